// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SectionSteps.h
 * @brief From close points of a plane curve on a cloud's surface to a polyline with as few points
 * as a bound on the chord error allows (Yang and Qian 2009, section 4.2.2).
 *
 * The curvature is that of Eq. 8, and points between others are moved onto the curve by Newton's
 * method in the plane; the rest is the same for all curves (ChordSteps.h).
 */
#ifndef sb_SectionSteps_h
#define sb_SectionSteps_h

#include "ChordSteps.h"
#include "MovingLeastSquares.h"

#include <vector>

namespace sb
{

class SectionSteps : private SteppedCurve
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
    , ChordError(chordError)
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
  double CurvatureAt(const CurveNode& node) override;
  CurveNode Between(const CurveNode& a, const CurveNode& b, double t) override;
  void OntoCurve(Real3& x);

  const MovingLeastSquares& Surface;
  const Real3 Normal;
  const double ChordError;
  const double Spacing;
  MovingLeastSquares::Neighbourhood Near;
};

} // namespace sb

#endif
