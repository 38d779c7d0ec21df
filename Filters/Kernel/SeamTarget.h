// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SeamTarget.h
 * @brief Where a seam vertex should be: the nearest place on the tool, of those it may move to, at
 * which the cloud's function is zero.
 */
#ifndef sb_SeamTarget_h
#define sb_SeamTarget_h

#include "MovingLeastSquares.h"
#include "ToolSurface.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** What of the tool a seam vertex lies on, and so where it may move. */
struct SeamFreedom
{
  enum class Kind : std::uint8_t
  {
    Plane, ///< of a triangle, or of several in one plane
    Patch, ///< the exact patch behind its triangles
    Border, ///< where the patch meets itself, such as the seam line of a cylinder
    Crease, ///< the edge in which two exact patches meet
    Line, ///< an edge between two triangles that are not in one plane
    Fixed ///< a corner of the tool
  } What = Kind::Fixed;
  Real3 Direction{}; ///< the plane's normal, or along the line
  std::int32_t Triangle = -1; ///< one of those it lies on
  std::int32_t OnOtherPatch = -1; ///< of a crease: one that is on the other patch
  bool KeepsU = false; ///< of a border: it is a line of constant u, not v
};

/**
 * @param triangles of the tool that the vertex is a corner of pieces of
 * @param place of the vertex
 */
SeamFreedom FreedomOn(
  const ToolSurface& tool, const std::vector<std::int32_t>& triangles, const Real3& place);

struct SeamTarget
{
  Real3 Place{};
  double Residual = 0.0; ///< |f| / |grad f| where the search ended
  double Tangency = 0.0; ///< the cosine between the surfaces' normals there, 0 or more
  bool Reached = false; ///< it is on both, and nearer than the limit
};

/** @param limit of the way from `start` */
SeamTarget FindSeamTarget(const MovingLeastSquares& cloud, const ToolSurface& tool,
  const SeamFreedom& freedom, const Real3& start, double limit,
  MovingLeastSquares::Neighbourhood& near);

/**
 * The same for a vertex that may go over to other triangles of the tool, as where these are smaller
 * than the way.
 */
SeamTarget FindSeamTargetAcross(const MovingLeastSquares& cloud, const ToolSurface& tool,
  const Real3& start, double limit, MovingLeastSquares::Neighbourhood& near);

/** Whether a place is nearer than `limit` to the planes of all these triangles of the tool. */
bool IsNearPlanes(const ToolSurface& tool, const std::vector<std::int32_t>& triangles,
  const Real3& place, double limit);

} // namespace sb

#endif
