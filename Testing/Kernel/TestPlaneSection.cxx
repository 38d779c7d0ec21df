// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPlaneSection.cxx
 * @brief Sections of a torus and a sphere with random planes: as many loops as there are, the chord
 * error under its bound, points on both; open sections end at the border; nothing where nothing is.
 */
#include "Check.h"
#include "Clouds.h"
#include "PlaneSection.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using sb::Real3;

sb::PlaneSection SectionOf(const sb::CloudSurface& made, const Real3& origin, const Real3& normal,
  double chordError, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  return sb::IntersectPlane(*made.Surface, origin, sb::Scaled(normal, 1.0 / sb::Length(normal)),
    chordError, executor, monitor);
}

double LengthOf(const sb::SectionCurve& curve)
{
  double length = 0.0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    length += sb::Length(sb::Difference(curve.Points[i], curve.Points[i - 1]));
  }
  return length;
}

/** The largest distance of the curve to its segments, measured at sixteen places a segment. */
double ChordError(const sb::CloudSurface& made, const sb::SectionCurve& curve, const Real3& normal)
{
  sb::MovingLeastSquares::Neighbourhood near;
  double largest = 0.0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    const Real3 a = curve.Points[i - 1];
    const Real3 along = sb::Difference(curve.Points[i], a);
    for (int k = 1; k < 16; ++k)
    {
      Real3 x = sb::PlusScaled(a, k / 16.0, along);
      for (int iteration = 0; iteration < 5; ++iteration)
      {
        const sb::SurfaceValue f = made.Surface->EvaluateAt(x, 1, near);
        const Real3 inPlane = sb::WithoutPartAlong(f.Gradient, normal);
        x = sb::PlusScaled(x, -f.Value / sb::Dot(inPlane, inPlane), inPlane);
      }
      const Real3 from = sb::Difference(x, a);
      const double t = std::clamp(sb::Dot(from, along) / sb::Dot(along, along), 0.0, 1.0);
      largest = std::max(largest, sb::Length(sb::PlusScaled(from, -t, along)));
    }
  }
  return largest;
}

void CirclesOfASphere()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> height(0.0, 1.05);
  for (int k = 0; k < 500; ++k)
  {
    Real3 n{ normal(random), normal(random), normal(random) };
    n = sb::Scaled(n, 1.0 / sb::Length(n));
    const double h = height(random);
    const double radius = h < 1.0 ? std::sqrt(1.0 - h * h) : 0.0;
    const sb::PlaneSection section = SectionOf(made, sb::Scaled(n, h), n, 1e-3);
    const bool isLoop = radius > made.Spacing; // wider than two spacings
    CHECK(section.Curves.size() == (radius > 0.0 ? 1u : 0u) || !isLoop);
    for (const sb::SectionCurve& curve : section.Curves)
    {
      CHECK(curve.Closed);
      CHECK(curve.Points.front() == curve.Points.back());
      for (const Real3& x : curve.Points)
      {
        CHECK(std::abs(sb::Dot(x, n) - h) < 1e-12);
        CHECK(std::abs(sb::Length(x) - 1.0) < 1e-5);
      }
      CHECK(curve.LargestChordError <= 1e-3);
      CHECK(k % 10 != 0 || ChordError(made, curve, n) <= 1e-3);
      if (isLoop)
      {
        // Of chords that are off by at most e the length is shorter by at most 4 e / radius.
        const double circle = 2.0 * clouds::Pi * radius;
        CHECK(LengthOf(curve) < circle && LengthOf(curve) > circle * (1.0 - 2e-3 / radius));
      }
    }
  }
}

void SectionsOfATorus()
{
  std::mt19937 random(2);
  clouds::Cloud cloud = clouds::Torus(20000, random);
  clouds::AddNoise(cloud, 0.005, random);
  const sb::CloudSurface made =
    clouds::SurfaceOf(cloud, true, sb::SurfaceDefinition::Unbiased, 0.15);
  std::size_t last = 0;
  for (const double bound : { 3e-3, 3e-4, 3e-5 })
  {
    const sb::PlaneSection flat = SectionOf(made, { 0, 0, 0.01 }, { 0, 0, 1 }, bound);
    CHECK_EQUAL(flat.Curves.size(), 2u); // the outer and the inner equator
    const sb::PlaneSection upright = SectionOf(made, { 0, 0.01, 0 }, { 0, 1, 0 }, bound);
    CHECK_EQUAL(upright.Curves.size(), 2u); // two circles of the tube
    std::size_t points = 0;
    for (const sb::SectionCurve& curve : flat.Curves)
    {
      CHECK(curve.Closed);
      CHECK(ChordError(made, curve, { 0, 0, 1 }) <= bound);
      points += curve.Points.size();
    }
    CHECK(points > 2 * last); // ten times the accuracy takes some three times the points
    CHECK(last == 0 || points < 5 * last);
    last = points;
  }
  const sb::PlaneSection tilted = SectionOf(made, { 0, 0, 0 }, { 0.2, 0, 1 }, 1e-3);
  CHECK_EQUAL(tilted.Curves.size(), 2u);
  CHECK(SectionOf(made, { 0, 0, 0.6 }, { 0, 0, 1 }, 1e-3).Curves.empty());
}

/** A plane that nearly touches a torus at its inner equator: two loops that almost meet, or one
 * with a waist. */
void BranchesNearASaddle()
{
  std::mt19937 random(3);
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Torus(20000, random));
  for (const double away : { 3e-2, 1e-2, 3e-3, 1e-3, 3e-4 })
  {
    for (const double turn : { 0.0, 0.3, 1.1, 2.0, 4.0 })
    {
      const Real3 n{ std::cos(turn), std::sin(turn), 0.0 };
      for (const double side : { -1.0, 1.0 })
      {
        const sb::PlaneSection section = SectionOf(made, sb::Scaled(n, 0.6 + side * away), n, 1e-3);
        CHECK_EQUAL(section.Curves.size(), side < 0.0 ? 2u : 1u);
        for (const sb::SectionCurve& curve : section.Curves)
        {
          CHECK(curve.Closed);
          CHECK(curve.LargestChordError <= 1e-3);
          CHECK(ChordError(made, curve, n) <= 1e-3);
        }
      }
    }
  }
}

void OpenSectionsEndAtTheBorder()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Plane(60));
  const sb::PlaneSection section = SectionOf(made, { 0.5, 0.4, 0.0 }, { 0.1, 1.0, 0.3 }, 1e-4);
  CHECK_EQUAL(section.Curves.size(), 1u);
  for (const sb::SectionCurve& curve : section.Curves)
  {
    CHECK(!curve.Closed);
    CHECK(std::abs(std::abs(curve.Points.front()[0] - curve.Points.back()[0]) - 1.0) <
      3.0 * made.Spacing);
    for (const Real3& x : curve.Points)
    {
      CHECK(std::abs(x[2]) < 1e-12);
    }
  }
  // The plane of the cloud itself does not cut it.
  CHECK(SectionOf(made, { 0, 0, 0 }, { 0, 0, 1 }, 1e-4).Curves.empty());
}

void ThreadsDoNotMatter()
{
  std::mt19937 random(3);
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Torus(5000, random));
  const sb::PlaneSection one = SectionOf(made, { 0, 0, 0 }, { 0.3, 0.2, 1 }, 1e-3, 1);
  const sb::PlaneSection other = SectionOf(made, { 0, 0, 0 }, { 0.3, 0.2, 1 }, 1e-3, 3);
  CHECK_EQUAL(one.Curves.size(), other.Curves.size());
  for (std::size_t i = 0; i < std::min(one.Curves.size(), other.Curves.size()); ++i)
  {
    CHECK(one.Curves[i].Points == other.Curves[i].Points);
  }
}

} // namespace

int main()
{
  CirclesOfASphere();
  SectionsOfATorus();
  BranchesNearASaddle();
  OpenSectionsEndAtTheBorder();
  ThreadsDoNotMatter();
  return check::Verdict("TestPlaneSection");
}
