// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCommonPoint.cxx
 * @brief Points on a cloud and a patch or a plane, to rounding, from near starts, at the border and
 * at poles; none where there is none; closest points of patches; the curvature of common curves.
 */
#include "Check.h"
#include "ClosestOnPatch.h"
#include "Clouds.h"
#include "CommonPoint.h"
#include "Patches.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using sb::CommonPoint;
using sb::MovingLeastSquares;
using sb::NURBSSurface;
using sb::PatchPoint;
using sb::Real3;

double Gap(const Real3& a, const Real3& b) { return sb::Length(sb::Difference(a, b)); }

Real3 RandomDirection(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const Real3 n{ normal(random), normal(random), normal(random) };
  return sb::Scaled(n, 1.0 / sb::Length(n));
}

NURBSSurface Moved(NURBSSurface surface, const Real3& by)
{
  for (std::size_t i = 0; i < surface.Poles.size(); ++i)
  {
    surface.Poles[i] += i % 4 < 3 ? by[i % 4] : 0.0;
  }
  return surface;
}

/** Whether it is on both, as claimed; it never claims what is not so. */
bool IsOnBoth(const sb::CloudSurface& made, const NURBSSurface& patch, const CommonPoint& found)
{
  MovingLeastSquares::Neighbourhood near;
  return std::abs(made.Surface->EvaluateAt(found.Point, 0, near).Value) < 1e-14 &&
    Gap(sb::EvaluatePatch(patch, found.U, found.V, 0).Point, found.Point) == 0.0;
}

void OntoPatches()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  const double width = made.Surface->Width();
  const NURBSSurface shapes[] = { Moved(patches::Sphere(0.8), { 0.7, 0.1, 0.2 }),
    Moved(patches::Cylinder(0.4, 2.0), { 0.3, 0.2, 0.0 }),
    Moved(patches::Torus(0.7, 0.4), { 0.4, 0.0, 0.1 }), patches::FreeForm(3, 3, 8, 8, 0.6, random),
    patches::Parallelogram({ -2, -2, 0.3 }, { 4, 0, 0.2 }, { 0.1, 4, -0.3 }) };
  for (const NURBSSurface& patch : shapes)
  {
    int starts = 0;
    int found = 0;
    MovingLeastSquares::Neighbourhood near;
    while (starts < 2000)
    {
      const double u = uniform(random);
      const double v = uniform(random);
      const PatchPoint at = sb::EvaluatePatch(patch, u, v, 1);
      const Real3 n = sb::Cross(at.Du, at.Dv);
      const double radius = sb::Length(at.Point);
      const double sine = sb::Length(sb::Cross(n, at.Point)) / (sb::Length(n) * radius);
      // Near, and the surfaces do not nearly touch.
      if (std::abs(radius - 1.0) > 0.5 * width || sine < 0.5)
      {
        continue;
      }
      ++starts;
      const CommonPoint common = sb::OntoCloudAndPatch(*made.Surface, patch, u, v, near);
      found += common.Found ? 1 : 0;
      CHECK(!common.Found || IsOnBoth(made, patch, common));
      CHECK(!common.Found || std::abs(sb::Length(common.Point) - 1.0) < 1e-5);
      CHECK(!common.Found || common.Surface.Where == sb::Support::Defined);
      // About the shortest way.
      CHECK(
        !common.Found || Gap(common.Point, at.Point) < 2.0 * std::abs(radius - 1.0) / sine + 1e-5);
    }
    CHECK(found > 1990);
  }
  // The same start gives the same bits, whatever was searched before.
  MovingLeastSquares::Neighbourhood fresh;
  MovingLeastSquares::Neighbourhood used;
  made.Surface->EvaluateAt({ 0.0, 1.0, 0.0 }, 0, used);
  const CommonPoint one = sb::OntoCloudAndPatch(*made.Surface, shapes[4], 0.72, 0.5, fresh);
  const CommonPoint other = sb::OntoCloudAndPatch(*made.Surface, shapes[4], 0.72, 0.5, used);
  CHECK(one.Found && one.Point == other.Point);
}

/** The surface passes near the pole of a spherical patch, in any direction. */
void PolesOfPatches()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform;
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  const double width = made.Surface->Width();
  MovingLeastSquares::Neighbourhood near;
  for (int k = 0; k < 500; ++k)
  {
    const double turn = 2.0 * clouds::Pi * uniform(random);
    // The patch's north pole is at most a third of a width in front of the cloud or behind.
    const double reach = 1.0 + (2.0 * uniform(random) - 1.0) * width / 3.0;
    const Real3 pole{ reach * std::cos(turn), reach * std::sin(turn), 0.0 };
    const NURBSSurface patch = Moved(patches::Sphere(0.5), { pole[0], pole[1], -0.5 });
    for (const double v : { 1.0, 1.0 - 1e-9, 0.99, 0.97 })
    {
      const CommonPoint common =
        sb::OntoCloudAndPatch(*made.Surface, patch, uniform(random), v, near);
      CHECK(common.Found);
      CHECK(IsOnBoth(made, patch, common));
      CHECK(Gap(common.Point, pole) < 0.1);
    }
  }
}

void BordersAndNothing()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  const double width = made.Surface->Width();
  MovingLeastSquares::Neighbourhood near;
  // A plane patch that ends just outside of the sphere: only its corner region reaches it.
  const NURBSSurface patch = patches::Parallelogram({ 0.99, -1, 0 }, { 1, 0, 0 }, { 0, 2, 0 });
  const CommonPoint atBorder = sb::OntoCloudAndPatch(*made.Surface, patch, 0.05, 0.53, near);
  CHECK(atBorder.Found && IsOnBoth(made, patch, atBorder));
  CHECK(atBorder.U >= 0.0 && atBorder.Point[0] >= 0.99);
  // Just out of reach, and far away, and a plane that stays half a width off.
  const NURBSSurface beyond = patches::Parallelogram({ 1.01, -1, 0 }, { 1, 0, 0 }, { 0, 2, 0 });
  CHECK(!sb::OntoCloudAndPatch(*made.Surface, beyond, 0.01, 0.5, near).Found);
  CHECK(!sb::OntoCloudAndPatch(*made.Surface, beyond, 0.9, 0.5, near).Found);
  const Real3 off{ -1, -1, 1.0 + 0.5 * width };
  const NURBSSurface above = patches::Parallelogram(off, { 2, 0, 0 }, { 0, 2, 0 });
  CHECK(!sb::OntoCloudAndPatch(*made.Surface, above, 0.5, 0.5, near).Found);
  CHECK(!sb::OntoCloudAndPatch(*made.Surface, above, 0.52, 0.49, near).Found);
}

void OntoPlanes()
{
  std::mt19937 random(3);
  clouds::Cloud cloud = clouds::Torus(20000, random);
  clouds::AddNoise(cloud, 0.005, random);
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  MovingLeastSquares::Neighbourhood near;
  std::uniform_int_distribution<std::int64_t> any(0, cloud.Count() - 1);
  int crossing = 0;
  int found = 0;
  for (int k = 0; k < 2000; ++k)
  {
    const std::size_t i = 3 * static_cast<std::size_t>(any(random));
    const Real3 sample{ cloud.Points[i], cloud.Points[i + 1], cloud.Points[i + 2] };
    const Real3 v{ cloud.Normals[i], cloud.Normals[i + 1], cloud.Normals[i + 2] };
    const Real3 n = RandomDirection(random);
    const Real3 start = sb::PlusScaled(sample, 0.02, RandomDirection(random));
    const CommonPoint common = sb::OntoCloudAndPlane(*made.Surface, sample, n, start, near);
    const bool crosses = std::abs(sb::Dot(n, v)) < 0.9;
    crossing += crosses ? 1 : 0;
    found += crosses && common.Found ? 1 : 0;
    CHECK(!common.Found || std::abs(sb::Dot(sb::Difference(common.Point, sample), n)) < 1e-15);
    CHECK(!common.Found || std::abs(made.Surface->EvaluateAt(common.Point, 0, near).Value) < 1e-14);
  }
  CHECK(crossing > 1500);
  CHECK(found > 0.99 * crossing);
}

void ClosestPoints()
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  const NURBSSurface sphere = patches::Sphere(1.0);
  const NURBSSurface torus = patches::Torus(1.0, 0.4);
  const NURBSSurface free = patches::FreeForm(5, 3, 9, 8, 0.5, random);
  for (int k = 0; k < 3000; ++k)
  {
    const Real3 x{ uniform(random), uniform(random), uniform(random) };
    const sb::PlaceOnPatch onSphere = sb::ClosestOnPatch(sphere, x);
    CHECK(std::abs(onSphere.Distance - std::abs(sb::Length(x) - 1.0)) < 1e-14);
    CHECK(Gap(onSphere.Point, sb::Scaled(x, 1.0 / sb::Length(x))) < 1e-7);
    CHECK(sb::EvaluatePatch(sphere, onSphere.U, onSphere.V, 0).Point == onSphere.Point);
    const sb::PlaceOnPatch onTorus = sb::ClosestOnPatch(torus, x);
    CHECK(std::abs(onTorus.Distance - std::abs(clouds::DistanceToTorus(x))) < 1e-14);
  }
  // A point of the patch finds its own parameters again, from beside them.
  std::uniform_real_distribution<double> inside(0.05, 0.95);
  for (int k = 0; k < 3000; ++k)
  {
    const double u = inside(random);
    const double v = inside(random);
    const Real3 x = sb::EvaluatePatch(free, u, v, 0).Point;
    const sb::PlaceOnPatch place = sb::ClosestOnPatchFrom(free, x, u + 0.02, v - 0.03);
    CHECK(place.Distance < 1e-15);
    CHECK(std::abs(place.U - u) < 1e-14 && std::abs(place.V - v) < 1e-14);
  }
}

/** Against the circle through three points of the curve. */
void CurvatureOfCurves()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform;
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Torus(20000, random));
  const NURBSSurface shapes[] = { Moved(patches::Sphere(0.8), { 0.7, 0.1, 0.2 }),
    patches::FreeForm(4, 3, 6, 7, 0.6, random),
    Moved(patches::Cylinder(0.7, 2.0), { 0.5, 0.2, 0.0 }) };
  MovingLeastSquares::Neighbourhood near;
  for (const NURBSSurface& patch : shapes)
  {
    for (int tested = 0; tested < 50;)
    {
      const CommonPoint common =
        sb::OntoCloudAndPatch(*made.Surface, patch, uniform(random), uniform(random), near);
      if (!common.Found || common.Surface.Where != sb::Support::Defined)
      {
        continue;
      }
      const PatchPoint at = sb::EvaluatePatch(patch, common.U, common.V, 2);
      const Real3 normal = sb::Cross(at.Du, at.Dv);
      const sb::SurfaceValue f = made.Surface->EvaluateAt(common.Point, 2, near);
      Real3 t = sb::Cross(f.Gradient, normal);
      if (sb::Length(t) < 0.4 * sb::Length(f.Gradient) * sb::Length(normal))
      {
        continue;
      }
      t = sb::Scaled(t, 1.0 / sb::Length(t));
      const double step = 2e-4;
      const double du = sb::Dot(sb::Cross(t, at.Dv), normal) / sb::Dot(normal, normal);
      const double dv = sb::Dot(sb::Cross(at.Du, t), normal) / sb::Dot(normal, normal);
      const CommonPoint ahead = sb::OntoCloudAndPatch(
        *made.Surface, patch, common.U + step * du, common.V + step * dv, near);
      const CommonPoint behind = sb::OntoCloudAndPatch(
        *made.Surface, patch, common.U - step * du, common.V - step * dv, near);
      const Real3 a = sb::Difference(ahead.Point, common.Point);
      const Real3 b = sb::Difference(behind.Point, common.Point);
      if (sb::Length(a) < 0.9 * step || sb::Length(b) < 0.9 * step) // the border of the domain
      {
        continue;
      }
      ++tested;
      const double ra = sb::Length(a);
      const double rb = sb::Length(b);
      Real3 circle = sb::PlusScaled(sb::Scaled(a, 1.0 / ra), 1.0 / rb, b);
      circle = sb::WithoutPartAlong(sb::Scaled(circle, 2.0 / (ra + rb)), t);
      const Real3 curvature = sb::CurvatureOfCommonCurve(f, at);
      CHECK(std::abs(sb::Dot(curvature, t)) < 1e-10 * (1.0 + sb::Length(curvature)));
      CHECK(Gap(curvature, circle) < 1e-2 * (1.0 + sb::Length(curvature)));
    }
  }
  // A sphere and a plane: a circle, whose centre the vector points to.
  const sb::CloudSurface sphere = clouds::SurfaceOf(clouds::Sphere(20000));
  const NURBSSurface plane = patches::Parallelogram({ -2, -2, 0.6 }, { 4, 0, 0 }, { 0, 4, 0 });
  const CommonPoint on = sb::OntoCloudAndPatch(*sphere.Surface, plane, 0.7, 0.5, near);
  const Real3 curvature = sb::CurvatureOfCommonCurve(
    sphere.Surface->EvaluateAt(on.Point, 2, near), sb::EvaluatePatch(plane, on.U, on.V, 2));
  CHECK(Gap(curvature, { -1.25, 0, 0 }) < 2e-3);
}

} // namespace

int main()
{
  OntoPatches();
  PolesOfPatches();
  BordersAndNothing();
  OntoPlanes();
  ClosestPoints();
  CurvatureOfCurves();
  return check::Verdict("TestCommonPoint");
}
