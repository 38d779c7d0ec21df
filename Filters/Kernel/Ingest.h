// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ingest.h
 * @brief One pass over each operand that checks it and measures it.
 *
 * Whether a surface is closed is found without building its topology: a closed surface uses every
 * directed edge as often as its opposite. Let each point have a random place in a plane (its two
 * coordinates are hashes of its position, so points that coincide count as one). The area that the
 * triangles have there, counted with their orientation, depends on the edges without an opposite
 * alone; it is computed modulo 2^64, and zero if there are none. Only where it is not zero are the
 * edges sorted, to say what is wrong and where.
 */
#ifndef sb_Ingest_h
#define sb_Ingest_h

#include "Boolean.h"
#include "TriangleBlocks.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** An edge that only one triangle, or an odd number of them, has: a piece of a sheet's rim. */
struct RimEdge
{
  std::int32_t Triangle;
  std::int32_t Edge; ///< from that corner to the next
};

struct Examination
{
  OperandReport Report;
  std::vector<Remark> Remarks; ///< Operand is not set
  bool IsOpen = false;
  bool IsInsideOut = false;
  std::vector<RimEdge> Rim;
  std::vector<TriangleBlock> Blocks; ///< in the caller's coordinates
};

struct Ingested
{
  std::vector<OperandReport> Reports;
  std::vector<Remark> Remarks;
  std::vector<std::uint8_t> Open; ///< operands to be treated as sheets
  std::vector<std::uint8_t> Swapped; ///< closed operands that are inside out
  std::vector<std::vector<RimEdge>> Rims; ///< [operand]
  std::vector<std::shared_ptr<const Examination>> Examinations; ///< [operand]
};

/** Whether 32-bit ids cannot count the points and triangles, and what is made of them. */
bool IsTooLarge(const Surface& surface);

Ingested Ingest(const BooleanRequest& request, Executor& executor);

} // namespace sb

#endif
