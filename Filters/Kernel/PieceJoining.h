// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceJoining.h
 * @brief Which pieces of curves on neighbouring faces continue each other.
 *
 * Facets of both faces have the same edges in space, but the borders that they give the two patches
 * are chords of the true common edge, and so the pieces end a little apart. Where the patches cross
 * at an angle, Newton's method finds the point on both and on the cloud's surface, and both pieces
 * end in it.
 */
#ifndef sb_PieceJoining_h
#define sb_PieceJoining_h

#include "FaceSection.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** Number of an end: twice that of the piece, and 1 more for its last node. */
using PieceEnd = std::int32_t;

/** Move ends that belong together to one point where they have one.
 * @return of each end, the one that continues it; -1 if none does. */
std::vector<PieceEnd> JoinPieces(const MovingLeastSquares& surface, const DesignedSurface& designed,
  std::vector<SectionPiece>& pieces);

} // namespace sb

#endif
