// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudOrientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr std::int32_t Dipoles = 4096;
constexpr std::int32_t Places = 64;
constexpr int Neighbours = 8;

struct Dipole
{
  Real3 Place{};
  Real3 Normal{}; ///< as long as the area
  double Area = 0.0;
};

/** Every so many samples of the tree, which stand for those between them; as the order of the tree
 * is one in space, they are spread evenly. */
std::vector<Dipole> SelectDipoles(const MovingLeastSquares& surface, Executor& executor)
{
  const PointTree& samples = surface.Samples();
  const std::int32_t step = (samples.Size() + Dipoles - 1) / Dipoles;
  std::vector<Dipole> dipoles(static_cast<std::size_t>((samples.Size() + step - 1) / step));
  executor.For(
    static_cast<std::int64_t>(dipoles.size()), 64, [&](std::int64_t begin, std::int64_t end) {
      std::array<PointTree::Neighbour, Neighbours + 1> found;
      for (std::int64_t i = begin; i < end; ++i)
      {
        const std::int32_t sample = static_cast<std::int32_t>(i) * step;
        Dipole& dipole = dipoles[static_cast<std::size_t>(i)];
        dipole.Place = samples.Point(sample);
        const int number = samples.Nearest(dipole.Place, Neighbours + 1, found.data());
        const double squared = found[static_cast<std::size_t>(number - 1)].SquaredDistance;
        dipole.Area = step * Pi * squared / std::max(1, number - 1);
        dipole.Normal = Scaled(surface.SampleNormal(sample), dipole.Area);
      }
    });
  return dipoles;
}

/** The winding number at one of them, without its own part. */
double WindingAt(const std::vector<Dipole>& dipoles, std::size_t place)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < dipoles.size(); ++i)
  {
    const Real3 way = Difference(dipoles[i].Place, dipoles[place].Place);
    const double squared = Dot(way, way);
    if (i != place && squared > 0.0)
    {
      // A disk, not a point: from nearer than its radius it does not fill more of the view.
      const double bounded = std::max(squared, dipoles[i].Area / Pi);
      sum += Dot(way, dipoles[i].Normal) / (bounded * std::sqrt(bounded));
    }
  }
  return sum / (4.0 * Pi);
}

} // namespace

double WindingOnSurface(const MovingLeastSquares& surface, Executor& executor)
{
  const std::vector<Dipole> dipoles = SelectDipoles(surface, executor);
  const std::size_t number = std::min<std::size_t>(Places, dipoles.size());
  std::vector<double> windings(number);
  executor.For(static_cast<std::int64_t>(number), 4, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      const std::size_t k = static_cast<std::size_t>(i);
      windings[k] = WindingAt(dipoles, dipoles.size() * k / number);
    }
  });
  double sum = 0.0;
  for (const double winding : windings)
  {
    sum += std::clamp(winding, -0.5, 0.5);
  }
  return number > 0 ? sum / static_cast<double>(number) : 0.0;
}

} // namespace sb
