// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMovingLeastSquares.cxx
 * @brief Gradient and Hessian against finite differences; the unbiased surface of a sphere is the
 * sphere, the paper's lies inside by what theory says; curvatures converge; projections lie on the
 * surface; far and unsupported places are told apart; all roots on lines.
 */
#include "Check.h"
#include "Clouds.h"
#include "LineIntersection.h"
#include "MovingLeastSquares.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using sb::MovingLeastSquares;
using sb::Real3;
using sb::Support;
using sb::SurfaceDefinition;
using sb::SurfaceValue;
using Neighbourhood = MovingLeastSquares::Neighbourhood;

constexpr SurfaceDefinition Definitions[] = { SurfaceDefinition::Unbiased,
  SurfaceDefinition::AmentaKil };

/** A bumpy patch small enough for no sample to leave the weights' reach while x is moved. */
clouds::Cloud NoisyPatch(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  clouds::Cloud cloud;
  for (int i = 0; i < 400; ++i)
  {
    const double x = 0.6 * normal(random);
    const double y = 0.6 * normal(random);
    Real3 v{ -x + 0.1 * normal(random), -0.5 * y + 0.1 * normal(random), 1.0 };
    v = sb::Scaled(v, 1.0 / sb::Length(v));
    cloud.Add({ x, y, 0.5 * x * x + 0.25 * y * y + 0.05 * normal(random) }, v);
  }
  return cloud;
}

void DerivativesAreThoseOfFiniteDifferences()
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const clouds::Cloud cloud = NoisyPatch(random);
  for (const SurfaceDefinition definition : Definitions)
  {
    const sb::CloudSurface made = clouds::SurfaceOf(cloud, true, definition, 1.0);
    double ofGradient = 0.0, ofHessian = 0.0, asymmetry = 0.0;
    Neighbourhood near;
    for (int k = 0; k < 60; ++k)
    {
      const Real3 x{ 0.3 * normal(random), 0.3 * normal(random), 0.2 * normal(random) };
      made.Surface->Gather(x, 0.1, near);
      const SurfaceValue f = made.Surface->Evaluate(x, 2, near);
      CHECK(f.IsNear);
      const double e = 1e-4;
      for (std::size_t a = 0; a < 3; ++a)
      {
        Real3 before = x, after = x;
        before[a] -= e;
        after[a] += e;
        const SurfaceValue lower = made.Surface->Evaluate(before, 1, near);
        const SurfaceValue upper = made.Surface->Evaluate(after, 1, near);
        ofGradient =
          std::max(ofGradient, std::abs((upper.Value - lower.Value) / (2.0 * e) - f.Gradient[a]));
        for (std::size_t b = 0; b < 3; ++b)
        {
          const double slope = (upper.Gradient[b] - lower.Gradient[b]) / (2.0 * e);
          ofHessian = std::max(ofHessian, std::abs(slope - f.Hessian[a][b]));
          asymmetry = std::max(asymmetry, std::abs(f.Hessian[a][b] - f.Hessian[b][a]));
        }
      }
    }
    CHECK(ofGradient < 1e-6);
    CHECK(ofHessian < 1e-6);
    CHECK(asymmetry < 1e-12);
  }
}

/** The distance from the centre at which a surface of the sphere's samples is met. */
double RadiusAlong(const MovingLeastSquares& surface, const Real3& direction)
{
  Neighbourhood near;
  const std::vector<double> roots =
    sb::IntersectSegment(surface, sb::Scaled(direction, 0.5), sb::Scaled(direction, 1.5), near);
  CHECK_EQUAL(roots.size(), 1u);
  return roots.empty() ? 0.0 : 0.5 + roots.front();
}

void TheSphereHasNoBiasAndThePapersIsKnown()
{
  const clouds::Cloud cloud = clouds::Sphere(30000);
  const Real3 direction = sb::Scaled({ 0.3, -0.5, 0.8 }, 1.0 / std::sqrt(0.98));
  for (const double h : { 0.08, 0.16, 0.32 })
  {
    const sb::CloudSurface unbiased =
      clouds::SurfaceOf(cloud, true, SurfaceDefinition::Unbiased, h);
    CHECK(std::abs(RadiusAlong(*unbiased.Surface, direction) - 1.0) < 1e-11);
    const sb::CloudSurface paper = clouds::SurfaceOf(cloud, true, SurfaceDefinition::AmentaKil, h);
    const double bias = RadiusAlong(*paper.Surface, direction) - 1.0;
    CHECK(std::abs(bias / (-0.5 * h * h) - 1.0) < 0.03);
  }
}

/** Largest error of the curvature over a torus: of the principal ones and of a planar section. */
void CurvaturesConverge()
{
  double last = 0.0;
  for (const double h : { 0.24, 0.12 })
  {
    const clouds::Cloud cloud = clouds::TorusGrid(420, 120);
    const sb::CloudSurface made = clouds::SurfaceOf(cloud, true, SurfaceDefinition::Unbiased, h);
    Neighbourhood near;
    double worst = 0.0;
    for (const double b : { 0.0, 1.0, 2.0, 3.1 })
    {
      const double reach = 1.0 + 0.4 * std::cos(b);
      Real3 x{ reach, 0.0, 0.4 * std::sin(b) };
      CHECK(made.Surface->Project(x, near).Where == Support::Defined);
      const SurfaceValue f = made.Surface->EvaluateAt(x, 2, near);
      const sb::SurfaceCurvature found = sb::CurvatureOf(f);
      worst = std::max(worst, std::abs(found.Maximum - 2.5));
      worst = std::max(worst, std::abs(found.Minimum - std::cos(b) / reach));
      // The plane y = 0 cuts the tube in a circle of radius 0.4, which bends away from the
      // gradient.
      worst = std::max(worst, std::abs(sb::SectionCurvature(f, { 0.0, 1.0, 0.0 }) + 2.5));
    }
    if (last > 0.0)
    {
      CHECK(std::log2(last / worst) > 1.7); // second order
      CHECK(worst < 0.2);
    }
    last = worst;
  }
}

/** Eq. 8 is the curvature of the circle through three points of the section. */
void SectionCurvatureIsThatOfTracedPoints()
{
  std::mt19937 random(5);
  const clouds::Cloud cloud = clouds::Torus(8000, random);
  for (const SurfaceDefinition definition : Definitions)
  {
    const sb::CloudSurface made = clouds::SurfaceOf(cloud, true, definition, 0.14);
    Neighbourhood near;
    const auto ontoSection = [&](Real3 x, const Real3& m) {
      for (int iteration = 0; iteration < 30; ++iteration)
      {
        const SurfaceValue f = made.Surface->EvaluateAt(x, 1, near);
        const Real3 inPlane = sb::WithoutPartAlong(f.Gradient, m);
        x = sb::PlusScaled(x, -f.Value / sb::Dot(inPlane, inPlane), inPlane);
      }
      return x;
    };
    const Real3 m = sb::Scaled({ 0.35, 0.1, 1.0 }, 1.0 / std::sqrt(1.1325));
    for (const double a : { 0.3, 1.7, 4.0 })
    {
      const Real3 x = ontoSection({ 1.38 * std::cos(a), 1.38 * std::sin(a), 0.0 }, m);
      const SurfaceValue f = made.Surface->EvaluateAt(x, 2, near);
      const Real3 tangent = sb::Cross(m, f.Gradient);
      const double step = 2e-3 / sb::Length(tangent);
      const Real3 p = ontoSection(sb::PlusScaled(x, -step, tangent), m);
      const Real3 q = ontoSection(sb::PlusScaled(x, step, tangent), m);
      const Real3 u = sb::Difference(p, x);
      const Real3 v = sb::Difference(q, x);
      const double circle = 2.0 * sb::Length(sb::Cross(u, v)) /
        (sb::Length(u) * sb::Length(v) * sb::Length(sb::Difference(q, p)));
      const double side = sb::Dot(f.Gradient, sb::PlusScaled(u, 1.0, v)) < 0.0 ? -1.0 : 1.0;
      CHECK(std::abs(sb::SectionCurvature(f, m) - side * circle) < 2e-3 * (1.0 + circle));
    }
  }
}

void ProjectedPointsLieOnTheSurface()
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  clouds::Cloud cloud = clouds::Torus(20000, random);
  const double spacing = clouds::SurfaceOf(cloud).Spacing;
  clouds::AddNoise(cloud, 0.2 * spacing, random);
  for (const SurfaceDefinition definition : Definitions)
  {
    const sb::CloudSurface made = clouds::SurfaceOf(cloud, true, definition);
    const double h = made.Surface->Width();
    Neighbourhood near;
    double residual = 0.0, squares = 0.0;
    const int count = 400;
    for (int k = 0; k < count; ++k)
    {
      const Real3 sample = made.Surface->Samples().Point(k * 50);
      Real3 x = sb::PlusScaled(sample, uniform(random) * h, made.Surface->SampleNormal(k * 50));
      const Real3 start = x;
      CHECK(made.Surface->Project(x, near).Where == Support::Defined);
      CHECK(sb::Length(sb::Difference(x, start)) <= h);
      residual = std::max(residual, std::abs(made.Surface->EvaluateAt(x, 0, near).Value));
      squares += clouds::DistanceToTorus(x) * clouds::DistanceToTorus(x);
      Real3 again = x;
      made.Surface->Project(again, near);
      CHECK(sb::Length(sb::Difference(x, again)) < 1e-8 * h); // a point of the surface stays
    }
    CHECK(residual < 1e-9 * h);
    CHECK(std::sqrt(squares / count) <
      (definition == SurfaceDefinition::Unbiased ? 0.06 : 0.3) * spacing);
  }
}

/** The mean over noise is that much smaller: sigma s / (h sqrt(2 pi)) for a Gaussian weight. */
void NoiseIsAveragedAsPredicted()
{
  std::mt19937 random(7);
  clouds::Cloud cloud = clouds::Plane(101);
  const double s = 0.01;
  std::normal_distribution<double> height(0.0, 0.5 * s);
  for (std::size_t i = 2; i < cloud.Points.size(); i += 3)
  {
    cloud.Points[i] = height(random);
  }
  const sb::CloudSurface made =
    clouds::SurfaceOf(cloud, true, SurfaceDefinition::AmentaKil, 3.0 * s);
  std::uniform_real_distribution<double> inside(0.2, 0.8);
  Neighbourhood near;
  double squares = 0.0;
  const int count = 600;
  for (int k = 0; k < count; ++k)
  {
    Real3 x{ inside(random), inside(random), 0.0 };
    made.Surface->Project(x, near);
    squares += x[2] * x[2];
  }
  const double predicted = 0.5 * s / (3.0 * std::sqrt(2.0 * clouds::Pi));
  CHECK(std::abs(std::sqrt(squares / count) / predicted - 1.0) < 0.15);
}

void PlacesWithoutSupportAreToldApart()
{
  const clouds::Cloud cloud = clouds::Plane(60);
  const double s = 1.0 / 59.0;
  for (const SurfaceDefinition definition : Definitions)
  {
    const sb::CloudSurface made = clouds::SurfaceOf(cloud, true, definition, 3.0 * s);
    Neighbourhood near;
    const auto support = [&](const Real3& x) { return made.Surface->EvaluateAt(x, 0, near).Where; };
    CHECK(support({ 0.5, 0.5, 0.0 }) == Support::Defined);
    CHECK(support({ 0.5, 0.5, 1.0 * s }) == Support::Defined);
    CHECK(support({ 0.5, 0.5, 12.0 * s }) == Support::Far);
    CHECK(support({ 1.0 + 2.0 * s, 0.5, 0.0 }) == Support::Border);
    CHECK(support({ 1.0 - 3.0 * s, 0.5, 0.0 }) == Support::Defined);
    CHECK(support({ 1e300, 0.0, 0.0 }) == Support::Far);
    Real3 far{ 0.5, 0.5, 0.5 };
    CHECK(made.Surface->Project(far, near).Where == Support::Far);
    CHECK(far == Real3({ 0.5, 0.5, 0.5 }));
    // The sign is right however far, and the size is the distance.
    Real3 gradient{};
    CHECK(std::abs(made.Surface->DistanceToSamples({ 0.5, 0.5, -7.0 }, &gradient) + 7.0) < 1e-4);
    CHECK(std::abs(gradient[2] - 1.0) < 1e-4);
  }
  // Two sheets that face apart, closer than the width: between them the normals cancel.
  clouds::Cloud sheets = clouds::Plane(60);
  for (std::size_t i = 0; i < 3u * 3600u; i += 3)
  {
    sheets.Add({ sheets.Points[i], sheets.Points[i + 1], -s }, { 0.0, 0.0, -1.0 });
  }
  const sb::CloudSurface thin =
    clouds::SurfaceOf(sheets, true, SurfaceDefinition::Unbiased, 3.0 * s);
  Neighbourhood near;
  CHECK(thin.Surface->EvaluateAt({ 0.5, 0.5, -0.5 * s }, 0, near).Where == Support::Contradicting);
}

void AllRootsOfALineAreFound()
{
  std::mt19937 random(8);
  const clouds::Cloud cloud = clouds::Torus(20000, random);
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  Neighbourhood near;
  const auto rootsOf = [&](const Real3& a, const Real3& b) {
    return sb::IntersectSegment(*made.Surface, a, b, near);
  };
  const std::vector<double> four = rootsOf({ -2.0, 0.01, 0.02 }, { 2.0, 0.01, 0.02 });
  CHECK_EQUAL(four.size(), 4u);
  const double wanted[] = { 0.15, 0.35, 0.65, 0.85 };
  for (std::size_t k = 0; k < four.size(); ++k)
  {
    CHECK(std::abs(four[k] - wanted[k]) < 1e-3);
    const Real3 x{ -2.0 + 4.0 * four[k], 0.01, 0.02 };
    CHECK(std::abs(made.Surface->EvaluateAt(x, 0, near).Value) < 1e-13);
  }
  // Just inside and just outside of the rim: two roots close together, and none.
  const double h = made.Surface->Width();
  CHECK_EQUAL(rootsOf({ -2.0, 1.4 - 0.02 * h, 0.0 }, { 2.0, 1.4 - 0.02 * h, 0.0 }).size(), 2u);
  CHECK_EQUAL(rootsOf({ -2.0, 1.4 + 0.05 * h, 0.0 }, { 2.0, 1.4 + 0.05 * h, 0.0 }).size(), 0u);
  CHECK_EQUAL(rootsOf({ -2.0, 0.0, 3.0 }, { 2.0, 0.0, 3.0 }).size(), 0u);
  CHECK_EQUAL(rootsOf({ 1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }).size(), 0u);
  // Of random chords of a sphere the roots are those of the circle equation.
  const sb::CloudSurface ball = clouds::SurfaceOf(clouds::Sphere(20000));
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int k = 0; k < 200; ++k)
  {
    const Real3 a{ uniform(random), uniform(random), uniform(random) };
    const Real3 b{ uniform(random), uniform(random), uniform(random) };
    const Real3 along = sb::Difference(b, a);
    const double half = sb::Dot(a, along) / sb::Dot(along, along);
    const double rest = half * half - (sb::Dot(a, a) - 1.0) / sb::Dot(along, along);
    std::vector<double> exact;
    for (const double sign : { -1.0, 1.0 })
    {
      const double t = rest > 0.0 ? -half + sign * std::sqrt(rest) : -1.0;
      if (t >= 0.0 && t <= 1.0)
      {
        exact.push_back(t);
      }
    }
    const std::vector<double> found = sb::IntersectSegment(*ball.Surface, a, b, near);
    CHECK_EQUAL(found.size(), exact.size());
    for (std::size_t i = 0; i < std::min(found.size(), exact.size()); ++i)
    {
      CHECK(std::abs(found[i] - exact[i]) < 1e-6);
    }
  }
}

} // namespace

int main()
{
  DerivativesAreThoseOfFiniteDifferences();
  TheSphereHasNoBiasAndThePapersIsKnown();
  CurvaturesConverge();
  SectionCurvatureIsThatOfTracedPoints();
  ProjectedPointsLieOnTheSurface();
  NoiseIsAveragedAsPredicted();
  PlacesWithoutSupportAreToldApart();
  AllRootsOfALineAreFound();
  return check::Verdict("TestMovingLeastSquares");
}
