// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestClassification.cxx
 * @brief Which faces and regions are kept: nested bodies, shells, stacks of coinciding faces,
 * overlaps within one operand.
 */
#include "Check.h"
#include "Classification.h"
#include "InsideCount.h"
#include "Shapes.h"

#include <map>

namespace
{

using namespace shapes;
using sb::Classification;
using sb::Fate;
using sb::Operation;

constexpr Operation AllOperations[] = { Operation::Union, Operation::Intersection,
  Operation::Difference, Operation::SymmetricDifference, Operation::Resolve };

Classification Classify(CutStage& stage)
{
  return sb::Classify({ stage.World, stage.Cuts, stage.Given.Op, stage.Self, stage.Checked.Open,
                        stage.Checked.Rims, stage.Collapsed },
    stage.Executor, stage.Monitor);
}

Classification Classify(const Case& given, const std::vector<std::uint8_t>& self = {})
{
  CutStage stage(given, self);
  return Classify(stage);
}

/** The one fate of a range of an operand's faces; 'x' if they differ: '.' dropped, '+' kept, '-'
 * reversed, '/' cut. */
char FateOf(const Classification& classes, std::size_t operand, std::size_t first, std::size_t end)
{
  const std::vector<Fate>& fates = classes.Fates[operand];
  for (std::size_t i = first; i < end; ++i)
  {
    if (fates[i] != fates[first])
    {
      return 'x';
    }
  }
  return ".+-/"[static_cast<int>(fates[first])];
}

/** The fates of whole bodies, operand by operand, each of the given sizes. */
std::string Fates(const Case& given, const std::vector<std::vector<std::size_t>>& bodies)
{
  const Classification classes = Classify(given);
  for (const std::uint8_t overlaps : classes.SelfIntersecting)
  {
    CHECK_EQUAL(int(overlaps), 0);
  }
  std::string all;
  for (std::size_t operand = 0; operand < bodies.size(); ++operand)
  {
    std::size_t first = 0;
    for (const std::size_t size : bodies[operand])
    {
      all.push_back(FateOf(classes, operand, first, first + size));
      first += size;
    }
  }
  return all;
}

/** Union, intersection, difference, symmetric difference and resolve of the same operands. */
void CheckFates(Case given, const std::vector<std::vector<std::size_t>>& bodies,
  const std::array<std::string, 5>& expected)
{
  for (std::size_t i = 0; i < 5; ++i)
  {
    given.Op = AllOperations[i];
    CHECK_EQUAL(Fates(given, bodies), expected[i]);
  }
}

/** Nothing touches anything: every body is kept, dropped or turned as a whole. */
void CheckNested()
{
  const Mesh large = Cube(-9, 9);
  const Mesh middle = Cube(-5, 5);
  const Mesh small = Cube(-2, 2);
  const Mesh tiny = Cube(-1, 1);
  const Mesh apart = Cube(20, 21);
  CheckFates({ { large }, { small }, {} }, { { 12 }, { 12 } }, { "+.", ".+", "+-", "+-", "+." });
  CheckFates({ { small }, { large }, {} }, { { 12 }, { 12 } }, { ".+", "+.", "..", "-+", ".+" });
  CheckFates({ { large }, { apart }, {} }, { { 12 }, { 12 } }, { "++", "..", "+.", "++", "++" });
  // Matryoshkas, inputs and tools in turn: their symmetric difference is that of the two unions.
  CheckFates({ { large, small }, { middle, tiny }, {} }, { { 12 }, { 12 }, { 12 }, { 12 } },
    { "+...", "..+.", "+.-.", "+.-.", "+..." });
  // Inputs only: the intersection is that of all.
  CheckFates({ { large, small, middle }, {}, {} }, { { 12 }, { 12 }, { 12 } },
    { "+..", ".+.", "+..", "+..", "+.." });

  // A shell with a cavity, and a body in the cavity, in the wall's place, around all, or small
  // within the wall.
  Mesh shell = large;
  shell.Append(middle.Reversed());
  CheckFates(
    { { shell }, { small }, {} }, { { 12, 12 }, { 12 } }, { "+++", "...", "++.", "+++", "+++" });
  CheckFates({ { shell }, { Cube(6, 7) }, {} }, { { 12, 12 }, { 12 } },
    { "++.", "..+", "++-", "++-", "++." });
  CheckFates({ { shell }, { Cube(-11, 11) }, {} }, { { 12, 12 }, { 12 } },
    { "..+", "++.", "...", "--+", "..+" });
  CheckFates({ { shell }, { Cube(-7, 7) }, {} }, { { 12, 12 }, { 12 } },
    { "+..", ".++", "+.-", "+--", "+.." });
  // Two shells, one in the cavity of the other.
  Mesh inner = small;
  inner.Append(tiny.Reversed());
  CheckFates({ { shell }, { inner }, {} }, { { 12, 12 }, { 12, 12 } },
    { "++++", "....", "++..", "++++", "++++" });
  // Several bodies of one operand on both sides of another one's surface.
  Mesh several = small;
  several.Append(apart);
  several.Append(Cube(30, 31));
  CheckFates({ { several }, { Cube(-5, 25) }, {} }, { { 12, 12, 12 }, { 12 } },
    { "..++", "++..", "..+.", "--++", "..++" });
}

/** Of the faces in one place, of as many operands as there are, at most one is kept: the one that
 * bounds the result. */
void CheckStacks()
{
  const Mesh cube = Cube(0, 1);
  for (std::size_t copies = 2; copies <= 5; ++copies)
  {
    for (const bool asTools : { false, true })
    {
      Case given;
      for (std::size_t i = 0; i < copies; ++i)
      {
        Mesh copy = cube;
        std::rotate(copy.Triangles.begin(),
          copy.Triangles.begin() + static_cast<std::ptrdiff_t>(5 * i % 12), copy.Triangles.end());
        (asTools && i > 0 ? given.Tools : given.Inputs).push_back(copy);
      }
      for (const Operation op : AllOperations)
      {
        given.Op = op;
        CutStage stage(given);
        CHECK_EQUAL(stage.Cuts.NumberOfStacks, 12);
        const Classification classes = Classify(stage);
        const bool vanishes =
          asTools ? op == Operation::Difference || op == Operation::SymmetricDifference : false;
        std::map<std::int32_t, int> kept;
        for (std::size_t i = 0; i < stage.Cuts.Regions.size(); ++i)
        {
          CHECK(stage.Cuts.Regions[i].Stack >= 0);
          CHECK(classes.RegionFates[i] != Fate::KeptReversed);
          kept[stage.Cuts.Regions[i].Stack] += classes.RegionFates[i] == Fate::Kept;
        }
        for (const auto& [stack, count] : kept)
        {
          CHECK_EQUAL(count, vanishes ? 0 : 1);
        }
      }
    }
  }
  // Back to back: the common side goes in a union, stays with the input in a difference.
  const Case beside{ { Cube(0, 1) }, { Box({ 1, 0, 0 }, { 2, 1, 1 }) }, Operation::Union };
  for (const Operation op : AllOperations)
  {
    Case given = beside;
    given.Op = op;
    CutStage stage(given);
    CHECK_EQUAL(stage.Cuts.NumberOfStacks, 2);
    const Classification classes = Classify(stage);
    for (std::size_t i = 0; i < stage.Cuts.Regions.size(); ++i)
    {
      const sb::Region& region = stage.Cuts.Regions[i];
      if (region.Stack >= 0)
      {
        const bool expected = op == Operation::Difference && region.Face < 12;
        CHECK(classes.RegionFates[i] == (expected ? Fate::Kept : Fate::Dropped));
      }
    }
  }
}

/** In any stack of any random operands at most one region is in the result. */
void CheckRandomStacks()
{
  Random random(1);
  int stacks = 0;
  for (int round = 0; round < 400; ++round)
  {
    Case given;
    for (int i = Between(random, 2, 5); i > 0; --i)
    {
      (Between(random, 0, 1) == 0 || given.Inputs.empty() ? given.Inputs : given.Tools)
        .push_back(RandomBox(random, 0, 3));
    }
    given.Op = AllOperations[Between(random, 0, 4)];
    CutStage stage(given);
    const Classification classes = Classify(stage);
    std::map<std::int32_t, int> kept;
    for (std::size_t i = 0; i < stage.Cuts.Regions.size(); ++i)
    {
      if (stage.Cuts.Regions[i].Stack >= 0)
      {
        kept[stage.Cuts.Regions[i].Stack] += classes.RegionFates[i] != Fate::Dropped;
      }
    }
    for (const auto& [stack, count] : kept)
    {
      CHECK(count <= 1);
    }
    stacks += stage.Cuts.NumberOfStacks;
    for (const std::uint8_t overlaps : classes.SelfIntersecting)
    {
      CHECK_EQUAL(int(overlaps), 0);
    }
  }
  CHECK(stacks > 1000);
}

/** Operands that overlap themselves are found out where it matters, and clean ones are never
 * suspected. */
void CheckOverlaps()
{
  const auto overlaps = [](const Mesh& a, const Mesh& b) {
    const Classification classes = Classify(Case{ { a }, { b }, Operation::Union });
    CHECK_EQUAL(int(classes.SelfIntersecting[1]), 0);
    return classes.SelfIntersecting[0] != 0;
  };
  Mesh crossing = Cube(0, 4);
  crossing.Append(Cube(2, 6));
  CHECK(overlaps(crossing, Cube(3, 5))); // met by both, where they cross
  CHECK(overlaps(crossing, Box({ 3, 3, -1 }, { 3.5, 3.5, 9 }))); // goes through both
  CHECK(overlaps(crossing, Cube(2.5, 3.5))); // inside both, touching neither
  CHECK(!overlaps(crossing, Cube(-1, 1))); // away from where they cross
  CHECK(!overlaps(crossing, Cube(10, 11)));
  Mesh nested = Cube(0, 9);
  nested.Append(Cube(2, 5));
  CHECK(overlaps(nested, Cube(3, 4)));
  CHECK(overlaps(nested, Cube(4, 7)));
  CHECK(!overlaps(nested, Cube(8, 10)));
  Mesh shell = Cube(0, 9);
  shell.Append(Cube(2, 5).Reversed());
  CHECK(!overlaps(shell, Cube(3, 4)));
  CHECK(!overlaps(shell, Cube(4, 7)));
  // A body that is inside out, beside a good one.
  Mesh reversed = Cube(0, 9);
  reversed.Append(Cube(12, 15).Reversed());
  CHECK(overlaps(reversed, Cube(14, 16)));
  CHECK(overlaps(reversed, Cube(13, 14)));
  CHECK(!overlaps(reversed, Cube(8, 10)));
  // Bodies that only touch each other are clean.
  Mesh touching = Cube(0, 4);
  touching.Append(Cube(4, 8));
  touching.Append(Box({ 4, 0, 0 }, { 8, 4, 4 }));
  CHECK(!overlaps(touching, Cube(3, 5)));
  // Once cut against themselves they are taken as they are.
  const Classification again =
    Classify(Case{ { crossing }, { Cube(3, 5) }, Operation::Union }, { 1, 0 });
  CHECK_EQUAL(again.Fates.size(), 2u);
  CHECK(!again.RegionFates.empty());
}

/** Sheets: those that cut through separate, those that end inside do not. */
void CheckSheets()
{
  const auto separates = [](const Mesh& body, const Mesh& sheet) {
    const Classification classes = Classify(Case{ { body }, { sheet }, Operation::Difference });
    CHECK_EQUAL(int(classes.NonSeparating[0]), 0);
    return classes.NonSeparating[1] == 0;
  };
  const auto sheet = [](double low, double high, double z) {
    return Sheet({ low, low, z }, { high, low, z }, { high, high, z }, { low, high, z });
  };
  const Mesh cube = Cube(0, 4);
  CHECK(separates(cube, sheet(-1, 5, 2)));
  CHECK(separates(cube, sheet(0, 4, 2))); // its rim is on the body's surface
  CHECK(separates(cube, sheet(-1, 5, 4)));
  CHECK(!separates(cube, sheet(1, 3, 2)));
  CHECK(!separates(cube, sheet(-1, 3, 2)));
  CHECK(separates(cube, Tube(1, -9, 9, 8).Translated({ 2, 2, 0 })));
  CHECK(!separates(cube, Tube(1, -9, 2, 8).Translated({ 2, 2, 0 })));
  // In front of the sheet is outside of it: the difference keeps that half.
  const Classification half =
    Classify(Case{ { cube }, { sheet(-1, 5, 2) }, Operation::Difference });
  CHECK_EQUAL(FateOf(half, 0, 2, 4), '+'); // the top
  CHECK_EQUAL(FateOf(half, 0, 0, 2), '.'); // the bottom
}

/** The value of an operation, for all that up to two inputs and two tools can be around a point. */
void CheckInsideCount()
{
  for (int inputs = 1; inputs <= 2; ++inputs)
  {
    for (int tools = 0; tools <= 2; ++tools)
    {
      Case given;
      given.Inputs.assign(static_cast<std::size_t>(inputs), Cube(0, 1));
      given.Tools.assign(static_cast<std::size_t>(tools), Cube(0, 1));
      const Stage stage(given);
      int combinations = 1;
      for (int i = 0; i < inputs + tools; ++i)
      {
        combinations *= 4; // winding numbers from -1 to 2
      }
      for (int combination = 0; combination < combinations; ++combination)
      {
        int insideInputs = 0;
        int insideTools = 0;
        int multiple = 0;
        std::vector<int> windings;
        for (int i = 0, rest = combination; i < inputs + tools; ++i, rest /= 4)
        {
          const int winding = rest % 4 - 1;
          windings.push_back(winding);
          (i < inputs ? insideInputs : insideTools) += winding >= 1;
          multiple += winding < 0 || winding > 1;
        }
        const bool expected[] = { insideInputs + insideTools > 0,
          tools == 0 ? insideInputs == inputs : insideInputs > 0 && insideTools > 0,
          insideInputs > 0 && insideTools == 0, (insideInputs > 0) != (insideTools > 0),
          insideInputs + insideTools > 0 };
        for (std::size_t op = 0; op < 5; ++op)
        {
          sb::InsideCount count(stage.World, AllOperations[op]);
          CHECK_EQUAL(count.IsInside(), false);
          for (std::size_t i = 0; i < windings.size(); ++i)
          {
            count.Add(static_cast<std::int32_t>(i), 5);
            count.Add(static_cast<std::int32_t>(i), windings[i] - 5);
            CHECK_EQUAL(
              count.IsMultiple(static_cast<std::int32_t>(i)), windings[i] < 0 || windings[i] > 1);
          }
          CHECK_EQUAL(count.IsInside(), expected[op]);
          CHECK_EQUAL(count.NumberOfMultiple(), multiple);
        }
      }
    }
  }
}

} // namespace

int main()
{
  CheckNested();
  CheckStacks();
  CheckRandomStacks();
  CheckOverlaps();
  CheckSheets();
  CheckInsideCount();
  return check::Verdict("TestClassification");
}
