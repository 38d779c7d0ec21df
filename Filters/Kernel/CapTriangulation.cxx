// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CapTriangulation.h"

#include "FaceTriangulation.h"
#include "HilbertCurve.h"
#include "Lattice.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace sb
{

namespace
{

class ContourFiller : private ConstraintSource
{
public:
  using CrossingOf = std::function<ExactPoint(std::int32_t, std::int32_t)>;

  ContourFiller(const PlanarContours& contours, FillRule rule, const CrossingOf& crossing)
    : Input(contours)
    , Rule(rule)
    , CrossingPoint(crossing)
  {
  }

  Filling Run()
  {
    if (this->Input.Edges.empty())
    {
      return std::move(this->Result);
    }
    this->StartWithFrame();
    this->InsertPoints();
    this->ConstrainAll();
    this->FindEdges();
    this->FindWindings();
    this->NumberRegions();
    this->Emit();
    return std::move(this->Result);
  }

private:
  using VertexPair = std::pair<int, int>;

  ExactPoint Crossing(int constraint, int other) override
  {
    this->IsSplit = true;
    const int index = static_cast<int>(this->Input.Points.size() + this->Result.Crossings.size());
    this->Result.Crossings.push_back(this->CrossingPoint(constraint, other));
    this->PointOfVertex.push_back(index);
    return this->Result.Crossings.back();
  }

  void PassesThrough(int constraint, int vertex) override
  {
    this->IsSplit = true;
    if (!this->Result.PointsOnEdges.empty())
    {
      this->Result.PointsOnEdges[std::size_t(constraint)].push_back(
        this->PointOfVertex[std::size_t(vertex)]);
    }
  }

  /** A triangle around all that the lattice holds, about eight times as large. */
  void StartWithFrame()
  {
    const int u = (this->Input.Normal.Axis + 1) % 3;
    const int v = (this->Input.Normal.Axis + 2) % 3;
    const double directions[3][2] = { { -16.0, -8.0 }, { 16.0, -8.0 }, { 0.0, 24.0 } };
    for (int i = 0; i < 3; ++i)
    {
      // Sixteen times a lattice point: beyond what predicates on plain lattice points are made for,
      // so it is made as the point of a line.
      const double* direction = directions[this->Input.Normal.Sign > 0 ? i : 2 - i];
      const double origin[3] = { 0.0, 0.0, 0.0 };
      double within[3] = { 0.0, 0.0, 0.0 };
      within[u] = direction[0] * Lattice::Limit / 32.0;
      within[v] = direction[1] * Lattice::Limit / 32.0;
      ExactPlane plane;
      plane.Normal[v] = WideInteger<2>(1);
      plane.Offset = WideInteger<3>(WideInteger<1>::FromIntegral(16.0 * within[v]));
      this->Frame[std::size_t(i)] = ExactPoint::LinePlane(origin, within, plane);
    }
    this->Mesh.Reset({ &this->Frame[0], &this->Frame[1], &this->Frame[2] }, this->Input.Normal.Axis,
      this->Input.Normal.Sign);
    this->PointOfVertex.assign(3, -1);
  }

  void InsertPoints()
  {
    const int axes[2] = { (this->Input.Normal.Axis + 1) % 3, (this->Input.Normal.Axis + 2) % 3 };
    double low[2];
    double scale = 0.0;
    for (int i = 0; i < 2; ++i)
    {
      const auto range = std::minmax_element(this->Input.Points.begin(), this->Input.Points.end(),
        [&](const ExactPoint* l, const ExactPoint* r) {
          return l->Approximation()[axes[i]] < r->Approximation()[axes[i]];
        });
      low[i] = (*range.first)->Approximation()[axes[i]];
      scale = std::max(scale, (*range.second)->Approximation()[axes[i]] - low[i]);
    }
    scale = scale > 0.0 ? 65535.0 / scale : 0.0;
    std::vector<std::pair<std::uint64_t, std::int32_t>> order;
    for (const ExactPoint* point : this->Input.Points)
    {
      const auto cell = [&](int i) {
        return static_cast<std::uint32_t>(scale * (point->Approximation()[axes[i]] - low[i]));
      };
      order.emplace_back(HilbertIndex(cell(0), cell(1)), static_cast<std::int32_t>(order.size()));
    }
    std::sort(order.begin(), order.end());
    this->VertexOfPoint.resize(order.size());
    for (const auto& entry : order)
    {
      const int vertex = this->Mesh.Insert(this->Input.Points[std::size_t(entry.second)]);
      this->VertexOfPoint[std::size_t(entry.second)] = vertex;
      this->PointOfVertex.resize(std::size_t(this->Mesh.NumberOfVertices()), -1);
      this->PointOfVertex[std::size_t(vertex)] = entry.second;
    }
  }

  void ConstrainAll()
  {
    const auto constrain = [this] {
      for (std::size_t i = 0; i < this->Input.Edges.size(); ++i)
      {
        const PlanarContours::Edge& edge = this->Input.Edges[i];
        this->Mesh.Constrain(this->VertexOfPoint[std::size_t(edge.From)],
          this->VertexOfPoint[std::size_t(edge.To)], static_cast<int>(i), *this);
      }
    };
    constrain();
    if (this->IsSplit)
    {
      // All parts are edges now: a second time tells the points on each edge.
      this->Result.PointsOnEdges.resize(this->Input.Edges.size());
      constrain();
      for (std::size_t i = 0; i < this->Input.Edges.size(); ++i)
      {
        this->SortAlong(this->Input.Edges[i], this->Result.PointsOnEdges[i]);
      }
    }
  }

  /** Put points on an edge into the order in which it runs through them. */
  void SortAlong(const PlanarContours::Edge& edge, std::vector<std::int32_t>& points) const
  {
    const ExactPoint& from = this->PlaceOf(edge.From);
    const ExactPoint& to = this->PlaceOf(edge.To);
    int axis = (this->Input.Normal.Axis + 1) % 3;
    if (CompareAlong(from, to, axis) == 0)
    {
      axis = (this->Input.Normal.Axis + 2) % 3;
    }
    const int forward = CompareAlong(from, to, axis);
    std::sort(points.begin(), points.end(), [&](std::int32_t l, std::int32_t r) {
      return CompareAlong(this->PlaceOf(l), this->PlaceOf(r), axis) == forward;
    });
  }

  const ExactPoint& PlaceOf(std::int32_t point) const
  {
    const std::size_t index = std::size_t(point);
    const std::size_t numberOfPoints = this->Input.Points.size();
    return index < numberOfPoints ? *this->Input.Points[index]
                                  : this->Result.Crossings[index - numberOfPoints];
  }

  /** How often the contours run along each edge of the triangulation, from the lower vertex to the
   * higher one. */
  void FindEdges()
  {
    for (std::size_t i = 0; this->IsSplit && i < this->Input.Edges.size(); ++i)
    {
      const PlanarContours::Edge& edge = this->Input.Edges[i];
      std::int32_t from = edge.From;
      std::vector<std::int32_t> parts = this->Result.PointsOnEdges[i];
      parts.push_back(edge.To);
      for (const std::int32_t to : parts)
      {
        const int a = this->VertexOf(from);
        const int b = this->VertexOf(to);
        this->Runs[std::minmax(a, b)] +=
          a < b ? this->Input.Multiplicities[i] : -this->Input.Multiplicities[i];
        from = to;
      }
    }
  }

  int VertexOf(std::int32_t point)
  {
    const auto numberOfPoints = static_cast<std::int32_t>(this->Input.Points.size());
    if (point < numberOfPoints)
    {
      return this->VertexOfPoint[std::size_t(point)];
    }
    return 3 + point; // all input points are vertices before the first crossing is
  }

  /** How often the contours run from vertex a to b, which an edge of constraint `label` joins. */
  int RunsAlong(int a, int b, int label) const
  {
    if (label == FaceTriangulation::None)
    {
      return 0;
    }
    if (this->IsSplit)
    {
      const auto found = this->Runs.find(std::minmax(a, b));
      const int runs = found == this->Runs.end() ? 0 : found->second;
      return a < b ? runs : -runs;
    }
    const std::size_t edge = static_cast<std::size_t>(label);
    const bool forward = this->VertexOfPoint[std::size_t(this->Input.Edges[edge].From)] == a;
    return forward ? this->Input.Multiplicities[edge] : -this->Input.Multiplicities[edge];
  }

  void FindWindings()
  {
    const std::vector<FaceTriangulation::Cell>& cells = this->Mesh.Cells();
    this->Windings.assign(cells.size(), 0);
    std::vector<std::uint8_t> known(cells.size(), 0);
    std::vector<int> stack;
    for (std::size_t i = 0; i < cells.size() && stack.empty(); ++i)
    {
      if (cells[i].Vertices[0] < 3 || cells[i].Vertices[1] < 3 || cells[i].Vertices[2] < 3)
      {
        known[i] = 1; // a corner of the frame: outside of everything
        this->FrameCell = static_cast<int>(i);
        stack.push_back(static_cast<int>(i));
      }
    }
    while (!stack.empty())
    {
      const std::size_t here = static_cast<std::size_t>(stack.back());
      stack.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
      {
        const int across = cells[here].Neighbours[i];
        if (across == FaceTriangulation::None || known[std::size_t(across)])
        {
          continue;
        }
        known[std::size_t(across)] = 1;
        this->Windings[std::size_t(across)] = this->Windings[here] -
          this->RunsAlong(cells[here].Vertices[(i + 1) % 3], cells[here].Vertices[(i + 2) % 3],
            cells[here].Constraints[i]);
        stack.push_back(across);
      }
    }
    for (int& winding : this->Windings)
    {
      if (this->Rule == FillRule::EvenOdd)
      {
        winding = std::abs(winding) % 2;
      }
      else if (this->Rule == FillRule::NonZero)
      {
        winding = winding > 0 ? 1 : (winding < 0 ? -1 : 0);
      }
    }
  }

  /** Go inwards from the frame, layer by layer: cells of one winding number that hang together, and
   * then those beyond their outlines. */
  void NumberRegions()
  {
    this->Regions.assign(this->Mesh.Cells().size(), -1);
    std::vector<std::uint8_t> seen(this->Mesh.Cells().size(), 0);
    std::vector<int> layer(1, this->FrameCell);
    std::vector<int> next;
    for (std::int32_t depth = 0; !layer.empty(); ++depth)
    {
      for (const int cell : layer)
      {
        if (!seen[std::size_t(cell)])
        {
          this->NumberRegion(cell, depth, seen, next);
        }
      }
      layer.swap(next);
      next.clear();
    }
  }

  void NumberRegion(
    int first, std::int32_t depth, std::vector<std::uint8_t>& seen, std::vector<int>& beyond)
  {
    const std::vector<FaceTriangulation::Cell>& cells = this->Mesh.Cells();
    const int winding = this->Windings[std::size_t(first)];
    const std::int32_t region = winding == 0 ? -1 : this->Result.NumberOfRegions++;
    if (region >= 0)
    {
      this->Result.Depths.push_back((depth - 1) / 2);
    }
    std::vector<int> stack(1, first);
    seen[std::size_t(first)] = 1;
    while (!stack.empty())
    {
      const std::size_t here = static_cast<std::size_t>(stack.back());
      stack.pop_back();
      this->Regions[here] = region;
      for (const int across : cells[here].Neighbours)
      {
        if (across == FaceTriangulation::None || seen[std::size_t(across)])
        {
          continue;
        }
        if (this->Windings[std::size_t(across)] != winding)
        {
          beyond.push_back(across);
          continue;
        }
        seen[std::size_t(across)] = 1;
        stack.push_back(across);
      }
    }
  }

  void Emit()
  {
    const std::vector<FaceTriangulation::Cell>& cells = this->Mesh.Cells();
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (this->Windings[i] == 0)
      {
        continue;
      }
      Filling::Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t corner = this->Windings[i] > 0 ? k : 2 - k;
        triangle.Corners[corner] = this->PointOfVertex[std::size_t(cells[i].Vertices[k])];
      }
      triangle.Winding = this->Windings[i];
      triangle.Region = this->Regions[i];
      this->Result.Triangles.push_back(triangle);
    }
  }

  const PlanarContours& Input;
  const FillRule Rule;
  const CrossingOf& CrossingPoint;
  Filling Result;
  FaceTriangulation Mesh;
  std::array<ExactPoint, 3> Frame;
  std::vector<int> VertexOfPoint;
  std::vector<std::int32_t> PointOfVertex;
  bool IsSplit = false; ///< an edge became several
  std::map<VertexPair, int> Runs; ///< only where an edge became several
  int FrameCell = 0; ///< a cell outside of all contours
  std::vector<int> Windings; ///< by cell
  std::vector<std::int32_t> Regions; ///< by cell
};

} // namespace

Filling FillContours(const PlanarContours& contours, FillRule rule,
  const std::function<ExactPoint(std::int32_t, std::int32_t)>& crossing)
{
  return ContourFiller(contours, rule, crossing).Run();
}

} // namespace sb
