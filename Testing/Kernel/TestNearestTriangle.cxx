// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNearestTriangle.cxx
 * @brief The nearest triangle against all triangles in long double: slender and degenerate ones, at
 * any scale, offset and distance, whatever the guess.
 */
#include "Check.h"
#include "NearestReference.h"
#include "NearestTriangle.h"
#include "Shapes.h"
#include "ThreadExecutor.h"

#include <limits>

namespace
{

using namespace shapes;
constexpr double everywhere = std::numeric_limits<double>::infinity();

sb::Vector3 ToVector(const Point& p) { return { p[0], p[1], p[2] }; }

Point Anywhere(Random& random, double size)
{
  return { Uniform(random, -size, size), Uniform(random, -size, size),
    Uniform(random, -size, size) };
}

Mesh Soup(Random& random, int count, double triangleSize)
{
  Mesh soup;
  for (int i = 0; i < count; ++i)
  {
    const Point middle = Anywhere(random, 1.0);
    for (int corner = 0; corner < 3; ++corner)
    {
      soup.Points.push_back(middle + Anywhere(random, triangleSize));
    }
    soup.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return soup;
}

/** Needles, points, segments and folded triangles. */
Mesh Degenerate(Random& random, int count)
{
  Mesh soup = Soup(random, count, 0.3);
  for (std::size_t i = 0; i < soup.Triangles.size(); ++i)
  {
    Point* const p = &soup.Points[3 * i];
    switch (i % 5)
    {
      case 0:
        p[2] = p[0];
        break;
      case 1:
        p[2] = p[1] = p[0];
        break;
      case 2:
        p[2] = 0.25 * p[0] + 0.75 * p[1];
        break;
      case 3:
        p[2] = 0.5 * p[0] + 0.5 * p[1] + Anywhere(random, std::pow(10.0, Uniform(random, -16, -1)));
        break;
      default:
        break;
    }
  }
  return soup;
}

Mesh Placed(Mesh mesh, double scale, const Point& offset)
{
  for (Point& p : mesh.Points)
  {
    p = scale * p + offset;
  }
  return mesh;
}

/** @param size of the mesh. @param reach how far the queries go, in sizes. */
void CheckAgainstAll(const Mesh& mesh, double size, const Point& centre, double reach, int count)
{
  sb::ThreadExecutor two(2);
  sb::NearestTriangle tree;
  tree.Build(mesh.View(), two);
  Random random(7);
  const double unit = size * std::max(1.0, reach);
  for (int i = 0; i < count; ++i)
  {
    Point p = centre + reach * size * Anywhere(random, 1.0);
    if (i % 3 == 0) // on a triangle, or very near
    {
      const Corners& corners = mesh.Triangles[static_cast<std::size_t>(i) % mesh.Triangles.size()];
      const double s = Uniform(random, 0, 1);
      p = (1 - s) * mesh.At(corners, 0) + 0.5 * s * mesh.At(corners, 1) +
        0.5 * s * mesh.At(corners, 2) +
        size * Anywhere(random, i % 2 ? 0.0 : std::pow(10.0, Uniform(random, -12, 0)));
    }
    const sb::NearestTriangle::Answer found = tree.Find(ToVector(p), everywhere, -1);
    const double distance = std::sqrt(found.SquaredDistance) / tree.Scale();
    CHECK(found.Triangle >= 0);
    CHECK(std::fabs(distance - double(reference::ToMesh(mesh, p))) <= 1e-14 * unit);
    const Corners& corners = mesh.Triangles[static_cast<std::size_t>(found.Triangle)];
    CHECK(std::fabs(distance -
            double(reference::ToTriangle(
              mesh.At(corners, 0), mesh.At(corners, 1), mesh.At(corners, 2), p))) <= 1e-14 * unit);
    const std::int32_t guess =
      static_cast<std::int32_t>(static_cast<std::size_t>(7 * i) % mesh.Triangles.size());
    const sb::NearestTriangle::Answer again = tree.Find(ToVector(p), everywhere, guess);
    CHECK_EQUAL(again.Triangle, found.Triangle);
    CHECK(again.SquaredDistance == found.SquaredDistance);
  }
}

void TestAnyMesh()
{
  Random random(1);
  const Mesh meshes[] = { Soup(random, 1, 1.0), Soup(random, 9, 0.5), Soup(random, 700, 0.05),
    Degenerate(random, 600), Sphere({ 0, 0, 0 }, 1.0, 12) };
  for (const Mesh& mesh : meshes)
  {
    for (const double reach : { 1.0, 2.0, 30.0, 1e6 })
    {
      CheckAgainstAll(mesh, 1.0, { 0, 0, 0 }, reach, 300);
    }
  }
}

void TestAnyScaleAndPlace()
{
  Random random(2);
  const Mesh mesh = Degenerate(random, 300);
  for (const double scale : { 1e-120, 1e-9, 1e9, 1e120 })
  {
    CheckAgainstAll(Placed(mesh, scale, { 0, 0, 0 }), scale, { 0, 0, 0 }, 2.0, 200);
  }
  // Coordinates a million sizes off the origin have that many units less in their last places.
  CheckAgainstAll(Placed(mesh, 1.0, { 1e6, -2e6, 3e6 }), 1.0, { 1e6, -2e6, 3e6 }, 2.0, 200);
}

void TestBeyondAllDistances()
{
  const Mesh mesh = Sphere({ 0, 0, 0 }, 1.0, 12);
  sb::SerialExecutor one;
  sb::NearestTriangle tree;
  tree.Build(mesh.View(), one);
  Random random(3);
  for (const double far : { 1e8, 1e9, 1e15, 1e100, 1e200 })
  {
    const Point direction = Anywhere(random, 1.0);
    const auto found = tree.Find(ToVector((far / Length(direction)) * direction), everywhere, -1);
    CHECK(found.Triangle >= 0);
    const double distance = std::hypot(found.Place.X, found.Place.Y, found.Place.Z) / tree.Scale();
    CHECK(std::fabs(distance - (far - 1.0)) <= 0.02 + 1e-15 * far);
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_EQUAL(tree.Find({ none, 0, 0 }, everywhere, -1).Triangle, -1);
  CHECK_EQUAL(tree.Find({ 0, everywhere, 0 }, everywhere, 0).Triangle, -1);
}

/** Of equal ones the triangle with the smallest number, whatever the guess. */
void TestTiesAndLimits()
{
  Mesh mesh = Sphere({ 0, 0, 0 }, 1.0, 6);
  const std::vector<Corners> once = mesh.Triangles;
  mesh.Triangles.insert(mesh.Triangles.end(), once.begin(), once.end());
  sb::SerialExecutor one;
  sb::NearestTriangle tree;
  tree.Build(mesh.View(), one);
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    std::int32_t first = 0;
    while (std::count(once[static_cast<std::size_t>(first)].begin(),
             once[static_cast<std::size_t>(first)].end(), static_cast<std::int32_t>(i)) == 0)
    {
      ++first;
    }
    const sb::Vector3 outside = 2.0 * ToVector(mesh.Points[i]);
    for (const std::int32_t guess : { -1, 0, static_cast<std::int32_t>(once.size()) })
    {
      CHECK_EQUAL(tree.Find(outside, everywhere, guess).Triangle, first);
    }
    const double distance =
      std::sqrt(tree.Find(outside, everywhere, -1).SquaredDistance) / tree.Scale();
    CHECK_EQUAL(tree.Find(outside, distance * (1 + 1e-12), 0).Triangle, first);
    CHECK_EQUAL(tree.Find(outside, distance * (1 - 1e-12), 0).Triangle, -1);
  }
}

void TestEmptyAndMemory()
{
  sb::SerialExecutor one;
  sb::NearestTriangle tree;
  tree.Build({}, one);
  CHECK(tree.IsEmpty());
  CHECK_EQUAL(tree.Find({ 0, 0, 0 }, everywhere, -1).Triangle, -1);
  tree.Build(Sphere({ 0, 0, 0 }, 1.0, 60).View(), one);
  CHECK(tree.BytesATriangle() < 75.0);
}

} // namespace

int main()
{
  TestAnyMesh();
  TestAnyScaleAndPlace();
  TestBeyondAllDistances();
  TestTiesAndLimits();
  TestEmptyAndMemory();
  return check::Verdict("TestNearestTriangle");
}
