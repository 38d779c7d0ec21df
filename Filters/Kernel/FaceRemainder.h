// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceRemainder.h
 * @brief What is left of a triangle when a convex part is taken out of it.
 *
 * For the rest of a solid that is cut by several planes at once, which is not convex. The outline
 * of the part, and the points that neighbours put on the triangle's edges, become edges and points
 * of a constrained triangulation; the cells outside of the part are the remainder.
 */
#ifndef sb_FaceRemainder_h
#define sb_FaceRemainder_h

#include "ExactPoint.h"
#include "FaceTriangulation.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

class FaceRemainder : private ConstraintSource
{
public:
  struct Point
  {
    const ExactPoint* Place; ///< has to stay until Cut is done
    std::int32_t Id;
  };

  /**
   * Cut the remainder into triangles.
   * @param corners of the triangle
   * @param onEdges points on its edges, in any order, more than once if need be
   * @param part the outline of what is taken out, in the triangle's orientation; empty for nothing
   * @param triangles get the remainder's, by the points' ids
   */
  void Cut(const std::array<Point, 3>& corners, const std::vector<Point>& onEdges,
    const std::vector<Point>& part, std::vector<std::array<std::int32_t, 3>>& triangles);

private:
  ExactPoint Crossing(int, int) override { return ExactPoint(); }
  void PassesThrough(int, int) override {}
  void Insert(const std::vector<Point>& points, std::vector<int>& vertices);
  std::vector<std::uint8_t> FindPart(const std::vector<int>& outline) const;

  FaceTriangulation Mesh;
  std::vector<std::int32_t> Ids; ///< by vertex
};

} // namespace sb

#endif
