// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridBlocks.h
 * @brief Sets of nodes, cells and edges of a grid without bounds, in blocks of 4 x 4 x 4: such a
 * set is a word of 64 bits a block, and what lies beside, above or around it a few shifts.
 *
 * Node and cell x, y, z of a block have bit x + 4 y + 16 z. Cell and edges lie above the node of
 * their bit, so that some of their corners are nodes of the blocks above.
 */
#ifndef sb_GridBlocks_h
#define sb_GridBlocks_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

using BlockBits = std::uint64_t;

/** Of a block and of those above it: bit a of the index is set for those above on axis a. */
using BitsAbove = std::array<BlockBits, 8>;

constexpr int BlockSide = 4;

/** The bits at coordinate 0, and what a step on the axis adds to a bit's number. */
constexpr std::array<BlockBits, 3> LowestOfBlock{ 0x1111111111111111u, 0x000F000F000F000Fu,
  0x000000000000FFFFu };
constexpr std::array<int, 3> BlockStride{ 1, 4, 16 };

/** Sets moved by one step: what stays in the block, and what comes to the next one. */
inline BlockBits StepUp(BlockBits bits, std::size_t axis)
{
  const int stride = BlockStride[axis];
  return (bits & ~(LowestOfBlock[axis] << 3 * stride)) << stride;
}
inline BlockBits StepOutUp(BlockBits bits, std::size_t axis)
{
  const int stride = BlockStride[axis];
  return bits >> 3 * stride & LowestOfBlock[axis];
}
inline BlockBits StepDown(BlockBits bits, std::size_t axis)
{
  return (bits & ~LowestOfBlock[axis]) >> BlockStride[axis];
}
inline BlockBits StepOutDown(BlockBits bits, std::size_t axis)
{
  return (bits & LowestOfBlock[axis]) << 3 * BlockStride[axis];
}

/** The corners of cells: in the block and in those above it. */
inline BitsAbove CornersOfCells(BlockBits cells)
{
  BitsAbove nodes{ cells };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t block = 0; block < std::size_t(1) << axis; ++block)
    {
      nodes[block | std::size_t(1) << axis] = StepOutUp(nodes[block], axis);
      nodes[block] |= StepUp(nodes[block], axis);
    }
  }
  return nodes;
}

/** The edges of cells along one axis, by their lower nodes. */
inline BitsAbove EdgesOfCells(BlockBits cells, std::size_t along)
{
  BitsAbove nodes{ cells };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t block = 0; block < std::size_t(1) << axis && axis != along; ++block)
    {
      nodes[block | std::size_t(1) << axis] = StepOutUp(nodes[block], axis);
      nodes[block] |= StepUp(nodes[block], axis);
    }
  }
  return nodes;
}

/** From a set of nodes, the sets of cells whose corner c, c from 0 to 7, is in it. */
inline BitsAbove CellsByCorner(BitsAbove nodes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t upper = std::size_t(1) << axis;
    for (std::size_t i = 0; i < 8; ++i)
    {
      if (!(i & upper))
      {
        nodes[i | upper] = StepDown(nodes[i], axis) | StepOutDown(nodes[i | upper], axis);
      }
    }
  }
  return nodes;
}

inline int NumberOfBits(BlockBits bits)
{
  bits -= bits >> 1 & 0x5555555555555555u;
  bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
  return static_cast<int>(bits * 0x0101010101010101u >> 56);
}

/** Call body(bit) for each bit that is set, from the lowest on. */
template <class Body>
inline void ForBits(BlockBits bits, const Body& body)
{
  for (; bits != 0; bits &= bits - 1)
  {
    body(NumberOfBits((bits & (~bits + 1)) - 1));
  }
}

/** Where a block is, in blocks, or a node or cell, in cells. */
struct GridPlace
{
  std::int32_t X, Y, Z;

  bool operator==(const GridPlace& other) const
  {
    return this->X == other.X && this->Y == other.Y && this->Z == other.Z;
  }
  /** The place `steps` away on an axis. */
  GridPlace Moved(std::size_t axis, std::int32_t steps) const
  {
    return { this->X + (axis == 0 ? steps : 0), this->Y + (axis == 1 ? steps : 0),
      this->Z + (axis == 2 ? steps : 0) };
  }
};

/** From the places of blocks to their numbers, by open addressing. Numbers are given in the order
 * in which places are asked for. */
class BlockNumbers
{
public:
  /** The number of a block, which it is given now if it had none. */
  std::int32_t Of(const GridPlace& place);

  std::int32_t Size() const { return static_cast<std::int32_t>(this->Places.size()); }
  const GridPlace& Place(std::int32_t block) const
  {
    return this->Places[static_cast<std::size_t>(block)];
  }

private:
  std::size_t SlotOf(const GridPlace& place) const;

  std::vector<GridPlace> Places;
  std::vector<std::int32_t> Slots; ///< numbers, or -1
};

} // namespace sb

#endif
