// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMeshSection.cxx
 * @brief Curves of clouds with meshes: points in the planes of their triangles and on the surface,
 * chord errors under their bound, every loop and branch there, ends told, areas reported.
 */
#include "Check.h"
#include "Clouds.h"
#include "Designed.h"
#include "MeshSection.h"
#include "PlaneSection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using sb::CurveEnd;
using sb::Real3;

sb::MeshSection SectionOf(
  const sb::CloudSurface& cloud, const shapes::Mesh& mesh, double chordError, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  return sb::IntersectMesh(
    *cloud.Surface, designed::FromMesh(mesh), { cloud.Spacing, chordError }, executor, monitor);
}

double LengthOf(const sb::MeshSectionCurve& curve)
{
  double length = 0.0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    length += sb::Length(sb::Difference(curve.Points[i], curve.Points[i - 1]));
  }
  return length;
}

double LengthOf(const sb::MeshSection& section)
{
  double length = 0.0;
  for (const sb::MeshSectionCurve& curve : section.Curves)
  {
    length += LengthOf(curve);
  }
  return length;
}

Real3 At(const shapes::Mesh& mesh, std::int32_t triangle, std::size_t k)
{
  return mesh.At(mesh.Triangles[static_cast<std::size_t>(triangle)], k);
}

Real3 NormalOf(const shapes::Mesh& mesh, std::int32_t triangle)
{
  const Real3 a = At(mesh, triangle, 0);
  const Real3 n =
    sb::Cross(sb::Difference(At(mesh, triangle, 1), a), sb::Difference(At(mesh, triangle, 2), a));
  return sb::Scaled(n, 1.0 / sb::Length(n));
}

/** How far a point is outside of a triangle within its plane. */
double Outside(const shapes::Mesh& mesh, std::int32_t triangle, const Real3& x)
{
  double outside = 0.0;
  const Real3 normal = NormalOf(mesh, triangle);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Real3 a = At(mesh, triangle, k);
    const Real3 along = sb::Difference(At(mesh, triangle, (k + 1) % 3), a);
    outside = std::max(
      outside, sb::Dot(sb::Cross(along, normal), sb::Difference(x, a)) / sb::Length(along));
  }
  return outside;
}

/** What holds of every curve: in its triangles, on the surface, its chord error measured anew. */
void CheckCurves(const sb::CloudSurface& cloud, const shapes::Mesh& mesh,
  const sb::MeshSection& section, double bound)
{
  sb::MovingLeastSquares::Neighbourhood near;
  CHECK(section.Status == sb::MeshSectionStatus::Ok);
  for (const sb::MeshSectionCurve& curve : section.Curves)
  {
    CHECK_EQUAL(curve.Triangles.size() + 1, curve.Points.size());
    CHECK((curve.Points.front() == curve.Points.back()) == curve.Closed);
    CHECK((curve.Ends[0] == CurveEnd::None) == curve.Closed);
    CHECK((curve.Ends[1] == CurveEnd::None) == curve.Closed);
    CHECK(curve.LargestChordError <= bound);
    for (std::size_t i = 0; i + 1 < curve.Points.size(); ++i)
    {
      const std::int32_t triangle = curve.Triangles[i];
      const Real3 normal = NormalOf(mesh, triangle);
      const Real3 along = sb::Difference(curve.Points[i + 1], curve.Points[i]);
      for (const Real3& x : { curve.Points[i], curve.Points[i + 1] })
      {
        CHECK(std::abs(sb::Dot(sb::Difference(x, At(mesh, triangle, 0)), normal)) < 1e-13);
        CHECK(Outside(mesh, triangle, x) < 1e-9);
        CHECK(std::abs(cloud.Surface->EvaluateAt(x, 0, near).Value) < 1e-12);
      }
      for (const double t : { 0.2, 0.5, 0.8 })
      {
        const Real3 start = sb::PlusScaled(curve.Points[i], t, along);
        Real3 x = start;
        for (int iteration = 0; iteration < 6; ++iteration)
        {
          const sb::SurfaceValue f = cloud.Surface->EvaluateAt(x, 1, near);
          const Real3 inPlane = sb::WithoutPartAlong(f.Gradient, normal);
          x = sb::PlusScaled(x, -f.Value / sb::Dot(inPlane, inPlane), inPlane);
        }
        const Real3 off = sb::WithoutPartAlong(
          sb::Difference(x, start), sb::Scaled(along, 1.0 / sb::Length(along)));
        CHECK(sb::Length(off) <= bound);
      }
    }
  }
}

/** A corner of a box in the unit sphere: three quarter circles of radius sqrt(1 - d^2) and less,
 * in one loop. */
void ASphereAndABox()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(20000));
  const double d = 0.3;
  const shapes::Mesh box = shapes::Box({ d, d, d }, { 4, 4, 4 });
  const double radius = std::sqrt(1.0 - d * d);
  const double start = std::asin(d / radius);
  const double exact = 3.0 * radius * (clouds::Pi / 2.0 - 2.0 * start);
  std::size_t last = 0;
  for (const double bound : { 1e-3, 1e-4, 1e-5 })
  {
    const sb::MeshSection section = SectionOf(cloud, box, bound);
    CHECK_EQUAL(section.Curves.size(), 1u);
    CHECK(section.Curves.front().Closed && !section.Curves.front().IsTangential);
    CheckCurves(cloud, box, section, bound);
    CHECK(std::abs(LengthOf(section) - exact) < 10.0 * bound + 1e-4);
    const std::size_t points = section.Curves.front().Points.size();
    CHECK(last == 0 || (points > 2 * last && points < 5 * last));
    CHECK(last > 0 || points < 40); // not one for each small triangle
    last = points;
    CHECK(section.CoincidentArea == 0.0);
  }
}

/** The finer the mesh of a ball, the nearer the curve to the circle of two spheres. */
void ASphereAndABall()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(20000));
  // Centres 1.2 apart, radii 1 and 0.7.
  const double height = (1.44 + 1.0 - 0.49) / 2.4;
  const double circle = 2.0 * clouds::Pi * std::sqrt(1.0 - height * height);
  double last = 1.0;
  for (const int divisions : { 6, 12, 24, 96 })
  {
    const shapes::Mesh ball = shapes::Sphere({ 1.2, 0, 0 }, 0.7, divisions);
    const sb::MeshSection section = SectionOf(cloud, ball, 1e-4);
    CHECK_EQUAL(section.Curves.size(), 1u);
    CHECK(section.Curves.front().Closed);
    CheckCurves(cloud, ball, section, 1e-4);
    const double error = std::abs(LengthOf(section) - circle);
    CHECK(error < 0.4 * last || error < 1e-3);
    last = error;
  }
  CHECK(last < 1e-3);
}

/** A tube through a sphere, open and closed: two circles of the tube's radius. */
void ASphereAndATube()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(20000));
  const shapes::Mesh tube = shapes::Tube(0.5, -2.0, 2.0, 400); // long thin triangles
  const sb::MeshSection section = SectionOf(cloud, tube, 1e-4);
  CHECK_EQUAL(section.Curves.size(), 2u);
  CheckCurves(cloud, tube, section, 1e-4);
  for (const sb::MeshSectionCurve& curve : section.Curves)
  {
    CHECK(curve.Closed);
    CHECK(std::abs(LengthOf(curve) - clouds::Pi) < 1e-3);
  }
}

/** A sheet of two large triangles is a plane: the same curves. */
void ALargeSheetIsAPlane()
{
  std::mt19937 random(3);
  clouds::Cloud points = clouds::Torus(20000, random);
  clouds::AddNoise(points, 0.004, random);
  const sb::CloudSurface cloud = clouds::SurfaceOf(points);
  const shapes::Mesh sheet =
    shapes::Sheet({ -50, -41, -5 }, { 52, -40, -5 }, { 50, 43, 5.1 }, { -52, 42, 5.1 });
  for (const double bound : { 3e-3, 3e-4 })
  {
    sb::ThreadExecutor executor(2);
    sb::Monitor monitor;
    const sb::PlaneSection plane = sb::IntersectPlane(
      *cloud.Surface, At(sheet, 0, 0), NormalOf(sheet, 0), bound, executor, monitor);
    const sb::MeshSection section = SectionOf(cloud, sheet, bound);
    CHECK_EQUAL(section.Curves.size(), plane.Curves.size());
    CHECK_EQUAL(section.Curves.size(), 2u);
    double length = 0.0;
    for (const sb::SectionCurve& curve : plane.Curves)
    {
      for (std::size_t i = 1; i < curve.Points.size(); ++i)
      {
        length += sb::Length(sb::Difference(curve.Points[i], curve.Points[i - 1]));
      }
    }
    CHECK(std::abs(LengthOf(section) - length) < 20.0 * bound);
  }
}

/** Random boxes in the sphere, against the arcs of the circles of their faces' planes. */
void NoLoopIsMissedInManyPoses()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(5000));
  shapes::Random random(4);
  long loops = 0;
  for (int pose = 0; pose < 500; ++pose)
  {
    const shapes::Point half{ shapes::Uniform(random, 0.3, 3.0), shapes::Uniform(random, 0.3, 3.0),
      shapes::Uniform(random, 0.3, 3.0) };
    const shapes::Point by{ shapes::Uniform(random, -2.0, 2.0), shapes::Uniform(random, -2.0, 2.0),
      shapes::Uniform(random, -2.0, 2.0) };
    const std::array<shapes::Point, 3> turn = shapes::RandomRotation(random);
    const shapes::Mesh box =
      shapes::Rotated(shapes::Box({ -half[0], -half[1], -half[2] }, half).Translated(by), turn);
    // In the frame of the box the sphere stays where it is.
    double exact = 0.0;
    double least = 2.0; // of all inner circles, the radius
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const double side : { -1.0, 1.0 })
      {
        const double height = by[axis] + side * half[axis];
        if (std::abs(height) >= 1.0)
        {
          continue;
        }
        const double radius = std::sqrt(1.0 - height * height);
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        constexpr int steps = 2000;
        int inside = 0;
        for (int k = 0; k < steps; ++k)
        {
          const double angle = 2.0 * clouds::Pi * k / steps;
          inside += std::abs(radius * std::cos(angle) - by[u]) < half[u] &&
            std::abs(radius * std::sin(angle) - by[v]) < half[v];
        }
        exact += 2.0 * clouds::Pi * radius * inside / steps;
        loops += inside == steps;
        least = inside > 0 ? std::min(least, radius) : least;
      }
    }
    const sb::MeshSection section = SectionOf(cloud, box, 2e-3);
    CHECK(section.Status == sb::MeshSectionStatus::Ok);
    for (const sb::MeshSectionCurve& curve : section.Curves)
    {
      CHECK(curve.Closed); // as box and sphere are
      CHECK(curve.LargestChordError <= 2e-3);
    }
    if (least > cloud.Spacing)
    {
      // Chords, the sampling above at the ends of arcs, and the surface's own error.
      CHECK(std::abs(LengthOf(section) - exact) < 0.05);
    }
  }
  CHECK(loops > 100); // of them within one face of two triangles
}

/** Small loops inside of one triangle, down to a width of two spacings. */
void LoopsInsideOfATriangleAreFound()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(20000));
  shapes::Random random(5);
  for (int pose = 0; pose < 200; ++pose)
  {
    const double radius = cloud.Spacing * shapes::Uniform(random, 1.0, 3.0);
    const double height = std::sqrt(1.0 - radius * radius);
    const shapes::Mesh triangle =
      shapes::Rotated(shapes::Triangle({ -9 + shapes::Uniform(random, 0, 1), -8, height },
                        { 10, -7, height }, { 0, 9 + shapes::Uniform(random, 0, 1), height }),
        shapes::RandomRotation(random));
    const sb::MeshSection section = SectionOf(cloud, triangle, 1e-3);
    CHECK_EQUAL(section.Curves.size(), 1u);
    CHECK(section.Curves.empty() || section.Curves.front().Closed);
    CHECK(std::abs(LengthOf(section) - 2.0 * clouds::Pi * radius) < 0.02 + 0.1 * radius);
    CHECK(section.Curves.empty() || section.Curves.front().IsTangential == (radius < 0.0999) ||
      std::abs(radius - 0.1) < 0.01);
  }
}

/** A strip that the tube of a cloud sticks out of by a fraction of a triangle: both its sides. */
void ThinStripsAreFound()
{
  clouds::Cloud points;
  for (int i = 0; i < 20000; ++i) // a tube of radius 1 along y
  {
    const double a = 2.0 * clouds::Pi * i * 0.6180339887498949;
    points.Add(
      { std::cos(a), 8.0 * i / 20000.0 - 4.0, std::sin(a) }, { std::cos(a), 0, std::sin(a) });
  }
  const sb::CloudSurface cloud = clouds::SurfaceOf(points);
  const double halfWidth = 0.3 * cloud.Spacing;
  const double height = std::sqrt(1.0 - halfWidth * halfWidth) + 0.0;
  const shapes::Mesh sheet = shapes::Sheet(
    { -7, -2.1, height }, { 9.3, -2, height }, { 8.4, 2, height }, { -8, 2.2, height });
  const sb::MeshSection section = SectionOf(cloud, sheet, 1e-4);
  double length = 0.0;
  for (const sb::MeshSectionCurve& curve : section.Curves)
  {
    CHECK(curve.IsTangential);
    length += LengthOf(curve);
  }
  CHECK(std::abs(length - 8.2) < 0.6);
}

void SliversAndTrianglesWithoutAreaDoNoHarm()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(5000));
  // A plane through the sphere as a fan of slivers, some of them without any area, and on edge.
  shapes::Mesh fan;
  const shapes::Point centre{ -5.0, 0.3, 0.2 };
  std::vector<shapes::Point> rim;
  for (const double y : { -6.0, -0.3, -0.3 + 1e-9, 0.1, 0.1, 0.1 + 1e-13, 0.6, 6.0 })
  {
    rim.push_back({ 5.0, y, 0.2 });
  }
  for (std::size_t k = 1; k < rim.size(); ++k)
  {
    fan.AddTriangle(centre, rim[k - 1], rim[k]);
  }
  const sb::MeshSection section = SectionOf(cloud, fan, 1e-3);
  CHECK_EQUAL(section.Curves.size(), 1u);
  CHECK(section.Curves.front().Closed);
  CHECK(std::abs(LengthOf(section) - 2.0 * clouds::Pi * std::sqrt(1.0 - 0.04)) < 0.02);
  // A line across the sphere, as a triangle, meets it nowhere; one without extent neither.
  const sb::MeshSection line =
    SectionOf(cloud, shapes::Triangle({ -2, 0, 0 }, { 0, 0, 0 }, { 2, 0, 0 }), 1e-3);
  CHECK(line.Status == sb::MeshSectionStatus::Ok);
  CHECK(
    SectionOf(cloud, shapes::Triangle({ 1, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }), 1e-3).Curves.empty());
  CHECK(SectionOf(cloud, shapes::Mesh(), 1e-3).Curves.empty());
  CHECK(SectionOf(cloud, shapes::Cube(5, 6), 1e-3).Curves.empty());
}

/** Corners and edges of the mesh on the surface itself: zeros are no special case. */
void ZerosAtCornersAreNoSpecialCase()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Plane(60)); // z = 0 over the unit square
  shapes::Mesh roof; // two slopes that touch z = 0 along their ridge or cross it, corners at z = 0
  roof.Append(
    shapes::Sheet({ 0.2, 0.2, 0 }, { 0.8, 0.2, 0 }, { 0.8, 0.5, 0.3 }, { 0.2, 0.5, 0.3 }));
  roof.Append(
    shapes::Sheet({ 0.2, 0.2, -0.3 }, { 0.8, 0.2, -0.3 }, { 0.8, 0.2, 0 }, { 0.2, 0.2, 0 }));
  const sb::MeshSection section = SectionOf(cloud, roof, 1e-3);
  CHECK_EQUAL(section.Curves.size(), 1u);
  CHECK(std::abs(LengthOf(section) - 0.6) < 1e-6);
  for (const sb::MeshSectionCurve& curve : section.Curves)
  {
    CHECK(curve.Ends[0] == CurveEnd::MeshBorder && curve.Ends[1] == CurveEnd::MeshBorder);
  }
}

void EndsAreTold()
{
  const sb::CloudSurface ball = clouds::SurfaceOf(clouds::Sphere(20000));
  const sb::MeshSection half = SectionOf(
    ball, shapes::Sheet({ 0, -3, -3 }, { 0, 3, -3 }, { 0, 3, 0.5 }, { 0, -3, 0.5 }), 1e-3);
  CHECK_EQUAL(half.Curves.size(), 1u);
  for (const sb::MeshSectionCurve& curve : half.Curves)
  {
    CHECK(curve.Ends[0] == CurveEnd::MeshBorder && curve.Ends[1] == CurveEnd::MeshBorder);
    CHECK(std::abs(curve.Points.front()[2] - 0.5) < 1e-12);
    CHECK(std::abs(curve.Points.back()[2] - 0.5) < 1e-12);
    CHECK(std::abs(LengthOf(curve) - (clouds::Pi + 2.0 * std::asin(0.5))) < 0.01);
  }
  const sb::CloudSurface square = clouds::SurfaceOf(clouds::Plane(60));
  const sb::MeshSection open = SectionOf(
    square, shapes::Sheet({ 0.5, 0.4, -1 }, { 4, 0.4, -1 }, { 4, 0.4, 1 }, { 0.5, 0.4, 1 }), 1e-3);
  CHECK_EQUAL(open.Curves.size(), 1u);
  for (const sb::MeshSectionCurve& curve : open.Curves)
  {
    const bool forwards = curve.Points.front()[0] < curve.Points.back()[0];
    CHECK(curve.Ends[forwards ? 0 : 1] == CurveEnd::MeshBorder);
    CHECK(curve.Ends[forwards ? 1 : 0] == CurveEnd::ScanBorder);
    CHECK(std::abs(std::max(curve.Points.front()[0], curve.Points.back()[0]) - 1.0) <
      3.0 * square.Spacing);
  }
  // Three sheets with one edge in common.
  shapes::Mesh book;
  for (const double angle : { 0.1, 2.0, 4.5 })
  {
    const shapes::Point to{ 2.0 * std::cos(angle), 2.0 * std::sin(angle), 0 };
    book.Append(
      shapes::Sheet({ 0, 0, -3 }, { to[0], to[1], -3 }, { to[0], to[1], 3 }, { 0, 0, 3 }));
  }
  const sb::MeshSection leaves = SectionOf(ball, book, 1e-3);
  CHECK_EQUAL(leaves.Curves.size(), 3u);
  for (const sb::MeshSectionCurve& curve : leaves.Curves)
  {
    CHECK(curve.Ends[0] == CurveEnd::Junction && curve.Ends[1] == CurveEnd::Junction);
    CHECK(std::abs(LengthOf(curve) - clouds::Pi) < 0.01);
  }
}

/** Seen from the front of the mesh the inside is on the left. */
void InsideIsOnTheLeft()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(5000));
  const shapes::Mesh sheet =
    shapes::Sheet({ -3, -3, 0.2 }, { 3, -3, 0.2 }, { 3, 3, 0.2 }, { -3, 3, 0.2 });
  for (const bool reversed : { false, true })
  {
    const sb::MeshSection section = SectionOf(cloud, reversed ? sheet.Reversed() : sheet, 1e-3);
    CHECK_EQUAL(section.Curves.size(), 1u);
    double turn = 0.0;
    const std::vector<Real3>& x = section.Curves.front().Points;
    for (std::size_t i = 1; i < x.size(); ++i)
    {
      turn += x[i - 1][0] * x[i][1] - x[i - 1][1] * x[i][0];
    }
    CHECK(reversed ? turn < 0.0 : turn > 0.0);
  }
}

/** A noisy scan of a cube, and that cube: an area and no curves. Moved by a spacing: none. */
void AreasInCommonAreReported()
{
  std::mt19937 random(6);
  clouds::Cloud points;
  const int across = 50;
  for (int face = 0; face < 6; ++face)
  {
    for (int k = 0; k < across * across; ++k)
    {
      const double side = face % 2 == 0 ? -1.0 : 1.0;
      Real3 x{ side, 2.0 * (k % across + 0.5) / across - 1.0,
        2.0 * (k / across + 0.5) / across - 1.0 };
      Real3 n{ side, 0, 0 };
      std::rotate(x.begin(), x.begin() + face / 2, x.end());
      std::rotate(n.begin(), n.begin() + face / 2, n.end());
      points.Add(x, n);
    }
  }
  for (const double noise : { 0.0, 0.1, 0.4 })
  {
    clouds::Cloud scan = points;
    clouds::AddNoise(scan, noise * 2.0 / across, random);
    const sb::CloudSurface cloud = clouds::SurfaceOf(scan);
    const sb::MeshSection same = SectionOf(cloud, shapes::Cube(-1, 1), 1e-3);
    CHECK(same.CoincidentArea > 0.6 * 24.0 && same.CoincidentArea < 24.0);
    const sb::MeshSection moved =
      SectionOf(cloud, shapes::Cube(-1, 1).Translated({ 0.21, 0.1, 0.1 }), 1e-3);
    CHECK(moved.CoincidentArea == 0.0);
    CHECK_EQUAL(moved.Curves.size(), 1u);
    // Planes that meet at four degrees have a curve in common, and no area.
    const shapes::Mesh tilted = shapes::Sheet({ -0.6, -3, 1 - 0.042 }, { 0.6, -3, 1 + 0.042 },
      { 0.6, 3, 1 + 0.042 }, { -0.6, 3, 1 - 0.042 });
    const sb::MeshSection crossing = SectionOf(cloud, tilted, 1e-3);
    CHECK(crossing.CoincidentArea == 0.0);
    CHECK(LengthOf(crossing) > 1.5);
  }
}

void ThreadsAndTheOrderOfSamplesDoNotMatter()
{
  std::mt19937 random(7);
  const clouds::Cloud points = clouds::Torus(5000, random);
  std::vector<std::size_t> order(static_cast<std::size_t>(points.Count()));
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  clouds::Cloud shuffled;
  for (const std::size_t i : order)
  {
    const double* x = points.Points.data() + 3 * i;
    const double* n = points.Normals.data() + 3 * i;
    shuffled.Add({ x[0], x[1], x[2] }, { n[0], n[1], n[2] });
  }
  const shapes::Mesh mesh = shapes::Sphere({ 1, 0.1, 0 }, 0.6, 8);
  const sb::MeshSection one = SectionOf(clouds::SurfaceOf(points), mesh, 1e-3, 1);
  const sb::MeshSection other = SectionOf(clouds::SurfaceOf(shuffled), mesh, 1e-3, 3);
  CHECK(one.Curves.size() > 1);
  CHECK_EQUAL(one.Curves.size(), other.Curves.size());
  for (std::size_t i = 0; i < std::min(one.Curves.size(), other.Curves.size()); ++i)
  {
    CHECK(one.Curves[i].Points == other.Curves[i].Points);
    CHECK(one.Curves[i].Triangles == other.Curves[i].Triangles);
  }
}

} // namespace

int main()
{
  ASphereAndABox();
  ASphereAndABall();
  ASphereAndATube();
  ALargeSheetIsAPlane();
  NoLoopIsMissedInManyPoses();
  LoopsInsideOfATriangleAreFound();
  ThinStripsAreFound();
  SliversAndTrianglesWithoutAreaDoNoHarm();
  ZerosAtCornersAreNoSpecialCase();
  EndsAreTold();
  InsideIsOnTheLeft();
  AreasInCommonAreReported();
  ThreadsAndTheOrderOfSamplesDoNotMatter();
  return check::Verdict("TestMeshSection");
}
