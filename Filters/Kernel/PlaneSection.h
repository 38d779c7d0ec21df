// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneSection.h
 * @brief The curves in which a plane meets the surface of a cloud, with a bound on the chord error
 * (Yang and Qian 2009, section 4.2).
 *
 * The paper marches from starting points, and has to find one for each loop. Here squares of a
 * third of the width are laid over the plane where samples are near, and the signs at their corners
 * give all branches at once (Lorensen and Cline 1987, in two dimensions): a loop that is wider than
 * such a square's diagonal contains a corner and cannot be missed, and closed and open branches
 * come out as such. Where branches are closer to each other than that, smaller squares tell which
 * ends belong together. Along each of them steps are as long as the curvature (Eq. 8) allows for
 * the bound; the chord error is then measured, not only predicted, and a step that keeps it not is
 * shortened.
 */
#ifndef sb_PlaneSection_h
#define sb_PlaneSection_h

#include "MovingLeastSquares.h"
#include "TouchSearch.h"

#include <vector>

namespace sb
{

struct SectionCurve
{
  std::vector<Real3>
    Points; ///< on the surface and in the plane; the first again at the end if Closed
  bool Closed = false;
  double LargestChordError = 0.0; ///< as measured
};

struct PlaneSection
{
  std::vector<SectionCurve> Curves;
  /** Where the plane comes nearer to the surface than the chord error, or a thirtieth of the width,
   * without crossing it. */
  std::vector<SurfaceTouch> Touches;
  bool Aborted = false;
};

/**
 * @param normal a unit vector. The inside of the surface lies on the left of the curves, seen from
 * where it points.
 * @param chordError how far the curve may be from a segment, positive
 */
PlaneSection IntersectPlane(const MovingLeastSquares& surface, const Real3& origin,
  const Real3& normal, double chordError, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
