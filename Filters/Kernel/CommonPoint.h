// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommonPoint.h
 * @brief From a place near the surface of a cloud and a patch (or a plane) to a point on both.
 *
 * The closest point of the patch, taken after a point of the cloud's surface, would leave that
 * surface again. Newton's method for f(S(u, v)) = 0 stays on the patch all the time: with the
 * Jacobian J = [S_u S_v] and w = J^T grad f, the shortest step in space is
 * -f M^-1 w / (w^T M^-1 w), M = J^T J.
 */
#ifndef sb_CommonPoint_h
#define sb_CommonPoint_h

#include "MovingLeastSquares.h"
#include "NURBSSurface.h"

namespace sb
{

struct CommonPoint
{
  bool Found = false; ///< if not, the rest is where the search was given up
  double U = 0.0; ///< for a patch
  double V = 0.0;
  Real3 Point{};
  SurfaceValue Surface; ///< of the cloud at the point, with its gradient; its value is the residual
};

/**
 * The point on both that Newton's method reaches from u and v in steps of at most 0.4 widths; not
 * found if it would be farther than two widths from the start, or the surfaces touch there without
 * crossing. Where lines of constant v are a single point (the poles of a sphere), u is turned to
 * where the surface is.
 */
CommonPoint OntoCloudAndPatch(const MovingLeastSquares& surface, const NURBSSurface& patch,
  double u, double v, MovingLeastSquares::Neighbourhood& near);

/**
 * The same in a plane.
 * @param normal a unit vector
 * @param start is taken to the plane first
 */
CommonPoint OntoCloudAndPlane(const MovingLeastSquares& surface, const Real3& origin,
  const Real3& normal, const Real3& start, MovingLeastSquares::Neighbourhood& near);

/**
 * The curvature vector of the curve in which the zero set of a function and a patch meet: it is
 * orthogonal to the curve and as long as one over its radius. Its part along the gradient follows
 * from the Hessian, its part along the patch's normal from the second derivatives of the patch (Ye
 * and Maekawa 1999, section 3). 0 where the two surfaces touch.
 * @param value with Hessian
 * @param at with second derivatives
 */
Real3 CurvatureOfCommonCurve(const SurfaceValue& value, const PatchPoint& at);

} // namespace sb

#endif
