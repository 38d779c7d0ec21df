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

std::array<double, 2> MiddleOf(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) };
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

PlaceOnPatch NearestOnPatch(const NURBSSurface& patch, const Real3& x, std::array<double, 2> uv)
{
  constexpr int most = 20;
  PatchPoint at = EvaluatePatch(patch, uv[0], uv[1], 1);
  for (int iteration = 0; iteration < most; ++iteration)
  {
    const Real3 away = Difference(x, at.Point);
    const double uu = Dot(at.Du, at.Du);
    const double mixed = Dot(at.Du, at.Dv);
    const double vv = Dot(at.Dv, at.Dv);
    const double determinant = uu * vv - mixed * mixed;
    const double alongU = Dot(at.Du, away);
    const double alongV = Dot(at.Dv, away);
    // At a pole one direction has no length: then only the other one is followed.
    const bool isRegular = determinant > 1e-12 * uu * vv;
    const double du = isRegular ? (vv * alongU - mixed * alongV) / determinant
                                : (uu >= vv && uu > 0.0 ? alongU / uu : 0.0);
    const double dv =
      isRegular ? (uu * alongV - mixed * alongU) / determinant : (vv > uu ? alongV / vv : 0.0);
    bool isNearer = false;
    for (double factor = 1.0; !isNearer && factor > 1e-3; factor *= 0.25)
    {
      const std::array<double, 2> next{ std::clamp(
                                          uv[0] + factor * du, patch.FirstU(), patch.LastU()),
        std::clamp(uv[1] + factor * dv, patch.FirstV(), patch.LastV()) };
      const PatchPoint reached = EvaluatePatch(patch, next[0], next[1], 1);
      isNearer = Apart(reached.Point, x) < Apart(at.Point, x);
      if (isNearer)
      {
        uv = next;
        at = reached;
      }
    }
    if (!isNearer)
    {
      break;
    }
  }
  return { at.Point, uv };
}

PlaceOnPatch MiddleOnPatch(const PatchEdge& edge)
{
  const Real3 middle = MiddleOf(edge.A.Point, edge.B.Point);
  const double farthest = FarthestInEdges * Apart(edge.A.Point, edge.B.Point);
  const std::array<double, 2> uv = MiddleOf(edge.A.UV, edge.B.UV);
  const Real3 point = EvaluatePatch(*edge.Patch, uv[0], uv[1], 0).Point;
  if (Apart(point, middle) <= farthest)
  {
    return { point, uv };
  }
  for (const std::array<double, 2>& start : { edge.A.UV, edge.B.UV, uv })
  {
    const PlaceOnPatch nearest = NearestOnPatch(*edge.Patch, middle, start);
    if (Apart(nearest.Point, middle) <= farthest)
    {
      return nearest;
    }
  }
  return { middle, uv };
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
      const PatchPoint at = EvaluatePatch(*edges[k].Patch, places[k].UV[0], places[k].UV[1], 1);
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
      places[k] = NearestOnPatch(*edges[k].Patch, common, places[k].UV);
    }
    if (moved <= CommonInEdges * size)
    {
      return true;
    }
  }
  return false;
}

} // namespace

Real3 CommonMiddle(const std::vector<PatchEdge>& edges, std::vector<std::array<double, 2>>& uv)
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
    candidates.push_back(NearestOnPatch(*edges[k].Patch, chord, middles[k].UV).Point);
    candidates.push_back(middles[k].Point);
  }
  const double enough = CommonInEdges * Apart(edges.front().A.Point, edges.front().B.Point);
  double least = std::numeric_limits<double>::infinity();
  Real3 best = candidates.front();
  for (std::size_t c = 0; c < candidates.size() && least > enough; ++c)
  {
    double gap = 0.0;
    std::vector<std::array<double, 2>> places;
    for (std::size_t k = 0; k < edges.size(); ++k)
    {
      const PlaceOnPatch nearest = NearestOnPatch(*edges[k].Patch, candidates[c], middles[k].UV);
      gap = std::max(gap, Apart(nearest.Point, candidates[c]));
      places.push_back(nearest.UV);
    }
    if (gap < least)
    {
      least = gap;
      best = candidates[c];
      uv = places;
    }
  }
  return best;
}

} // namespace sb
