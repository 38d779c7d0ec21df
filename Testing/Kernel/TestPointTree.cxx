// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPointTree.cxx
 * @brief Neighbours are those that trying all points finds; a permuted cloud gives the same tree;
 * duplicates and points that are not finite are left out; the spacing is that of a known cloud.
 */
#include "Check.h"
#include "Clouds.h"
#include "PointTree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace
{

std::vector<double> RandomPoints(int count, std::mt19937& random, int steps)
{
  // On a coarse lattice, so that equal coordinates and equal distances occur.
  std::uniform_int_distribution<int> step(0, steps);
  std::set<sb::Real3> places;
  while (static_cast<int>(places.size()) < count)
  {
    places.insert({ double(step(random)), double(step(random)), double(step(random)) });
  }
  std::vector<sb::Real3> shuffled(places.begin(), places.end());
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  std::vector<double> points;
  for (const sb::Real3& place : shuffled)
  {
    points.insert(points.end(), place.begin(), place.end());
  }
  return points;
}

sb::PointTree TreeOf(const std::vector<double>& points, int threads = 1)
{
  sb::ThreadExecutor executor(threads);
  return sb::PointTree(
    points.data(), static_cast<std::int64_t>(points.size() / 3), nullptr, executor);
}

void NeighboursAreThoseOfTryingAll()
{
  std::mt19937 random(1);
  for (const int count : { 1, 2, 23, 24, 25, 100, 777, 5000 })
  {
    const sb::PointTree tree = TreeOf(RandomPoints(count, random, 40));
    CHECK_EQUAL(tree.Size(), count);
    for (int query = 0; query < 30; ++query)
    {
      std::uniform_real_distribution<double> place(-5.0, 45.0);
      const sb::Real3 x{ place(random), std::floor(place(random)), place(random) };
      std::vector<std::pair<double, std::int32_t>> all;
      for (std::int32_t i = 0; i < count; ++i)
      {
        const sb::Real3 away = sb::Difference(x, tree.Point(i));
        all.emplace_back(sb::Dot(away, away), i);
      }
      std::sort(all.begin(), all.end());
      sb::PointTree::Neighbour found[16];
      const int number = tree.Nearest(x, 16, found);
      CHECK_EQUAL(number, std::min(16, count));
      for (int k = 0; k < number; ++k)
      {
        CHECK(found[k].Index == all[static_cast<std::size_t>(k)].second);
      }
      const double radius = 7.0;
      std::set<std::int32_t> visited;
      tree.ForRangesWithin(x, radius, [&](std::int32_t begin, std::int32_t end) {
        for (std::int32_t i = begin; i < end; ++i)
        {
          CHECK(visited.insert(i).second);
        }
      });
      for (const auto& one : all)
      {
        CHECK(one.first >= radius * radius || visited.count(one.second) == 1);
      }
    }
  }
}

void PermutedPointsGiveTheSameTree()
{
  std::mt19937 random(2);
  const std::vector<double> points = RandomPoints(3000, random, 25);
  std::vector<std::size_t> order(3000);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  std::vector<double> permuted;
  for (const std::size_t i : order)
  {
    permuted.insert(permuted.end(), points.begin() + 3 * std::ptrdiff_t(i),
      points.begin() + 3 * std::ptrdiff_t(i) + 3);
  }
  const sb::PointTree one = TreeOf(points);
  const sb::PointTree other = TreeOf(permuted, 3);
  for (std::int32_t i = 0; i < 3000; ++i)
  {
    CHECK(one.Point(i) == other.Point(i));
    CHECK_EQUAL(static_cast<std::size_t>(one.Id(i)), order[static_cast<std::size_t>(other.Id(i))]);
  }
}

void DuplicatesAndWhatIsNotFiniteAreLeftOut()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<double> points{ 1, 2, 3, nan, 0, 0, 1, 2, 3, 4, 5, 6, 0, -infinite, 0, 1, 2,
    3 };
  const std::vector<double> preference{ 9, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0 };
  sb::SerialExecutor executor;
  const sb::PointTree tree(points.data(), 6, preference.data(), executor);
  CHECK_EQUAL(tree.Size(), 2);
  CHECK_EQUAL(tree.NumberOfDuplicates(), 2);
  CHECK_EQUAL(tree.NumberOfNotFinite(), 2);
  CHECK(tree.Id(0) == 2 || tree.Id(1) == 2); // the one whose preference comes first
  CHECK_EQUAL(sb::PointTree(nullptr, 0, nullptr, executor).Size(), 0);
  sb::PointTree::Neighbour found[3];
  CHECK_EQUAL(sb::PointTree().Nearest({ 0, 0, 0 }, 3, found), 0);
}

void SpacingIsTheSideOfAPointsSquare()
{
  sb::ThreadExecutor executor(2);
  const clouds::Cloud sphere = clouds::Sphere(20000);
  const double side = std::sqrt(4.0 * clouds::Pi / 20000);
  CHECK(std::abs(sb::SpacingOf(TreeOf(sphere.Points), executor) / side - 1.0) < 0.12);
  std::mt19937 random(3);
  const clouds::Cloud torus = clouds::Torus(20000, random);
  const double ofTorus = std::sqrt(4.0 * clouds::Pi * clouds::Pi * 0.4 / 20000);
  CHECK(std::abs(sb::SpacingOf(TreeOf(torus.Points), executor) / ofTorus - 1.0) < 0.05);
  CHECK_EQUAL(sb::SpacingOf(TreeOf({ 1, 2, 3 }), executor), 0.0);
  CHECK_EQUAL(sb::SpacingOf(sb::PointTree(), executor), 0.0);
}

} // namespace

int main()
{
  NeighboursAreThoseOfTryingAll();
  PermutedPointsGiveTheSameTree();
  DuplicatesAndWhatIsNotFiniteAreLeftOut();
  SpacingIsTheSideOfAPointsSquare();
  return check::Verdict("TestPointTree");
}
