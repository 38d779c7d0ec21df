// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ParallelSort.h
 * @brief Sorting and prefix sums over an Executor, the same result for any number of threads.
 *
 * RadixSort is the fast one where the order is that of an unsigned integer; ParallelSort takes any
 * strict order.
 */
#ifndef sb_ParallelSort_h
#define sb_ParallelSort_h

#include "Executor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sb
{

/** What to sort by and what to carry along: a Morton code and the number of the box it stands for,
 * for instance. */
struct KeyedIndex
{
  std::uint64_t Key;
  std::int32_t Index;
};

/** Replace each value by the sum of those before it; returns the sum of all. */
inline std::int64_t ExclusivePrefixSum(std::vector<std::int64_t>& values, Executor& executor)
{
  const std::int64_t count = static_cast<std::int64_t>(values.size());
  const std::int64_t grain =
    std::max<std::int64_t>(1 << 15, (count - 1) / executor.NumberOfThreads() + 1);
  std::vector<std::int64_t> sums(static_cast<std::size_t>((count + grain - 1) / grain), 0);
  const auto forEachBlock = [&](auto&& body) {
    executor.For(
      static_cast<std::int64_t>(sums.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end; ++block)
        {
          std::int64_t& sum = sums[static_cast<std::size_t>(block)];
          const std::int64_t last = std::min(count, (block + 1) * grain);
          for (std::int64_t i = block * grain; i < last; ++i)
          {
            body(values[static_cast<std::size_t>(i)], sum);
          }
        }
      });
  };
  forEachBlock([](std::int64_t value, std::int64_t& sum) { sum += value; });
  std::int64_t total = 0;
  for (std::int64_t& sum : sums)
  {
    total += std::exchange(sum, total);
  }
  forEachBlock([](std::int64_t& value, std::int64_t& sum) { sum += std::exchange(value, sum); });
  return total;
}

namespace detail
{

/** How many of the first `rank` elements of the merged sequence come from `left` (a binary search
 * over the diagonal). */
template <class T, class Less>
std::size_t TakenFromLeft(const T* left, std::size_t leftSize, const T* right,
  std::size_t rightSize, std::size_t rank, const Less& less)
{
  std::size_t low = rank > rightSize ? rank - rightSize : 0;
  std::size_t high = std::min(rank, leftSize);
  while (low < high)
  {
    const std::size_t middle = (low + high) / 2;
    if (less(right[rank - middle - 1], left[middle]))
    {
      high = middle;
    }
    else
    {
      low = middle + 1;
    }
  }
  return low;
}

} // namespace detail

/**
 * Sort by the strict order `less`. Elements that neither precedes must be equal in all that
 * matters: their order is the same for one number of threads only.
 */
template <class T, class Less>
void ParallelSort(std::vector<T>& values, Less less, Executor& executor)
{
  constexpr std::size_t smallestRun = 1 << 12;
  const std::size_t count = values.size();
  std::size_t runs = 1;
  while (runs < static_cast<std::size_t>(executor.NumberOfThreads()) &&
    count / (2 * runs) >= smallestRun)
  {
    runs *= 2;
  }
  // Runs start at count * run / runs, so that two neighbours make exactly one run of the next
  // round.
  const auto startOf = [count](std::size_t run, std::size_t numberOfRuns) {
    return count / numberOfRuns * run + count % numberOfRuns * run / numberOfRuns;
  };
  const std::int64_t tasks = static_cast<std::int64_t>(runs);
  executor.For(tasks, 1, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t run = begin; run < end; ++run)
    {
      const std::size_t r = static_cast<std::size_t>(run);
      std::sort(values.begin() + static_cast<std::ptrdiff_t>(startOf(r, runs)),
        values.begin() + static_cast<std::ptrdiff_t>(startOf(r + 1, runs)), less);
    }
  });
  if (runs == 1)
  {
    return;
  }
  std::vector<T> merged(count);
  const std::size_t numberOfTasks = runs;
  for (; runs > 1; runs /= 2)
  {
    // Each merge is cut into as many equal pieces as keep all threads at work.
    const std::size_t merges = runs / 2;
    const std::size_t pieces = numberOfTasks / merges;
    executor.For(tasks, 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t task = static_cast<std::size_t>(begin); task < static_cast<std::size_t>(end);
           ++task)
      {
        const std::size_t merge = task / pieces;
        const std::size_t piece = task % pieces;
        const std::size_t start = startOf(2 * merge, runs);
        const std::size_t leftSize = startOf(2 * merge + 1, runs) - start;
        const std::size_t size = startOf(2 * merge + 2, runs) - start;
        const T* const left = values.data() + start;
        const T* const right = left + leftSize;
        const std::size_t rank = size * piece / pieces;
        const std::size_t lastRank = size * (piece + 1) / pieces;
        const std::size_t first =
          detail::TakenFromLeft(left, leftSize, right, size - leftSize, rank, less);
        const std::size_t last =
          detail::TakenFromLeft(left, leftSize, right, size - leftSize, lastRank, less);
        std::merge(left + first, left + last, right + (rank - first), right + (lastRank - last),
          merged.data() + start + rank, less);
      }
    });
    values.swap(merged);
  }
}

/** Sort, and keep each value once. */
template <class T>
void ParallelSortUnique(std::vector<T>& values, Executor& executor)
{
  ParallelSort(
    values, [](const T& a, const T& b) { return a < b; }, executor);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/**
 * Stable sort by the `bits` lowest bits of key(value), an unsigned integer of 64 bits. Least
 * significant digit first; digits that all keys share cost a count only. Takes as much memory again
 * as the values.
 */
template <class T, class KeyOf>
void RadixSort(std::vector<T>& values, KeyOf key, int bits, Executor& executor)
{
  constexpr int digitBits = 11;
  constexpr std::size_t digits = std::size_t(1) << digitBits;
  const std::int64_t count = static_cast<std::int64_t>(values.size());
  if (count < 512)
  {
    const std::uint64_t mask = bits < 64 ? (std::uint64_t(1) << bits) - 1 : ~std::uint64_t(0);
    std::stable_sort(values.begin(), values.end(),
      [&](const T& a, const T& b) { return (key(a) & mask) < (key(b) & mask); });
    return;
  }
  const std::int64_t blocks =
    std::max<std::int64_t>(1, std::min<std::int64_t>(executor.NumberOfThreads(), count >> 13));
  const std::int64_t grain = (count + blocks - 1) / blocks;
  std::vector<std::array<std::uint32_t, digits>> places(static_cast<std::size_t>(blocks));
  std::vector<T> sorted(values.size());
  const auto forEachBlock = [&](auto&& body) {
    executor.For(blocks, 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t block = begin; block < end; ++block)
      {
        body(places[static_cast<std::size_t>(block)], values.data() + block * grain,
          values.data() + std::min(count, (block + 1) * grain));
      }
    });
  };
  for (int shift = 0; shift < bits; shift += digitBits)
  {
    const std::uint64_t mask = (std::uint64_t(1) << std::min(digitBits, bits - shift)) - 1;
    const auto digitOf = [&](const T& value) {
      return static_cast<std::size_t>(key(value) >> shift & mask);
    };
    forEachBlock([&](auto& place, const T* begin, const T* end) {
      place.fill(0);
      for (; begin != end; ++begin)
      {
        ++place[digitOf(*begin)];
      }
    });
    std::uint32_t next = 0;
    bool shared = false;
    for (std::size_t digit = 0; digit < digits; ++digit)
    {
      const std::uint32_t before = next;
      for (auto& place : places)
      {
        next += std::exchange(place[digit], next);
      }
      shared = shared || next - before == static_cast<std::uint32_t>(count);
    }
    if (shared)
    {
      continue;
    }
    forEachBlock([&](auto& place, const T* begin, const T* end) {
      for (; begin != end; ++begin)
      {
        sorted[place[digitOf(*begin)]++] = *begin;
      }
    });
    values.swap(sorted);
  }
}

} // namespace sb

#endif
