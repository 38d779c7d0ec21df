// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNURBSSection.cxx
 * @brief Curves of clouds with exact patches: circles and other curves that are known, points on
 * both to 1e-12, chord errors under their bound; over seams, poles and edges between faces, cut at
 * trimmed borders; areas where both coincide; and as many loops as dense samples show.
 */
#include "Check.h"
#include "Clouds.h"
#include "CommonPoint.h"
#include "DesignedShapes.h"
#include "NURBSSection.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using patches::AddFace;
using patches::Moved;
using patches::OneFace;
using sb::CurveEnd;
using sb::DesignedSurface;
using sb::NURBSCurve;
using sb::NURBSSection;
using sb::NURBSSurface;
using sb::Real3;
using sb::Real3x3;

double Gap(const Real3& a, const Real3& b) { return sb::Length(sb::Difference(a, b)); }

NURBSSection SectionOf(const sb::CloudSurface& made, const DesignedSurface& designed,
  double chordError = 1e-3, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  return sb::IntersectPatches(
    *made.Surface, designed, { made.Spacing, chordError }, executor, monitor);
}

double LengthOf(const NURBSCurve& curve)
{
  double length = 0.0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    length += Gap(curve.Points[i], curve.Points[i - 1]);
  }
  return length;
}

double LengthOf(const NURBSSection& section)
{
  double length = 0.0;
  for (const NURBSCurve& curve : section.Curves)
  {
    length += LengthOf(curve);
  }
  return length;
}

/** What holds of every curve. */
void CheckCurves(const sb::CloudSurface& made, const DesignedSurface& designed,
  const NURBSSection& section, double chordError)
{
  sb::MovingLeastSquares::Neighbourhood near;
  for (const NURBSCurve& curve : section.Curves)
  {
    CHECK(curve.Points.size() > 1);
    CHECK_EQUAL(curve.UV.size(), curve.Points.size());
    CHECK_EQUAL(curve.FaceId.size(), curve.Points.size());
    CHECK(curve.Closed == (curve.Points.front() == curve.Points.back()));
    CHECK(curve.Closed == (curve.Begin == CurveEnd::None));
    CHECK(curve.Closed == (curve.End == CurveEnd::None));
    CHECK(curve.LargestChordError <= chordError);
    CHECK(curve.LargestResidual < 1e-12);
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      const NURBSSurface& patch = designed.Patches[static_cast<std::size_t>(curve.FaceId[i])];
      const Real3 x = sb::EvaluatePatch(patch, curve.UV[i][0], curve.UV[i][1], 0).Point;
      CHECK(Gap(x, curve.Points[i]) < 1e-12);
      CHECK(std::abs(made.Surface->EvaluateAt(curve.Points[i], 0, near).Value) < 1e-12);
      CHECK(i == 0 || curve.Points[i] != curve.Points[i - 1]);
    }
  }
}

/** The largest distance of the curve to its segments, of those on one face, at places between. */
double ChordError(
  const sb::CloudSurface& made, const DesignedSurface& designed, const NURBSCurve& curve)
{
  sb::MovingLeastSquares::Neighbourhood near;
  double largest = 0.0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    const NURBSSurface& patch = designed.Patches[static_cast<std::size_t>(curve.FaceId[i])];
    const double du = curve.UV[i][0] - curve.UV[i - 1][0];
    const double dv = curve.UV[i][1] - curve.UV[i - 1][1];
    const double spanU = patch.LastU() - patch.FirstU();
    const double spanV = patch.LastV() - patch.FirstV();
    if (curve.FaceId[i] != curve.FaceId[i - 1] || std::abs(du) > 0.2 * spanU ||
      std::abs(dv) > 0.2 * spanV)
    {
      continue;
    }
    const Real3 a = curve.Points[i - 1];
    const Real3 along = sb::Difference(curve.Points[i], a);
    for (int k = 1; k < 8; ++k)
    {
      const double s = k / 8.0;
      const sb::CommonPoint on = sb::OntoCloudAndPatch(
        *made.Surface, patch, curve.UV[i - 1][0] + s * du, curve.UV[i - 1][1] + s * dv, near);
      CHECK(on.Found);
      const Real3 from = sb::Difference(on.Point, a);
      const double t = std::clamp(sb::Dot(from, along) / sb::Dot(along, along), 0.0, 1.0);
      largest = std::max(largest, sb::Length(sb::PlusScaled(from, -t, along)));
    }
  }
  return largest;
}

/** Two unit spheres' radii and distance: the radius of the circle that they have in common. */
double CircleOfSpheres(double radius, double distance)
{
  const double x = (distance * distance + 1.0 - radius * radius) / (2.0 * distance);
  return std::sqrt(1.0 - x * x);
}

void CirclesOnASphere()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  for (const double bound : { 1e-3, 1e-4 })
  {
    const auto isCircle = [&](const DesignedSurface& designed, double radius, std::size_t count) {
      const NURBSSection section = SectionOf(made, designed, bound);
      CheckCurves(made, designed, section, bound);
      CHECK_EQUAL(section.Curves.size(), count);
      CHECK_EQUAL(section.CoincidentArea, 0.0);
      for (const NURBSCurve& curve : section.Curves)
      {
        CHECK(curve.Closed);
        CHECK(ChordError(made, designed, curve) <= bound);
        const double circle = 2.0 * clouds::Pi * radius;
        CHECK(LengthOf(curve) < circle + 1e-4);
        CHECK(LengthOf(curve) > circle * (1.0 - 2.0 * bound / radius) - 1e-4);
      }
    };
    isCircle(OneFace(patches::Parallelogram({ -2, -2, 0.6 }, { 4, 0, 0 }, { 0, 4, 0 })), 0.8, 1);
    // In the middle of the patch; over its seam; around its pole; through its pole.
    const double common = CircleOfSpheres(0.8, std::sqrt(0.54));
    isCircle(OneFace(Moved(patches::Sphere(0.8), { 0.7, 0.1, 0.2 })), common, 1);
    isCircle(OneFace(Moved(patches::Sphere(0.8), { -0.7, 0.1, 0.2 })), common, 1);
    isCircle(OneFace(Moved(patches::Sphere(0.8), { 0, 0, 0.7 })), CircleOfSpheres(0.8, 0.7), 1);
    isCircle(OneFace(Moved(patches::Sphere(0.8), { 0.6, 0, 0 })), 0.8, 1);
    isCircle(OneFace(Moved(patches::Sphere(0.8), { 0, 0.6, 0.001 })), 0.8, 1);
    isCircle(OneFace(Moved(patches::Sphere(0.8), { 0.6, 0.3, -0.8 })),
      CircleOfSpheres(0.8, std::sqrt(1.09)), 1);
    isCircle(OneFace(patches::Cylinder(0.6, 2.0)), 0.6, 2);
    // Around the axis, where the tube's circle about (0.9, 0) meets the unit circle.
    isCircle(OneFace(patches::Torus(0.9, 0.5)), (1.0 + 0.81 - 0.25) / 1.8, 2);
  }
}

double DistanceToCurve(const Real3& x, const NURBSCurve& curve)
{
  double least = 1e300;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    const Real3 along = sb::Difference(curve.Points[i], curve.Points[i - 1]);
    const Real3 from = sb::Difference(x, curve.Points[i - 1]);
    const double t = std::clamp(sb::Dot(from, along) / sb::Dot(along, along), 0.0, 1.0);
    least = std::min(least, sb::Length(sb::PlusScaled(from, -t, along)));
  }
  return least;
}

double DistanceToCurves(const Real3& x, const NURBSSection& section)
{
  double least = 1e300;
  for (const NURBSCurve& curve : section.Curves)
  {
    least = std::min(least, DistanceToCurve(x, curve));
  }
  return least;
}

void TrimmedPatches()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  const NURBSSurface plane = patches::Parallelogram({ -2, -2, 0.6 }, { 4, 0, 0 }, { 0, 4, 0 });
  // The half with x < 0: a half circle, whose ends are where the face ends.
  DesignedSurface half;
  AddFace(half, plane, 8, 8, [](double u, double) { return u < 0.5; });
  NURBSSection section = SectionOf(made, half);
  CheckCurves(made, half, section, 1e-3);
  CHECK_EQUAL(section.Curves.size(), 1u);
  CHECK(std::abs(LengthOf(section) - 0.8 * clouds::Pi) < 2e-3 * clouds::Pi);
  for (const NURBSCurve& curve : section.Curves)
  {
    CHECK(curve.Begin == CurveEnd::MeshBorder && curve.End == CurveEnd::MeshBorder);
    CHECK(curve.UV.front()[0] == 0.5 && curve.UV.back()[0] == 0.5);
    CHECK(std::abs(std::abs(curve.Points.front()[1]) - 0.8) < 1e-5);
  }
  // A window cut out around (0.8, 0), and one around (-0.8, 0) alone kept.
  const auto inWindow = [](double u, double v) {
    return std::abs(u - 0.7) < 0.1 && std::abs(v - 0.5) < 0.1;
  };
  DesignedSurface holed;
  AddFace(holed, plane, 20, 20, [&](double u, double v) { return !inWindow(u, v); });
  section = SectionOf(made, holed);
  CheckCurves(made, holed, section, 1e-3);
  CHECK_EQUAL(section.Curves.size(), 1u);
  DesignedSurface window;
  AddFace(window, plane, 20, 20, [&](double u, double v) { return inWindow(1.0 - u, v); });
  const NURBSSection inside = SectionOf(made, window);
  CheckCurves(made, window, inside, 1e-3);
  CHECK_EQUAL(inside.Curves.size(), 1u);
  CHECK(std::abs(LengthOf(section) + LengthOf(inside) - 1.6 * clouds::Pi) < 4e-3 * clouds::Pi);
  // Away from all of the circle: in it, and outside of it.
  for (const double radius : { 0.1, 0.35 })
  {
    DesignedSurface off;
    AddFace(off, plane, 20, 20, [&](double u, double v) {
      const double r = std::hypot(u - 0.5, v - 0.5);
      return radius < 0.2 ? r < radius : r > radius;
    });
    CHECK(SectionOf(made, off).Curves.empty());
  }
}

/** A checkered face: many holes that touch at their corners. What is kept and what is cut out make
 * the whole circle together. */
void CheckeredFaces()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  for (int k = 0; k < 30; ++k)
  {
    const NURBSSurface plane = patches::Parallelogram(
      { -2, -2, uniform(random) }, { 4, uniform(random), 0 }, { uniform(random), 4, 0.3 });
    const auto isBlack = [](double u, double v) {
      return (static_cast<int>(u * 24) + static_cast<int>(v * 24)) % 2 == 0;
    };
    DesignedSurface black;
    DesignedSurface white;
    AddFace(black, plane, 24, 24, isBlack);
    AddFace(
      white, plane, 24, 24, [&](double u, double v) { return !isBlack(u, v); }, true);
    const NURBSSection whole = SectionOf(made, OneFace(plane), 1e-4);
    const NURBSSection parts[2] = { SectionOf(made, black, 1e-4), SectionOf(made, white, 1e-4) };
    CHECK_EQUAL(whole.Curves.size(), 1u);
    CheckCurves(made, black, parts[0], 1e-4);
    CheckCurves(made, white, parts[1], 1e-4);
    CHECK(std::abs(LengthOf(parts[0]) + LengthOf(parts[1]) - LengthOf(whole)) < 2e-3);
    for (const NURBSSection& part : parts)
    {
      for (const NURBSCurve& curve : part.Curves)
      {
        for (const Real3& x : curve.Points)
        {
          CHECK(DistanceToCurves(x, whole) < 1.1e-4);
        }
      }
    }
  }
}

/** Six faces; each turned as the box needs it. */
DesignedSurface Box(const Real3& lower, const Real3& size, bool turnSome)
{
  DesignedSurface box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const bool far : { false, true })
    {
      Real3 corner = lower;
      corner[axis] += far ? size[axis] : 0.0;
      Real3 u{};
      Real3 v{};
      u[(axis + 1) % 3] = size[(axis + 1) % 3];
      v[(axis + 2) % 3] = size[(axis + 2) % 3];
      // u x v points along the axis; a patch may be turned against its face.
      const bool swap = turnSome && axis == 1;
      AddFace(
        box, patches::Parallelogram(corner, swap ? v : u, swap ? u : v), 3, 5,
        [](double, double) { return true; }, swap == far);
    }
  }
  return box;
}

void OverEdges()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  for (const bool turnSome : { false, true })
  {
    // An eighth of the sphere is in the box: three quarters of circles.
    const DesignedSurface box = Box({ 0, 0, 0 }, { 2, 2, 2 }, turnSome);
    const NURBSSection section = SectionOf(made, box, 1e-3);
    CheckCurves(made, box, section, 1e-3);
    CHECK_EQUAL(section.Curves.size(), 1u);
    for (const NURBSCurve& curve : section.Curves)
    {
      CHECK(curve.Closed);
      CHECK(std::abs(LengthOf(curve) - 1.5 * clouds::Pi) < 4e-3 * clouds::Pi);
      for (const Real3& corner : { Real3{ 1, 0, 0 }, Real3{ 0, 1, 0 }, Real3{ 0, 0, 1 } })
      {
        CHECK(std::any_of(curve.Points.begin(), curve.Points.end(),
          [&](const Real3& x) { return Gap(x, corner) < 1e-5; }));
      }
    }
    // Through the faces around one edge.
    const DesignedSurface low = Box({ 0.5, -2, 0.3 }, { 2, 4, 2 }, turnSome);
    const NURBSSection arc = SectionOf(made, low, 1e-3);
    CheckCurves(made, low, arc, 1e-3);
    CHECK_EQUAL(arc.Curves.size(), 1u);
    CHECK(arc.Curves.empty() || arc.Curves.front().Closed);
  }
}

/** The inside of the cloud is on the left, seen from outside of the designed body. */
void Directions()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  for (const bool turned : { false, true })
  {
    DesignedSurface designed;
    AddFace(
      designed, patches::Parallelogram({ -2, -2, 0.6 }, { 4, 0, 0 }, { 0, 4, 0 }), 3, 3,
      [](double, double) { return true; }, turned);
    const NURBSSection section = SectionOf(made, designed);
    CHECK_EQUAL(section.Curves.size(), 1u);
    for (const NURBSCurve& curve : section.Curves)
    {
      const Real3 turn = sb::Cross(curve.Points[0], curve.Points[1]);
      CHECK((turn[2] > 0.0) != turned);
    }
  }
}

/** A round bar with flat ends: the edges of its facets are chords of the true edges. */
DesignedSurface Bar(double radius, double halfHeight, int around)
{
  DesignedSurface bar;
  AddFace(bar, patches::Cylinder(radius, halfHeight), around, 1);
  for (const bool top : { false, true })
  {
    const double z = top ? halfHeight : -halfHeight;
    const std::int32_t face = static_cast<std::int32_t>(bar.Patches.size());
    const std::int32_t first = static_cast<std::int32_t>(bar.Points.size() / 3);
    bar.Patches.push_back(patches::Parallelogram(
      { -2 * radius, -2 * radius, z }, { 4 * radius, 0, 0 }, { 0, 4 * radius, 0 }));
    for (int k = 0; k < around; ++k)
    {
      const std::size_t rim = 3 * static_cast<std::size_t>((top ? around + 1 : 0) + k);
      const Real3 x{ bar.Points[rim], bar.Points[rim + 1], bar.Points[rim + 2] };
      bar.Points.insert(bar.Points.end(), x.begin(), x.end());
      bar.UV.insert(
        bar.UV.end(), { (x[0] + 2 * radius) / (4 * radius), (x[1] + 2 * radius) / (4 * radius) });
    }
    for (std::int32_t k = 1; k + 1 < around; ++k)
    {
      const std::int32_t a = first + (top ? k : k + 1);
      const std::int32_t b = first + (top ? k + 1 : k);
      bar.Triangles.insert(bar.Triangles.end(), { first, a, b });
      bar.FaceId.push_back(face);
    }
  }
  return bar;
}

void OverRoundEdges()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (int k = 0; k < 40; ++k)
  {
    DesignedSurface bar = Bar(0.5, 0.4, k % 2 == 0 ? 12 : 40);
    const Real3 by{ 0.8 + uniform(random), uniform(random), 0.3 + uniform(random) };
    for (NURBSSurface& patch : bar.Patches)
    {
      patch = Moved(patch, by);
    }
    for (std::size_t i = 0; i < bar.Points.size(); ++i)
    {
      bar.Points[i] += by[i % 3];
    }
    const NURBSSection section = SectionOf(made, bar, 1e-3);
    CheckCurves(made, bar, section, 1e-3);
    CHECK_EQUAL(section.Curves.size(), 1u);
    for (const NURBSCurve& curve : section.Curves)
    {
      CHECK(curve.Closed);
      for (std::size_t i = 1; i < curve.Points.size(); ++i)
      {
        if (curve.FaceId[i] != curve.FaceId[i - 1])
        {
          // The face changes in a point of the true edge.
          const Real3 x = sb::Difference(curve.Points[i - 1], by);
          CHECK(std::abs(std::hypot(x[0], x[1]) - 0.5) < 1e-12);
          CHECK(std::abs(std::abs(x[2]) - 0.4) < 1e-12);
        }
      }
    }
  }
}

void CoincidentAndTangential()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  const NURBSSection same = SectionOf(made, OneFace(patches::Sphere(1.0)));
  CHECK(same.Curves.empty());
  CHECK(std::abs(same.CoincidentArea - 4.0 * clouds::Pi) < 1e-2);
  // With noise, too, and nothing is marched around the waves of it.
  std::mt19937 random(8);
  clouds::Cloud cloud = clouds::Sphere(5000);
  clouds::AddNoise(cloud, 0.01, random);
  const NURBSSection noisy = SectionOf(clouds::SurfaceOf(cloud), OneFace(patches::Sphere(1.0)));
  CHECK(noisy.Curves.empty());
  CHECK(noisy.CoincidentArea > 0.9 * 4.0 * clouds::Pi);
  // A cap of the sphere as a face of its own, and only half of the cloud's plane.
  const sb::CloudSurface flat = clouds::SurfaceOf(clouds::Plane(60));
  const NURBSSection half =
    SectionOf(flat, OneFace(patches::Parallelogram({ 0.5, -1, 0 }, { 2, 0, 0 }, { 0, 3, 0 })));
  CHECK(half.Curves.empty());
  CHECK(std::abs(half.CoincidentArea - 0.5) < 0.15);
  // One that only touches is no area.
  for (const double height : { 1.0, 1.0 - 1e-5, 1.0 + 1e-5 })
  {
    const NURBSSection touching = SectionOf(
      made, OneFace(patches::Parallelogram({ -2, -2, height }, { 4, 0, 0 }, { 0, 4, 0 })));
    CHECK_EQUAL(touching.CoincidentArea, 0.0);
    CHECK(LengthOf(touching) < 0.1);
  }
  // A loop a little wider than two spacings, where the angle is small, is found.
  const double radius = 1.05 * made.Spacing;
  const double height = std::sqrt(1.0 - radius * radius);
  const NURBSSection loop = SectionOf(
    made, OneFace(patches::Parallelogram({ -2, -2, height }, { 4, 0, 0 }, { 0, 4, 0 })), 1e-4);
  CHECK_EQUAL(loop.Curves.size(), 1u);
  CHECK(std::abs(LengthOf(loop) - 2.0 * clouds::Pi * radius) < 0.02 * radius);
  // Wholly away, outside and inside.
  CHECK(SectionOf(made, OneFace(Moved(patches::Sphere(1.0), { 2.2, 0, 0 }))).Curves.empty());
  CHECK(SectionOf(made, OneFace(patches::Torus(0.5, 0.2))).Curves.empty());
}

void OpenScans()
{
  const sb::CloudSurface flat = clouds::SurfaceOf(clouds::Plane(60));
  const DesignedSurface wall =
    OneFace(patches::Parallelogram({ -1, 0.4, -1 }, { 3, 0.2, 0 }, { 0, 0.1, 2 }));
  const NURBSSection section = SectionOf(flat, wall, 1e-4);
  CheckCurves(flat, wall, section, 1e-4);
  CHECK_EQUAL(section.Curves.size(), 1u);
  for (const NURBSCurve& curve : section.Curves)
  {
    CHECK(curve.Begin == CurveEnd::ScanBorder && curve.End == CurveEnd::ScanBorder);
    CHECK(std::abs(std::abs(curve.Points.front()[0] - curve.Points.back()[0]) - 1.0) <
      3.0 * flat.Spacing);
  }
  // A face that ends in the middle of the scan.
  const DesignedSurface fin =
    OneFace(patches::Parallelogram({ -1, 0.4, -1 }, { 1.5, 0.2, 0 }, { 0, 0.1, 2 }));
  const NURBSSection part = SectionOf(flat, fin, 1e-4);
  CHECK_EQUAL(part.Curves.size(), 1u);
  for (const NURBSCurve& curve : part.Curves)
  {
    CHECK((curve.Begin == CurveEnd::ScanBorder) != (curve.End == CurveEnd::ScanBorder));
    CHECK((curve.Begin == CurveEnd::MeshBorder) != (curve.End == CurveEnd::MeshBorder));
  }
}

Real3 Turned(const Real3& x, const Real3x3& rotation) { return sb::Times(rotation, x); }

Real3x3 RandomRotation(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  Real3 a{ normal(random), normal(random), normal(random) };
  a = sb::Scaled(a, 1.0 / sb::Length(a));
  Real3 b{ normal(random), normal(random), normal(random) };
  b = sb::WithoutPartAlong(b, a);
  b = sb::Scaled(b, 1.0 / sb::Length(b));
  return { a, b, sb::Cross(a, b) };
}

/** Where a fine grid of the patch says that it crosses the unit sphere: on each grid line between
 * two samples on different sides. */
std::vector<Real3> CrossingsOfGrid(const NURBSSurface& patch, int steps)
{
  std::vector<Real3> samples;
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; j <= steps; ++j)
    {
      samples.push_back(
        sb::EvaluatePatch(patch, patch.FirstU() + (patch.LastU() - patch.FirstU()) * i / steps,
          patch.FirstV() + (patch.LastV() - patch.FirstV()) * j / steps, 0)
          .Point);
    }
  }
  std::vector<Real3> crossings;
  const auto add = [&](const Real3& a, const Real3& b) {
    const double fa = sb::Length(a) - 1.0;
    const double fb = sb::Length(b) - 1.0;
    if ((fa < 0.0) != (fb < 0.0))
    {
      crossings.push_back(sb::PlusScaled(a, fa / (fa - fb), sb::Difference(b, a)));
    }
  };
  const std::size_t row = static_cast<std::size_t>(steps) + 1;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    if (k % row + 1 < row)
    {
      add(samples[k], samples[k + 1]);
    }
    if (k + row < samples.size())
    {
      add(samples[k], samples[k + row]);
    }
  }
  return crossings;
}

void RandomPoses()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(20000));
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const int poses = 300;
  int crossed = 0;
  for (int k = 0; k < poses; ++k)
  {
    const NURBSSurface shapes[] = { patches::Sphere(0.5), patches::Cylinder(0.4, 1.2),
      patches::Torus(0.7, 0.3), patches::FreeForm(5, 3, 8, 7, 0.8, random),
      patches::FreeForm(2, 4, 6, 9, 0.8, random, false),
      patches::Parallelogram({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }) };
    const Real3x3 rotation = RandomRotation(random);
    const Real3 by{ uniform(random), uniform(random), uniform(random) };
    const NURBSSurface patch = patches::Mapped(
      shapes[k % 6], [&](const Real3& x) { return sb::PlusScaled(Turned(x, rotation), 1.0, by); });
    const DesignedSurface designed = OneFace(patch, 3, 3);
    const NURBSSection section = SectionOf(made, designed, 2e-3);
    CheckCurves(made, designed, section, 2e-3);
    crossed += section.Curves.empty() ? 0 : 1;
    // Nothing that the grid shows is missed, unless all of it is narrower than two spacings.
    Real3 lower{ 9, 9, 9 };
    Real3 upper{ -9, -9, -9 };
    for (const Real3& x : CrossingsOfGrid(patch, 150))
    {
      if (DistanceToCurves(x, section) > 5e-3)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          lower[axis] = std::min(lower[axis], x[axis]);
          upper[axis] = std::max(upper[axis], x[axis]);
        }
      }
    }
    CHECK(lower[0] > upper[0] || Gap(lower, upper) <= 2.0 * made.Spacing);
    // And nothing is found where nothing is.
    for (const NURBSCurve& curve : section.Curves)
    {
      for (const Real3& x : curve.Points)
      {
        CHECK(std::abs(sb::Length(x) - 1.0) < 1e-5);
      }
      CHECK(k % 10 != 0 || ChordError(made, designed, curve) <= 2e-3);
      const bool isOpen = curve.Begin == CurveEnd::MeshBorder && curve.End == CurveEnd::MeshBorder;
      CHECK(curve.Closed || isOpen);
    }
  }
  CHECK(crossed > poses / 2);
}

bool AreEqual(const NURBSSection& a, const NURBSSection& b)
{
  return std::equal(a.Curves.begin(), a.Curves.end(), b.Curves.begin(), b.Curves.end(),
    [](const NURBSCurve& x, const NURBSCurve& y) {
      return x.Points == y.Points && x.UV == y.UV && x.FaceId == y.FaceId;
    });
}

void NothingElseMatters()
{
  std::mt19937 random(10);
  clouds::Cloud cloud = clouds::Torus(8000, random);
  clouds::AddNoise(cloud, 0.003, random);
  DesignedSurface designed = Bar(0.8, 0.7, 40);
  AddFace(designed, Moved(patches::Sphere(0.5), { 0.8, 0.1, 0.1 }), 8, 8);
  const NURBSSection one = SectionOf(clouds::SurfaceOf(cloud), designed, 1e-3, 1);
  CHECK(one.Curves.size() > 1);
  CHECK(AreEqual(one, SectionOf(clouds::SurfaceOf(cloud), designed, 1e-3, 3)));
  clouds::Cloud permuted;
  std::vector<std::size_t> order(static_cast<std::size_t>(cloud.Count()));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::shuffle(order.begin(), order.end(), random);
  for (const std::size_t i : order)
  {
    permuted.Add({ cloud.Points[3 * i], cloud.Points[3 * i + 1], cloud.Points[3 * i + 2] },
      { cloud.Normals[3 * i], cloud.Normals[3 * i + 1], cloud.Normals[3 * i + 2] });
  }
  CHECK(AreEqual(one, SectionOf(clouds::SurfaceOf(permuted), designed, 1e-3, 2)));
}

class Impatient : public sb::Monitor
{
public:
  explicit Impatient(int patience)
    : Left(patience)
  {
  }
  bool Aborted() override { return --this->Left < 0; }

private:
  std::atomic<int> Left;
};

void Aborts()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(5000));
  const DesignedSurface bar = Bar(0.5, 2.0, 40);
  for (const int patience : { 0, 1, 5, 50, 500 })
  {
    sb::ThreadExecutor executor(2);
    Impatient monitor(patience);
    const NURBSSection section =
      sb::IntersectPatches(*made.Surface, bar, { made.Spacing, 1e-3 }, executor, monitor);
    CHECK(section.Aborted);
    CHECK(section.Curves.empty());
  }
}

} // namespace

int main()
{
  CirclesOnASphere();
  TrimmedPatches();
  CheckeredFaces();
  OverEdges();
  Directions();
  OverRoundEdges();
  CoincidentAndTangential();
  OpenScans();
  RandomPoses();
  NothingElseMatters();
  Aborts();
  return check::Verdict("TestNURBSSection");
}
