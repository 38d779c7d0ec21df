// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Arrangement.h
 * @brief The faces that touch others, cut along their contacts.
 *
 * Every face finds all points and lines of the arrangement that lie on it by itself, from its own
 * contacts; neighbours agree because every construction is exact. So faces are cut independently
 * and in parallel. A *region* is a part of a face that no contact divides: a set of its pieces,
 * connected across edges that are free.
 */
#ifndef sb_Arrangement_h
#define sb_Arrangement_h

#include "Contacts.h"
#include "PointTable.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** A corner of a piece: the node there, or ~vertex for an input vertex that nothing touches. */
using CornerRef = std::int32_t;
constexpr bool IsNode(CornerRef corner) { return corner >= 0; }

struct Piece
{
  std::array<CornerRef, 3> Corners; ///< in the orientation of its face
  std::array<Location, 3> Where; ///< the corners' places on the face
  std::int32_t Region;
};

struct Region
{
  std::int32_t Face;
  std::int32_t FirstPiece; ///< its pieces are consecutive
  std::int32_t Stack; ///< regions of other faces that cover exactly the same points share this
                      ///< number; -1: none do
};

/** A region's use of an edge of the arrangement. */
struct EdgeUse
{
  NodeId Low;
  NodeId High;
  std::int32_t Region;
  bool RunsUp; ///< the piece runs from Low to High
  bool IsContact; ///< the edge lies on a contact, as seen from this face

  friend bool operator<(const EdgeUse& l, const EdgeUse& r)
  {
    return l.Low != r.Low    ? l.Low < r.Low
      : l.High != r.High     ? l.High < r.High
      : l.Region != r.Region ? l.Region < r.Region
                             : l.RunsUp < r.RunsUp;
  }
};

/** A face that was cut, or at least touched. */
struct CutFace
{
  std::int32_t Face;
  std::int32_t FirstPiece; ///< up to the next face's first one
};

struct Arrangement
{
  PointTable Nodes;
  std::vector<CutFace> Faces; ///< ascending
  std::vector<Region> Regions; ///< by face
  std::vector<Piece> Pieces; ///< by face, then region
  std::vector<EdgeUse> EdgeUses; ///< sorted
  std::int32_t NumberOfStacks = 0;
  /** Operands whose own triangles were seen to cross or overlap each other without having been cut
   * against each other. */
  std::vector<std::uint8_t> SelfIntersecting;

  std::int32_t EndOfPieces(std::size_t face) const
  {
    return face + 1 < this->Faces.size() ? this->Faces[face + 1].FirstPiece
                                         : static_cast<std::int32_t>(this->Pieces.size());
  }
  std::int32_t EndOfPiecesOfRegion(std::int32_t region) const
  {
    return region + 1 < static_cast<std::int32_t>(this->Regions.size())
      ? this->Regions[std::size_t(region) + 1].FirstPiece
      : static_cast<std::int32_t>(this->Pieces.size());
  }
};

/**
 * Cut all faces that have contacts, and take in all faces of operands marked in `self` (whose
 * contacts have to include those among their own faces); not those marked in `collapsed`.
 */
Arrangement MakeArrangement(const Scene& scene, const ContactSet& contacts,
  const std::vector<std::uint8_t>& self, const std::vector<std::uint8_t>& collapsed,
  Executor& executor, Monitor& monitor);

} // namespace sb

#endif
