// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExactOrientation.h
 * @brief On which side of a triangle a point lies, exactly, for any doubles.
 *
 * The Boolean's predicates need lattice coordinates (Predicates.h). A distance is asked for at
 * points that are on no lattice, so here the determinant is evaluated with Shewchuk's expansions
 * (Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997), behind
 * his filter.
 */
#ifndef sb_ExactOrientation_h
#define sb_ExactOrientation_h

#include "Vector3.h"

namespace sb
{

/**
 * 1 if `point` is in front of the triangle a b c (where its corners turn left), -1 if it is behind,
 * 0 if it is in its plane. Exact unless a product of three coordinates over- or underflows.
 */
int SideOfTriangle(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& point);

} // namespace sb

#endif
