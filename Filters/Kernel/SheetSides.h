// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SheetSides.h
 * @brief On which side of an open operand (a sheet) the patches of the others lie.
 *
 * Where a patch meets the sheet, the radial order at their common edges says it exactly, and every
 * such edge gives a vote. Patches that do not meet it take the sign of the distance to the nearest
 * point of the sheet, as the source document has it (Quammen, Weigle and Taylor 2011, sections 3
 * and 4).
 */
#ifndef sb_SheetSides_h
#define sb_SheetSides_h

#include "RadialOrder.h"
#include "Scene.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** One edge's word on a patch and a sheet. */
struct SheetVote
{
  std::int32_t Patch;
  std::int32_t Sheet;
  bool Behind;
};

/** A piece in the radial order around an edge. */
struct PieceAtEdge
{
  std::int32_t Patch;
  std::int32_t Operand;
  bool RunsUp;
};

/** Add the votes of one edge, whose pieces have just been sorted by `order`. */
void Vote(const std::vector<std::int32_t>& sheets, const std::vector<PieceAtEdge>& pieces,
  const RadialOrder& order, std::vector<SheetVote>& votes);

/** The votes, counted. */
class SheetSides
{
public:
  /** 1 if the patch lies behind the sheet, 0 if in front of it, -1 if they do not meet. */
  int Find(std::int32_t patch, std::int32_t sheet) const;

  /** Sorted by patch, then sheet; one each. */
  std::vector<SheetVote> Votes;
};

/** Sheets whose votes on one patch differ do not separate front from back; they are marked. */
SheetSides CountVotes(std::vector<SheetVote> votes, std::vector<std::uint8_t>& nonSeparating);

/** The sign of the distance to a sheet. */
class DistanceSign
{
public:
  explicit DistanceSign(const Scene& scene)
    : World(scene)
  {
  }

  /** Whether the middle of a face lies behind the nearest point of the sheet. Linear in the sheet's
   * faces. */
  bool IsBehind(std::int32_t face, std::int32_t sheet) const;

private:
  const Scene& World;
};

} // namespace sb

#endif
