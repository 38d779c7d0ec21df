// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestArrangement.cxx
 * @brief Pieces fill their faces, coinciding regions find each other, and the cost of cutting
 * follows the pieces that there are: coplanar fans, bodies that all overlap, voxels.
 */
#include "Arrangement.h"
#include "Check.h"
#include "Shapes.h"

#include <cmath>
#include <ctime>

namespace
{

using namespace shapes;
using sb::Operation;

/** An upright cylinder whose caps are fans around their first corner. */
Mesh FannedCylinder(double radius, double low, double high, int sides)
{
  Mesh mesh = Tube(radius, low, high, sides);
  for (int i = 1; i + 1 < sides; ++i)
  {
    mesh.Triangles.push_back({ 0, 2 * i + 2, 2 * i });
    mesh.Triangles.push_back({ 1, 2 * i + 1, 2 * i + 3 });
  }
  return mesh;
}

/** A plate with a cylinder standing on it: a cap in the plane of the top. */
Case FlushCylinder(int sides)
{
  return { { Box({ -2, -2, -1 }, { 2, 2, 0 }) }, { FannedCylinder(1.0, 0.0, 1.0, sides) },
    Operation::Union };
}

Case Diagonal(int count)
{
  Case given;
  given.Op = Operation::Intersection;
  for (int i = 0; i < count; ++i)
  {
    given.Inputs.push_back(Cube(i, 256 + i));
  }
  return given;
}

Case Voxels(int size)
{
  Case given;
  given.Op = Operation::Union;
  for (int i = 0; i < size * size * size; ++i)
  {
    const double x = i % size;
    const double y = i / size % size;
    const double z = i / size / size;
    given.Inputs.push_back(Box({ x, y, z }, { x + 1, y + 1, z + 1 }));
  }
  return given;
}

Case Copies(int count)
{
  Case given;
  given.Op = Operation::Union;
  given.Inputs.assign(static_cast<std::size_t>(count), Cube(0, 1));
  return given;
}

double DoubledArea(const CutStage& stage, std::int32_t face)
{
  const std::array<std::int32_t, 3> c = stage.World.Corners(face);
  const auto at = [&](std::size_t i) {
    const double* p = stage.World.Position(c[i]);
    return Point{ p[0], p[1], p[2] };
  };
  return Length(Cross(at(1) - at(0), at(2) - at(0)));
}

/** The pieces of each face have its area together, and none is turned over. */
void CheckPiecesFill(const CutStage& stage)
{
  const sb::Arrangement& cuts = stage.Cuts;
  for (std::size_t i = 0; i < cuts.Faces.size(); ++i)
  {
    const std::int32_t face = cuts.Faces[i].Face;
    double sum = 0.0;
    for (std::int32_t p = cuts.Faces[i].FirstPiece; p < cuts.EndOfPieces(i); ++p)
    {
      const sb::Piece& piece = cuts.Pieces[static_cast<std::size_t>(p)];
      CHECK_EQUAL(cuts.Regions[static_cast<std::size_t>(piece.Region)].Face, face);
      const auto at = [&](std::size_t k) {
        const double* q = sb::IsNode(piece.Corners[k])
          ? cuts.Nodes.Point(piece.Corners[k]).Approximation()
          : stage.World.Position(~piece.Corners[k]);
        return Point{ q[0], q[1], q[2] };
      };
      sum += Length(Cross(at(1) - at(0), at(2) - at(0)));
    }
    const double whole = DoubledArea(stage, face);
    CHECK(std::abs(sum - whole) <= 1e-9 * whole);
  }
}

/** The least processor time of three runs of cutting. */
double SecondsOfCuts(CutStage& stage)
{
  double least = 1e300;
  for (int i = 0; i < 3; ++i)
  {
    const std::clock_t begin = std::clock();
    const sb::Arrangement again = sb::MakeArrangement(
      stage.World, stage.Contacts, stage.Self, stage.Collapsed, stage.Executor, stage.Monitor);
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    CHECK_EQUAL(again.Pieces.size(), stage.Cuts.Pieces.size());
  }
  return least;
}

void CheckRegions()
{
  // Two equal cubes: every face is one piece, and each pair of them a stack.
  const CutStage twice(Copies(2));
  CHECK_EQUAL(twice.Cuts.Pieces.size(), 24u);
  CHECK_EQUAL(twice.Cuts.NumberOfStacks, 12);
  for (const sb::Region& region : twice.Cuts.Regions)
  {
    CHECK(region.Stack >= 0);
  }
  CheckPiecesFill(twice);

  const CutStage flush(FlushCylinder(40));
  CheckPiecesFill(flush);
  // Each of the cap's 38 triangles lies on the top; the top's diagonal divides some of them.
  CHECK(flush.Cuts.NumberOfStacks >= 38 && flush.Cuts.NumberOfStacks <= 76);
  CheckPiecesFill(CutStage(Diagonal(9)));
  CheckPiecesFill(CutStage(Voxels(3)));
}

/** Coplanar triangles that have an edge or a corner in common have one contact there, not one for
 * each way to come upon it. */
void CheckContactsOnce()
{
  const auto contacts = [](const Mesh& a, const Mesh& b) {
    return CutStage({ { a }, { b }, Operation::Union }).Contacts.Contacts.size();
  };
  const Mesh corner = Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 });
  CHECK_EQUAL(contacts(corner, Triangle({ 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 })), 2u);
  CHECK_EQUAL(contacts(corner, Triangle({ 4, 0, 0 }, { 8, 0, 0 }, { 8, 4, 0 })), 2u);
  CHECK_EQUAL(contacts(corner, corner), 6u);

  // Voxels: what a cube has in common with its neighbours does not grow with their number.
  const CutStage few(Voxels(3));
  const CutStage many(Voxels(6));
  const auto perCube = [](const CutStage& stage) {
    return static_cast<double>(stage.Contacts.Contacts.size()) /
      static_cast<double>(stage.World.NumberOfOperands());
  };
  CHECK(perCube(many) < 1.5 * perCube(few));
}

/** Eight times the sides of a coplanar fan: eight times the pieces, and not much more than eight
 * times the time. */
void CheckFans()
{
  CutStage few(FlushCylinder(250));
  CutStage many(FlushCylinder(2000));
  const double pieces =
    static_cast<double>(many.Cuts.Pieces.size()) / static_cast<double>(few.Cuts.Pieces.size());
  CHECK(pieces > 7.0 && pieces < 9.0);
  CHECK(SecondsOfCuts(many) < 20 * SecondsOfCuts(few) + 0.02);
}

/** Each of the bodies crosses all others: four times as many have sixteen times the contacts. */
void CheckManyAcross()
{
  CutStage few(Diagonal(16));
  CutStage many(Diagonal(64));
  const double contacts = static_cast<double>(many.Contacts.Contacts.size()) /
    static_cast<double>(few.Contacts.Contacts.size());
  const double pieces =
    static_cast<double>(many.Cuts.Pieces.size()) / static_cast<double>(few.Cuts.Pieces.size());
  CHECK(contacts > 14.0 && contacts < 20.0);
  CHECK(pieces > 10.0 && pieces < 20.0);
  CHECK(SecondsOfCuts(many) < 2.5 * contacts * SecondsOfCuts(few) + 0.02);
}

} // namespace

int main()
{
  CheckRegions();
  CheckContactsOnce();
  CheckFans();
  CheckManyAcross();
  return check::Verdict("TestArrangement");
}
