// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoincidentArea.h
 * @brief Where a mesh lies on a cloud within the cloud's noise, over an area and not only along a
 * curve.
 *
 * The zero set has no meaning there: it is as many small loops as the noise has waves. A triangle
 * coincides if the function at its corners is within four standard deviations of what the noise
 * leaves of itself after averaging, s / (h sqrt(2 pi)) of it for samples s apart, and the surfaces
 * are nearly parallel. Where two surfaces cross at a small angle, or one touches the other, this
 * holds in a strip or a spot; an area is what contains a disc of two widths of such triangles.
 */
#ifndef sb_CoincidentArea_h
#define sb_CoincidentArea_h

#include "BandMesh.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** The sine of the angle below which two surfaces count as touching. */
constexpr double TangentialSine = 0.1;

/** The sine of the angle between a triangle's plane and the surface of a function. */
double SineBetween(const Real3& gradient, const Real3& unitNormal);

/**
 * 1 for each triangle that belongs to a coincident area; empty if there is none.
 * @param spacing of the cloud
 */
std::vector<std::uint8_t> FindCoincidentArea(
  const BandMesh& band, const MovingLeastSquares& surface, double spacing, Executor& executor);

} // namespace sb

#endif
