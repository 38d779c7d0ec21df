// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNURBSBranches.cxx
 * @brief Curves with exact patches that nearly touch: at a saddle each branch goes on to the right
 * one, with its chords under the bound; a patch that comes near without crossing is told, once;
 * steps are as short as the samples' own widths ask for.
 */
#include "Check.h"
#include "Clouds.h"
#include "CommonPoint.h"
#include "DesignedShapes.h"
#include "NURBSSection.h"
#include "Patches.h"

#include <cmath>

namespace
{

using patches::OneFace;
using sb::NURBSCurve;
using sb::NURBSSection;
using sb::Real3;

NURBSSection SectionOf(
  const sb::CloudSurface& made, const sb::DesignedSurface& designed, double chordError = 1e-3)
{
  sb::ThreadExecutor executor(2);
  sb::Monitor monitor;
  return sb::IntersectPatches(
    *made.Surface, designed, { made.Spacing, chordError }, executor, monitor);
}

/** A plane as a patch, that far from the origin, across n, which has no part along z. */
sb::DesignedSurface Wall(const Real3& n, double away, double half = 2.0)
{
  const Real3 along{ -n[1], n[0], 0.0 };
  const Real3 corner =
    sb::PlusScaled(sb::PlusScaled(sb::Scaled(n, away), -half, along), -half, { 0.0, 0.0, 1.0 });
  return OneFace(
    patches::Parallelogram(corner, sb::Scaled(along, 2.0 * half), { 0.0, 0.0, 2.0 * half }));
}

/** Walls a little before and behind the inner equator of a torus. */
void BranchesNearASaddle()
{
  std::mt19937 random(3);
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Torus(20000, random));
  for (const double away : { 1e-2, 1e-3, 3e-4 })
  {
    for (const double turn : { 0.3, 2.0 })
    {
      const Real3 n{ std::cos(turn), std::sin(turn), 0.0 };
      for (const double side : { -1.0, 1.0 })
      {
        const NURBSSection section = SectionOf(made, Wall(n, 0.6 + side * away));
        CHECK_EQUAL(section.Curves.size(), side < 0.0 ? 2u : 1u);
        CHECK(section.Touches.empty());
        for (const NURBSCurve& curve : section.Curves)
        {
          CHECK(curve.Closed);
          CHECK(curve.LargestChordError <= 1e-3);
          CHECK(curve.LargestResidual < 1e-12);
        }
      }
    }
  }
}

void TouchesAreTold()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(8000));
  const Real3 n{ 0.6, 0.8, 0.0 };
  const double near = 0.05 * made.Spacing;
  const NURBSSection touching = SectionOf(made, Wall(n, 1.0 + near));
  CHECK(touching.Curves.empty());
  CHECK_EQUAL(touching.Touches.size(), 1u);
  CHECK(!touching.Touches.empty() && std::abs(touching.Touches[0].Distance - near) < 2e-3 &&
    sb::Length(sb::Difference(touching.Touches[0].Place, n)) < 2.0 * made.Spacing);
  // One that is away, one that crosses, and one that ends before it touches.
  CHECK(SectionOf(made, Wall(n, 1.0 + 5.0 * made.Spacing)).Touches.empty());
  const NURBSSection crossing = SectionOf(made, Wall(n, 0.9));
  CHECK_EQUAL(crossing.Curves.size(), 1u);
  CHECK(crossing.Touches.empty());
  const Real3 side{ 1.0 + near, 0.5, -1.0 };
  CHECK(SectionOf(made, OneFace(patches::Parallelogram(side, { 0, 1, 0 }, { 0, 0, 2 })))
          .Touches.empty());
  // Two faces that share the edge at which they touch: one place.
  sb::DesignedSurface roof =
    OneFace(patches::Parallelogram({ 1.0 + near, 0, -2 }, { 1, 1, 0 }, { 0, 0, 4 }));
  patches::AddFace(
    roof, patches::Parallelogram({ 1.0 + near, 0, -2 }, { 1, -1, 0 }, { 0, 0, 4 }), 8, 8);
  const NURBSSection edge = SectionOf(made, roof);
  CHECK(edge.Curves.empty());
  CHECK_EQUAL(edge.Touches.size(), 1u);
}

/** Two balls, one a tenth as large and with as many samples: between them the widths differ ten
 * times, and the typical one is right for neither. */
void WidthsMayDiffer()
{
  clouds::Cloud cloud = clouds::Sphere(4000);
  const clouds::Cloud small = clouds::Sphere(4000);
  for (std::size_t i = 0; i < small.Points.size(); ++i)
  {
    cloud.Points.push_back(0.1 * small.Points[i] + (i % 3 == 0 ? 3.0 : 0.0));
    cloud.Normals.push_back(small.Normals[i]);
  }
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  const NURBSSection section = SectionOf(
    made, OneFace(patches::Parallelogram({ -2, -2, 0.02 }, { 6, 0, 0 }, { 0, 4, 0 })), 1e-4);
  CHECK_EQUAL(section.Curves.size(), 2u);
  for (const NURBSCurve& curve : section.Curves)
  {
    const bool isSmall = curve.Points.front()[0] > 2.0;
    CHECK(curve.Closed);
    CHECK(curve.LargestChordError <= 1e-4);
    CHECK(curve.LargestResidual < 1e-12);
    for (const Real3& x : curve.Points)
    {
      const Real3 from = sb::Difference(x, { isSmall ? 3.0 : 0.0, 0.0, 0.0 });
      CHECK(std::abs(sb::Length(from) - (isSmall ? 0.1 : 1.0)) < (isSmall ? 1e-4 : 1e-3));
    }
  }
}

} // namespace

int main()
{
  BranchesNearASaddle();
  TouchesAreTold();
  WidthsMayDiffer();
  return check::Verdict("TestNURBSBranches");
}
