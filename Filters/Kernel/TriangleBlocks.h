// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleBlocks.h
 * @brief The boxes of runs of a surface's triangles, in the order in which the surface lists them.
 *
 * Meshes mostly list neighbours one after the other, so the box of a run is small, and comparing a
 * few thousand boxes finds which parts of two surfaces may meet. The boxes depend on one surface
 * alone and are kept with it. Where neighbours are not listed together the boxes are large and
 * nothing is ruled out; nothing is lost either.
 */
#ifndef sb_TriangleBlocks_h
#define sb_TriangleBlocks_h

#include "BVH.h"
#include "Executor.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace sb
{

/** Triangles Size * i up to Size * (i + 1) of a surface, fewer in its last block. */
struct TriangleBlock
{
  static constexpr std::int64_t Size = 256;

  Box Bounds;
  std::int32_t LowestPoint; ///< of the points that the triangles refer to
  std::int32_t HighestPoint;
};

/** The block of the triangles begin..end-1; there has to be one. Coordinates that are not numbers
 * are passed over. */
TriangleBlock BlockOf(
  const double* points, const std::int32_t* triangles, std::int64_t begin, std::int64_t end);

/** All blocks of a surface with `count` triangles. */
std::vector<TriangleBlock> BlocksOf(
  const double* points, const std::int32_t* triangles, std::int64_t count, Executor& executor);

/** Finds the blocks of several surfaces that meet another surface's. */
class NearBlocks
{
public:
  /** `blocks` [surface] has to outlive this. */
  NearBlocks(const std::vector<const std::vector<TriangleBlock>*>& blocks, Executor& executor);

  /** Mark all blocks of one surface. */
  void MarkAll(std::size_t surface);

  /** Mark the blocks of two surfaces that meet a block of the other. `common` encloses what the
   * surfaces' boxes have in common. */
  void MarkMeeting(std::size_t a, std::size_t b, const Box& common);

  /** Runs [begin, end) of marked blocks of a surface, ascending. */
  std::vector<std::pair<std::int64_t, std::int64_t>> Runs(std::size_t surface) const;

private:
  void MarkThoseThatMeet(std::size_t surface, std::size_t other, const Box& common);
  const BVH& HierarchyOf(std::size_t surface);

  const std::vector<const std::vector<TriangleBlock>*>& Blocks;
  Executor& Host;
  std::vector<std::vector<std::uint8_t>> Marks; ///< [surface][block]
  std::vector<BVH> Hierarchies; ///< [surface], built when first asked
};

} // namespace sb

#endif
