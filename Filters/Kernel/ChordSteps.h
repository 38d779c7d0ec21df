// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChordSteps.h
 * @brief Few points of a curve that is known by many, with a bound on the distance of the curve to
 * its chords: steps are as long as the curvature allows (Yang and Qian 2009, section 4.2.2), and
 * shortened where the measured distance is above the bound.
 */
#ifndef sb_ChordSteps_h
#define sb_ChordSteps_h

#include "Real3.h"

#include <cstddef>
#include <vector>

namespace sb
{

/** A point of a curve, with u and v if it is on a patch. */
struct CurveNode
{
  Real3 Point{};
  double U = 0.0;
  double V = 0.0;
};

/** A curve that can be asked for more than its points. */
class SteppedCurve
{
public:
  virtual ~SteppedCurve() = default;
  virtual double CurvatureAt(const CurveNode& node) = 0;
  /** The point of the curve opposite of a place on the chord from a to b; a if there is none. */
  virtual CurveNode Between(const CurveNode& a, const CurveNode& b, double t) = 0;
};

struct StepBounds
{
  double ChordError;
  double Longest; ///< step
  double Shortest; ///< below it a step is not halved any more
};

/**
 * Append the points after the first of those of the nodes that are needed, and points between them
 * where more are.
 * @param fewest steps, if there are as many nodes
 * @return the largest measured distance.
 */
double StepAlong(const std::vector<CurveNode>& nodes, const StepBounds& bounds, std::size_t fewest,
  SteppedCurve& curve, std::vector<CurveNode>& points);

} // namespace sb

#endif
