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

// Of the diagonal of the facets' box: CAD systems join faces with gaps of 1e-5 of it and more.
// Where facets were cut, the new corners are off by as much as the facets themselves, so that this
// is allowed for, too: a patch that fits no worse than the facets is still of use.
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
  std::vector<double> Chords; ///< of each facet, from its middle to the patch, as three numbers

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

/** From the middle of each facet to its patch, were the corners on it. */
std::vector<double> ChordsOf(
  const sb::DesignedSurface& surface, const std::vector<double>& onPatch, sb::Executor& executor)
{
  std::vector<double> chords(surface.Triangles.size());
  executor.For(static_cast<std::int64_t>(surface.FaceId.size()), grain,
    [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        if (surface.FaceId[i] < 0)
        {
          continue;
        }
        sb::Real3 middle{};
        double u = 0.0;
        double v = 0.0;
        for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner)
        {
          const std::size_t point = static_cast<std::size_t>(surface.Triangles[corner]);
          const double* x = onPatch.data() + 3 * point;
          middle = sb::PlusScaled(middle, 1.0 / 3.0, { x[0], x[1], x[2] });
          u += surface.UV[2 * point] / 3.0;
          v += surface.UV[2 * point + 1] / 3.0;
        }
        const sb::NURBSSurface& patch =
          surface.Patches[static_cast<std::size_t>(surface.FaceId[i])];
        const sb::Real3 chord = sb::Difference(sb::EvaluatePatch(patch, u, v, 0).Point, middle);
        std::copy(chord.begin(), chord.end(), chords.begin() + static_cast<std::ptrdiff_t>(3 * i));
      }
    });
  return chords;
}

std::vector<Correspondence> GroupPoints(const sb::DesignedSurface& surface,
  const std::vector<std::int32_t>& faceOfPoint, const std::vector<std::int32_t>& groupOfPatch,
  sb::Executor& executor)
{
  const std::vector<double> onPatch = PointsOnPatches(surface, faceOfPoint, executor);
  std::vector<Correspondence> groups(static_cast<std::size_t>(
    groupOfPatch.empty() ? 0 : 1 + *std::max_element(groupOfPatch.begin(), groupOfPatch.end())));
  const auto groupOf = [&](std::int32_t face) -> Correspondence& {
    return groups[static_cast<std::size_t>(groupOfPatch[static_cast<std::size_t>(face)])];
  };
  for (std::size_t i = 0; i < faceOfPoint.size(); ++i)
  {
    for (std::size_t k = 3 * i; k < 3 * i + 3 && faceOfPoint[i] >= 0; ++k)
    {
      groupOf(faceOfPoint[i]).OnPatch.push_back(onPatch[k]);
      groupOf(faceOfPoint[i]).Now.push_back(surface.Points[k]);
    }
  }
  const std::vector<double> chords = ChordsOf(surface, onPatch, executor);
  for (std::size_t k = 0; k < chords.size(); ++k)
  {
    if (surface.FaceId[k / 3] >= 0)
    {
      groupOf(surface.FaceId[k / 3]).Chords.push_back(chords[k]);
    }
  }
  return groups;
}

double LargestChord(const Correspondence& group, const sb::AffineMap& map)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < group.Chords.size(); i += 3)
  {
    const sb::Real3 chord{ group.Chords[i], group.Chords[i + 1], group.Chords[i + 2] };
    largest = std::max(largest, sb::Length(sb::Times(map.Matrix, chord)));
  }
  return largest;
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
    const double chord = LargestChord(group, fits.back().Map);
    if (!(fits.back().MeanError <= mostMeanError * diagonal + 0.5 * chord &&
          fits.back().LargestError <= mostError * diagonal + chord))
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
