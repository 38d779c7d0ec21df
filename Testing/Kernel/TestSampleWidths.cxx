// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSampleWidths.cxx
 * @brief Clouds of one density keep one width; in a cloud whose density varies the sparse part gets
 * larger ones and an outlier does not; thin walls get smaller ones down to two spacings, and are
 * reported beyond that.
 */
#include "Check.h"
#include "Clouds.h"
#include "SampleWidths.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using sb::CloudStatus;
using sb::Real3;

/** A torus with `ratio` times as many points by area at x > 0 as at x < 0, changing smoothly. */
clouds::Cloud UnevenTorus(int count, double ratio, std::mt19937& random)
{
  const clouds::Cloud dense = clouds::Torus(count, random);
  std::uniform_real_distribution<double> uniform;
  clouds::Cloud cloud;
  for (std::size_t i = 0; i < dense.Points.size(); i += 3)
  {
    const double cosine = dense.Points[i] / std::hypot(dense.Points[i], dense.Points[i + 1]);
    if (uniform(random) < std::pow(ratio, 0.5 * (cosine - 1.0)))
    {
      cloud.Add({ dense.Points[i], dense.Points[i + 1], dense.Points[i + 2] },
        { dense.Normals[i], dense.Normals[i + 1], dense.Normals[i + 2] });
    }
  }
  return cloud;
}

/** A hollow ball with a wall that is so many spacings thick. */
clouds::Cloud HollowBall(double thickness)
{
  const int count = 8000;
  clouds::Cloud cloud = clouds::Sphere(count);
  const double radius = 1.0 - thickness * std::sqrt(4.0 * clouds::Pi / count);
  const clouds::Cloud inner = clouds::Sphere(static_cast<int>(count * radius * radius));
  for (std::size_t i = 0; i < inner.Points.size(); i += 3)
  {
    const Real3 v{ inner.Points[i], inner.Points[i + 1], inner.Points[i + 2] };
    cloud.Add(sb::Scaled(v, radius), sb::Scaled(v, -1.0));
  }
  return cloud;
}

void OneDensityKeepsOneWidth()
{
  std::mt19937 random(1);
  for (const clouds::Cloud& cloud :
    { clouds::Sphere(5000), clouds::Torus(20000, random), clouds::Plane(50) })
  {
    const sb::CloudSurface made = clouds::SurfaceOf(cloud);
    CHECK(!made.Surface->IsUneven());
    CHECK_EQUAL(made.Surface->Width(), sb::WidthInSpacings * made.Spacing);
    CHECK_EQUAL(made.ThinShare, 0.0);
  }
}

void SparsePartsGetLargerWidths()
{
  std::mt19937 random(2);
  clouds::Cloud cloud = UnevenTorus(60000, 10.0, random);
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  const sb::MovingLeastSquares& surface = *made.Surface;
  CHECK(surface.IsUneven());
  double sparse = 0.0;
  for (std::int32_t i = 0; i < surface.Samples().Size(); ++i)
  {
    CHECK(surface.WidthOf(i) >= sb::WidthInSpacings * made.Spacing * (1.0 - 1e-12));
    sparse = std::max(sparse, surface.WidthOf(i));
  }
  CHECK(sparse > 1.1 * surface.Width());
  CHECK(sparse < 4.0 * surface.Width());
  // Found from everywhere, and no place of it is taken for a border.
  sb::MovingLeastSquares::Neighbourhood near;
  double worst = 0.0;
  for (int k = 0; k < 1000; ++k)
  {
    const double a = 0.1 * k;
    const double b = 0.37 * k;
    const double reach = 1.0 + 0.4 * std::cos(b);
    Real3 x{ reach * std::cos(a), reach * std::sin(a), 0.4 * std::sin(b) };
    CHECK(surface.Project(x, near).Where == sb::Support::Defined);
    worst = std::max(worst, std::abs(clouds::DistanceToTorus(x)));
  }
  CHECK(worst < 0.15 * made.Spacing);
}

void AnOutlierDoesNotReachFar()
{
  std::mt19937 random(3);
  clouds::Cloud cloud = UnevenTorus(30000, 10.0, random);
  cloud.Add({ 1.9, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }); // half a radius off the dense part
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  CHECK(made.Surface->IsUneven());
  for (std::int32_t i = 0; i < made.Surface->Samples().Size(); ++i)
  {
    CHECK(made.Surface->Samples().Point(i)[0] < 1.8 ||
      made.Surface->WidthOf(i) < 1.01 * made.Surface->Width());
  }
}

void ThinWallsGetSmallerWidths()
{
  for (const double thickness : { 6.0, 4.0, 2.8, 2.3 })
  {
    const sb::CloudSurface made = clouds::SurfaceOf(HollowBall(thickness));
    CHECK(made.Status == CloudStatus::Ok);
    CHECK(made.ThinShare < 0.01);
    CHECK_EQUAL(made.Surface->IsUneven(), thickness < 3.0);
    sb::MovingLeastSquares::Neighbourhood near;
    const double inner = 1.0 - thickness * std::sqrt(4.0 * clouds::Pi / 8000.0);
    for (std::int32_t i = 0; i < made.Surface->Samples().Size(); i += 20)
    {
      Real3 x = made.Surface->Samples().Point(i);
      const double wanted = sb::Length(x) > 0.5 * (1.0 + inner) ? 1.0 : inner;
      CHECK(made.Surface->Project(x, near).IsNear);
      CHECK(std::abs(sb::Length(x) - wanted) < 0.05 * made.Spacing);
    }
  }
}

void WhatIsTooThinIsReported()
{
  const clouds::Cloud shell = HollowBall(1.5);
  const sb::CloudSurface made = clouds::SurfaceOf(shell);
  CHECK(made.Status == CloudStatus::ThinWall);
  CHECK(made.ThinShare > 0.9);
  CHECK(std::abs(made.ThinWall / (1.5 * std::sqrt(4.0 * clouds::Pi / 8000.0)) - 1.0) < 0.1);
  const double spacing = made.Spacing;
  const clouds::Cloud wall = HollowBall(4.0);
  const auto asked = [&](double width) {
    return clouds::SurfaceOf(wall, true, sb::SurfaceDefinition::Unbiased, width * spacing).Status;
  };
  CHECK(asked(3.5) == CloudStatus::Ok);
  CHECK(asked(4.5) == CloudStatus::ThinWall);
}

} // namespace

int main()
{
  OneDensityKeepsOneWidth();
  SparsePartsGetLargerWidths();
  AnOutlierDoesNotReachFar();
  ThinWallsGetSmallerWidths();
  WhatIsTooThinIsReported();
  return check::Verdict("TestSampleWidths");
}
