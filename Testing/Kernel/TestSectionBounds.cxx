// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSectionBounds.cxx
 * @brief 500 random planes through a torus: no segment is farther from the curve than the bound,
 * measured by projecting places of it; and no loop wider than two spacings is missed, compared with
 * a dense sampling of the torus itself.
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

struct Plane
{
  Real3 Origin;
  Real3 Normal;
  double Height(const Real3& x) const
  {
    return sb::Dot(sb::Difference(x, this->Origin), this->Normal);
  }
};

Plane RandomPlane(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-0.9, 0.9);
  Real3 n{ normal(random), normal(random), normal(random) };
  n = sb::Scaled(n, 1.0 / sb::Length(n));
  return { { uniform(random), uniform(random), 0.4 * uniform(random) }, n };
}

double DistanceToSegment(const Real3& x, const Real3& a, const Real3& b)
{
  const Real3 along = sb::Difference(b, a);
  const Real3 from = sb::Difference(x, a);
  const double t = std::clamp(sb::Dot(from, along) / sb::Dot(along, along), 0.0, 1.0);
  return sb::Length(sb::PlusScaled(from, -t, along));
}

double DistanceToCurves(const Real3& x, const sb::PlaneSection& section)
{
  double least = 1e300;
  for (const sb::SectionCurve& curve : section.Curves)
  {
    for (std::size_t i = 1; i < curve.Points.size(); ++i)
    {
      least = std::min(least, DistanceToSegment(x, curve.Points[i - 1], curve.Points[i]));
    }
  }
  return least;
}

/** Of places on the segments: how far they are from the curve, found by Newton's method in the
 * plane. */
double MeasuredError(
  const sb::MovingLeastSquares& surface, const sb::PlaneSection& section, const Plane& plane)
{
  sb::MovingLeastSquares::Neighbourhood near;
  double largest = 0.0;
  for (const sb::SectionCurve& curve : section.Curves)
  {
    for (std::size_t i = 1; i < curve.Points.size(); ++i)
    {
      const Real3 a = curve.Points[i - 1];
      const Real3 b = curve.Points[i];
      for (const double t : { 0.1, 0.3, 0.5, 0.7, 0.9 })
      {
        Real3 x = sb::PlusScaled(a, t, sb::Difference(b, a));
        for (int iteration = 0; iteration < 4; ++iteration)
        {
          const sb::SurfaceValue f = surface.EvaluateAt(x, 1, near);
          const Real3 inPlane = sb::WithoutPartAlong(f.Gradient, plane.Normal);
          x = sb::PlusScaled(x, -f.Value / sb::Dot(inPlane, inPlane), inPlane);
        }
        largest = std::max(largest, DistanceToSegment(x, a, b));
      }
    }
  }
  return largest;
}

/** Places of the torus in the plane, closer together than half a spacing: the plane's crossings
 * with circles of the tube. */
std::vector<Real3> DenseSection(const Plane& plane)
{
  const int around = 700;
  const int across = 280;
  std::vector<Real3> places;
  const auto place = [](double a, double b) {
    const double reach = 1.0 + 0.4 * std::cos(b);
    return Real3{ reach * std::cos(a), reach * std::sin(a), 0.4 * std::sin(b) };
  };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double a = 2.0 * clouds::Pi * i / around;
      const double b = 2.0 * clouds::Pi * j / across;
      const Real3 p = place(a, b);
      const double height = plane.Height(p);
      for (const Real3& q :
        { place(a + 2.0 * clouds::Pi / around, b), place(a, b + 2.0 * clouds::Pi / across) })
      {
        const double other = plane.Height(q);
        if ((height < 0.0) != (other < 0.0))
        {
          places.push_back(sb::PlusScaled(p, height / (height - other), sb::Difference(q, p)));
        }
      }
    }
  }
  return places;
}

/** What no curve passes by is a piece that is not wider than two spacings: everything missed lies
 * within that of whatever missed place one begins with, or is another piece. */
bool MissesNoLoop(const std::vector<Real3>& dense, const sb::PlaneSection& section, double spacing)
{
  std::vector<Real3> missed;
  for (const Real3& x : dense)
  {
    if (DistanceToCurves(x, section) > 0.5 * spacing)
    {
      missed.push_back(x);
    }
  }
  std::vector<bool> seen(missed.size(), false);
  for (std::size_t first = 0; first < missed.size(); ++first)
  {
    std::vector<std::size_t> piece;
    if (!seen[first])
    {
      piece.push_back(first);
      seen[first] = true;
    }
    for (std::size_t k = 0; k < piece.size(); ++k)
    {
      for (std::size_t j = 0; j < missed.size(); ++j)
      {
        if (!seen[j] && sb::Length(sb::Difference(missed[j], missed[piece[k]])) < 0.5 * spacing)
        {
          seen[j] = true;
          piece.push_back(j);
        }
      }
    }
    for (const std::size_t i : piece)
    {
      for (const std::size_t j : piece)
      {
        if (sb::Length(sb::Difference(missed[i], missed[j])) > 2.0 * spacing)
        {
          return false;
        }
      }
    }
  }
  return true;
}

void FiveHundredPlanesThroughATorus()
{
  std::mt19937 random(500);
  clouds::Cloud cloud = clouds::Torus(12000, random);
  const double spacing = clouds::SurfaceOf(cloud).Spacing;
  clouds::AddNoise(cloud, 0.1 * spacing, random);
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  sb::ThreadExecutor executor(2);
  sb::Monitor monitor;
  const double bound = 0.05 * spacing;
  int crossing = 0;
  for (int k = 0; k < 500; ++k)
  {
    const Plane plane = RandomPlane(random);
    const sb::PlaneSection section =
      sb::IntersectPlane(*made.Surface, plane.Origin, plane.Normal, bound, executor, monitor);
    crossing += section.Curves.empty() ? 0 : 1;
    for (const sb::SectionCurve& curve : section.Curves)
    {
      CHECK(curve.Closed);
      CHECK(curve.LargestChordError <= bound);
      for (const Real3& x : curve.Points)
      {
        CHECK(std::abs(clouds::DistanceToTorus(x)) < 0.2 * spacing);
        CHECK(std::abs(plane.Height(x)) < 1e-12);
      }
    }
    CHECK(MeasuredError(*made.Surface, section, plane) <= bound);
    CHECK(k % 10 != 0 || MissesNoLoop(DenseSection(plane), section, spacing));
  }
  CHECK(crossing > 450);
}

} // namespace

int main()
{
  FiveHundredPlanesThroughATorus();
  return check::Verdict("TestSectionBounds");
}
