// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamTarget.h"

#include "ClosestOnPatch.h"
#include "CommonPoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sb
{
namespace
{

constexpr double SamePlane = 1e-9; ///< one minus the cosine between two triangles' normals
constexpr double LeastCrossing = 0.05; ///< sine between a line and the surface; below it they touch
constexpr int MostSteps = 12;
constexpr int MostTriangles = 8; ///< that a vertex may go over
constexpr double NearlyThere = 1e-9; ///< of the limit of a move

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

/** A triangle of each of the patches that triangles are on: two, or nothing. */
std::vector<std::int32_t> OnTwoPatches(
  const ToolSurface& tool, const std::vector<std::int32_t>& triangles)
{
  const DesignedSurface& body = tool.Body();
  std::vector<std::int32_t> found;
  for (const std::int32_t t : triangles)
  {
    const auto face = [&](std::int32_t s) { return body.FaceId[static_cast<std::size_t>(s)]; };
    if (!body.HasPatches() || body.FaceId.empty() || face(t) < 0)
    {
      return {};
    }
    if (std::none_of(
          found.begin(), found.end(), [&](std::int32_t other) { return face(other) == face(t); }))
    {
      found.push_back(t);
    }
  }
  return found.size() == 2 ? found : std::vector<std::int32_t>{};
}

bool AreOnOnePatch(const ToolSurface& tool, const std::vector<std::int32_t>& triangles)
{
  const DesignedSurface& body = tool.Body();
  const auto face = [&](std::int32_t t) { return body.FaceId[static_cast<std::size_t>(t)]; };
  return body.HasPatches() && !body.FaceId.empty() &&
    std::all_of(triangles.begin(), triangles.end(),
      [&](std::int32_t t) { return face(t) >= 0 && face(t) == face(triangles.front()); });
}

/** The root of the function along a line. */
CommonPoint OntoCloudAndLine(const MovingLeastSquares& cloud, const Real3& start,
  const Real3& along, double limit, MovingLeastSquares::Neighbourhood& near)
{
  CommonPoint now;
  now.Point = start;
  cloud.Gather(start, limit, near);
  double best = std::numeric_limits<double>::infinity();
  CommonPoint reached;
  for (int step = 0; step < MostSteps; ++step)
  {
    now.Surface = cloud.EvaluateNear(now.Point, 1, near);
    const double slope = Dot(now.Surface.Gradient, along);
    const double residual = std::abs(now.Surface.Value);
    if (!now.Surface.IsNear || !(residual < best) ||
      !(std::abs(slope) > LeastCrossing * Length(now.Surface.Gradient)))
    {
      break;
    }
    best = residual;
    reached = now;
    reached.Found = residual < NearlyThere * limit;
    now.Point = PlusScaled(now.Point, -now.Surface.Value / slope, along);
  }
  return reached.Found ? reached : now;
}

/** The step to where three planes n . x = d meet, if they do not nearly lie along one line. */
bool StepToThree(const Real3 (&n)[3], const Real3& d, Real3& step)
{
  const Real3 crosses[3] = { Cross(n[1], n[2]), Cross(n[2], n[0]), Cross(n[0], n[1]) };
  const double determinant = Dot(n[0], crosses[0]);
  step = PlusScaled(PlusScaled(Scaled(crosses[0], d[0]), d[1], crosses[1]), d[2], crosses[2]);
  step = Scaled(step, determinant != 0.0 ? 1.0 / determinant : 0.0);
  return std::abs(determinant) > LeastCrossing;
}

/** The point of the surface on the edge of two patches, by Newton's method for all three. */
CommonPoint OntoCloudAndCrease(const MovingLeastSquares& cloud, const ToolSurface& tool,
  const SeamFreedom& crease, const Real3& start, double limit,
  MovingLeastSquares::Neighbourhood& near)
{
  const std::int32_t triangles[2] = { crease.Triangle, crease.OnOtherPatch };
  PlaceOnPatch on[2];
  for (std::size_t k = 0; k < 2; ++k)
  {
    const std::array<double, 2> uv = tool.ParametersOf(triangles[k], start);
    on[k].U = uv[0];
    on[k].V = uv[1];
  }
  CommonPoint now;
  now.Point = start;
  cloud.Gather(start, limit, near);
  for (int step = 0; step < MostSteps; ++step)
  {
    Real3 normals[3];
    Real3 offsets{};
    for (std::size_t k = 0; k < 2; ++k)
    {
      const NURBSSurface& patch = tool.PatchOf(triangles[k]);
      on[k] = ClosestOnPatchFrom(patch, now.Point, on[k].U, on[k].V);
      const PatchPoint at = EvaluatePatch(patch, on[k].U, on[k].V, 1);
      const Real3 across = Cross(at.Du, at.Dv);
      const double length = Length(across);
      normals[k] = length > 0.0 ? Scaled(across, 1.0 / length) : Real3{};
      offsets[k] = Dot(normals[k], Difference(at.Point, now.Point));
    }
    now.Surface = cloud.EvaluateNear(now.Point, 1, near);
    const double steepness = Length(now.Surface.Gradient);
    if (!now.Surface.IsNear || !(steepness > 0.0))
    {
      return now;
    }
    normals[2] = Scaled(now.Surface.Gradient, 1.0 / steepness);
    offsets[2] = -now.Surface.Value / steepness;
    const double off =
      std::max({ std::abs(offsets[0]), std::abs(offsets[1]), std::abs(offsets[2]) });
    now.Found = off < NearlyThere * limit;
    Real3 way{};
    if (off == 0.0 || !StepToThree(normals, offsets, way) || !(Length(way) <= limit))
    {
      return now;
    }
    now.Point = PlusScaled(now.Point, 1.0, way);
  }
  return now;
}

/** The least and the largest of some numbers. */
struct Extent
{
  double Least = std::numeric_limits<double>::infinity();
  double Largest = -std::numeric_limits<double>::infinity();

  void Add(double value)
  {
    this->Least = std::min(this->Least, value);
    this->Largest = std::max(this->Largest, value);
  }
};

/** The line in which the patch of these triangles meets itself, if it is one: from pole to pole one
 * parameter is at the two ends of its domain. At a pole, where it is everywhere, and where two such
 * lines cross, a vertex has to stay. */
SeamFreedom BorderBetween(
  const ToolSurface& tool, const std::vector<std::int32_t>& triangles, const Real3& place)
{
  const NURBSSurface& patch = tool.PatchOf(triangles.front());
  const std::array<double, 2> first{ patch.FirstU(), patch.FirstV() };
  const std::array<double, 2> last{ patch.LastU(), patch.LastV() };
  // From the nearest end, as a share of the domain: the facets at a pole have another u there.
  constexpr double near = 0.25;
  std::array<Extent, 2> extents;
  std::array<double, 2> farthest{ 0.0, 0.0 };
  for (const std::int32_t t : triangles)
  {
    const std::array<double, 2> uv = tool.ParametersOf(t, place);
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double share = (uv[k] - first[k]) / (last[k] - first[k]);
      extents[k].Add(share);
      farthest[k] = std::max(farthest[k], std::min(std::abs(share), std::abs(1.0 - share)));
    }
  }
  SeamFreedom freedom;
  freedom.Triangle = triangles.front();
  const auto isAtEnds = [&](std::size_t k) {
    const double other = extents[1 - k].Largest - extents[1 - k].Least;
    return farthest[k] < near && other < near;
  };
  if (isAtEnds(0) != isAtEnds(1))
  {
    freedom.What = SeamFreedom::Kind::Border;
    freedom.KeepsU = isAtEnds(0);
  }
  return freedom;
}

/** The root of the function on a border line of a patch. */
CommonPoint OntoCloudAndBorder(const MovingLeastSquares& cloud, const ToolSurface& tool,
  const SeamFreedom& border, const Real3& start, double limit,
  MovingLeastSquares::Neighbourhood& near)
{
  const NURBSSurface& patch = tool.PatchOf(border.Triangle);
  std::array<double, 2> uv = tool.ParametersOf(border.Triangle, start);
  const std::array<double, 2> first{ patch.FirstU(), patch.FirstV() };
  const std::array<double, 2> last{ patch.LastU(), patch.LastV() };
  const std::size_t kept = border.KeepsU ? 0 : 1;
  const std::size_t moved = 1 - kept;
  uv[kept] = uv[kept] < 0.5 * (first[kept] + last[kept]) ? first[kept] : last[kept];
  CommonPoint now;
  CommonPoint reached;
  cloud.Gather(start, limit, near);
  double best = std::numeric_limits<double>::infinity();
  for (int step = 0; step < MostSteps; ++step)
  {
    uv[moved] = std::clamp(uv[moved], first[moved], last[moved]);
    const PatchPoint at = EvaluatePatch(patch, uv[0], uv[1], 1);
    const Real3& along = border.KeepsU ? at.Dv : at.Du;
    now.Point = at.Point;
    now.Surface = cloud.EvaluateNear(now.Point, 1, near);
    const double slope = Dot(now.Surface.Gradient, along);
    const double residual = std::abs(now.Surface.Value);
    if (!now.Surface.IsNear || !(residual < best) ||
      !(std::abs(slope) > LeastCrossing * Length(now.Surface.Gradient) * Length(along)))
    {
      break;
    }
    best = residual;
    reached = now;
    reached.Found = residual < NearlyThere * limit;
    uv[moved] -= now.Surface.Value / slope;
  }
  return reached.Found ? reached : now;
}

bool HasPatch(const ToolSurface& tool, std::int32_t triangle)
{
  const DesignedSurface& body = tool.Body();
  return body.HasPatches() && body.FaceId[static_cast<std::size_t>(triangle)] >= 0;
}

/** From a place on a facet, in its plane or on its patch. */
CommonPoint OntoCloudAndFacet(const MovingLeastSquares& cloud, const ToolSurface& tool,
  const ToolSurface::Nearest& on, MovingLeastSquares::Neighbourhood& near)
{
  if (!HasPatch(tool, on.Triangle))
  {
    return OntoCloudAndPlane(cloud, on.Place, tool.Normal(on.Triangle), on.Place, near);
  }
  const std::array<double, 2> uv = tool.ParametersOf(on.Triangle, on.Place);
  return OntoCloudAndPatch(cloud, tool.PatchOf(on.Triangle), uv[0], uv[1], near);
}

/** Whether a place in a facet's plane is on the tool, or one on a patch within its face. */
bool IsOnFace(const ToolSurface& tool, const Real3& place, std::int32_t triangle, double limit)
{
  const ToolSurface::Nearest nearest = tool.NearestTo(place, limit);
  if (!HasPatch(tool, triangle))
  {
    return nearest.Distance < NearlyThere * limit;
  }
  const std::vector<std::int32_t>& faces = tool.Body().FaceId;
  return nearest.Triangle >= 0 &&
    faces[static_cast<std::size_t>(nearest.Triangle)] == faces[static_cast<std::size_t>(triangle)];
}

SeamTarget TargetOf(
  const CommonPoint& found, const Real3& normalOfTool, const Real3& start, double limit)
{
  SeamTarget target;
  target.Reached = found.Found && Length(Difference(found.Point, start)) <= limit;
  target.Place = target.Reached ? found.Point : start;
  const double steepness = Length(found.Surface.Gradient);
  if (steepness > 0.0)
  {
    target.Residual = std::abs(found.Surface.Value) / steepness;
    target.Tangency = std::abs(Dot(found.Surface.Gradient, normalOfTool)) / steepness;
  }
  return target;
}

} // namespace

SeamFreedom FreedomOn(
  const ToolSurface& tool, const std::vector<std::int32_t>& triangles, const Real3& place)
{
  SeamFreedom freedom;
  if (triangles.empty())
  {
    return freedom;
  }
  freedom.Triangle = triangles.front();
  const bool meetsItself = tool.MeetsItselfAmong(triangles, place);
  if (AreOnOnePatch(tool, triangles))
  {
    freedom.What = SeamFreedom::Kind::Patch;
    return meetsItself ? BorderBetween(tool, triangles, place) : freedom;
  }
  if (meetsItself)
  {
    return freedom;
  }
  const std::vector<std::int32_t> patches = OnTwoPatches(tool, triangles);
  if (!patches.empty() &&
    Length(Cross(tool.Normal(patches[0]), tool.Normal(patches[1]))) > LeastCrossing)
  {
    freedom.What = SeamFreedom::Kind::Crease;
    freedom.Triangle = patches[0];
    freedom.OnOtherPatch = patches[1];
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
  CommonPoint found;
  found.Point = start;
  switch (freedom.What)
  {
    case SeamFreedom::Kind::Plane:
      found = OntoCloudAndPlane(cloud, start, freedom.Direction, start, near);
      break;
    case SeamFreedom::Kind::Patch: {
      const std::array<double, 2> uv = tool.ParametersOf(freedom.Triangle, start);
      found = OntoCloudAndPatch(cloud, tool.PatchOf(freedom.Triangle), uv[0], uv[1], near);
      break;
    }
    case SeamFreedom::Kind::Border:
      found = OntoCloudAndBorder(cloud, tool, freedom, start, limit, near);
      break;
    case SeamFreedom::Kind::Crease:
      found = OntoCloudAndCrease(cloud, tool, freedom, start, limit, near);
      break;
    case SeamFreedom::Kind::Line:
      found = OntoCloudAndLine(cloud, start, freedom.Direction, limit, near);
      break;
    case SeamFreedom::Kind::Fixed:
      found.Surface = cloud.EvaluateAt(start, 1, near);
  }
  return TargetOf(found, tool.Normal(freedom.Triangle), start, limit);
}

SeamTarget FindSeamTargetAcross(const MovingLeastSquares& cloud, const ToolSurface& tool,
  const Real3& start, double limit, MovingLeastSquares::Neighbourhood& near)
{
  // In the plane of the nearest triangle; then, if that leads beyond it, back onto the tool.
  Real3 place = start;
  for (int step = 0; step < MostTriangles; ++step)
  {
    const ToolSurface::Nearest on = tool.NearestTo(place, limit);
    if (on.Triangle < 0)
    {
      break;
    }
    const Real3 normal = tool.Normal(on.Triangle);
    const CommonPoint found = OntoCloudAndFacet(cloud, tool, on, near);
    if (!found.Found || IsOnFace(tool, found.Point, on.Triangle, limit))
    {
      return TargetOf(found, normal, start, limit);
    }
    place = found.Point;
  }
  SeamTarget none;
  none.Place = start;
  return none;
}

bool IsNearPlanes(const ToolSurface& tool, const std::vector<std::int32_t>& triangles,
  const Real3& place, double limit)
{
  return std::all_of(triangles.begin(), triangles.end(), [&](std::int32_t t) {
    const Real3 corner = tool.Point(tool.Corners(t)[0]);
    return std::abs(Dot(Difference(place, corner), tool.Normal(t))) <= limit;
  });
}

} // namespace sb
