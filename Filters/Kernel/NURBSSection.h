// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NURBSSection.h
 * @brief The curves in which the surface of a cloud meets the exact patches of a designed surface
 * (Yang and Qian 2009, section 6), with a bound on the chord error.
 *
 * Each point is found by Newton's method for f(S(u, v)) = 0 and so lies on both; its u and v come
 * with it. Loops wider than two spacings are all found. Curves go on over seams of patches and from
 * face to face. Where both surfaces lie in each other there is no curve, but an area.
 */
#ifndef sb_NURBSSection_h
#define sb_NURBSSection_h

#include "FaceSection.h"
#include "SectionRequest.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct NURBSCurve
{
  std::vector<Real3> Points; ///< the first again at the end if Closed
  std::vector<Parameters> UV; ///< of each point, in the patch of its face
  std::vector<std::int32_t> FaceId; ///< of each point
  bool Closed = false;
  std::array<CurveEnd, 2> Ends{ CurveEnd::None, CurveEnd::None };
  bool IsTangential = false; ///< somewhere the surfaces meet at an angle below 0.1
  double LargestChordError = 0.0; ///< as measured
  double LargestResidual = 0.0; ///< distance of a point from either surface, as measured
};

struct NURBSSection
{
  std::vector<NURBSCurve> Curves; ///< the cloud's inside is on the left, seen from outside
  /** Where a face comes nearer to the surface than the chord error, or a tenth of a spacing,
   * without crossing it. */
  std::vector<SurfaceTouch> Touches;
  double CoincidentArea = 0.0; ///< of the designed surface, where the cloud lies in it
  bool Aborted = false;
};

/** @param designed with patches without a fault; triangles without a patch (-1) are left out */
NURBSSection IntersectPatches(const MovingLeastSquares& surface, const DesignedSurface& designed,
  const SectionRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
