// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellRuns.h
 * @brief Which triangles make one polygon or strip: a run each.
 */
#ifndef sb_CellRuns_h
#define sb_CellRuns_h

#include <algorithm>
#include <cstdint>

namespace sb
{

struct CellRuns
{
  /** The first triangle of each cell, and the end of the last; null if each triangle is a cell. */
  const std::int32_t* Firsts = nullptr;
  std::int64_t NumberOfCells = 0;

  std::int32_t First(std::int64_t cell) const
  {
    return this->Firsts ? this->Firsts[cell] : static_cast<std::int32_t>(cell);
  }

  std::int32_t CellOf(std::int32_t triangle) const
  {
    return this->Firsts
      ? static_cast<std::int32_t>(
          std::upper_bound(this->Firsts, this->Firsts + this->NumberOfCells, triangle) -
          this->Firsts) -
        1
      : triangle;
  }
};

} // namespace sb

#endif
