// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OccupancyGrid.h
 * @brief Which parts of space have several surfaces near them, told from the surfaces' points by a grid of marks.
 *
 * A triangle is *small* if the cells of its second and third corner are neighbours of the cell of its first (or the
 * same). Its box then lies within one cell of each cell that its first corner is in. So it is enough that points mark
 * the cells they are in: spread by one cell, the marks cover all small boxes, and a cell that two surfaces' spread marks
 * share is *shared*. Two small triangles whose boxes meet have a shared cell within one cell of either first corner.
 * That takes one mark a point and one look a triangle, and the spreading is a handful of passes over a few bytes a cell.
 * A triangle that is not small marks all cells of its box.
 *
 * A mark is a word that holds the bits of the surface's number and their complements. The union (bitwise or) of marks
 * has a bit together with its complement just when two of them differ.
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

  /** How often to halve the resolution for no more than `most` cells. */
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
 * A region in equal cells, a power of two of them on each axis. There are two layers of cells around the region: the
 * inner one for points that may belong to a small triangle which reaches into it, the outer one for all points beyond.
 */
class GridShape
{
public:
  /** Cells to spare on an axis: two layers on either side, and one because the region may begin in mid cell. */
  static constexpr int Spare = 5;

  GridShape(const Box& region, const std::array<int, 3>& bits, const std::array<double, 3>& sides)
    : Bits(bits)
    , Origin(region.Lower)
    , CellsAUnit{ 1.0 / sides[0], 1.0 / sides[1], 1.0 / sides[2] }
  {
    int shift = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Shift[axis] = shift;
      this->Ones |= 1u << shift;
      this->Guards |= 1u << (shift + bits[axis]);
      shift += bits[axis] + 1;
    }
  }

  const std::array<int, 3>& BitsAnAxis() const { return this->Bits; }
  std::size_t NumberOfCells() const { return std::size_t(1) << (this->Bits[0] + this->Bits[1] + this->Bits[2]); }

  /** The cell on one axis, monotone in the coordinate and no less than `first`, no more than `last`. */
  std::int32_t Cell(double coordinate, std::size_t axis, std::int32_t first, std::int32_t last) const
  {
    const double cell = (coordinate - this->Origin[axis]) * this->CellsAUnit[axis] + 2.5;
    return static_cast<std::int32_t>(
      std::min(std::max(cell, static_cast<double>(first)), static_cast<double>(last)));
  }

  /** The cells of a box inside the region. */
  CellRange Cells(const Box& box) const
  {
    CellRange range;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int32_t last = (1 << this->Bits[axis]) - 3;
      range.First[axis] = this->Cell(box.Lower[axis], axis, 2, last);
      range.Last[axis] = this->Cell(box.Upper[axis], axis, 2, last);
    }
    return range;
  }

  /** A cell in one word, with a zero bit above each of its three numbers. Codes leave the highest bit of the word free. */
  std::uint32_t Code(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << this->Shift[1] |
      static_cast<std::uint32_t>(z) << this->Shift[2];
  }

  std::int32_t CellOfCode(std::uint32_t code, std::size_t axis) const
  {
    return static_cast<std::int32_t>(code >> this->Shift[axis] & ((1u << this->Bits[axis]) - 1));
  }

  /** The place of a cell in an array. */
  std::size_t Index(std::uint32_t code) const
  {
    const std::uint32_t x = code & ((1u << this->Shift[1]) - 1);
    const std::uint32_t y = code & ((1u << this->Shift[2]) - (1u << this->Shift[1]));
    const std::uint32_t z = code & ~HighestBit & ~((1u << this->Shift[2]) - 1);
    return x | y >> 1 | z >> 2;
  }

  static constexpr std::uint32_t HighestBit = 0x80000000u;

  /** Whether two cells are the same or neighbours, by face, edge or corner. */
  bool AreNeighbours(std::uint32_t a, std::uint32_t b) const
  {
    // All three numbers at once: with the guard bit set, no difference borrows from the next number. Plus one, a
    // difference of -1, 0 or 1 has no bits but the lowest two; so has 2, but not the other way round.
    const std::uint32_t forth = ((a | this->Guards) - b + this->Ones) ^ this->Guards;
    const std::uint32_t back = ((b | this->Guards) - a + this->Ones) ^ this->Guards;
    return ((forth | back) & ~(3u * this->Ones)) == 0;
  }

private:
  std::array<int, 3> Bits;
  std::array<int, 3> Shift;
  std::array<double, 3> Origin;
  std::array<double, 3> CellsAUnit;
  std::uint32_t Ones = 0;
  std::uint32_t Guards = 0;
};

/** The marks: a Word has twice as many bits as the surfaces' numbers need. */
template <class Word>
class OccupancyGrid
{
public:
  static constexpr Word Everybody = static_cast<Word>(~Word(0));

  /** The surfaces that a word has no number for mark as everybody does, which is on the safe side. */
  static Word MarkOf(std::int32_t surface)
  {
    const std::uint32_t number = static_cast<std::uint32_t>(surface);
    return number > LowHalf ? Everybody
                            : static_cast<Word>(number | (~number & LowHalf) << HalfBits);
  }

  explicit OccupancyGrid(const GridShape& shape)
    : Bits(shape.BitsAnAxis())
    , Padding(std::size_t(1) << (Bits[0] + Bits[1]))
  {
    this->AddLevelsUpTo(0);
  }

  /** Make room for marks on coarser levels. Not while others mark. */
  void AddLevelsUpTo(int level)
  {
    while (static_cast<int>(this->Levels.size()) <= level)
    {
      const std::array<int, 3> bits = this->BitsOf(static_cast<int>(this->Levels.size()));
      this->Levels.emplace_back(
        new std::atomic<Word>[std::size_t(1) << (bits[0] + bits[1] + bits[2])]());
    }
  }

  /** Mark the cell at an index of GridShape. May be called from all threads at once, like MarkRange. */
  void MarkCell(std::size_t index, Word mark) { Add(this->Levels.front()[index], mark); }

  /** Mark the cells of a range of the finest level on the given level. */
  void MarkRange(const CellRange& cells, int level, Word mark)
  {
    std::atomic<Word>* const marks = this->Levels[static_cast<std::size_t>(level)].get();
    this->ForEachRow(cells.Coarsened(level), level, [=](std::size_t first, std::size_t last) {
      std::for_each(marks + first, marks + last, [mark](std::atomic<Word>& cell) { Add(cell, mark); });
      return false;
    });
  }

  /** To be called once, after the last mark and before the first question. */
  void Spread(Executor& executor)
  {
    const std::size_t size = this->NumberOfCells(0);
    std::vector<Word> marks(size + 2 * this->Padding);
    std::vector<Word> spread(marks.size());
    this->HandDown(executor);
    ForEachCell(size, executor, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        marks[i + this->Padding] = this->Levels.front()[i].load(std::memory_order_relaxed);
      }
    });
    const std::ptrdiff_t row = std::ptrdiff_t(1) << this->Bits[0];
    const std::ptrdiff_t layer = row << this->Bits[1];
    this->SpreadAlong(1, marks, spread, executor);
    this->SpreadAlong(row, spread, marks, executor);
    this->SpreadAlong(layer, marks, spread, executor);
    this->Near.resize(marks.size());
    std::vector<std::uint8_t> shared(marks.size());
    ForEachCell(size, executor, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin + this->Padding; i < end + this->Padding; ++i)
      {
        shared[i] = (spread[i] & spread[i] >> HalfBits & LowHalf) != 0 ? 1 : 0;
      }
    });
    this->SpreadAlong(1, shared, this->Near, executor);
    this->SpreadAlong(row, this->Near, shared, executor);
    this->SpreadAlong(layer, shared, this->Near, executor);
  }

  /** Whether the cell at an index, or one beside it, is shared. */
  bool IsNearShared(std::size_t index) const { return this->Near[index + this->Padding] != 0; }

  bool IsNearShared(const CellRange& cells) const
  {
    const std::uint8_t* const near = this->Near.data() + this->Padding;
    return this->ForEachRow(cells, 0, [near](std::size_t first, std::size_t last) {
      return std::find(near + first, near + last, 1) != near + last;
    });
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

  /** Call body(first, one past last) for the cells of each row along x until it returns true, and return that. */
  template <class Body>
  bool ForEachRow(const CellRange& cells, int level, Body&& body) const
  {
    const std::array<int, 3> bits = this->BitsOf(level);
    for (std::size_t z = static_cast<std::size_t>(cells.First[2]); z <= static_cast<std::size_t>(cells.Last[2]); ++z)
    {
      for (std::size_t y = static_cast<std::size_t>(cells.First[1]); y <= static_cast<std::size_t>(cells.Last[1]); ++y)
      {
        const std::size_t row = (z << bits[1] | y) << bits[0];
        if (body(row + static_cast<std::size_t>(cells.First[0]), row + static_cast<std::size_t>(cells.Last[0]) + 1))
        {
          return true;
        }
      }
    }
    return false;
  }

  template <class Body>
  static void ForEachCell(std::size_t size, Executor& executor, Body&& body)
  {
    executor.For(static_cast<std::int64_t>(size), 1 << 17, [&](std::int64_t begin, std::int64_t end) {
      body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
    });
  }

  /** Give each cell's marks to the cells of the level below that lie in it, down to the finest level. */
  void HandDown(Executor& executor)
  {
    for (int level = static_cast<int>(this->Levels.size()) - 1; level > 0; --level)
    {
      const std::array<int, 3> coarse = this->BitsOf(level);
      const std::array<int, 3> fine = this->BitsOf(level - 1);
      const std::atomic<Word>* const from = this->Levels[static_cast<std::size_t>(level)].get();
      std::atomic<Word>* const to = this->Levels[static_cast<std::size_t>(level) - 1].get();
      ForEachCell(this->NumberOfCells(level - 1), executor, [=](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
        {
          const std::size_t x = i & ((std::size_t(1) << fine[0]) - 1);
          const std::size_t y = i >> fine[0] & ((std::size_t(1) << fine[1]) - 1);
          const std::size_t z = i >> (fine[0] + fine[1]);
          const std::size_t above = ((z / 2) << coarse[1] | y / 2) << coarse[0] | x / 2;
          Add(to[i], from[above].load(std::memory_order_relaxed));
        }
      });
    }
  }

  /**
   * Give each cell's value to those `stride` before and after it. What falls off a row's end arrives in the outer layer
   * of cells on the other side, where nobody asks.
   */
  template <class Value>
  void SpreadAlong(std::ptrdiff_t stride, const std::vector<Value>& from, std::vector<Value>& to, Executor& executor) const
  {
    ForEachCell(this->NumberOfCells(0), executor, [&](std::size_t begin, std::size_t end) {
      const Value* const in = from.data() + this->Padding;
      Value* const out = to.data() + this->Padding;
      for (std::ptrdiff_t i = static_cast<std::ptrdiff_t>(begin); i < static_cast<std::ptrdiff_t>(end); ++i)
      {
        out[i] = static_cast<Value>(in[i - stride] | in[i] | in[i + stride]);
      }
    });
  }

  std::array<int, 3> Bits;
  std::size_t Padding; ///< cells before the first and after the last, one layer along z
  std::vector<std::unique_ptr<std::atomic<Word>[]>> Levels; ///< [0] is the finest
  std::vector<std::uint8_t> Near;
};

} // namespace sb

#endif
