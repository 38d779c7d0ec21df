// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleCutting.h
 * @brief A triangle that has points on its edges, as triangles without.
 */
#ifndef sb_TriangleCutting_h
#define sb_TriangleCutting_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace sb
{

/**
 * Call add(corners) for two to four triangles: the longest of the cut edges is joined to the corner
 * across it, and then its point to those on the other edges. With points in the middle, and the
 * longest edge among those cut, angles stay above half of the smallest one however often it is done
 * (Rosenberg and Stenger 1975).
 * @param onEdges the point on the edge from each corner to the next one, -1 if there is none; at
 * least one must be there
 * @param lengths of the edges
 */
template <class Add>
void CutTriangle(const std::array<std::int32_t, 3>& corners,
  const std::array<std::int32_t, 3>& onEdges, const std::array<double, 3>& lengths, const Add& add)
{
  std::size_t first = 3;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (onEdges[k] >= 0 && (first == 3 || lengths[k] > lengths[first]))
    {
      first = k;
    }
  }
  using Corners = std::array<std::int32_t, 3>;
  const std::int32_t a = corners[first];
  const std::int32_t b = corners[(first + 1) % 3];
  const std::int32_t c = corners[(first + 2) % 3];
  const std::int32_t ab = onEdges[first];
  const std::int32_t bc = onEdges[(first + 1) % 3];
  const std::int32_t ca = onEdges[(first + 2) % 3];
  add(Corners{ a, ab, ca >= 0 ? ca : c });
  if (ca >= 0)
  {
    add(Corners{ ab, c, ca });
  }
  add(Corners{ ab, b, bc >= 0 ? bc : c });
  if (bc >= 0)
  {
    add(Corners{ ab, bc, c });
  }
}

} // namespace sb

#endif
