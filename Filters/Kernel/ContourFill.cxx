// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourFill.h"

#include "CapTriangulation.h"
#include "Lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sb
{

namespace
{

using Vector = std::array<double, 3>;

Vector Cross(const Vector& p, const Vector& q)
{
  return { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0] };
}

double Dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

class LineFiller
{
public:
  explicit LineFiller(const ContourFillRequest& request)
    : Request(request)
  {
  }

  ContourFillResult Run()
  {
    if (!this->Check() || !this->FindPlane())
    {
      return std::move(this->Result);
    }
    this->PlacePoints();
    this->ListEdges();
    this->RemoveOpenEdges();
    this->Fill();
    return std::move(this->Result);
  }

private:
  Vector Offset(std::int32_t point) const
  {
    const double* p = this->Request.Points + 3 * std::int64_t(point);
    const double* q = this->Request.Points + 3 * std::int64_t(this->Request.Segments.front()[0]);
    return { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
  }

  bool Check()
  {
    if (this->Request.NumberOfPoints > std::numeric_limits<std::int32_t>::max() / 4)
    {
      this->Refuse(Status::TooLarge, -1);
      return false;
    }
    for (const std::array<std::int32_t, 2>& segment : this->Request.Segments)
    {
      for (const std::int32_t point : segment)
      {
        const double* p = this->Request.Points + 3 * std::int64_t(point);
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        {
          this->Refuse(Status::BadCoordinate, point);
          return false;
        }
      }
    }
    return !this->Request.Segments.empty();
  }

  void Refuse(Status condition, std::int64_t point)
  {
    this->Result.Condition = condition;
    this->Result.Remarks.emplace_back();
    this->Result.Remarks.back().Condition = condition;
    this->Result.Remarks.back().Point = point;
  }

  /** The plane through the first point, the one farthest from it, and the one farthest from their
   * line; its normal looks where the contours' area does. @return whether the points span one. */
  bool FindPlane()
  {
    Vector far{};
    Vector area{};
    for (const std::array<std::int32_t, 2>& segment : this->Request.Segments)
    {
      const Vector from = this->Offset(segment[0]);
      const Vector to = this->Offset(segment[1]);
      far = Dot(to, to) > Dot(far, far) ? to : far;
      const Vector part = Cross(from, to);
      for (std::size_t i = 0; i < 3; ++i)
      {
        area[i] += part[i];
      }
    }
    Vector normal{};
    for (const std::array<std::int32_t, 2>& segment : this->Request.Segments)
    {
      const Vector candidate = Cross(far, this->Offset(segment[1]));
      normal = Dot(candidate, candidate) > Dot(normal, normal) ? candidate : normal;
    }
    const double length = std::sqrt(Dot(normal, normal));
    this->Result.Size = std::sqrt(Dot(far, far));
    if (!(length > 0.0))
    {
      this->Result.OpenSegments = static_cast<std::int64_t>(this->Request.Segments.size());
      return false;
    }
    int axis = 0;
    for (int i = 1; i < 3; ++i)
    {
      axis = std::fabs(normal[std::size_t(i)]) > std::fabs(normal[std::size_t(axis)]) ? i : axis;
    }
    const double along = Dot(area, normal);
    const bool upwards =
      std::fabs(along) > 1e-9 * length * length ? along > 0.0 : normal[std::size_t(axis)] > 0.0;
    this->Input.Normal = { axis, (normal[std::size_t(axis)] > 0.0) == upwards ? 1 : -1 };
    for (const std::array<std::int32_t, 2>& segment : this->Request.Segments)
    {
      this->Result.Deviation =
        std::max(this->Result.Deviation, std::fabs(Dot(normal, this->Offset(segment[1]))) / length);
    }
    return true;
  }

  void PlacePoints()
  {
    std::vector<std::int32_t> used;
    double largest = 0.0;
    for (const std::array<std::int32_t, 2>& segment : this->Request.Segments)
    {
      for (const std::int32_t point : segment)
      {
        used.push_back(point);
        for (int i = 0; i < 3; ++i)
        {
          largest = std::max(largest, std::fabs(this->Request.Points[3 * std::int64_t(point) + i]));
        }
      }
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    this->Grid = Lattice::ForMagnitude(largest);
    const int axis = this->Input.Normal.Axis;
    std::vector<std::array<double, 3>> places; // along the axis, all lie in one plane
    for (const std::int32_t point : used)
    {
      double q[3];
      this->Grid.Quantise(this->Request.Points + 3 * std::int64_t(point), q);
      places.push_back({ q[(axis + 1) % 3], q[(axis + 2) % 3], q[axis] });
    }
    std::vector<std::size_t> order(used.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto same = [&](std::size_t l, std::size_t r) {
      return places[l][0] == places[r][0] && places[l][1] == places[r][1];
    };
    std::sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) {
      return !same(l, r)
        ? std::make_pair(places[l][0], places[l][1]) < std::make_pair(places[r][0], places[r][1])
        : l < r;
    });
    this->NodeOfPoint.assign(std::size_t(this->Request.NumberOfPoints), -1);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      if (i == 0 || !same(order[i - 1], order[i]))
      {
        double q[3];
        this->Grid.Quantise(this->Request.Points + 3 * std::int64_t(used[order[i]]), q);
        this->Exact.push_back(ExactPoint::Vertex(q));
        this->PointOfNode.push_back(used[order[i]]);
      }
      this->NodeOfPoint[std::size_t(used[order[i]])] =
        static_cast<std::int32_t>(this->Exact.size()) - 1;
    }
    for (const ExactPoint& point : this->Exact)
    {
      this->Input.Points.push_back(&point);
    }
  }

  /** Segments that are there twice bound nothing. */
  void ListEdges()
  {
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    for (const std::array<std::int32_t, 2>& segment : this->Request.Segments)
    {
      const std::int32_t from = this->NodeOfPoint[std::size_t(segment[0])];
      const std::int32_t to = this->NodeOfPoint[std::size_t(segment[1])];
      if (from != to)
      {
        edges.emplace_back(std::min(from, to), std::max(from, to));
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
    {
      for (end = begin; end < edges.size() && edges[end] == edges[begin]; ++end)
      {
      }
      if ((end - begin) % 2 == 1)
      {
        this->Input.Edges.push_back({ edges[begin].first, edges[begin].second });
      }
    }
  }

  /** Take loose ends off, one edge after the other, until only closed contours are left. */
  void RemoveOpenEdges()
  {
    std::vector<PlanarContours::Edge>& edges = this->Input.Edges;
    std::vector<std::vector<std::size_t>> edgesOfNode(this->Exact.size());
    std::vector<std::size_t> degrees(this->Exact.size(), 0);
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      for (const std::int32_t node : { edges[i].From, edges[i].To })
      {
        edgesOfNode[std::size_t(node)].push_back(i);
        ++degrees[std::size_t(node)];
      }
    }
    std::vector<std::uint8_t> removed(edges.size(), 0);
    std::vector<std::size_t> loose;
    for (std::size_t node = 0; node < degrees.size(); ++node)
    {
      if (degrees[node] == 1)
      {
        loose.push_back(node);
      }
    }
    while (!loose.empty())
    {
      const std::size_t node = loose.back();
      loose.pop_back();
      for (const std::size_t edge : edgesOfNode[node])
      {
        if (removed[edge])
        {
          continue;
        }
        removed[edge] = 1;
        ++this->Result.OpenSegments;
        const std::size_t other =
          std::size_t(edges[edge].From) + std::size_t(edges[edge].To) - node;
        if (--degrees[other] == 1)
        {
          loose.push_back(other);
        }
      }
    }
    std::vector<PlanarContours::Edge> kept;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (!removed[i])
      {
        kept.push_back(edges[i]);
      }
    }
    edges.swap(kept);
    this->Input.Multiplicities.assign(edges.size(), 1);
  }

  const double* PlaceOf(std::int32_t node) const
  {
    return this->Exact[std::size_t(node)].Approximation();
  }

  void Fill()
  {
    std::vector<std::array<std::int32_t, 2>> crossed;
    const Filling filling =
      FillContours(this->Input, FillRule::EvenOdd, [&](std::int32_t a, std::int32_t b) {
        const PlanarContours::Edge& first = this->Input.Edges[std::size_t(a)];
        const PlanarContours::Edge& second = this->Input.Edges[std::size_t(b)];
        crossed.push_back({ first.From, first.To });
        return ExactPoint::LineLine(this->PlaceOf(first.From), this->PlaceOf(first.To),
          this->PlaceOf(second.From), this->PlaceOf(second.To), this->Input.Normal.Axis);
      });
    for (std::size_t i = 0; i < filling.Crossings.size(); ++i)
    {
      this->AddCrossing(filling.Crossings[i], crossed[i]);
    }
    for (const Filling::Triangle& triangle : filling.Triangles)
    {
      this->Result.Triangles.push_back({ this->IdOf(triangle.Corners[0]),
        this->IdOf(triangle.Corners[1]), this->IdOf(triangle.Corners[2]) });
      this->Result.PolygonOfTriangle.push_back(triangle.Region);
    }
    this->Result.Nesting = filling.Depths;
  }

  std::int32_t IdOf(std::int32_t node) const
  {
    const auto numberOfNodes = static_cast<std::int32_t>(this->PointOfNode.size());
    return node < numberOfNodes
      ? this->PointOfNode[std::size_t(node)]
      : static_cast<std::int32_t>(this->Request.NumberOfPoints) + node - numberOfNodes;
  }

  void AddCrossing(const ExactPoint& point, const std::array<std::int32_t, 2>& ends)
  {
    const double* p = point.Approximation();
    const double* from = this->PlaceOf(ends[0]);
    const double* to = this->PlaceOf(ends[1]);
    const double whole = std::hypot(std::hypot(to[0] - from[0], to[1] - from[1]), to[2] - from[2]);
    const double part = std::hypot(std::hypot(p[0] - from[0], p[1] - from[1]), p[2] - from[2]);
    const double weight = std::min(1.0, part / whole);
    this->Result.Crossings.push_back(
      { { this->Grid.ToWorld(p[0]), this->Grid.ToWorld(p[1]), this->Grid.ToWorld(p[2]) }, 0,
        { this->IdOf(ends[0]), this->IdOf(ends[1]), this->IdOf(ends[0]) },
        { 1.0 - weight, weight, 0.0 } });
  }

  const ContourFillRequest& Request;
  ContourFillResult Result;
  Lattice Grid;
  PlanarContours Input;
  std::vector<ExactPoint> Exact; ///< by node
  std::vector<std::int32_t> PointOfNode;
  std::vector<std::int32_t> NodeOfPoint;
};

} // namespace

ContourFillResult FillLines(const ContourFillRequest& request) { return LineFiller(request).Run(); }

} // namespace sb
