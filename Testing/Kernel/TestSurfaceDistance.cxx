// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceDistance.cxx
 * @brief Signs against winding numbers: nearest to faces, edges and vertices, at spikes and
 * saddles, with split points, far away; the winding number itself; open and non-manifold surfaces;
 * threads.
 */
#include "Check.h"
#include "DistanceSampling.h"
#include "FastWinding.h"
#include "NearestReference.h"
#include "Shapes.h"
#include "SurfaceDistance.h"
#include "ThreadExecutor.h"

#include <cstring>
#include <limits>
#include <set>

namespace
{

using namespace shapes;
using sb::SignRule;
using sb::Vector3;

Vector3 ToVector(const Point& p) { return { p[0], p[1], p[2] }; }

Point Direction(Random& random)
{
  for (;;)
  {
    const Point p{ Uniform(random, -1, 1), Uniform(random, -1, 1), Uniform(random, -1, 1) };
    if (Length(p) < 1.0 && Length(p) > 0.1)
    {
      return (1.0 / Length(p)) * p;
    }
  }
}

/** A cone of `sides` faces whose apex is a needle; with `dent` its foot is drawn in, too. */
Mesh Spike(int sides, double height, double dent)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, height }, { 0, 0, dent } };
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * i / sides;
    mesh.Points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
  }
  for (int i = 0; i < sides; ++i)
  {
    const std::int32_t a = 2 + i;
    const std::int32_t b = 2 + (i + 1) % sides;
    mesh.Triangles.push_back({ 0, a, b });
    mesh.Triangles.push_back({ 1, b, a });
  }
  return mesh;
}

/** A closed body whose top has a vertex where mountains and valleys alternate. */
Mesh Saddle(int waves, double height, int skew)
{
  const int sides = 2 * waves;
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 0, 0, -3 } };
  for (int i = 0; i < sides; ++i)
  {
    // Mountains narrower than valleys: the mean of the faces' normals then looks astray.
    const double turn = (i + (i % 2 == 0 ? 0.3 * skew : -0.3 * skew)) / sides;
    const double angle = 2.0 * 3.14159265358979 * turn;
    mesh.Points.push_back(
      { std::cos(angle), std::sin(angle), i % 2 == 0 ? height : -0.5 * height });
  }
  for (int i = 0; i < sides; ++i)
  {
    const std::int32_t a = 2 + i;
    const std::int32_t b = 2 + (i + 1) % sides;
    mesh.Triangles.push_back({ 0, a, b });
    mesh.Triangles.push_back({ 1, b, a });
  }
  return mesh;
}

/** Every triangle with three points of its own. */
Mesh Split(const Mesh& mesh)
{
  Mesh split;
  for (const Corners& corners : mesh.Triangles)
  {
    const std::int32_t first = static_cast<std::int32_t>(split.Points.size());
    for (std::size_t k = 0; k < 3; ++k)
    {
      split.Points.push_back(mesh.At(corners, k));
    }
    split.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return split;
}

/** Signs at points around every vertex, edge and face, all kinds of which must have been nearest.
 */
void CheckSigns(const Mesh& mesh)
{
  sb::SerialExecutor one;
  const sb::SurfaceDistance surface(mesh.View(), true, false, one);
  const Mesh split = Split(mesh);
  const sb::SurfaceDistance apart(split.View(), true, false, one);
  Random random(4);
  std::set<int> kinds;
  for (const Corners& corners : mesh.Triangles)
  {
    for (int i = 0; i < 60; ++i)
    {
      const double s = i % 3 == 0 ? 0.0 : Uniform(random, 0, 1);
      const double t = i % 3 == 2 ? Uniform(random, 0, 1 - s) : 0.0;
      const Point on =
        (1 - s - t) * mesh.At(corners, 0) + s * mesh.At(corners, 1) + t * mesh.At(corners, 2);
      const Point p = on + std::pow(10.0, Uniform(random, -7, 0.5)) * Direction(random);
      const auto found = surface.At(ToVector(p), SignRule::Pseudonormal);
      kinds.insert(static_cast<int>(found.Where) / 3);
      const bool inside = Winding(mesh, p) > 0.5;
      CHECK_EQUAL(found.Distance < 0.0, inside);
      CHECK(std::fabs(std::fabs(found.Distance) - double(reference::ToMesh(mesh, p))) < 1e-14);
      CHECK_EQUAL(apart.At(ToVector(p), SignRule::Pseudonormal).Distance < 0.0, inside);
      CHECK_EQUAL(surface.At(ToVector(p), SignRule::WindingNumber).Distance < 0.0, inside);
      const Point far = on + 1e6 * Direction(random);
      CHECK(surface.At(ToVector(far), SignRule::Pseudonormal).Distance > 0.0);
    }
  }
  CHECK_EQUAL(kinds.size(), 3u);
  for (const Point& vertex : mesh.Points)
  {
    CHECK(surface.At(ToVector(vertex), SignRule::Pseudonormal).Distance == 0.0);
  }
}

void TestSigns()
{
  for (const double height : { 0.1, 1.0, 10.0, 300.0 })
  {
    CheckSigns(Spike(3, height, -0.1));
    CheckSigns(Spike(7, height, 0.5 * height));
    CheckSigns(Spike(40, height, 0.9 * height));
  }
  for (const double height : { 0.3, 1.0, 2.5 })
  {
    for (int skew = -1; skew <= 1; ++skew)
    {
      CheckSigns(Saddle(2, height, skew));
      CheckSigns(Saddle(3, height, skew));
      CheckSigns(Saddle(5, height, skew));
    }
  }
  CheckSigns(Cube(-1, 1));
  CheckSigns(Sphere({ 0, 0, 0 }, 1.0, 4));
}

/** A mean of the faces' normals without weights fails at a corner of a cube cut into many
 * triangles; the pseudonormal does not, nor does it change with the triangulation. */
void TestPseudonormalsDoNotDependOnTheTriangulation()
{
  Mesh mesh = Cube(0, 1);
  sb::SerialExecutor one;
  for (int round = 0; round < 2; ++round)
  {
    const sb::SurfaceDistance surface(mesh.View(), true, false, one);
    const auto found = surface.At({ 2, 2, 2 }, SignRule::Pseudonormal);
    const Vector3 normal = surface.Pseudonormal(found.Triangle, found.Where);
    for (const double coordinate : { normal.X, normal.Y, normal.Z })
    {
      CHECK(std::fabs(coordinate - 1 / std::sqrt(3.0)) < 1e-15);
    }
    // Cut each triangle at the corner (1, 1, 1) in two, but only on the side z = 1.
    std::vector<Corners> triangles;
    for (const Corners& corners : mesh.Triangles)
    {
      const bool top =
        mesh.At(corners, 0)[2] + mesh.At(corners, 1)[2] + mesh.At(corners, 2)[2] == 3;
      if (!top)
      {
        triangles.push_back(corners);
        continue;
      }
      const std::int32_t middle = static_cast<std::int32_t>(mesh.Points.size());
      const Point centre =
        (1.0 / 3.0) * (mesh.At(corners, 0) + mesh.At(corners, 1) + mesh.At(corners, 2));
      mesh.Points.push_back({ centre[0], centre[1], 1.0 });
      for (std::size_t k = 0; k < 3; ++k)
      {
        triangles.push_back({ corners[k], corners[(k + 1) % 3], middle });
      }
    }
    mesh.Triangles = triangles;
  }
}

/** Where four faces meet in an edge, and with a face without area in an edge, the surface is closed
 * all the same. */
void TestNonManifoldAndDegenerateButClosed()
{
  Mesh mesh = Box({ 0, 0, 0 }, { 1, 1, 1 });
  mesh.Append(Box({ 1, 1, 0 }, { 2, 2, 1 }));
  CheckSigns(mesh);

  // A cut edge with a triangle in it that closes the gap of width nothing.
  Mesh stitched = Cube(-1, 1);
  const Corners cut = stitched.Triangles.front();
  const std::int32_t middle = static_cast<std::int32_t>(stitched.Points.size());
  stitched.Points.push_back(0.5 * (stitched.At(cut, 0) + stitched.At(cut, 1)));
  stitched.Triangles.front() = { middle, cut[1], cut[2] };
  stitched.Triangles.push_back({ cut[0], middle, cut[2] });
  stitched.Triangles.push_back({ cut[0], cut[1], middle });
  CheckSigns(stitched);
}

void TestOpenSurfaces()
{
  const Mesh sheet = Sheet({ 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 });
  sb::SerialExecutor one;
  const sb::SurfaceDistance surface(sheet.View(), false, false, one);
  Random random(5);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 p{ Uniform(random, -9, 9), Uniform(random, -9, 9), Uniform(random, -9, 9) };
    const double distance = surface.At(p, SignRule::Pseudonormal).Distance;
    CHECK_EQUAL(distance > 0.0, p.Z > 0.0);
    CHECK(surface.At(p, SignRule::Unsigned).Distance == std::fabs(distance));
  }
}

void TestWindingNumbers()
{
  sb::ThreadExecutor two(2);
  Random random(6);
  Mesh holed = Sphere({ 0, 0, 0 }, 1.0, 30);
  holed.Triangles.resize(holed.Triangles.size() * 9 / 10);
  for (const Mesh& mesh : { Sphere({ 0, 0, 0 }, 1.0, 30), holed, Spike(30, 5.0, 2.0) })
  {
    sb::NearestTriangle tree;
    tree.Build(mesh.View(), two);
    sb::FastWinding winding;
    winding.Build(tree, two);
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i)
    {
      const Point p = std::pow(10.0, Uniform(random, -1, 1)) * Direction(random);
      worst = std::max(worst, std::fabs(winding.At(ToVector(p)) - Winding(mesh, p)));
    }
    CHECK(worst < 0.05);
    CHECK(worst > 0.0); // it is an approximation, or this compares a thing with itself
  }
}

void TestThreadsAndOrderDoNotMatter()
{
  const Mesh mesh = Saddle(5, 1.0, 1);
  Random random(8);
  std::vector<double> points;
  for (int i = 0; i < 3 * 20000; ++i)
  {
    points.push_back(Uniform(random, -2, 2));
  }
  points[7] = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = points.size() / 3;
  std::vector<std::vector<double>> results;
  for (const int threads : { 1, 2, 5 })
  {
    sb::ThreadExecutor executor(threads);
    const sb::SurfaceDistance surface(mesh.View(), true, false, executor);
    std::vector<double> all(7 * count);
    std::vector<std::int32_t> triangles(count);
    sb::DistanceRequest request;
    request.Points = points.data();
    request.Count = static_cast<std::int64_t>(count);
    sb::DistanceArrays arrays;
    arrays.Distance = all.data();
    arrays.Nearest = all.data() + count;
    arrays.Direction = all.data() + 4 * count;
    arrays.Triangle = triangles.data();
    sb::Monitor monitor;
    CHECK(sb::SampleDistances(surface, request, arrays, executor, monitor));
    CHECK_EQUAL(triangles[2], -1);
    for (std::size_t i = 0; i < count; i += 17)
    {
      const auto alone = surface.At(sb::PointAt(points.data(), i), request.Rule);
      CHECK_EQUAL(alone.Triangle, triangles[i]);
      CHECK(std::isnan(alone.Distance) || alone.Distance == all[i]);
    }
    results.push_back(all);
  }
  for (const std::vector<double>& other : results)
  {
    CHECK(std::memcmp(other.data(), results[0].data(), other.size() * sizeof(double)) == 0);
  }
}

} // namespace

int main()
{
  TestSigns();
  TestPseudonormalsDoNotDependOnTheTriangulation();
  TestNonManifoldAndDegenerateButClosed();
  TestOpenSurfaces();
  TestWindingNumbers();
  TestThreadsAndOrderDoNotMatter();
  return check::Verdict("TestSurfaceDistance");
}
