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

/** 1 for cells whose centre is not farther than the radius from that of a cell with the mark. */
std::vector<std::uint8_t> NearMarked(const std::vector<Real3>& centres,
  const std::vector<std::uint8_t>& marks, std::uint8_t mark, double radius, Executor& executor)
{
  std::vector<double> marked;
  for (std::size_t cell = 0; cell < marks.size(); ++cell)
  {
    if (marks[cell] == mark)
    {
      marked.insert(marked.end(), centres[cell].begin(), centres[cell].end());
    }
  }
  const PointTree tree(
    marked.data(), static_cast<std::int64_t>(marked.size() / 3), nullptr, executor);
  std::vector<std::uint8_t> isNear(marks.size(), 0);
  executor.For(
    static_cast<std::int64_t>(marks.size()), 256, [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t cell = static_cast<std::size_t>(begin); cell < static_cast<std::size_t>(end);
           ++cell)
      {
        PointTree::Neighbour nearest{};
        isNear[cell] = tree.Nearest(centres[cell], 1, &nearest) > 0 &&
          nearest.SquaredDistance <= radius * radius;
      }
    });
  return isNear;
}

bool IsAny(const std::vector<std::uint8_t>& marks)
{
  return std::find(marks.begin(), marks.end(), 1) != marks.end();
}

} // namespace

double SineBetween(const Real3& gradient, const Real3& unitNormal)
{
  const double steepness = Length(gradient);
  return steepness > 0.0 ? Length(Cross(gradient, unitNormal)) / steepness : 0.0;
}

Real3 UnitNormalOf(const Real3& a, const Real3& b, const Real3& c)
{
  const Real3 normal = Cross(Difference(b, a), Difference(c, a));
  const double size = Length(normal);
  return size > 0.0 ? Scaled(normal, 1.0 / size) : Real3{};
}

double CoincidenceTolerance::Value()
{
  if (this->Known < 0.0)
  {
    const double averaged = NoiseOf(this->Surface) * this->Spacing /
      (this->Surface.Width() * std::sqrt(2.0 * std::acos(-1.0)));
    this->Known = std::min(this->Most(), Deviations * averaged + LeastTolerance * this->Spacing);
  }
  return this->Known;
}

/** An opening: first what is far from all that does not coincide, then what is near to that. */
std::vector<std::uint8_t> AreaOf(const std::vector<Real3>& centres,
  const std::vector<std::uint8_t>& coincides, double width, Executor& executor)
{
  const double radius = LeastRadius * width;
  if (!IsAny(coincides))
  {
    return {};
  }
  std::vector<std::uint8_t> core = NearMarked(centres, coincides, 0, radius, executor);
  for (std::size_t cell = 0; cell < core.size(); ++cell)
  {
    core[cell] = coincides[cell] && !core[cell] ? 1 : 0;
  }
  if (!IsAny(core))
  {
    return {};
  }
  std::vector<std::uint8_t> area = NearMarked(centres, core, 1, radius, executor);
  for (std::size_t cell = 0; cell < area.size(); ++cell)
  {
    area[cell] = area[cell] && coincides[cell] ? 1 : 0;
  }
  return area;
}

std::vector<std::uint8_t> FindCoincidentArea(
  const BandMesh& band, const MovingLeastSquares& surface, double spacing, Executor& executor)
{
  CoincidenceTolerance tolerance(surface, spacing);
  std::vector<Real3> centres;
  for (const BandMesh::Triangle& triangle : band.Triangles)
  {
    centres.push_back(CentreOf(band, triangle));
  }
  const auto areaWithin = [&](double most) {
    std::vector<std::uint8_t> coincides;
    for (const BandMesh::Triangle& triangle : band.Triangles)
    {
      coincides.push_back(Coincides(band, triangle, most) ? 1 : 0);
    }
    return AreaOf(centres, coincides, surface.Width(), executor);
  };
  return IsAny(areaWithin(tolerance.Most())) ? areaWithin(tolerance.Value())
                                             : std::vector<std::uint8_t>();
}

} // namespace sb
