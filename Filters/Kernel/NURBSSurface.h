// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NURBSSurface.h
 * @brief A patch of a rational B-spline surface: its point and derivatives at u and v (Piegl and
 * Tiller, The NURBS Book, 1997, sections 2.5, 3.5 and 4.5).
 */
#ifndef sb_NURBSSurface_h
#define sb_NURBSSurface_h

#include "Real3.h"

#include <cstddef>
#include <vector>

namespace sb
{

struct NURBSSurface
{
  static constexpr int LargestDegree = 25; ///< also that of the CAD kernels that files come from

  int DegreeU = 0; ///< at least 1
  int DegreeV = 0;
  int CountU = 0; ///< poles along u
  int CountV = 0;
  std::vector<double> KnotsU; ///< CountU + DegreeU + 1 of them, non-decreasing, clamped or not
  std::vector<double> KnotsV;
  /** x, y, z (not multiplied by the weight) and weight of pole (i, j) at 4 * (i * CountV + j). */
  std::vector<double> Poles;

  double FirstU() const { return this->KnotsU[static_cast<std::size_t>(this->DegreeU)]; }
  double LastU() const { return this->KnotsU[static_cast<std::size_t>(this->CountU)]; }
  double FirstV() const { return this->KnotsV[static_cast<std::size_t>(this->DegreeV)]; }
  double LastV() const { return this->KnotsV[static_cast<std::size_t>(this->CountV)]; }
};

/** What is wrong with a patch, as the end of a sentence that begins with "It"; null if nothing. A
 * patch with a fault must not be evaluated. */
const char* FaultOf(const NURBSSurface& surface);

struct PatchPoint
{
  Real3 Point{};
  Real3 Du{};
  Real3 Dv{};
  Real3 Duu{};
  Real3 Duv{};
  Real3 Dvv{};
};

/**
 * The point at u and v, and with `order` 1 the first, with 2 the second derivatives as well; those
 * not asked for are 0. Places outside of the domain are taken to its border. On a knot where a
 * derivative jumps it is the one of the side of larger parameters, at the end of the domain of the
 * smaller.
 */
PatchPoint EvaluatePatch(const NURBSSurface& surface, double u, double v, int order);

} // namespace sb

#endif
