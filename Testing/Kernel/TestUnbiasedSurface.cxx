// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestUnbiasedSurface.cxx
 * @brief The unbiased surface of samples of a sphere is the sphere to rounding, for every width,
 * every placement of the samples and widths of their own; of a torus it is off by the fourth power
 * of the width; noise is averaged as theory says; derivatives are those of differences with widths
 * of their own, too.
 */
#include "Check.h"
#include "Clouds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace
{

using sb::MovingLeastSquares;
using sb::Real3;
using sb::SurfaceDefinition;
using sb::SurfaceValue;
using Neighbourhood = MovingLeastSquares::Neighbourhood;

/** Randomly over the unit sphere, moved to a centre and made larger. */
clouds::Cloud RandomSphere(int count, double radius, const Real3& centre, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  clouds::Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    Real3 v{ normal(random), normal(random), normal(random) };
    v = sb::Scaled(v, 1.0 / sb::Length(v));
    cloud.Add(sb::PlusScaled(centre, radius, v), v);
  }
  return cloud;
}

/** The surface with a width of its own for each sample, drawn between one and three times `least`.
 */
std::shared_ptr<MovingLeastSquares> WithOwnWidths(
  const clouds::Cloud& cloud, double least, std::mt19937& random)
{
  sb::SerialExecutor executor;
  const auto tree =
    std::make_shared<sb::PointTree>(cloud.Points.data(), cloud.Count(), nullptr, executor);
  std::uniform_real_distribution<double> factor(1.0, 3.0);
  std::vector<double> widths(static_cast<std::size_t>(tree->Size()));
  for (std::size_t i = 0; i < widths.size(); ++i)
  {
    widths[i] = factor(random) * least;
  }
  return std::make_shared<MovingLeastSquares>(
    tree, cloud.Normals.data(), SurfaceDefinition::Unbiased, 2.0 * least, widths);
}

double LargestRadiusError(
  const MovingLeastSquares& surface, double radius, const Real3& centre, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> height(-0.4, 0.4);
  Neighbourhood near;
  double worst = 0.0;
  for (int k = 0; k < 200; ++k)
  {
    Real3 v{ normal(random), normal(random), normal(random) };
    v = sb::Scaled(v, 1.0 / sb::Length(v));
    Real3 x = sb::PlusScaled(centre, radius + height(random) * surface.NarrowWidth(), v);
    CHECK(surface.Project(x, near).IsNear);
    const double reached = sb::Length(sb::Difference(x, centre));
    worst = std::max(worst, std::abs(reached / radius - 1.0));
  }
  return worst;
}

void SpheresAreExactAtEveryWidth()
{
  std::mt19937 random(1);
  const Real3 centre{ 3.0, -2.0, 5.0 };
  for (const int count : { 500, 5000, 50000 })
  {
    const double spacing = std::sqrt(4.0 * clouds::Pi / count);
    for (const double radius : { 1.0, 7.5 })
    {
      const clouds::Cloud cloud = RandomSphere(count, radius, centre, random);
      for (const double widths : { 2.5, 3.0, 4.0, 6.0 })
      {
        const sb::CloudSurface made =
          clouds::SurfaceOf(cloud, true, SurfaceDefinition::Unbiased, widths * spacing * radius);
        CHECK(LargestRadiusError(*made.Surface, radius, centre, random) < 1e-12);
      }
      const auto uneven = WithOwnWidths(cloud, 2.5 * spacing * radius, random);
      CHECK(uneven->IsUneven());
      CHECK(LargestRadiusError(*uneven, radius, centre, random) < 1e-12);
    }
  }
}

/** Half the mean curvature times the square of h, inwards; the mean of two such definitions has
 * nothing of that order. */
void TheBiasOfATorusIsOfTheFourthOrder()
{
  const clouds::Cloud cloud = clouds::TorusGrid(700, 280);
  const auto biasAt = [&](SurfaceDefinition definition, double h, double b) {
    const sb::CloudSurface made = clouds::SurfaceOf(cloud, true, definition, h);
    Neighbourhood near;
    const double reach = 1.0 + 0.4 * std::cos(b);
    Real3 x{ reach, 0.0, 0.4 * std::sin(b) };
    CHECK(made.Surface->Project(x, near).IsNear);
    return clouds::DistanceToTorus(x);
  };
  for (const double b : { 0.0, 1.0, 2.0, 3.1 })
  {
    const double curvature = 0.5 * (2.5 + std::cos(b) / (1.0 + 0.4 * std::cos(b)));
    const double paper = biasAt(SurfaceDefinition::AmentaKil, 0.08, b);
    CHECK(std::abs(paper / (-0.5 * 0.08 * 0.08 * curvature) - 1.0) < 0.08);
    const double coarse = std::abs(biasAt(SurfaceDefinition::Unbiased, 0.16, b));
    const double fine = std::abs(biasAt(SurfaceDefinition::Unbiased, 0.08, b));
    CHECK(coarse < 0.05 * 0.5 * 0.16 * 0.16 * curvature);
    CHECK(fine < 0.012 * 0.5 * 0.08 * 0.08 * curvature);
    CHECK(fine < coarse / 10.0 || fine < 1e-7); // 16 in the limit
  }
}

/** Weights th of height noise sigma leave sigma sqrt(sum th^2) / sum th: for (1 - r^2)^3 up to R
 * that is sigma s 4 / (R sqrt(7 pi)), which for R = 2 h is 0.43 sigma s / h. */
void NoiseIsAveragedAsPredicted()
{
  std::mt19937 random(2);
  for (const double widths : { 2.0, 3.0, 6.0 })
  {
    clouds::Cloud cloud = clouds::Plane(121);
    const double s = 1.0 / 120.0;
    std::normal_distribution<double> height(0.0, 0.5 * s);
    for (std::size_t i = 2; i < cloud.Points.size(); i += 3)
    {
      cloud.Points[i] = height(random);
    }
    const sb::CloudSurface made =
      clouds::SurfaceOf(cloud, true, SurfaceDefinition::Unbiased, widths * s);
    std::uniform_real_distribution<double> inside(0.2, 0.8);
    Neighbourhood near;
    double squares = 0.0;
    const int count = 2000;
    for (int k = 0; k < count; ++k)
    {
      Real3 x{ inside(random), inside(random), 0.0 };
      made.Surface->Project(x, near);
      squares += x[2] * x[2];
    }
    const double predicted = 0.5 * s * 4.0 / (2.0 * widths * std::sqrt(7.0 * clouds::Pi));
    CHECK(std::abs(std::sqrt(squares / count) / predicted - 1.0) < 0.15);
  }
}

void DerivativesWithOwnWidthsAreThoseOfDifferences()
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  clouds::Cloud cloud = RandomSphere(600, 1.0, { 0.0, 0.0, 0.0 }, random);
  clouds::AddNoise(cloud, 0.02, random);
  const auto surface = WithOwnWidths(cloud, 0.3, random);
  Neighbourhood near;
  double ofGradient = 0.0, ofHessian = 0.0, betweenOrders = 0.0;
  for (std::int32_t k = 0; k < 600; k += 10)
  {
    const Real3 q = surface->Samples().Point(k);
    const Real3 x{ q[0] + 0.05 * normal(random), q[1] + 0.05 * normal(random),
      q[2] + 0.05 * normal(random) };
    surface->Gather(x, 0.1, near);
    const SurfaceValue f = surface->Evaluate(x, 2, near);
    const SurfaceValue first = surface->Evaluate(x, 1, near);
    const double e = 1e-4;
    for (std::size_t a = 0; a < 3; ++a)
    {
      betweenOrders = std::max(betweenOrders, std::abs(first.Gradient[a] - f.Gradient[a]));
      Real3 before = x, after = x;
      before[a] -= e;
      after[a] += e;
      const SurfaceValue lower = surface->Evaluate(before, 1, near);
      const SurfaceValue upper = surface->Evaluate(after, 1, near);
      ofGradient =
        std::max(ofGradient, std::abs((upper.Value - lower.Value) / (2.0 * e) - f.Gradient[a]));
      for (std::size_t b = 0; b < 3; ++b)
      {
        const double slope = (upper.Gradient[b] - lower.Gradient[b]) / (2.0 * e);
        const double size = 1.0 + std::abs(f.Hessian[a][b]);
        ofHessian = std::max(ofHessian, std::abs(slope - f.Hessian[a][b]) / size);
      }
    }
  }
  CHECK(ofGradient < 1e-6);
  CHECK(ofHessian < 2e-6);
  CHECK(betweenOrders < 1e-12);
}

/** The leaves that are kept from query to query must not change anything. */
void WhatWasAskedBeforeDoesNotMatter()
{
  std::mt19937 random(4);
  const clouds::Cloud cloud = clouds::Torus(5000, random);
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  const auto uneven = WithOwnWidths(cloud, 0.1, random);
  std::uniform_real_distribution<double> step(-0.2, 0.2);
  for (const std::shared_ptr<const MovingLeastSquares>& surface :
    { made.Surface, std::shared_ptr<const MovingLeastSquares>(uneven) })
  {
    Neighbourhood kept;
    Real3 x{ 1.4, 0.0, 0.0 };
    for (int k = 0; k < 300; ++k)
    {
      const Real3 sample = surface->Samples().Point(k % 7 == 0 ? 13 * k : k);
      x = { sample[0] + 0.3 * step(random), sample[1] + 0.3 * step(random), sample[2] };
      Neighbourhood fresh;
      const SurfaceValue one = surface->EvaluateAt(x, 1, kept);
      const SurfaceValue other = surface->EvaluateAt(x, 1, fresh);
      CHECK(one.Value == other.Value && one.Gradient == other.Gradient);
    }
  }
}

} // namespace

int main()
{
  SpheresAreExactAtEveryWidth();
  TheBiasOfATorusIsOfTheFourthOrder();
  NoiseIsAveragedAsPredicted();
  DerivativesWithOwnWidthsAreThoseOfDifferences();
  WhatWasAskedBeforeDoesNotMatter();
  return check::Verdict("TestUnbiasedSurface");
}
