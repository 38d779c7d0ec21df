// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Classification.h
 * @brief Which faces and regions bound the result, by winding numbers.
 *
 * A *patch* is a maximal part of one operand that no contact divides. All of it has the same
 * winding numbers of all operands in front of it, and the same behind it; between front and behind,
 * only that of its own operand differs, by one.
 * - Untouched faces join the patches of their corners (union-find over vertices: no half-edges are
 * built), regions of cut faces join across free edges.
 * - Around every contact edge the pieces are put in radial order; the sides that face each other
 * across a wedge see the same winding numbers. A spanning forest of these relations gives all
 * winding numbers relative to one patch a tree.
 * - What is left is one number for each tree and operand. Where the tree has patches of that
 * operand it is known: a clean operand has winding number 0 in front of itself. Else it is 0
 * outside of the operand's box, or found by an exact query.
 *
 * A patch is in the result if the operation's value differs between its sides. Regions that cover
 * the same points form a stack; of these at most one is in the result, if the value differs between
 * the outer sides of the stack.
 *
 * The assumption that an operand is clean is checked for all that matters: each patch that meets
 * it asks for its winding number there. If that is not the assumed one, or neither 0 nor 1, or one
 * operand's numbers contradict each other, that operand overlaps itself there and is reported, to
 * be cut against itself. Where no such patch exists, self-overlaps of one operand lie away from all
 * other surfaces and are passed on as they are, which leaves the set of inner points right.
 *
 * Open operands (sheets) have no winding number. Their front is outside and their back is inside,
 * where they meet another surface; elsewhere the sign of the distance to them decides (Quammen,
 * Weigle and Taylor 2011, section 4). A sheet whose rim runs inside a closed operand of the other
 * group does not divide it: such a sheet has no inside.
 */
#ifndef sb_Classification_h
#define sb_Classification_h

#include "Arrangement.h"
#include "Boolean.h"
#include "DisjointSets.h"
#include "Ingest.h"
#include "Scene.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct ClassificationInput
{
  const Scene& World;
  const Arrangement& Cuts;
  Operation Op;
  const std::vector<std::uint8_t>& Self; ///< operands that were cut against themselves
  const std::vector<std::uint8_t>& Open; ///< operands that are sheets
  const std::vector<std::vector<RimEdge>>& Rims; ///< [operand] of the sheets
  const std::vector<std::uint8_t>&
    Collapsed; ///< faces without area that take no part; empty if there are none
};

struct Classification
{
  std::vector<std::vector<Fate>>
    Fates; ///< [operand][face], as read by the scene; Fate::Split where regions decide
  std::vector<Fate> RegionFates; ///< Dropped, Kept or KeptReversed
  /** Operands found to overlap themselves: the classification is void, cut them against themselves
   * and try again. */
  std::vector<std::uint8_t> SelfIntersecting;
  /** Open operands whose front and back are connected. */
  std::vector<std::uint8_t> NonSeparating;
};

Classification Classify(const ClassificationInput& input, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
