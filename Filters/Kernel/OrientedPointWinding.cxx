// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OrientedPointWinding.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace sb
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr std::int64_t Grain = 512;
constexpr int Neighbours = 8;
constexpr std::size_t Width = WindingTree::Width;

} // namespace

OrientedPointWinding::OrientedPointWinding(const MovingLeastSquares& surface, Executor& executor)
  : Surface(surface)
{
  const PointTree& samples = surface.Samples();
  const std::size_t count = static_cast<std::size_t>(samples.Size());
  this->Reference = Scaled(PlusScaled(samples.Lower(), 1.0, samples.Upper()), 0.5);
  this->Areas.resize(count);
  std::vector<WindingDipole>& lowest = this->Groups.Lowest();
  lowest.resize((count + Width - 1) / Width);
  executor.For(
    static_cast<std::int64_t>(lowest.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
      std::array<PointTree::Neighbour, Neighbours + 1> found;
      std::vector<WindingDipole> parts;
      for (std::size_t group = static_cast<std::size_t>(begin);
           group < static_cast<std::size_t>(end); ++group)
      {
        parts.clear();
        for (std::size_t i = group * Width; i < std::min(count, (group + 1) * Width); ++i)
        {
          const std::int32_t sample = static_cast<std::int32_t>(i);
          const int number = samples.Nearest(samples.Point(sample), Neighbours + 1, found.data());
          this->Areas[i] =
            Pi * found[static_cast<std::size_t>(number - 1)].SquaredDistance / (number - 1);
          parts.push_back(this->SampleDipole(sample));
        }
        lowest[group] = WindingDipole::Of(parts, 0, parts.size());
      }
    });
  this->Groups.Build(
    [&executor](std::int64_t loops, const auto& body) { executor.For(loops, Grain, body); });
}

WindingDipole OrientedPointWinding::SampleDipole(std::int32_t sample) const
{
  const Real3 from = Difference(this->Surface.Samples().Point(sample), this->Reference);
  const Real3 normal = this->Surface.SampleNormal(sample);
  WindingDipole one;
  one.Area = this->Areas[static_cast<std::size_t>(sample)];
  one.Center = { from[0], from[1], from[2] };
  one.Normal = one.Area * Vector3{ normal[0], normal[1], normal[2] };
  return one;
}

double OrientedPointWinding::NearBy(const Vector3& place, std::int32_t group) const
{
  double sum = 0.0;
  const std::size_t first = static_cast<std::size_t>(group) * Width;
  for (std::size_t i = first; i < std::min(this->Areas.size(), first + Width); ++i)
  {
    const WindingDipole one = this->SampleDipole(static_cast<std::int32_t>(i));
    const Vector3 r = one.Center - place;
    // A disk, not a point: from nearer than its radius it fills half of the view at most.
    const double squared = SquaredLength(r);
    sum += squared > 0.0 ? one.SolidAngle(r, std::max(squared, one.Area / Pi)) : 0.0;
  }
  return sum;
}

double OrientedPointWinding::At(const Real3& place) const
{
  if (this->Groups.IsEmpty())
  {
    return 0.0;
  }
  const Real3 from = Difference(place, this->Reference);
  const Vector3 query{ from[0], from[1], from[2] };
  return this->Groups.SolidAngleAt(
           query, [&](std::int32_t group) { return this->NearBy(query, group); }) /
    (4.0 * Pi);
}

} // namespace sb
