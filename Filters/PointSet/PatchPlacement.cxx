// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchPlacement.h"

#include "AffineFit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace sbvtk
{
namespace
{

// Of the diagonal of the facets' box. CAD systems join faces with gaps of 1e-5 of it and more; a
// thousandth is what facets themselves are off by, so that patches which fit worse are of no use.
constexpr double mostMeanError = 1e-4;
constexpr double mostError = 1e-3;

constexpr std::int64_t grain = 1024;

/** Which patch each point is on (-1: none), or false if a point is on two. */
bool FindFaces(const sb::DesignedSurface& surface, std::vector<std::int32_t>& faceOfPoint)
{
  faceOfPoint.assign(surface.Points.size() / 3, -1);
  for (std::size_t corner = 0; corner < surface.Triangles.size(); ++corner)
  {
    std::int32_t& face = faceOfPoint[static_cast<std::size_t>(surface.Triangles[corner])];
    const std::int32_t own = surface.FaceId[corner / 3];
    if (face >= 0 && own >= 0 && own != face)
    {
      return false;
    }
    face = std::max(face, own);
  }
  return true;
}

/** The points of one group: where the patches have them, and where they are. */
struct Correspondence
{
  std::vector<double> OnPatch;
  std::vector<double> Now;

  double Diagonal() const
  {
    sb::Real3 lower{ HUGE_VAL, HUGE_VAL, HUGE_VAL };
    sb::Real3 upper{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
    for (std::size_t i = 0; i < this->Now.size(); ++i)
    {
      lower[i % 3] = std::min(lower[i % 3], this->Now[i]);
      upper[i % 3] = std::max(upper[i % 3], this->Now[i]);
    }
    return sb::Length(sb::Difference(upper, lower));
  }
};

/** The point of its patch at each point's parameters. */
std::vector<double> PointsOnPatches(const sb::DesignedSurface& surface,
  const std::vector<std::int32_t>& faceOfPoint, sb::Executor& executor)
{
  std::vector<double> onPatch(surface.Points.size());
  executor.For(static_cast<std::int64_t>(faceOfPoint.size()), grain,
    [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        if (faceOfPoint[i] >= 0)
        {
          const sb::NURBSSurface& patch = surface.Patches[static_cast<std::size_t>(faceOfPoint[i])];
          const sb::Real3 point =
            sb::EvaluatePatch(patch, surface.UV[2 * i], surface.UV[2 * i + 1], 0).Point;
          std::copy(
            point.begin(), point.end(), onPatch.begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
      }
    });
  return onPatch;
}

std::vector<Correspondence> GroupPoints(const sb::DesignedSurface& surface,
  const std::vector<std::int32_t>& faceOfPoint, const std::vector<std::int32_t>& groupOfPatch,
  sb::Executor& executor)
{
  const std::vector<double> onPatch = PointsOnPatches(surface, faceOfPoint, executor);
  std::vector<Correspondence> groups(static_cast<std::size_t>(
    groupOfPatch.empty() ? 0 : 1 + *std::max_element(groupOfPatch.begin(), groupOfPatch.end())));
  for (std::size_t i = 0; i < faceOfPoint.size(); ++i)
  {
    if (faceOfPoint[i] >= 0)
    {
      Correspondence& group =
        groups[static_cast<std::size_t>(groupOfPatch[static_cast<std::size_t>(faceOfPoint[i])])];
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
      {
        group.OnPatch.push_back(onPatch[k]);
        group.Now.push_back(surface.Points[k]);
      }
    }
  }
  return groups;
}

std::string Misfit(double error)
{
  std::ostringstream sentence;
  sentence
    << "has facets up to " << error
    << " off the exact surfaces that it carries, so these are not used; move, turn, scale or "
       "mirror a designed body, but do not bend it, merge its points or append it to another "
       "one (group them instead).";
  return sentence.str();
}

void MovePoles(sb::NURBSSurface& patch, const sb::AffineMap& map)
{
  for (std::size_t i = 0; i < patch.Poles.size(); i += 4)
  {
    const sb::Real3 moved = map.Apply({ patch.Poles[i], patch.Poles[i + 1], patch.Poles[i + 2] });
    std::copy(moved.begin(), moved.end(), patch.Poles.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

} // namespace

std::string PlacePatches(sb::DesignedSurface& surface,
  const std::vector<std::int32_t>& groupOfPatch, sb::Executor& executor)
{
  std::vector<std::int32_t> faceOfPoint;
  if (!FindFaces(surface, faceOfPoint))
  {
    return "has faces that share points, which then have the UV of one of them only, so its exact "
           "surfaces are not used; leave out the filter that merges points.";
  }
  std::vector<sb::AffineFit> fits;
  for (const Correspondence& group : GroupPoints(surface, faceOfPoint, groupOfPatch, executor))
  {
    fits.push_back(sb::FitAffineMap(
      group.OnPatch.data(), group.Now.data(), static_cast<std::int64_t>(group.Now.size() / 3)));
    const double diagonal = group.Now.empty() ? 0.0 : group.Diagonal();
    if (!(fits.back().MeanError <= mostMeanError * diagonal &&
          fits.back().LargestError <= mostError * diagonal))
    {
      return Misfit(fits.back().LargestError);
    }
  }
  for (std::size_t i = 0; i < groupOfPatch.size(); ++i)
  {
    const sb::AffineFit& fit = fits[static_cast<std::size_t>(groupOfPatch[i])];
    if (!fit.IsIdentity)
    {
      MovePoles(surface.Patches[i], fit.Map);
    }
  }
  return "";
}

} // namespace sbvtk
