// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCurveJoining.cxx
 * @brief Intersection curves: loops are closed, branches end at branch points, coinciding areas
 * have but an outline.
 */
#include "Check.h"
#include "CurveJoining.h"
#include "Shapes.h"

#include <map>
#include <set>

namespace
{

using namespace shapes;
using sb::Curves;
using sb::Operation;

/** How a set of curves hangs together. */
struct Summary
{
  std::size_t Loops = 0;
  std::size_t Open = 0;
  double Length = 0.0;
};

/** How far a point is from a triangle, by the nearest of a fine net of its points' planes and
 * edges. */
double Distance(const Mesh& mesh, std::int32_t triangle, const Point& p)
{
  const Corners& t = mesh.Triangles[static_cast<std::size_t>(triangle)];
  const Point normal = Cross(mesh.At(t, 1) - mesh.At(t, 0), mesh.At(t, 2) - mesh.At(t, 0));
  double outside = std::abs(Dot(normal, p - mesh.At(t, 0))) / shapes::Length(normal);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point edge = mesh.At(t, (i + 1) % 3) - mesh.At(t, i);
    const Point inwards = Cross(normal, edge);
    outside = std::max(outside, -Dot(inwards, p - mesh.At(t, i)) / shapes::Length(inwards));
  }
  return outside;
}

/** The arrays agree, no segment comes twice, every segment lies on its makers, and curves end only
 * where they have to. */
Summary Check(const Case& given, const Curves& curves)
{
  Summary summary;
  CHECK(!curves.Offsets.empty() && curves.Offsets.front() == 0);
  CHECK_EQUAL(curves.Offsets.back(), std::int32_t(curves.Connectivity.size()));
  const std::size_t polylines = curves.Offsets.size() - 1;
  CHECK_EQUAL(curves.Segments.size() + polylines, curves.Connectivity.size());
  CHECK_EQUAL(
    std::set<Point>(curves.Points.begin(), curves.Points.end()).size(), curves.Points.size());

  std::set<std::pair<std::int32_t, std::int32_t>> segments;
  std::map<std::int32_t, int> degree;
  std::size_t maker = 0;
  for (std::size_t line = 0; line < polylines; ++line)
  {
    const auto first = static_cast<std::size_t>(curves.Offsets[line]);
    const auto end = static_cast<std::size_t>(curves.Offsets[line + 1]);
    CHECK(end - first >= 2);
    for (std::size_t i = first; i + 1 < end; ++i, ++maker)
    {
      const std::int32_t a = curves.Connectivity[i];
      const std::int32_t b = curves.Connectivity[i + 1];
      CHECK(a != b && segments.insert(std::minmax(a, b)).second);
      ++degree[a];
      ++degree[b];
      const Point& from = curves.Points[static_cast<std::size_t>(a)];
      const Point& to = curves.Points[static_cast<std::size_t>(b)];
      summary.Length += shapes::Length(to - from);
      const Curves::Makers& makers = curves.Segments[maker];
      for (std::size_t side = 0; side < 2; ++side)
      {
        const Mesh& mesh = given.Operand(static_cast<std::size_t>(makers.Operand[side]));
        CHECK(Distance(mesh, makers.Triangle[side], from) < 1e-12);
        CHECK(Distance(mesh, makers.Triangle[side], to) < 1e-12);
      }
      CHECK(makers.Operand[0] != makers.Operand[1] || makers.Triangle[0] != makers.Triangle[1]);
    }
  }
  for (std::size_t line = 0; line < polylines; ++line)
  {
    const auto first = static_cast<std::size_t>(curves.Offsets[line]);
    const auto last = static_cast<std::size_t>(curves.Offsets[line + 1]) - 1;
    for (std::size_t i = first + 1; i < last; ++i)
    {
      CHECK_EQUAL(degree[curves.Connectivity[i]], 2);
    }
    const std::int32_t start = curves.Connectivity[first];
    const bool closed = start == curves.Connectivity[last];
    ++(closed ? summary.Loops : summary.Open);
    CHECK(closed || degree[start] != 2);
    CHECK(closed || degree[curves.Connectivity[last]] != 2);
  }
  return summary;
}

Summary CurvesOf(const Case& given)
{
  const CutStage stage(given);
  return Check(given, sb::JoinCurves(stage.World, stage.Cuts));
}

void CheckCounts(const Case& given, std::size_t loops, std::size_t open, double length)
{
  const Summary summary = CurvesOf(given);
  CHECK_EQUAL(summary.Loops, loops);
  CHECK_EQUAL(summary.Open, open);
  CHECK(std::abs(summary.Length - length) < 1e-12 * (1.0 + length));
}

void CheckCrossings()
{
  const Mesh cube = Cube(0, 4);
  CheckCounts({ { cube }, { Cube(2, 6) }, Operation::Union }, 1, 0, 12.0);
  CheckCounts({ { cube }, { Box({ 1, 1, -1 }, { 3, 3, 5 }) }, Operation::Union }, 2, 0, 16.0);
  CheckCounts({ { cube }, { Cube(5, 6) }, Operation::Union }, 0, 0, 0.0);
  CheckCounts({ { cube }, { Cube(1, 2) }, Operation::Union }, 0, 0, 0.0);
  // A plane through it, and one that ends inside.
  const Mesh plane = Sheet({ -9, -9, 1 }, { 9, -9, 1 }, { 9, 9, 1 }, { -9, 9, 1 });
  CheckCounts({ { cube }, { plane }, Operation::Difference }, 1, 0, 16.0);
  const Mesh part = Sheet({ -9, 1, 1 }, { 2, 1, 1 }, { 2, 3, 1 }, { -9, 3, 1 });
  CheckCounts({ { cube }, { part }, Operation::Difference }, 0, 1, 2.0);
  // Two boxes that leave a third through each other: four points where curves branch.
  const Case three{ { cube }, { Box({ 1, 1, -1 }, { 3, 3, 2 }), Box({ 2, 2, -2 }, { 5, 5, 1 }) },
    Operation::Union };
  const Summary summary = CurvesOf(three);
  CHECK(summary.Open >= 4);
}

void CheckTouching()
{
  const Mesh cube = Cube(0, 4);
  // In a vertex, along an edge, along a part of an edge, with an edge on a face.
  CheckCounts({ { cube }, { Cube(4, 6) }, Operation::Union }, 0, 0, 0.0);
  CheckCounts({ { cube }, { Box({ 4, 4, 0 }, { 6, 6, 4 }) }, Operation::Union }, 0, 1, 4.0);
  CheckCounts({ { cube }, { Box({ 4, 4, 1 }, { 6, 6, 9 }) }, Operation::Union }, 0, 1, 3.0);
  const Mesh wedge =
    ConvexHull({ { 1, 1, 4 }, { 3, 1, 4 }, { 1, 1, 6 }, { 3, 1, 6 }, { 2, 3, 6 } });
  CheckCounts({ { cube }, { wedge }, Operation::Union }, 0, 1, 2.0);
}

/** Where areas coincide, only their outline is a curve, however the triangles lie. */
void CheckCoplanar()
{
  const Mesh cube = Cube(0, 4);
  CheckCounts({ { cube }, { Box({ 1, 1, 4 }, { 3, 3, 6 }) }, Operation::Union }, 1, 0, 8.0);
  CheckCounts({ { cube }, { Box({ 1, 1, 2 }, { 3, 3, 4 }) }, Operation::Union }, 1, 0, 8.0);
  CheckCounts({ { cube }, { Box({ 2, 2, 4 }, { 6, 6, 6 }) }, Operation::Union }, 1, 0, 8.0);
  CheckCounts({ { cube }, { Box({ 0, 0, 4 }, { 4, 4, 6 }) }, Operation::Union }, 1, 0, 16.0);
  CheckCounts({ { cube }, { Box({ 4, 1, 1 }, { 6, 3, 3 }) }, Operation::Union }, 1, 0, 8.0);
  // All of it.
  CheckCounts({ { cube }, { cube }, Operation::Union }, 0, 0, 0.0);
  Mesh other = cube; // the other diagonals
  for (std::size_t i = 0; i < 12; i += 2)
  {
    const Corners a = other.Triangles[i];
    const Corners b = other.Triangles[i + 1];
    // (p, q, r) and (p, r, s) become (p, q, s) and (q, r, s).
    other.Triangles[i] = { a[0], a[1], b[2] };
    other.Triangles[i + 1] = { a[1], a[2], b[2] };
  }
  CHECK_EQUAL(NumberOfOpenEdges(other), 0);
  CheckCounts({ { cube }, { other }, Operation::Union }, 0, 0, 0.0);
  // Three sides in common: the outline of the common part, one hexagon of edges.
  CheckCounts({ { cube }, { Cube(0, 2) }, Operation::Union }, 1, 0, 12.0);
}

/** Surfaces in general position meet in loops; a curve does not depend on which surface comes
 * first. */
void CheckRandom()
{
  Random random(1);
  std::size_t loops = 0;
  for (int round = 0; round < 150; ++round)
  {
    const Mesh a = Rotated(RandomConvex(random, -2, 2, 6), RandomRotation(random));
    const Mesh b = Rotated(RandomConvex(random, -2, 2, 6), RandomRotation(random));
    const Summary summary = CurvesOf({ { a }, { b }, Operation::Union });
    CHECK_EQUAL(summary.Open, 0u);
    loops += summary.Loops;
    const Summary swapped = CurvesOf({ { b }, { a }, Operation::Union });
    CHECK_EQUAL(swapped.Loops, summary.Loops);
    CHECK(std::abs(swapped.Length - summary.Length) < 1e-10);
  }
  CHECK(loops > 100);
  for (int round = 0; round < 300; ++round)
  {
    const Mesh a = RandomConvex(random, -2, 2, Between(random, 4, 7));
    const Mesh b = Between(random, 0, 1) == 0 ? RandomBox(random, -2, 2)
                                              : RandomConvex(random, -2, 2, Between(random, 4, 7));
    const Summary summary = CurvesOf({ { a }, { b }, Operation::Union });
    const Summary swapped = CurvesOf({ { b }, { a }, Operation::Union });
    CHECK(std::abs(swapped.Length - summary.Length) < 1e-10);
    CHECK_EQUAL(swapped.Open, summary.Open);
    CHECK_EQUAL(swapped.Loops, summary.Loops);
  }
  // Round bodies: one loop, as long as the circle that it follows.
  const Summary circle = CurvesOf({ { Sphere({ 0, 0, 0 }, 1.0, 40) },
    { Sphere({ 1.0, 0.001, 0.002 }, 1.0, 40) }, Operation::Union });
  CHECK_EQUAL(circle.Loops, 1u);
  CHECK_EQUAL(circle.Open, 0u);
  CHECK(std::abs(circle.Length - 2.0 * 3.14159265358979 * std::sqrt(0.75)) < 0.02);
}

} // namespace

int main()
{
  CheckCrossings();
  CheckTouching();
  CheckCoplanar();
  CheckRandom();
  return check::Verdict("TestCurveJoining");
}
