// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestWindingQuery.cxx
 * @brief Winding numbers just above points of faces, against solid angles; what lies in the face's
 * plane, by its layer.
 */
#include "Check.h"
#include "ProbePlacement.h"
#include "Shapes.h"
#include "ThreadExecutor.h"
#include "WindingQuery.h"

namespace
{

using namespace shapes;
using sb::Operation;

/** Where a probe goes through its face, in the caller's unit. */
Point PlaceOf(const Stage& stage, const sb::Probe& probe)
{
  const std::array<std::int32_t, 3> corners = stage.World.Corners(probe.Face);
  Point p[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    p[i] = stage.World.OriginalPosition(corners[i]);
  }
  const Point normal = Cross(p[1] - p[0], p[2] - p[0]);
  const auto axis = static_cast<std::size_t>(probe.Axis);
  Point place{};
  for (std::size_t i = 0; i < 2; ++i)
  {
    place[(axis + 1 + i) % 3] =
      static_cast<double>(probe.Place[i]) / 256.0 / stage.World.Grid().Scale;
  }
  place[axis] = p[0][axis];
  place[axis] -= Dot(normal, place - p[0]) / normal[axis];
  return place;
}

/** Every face of every operand, asked for every operand. */
void CheckEverywhere(const Case& given)
{
  Stage stage(given);
  const sb::Arrangement nothingCut;
  const sb::ProbePlacement placement(stage.World, nothingCut);
  sb::ThreadExecutor two(2);
  int different = 0;
  for (int attempt = 0; attempt < 3; ++attempt)
  {
    std::vector<sb::WindingQuery> queries;
    for (std::int32_t face = 0; face < stage.World.NumberOfFaces(); ++face)
    {
      for (std::int32_t operand = 0; operand < stage.World.NumberOfOperands(); ++operand)
      {
        queries.push_back({ *placement.Place(face, -1, attempt), operand, 0, false });
      }
    }
    std::vector<sb::WindingQuery> again = queries;
    sb::AnswerQueries(stage.World, {}, queries, stage.Executor);
    sb::AnswerQueries(stage.World, {}, again, two);
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      CHECK_EQUAL(queries[i].Winding, again[i].Winding);
      CHECK_EQUAL(queries[i].Degenerate, again[i].Degenerate);
      CHECK(!queries[i].Degenerate);
      Point above = PlaceOf(stage, queries[i].Line);
      above[static_cast<std::size_t>(queries[i].Line.Axis)] += 1e-7;
      const double expected =
        Winding(stage.Given.Operand(static_cast<std::size_t>(queries[i].Operand)), above);
      CHECK(std::abs(expected - std::round(expected)) < 1e-6);
      CHECK_EQUAL(queries[i].Winding, static_cast<int>(std::lround(expected)));
      different += queries[i].Winding != 0;
    }
  }
  CHECK(different > 0);
}

/** Nested, in shells, side by side and overlapping: none of them in one plane with another. */
void CheckArrangements()
{
  Random random(1);
  const auto turned = [&](const Mesh& mesh) { return Rotated(mesh, RandomRotation(random)); };
  const Mesh large = turned(Sphere({ 0, 0, 0 }, 4.0, 4));
  const Mesh middle = turned(Cube(-1.5, 1.5));
  const Mesh small = turned(Sphere({ 0, 0, 0 }, 1.0, 3));
  CheckEverywhere({ { large }, { middle, small }, Operation::Union });
  Mesh shells = large;
  shells.Append(middle.Reversed());
  shells.Append(small);
  CheckEverywhere({ { shells }, { turned(Cube(-0.3, 0.3)) }, Operation::Union });
  CheckEverywhere(
    { { shells }, { turned(Cube(-0.3, 0.3)).Translated({ 1.2, 0, 0 }) }, Operation::Union });
  Mesh twice = large; // twice around, and backwards
  twice.Append(middle);
  twice.Append(turned(Cube(2, 5)).Reversed());
  CheckEverywhere({ { twice }, { small }, Operation::Union });
  for (int round = 0; round < 20; ++round)
  {
    CheckEverywhere({ { turned(RandomConvex(random, -2, 2, 6)) },
      { turned(RandomConvex(random, -2, 2, 6)) }, Operation::Union });
  }
  // Axis-parallel: lines run along faces.
  CheckEverywhere({ { Box({ -4, -4, -4 }, { 4, 4, 4.5 }) },
    { Box({ -1.5, -1, -2.5 }, { 2, 1, 1.5 }), Box({ 5, 5, 5 }, { 7, 8, 9 }) }, Operation::Union });
}

/** Faces in the probed face's plane lie above it if they come after it. */
void CheckLayers()
{
  const Mesh box = Cube(0, 1);
  Stage stage({ { box }, { box, box.Translated({ 0, 0, 1 }) }, Operation::Union });
  const sb::Arrangement nothingCut;
  const sb::ProbePlacement placement(stage.World, nothingCut);
  const auto winding = [&](std::int32_t face, std::int32_t operand) {
    std::vector<sb::WindingQuery> queries{ { *placement.Place(face, -1, 0), operand, 0, false } };
    sb::AnswerQueries(stage.World, {}, queries, stage.Executor);
    CHECK(!queries[0].Degenerate);
    return queries[0].Winding;
  };
  // Of a box, triangles 0 and 1 are the bottom, 2 and 3 the top.
  for (const std::int32_t bottom : { 0, 1 })
  {
    CHECK_EQUAL(winding(bottom, 0), 1);
    CHECK_EQUAL(winding(bottom, 1), 0); // just below the other's bottom
    CHECK_EQUAL(winding(12 + bottom, 0), 1);
    CHECK_EQUAL(winding(12 + bottom, 1), 1);
    CHECK_EQUAL(winding(24 + bottom, 0), 0); // just above the first two
    CHECK_EQUAL(winding(24 + bottom, 1), 0);
    CHECK_EQUAL(winding(24 + bottom, 2), 1);
  }
  for (const std::int32_t top : { 2, 3 })
  {
    CHECK_EQUAL(winding(top, 0), 0);
    CHECK_EQUAL(winding(top, 1), 1); // between the two tops
    CHECK_EQUAL(winding(top, 2), 0);
    CHECK_EQUAL(winding(12 + top, 0), 0);
    CHECK_EQUAL(winding(12 + top, 2), 0); // the third's bottom comes later still
  }
}

/** A line through an edge or a crossing above is no answer; one that is below does not matter. */
void CheckDegenerate()
{
  const Mesh low = Box({ 0, 0, -3 }, { 4, 4, -2 });
  const Mesh high = Box({ 0, 0, 2 }, { 4, 4, 3 });
  Stage stage({ { low }, { high }, Operation::Union });
  const auto scale = static_cast<std::int64_t>(stage.World.Grid().Scale);
  const auto ask = [&](std::int32_t face, std::int32_t operand, std::int64_t x, std::int64_t y) {
    sb::Probe probe;
    probe.Face = face;
    probe.Axis = 2;
    probe.Place = { 64 * x * scale, 64 * y * scale }; // in quarters
    std::vector<sb::WindingQuery> queries{ { probe, operand, 0, false } };
    sb::AnswerQueries(stage.World, {}, queries, stage.Executor);
    return queries[0];
  };
  const std::int32_t top = 2;
  CHECK(ask(top, 1, 5, 5).Degenerate); // below a diagonal
  CHECK(!ask(top, 1, 6, 5).Degenerate);
  CHECK_EQUAL(ask(top, 1, 6, 5).Winding, 0);
  CHECK(!ask(12 + top, 0, 5, 5).Degenerate); // above it
  CHECK_EQUAL(ask(12 + top, 0, 5, 5).Winding, 0);
  // A face that crosses the probed one right at the line.
  Stage crossing(
    { { Cube(0, 4) }, { Triangle({ 0, 0, 2 }, { 4, 0, 6 }, { 0, 4, 2 }).Translated({ 0, 0, 1 }) },
      Operation::Union });
  sb::Probe probe;
  probe.Face = 2;
  probe.Axis = 2;
  const auto unit = static_cast<std::int64_t>(crossing.World.Grid().Scale);
  probe.Place = { 256 * unit, 256 * unit };
  std::vector<sb::WindingQuery> queries{ { probe, 1, 0, false } };
  sb::AnswerQueries(crossing.World, {}, queries, crossing.Executor);
  CHECK(queries[0].Degenerate);
}

void CheckCollapsedPassedOver()
{
  const Mesh low = Box({ 0, 0, -3 }, { 4, 4, -2 });
  Mesh roof = Triangle({ -9, -9, 5 }, { 9, -9, 5 }, { 0, 20, 5 });
  roof.AddTriangle({ -9, -9, 6 }, { 9, -9, 6 }, { 0, 20, 6 });
  Stage stage({ { low }, { roof }, Operation::Union });
  const sb::Arrangement nothingCut;
  const sb::ProbePlacement placement(stage.World, nothingCut);
  std::vector<std::uint8_t> collapsed(static_cast<std::size_t>(stage.World.NumberOfFaces()), 0);
  for (const int expected : { 2, 1, 0 })
  {
    std::vector<sb::WindingQuery> queries{ { *placement.Place(2, -1, 0), 1, 0, false } };
    sb::AnswerQueries(stage.World, collapsed, queries, stage.Executor);
    CHECK_EQUAL(queries[0].Winding, expected);
    collapsed[static_cast<std::size_t>(stage.World.FirstFace(1) + (expected == 2 ? 0 : 1))] = 1;
  }
}

} // namespace

int main()
{
  CheckArrangements();
  CheckLayers();
  CheckDegenerate();
  CheckCollapsedPassedOver();
  return check::Verdict("TestWindingQuery");
}
