// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BorderEdges.h"

#include <algorithm>
#include <cstdlib>

namespace sb
{
namespace
{

/** Of the edges that have their lower end in common: the upper one, and in the lowest bit the
 * direction. */
std::int64_t CountUnbalanced(std::uint64_t* first, std::uint64_t* last)
{
  std::sort(first, last);
  std::int64_t count = 0;
  while (first != last)
  {
    std::int64_t balance = 0;
    const std::uint64_t upper = *first >> 1;
    for (; first != last && *first >> 1 == upper; ++first)
    {
      balance += (*first & 1u) ? 1 : -1;
    }
    count += std::abs(balance);
  }
  return count;
}

} // namespace

std::int64_t CountBorderEdges(
  const std::vector<std::int32_t>& triangles, std::size_t numberOfPoints)
{
  const auto next = [](std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  // By their lower end, of which each has few.
  std::vector<std::size_t> ends(numberOfPoints + 1, 0);
  for (std::size_t corner = 0; corner < triangles.size(); ++corner)
  {
    ++ends[static_cast<std::size_t>(std::min(triangles[corner], triangles[next(corner)]))];
  }
  std::size_t sum = 0;
  for (std::size_t& end : ends)
  {
    sum += end;
    end = sum;
  }
  std::vector<std::uint64_t> edges(triangles.size());
  for (std::size_t corner = 0; corner < triangles.size(); ++corner)
  {
    const std::int32_t from = triangles[corner];
    const std::int32_t to = triangles[next(corner)];
    edges[--ends[static_cast<std::size_t>(std::min(from, to))]] =
      static_cast<std::uint64_t>(std::max(from, to)) << 1 | (from < to ? 1u : 0u);
  }
  std::int64_t count = 0;
  for (std::size_t point = 0; point < numberOfPoints; ++point)
  {
    count += CountUnbalanced(edges.data() + ends[point], edges.data() + ends[point + 1]);
  }
  return count;
}

} // namespace sb
