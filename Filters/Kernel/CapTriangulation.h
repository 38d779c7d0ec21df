// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CapTriangulation.h
 * @brief Triangles that fill the contours of one plane.
 *
 * The points are put into a constrained Delaunay triangulation in the order of a space-filling
 * curve, so that each is found in a few steps from the last; then the winding number of the
 * contours is known in each cell from that of its neighbour. A cell of winding number w becomes |w|
 * triangles, turned over where w is negative: so the filling has the contours as its boundary,
 * holes, islands and shells that overlap each other included. No point is added but where contours
 * cross.
 */
#ifndef sb_CapTriangulation_h
#define sb_CapTriangulation_h

#include "CapContours.h"
#include "ExactPoint.h"
#include "Predicates.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace sb
{

/** Segments between points of one plane. */
struct PlanarContours
{
  struct Edge
  {
    std::int32_t From; ///< index into Points
    std::int32_t To;
  };
  DominantNormal Normal; ///< of the plane
  std::vector<const ExactPoint*> Points; ///< no two equal; they have to stay
  std::vector<Edge> Edges; ///< no two between the same points; of no length zero
  std::vector<std::int32_t> Multiplicities; ///< how often each edge counts; by edge
};

struct Filling
{
  struct Triangle
  {
    std::array<std::int32_t, 3> Corners; ///< indices into Points, and then into Crossings
    std::int32_t Winding; ///< not 0; the corners are already turned over where it is negative
    std::int32_t Region; ///< triangles of one winding number that hang together are of one region
  };
  std::vector<Triangle> Triangles;
  std::vector<ExactPoint> Crossings; ///< new points where edges cross
  /** For each edge the points inside it, in order; empty if no edge has any. */
  std::vector<std::vector<std::int32_t>> PointsOnEdges;
  std::int32_t NumberOfRegions = 0;
  /** By region: how many other regions' outlines are around it, not counting holes; 0 is outermost,
   * 1 an island in a hole. */
  std::vector<std::int32_t> Depths;
};

/** What a winding number stands for. */
enum class FillRule : std::uint8_t
{
  Winding, ///< itself
  NonZero, ///< its sign
  EvenOdd ///< 1 where it is odd: the directions of the contours do not matter
};

/**
 * @param crossing gives the point in which two edges (by index) cross
 */
Filling FillContours(const PlanarContours& contours, FillRule rule,
  const std::function<ExactPoint(std::int32_t, std::int32_t)>& crossing);

} // namespace sb

#endif
