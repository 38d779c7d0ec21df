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

/** Whether a cell may have a copy, by its neighbour at one of its outer edges. */
bool MayHaveCopy(const std::vector<std::int32_t>& corners, const CellRuns& cells,
  const MeshEdges& edges, std::int64_t cell)
{
  const HalfEdge begin = 3 * cells.First(cell);
  const HalfEdge end = 3 * cells.First(cell + 1);
  HalfEdge half = begin;
  while (
    half < end && edges.Mates[std::size_t(half)] >= begin && edges.Mates[std::size_t(half)] < end)
  {
    ++half; // an edge between triangles of the cell
  }
  if (half == end || edges.Mates[std::size_t(half)] < 0)
  {
    return begin < end; // all are inner edges, or this one is not that of two cells
  }
  const std::int64_t other = cells.CellOf(edges.Mates[std::size_t(half)] / 3);
  if (3 * (cells.First(other + 1) - cells.First(other)) != end - begin)
  {
    return false;
  }
  for (HalfEdge mine = begin; mine < end; ++mine)
  {
    const auto first = corners.begin() + 3 * std::ptrdiff_t(cells.First(other));
    if (std::find(first, first + (end - begin), corners[std::size_t(mine)]) ==
      first + (end - begin))
    {
      return false;
    }
  }
  return true;
}

/** The cells that may have copies, with hashes of their corners. */
std::vector<KeyedIndex> HashCells(const std::vector<std::int32_t>& corners, const CellRuns& cells,
  const MeshEdges& edges, Executor& executor)
{
  const std::int64_t count = cells.NumberOfCells;
  std::vector<std::vector<KeyedIndex>> parts(std::size_t((count + Grain - 1) / Grain));
  executor.For(
    static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      std::vector<std::int32_t> list;
      for (std::int64_t part = begin; part < end; ++part)
      {
        for (std::int64_t cell = part * Grain; cell < std::min(count, (part + 1) * Grain); ++cell)
        {
          if (MayHaveCopy(corners, cells, edges, cell))
          {
            ListCorners(corners, cells, cell, list);
            parts[std::size_t(part)].push_back({ HashOf(list), static_cast<std::int32_t>(cell) });
          }
        }
      }
    });
  std::vector<KeyedIndex> keys;
  for (const std::vector<KeyedIndex>& part : parts)
  {
    keys.insert(keys.end(), part.begin(), part.end());
  }
  return keys;
}

} // namespace

std::vector<std::int32_t> FindDuplicateCells(const std::vector<std::int32_t>& corners,
  const CellRuns& cells, const MeshEdges& edges, Executor& executor)
{
  std::vector<KeyedIndex> keys = HashCells(corners, cells, edges, executor);
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
      for (std::size_t other = begin; other < end; ++other)
      {
        ListCorners(corners, cells, keys[other].Index, others);
        if (mine == others)
        {
          first.resize(std::size_t(cells.NumberOfCells), -1);
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
