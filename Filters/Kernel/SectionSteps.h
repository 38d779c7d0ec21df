// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SectionSteps.h
 * @brief From close points of a plane curve on a cloud's surface to a polyline with as few points
 * as a bound on the chord error allows (Yang and Qian 2009, section 4.2.2).
 *
 * Steps are as long as the curvature (Eq. 8) allows. The chord error is then measured, not only
 * predicted: a step that keeps it not is shortened, and where neighbours are too far apart points
 * are put between them, moved onto the curve by Newton's method in the plane.
 */
#ifndef sb_SectionSteps_h
#define sb_SectionSteps_h

#include "MovingLeastSquares.h"

#include <vector>

namespace sb
{

class SectionSteps
{
public:
  /**
   * @param normal of the plane, a unit vector
   * @param chordError the bound, positive
   * @param spacing of the points that will be given, at most: how far one may be moved onto the
   * curve
   */
  SectionSteps(
    const MovingLeastSquares& surface, const Real3& normal, double chordError, double spacing)
    : Surface(surface)
    , Normal(normal)
    , Bound(Reserve * chordError)
    , Spacing(spacing)
  {
  }

  /**
   * Append the points after the first one to `curve`, in which that already is.
   * @param points of the curve and in the plane, at least two, no neighbours equal
   * @return the largest chord error measured
   */
  double Walk(const std::vector<Real3>& points, std::vector<Real3>& curve);

private:
  static constexpr double Reserve = 0.85; ///< of the bound, as errors are measured at some places

  std::size_t Step(const std::vector<Real3>& points, std::size_t at, std::vector<Real3>& curve);
  double ErrorOf(const std::vector<Real3>& points, std::size_t first, std::size_t last);
  void Subdivide(const Real3& a, const Real3& b, int depth, std::vector<Real3>& curve);
  void OntoCurve(Real3& x);

  const MovingLeastSquares& Surface;
  const Real3 Normal;
  const double Bound;
  const double Spacing;
  double LargestError = 0.0;
  MovingLeastSquares::Neighbourhood Near;
};

} // namespace sb

#endif
