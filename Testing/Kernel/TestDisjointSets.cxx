// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestDisjointSets.cxx
 * @brief A set is named by its smallest member, whatever the order of the unions.
 */
#include "Check.h"
#include "DisjointSets.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace
{

using Edges = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** The smallest member of each element's set, by repeated relaxation over the edges. */
std::vector<std::int32_t> NamesByRelaxation(std::int32_t count, const Edges& edges)
{
  std::vector<std::int32_t> names(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i)
  {
    names[static_cast<std::size_t>(i)] = i;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const auto& [a, b] : edges)
    {
      std::int32_t& nameOfA = names[static_cast<std::size_t>(a)];
      std::int32_t& nameOfB = names[static_cast<std::size_t>(b)];
      changed = changed || nameOfA != nameOfB;
      nameOfA = nameOfB = std::min(nameOfA, nameOfB);
    }
  }
  return names;
}

Edges RandomEdges(std::int32_t count, std::size_t number, std::mt19937& random)
{
  std::uniform_int_distribution<std::int32_t> member(0, count - 1);
  Edges edges(number);
  for (auto& [a, b] : edges)
  {
    a = member(random);
    b = member(random);
  }
  return edges;
}

void SetsAreNamedByTheirSmallestMember()
{
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round)
  {
    const std::int32_t count = 1 + round;
    Edges edges = RandomEdges(count, static_cast<std::size_t>(round * (round % 4) / 3), random);
    const std::vector<std::int32_t> names = NamesByRelaxation(count, edges);
    for (int order = 0; order < 3; ++order)
    {
      std::shuffle(edges.begin(), edges.end(), random);
      sb::DisjointSets sets(count);
      for (const auto& [a, b] : edges)
      {
        sets.Unite(a, b);
      }
      bool same = true;
      for (std::int32_t i = 0; i < count; ++i)
      {
        same = same && sets.Find(i) == names[static_cast<std::size_t>(i)];
      }
      CHECK(same);
    }
  }
}

void UniteSaysWhetherThereWereTwoSets()
{
  std::mt19937 random(2);
  for (int round = 1; round < 100; ++round)
  {
    sb::DisjointSets sets(round);
    std::int32_t numberOfSets = round;
    for (const auto& [a, b] : RandomEdges(round, static_cast<std::size_t>(2 * round), random))
    {
      const bool wereTwo = sets.Find(a) != sets.Find(b);
      CHECK_EQUAL(sets.Unite(a, b), wereTwo);
      numberOfSets -= wereTwo ? 1 : 0;
    }
    std::int32_t roots = 0;
    for (std::int32_t i = 0; i < round; ++i)
    {
      roots += sets.Find(i) == i ? 1 : 0;
    }
    CHECK_EQUAL(roots, numberOfSets);
  }
}

void ResetForgets()
{
  sb::DisjointSets sets(4);
  sets.Unite(3, 0);
  sets.Reset(5);
  CHECK_EQUAL(sets.Size(), 5);
  for (std::int32_t i = 0; i < 5; ++i)
  {
    CHECK_EQUAL(sets.Find(i), i);
  }
}

/** The order that makes naive linking quadratic: a chain, joined from its end. */
void AChainOfAMillionIsNotQuadratic()
{
  const std::int32_t count = 1000000;
  sb::DisjointSets sets(count);
  for (std::int32_t i = count - 1; i > 0; --i)
  {
    sets.Unite(i, i - 1);
  }
  bool same = true;
  for (std::int32_t i = count - 1; i >= 0; --i)
  {
    same = same && sets.Find(i) == 0;
  }
  CHECK(same);
}

} // namespace

int main()
{
  SetsAreNamedByTheirSmallestMember();
  UniteSaysWhetherThereWereTwoSets();
  ResetForgets();
  AChainOfAMillionIsNotQuadratic();
  return check::Verdict("TestDisjointSets");
}
