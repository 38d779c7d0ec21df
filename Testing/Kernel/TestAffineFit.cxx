// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestAffineFit.cxx
 * @brief The map of moved points is found to rounding although two fifths of them are off, in
 * planes and far from the origin too; what has not been moved has exactly no map; what is bent is
 * told.
 */
#include "AffineFit.h"
#include "Check.h"

#include <cmath>
#include <random>
#include <vector>

namespace
{

using sb::Real3;

std::vector<double> Points(std::size_t count, double thickness, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(uniform(random));
    points.push_back(uniform(random));
    points.push_back(thickness * uniform(random));
  }
  return points;
}

std::vector<double> Moved(const std::vector<double>& points, const sb::AffineMap& map)
{
  std::vector<double> moved;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const Real3 image = map.Apply({ points[i], points[i + 1], points[i + 2] });
    moved.insert(moved.end(), image.begin(), image.end());
  }
  return moved;
}

/** Two points of five moved by up to `size`, as those on edges are. */
void Disturb(std::vector<double>& points, double size)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-size, size);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    for (std::size_t k = 0; k < 3 && i / 3 % 5 < 2; ++k)
    {
      points[i + k] += uniform(random);
    }
  }
}

double LargestDifference(
  const sb::AffineMap& found, const sb::AffineMap& wanted, const std::vector<double>& points)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const Real3 x{ points[i], points[i + 1], points[i + 2] };
    largest = std::max(largest, sb::Length(sb::Difference(found.Apply(x), wanted.Apply(x))));
  }
  return largest;
}

sb::AffineMap Map(double scale, double mirror, const Real3& offset)
{
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  sb::AffineMap map;
  map.Matrix = { { { scale * c, -scale * s, 0.2 }, { scale * s, scale * c, 0.0 },
    { 0.0, 0.1, mirror * scale } } };
  map.Offset = offset;
  return map;
}

double Determinant(const sb::AffineMap& map)
{
  return sb::Dot(sb::Cross(map.Matrix[0], map.Matrix[1]), map.Matrix[2]);
}

void MapsAreFound()
{
  for (const double mirror : { 1.0, -1.0 })
  {
    for (const double scale : { 1e-3, 1.0, 1e3 })
    {
      const sb::AffineMap map = Map(scale, mirror, { 3.0, -2.0, 7.0 });
      const std::vector<double> points = Points(500, 1.0, 1);
      std::vector<double> moved = Moved(points, map);
      Disturb(moved, 1e-4 * scale);
      const sb::AffineFit fit = sb::FitAffineMap(points.data(), moved.data(), 500);
      CHECK(!fit.IsIdentity);
      CHECK(LargestDifference(fit.Map, map, points) < 2e-14 * (8.0 + scale));
      CHECK(fit.LargestError > 5e-5 * scale && fit.LargestError < 2e-4 * scale);
      CHECK((Determinant(fit.Map) < 0.0) == (Determinant(map) < 0.0));
    }
  }
}

void WhatIsUnmovedStaysToTheBit()
{
  const std::vector<double> points = Points(500, 1.0, 2);
  std::vector<double> moved = points;
  Disturb(moved, 1e-4);
  const sb::AffineFit fit = sb::FitAffineMap(points.data(), moved.data(), 500);
  CHECK(fit.IsIdentity);
  CHECK_EQUAL(fit.Map.Offset[0], 0.0);
  CHECK_EQUAL(fit.Map.Matrix[1][1], 1.0);
}

void SmallMovesAreMovesAll()
{
  const std::vector<double> points = Points(500, 1.0, 3);
  sb::AffineMap shift;
  shift.Offset = { 1e-9, 0.0, 0.0 };
  const std::vector<double> moved = Moved(points, shift);
  const sb::AffineFit fit = sb::FitAffineMap(points.data(), moved.data(), 500);
  CHECK(!fit.IsIdentity);
  CHECK(std::abs(fit.Map.Offset[0] - 1e-9) < 1e-14);
}

void PlanesAndThinPlatesAreMapped()
{
  for (const double thickness : { 0.0, 1e-12, 1e-4 })
  {
    const std::vector<double> points = Points(300, thickness, 4);
    const sb::AffineMap map = Map(2.0, 1.0, { 1.0, 1.0, 1.0 });
    const std::vector<double> moved = Moved(points, map);
    const sb::AffineFit fit = sb::FitAffineMap(points.data(), moved.data(), 300);
    CHECK(!fit.IsIdentity);
    CHECK(LargestDifference(fit.Map, map, points) < 1e-11);
    CHECK(fit.LargestError < 1e-11);
  }
}

void FarFromTheOrigin()
{
  const std::vector<double> points = Points(300, 1.0, 6);
  const sb::AffineMap map = Map(1.0, 1.0, { 1e6, -2e6, 5e5 });
  const sb::AffineFit fit = sb::FitAffineMap(points.data(), Moved(points, map).data(), 300);
  CHECK(fit.LargestError < 4e-9); // a few steps of the doubles there
}

void BentIsTold()
{
  const std::vector<double> points = Points(300, 1.0, 7);
  std::vector<double> bent = points;
  for (std::size_t i = 0; i < bent.size(); i += 3)
  {
    bent[i + 2] += 0.1 * bent[i] * bent[i];
  }
  const sb::AffineFit fit = sb::FitAffineMap(points.data(), bent.data(), 300);
  CHECK(fit.LargestError > 0.01);
  CHECK(fit.MeanError > 0.005);
}

void FewPoints()
{
  const std::vector<double> points{ 1.0, 2.0, 3.0, 2.0, 2.0, 3.0 };
  const std::vector<double> moved{ 2.0, 2.0, 3.0, 3.0, 2.0, 3.0 };
  CHECK(sb::FitAffineMap(points.data(), moved.data(), 0).IsIdentity);
  for (const std::int64_t count : { 1, 2 })
  {
    const sb::AffineFit fit = sb::FitAffineMap(points.data(), moved.data(), count);
    CHECK(fit.LargestError < 1e-14);
  }
}

} // namespace

int main()
{
  MapsAreFound();
  WhatIsUnmovedStaysToTheBit();
  SmallMovesAreMovesAll();
  PlanesAndThinPlatesAreMapped();
  FarFromTheOrigin();
  BentIsTold();
  FewPoints();
  return check::Verdict("AffineFit");
}
