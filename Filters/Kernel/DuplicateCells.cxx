// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DuplicateCells.h"

#include "Hash.h"
#include "ParallelSort.h"

#include <algorithm>
#include <numeric>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 1 << 14;
constexpr int HashBits = 33; // three digits of the radix sort; those that share them are compared

/** The different corners of a cell, ascending. */
void ListCorners(const std::vector<std::int32_t>& corners, const CellRuns& cells, std::int64_t cell,
  std::vector<std::int32_t>& list)
{
  list.assign(corners.begin() + 3 * std::ptrdiff_t(cells.First(cell)),
    corners.begin() + 3 * std::ptrdiff_t(cells.First(cell + 1)));
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

std::uint64_t HashOf(const std::vector<std::int32_t>& list)
{
  std::uint64_t sum = 0;
  for (const std::int32_t corner : list)
  {
    sum += Mix(static_cast<std::uint64_t>(corner) + 0x9e3779b97f4a7c15u);
  }
  return Mix(sum);
}

std::vector<KeyedIndex> HashCells(
  const std::vector<std::int32_t>& corners, const CellRuns& cells, Executor& executor)
{
  std::vector<KeyedIndex> keys(static_cast<std::size_t>(cells.NumberOfCells));
  executor.For(cells.NumberOfCells, Grain, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::int32_t> list;
    for (std::int64_t cell = begin; cell < end; ++cell)
    {
      ListCorners(corners, cells, cell, list);
      // A cell of which nothing is left is no copy of others like it.
      keys[std::size_t(cell)] = { list.empty() ? Mix(static_cast<std::uint64_t>(cell))
                                               : HashOf(list),
        static_cast<std::int32_t>(cell) };
    }
  });
  return keys;
}

} // namespace

std::vector<std::int32_t> FindDuplicateCells(
  const std::vector<std::int32_t>& corners, const CellRuns& cells, Executor& executor)
{
  std::vector<KeyedIndex> keys = HashCells(corners, cells, executor);
  const std::uint64_t mask = (std::uint64_t(1) << HashBits) - 1;
  RadixSort(
    keys, [](const KeyedIndex& keyed) { return keyed.Key; }, HashBits, executor);
  std::vector<std::int32_t> first;
  std::vector<std::int32_t> mine;
  std::vector<std::int32_t> others;
  // The sort is stable, so the first of equal cells comes first.
  for (std::size_t begin = 0; begin < keys.size();)
  {
    std::size_t end = begin + 1;
    for (; end < keys.size() && ((keys[end].Key ^ keys[begin].Key) & mask) == 0; ++end)
    {
      ListCorners(corners, cells, keys[end].Index, mine);
      for (std::size_t other = begin; other < end && !mine.empty(); ++other)
      {
        ListCorners(corners, cells, keys[other].Index, others);
        if (mine == others)
        {
          first.resize(keys.size(), -1);
          first[std::size_t(keys[end].Index)] = keys[other].Index;
          break;
        }
      }
    }
    begin = end;
  }
  for (std::size_t cell = 0; cell < first.size(); ++cell)
  {
    first[cell] = first[cell] < 0 ? static_cast<std::int32_t>(cell) : first[cell];
  }
  return first;
}

} // namespace sb
