// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceRefinement.h
 * @brief A designed surface with triangles as small as a cloud's spacing where the cloud is near,
 * and as they were elsewhere.
 *
 * Edges that are too long are halved, all at once, round after round. A triangle is cut from the
 * middle of its longest edge first (Rivara 1984), so
 * its angles do not get worse the finer it is. What decides is the edge and the triangles beside
 * it, found by coordinates: both sides of an edge get the same points, and a surface that is closed
 * by coordinates stays so. Triangles that are not near take up the points on their edges and are
 * not cut again.
 *
 * Where patches are known, new points lie on them: on that of the face, or, at an edge of two
 * faces, on both of them, once with the u and v of each.
 */
#ifndef sb_SurfaceRefinement_h
#define sb_SurfaceRefinement_h

#include "DesignedSurface.h"
#include "PointTree.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct RefinementRequest
{
  double Near = 0.0; ///< triangles closer to a sample than this are refined
  double LongestEdge = 0.0; ///< of a refined triangle, positive
  /** How far the middles of edges and triangles may be from their patch, positive; without patches
   * it is not looked at. */
  double ChordError = 0.0;
};

enum class RefinementStatus
{
  Ok,
  TooLarge, ///< more points or triangles than 32-bit numbers can name
  Aborted
};

struct RefinedSurface
{
  RefinementStatus Status = RefinementStatus::Ok;
  /** The points of the input and then the new ones; triangles in the order of those that they are
   * part of. */
  DesignedSurface Surface;
  std::vector<std::int32_t> Original; ///< of each triangle, the one of the input it is part of
  std::vector<std::uint8_t> IsNear; ///< 1 for each triangle closer than Near to a sample
};

RefinedSurface RefineNearCloud(const DesignedSurface& surface, const PointTree& samples,
  const RefinementRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
