// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OccupancyGrid.h
 * @brief Which cells of a regular grid are touched by one surface only, and which are shared by
 * several.
 *
 * A mark is a word that holds the bits of a surface's number and their complements. A cell collects
 * the union (bitwise or) of the marks made in it; that has a bit together with its complement just
 * when two of the surfaces differ. So the order of the marks does not matter, and all threads mark
 * at once.
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
#include <memory>
#include <vector>

namespace sb
{

/** The cells First..Last, both included, on each axis. */
struct CellRange
{
  std::array<std::int32_t, 3> First;
  std::array<std::int32_t, 3> Last;

  bool IsEmpty() const
  {
    return this->First[0] > this->Last[0] || this->First[1] > this->Last[1] ||
      this->First[2] > this->Last[2];
  }

  std::int64_t Count() const
  {
    return static_cast<std::int64_t>(this->Last[0] - this->First[0] + 1) *
      (this->Last[1] - this->First[1] + 1) * (this->Last[2] - this->First[2] + 1);
  }

  /** The cells that these lie in when the resolution has been halved `level` times. */
  CellRange Coarsened(int level) const
  {
    CellRange coarse;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      coarse.First[axis] = this->First[axis] >> level;
      coarse.Last[axis] = this->Last[axis] >> level;
    }
    return coarse;
  }

  /** How often the resolution has to be halved for no more than `most` cells. */
  int LevelFor(std::int64_t most) const
  {
    int level = 0;
    while (this->Coarsened(level).Count() > most)
    {
      ++level;
    }
    return level;
  }
};

/**
 * A region in equal cells, a power of two of them on each axis. The outermost layers of cells stand
 * for all that is outside the region.
 */
class GridShape
{
public:
  /** Cells to spare on an axis: the outer layers, and one because the region begins in mid cell. */
  static constexpr int Spare = 3;

  /** A code leaves this bit free. */
  static constexpr std::uint32_t FreeBit = 0x80000000u;

  GridShape(const Box& region, const std::array<int, 3>& bits, const std::array<double, 3>& sides)
    : Bits(bits)
    , Origin(region.Lower)
    , CellsAUnit{ 1.0 / sides[0], 1.0 / sides[1], 1.0 / sides[2] }
  {
    int shift = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Shift[axis] = shift;
      this->Field[axis] = ((1u << bits[axis]) - 1) << shift;
      this->Ones |= 1u << shift;
      this->Guards |= 1u << (shift + bits[axis]);
      shift += bits[axis] + 1;
    }
    this->Numbers = this->Guards - this->Ones;
  }

  const std::array<int, 3>& BitsAnAxis() const { return this->Bits; }

  /** The cell on one axis, monotone in the coordinate and clamped to first..last. */
  std::int32_t Cell(double coordinate, std::size_t axis, double first, double last) const
  {
    const double cell = (coordinate - this->Origin[axis]) * this->CellsAUnit[axis] + 1.5;
    return static_cast<std::int32_t>(std::min(std::max(cell, first), last));
  }

  /** The cells of a box inside the region. */
  CellRange Cells(const Box& box) const
  {
    CellRange range;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double last = (1 << this->Bits[axis]) - 2;
      range.First[axis] = this->Cell(box.Lower[axis], axis, 1.0, last);
      range.Last[axis] = this->Cell(box.Upper[axis], axis, 1.0, last);
    }
    return range;
  }

  /** A cell in one word: its three numbers, each with a zero above it, the guard bit. */
  std::uint32_t Code(const std::array<std::int32_t, 3>& cell) const
  {
    return static_cast<std::uint32_t>(cell[0]) |
      static_cast<std::uint32_t>(cell[1]) << this->Shift[1] |
      static_cast<std::uint32_t>(cell[2]) << this->Shift[2];
  }

  std::int32_t CellOf(std::uint32_t code, std::size_t axis) const
  {
    return static_cast<std::int32_t>((code & this->Field[axis]) >> this->Shift[axis]);
  }

  /** The place of a cell in an array: its code without the guard bits. */
  std::size_t Index(std::uint32_t code) const
  {
    return (code & this->Field[0]) | (code & this->Field[1]) >> 1 | (code & this->Field[2]) >> 2;
  }

  /**
   * Whether the box of points in these three cells touches no other cell: they are at most
   * neighbours of the first, and on one axis only. Looks at all three axes of a code at once; the
   * free bit is ignored.
   */
  bool IsCompact(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
  {
    // Adding all ones to a number carries into its guard bit unless it is zero.
    const std::uint32_t different = ((a ^ b) | (a ^ c)) & this->Numbers;
    const std::uint32_t axes = (different + this->Numbers) & this->Guards;
    const std::uint32_t apart = this->BeyondNext(a, b) | this->BeyondNext(b, a) |
      this->BeyondNext(a, c) | this->BeyondNext(c, a);
    return ((axes & (axes - 1)) | apart) == 0;
  }

private:
  /** Not zero if a number of `a` is less than that of `b` by two or more. */
  std::uint32_t BeyondNext(std::uint32_t a, std::uint32_t b) const
  {
    // With its guard bit set no number borrows from the next. What is left of the guard says that a
    // + 1 >= b.
    return ~((a | this->Guards) - b + this->Ones) & this->Guards;
  }

  std::array<int, 3> Bits;
  std::array<int, 3> Shift; ///< where each number starts in a code
  std::array<std::uint32_t, 3> Field; ///< and the bits it has there
  std::array<double, 3> Origin;
  std::array<double, 3> CellsAUnit;
  std::uint32_t Ones = 0; ///< the lowest bit of each number
  std::uint32_t Numbers = 0; ///< all bits of the numbers
  std::uint32_t Guards = 0; ///< the bits above them
};

/** The marks in the cells; a Word has twice as many bits as the surfaces' numbers need. */
template <class Word>
class OccupancyGrid
{
public:
  static constexpr Word Everybody = static_cast<Word>(~Word(0));

  /** The surfaces that a word has no number for mark as everybody does, which is on the safe side.
   */
  static Word MarkOf(std::int32_t surface)
  {
    const std::uint32_t number = static_cast<std::uint32_t>(surface);
    return number > LowHalf ? Everybody
                            : static_cast<Word>(number | (~number & LowHalf) << HalfBits);
  }

  explicit OccupancyGrid(const GridShape& shape)
    : Bits(shape.BitsAnAxis())
  {
    this->AddLevelsUpTo(0);
  }

  /** Make room for marks at half the resolution, a quarter and so on. Not while others mark. */
  void AddLevelsUpTo(int level)
  {
    while (static_cast<int>(this->Levels.size()) <= level)
    {
      const std::size_t size = this->NumberOfCells(static_cast<int>(this->Levels.size()));
      this->Levels.emplace_back(new std::atomic<Word>[size]());
    }
  }

  /** Mark the cell at an index of GridShape. May be called from all threads at once, like
   * MarkRange. */
  void MarkCell(std::size_t index, Word mark) { Add(this->Levels.front()[index], mark); }

  /** Mark a range of cells, at the resolution of `level`. */
  void MarkRange(const CellRange& cells, int level, Word mark)
  {
    std::atomic<Word>* const marks = this->Levels[static_cast<std::size_t>(level)].get();
    this->AnyCell(cells.Coarsened(level), level, [marks, mark](std::size_t cell) {
      Add(marks[cell], mark);
      return false;
    });
  }

  /** Give the marks made at coarser levels to all the cells they stand for. */
  void HandDown(Executor& executor)
  {
    for (int level = static_cast<int>(this->Levels.size()) - 1; level > 0; --level)
    {
      executor.For(static_cast<std::int64_t>(this->NumberOfCells(level - 1)), 1 << 16,
        [this, level](std::int64_t begin, std::int64_t end) {
          this->HandDownTo(
            level - 1, static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
        });
    }
  }

  /** Whether several surfaces have marked the cell. */
  bool IsShared(std::size_t index) const
  {
    const std::uint32_t marks = this->Levels.front()[index].load(std::memory_order_relaxed);
    return (marks & marks >> HalfBits & LowHalf) != 0;
  }

  bool AnyShared(const CellRange& cells) const
  {
    return this->AnyCell(cells, 0, [this](std::size_t cell) { return this->IsShared(cell); });
  }

private:
  static constexpr int HalfBits = 4 * sizeof(Word);
  static constexpr std::uint32_t LowHalf = (1u << HalfBits) - 1;

  static void Add(std::atomic<Word>& cell, Word mark)
  {
    // Most cells have the mark already; looking first saves the expensive write.
    if ((cell.load(std::memory_order_relaxed) & mark) != mark)
    {
      cell.fetch_or(mark, std::memory_order_relaxed);
    }
  }

  std::array<int, 3> BitsOf(int level) const
  {
    return { std::max(this->Bits[0] - level, 0), std::max(this->Bits[1] - level, 0),
      std::max(this->Bits[2] - level, 0) };
  }

  std::size_t NumberOfCells(int level) const
  {
    const std::array<int, 3> bits = this->BitsOf(level);
    return std::size_t(1) << (bits[0] + bits[1] + bits[2]);
  }

  /** Call test(index) for the cells of a range until it is true; returns whether it was. */
  template <class Test>
  bool AnyCell(const CellRange& cells, int level, Test&& test) const
  {
    const std::array<int, 3> bits = this->BitsOf(level);
    for (std::int32_t z = cells.First[2]; z <= cells.Last[2]; ++z)
    {
      for (std::int32_t y = cells.First[1]; y <= cells.Last[1]; ++y)
      {
        const std::size_t row =
          (static_cast<std::size_t>(z) << bits[1] | static_cast<std::size_t>(y)) << bits[0];
        for (std::int32_t x = cells.First[0]; x <= cells.Last[0]; ++x)
        {
          if (test(row | static_cast<std::size_t>(x)))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  void HandDownTo(int level, std::size_t begin, std::size_t end)
  {
    const std::array<int, 3> fine = this->BitsOf(level);
    const std::array<int, 3> coarse = this->BitsOf(level + 1);
    const std::atomic<Word>* const from = this->Levels[static_cast<std::size_t>(level) + 1].get();
    std::atomic<Word>* const to = this->Levels[static_cast<std::size_t>(level)].get();
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const std::size_t x = cell & ((std::size_t(1) << fine[0]) - 1);
      const std::size_t y = cell >> fine[0] & ((std::size_t(1) << fine[1]) - 1);
      const std::size_t z = cell >> (fine[0] + fine[1]);
      const std::size_t above = ((z / 2) << coarse[1] | y / 2) << coarse[0] | x / 2;
      Add(to[cell], from[above].load(std::memory_order_relaxed));
    }
  }

  std::array<int, 3> Bits;
  std::vector<std::unique_ptr<std::atomic<Word>[]>> Levels; ///< [0] is the finest
};

} // namespace sb

#endif
