// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestOutputAssembly.cxx
 * @brief Output points: copies keep their bytes, new ones carry weights that reproduce them,
 * creases and seams stay doubled.
 */
#include "Check.h"
#include "Shapes.h"

#include <cstring>
#include <map>
#include <set>

namespace
{

using namespace shapes;
using sb::BooleanResult;
using sb::Fate;
using sb::Operation;
using sb::SeamPoints;

Mesh Soup(const Mesh& mesh)
{
  Mesh soup;
  for (const Corners& t : mesh.Triangles)
  {
    soup.AddTriangle(mesh.At(t, 0), mesh.At(t, 1), mesh.At(t, 2));
  }
  return soup;
}

/** A box whose six sides share no points: four points a side, as boxes with sharp edges come. */
Mesh CreasedBox(const Point& low, const Point& high)
{
  const Mesh box = Box(low, high);
  Mesh creased;
  for (std::size_t side = 0; side < 6; ++side)
  {
    std::map<std::int32_t, std::int32_t> point;
    for (std::size_t i = 2 * side; i < 2 * side + 2; ++i)
    {
      Corners t;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto next = static_cast<std::int32_t>(creased.Points.size());
        const auto [it, isNew] = point.emplace(box.Triangles[i][k], next);
        if (isNew)
        {
          creased.Points.push_back(box.At(box.Triangles[i], k));
        }
        t[k] = it->second;
      }
      creased.Triangles.push_back(t);
    }
  }
  return creased;
}

/** Ids of output points, and where they start to be interpolated. */
std::int32_t NumberOfKept(const BooleanResult& result)
{
  std::size_t kept = 0;
  for (const std::vector<std::int32_t>& points : result.KeptPoints)
  {
    kept += points.size();
  }
  return static_cast<std::int32_t>(kept);
}

/** Of each output point the operand it comes from. */
std::vector<std::int32_t> OperandsOfPoints(const BooleanResult& result)
{
  std::vector<std::int32_t> operands;
  for (std::size_t operand = 0; operand < result.KeptPoints.size(); ++operand)
  {
    operands.insert(
      operands.end(), result.KeptPoints[operand].size(), static_cast<std::int32_t>(operand));
  }
  for (const sb::InterpolatedPoint& point : result.Interpolated)
  {
    operands.push_back(point.Operand);
  }
  return operands;
}

void CheckWeights(const Case& given, const BooleanResult& result, double size)
{
  for (const sb::InterpolatedPoint& point : result.Interpolated)
  {
    const Mesh& mesh = given.Operand(static_cast<std::size_t>(point.Operand));
    double sum = 0.0;
    Point reproduced{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      CHECK(point.Weights[i] >= 0.0 && point.Weights[i] <= 1.0);
      sum += point.Weights[i];
      reproduced =
        reproduced + point.Weights[i] * mesh.Points[static_cast<std::size_t>(point.PointIds[i])];
    }
    CHECK(std::abs(sum - 1.0) < 1e-14);
    CHECK(Length(reproduced - point.Position) < 1e-12 * size);
  }
}

/** Pieces lie in their parents, are oriented as these, and fill them where all are in the result.
 */
void CheckPieces(const Case& given, const BooleanResult& result, SeamPoints seams, double size)
{
  const Mesh mesh = ResultMesh(given, result);
  const std::vector<std::int32_t> operandOf = OperandsOfPoints(result);
  std::map<std::pair<std::int32_t, std::int32_t>, double> areas;
  for (std::size_t i = 0; i < result.Split.Corners.size(); ++i)
  {
    const std::int32_t operand = result.Split.Operand[i];
    const Mesh& from = given.Operand(static_cast<std::size_t>(operand));
    const auto parent = static_cast<std::size_t>(result.Split.Parent[i]);
    CHECK(result.Fates[static_cast<std::size_t>(operand)][parent] == Fate::Split);
    const Corners& t = from.Triangles[parent];
    const Point normal = Cross(from.At(t, 1) - from.At(t, 0), from.At(t, 2) - from.At(t, 0));
    const Corners& piece = result.Split.Corners[i];
    const Point own =
      Cross(mesh.At(piece, 1) - mesh.At(piece, 0), mesh.At(piece, 2) - mesh.At(piece, 0));
    CHECK(Dot(normal, own) > -1e-12 * size * size * Length(normal));
    areas[{ operand, result.Split.Parent[i] }] += Length(own);
    for (const std::int32_t corner : piece)
    {
      const Point offset = mesh.Points[static_cast<std::size_t>(corner)] - from.At(t, 0);
      CHECK(std::abs(Dot(normal, offset)) < 1e-12 * size * Length(normal));
      CHECK(seams == SeamPoints::Shared || operandOf[static_cast<std::size_t>(corner)] == operand);
    }
  }
  for (const auto& [parent, area] : areas)
  {
    const Mesh& from = given.Operand(static_cast<std::size_t>(parent.first));
    const Corners& t = from.Triangles[static_cast<std::size_t>(parent.second)];
    CHECK(area <
      (1.0 + 1e-12) * Length(Cross(from.At(t, 1) - from.At(t, 0), from.At(t, 2) - from.At(t, 0))));
  }
}

void CheckRandom()
{
  Random random(1);
  std::size_t interpolated = 0;
  for (int round = 0; round < 150; ++round)
  {
    Mesh a = RandomConvex(random, -2, 2, Between(random, 4, 7));
    Mesh b = RandomConvex(random, -2, 2, Between(random, 4, 7));
    if (round % 3 == 0)
    {
      a = Rotated(a, RandomRotation(random)).Translated({ 100, 200, 300 });
      b = Rotated(b, RandomRotation(random)).Translated({ 100, 200, 300 });
    }
    if (round % 5 == 0)
    {
      a = Soup(a);
    }
    for (const Operation op : { Operation::Union, Operation::Difference, Operation::Intersection,
           Operation::SymmetricDifference })
    {
      for (const SeamPoints seams : { SeamPoints::PerSide, SeamPoints::Shared })
      {
        const Case given{ { a }, { b }, op };
        const BooleanResult result = Compute(given, seams);
        CheckWeights(given, result, 400.0);
        CheckPieces(given, result, seams, 400.0);
        interpolated += result.Interpolated.size();
        const Mesh mesh = ResultMesh(given, result);
        CHECK_EQUAL(NumberOfOpenEdges(mesh), 0);
        if (seams == SeamPoints::Shared && round % 5 != 0)
        {
          CHECK_EQUAL(
            std::set<Point>(mesh.Points.begin(), mesh.Points.end()).size(), mesh.Points.size());
          CHECK_EQUAL(NumberOfOpenEdgesById(mesh), 0);
        }
      }
    }
  }
  CHECK(interpolated > 3000);
}

/** Points of the result at one place. */
std::ptrdiff_t NumberAt(const Mesh& mesh, const Point& place)
{
  return std::count(mesh.Points.begin(), mesh.Points.end(), place);
}

/** Along the cut of a crease each side of the crease has points of its own; without a crease they
 * are one a body. */
void CheckCreases()
{
  const Mesh tool = Box({ -1, -1, 1 }, { 5, 5, 9 }); // cuts the box at height 1
  const Point onCrease{ 4, 4, 1 };
  for (const SeamPoints seams : { SeamPoints::PerSide, SeamPoints::Shared })
  {
    const bool shared = seams == SeamPoints::Shared;
    const Case smooth{ { Cube(0, 4) }, { tool }, Operation::Difference };
    const Mesh ofSmooth = ResultMesh(smooth, Compute(smooth, seams));
    // The box has one point there, the tool's bottom another one.
    CHECK_EQUAL(NumberAt(ofSmooth, onCrease), shared ? 1 : 2);
    const Case creased{ { CreasedBox({ 0, 0, 0 }, { 4, 4, 4 }) }, { tool }, Operation::Difference };
    const BooleanResult result = Compute(creased, seams);
    const Mesh ofCreased = ResultMesh(creased, result);
    CHECK_EQUAL(NumberAt(ofCreased, onCrease), shared ? 1 : 3);
    // Corners of the input that nothing touches keep their three points either way.
    CHECK_EQUAL(NumberAt(ofCreased, { 0, 0, 0 }), 3);
    CHECK_EQUAL(NumberAt(ofSmooth, { 0, 0, 0 }), 1);
    CHECK_EQUAL(NumberOfOpenEdges(ofCreased), 0);
    CHECK_EQUAL(NumberOfOpenEdges(ofSmooth), 0);
    CheckWeights(creased, result, 10.0);
    if (!shared)
    {
      // The two points on the crease belong to the two sides: their parents' corners differ.
      std::set<std::set<std::int32_t>> edges;
      for (const sb::InterpolatedPoint& point : result.Interpolated)
      {
        if (point.Position == onCrease && point.Operand == 0)
        {
          std::set<std::int32_t> ends;
          for (std::size_t i = 0; i < 3; ++i)
          {
            if (point.Weights[i] > 0.0)
            {
              ends.insert(point.PointIds[i]);
            }
          }
          CHECK_EQUAL(ends.size(), 2u);
          edges.insert(ends);
        }
      }
      CHECK_EQUAL(edges.size(), 2u);
    }
  }
}

/** What is not cut stays as it is: whole triangles, in the order and bytes of the input. */
void CheckKept()
{
  const Mesh a = Cube(0.1, 0.7);
  const Mesh b = Cube(0.3, 0.9);
  const Case given{ { a }, { b }, Operation::Union };
  const BooleanResult result = Compute(given);
  CHECK_EQUAL(NumberOfKept(result), 14);
  const Mesh mesh = ResultMesh(given, result);
  // Each cube keeps the three sides away from the other one.
  for (const std::vector<Fate>& fates : result.Fates)
  {
    CHECK_EQUAL(std::count(fates.begin(), fates.end(), Fate::Kept), 6);
    CHECK_EQUAL(std::count(fates.begin(), fates.end(), Fate::Split), 6);
  }
  // Disjoint and enclosed ones are kept or dropped as wholes.
  const BooleanResult apart = Compute({ { a }, { Cube(2, 3) }, Operation::Union });
  CHECK_EQUAL(NumberOfKept(apart), 16);
  CHECK(apart.Interpolated.empty() && apart.Split.Corners.empty());
  const BooleanResult enclosed = Compute({ { Cube(0, 1) }, { b }, Operation::Union });
  CHECK_EQUAL(NumberOfKept(enclosed), 8);
  const BooleanResult cavity = Compute({ { Cube(0, 1) }, { b }, Operation::Difference });
  CHECK_EQUAL(std::count(cavity.Fates[1].begin(), cavity.Fates[1].end(), Fate::KeptReversed), 12);
  // Faces that are touched but not cut are whole triangles, too.
  const BooleanResult touched = Compute({ { Cube(0, 1) }, { Cube(1, 2) }, Operation::Union });
  CHECK_EQUAL(std::count(touched.Fates[0].begin(), touched.Fates[0].end(), Fate::Kept), 12);
  CHECK_EQUAL(std::count(touched.Fates[1].begin(), touched.Fates[1].end(), Fate::Kept), 12);
  CHECK(touched.Split.Corners.empty() && touched.Interpolated.empty());
  // A new point where an input vertex lies has that vertex' bytes, whatever the lattice made of
  // them.
  const double third = 1.0 / 3.0;
  const Mesh block = Cube(-1, 1);
  const Mesh foot = Box({ -third, -third, 1 }, { third, 0.1, 3 });
  const Case standing{ { block }, { foot }, Operation::Union };
  const BooleanResult result2 = Compute(standing);
  int atCorners = 0;
  for (const sb::InterpolatedPoint& point : result2.Interpolated)
  {
    const bool isCorner = std::count(foot.Points.begin(), foot.Points.end(), point.Position) == 1;
    atCorners += isCorner && point.Operand == 0;
  }
  CHECK_EQUAL(atCorners, 4);
  CHECK_EQUAL(NumberOfOpenEdges(ResultMesh(standing, result2)), 0);
}

/** An operand that came inside out goes out as it came: kept triangles in its own orientation,
 * marked reversed. */
void CheckInsideOut()
{
  const Mesh a = Cube(0, 4);
  const Mesh b = Cube(2, 6);
  const BooleanResult plain = Compute({ { a }, { b }, Operation::Union });
  const Case given{ { a }, { b.Reversed() }, Operation::Union };
  const BooleanResult turned = Compute(given);
  for (std::size_t i = 0; i < 12; ++i)
  {
    CHECK((plain.Fates[1][i] == Fate::Kept) == (turned.Fates[1][i] == Fate::KeptReversed));
    CHECK(plain.Fates[0][i] == turned.Fates[0][i]);
  }
  int reversed = 0;
  for (std::size_t i = 0; i < turned.Split.Corners.size(); ++i)
  {
    CHECK_EQUAL(int(turned.Split.Reversed[i]), turned.Split.Operand[i] == 1 ? 1 : 0);
    reversed += turned.Split.Reversed[i];
  }
  CHECK(reversed > 0);
  CheckPieces(given, turned, SeamPoints::PerSide, 10.0);
  CHECK_EQUAL(Volume(ResultMesh(given, turned)), 120.0);
}

} // namespace

int main()
{
  CheckRandom();
  CheckCreases();
  CheckKept();
  CheckInsideOut();
  return check::Verdict("TestOutputAssembly");
}
