// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchMiddle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{
namespace
{

constexpr double FarthestInEdges = 0.5; ///< that the middle of an edge may be from its chord

Real3 MiddleOf(const Real3& a, const Real3& b)
{
  return { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
}

constexpr double CommonInEdges = 1e-12; ///< what counts as one point

double Apart(const Real3& a, const Real3& b) { return Length(Difference(a, b)); }

/** The common point of three planes n . x = d, if their normals span space. */
bool CommonPoint(const Real3 (&n)[3], const Real3& d, Real3& x)
{
  constexpr double flattest = 1e-3;
  const Real3 crosses[3] = { Cross(n[1], n[2]), Cross(n[2], n[0]), Cross(n[0], n[1]) };
  const double determinant = Dot(n[0], crosses[0]);
  if (!(std::abs(determinant) > flattest))
  {
    return false;
  }
  x = Scaled(PlusScaled(PlusScaled(Scaled(crosses[0], d[0]), d[1], crosses[1]), d[2], crosses[2]),
    1.0 / determinant);
  return true;
}

} // namespace

PlaceOnPatch MiddleOnPatch(const PatchEdge& edge)
{
  const Real3 middle = MiddleOf(edge.A.Point, edge.B.Point);
  const double farthest = FarthestInEdges * Apart(edge.A.Point, edge.B.Point);
  const double u = 0.5 * (edge.A.U + edge.B.U);
  const double v = 0.5 * (edge.A.V + edge.B.V);
  const Real3 point = EvaluatePatch(*edge.Patch, u, v, 0).Point;
  if (Apart(point, middle) <= farthest)
  {
    return { u, v, point, Apart(point, middle) };
  }
  for (const PlaceOnPatch* start : { &edge.A, &edge.B })
  {
    const PlaceOnPatch nearest = ClosestOnPatchFrom(*edge.Patch, middle, start->U, start->V);
    if (nearest.Distance <= farthest)
    {
      return nearest;
    }
  }
  return { u, v, middle, 0.0 };
}

namespace
{

/** Where two patches meet in the plane across the middle of the chord, if they do at an angle. */
bool MeetingPoint(
  const std::vector<PatchEdge>& edges, std::vector<PlaceOnPatch> places, Real3& common)
{
  const Real3 middle = MiddleOf(edges[0].A.Point, edges[0].B.Point);
  const Real3 along = Difference(edges[0].B.Point, edges[0].A.Point);
  const double size = Length(along);
  common = middle;
  constexpr int most = 12;
  for (int iteration = 0; iteration < most && size > 0.0; ++iteration)
  {
    Real3 normals[3];
    Real3 offsets{};
    for (std::size_t k = 0; k < 2; ++k)
    {
      const PatchPoint at = EvaluatePatch(*edges[k].Patch, places[k].U, places[k].V, 1);
      const Real3 normal = Cross(at.Du, at.Dv);
      const double length = Length(normal);
      normals[k] = length > 0.0 ? Scaled(normal, 1.0 / length) : Real3{};
      offsets[k] = Dot(normals[k], Difference(at.Point, middle));
    }
    normals[2] = Scaled(along, 1.0 / size);
    Real3 step{};
    if (!CommonPoint(normals, offsets, step) || !(Length(step) <= FarthestInEdges * size))
    {
      return false;
    }
    const Real3 next = PlusScaled(middle, 1.0, step);
    const double moved = Apart(next, common);
    common = next;
    for (std::size_t k = 0; k < 2; ++k)
    {
      places[k] = ClosestOnPatchFrom(*edges[k].Patch, common, places[k].U, places[k].V);
    }
    if (moved <= CommonInEdges * size)
    {
      return true;
    }
  }
  return false;
}

} // namespace

Real3 CommonMiddle(const std::vector<PatchEdge>& edges, std::vector<PlaceOnPatch>& places)
{
  std::vector<PlaceOnPatch> middles;
  std::vector<Real3> candidates;
  for (const PatchEdge& edge : edges)
  {
    middles.push_back(MiddleOnPatch(edge));
  }
  candidates.push_back(middles.front().Point);
  Real3 meeting{};
  if (edges.size() == 2 && MeetingPoint(edges, middles, meeting))
  {
    candidates.push_back(meeting);
  }
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    const Real3 chord = MiddleOf(edges[k].A.Point, edges[k].B.Point);
    candidates.push_back(
      ClosestOnPatchFrom(*edges[k].Patch, chord, middles[k].U, middles[k].V).Point);
    candidates.push_back(middles[k].Point);
  }
  const double enough = CommonInEdges * Apart(edges.front().A.Point, edges.front().B.Point);
  double least = std::numeric_limits<double>::infinity();
  Real3 best = candidates.front();
  for (std::size_t c = 0; c < candidates.size() && least > enough; ++c)
  {
    double gap = 0.0;
    std::vector<PlaceOnPatch> nearest;
    for (std::size_t k = 0; k < edges.size(); ++k)
    {
      nearest.push_back(
        ClosestOnPatchFrom(*edges[k].Patch, candidates[c], middles[k].U, middles[k].V));
      gap = std::max(gap, nearest.back().Distance);
    }
    if (gap < least)
    {
      least = gap;
      best = candidates[c];
      places = nearest;
    }
  }
  return best;
}

} // namespace sb
