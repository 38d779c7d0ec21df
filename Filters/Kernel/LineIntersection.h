// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LineIntersection.h
 * @brief All points in which a segment meets the surface of a cloud (Yang and Qian 2009, section
 * 4.1).
 *
 * The paper starts Brent's method on |psi(x) - x| from the samples near the line. This touches zero
 * without changing sign, and cannot be bracketed; here the signed function is. The segment is
 * looked at where samples are near it only, at steps of an eighth of the width. A change of sign is
 * a root. Between two values of one sign that come nearer to zero on the way, as their derivatives
 * tell, the nearest place is looked for; if the sign changes there, there are two roots.
 */
#ifndef sb_LineIntersection_h
#define sb_LineIntersection_h

#include "MovingLeastSquares.h"

#include <vector>

namespace sb
{

/** Places t in [0, 1] on the segment from a to b, ascending. Only roots where the surface is
 * defined are returned. */
std::vector<double> IntersectSegment(const MovingLeastSquares& surface, const Real3& a,
  const Real3& b, MovingLeastSquares::Neighbourhood& near);

} // namespace sb

#endif
