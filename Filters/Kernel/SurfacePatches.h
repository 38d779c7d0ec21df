// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfacePatches.h
 * @brief One operand cut along the curves: its pieces, and the patches into which the curves divide
 * it.
 *
 * Untouched faces join the patches of their corners, regions of cut faces join across edges that
 * are not on a curve (union-find, as in Classification.h). But here points that coincide are one,
 * so that creases and triangles that share no points hang together. An edge of another operand that
 * lies in a coplanar face divides regions and no patches, unless it is on the outline of what the
 * two have in common.
 */
#ifndef sb_SurfacePatches_h
#define sb_SurfacePatches_h

#include "CurveJoining.h"
#include "Intersection.h"

namespace sb
{

SplitSurface SplitAlongCurves(const Scene& scene, const Arrangement& cuts,
  const std::vector<CurveSegment>& curves, const std::vector<std::uint8_t>& collapsed,
  std::int32_t operand, Executor& executor);

} // namespace sb

#endif
