// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BroadPhase.h
 * @brief Which triangles may meet: all pairs of triangles whose closed axis-aligned boxes share a
 * point.
 *
 * No tree over a whole mesh is ever built. Blocks of triangles that meet no other surface's block
 * are dropped first (TriangleBlocks.h). Two streaming passes over an occupancy grid then drop every
 * triangle that has no other surface near it. So the cost is a few nanoseconds at most for each
 * input triangle, plus what the triangles near the intersection need.
 */
#ifndef sb_BroadPhase_h
#define sb_BroadPhase_h

#include "Executor.h"
#include "TriangleBlocks.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** A triangle surface as the broad phase sees it; the arrays are the caller's. */
struct BroadPhaseSurface
{
  const double* Points; ///< x0 y0 z0 x1 y1 z1 ...
  const std::int32_t* Triangles; ///< point ids, three a triangle
  std::int64_t NumberOfTriangles;
  std::array<double, 6>
    Bounds; ///< xmin xmax ymin ymax zmin zmax of all triangles; larger is allowed
  bool Self; ///< also pair the triangles of this surface with one another
  const std::vector<TriangleBlock>* Blocks = nullptr; ///< of all triangles; made if null
};

/** SurfaceA < SurfaceB, or SurfaceA == SurfaceB and TriangleA < TriangleB where that surface's Self
 * is set. */
struct TrianglePair
{
  std::int32_t SurfaceA;
  std::int32_t TriangleA;
  std::int32_t SurfaceB;
  std::int32_t TriangleB;
};

/**
 * All pairs of triangles of different surfaces, and of the same surface where Self is set, whose
 * closed boxes meet. The doubles themselves are compared, so no pair is missed and none is
 * invented. Each pair comes once; the pairs are sorted lexicographically and do not depend on the
 * executor's number of threads. Empty if the monitor says Aborted.
 */
std::vector<TrianglePair> FindOverlappingPairs(
  const std::vector<BroadPhaseSurface>& surfaces, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
