// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Contour.h
 * @brief Oriented segments in a clipping plane, each with the line that it lies on.
 *
 * A segment keeps its line, not only its ends, so that cutting it by the next plane gives a point
 * that is made of inputs alone, however many planes came before.
 */
#ifndef sb_Contour_h
#define sb_Contour_h

#include <cstdint>
#include <vector>

namespace sb
{

/** What meets the clipping plane in the line of a segment. */
struct Carrier
{
  enum class Kind : std::uint8_t
  {
    Face, ///< A: an input triangle
    Edge, ///< A, B: the vertices of an input edge that lies in the plane
    Plane, ///< A: another clipping plane
    Join ///< a segment that closes an open contour; nothing of the input carries it
  };
  Kind Of = Kind::Join;
  std::int32_t A = -1;
  std::int32_t B = -1;
};

struct Segment
{
  std::int32_t From; ///< instance (ClipPoints.h)
  std::int32_t To;
  Carrier Line;
};

using Contour = std::vector<Segment>;

} // namespace sb

#endif
