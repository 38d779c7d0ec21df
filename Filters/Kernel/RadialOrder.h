// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RadialOrder.h
 * @brief The order of pieces around an edge that they share.
 *
 * Each piece is a half-plane that ends at the edge, and stands in for its whole face there: which
 * of two comes first is on which side of one face's plane a corner of the other face lies, an
 * orientation of four input vertices.
 *
 * Half-planes that coincide are put in layers, by face id along the positive direction of their
 * plane's dominant axis. The choice is arbitrary, but the same at every edge of that plane, as if
 * every face had been moved by an infinitesimal amount; so winding numbers between the layers are
 * consistent.
 */
#ifndef sb_RadialOrder_h
#define sb_RadialOrder_h

#include "Arrangement.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** A piece at an edge. */
struct HalfPlane
{
  std::int32_t Region;
  std::int32_t Face;
  /** The piece runs from the edge's low end to its high end; its front then faces the direction of
   * turning. */
  bool RunsUp;
};

class RadialOrder
{
public:
  RadialOrder(const Scene& scene, const PointTable& nodes)
    : World(scene)
    , Nodes(nodes)
  {
  }

  /** Sort counter-clockwise as seen from the high end looking down to the low end, starting
   * anywhere. */
  void Sort(NodeId low, NodeId high, std::vector<HalfPlane>& pieces);

  /** Of the pieces last sorted: +1 if number b follows number a within half a turn, -1 if it
   * precedes it, 0 if both lie in one plane. */
  int Turn(std::size_t a, std::size_t b) const { return Turn(this->Entries[a], this->Entries[b]); }

  /** Whether pieces number a and b of those last sorted lie on top of each other. */
  bool Coincide(std::size_t a, std::size_t b) const
  {
    return this->Entries[a].Sector == this->Entries[b].Sector && this->Turn(a, b) == 0;
  }

private:
  struct Entry
  {
    HalfPlane Piece;
    std::array<const double*, 3> Corners;
    DominantNormal Normal;
    const double* Witness; ///< a corner of the face strictly on the piece's side of the edge's line
    int Sector; ///< 0 with the first piece, 1 up to half a turn, 2 opposite, 3 beyond
  };

  Entry MakeEntry(NodeId low, NodeId high, const HalfPlane& piece) const;
  /** +1 if b follows a within half a turn, -1 if it precedes it, 0 if both lie in one plane. */
  static int Turn(const Entry& a, const Entry& b);
  bool IsOnSameSide(NodeId low, NodeId high, const Entry& a, const Entry& b) const;

  const Scene& World;
  const PointTable& Nodes;
  std::vector<Entry> Entries;
};

} // namespace sb

#endif
