// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellOutline.h
 * @brief Cuts a flat polygon, convex or not, in one part or several, into triangles over its own
 * points.
 */
#ifndef sb_CellOutline_h
#define sb_CellOutline_h

#include "CapTriangulation.h"
#include "PolygonCutting.h"

#include <array>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace sb
{

class CellOutline
{
public:
  explicit CellOutline(const DominantNormal& normal) { this->Input.Normal = normal; }

  void AddPoint(std::int32_t id, const ExactPoint& point)
  {
    if (this->Indices.emplace(id, static_cast<std::int32_t>(this->Ids.size())).second)
    {
      this->Ids.push_back(id);
      this->Points.push_back(point);
    }
  }

  /** A side between two points that were added, the polygon to its left. */
  void AddSide(std::int32_t from, std::int32_t to)
  {
    if (from != to)
    {
      this->Input.Edges.push_back({ this->Indices[from], this->Indices[to] });
    }
  }

  /** Append the triangles. @param placeOf gives coordinates by id. */
  template <class PlaceOf>
  void Cut(PlaceOf&& placeOf, std::vector<std::array<std::int32_t, 3>>& triangles)
  {
    ConvexOutline convex;
    if (this->IsConvex(convex))
    {
      convex.Cut(placeOf, triangles);
      return;
    }
    for (const ExactPoint& point : this->Points)
    {
      this->Input.Points.push_back(&point);
    }
    this->Input.Multiplicities.assign(this->Input.Edges.size(), 1);
    // Sides of a polygon that does not run through itself do not cross.
    const Filling filling =
      FillContours(this->Input, FillRule::NonZero, [this](std::int32_t edge, std::int32_t) {
        return this->Points[std::size_t(this->Input.Edges[std::size_t(edge)].From)];
      });
    const auto count = static_cast<std::int32_t>(this->Ids.size());
    for (const Filling::Triangle& triangle : filling.Triangles)
    {
      const std::array<std::int32_t, 3>& t = triangle.Corners;
      if (t[0] < count && t[1] < count && t[2] < count)
      {
        triangles.push_back({ this->Ids[std::size_t(t[0])], this->Ids[std::size_t(t[1])],
          this->Ids[std::size_t(t[2])] });
      }
    }
  }

private:
  /** Whether the sides are one loop that turns left at every point; then that is in `outline`. */
  bool IsConvex(ConvexOutline& outline) const
  {
    const std::vector<PlanarContours::Edge>& sides = this->Input.Edges;
    if (sides.size() != this->Points.size() || sides.size() < 3)
    {
      return false;
    }
    std::vector<std::int32_t> next(sides.size(), -1);
    for (const PlanarContours::Edge& side : sides)
    {
      next[std::size_t(side.From)] = side.To;
    }
    std::int32_t here = 0;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      const std::int32_t second = next[std::size_t(here)];
      const std::int32_t third = second < 0 ? -1 : next[std::size_t(second)];
      if (third < 0 || (second == 0) != (i + 1 == sides.size()) ||
        this->Input.Normal.Sign *
            Orient2D(this->Points[std::size_t(here)], this->Points[std::size_t(second)],
              this->Points[std::size_t(third)], this->Input.Normal.Axis) <=
          0)
      {
        return false;
      }
      outline.Add(this->Ids[std::size_t(here)], false);
      here = second;
    }
    return true;
  }

  PlanarContours Input;
  std::deque<ExactPoint> Points;
  std::vector<std::int32_t> Ids; ///< by point
  std::unordered_map<std::int32_t, std::int32_t> Indices; ///< by id
};

} // namespace sb

#endif
