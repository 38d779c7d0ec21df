// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenScanBoolean.h"

#include "Intersection.h"
#include "OrientedPointWinding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>

namespace sb
{
namespace
{

constexpr std::size_t PlacesOfPatch = 64; ///< at which a winding number is asked for

/** Where a patch is asked about its winding number: middles of its triangles, and their areas. */
struct Place
{
  Real3 Middle;
  double Area;
};

Place PlaceOf(const std::array<Real3, 3>& corners)
{
  const Real3 sum = PlusScaled(PlusScaled(corners[0], 1.0, corners[1]), 1.0, corners[2]);
  return { Scaled(sum, 1.0 / 3.0),
    0.5 * Length(Cross(Difference(corners[1], corners[0]), Difference(corners[2], corners[0]))) };
}

Real3 PointOf(const double* points, std::int32_t i)
{
  const double* const p = points + 3 * static_cast<std::size_t>(i);
  return { p[0], p[1], p[2] };
}

/** The places of all patches of a surface. */
std::vector<std::vector<Place>> PlacesOfPatches(
  const SplitSurface& split, const Surface& mesh, std::int32_t operand)
{
  std::vector<std::vector<Place>> places(static_cast<std::size_t>(split.NumberOfPatches));
  const auto add = [&](std::int32_t patch, const std::array<Real3, 3>& corners) {
    if (patch >= 0)
    {
      places[static_cast<std::size_t>(patch)].push_back(PlaceOf(corners));
    }
  };
  for (std::size_t t = 0; t < split.PatchOfTriangle.size(); ++t)
  {
    const std::int32_t* const ids = mesh.Triangles + 3 * t;
    add(split.PatchOfTriangle[t],
      { PointOf(mesh.Points, ids[0]), PointOf(mesh.Points, ids[1]), PointOf(mesh.Points, ids[2]) });
  }
  std::vector<Real3> points;
  for (std::size_t k = 0; k < split.KeptPoints.size(); ++k)
  {
    for (const std::int32_t id : split.KeptPoints[k])
    {
      points.push_back(
        static_cast<std::int32_t>(k) == operand ? PointOf(mesh.Points, id) : Real3{});
    }
  }
  for (const InterpolatedPoint& point : split.Interpolated)
  {
    points.push_back(point.Position);
  }
  for (std::size_t p = 0; p < split.PatchOfPiece.size(); ++p)
  {
    const std::array<std::int32_t, 3>& ids = split.Split.Corners[p];
    add(split.PatchOfPiece[p],
      { points[static_cast<std::size_t>(ids[0])], points[static_cast<std::size_t>(ids[1])],
        points[static_cast<std::size_t>(ids[2])] });
  }
  return places;
}

/** The mean over the area of at most PlacesOfPatch of a patch's largest triangles. */
double MeanWinding(std::vector<Place> places, const std::function<double(const Real3&)>& winding)
{
  std::stable_sort(
    places.begin(), places.end(), [](const Place& a, const Place& b) { return a.Area > b.Area; });
  places.resize(std::min(places.size(), PlacesOfPatch));
  double sum = 0.0;
  double area = 0.0;
  for (const Place& place : places)
  {
    sum += place.Area * winding(place.Middle);
    area += place.Area;
  }
  return area > 0.0 ? sum / area : 0.0;
}

std::vector<double> MeanWindings(const std::vector<std::vector<Place>>& patches,
  const std::function<double(const Real3&)>& winding, Executor& executor)
{
  std::vector<double> means(patches.size());
  executor.For(
    static_cast<std::int64_t>(patches.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        means[i] = MeanWinding(patches[i], winding);
      }
    });
  return means;
}

double ConfidenceOf(double winding) { return std::min(1.0, std::abs(2.0 * winding - 1.0)); }

/** How sure it is that triangles and pieces of one operand are in the result; -1 if they are not.
 */
struct Choice
{
  std::vector<double> Triangles;
  std::vector<double> Pieces;
};

/** Those of patches inside, or outside. */
Choice Choose(const SplitSurface& split, const std::vector<double>& windings, bool takeInside)
{
  const auto confidence = [&](std::int32_t patch) {
    const double winding = patch >= 0 ? windings[static_cast<std::size_t>(patch)] : 0.0;
    return patch >= 0 && (winding > 0.5) == takeInside ? ConfidenceOf(winding) : -1.0;
  };
  Choice choice;
  std::transform(split.PatchOfTriangle.begin(), split.PatchOfTriangle.end(),
    std::back_inserter(choice.Triangles), confidence);
  std::transform(split.PatchOfPiece.begin(), split.PatchOfPiece.end(),
    std::back_inserter(choice.Pieces), confidence);
  return choice;
}

} // namespace

OpenScanResult CombineOpenScan(const MovingLeastSquares& cloud, const Surface& cloudMesh,
  const ToolSurface& tool, CloudOperation operation, Executor& executor, Monitor& monitor)
{
  OpenScanResult result;
  IntersectionRequest request;
  request.Operands.push_back({ cloudMesh, Group::Input, nullptr });
  request.Operands.push_back({ tool.Mesh(), Group::Tool, nullptr });
  request.Split.assign(2, 1);
  IntersectionResult cut = ComputeIntersection(request, executor, monitor);
  result.Condition = cut.Condition;
  result.Remarks = std::move(cut.Remarks);
  result.Times = std::move(cut.Times);
  if (IsError(result.Condition) || cut.Surfaces.size() != 2)
  {
    return result;
  }
  const OrientedPointWinding scan(cloud, executor);
  const std::vector<double> ofScan = MeanWindings(
    PlacesOfPatches(cut.Surfaces[0], cloudMesh, 0),
    [&tool](const Real3& place) { return tool.WindingNumber(place); }, executor);
  const std::vector<double> ofTool = MeanWindings(
    PlacesOfPatches(cut.Surfaces[1], tool.Mesh(), 1),
    [&scan](const Real3& place) { return scan.At(place); }, executor);
  const bool scanInside =
    operation == CloudOperation::Intersection || operation == CloudOperation::ReverseDifference;
  const bool toolInside =
    operation == CloudOperation::Intersection || operation == CloudOperation::Difference;
  const Choice fromScan = Choose(cut.Surfaces[0], ofScan, scanInside);
  const Choice fromTool = Choose(cut.Surfaces[1], ofTool, toolInside);
  for (const double winding : ofTool)
  {
    result.LeastConfidence = std::min(result.LeastConfidence, ConfidenceOf(winding));
    result.LeastWinding = std::min(result.LeastWinding, winding);
  }
  result.Mesh = Combine({ { &cut.Surfaces[0], 0, &fromScan.Triangles, &fromScan.Pieces,
                            operation == CloudOperation::ReverseDifference },
                          { &cut.Surfaces[1], 1, &fromTool.Triangles, &fromTool.Pieces,
                            operation == CloudOperation::Difference } },
    { cloudMesh, tool.Mesh() }, executor);
  result.Seam = std::move(cut.Intersection);
  return result;
}

} // namespace sb
