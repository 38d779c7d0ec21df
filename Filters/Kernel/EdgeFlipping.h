// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeFlipping.h
 * @brief The diagonals of a piece of surface chosen anew, so that its triangles are as little
 * slender as its points allow (Lawson 1977).
 */
#ifndef sb_EdgeFlipping_h
#define sb_EdgeFlipping_h

#include "Real3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct FlippableTriangle
{
  std::array<std::int32_t, 3> Corners;
  std::array<bool, 3> IsFixed; ///< the edge from each corner to the next one has to stay
  bool IsFlipped = false; ///< set where the corners are others than before
};

/**
 * Flip edges that two of the triangles share and that are not fixed, where the angles opposite of
 * them sum to more than a half turn, until there is none.
 * @param triangles flat or nearly so, alike oriented
 * @param points x, y, z of all points
 */
void FlipToDelaunay(std::vector<FlippableTriangle>& triangles, const std::vector<double>& points);

} // namespace sb

#endif
