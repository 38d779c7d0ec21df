// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CoincidentArea.h"

#include <algorithm>
#include <cmath>

namespace sb
{
namespace
{

constexpr double LeastRadius = 2.0; ///< of a coincident area, in widths
constexpr double LeastTolerance = 0.02; ///< in spacings, where there is no noise
constexpr double Deviations = 4.0;
constexpr std::int32_t MostProbes = 2000;

/** The deviation of the samples from their surface, by its median at some of them. */
double NoiseOf(const MovingLeastSquares& surface)
{
  const PointTree& samples = surface.Samples();
  const std::int32_t step = std::max<std::int32_t>(1, samples.Size() / MostProbes);
  std::vector<double> residuals;
  MovingLeastSquares::Neighbourhood near;
  for (std::int32_t i = 0; i < samples.Size(); i += step)
  {
    const SurfaceValue f = surface.EvaluateAt(samples.Point(i), 0, near);
    if (f.IsNear)
    {
      residuals.push_back(std::abs(f.Value));
    }
  }
  if (residuals.empty())
  {
    return 0.0;
  }
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  constexpr double deviationToMedian = 1.4826; // of a normal distribution
  return deviationToMedian * *middle;
}

bool Coincides(const BandMesh& band, const BandMesh::Triangle& triangle, double tolerance)
{
  for (const std::int32_t place : triangle.Places)
  {
    if (!band.IsKnown(place) ||
      !(std::abs(band.Values[static_cast<std::size_t>(place)].Value) <= tolerance))
    {
      return false;
    }
  }
  const auto& p = triangle.Places;
  const Real3 normal = UnitNormalOf(band.Place(p[0]), band.Place(p[1]), band.Place(p[2]));
  return std::all_of(p.begin(), p.end(), [&](std::int32_t place) {
    return SineBetween(band.Values[static_cast<std::size_t>(place)].Gradient, normal) <=
      TangentialSine;
  });
}

Real3 CentreOf(const BandMesh& band, const BandMesh::Triangle& triangle)
{
  Real3 centre{};
  for (const std::int32_t place : triangle.Places)
  {
    centre = PlusScaled(centre, 1.0 / 3.0, band.Place(place));
  }
  return centre;
}

/** Keep of the marked triangles those whose centre's distance from the centres of those with the
 * other mark is above (or not above) a bound. */
template <class Keep>
void Sift(const BandMesh& band, const std::vector<std::uint8_t>& seeds, std::uint8_t seed,
  Executor& executor, const Keep& keep)
{
  std::vector<double> centres;
  for (std::size_t t = 0; t < seeds.size(); ++t)
  {
    if (seeds[t] == seed)
    {
      const Real3 centre = CentreOf(band, band.Triangles[t]);
      centres.insert(centres.end(), centre.begin(), centre.end());
    }
  }
  const PointTree tree(
    centres.data(), static_cast<std::int64_t>(centres.size() / 3), nullptr, executor);
  executor.For(
    static_cast<std::int64_t>(seeds.size()), 256, [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
      {
        PointTree::Neighbour nearest{};
        const bool isAny = tree.Nearest(CentreOf(band, band.Triangles[t]), 1, &nearest) > 0;
        keep(t, isAny ? std::sqrt(nearest.SquaredDistance) : HUGE_VAL);
      }
    });
}

} // namespace

double SineBetween(const Real3& gradient, const Real3& unitNormal)
{
  const double steepness = Length(gradient);
  return steepness > 0.0 ? Length(Cross(gradient, unitNormal)) / steepness : 0.0;
}

std::vector<std::uint8_t> FindCoincidentArea(
  const BandMesh& band, const MovingLeastSquares& surface, double spacing, Executor& executor)
{
  const double averaged =
    NoiseOf(surface) * spacing / (surface.Width() * std::sqrt(2.0 * std::acos(-1.0)));
  const double tolerance = Deviations * averaged + LeastTolerance * spacing;
  const double radius = LeastRadius * surface.Width();
  std::vector<std::uint8_t> coincides(band.Triangles.size(), 0);
  for (std::size_t t = 0; t < coincides.size(); ++t)
  {
    coincides[t] = Coincides(band, band.Triangles[t], tolerance) ? 1 : 0;
  }
  if (std::find(coincides.begin(), coincides.end(), 1) == coincides.end())
  {
    return {};
  }
  // An opening: first what is far from all that does not coincide, then what is near to that.
  std::vector<std::uint8_t> isCore(coincides.size(), 0);
  Sift(band, coincides, 0, executor,
    [&](std::size_t t, double distance) { isCore[t] = coincides[t] && distance > radius ? 1 : 0; });
  if (std::find(isCore.begin(), isCore.end(), 1) == isCore.end())
  {
    return {};
  }
  std::vector<std::uint8_t> isArea(coincides.size(), 0);
  Sift(band, isCore, 1, executor, [&](std::size_t t, double distance) {
    isArea[t] = coincides[t] && distance <= radius ? 1 : 0;
  });
  return isArea;
}

} // namespace sb
