// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoincidentArea.h
 * @brief Where a mesh or a patch lies on a cloud within the cloud's noise, over an area and not
 * only along a curve.
 *
 * The zero set has no meaning there: it is as many small loops as the noise has waves. A cell (a
 * small triangle, a small part of a patch) coincides if the function at its corners is within four
 * standard deviations of what the noise leaves of itself after averaging, s / (h sqrt(2 pi)) of it
 * for samples s apart, and the surfaces are nearly parallel. Where two surfaces cross at a small
 * angle, or one touches the other, this holds in a strip or a spot; an area is what contains a disc
 * of two widths of such cells.
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

/** The unit normal of a triangle, or 0 if it has no area. */
Real3 UnitNormalOf(const Real3& a, const Real3& b, const Real3& c);

/** How large the function may be where surfaces coincide. Found from samples when first asked for,
 * as that takes a while and is rarely needed. */
class CoincidenceTolerance
{
public:
  /** @param spacing of the cloud */
  CoincidenceTolerance(const MovingLeastSquares& surface, double spacing)
    : Surface(surface)
    , Spacing(spacing)
  {
  }

  double Value();

  /** No tolerance is above it. */
  double Most() const { return 0.1 * this->Surface.Width(); }

private:
  const MovingLeastSquares& Surface;
  const double Spacing;
  double Known = -1.0;
};

/**
 * 1 for each cell that belongs to an area of cells that coincide; empty if there is none.
 * @param centres of cells
 * @param coincides 1 for those that do by themselves
 * @param width of the cloud's surface
 */
std::vector<std::uint8_t> AreaOf(const std::vector<Real3>& centres,
  const std::vector<std::uint8_t>& coincides, double width, Executor& executor);

/**
 * 1 for each triangle that belongs to a coincident area; empty if there is none.
 * @param spacing of the cloud
 */
std::vector<std::uint8_t> FindCoincidentArea(
  const BandMesh& band, const MovingLeastSquares& surface, double spacing, Executor& executor);

} // namespace sb

#endif
