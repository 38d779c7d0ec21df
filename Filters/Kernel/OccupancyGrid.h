// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OccupancyGrid.h
 * @brief Which cells of a regular grid are touched by one surface only, and which by several.
 *
 * Each cell knows nobody, one owner, or "shared". What a cell ends up as does not depend on the order of the marks, so
 * all threads mark at once. A box that covers too many cells is marked in a coarser copy of the grid (each level halves
 * the resolution), and the coarser marks are handed down before the grid is asked.
 */
#ifndef sb_OccupancyGrid_h
#define sb_OccupancyGrid_h

#include "BVH.h"
#include "Executor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

/** The cells First..Last, both included, on each axis. */
struct CellRange
{
  std::array<std::int32_t, 3> First;
  std::array<std::int32_t, 3> Last;

  std::int64_t Count() const
  {
    return static_cast<std::int64_t>(this->Last[0] - this->First[0] + 1) *
      (this->Last[1] - this->First[1] + 1) * (this->Last[2] - this->First[2] + 1);
  }

  CellRange Coarsened(std::size_t level) const
  {
    CellRange coarse;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      coarse.First[axis] = this->First[axis] >> level;
      coarse.Last[axis] = this->Last[axis] >> level;
    }
    return coarse;
  }

  /** The finest level on which there are no more than `most` of them. */
  std::size_t LevelFor(std::int64_t most) const
  {
    std::size_t level = 0;
    while (this->Coarsened(level).Count() > most)
    {
      ++level;
    }
    return level;
  }
};

/** A region of space in equal cells. */
class GridShape
{
public:
  GridShape(const Box& region, const std::array<double, 3>& cellSides)
    : Region(region)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->CellsAUnit[axis] = 1.0 / cellSides[axis];
      this->Size[axis] = this->Cell(region.Upper[axis], axis) + 1;
    }
  }

  const std::array<std::int32_t, 3>& CellsAnAxis() const { return this->Size; }

  /** The cells that a box touches inside the region, which it has to meet. Boxes that meet there share a cell. */
  CellRange Cells(const Box& box) const
  {
    CellRange range;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      range.First[axis] = this->Cell(std::max(box.Lower[axis], this->Region.Lower[axis]), axis);
      range.Last[axis] = this->Cell(std::min(box.Upper[axis], this->Region.Upper[axis]), axis);
    }
    return range;
  }

private:
  /** Monotone, so what holds for coordinates holds for cells. */
  std::int32_t Cell(double coordinate, std::size_t axis) const
  {
    return static_cast<std::int32_t>(
      (coordinate - this->Region.Lower[axis]) * this->CellsAUnit[axis]);
  }

  Box Region;
  std::array<double, 3> CellsAUnit;
  std::array<std::int32_t, 3> Size;
};

class OccupancyGrid
{
public:
  using Owner = std::uint16_t;
  static constexpr Owner Nobody = 0;
  static constexpr Owner Shared = 0xffff;

  /** A block of cells on the finest level, short enough to be kept for each candidate. */
  struct Block
  {
    std::uint32_t First; ///< number of its first cell
    std::array<std::uint8_t, 3> Steps; ///< how many cells follow, on each axis
  };

  explicit OccupancyGrid(const std::array<std::int32_t, 3>& cellsAnAxis) { this->AddLevel(cellsAnAxis); }

  /** The owner that stands for surface i. Those that the type has no number for count as shared: the safe side. */
  static Owner OwnerOf(std::int32_t surface)
  {
    return surface < Shared - 1 ? static_cast<Owner>(surface + 1) : Shared;
  }

  /** The range must not be longer than 256 cells on any axis. */
  Block ToBlock(const CellRange& cells) const
  {
    Block block;
    block.First = static_cast<std::uint32_t>(this->Levels.front().At(cells.First));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block.Steps[axis] = static_cast<std::uint8_t>(cells.Last[axis] - cells.First[axis]);
    }
    return block;
  }

  /** Make the coarser levels up to `level`. Not to be called while others mark. */
  void AddLevelsUpTo(std::size_t level)
  {
    while (this->Levels.size() <= level)
    {
      const std::array<std::int32_t, 3>& finer = this->Levels.back().Size;
      this->AddLevel({ (finer[0] + 1) / 2, (finer[1] + 1) / 2, (finer[2] + 1) / 2 });
    }
  }

  /** May be called from all threads at once, like the other Mark. */
  void Mark(const Block& cells, Owner owner)
  {
    Level& grid = this->Levels.front();
    grid.Any(cells.First, cells.Steps[0], cells.Steps[1], cells.Steps[2],
      [owner, &grid](std::size_t cell) { return Join(grid.Cells[cell], owner); });
  }

  void Mark(const CellRange& cells, std::size_t level, Owner owner)
  {
    Level& grid = this->Levels[level];
    grid.Any(cells.Coarsened(level), [owner, &grid](std::size_t cell) { return Join(grid.Cells[cell], owner); });
  }

  bool AnyShared(const Block& cells) const
  {
    const Level& grid = this->Levels.front();
    return grid.Any(cells.First, cells.Steps[0], cells.Steps[1], cells.Steps[2],
      [&grid](std::size_t cell) { return grid.IsShared(cell); });
  }

  bool AnyShared(const CellRange& cells) const
  {
    const Level& grid = this->Levels.front();
    return grid.Any(cells, [&grid](std::size_t cell) { return grid.IsShared(cell); });
  }

  /** Hand the marks of the coarser levels down to the finest, the only one that AnyShared looks at. */
  void HandDown(Executor& executor)
  {
    for (std::size_t level = this->Levels.size() - 1; level > 0; --level)
    {
      const Level& coarse = this->Levels[level];
      Level& fine = this->Levels[level - 1];
      executor.For(fine.Size[2], 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int32_t z = static_cast<std::int32_t>(begin); z < end; ++z)
        {
          HandDownLayer(coarse, fine, z);
        }
      });
    }
  }

private:
  struct Level
  {
    std::array<std::int32_t, 3> Size;
    std::size_t Row;   ///< cells from one to the next along y
    std::size_t Layer; ///< and along z
    std::vector<std::atomic<Owner>> Cells;

    std::size_t At(const std::array<std::int32_t, 3>& place) const
    {
      return static_cast<std::size_t>(place[2]) * this->Layer +
        static_cast<std::size_t>(place[1]) * this->Row + static_cast<std::size_t>(place[0]);
    }

    bool IsShared(std::size_t cell) const
    {
      return this->Cells[cell].load(std::memory_order_relaxed) == Shared;
    }

    /** Call test(cell) for the cells of a block until one is true; returns whether one was. */
    template <class Test>
    bool Any(std::size_t first, std::size_t stepsX, std::size_t stepsY, std::size_t stepsZ, Test&& test) const
    {
      for (std::size_t layer = first; layer <= first + stepsZ * this->Layer; layer += this->Layer)
      {
        for (std::size_t row = layer; row <= layer + stepsY * this->Row; row += this->Row)
        {
          for (std::size_t cell = row; cell <= row + stepsX; ++cell)
          {
            if (test(cell))
            {
              return true;
            }
          }
        }
      }
      return false;
    }

    template <class Test>
    bool Any(const CellRange& cells, Test&& test) const
    {
      return this->Any(this->At(cells.First), static_cast<std::size_t>(cells.Last[0] - cells.First[0]),
        static_cast<std::size_t>(cells.Last[1] - cells.First[1]),
        static_cast<std::size_t>(cells.Last[2] - cells.First[2]), test);
    }
  };

  void AddLevel(const std::array<std::int32_t, 3>& size)
  {
    const std::size_t row = static_cast<std::size_t>(size[0]);
    const std::size_t layer = row * static_cast<std::size_t>(size[1]);
    this->Levels.push_back({ size, row, layer,
      std::vector<std::atomic<Owner>>(layer * static_cast<std::size_t>(size[2])) });
  }

  /** Always false, so that Any goes on to the next cell. */
  static bool Join(std::atomic<Owner>& cell, Owner owner)
  {
    Owner known = cell.load(std::memory_order_relaxed);
    while (known != owner && known != Shared)
    {
      const Owner joined = known == Nobody ? owner : Shared;
      if (cell.compare_exchange_weak(known, joined, std::memory_order_relaxed))
      {
        break;
      }
    }
    return false;
  }

  static void HandDownLayer(const Level& coarse, Level& fine, std::int32_t z)
  {
    for (std::int32_t y = 0; y < fine.Size[1]; ++y)
    {
      const std::size_t above = coarse.At({ 0, y / 2, z / 2 });
      const std::size_t row = fine.At({ 0, y, z });
      for (std::size_t x = 0; x < fine.Row; ++x)
      {
        const Owner owner = coarse.Cells[above + x / 2].load(std::memory_order_relaxed);
        if (owner != Nobody)
        {
          Join(fine.Cells[row + x], owner);
        }
      }
    }
  }

  std::vector<Level> Levels;
};

} // namespace sb

#endif
