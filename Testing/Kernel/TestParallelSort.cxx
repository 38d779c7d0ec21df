// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestParallelSort.cxx
 * @brief Sorts and prefix sums agree with the standard library's, for any number of threads; so
 * does the thread pool cover each range once.
 */
#include "Check.h"
#include "ParallelSort.h"
#include "ThreadExecutor.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace
{

const std::vector<std::size_t> Sizes = { 0, 1, 2, 3, 511, 512, 513, 8191, 16384, 16387, 100003,
  400000 };

/** Keys of different kinds: all bits, few values, one value, sorted, reversed, only high bits. */
std::uint64_t MakeKey(int kind, std::size_t i, std::mt19937_64& random)
{
  switch (kind)
  {
    case 0:
      return random();
    case 1:
      return random() % 7;
    case 2:
      return 42;
    case 3:
      return i;
    case 4:
      return ~std::uint64_t(i);
    default:
      return random() << 50;
  }
}

void RadixSortIsAStableSort(sb::Executor& executor)
{
  std::mt19937_64 random(1);
  for (const std::size_t size : Sizes)
  {
    for (int kind = 0; kind < 6; ++kind)
    {
      std::vector<sb::KeyedIndex> values(size);
      for (std::size_t i = 0; i < size; ++i)
      {
        values[i] = { MakeKey(kind, i, random), static_cast<std::int32_t>(i) };
      }
      for (const int bits : { 64, 63, 13, 1 })
      {
        const std::uint64_t mask = ~std::uint64_t(0) >> (64 - bits);
        std::vector<sb::KeyedIndex> expected = values;
        std::stable_sort(expected.begin(), expected.end(),
          [mask](const auto& a, const auto& b) { return (a.Key & mask) < (b.Key & mask); });
        std::vector<sb::KeyedIndex> found = values;
        sb::RadixSort(
          found, [](const sb::KeyedIndex& value) { return value.Key; }, bits, executor);
        CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
          [](const auto& a, const auto& b) { return a.Key == b.Key && a.Index == b.Index; }));
      }
    }
  }
}

void ParallelSortIsASort(sb::Executor& executor)
{
  using Value = std::tuple<std::int32_t, std::string>;
  std::mt19937_64 random(2);
  for (const std::size_t size : Sizes)
  {
    for (const std::uint64_t range : { 3u, 1000u, 4000000000u })
    {
      std::vector<Value> values(size);
      for (Value& value : values)
      {
        value = { static_cast<std::int32_t>(random() % range / 2), std::to_string(random() % 5) };
      }
      std::vector<Value> expected = values;
      std::sort(expected.begin(), expected.end(), std::greater<>());
      sb::ParallelSort(values, std::greater<>(), executor);
      CHECK(values == expected);
    }
  }
}

void SortUniqueKeepsEachValueOnce(sb::Executor& executor)
{
  std::mt19937_64 random(4);
  for (const std::size_t size : Sizes)
  {
    std::vector<std::int32_t> values(size);
    for (std::int32_t& value : values)
    {
      value = static_cast<std::int32_t>(random() % (size / 3 + 1));
    }
    const std::set<std::int32_t> expected(values.begin(), values.end());
    sb::ParallelSortUnique(values, executor);
    CHECK(std::equal(values.begin(), values.end(), expected.begin(), expected.end()));
  }
}

void PrefixSumIsExclusive(sb::Executor& executor)
{
  std::mt19937_64 random(3);
  for (const std::size_t size : Sizes)
  {
    std::vector<std::int64_t> values(size);
    for (std::int64_t& value : values)
    {
      value = static_cast<std::int64_t>(random() % 1000) - 300;
    }
    std::vector<std::int64_t> expected(size);
    std::exclusive_scan(values.begin(), values.end(), expected.begin(), std::int64_t(0));
    const std::int64_t total = std::accumulate(values.begin(), values.end(), std::int64_t(0));
    CHECK_EQUAL(sb::ExclusivePrefixSum(values, executor), total);
    CHECK(values == expected);
  }
}

void EachIndexIsCoveredOnce(sb::Executor& executor)
{
  for (const std::int64_t count : { 0, 1, 7, 1000, 12345 })
  {
    for (const std::int64_t grain : { 0, 1, 3, 1000, 100000 })
    {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
      executor.For(count, grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          ++visits[static_cast<std::size_t>(i)];
        }
      });
      CHECK(std::all_of(visits.begin(), visits.end(), [](const auto& n) { return n == 1; }));
    }
  }
}

void LoopsNest(sb::Executor& executor)
{
  std::atomic<std::int64_t> sum{ 0 };
  executor.For(50, 1, [&](std::int64_t begin, std::int64_t end) {
    executor.For(100, 7, [&](std::int64_t innerBegin, std::int64_t innerEnd) {
      sum += (end - begin) * (innerEnd - innerBegin);
    });
  });
  CHECK_EQUAL(sum.load(), 5000);
}

void AnExceptionReachesTheCaller(sb::Executor& executor)
{
  bool caught = false;
  try
  {
    executor.For(1000, 1, [](std::int64_t begin, std::int64_t) {
      if (begin == 700)
      {
        throw std::runtime_error("seven hundred");
      }
    });
  }
  catch (const std::runtime_error&)
  {
    caught = true;
  }
  CHECK(caught);
  EachIndexIsCoveredOnce(executor);
}

} // namespace

int main()
{
  for (const int threads : { 1, 2, 3, 5 })
  {
    sb::ThreadExecutor executor(threads);
    CHECK_EQUAL(executor.NumberOfThreads(), threads);
    EachIndexIsCoveredOnce(executor);
    LoopsNest(executor);
    AnExceptionReachesTheCaller(executor);
    RadixSortIsAStableSort(executor);
    SortUniqueKeepsEachValueOnce(executor);
    ParallelSortIsASort(executor);
    PrefixSumIsExclusive(executor);
  }
  return check::Verdict("TestParallelSort");
}
