// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamTarget.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sb
{
namespace
{

constexpr double SamePlane = 1e-9; ///< one minus the cosine between two triangles' normals
constexpr double LeastCrossing = 0.05; ///< sine between the surfaces; below it they touch
constexpr int MostSteps = 12;
constexpr double Tiny = 1e-15; ///< a step by this share of the coordinates changes nothing

/** The direction of the edge that two triangles share; zero if they share none. */
Real3 SharedEdge(const ToolSurface& tool, std::int32_t s, std::int32_t t)
{
  const std::array<std::int32_t, 3> ofS = tool.Corners(s);
  const std::array<std::int32_t, 3> ofT = tool.Corners(t);
  std::array<std::int32_t, 3> shared{};
  std::size_t count = 0;
  for (const std::int32_t id : ofS)
  {
    if (std::find(ofT.begin(), ofT.end(), id) != ofT.end())
    {
      shared[count++] = id;
    }
  }
  if (count != 2)
  {
    return {};
  }
  const Real3 along = Difference(tool.Point(shared[1]), tool.Point(shared[0]));
  const double length = Length(along);
  return length > 0.0 ? Scaled(along, 1.0 / length) : Real3{};
}

bool AreOnOnePatch(const ToolSurface& tool, const std::vector<std::int32_t>& triangles)
{
  const DesignedSurface& body = tool.Body();
  const auto face = [&](std::int32_t t) { return body.FaceId[static_cast<std::size_t>(t)]; };
  return body.HasPatches() && !body.FaceId.empty() &&
    std::all_of(triangles.begin(), triangles.end(),
      [&](std::int32_t t) { return face(t) >= 0 && face(t) == face(triangles.front()); });
}

/** Along which a vertex in a plane or on a line is to be moved, given the gradient. */
Real3 Allowed(const SeamFreedom& freedom, const Real3& gradient)
{
  return freedom.What == SeamFreedom::Kind::Plane
    ? WithoutPartAlong(gradient, freedom.Direction)
    : Scaled(freedom.Direction, Dot(gradient, freedom.Direction));
}

} // namespace

SeamFreedom FreedomOn(const ToolSurface& tool, const std::vector<std::int32_t>& triangles)
{
  SeamFreedom freedom;
  if (triangles.empty())
  {
    return freedom;
  }
  freedom.Triangle = triangles.front();
  if (AreOnOnePatch(tool, triangles))
  {
    freedom.What = SeamFreedom::Kind::Patch;
    return freedom;
  }
  std::vector<std::int32_t> planes; // a triangle of each
  for (const std::int32_t t : triangles)
  {
    const Real3 normal = tool.Normal(t);
    const bool known = Dot(normal, normal) == 0.0 ||
      std::any_of(planes.begin(), planes.end(),
        [&](std::int32_t other) { return Dot(tool.Normal(other), normal) > 1.0 - SamePlane; });
    if (!known)
    {
      planes.push_back(t);
    }
  }
  if (planes.size() == 1)
  {
    freedom = { SeamFreedom::Kind::Plane, tool.Normal(planes[0]), planes[0] };
  }
  else if (planes.size() == 2)
  {
    const Real3 along = SharedEdge(tool, planes[0], planes[1]);
    if (Dot(along, along) > 0.0)
    {
      freedom = { SeamFreedom::Kind::Line, along, planes[0] };
    }
  }
  return freedom;
}

SeamTarget FindSeamTarget(const MovingLeastSquares& cloud, const ToolSurface& tool,
  const SeamFreedom& freedom, const Real3& start, double limit,
  MovingLeastSquares::Neighbourhood& near)
{
  SeamTarget target;
  target.Place = start;
  cloud.Gather(start, limit, near);
  const double size = std::max({ std::abs(start[0]), std::abs(start[1]), std::abs(start[2]) });
  const Real3 normal = tool.Normal(freedom.Triangle);
  for (int step = 0; step < MostSteps; ++step)
  {
    const SurfaceValue f = cloud.EvaluateNear(target.Place, 1, near);
    const double steepness = Length(f.Gradient);
    if (!f.IsNear || !(steepness > 0.0))
    {
      return target;
    }
    target.Residual = std::abs(f.Value) / steepness;
    target.Tangency = std::abs(Dot(f.Gradient, normal)) / steepness;
    const Real3 along =
      freedom.What == SeamFreedom::Kind::Fixed ? Real3{} : Allowed(freedom, f.Gradient);
    const double squared = Dot(along, along);
    target.Reached = target.Residual <= Tiny * (size + limit);
    if (target.Reached || !(squared > LeastCrossing * LeastCrossing * steepness * steepness))
    {
      return target;
    }
    const Real3 next = PlusScaled(target.Place, -f.Value / squared, along);
    if (!(Length(Difference(next, start)) <= limit))
    {
      return target;
    }
    const bool moved = Length(Difference(next, target.Place)) > Tiny * (size + limit);
    target.Place = next;
    if (!moved)
    {
      target.Reached = true;
      return target;
    }
  }
  target.Reached = target.Residual < 1e-9 * limit;
  return target;
}

} // namespace sb
