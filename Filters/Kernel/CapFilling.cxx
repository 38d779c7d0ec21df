// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CapFilling.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace sb
{

namespace
{

class CapFiller
{
public:
  CapFiller(ClipPoints& points, std::int32_t plane, const Contour& contour, FillRule rule,
    SplitSegments& splits)
    : Points(points)
    , Plane(plane)
    , Segments(contour)
    , Rule(rule)
    , Splits(splits)
  {
  }

  CapFilling Run()
  {
    this->ListPoints();
    this->ListEdges();
    const Filling filling = FillContours(this->Input, this->Rule,
      [this](std::int32_t a, std::int32_t b) { return this->Crossing(a, b); });
    for (const ExactPoint& crossing : filling.Crossings)
    {
      this->Instances.push_back(this->Points.Add(crossing));
    }
    this->NoteSplits(filling);
    CapFilling cap;
    cap.Depths = filling.Depths;
    for (const Filling::Triangle& triangle : filling.Triangles)
    {
      for (std::int32_t copy = 0; copy < std::abs(triangle.Winding); ++copy)
      {
        cap.Triangles.push_back({ this->Instances[std::size_t(triangle.Corners[0])],
          this->Instances[std::size_t(triangle.Corners[1])],
          this->Instances[std::size_t(triangle.Corners[2])] });
        cap.Regions.push_back(triangle.Region);
      }
    }
    return cap;
  }

private:
  void ListPoints()
  {
    std::vector<std::pair<std::int32_t, std::int32_t>> ends; // node, instance
    for (const Segment& segment : this->Segments)
    {
      ends.emplace_back(this->Points.Node(segment.From), segment.From);
      ends.emplace_back(this->Points.Node(segment.To), segment.To);
    }
    std::sort(ends.begin(), ends.end());
    for (const auto& end : ends)
    {
      if (this->Nodes.empty() || this->Nodes.back() != end.first)
      {
        this->Nodes.push_back(end.first);
        this->Instances.push_back(end.second);
        this->Input.Points.push_back(&this->Points.Point(end.first));
      }
    }
    this->Input.Normal = this->Points.Plane(this->Plane).Dominant();
  }

  std::int32_t IndexOf(std::int32_t instance) const
  {
    return static_cast<std::int32_t>(
      std::lower_bound(this->Nodes.begin(), this->Nodes.end(), this->Points.Node(instance)) -
      this->Nodes.begin());
  }

  /** Equal segments follow each other, as CancelSegments leaves them: they are one edge. */
  void ListEdges()
  {
    for (std::size_t i = 0; i < this->Segments.size(); ++i)
    {
      const PlanarContours::Edge edge{ this->IndexOf(this->Segments[i].From),
        this->IndexOf(this->Segments[i].To) };
      if (!this->Input.Edges.empty() && this->Input.Edges.back().From == edge.From &&
        this->Input.Edges.back().To == edge.To)
      {
        ++this->Input.Multiplicities.back();
        continue;
      }
      this->Input.Edges.push_back(edge);
      this->Input.Multiplicities.push_back(1);
      this->SegmentOfEdge.push_back(i);
    }
  }

  /** The plane in which a segment lies beside its own. */
  ExactPlane CarrierOf(const Segment& segment) const
  {
    const int axis = this->Input.Normal.Axis;
    const Carrier& line = segment.Line;
    switch (line.Of)
    {
      case Carrier::Kind::Face:
        return this->Points.PlaneOfFace(line.A);
      case Carrier::Kind::Edge:
        return ExactPlane::Vertical(
          this->Points.Position(line.A).data(), this->Points.Position(line.B).data(), axis);
      case Carrier::Kind::Plane:
        return this->Points.Plane(line.A).Plane();
      case Carrier::Kind::Join:
        break;
    }
    double ends[2][3];
    for (int i = 0; i < 3; ++i)
    {
      ends[0][i] =
        std::nearbyint(this->Points.Point(this->Points.Node(segment.From)).Approximation()[i]);
      ends[1][i] =
        std::nearbyint(this->Points.Point(this->Points.Node(segment.To)).Approximation()[i]);
    }
    return ExactPlane::Vertical(ends[0], ends[1], axis);
  }

  ExactPoint Crossing(std::int32_t a, std::int32_t b) const
  {
    const Segment& first = this->Segments[this->SegmentOfEdge[std::size_t(a)]];
    const Segment& second = this->Segments[this->SegmentOfEdge[std::size_t(b)]];
    return ExactPoint::ThreePlanes(
      this->CarrierOf(first), this->CarrierOf(second), this->Points.Plane(this->Plane).Plane());
  }

  void NoteSplits(const Filling& filling)
  {
    if (filling.PointsOnEdges.empty())
    {
      return;
    }
    for (std::size_t i = 0; i < filling.PointsOnEdges.size(); ++i)
    {
      std::vector<std::int32_t> between;
      for (const std::int32_t point : filling.PointsOnEdges[i])
      {
        between.push_back(this->Points.Node(this->Instances[std::size_t(point)]));
      }
      const std::int32_t from = this->Nodes[std::size_t(this->Input.Edges[i].From)];
      const std::int32_t to = this->Nodes[std::size_t(this->Input.Edges[i].To)];
      if (from > to)
      {
        std::reverse(between.begin(), between.end());
      }
      if (!between.empty())
      {
        this->Splits[std::minmax(from, to)] = between;
      }
    }
  }

  ClipPoints& Points;
  const std::int32_t Plane;
  const Contour& Segments;
  const FillRule Rule;
  SplitSegments& Splits;
  PlanarContours Input;
  std::vector<std::int32_t> Nodes; ///< by point, ascending
  std::vector<std::int32_t> Instances; ///< by point, and then by crossing
  std::vector<std::size_t> SegmentOfEdge;
};

} // namespace

CapFilling FillCapContour(ClipPoints& points, std::int32_t plane, const Contour& contour,
  FillRule rule, SplitSegments& splits)
{
  return CapFiller(points, plane, contour, rule, splits).Run();
}

} // namespace sb
