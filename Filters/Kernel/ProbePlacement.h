// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProbePlacement.h
 * @brief Where to put the vertical line of a winding query so that it goes through the inside of a
 * face or region.
 */
#ifndef sb_ProbePlacement_h
#define sb_ProbePlacement_h

#include "Arrangement.h"
#include "WindingQuery.h"

#include <cstdint>
#include <optional>

namespace sb
{

class ProbePlacement
{
public:
  ProbePlacement(const Scene& scene, const Arrangement& cuts)
    : World(scene)
    , Cuts(cuts)
  {
  }

  /** A line through an uncut face with area (region -1), or through a region of a cut one; another
   * one for each attempt. None through a region that is narrower than the grid of places. */
  std::optional<Probe> Place(std::int32_t face, std::int32_t region, int attempt) const;

  /** The sign of the face's normal along its dominant axis. */
  int NormalSign(std::int32_t face) const;

private:
  DominantNormal NormalOf(std::int32_t face) const;
  bool PlaceInPiece(const Piece& piece, int sign, int attempt, Probe& probe) const;

  const Scene& World;
  const Arrangement& Cuts;
};

} // namespace sb

#endif
