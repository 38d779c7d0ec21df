// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellGroups.h
 * @brief Goes through a list of triangles cell by cell.
 */
#ifndef sb_CellGroups_h
#define sb_CellGroups_h

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sb
{

/**
 * Visit triangles, those of one cell together.
 * @param faces ascending
 * @param firstTriangles of each cell, and the end of the last; null if each triangle is a cell
 * @param visit gets the range of `faces` in a cell, and the range of all triangles of that cell
 */
template <class Visitor>
void VisitCells(const std::vector<std::int32_t>& faces, const std::int32_t* firstTriangles,
  std::int64_t numberOfCells, Visitor&& visit)
{
  for (auto begin = faces.begin(), end = begin; begin != faces.end(); begin = end)
  {
    std::int32_t first = *begin;
    std::int32_t last = first + 1;
    if (firstTriangles)
    {
      const std::int32_t* next =
        std::upper_bound(firstTriangles, firstTriangles + numberOfCells + 1, *begin);
      first = *(next - 1);
      last = *next;
    }
    end = std::lower_bound(begin, faces.end(), last);
    visit(begin, end, first, last);
  }
}

} // namespace sb

#endif
