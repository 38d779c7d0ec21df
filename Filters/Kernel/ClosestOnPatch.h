// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosestOnPatch.h
 * @brief The point of a patch that is closest to a given point.
 */
#ifndef sb_ClosestOnPatch_h
#define sb_ClosestOnPatch_h

#include "NURBSSurface.h"

namespace sb
{

struct PlaceOnPatch
{
  double U = 0.0;
  double V = 0.0;
  Real3 Point{};
  double Distance = 0.0;
};

/** The local minimum of the distance that Newton's method (where it does not descend, the method of
 * Gauss and Newton) reaches from u and v within the domain. */
PlaceOnPatch ClosestOnPatchFrom(const NURBSSurface& patch, const Real3& x, double u, double v);

/** The closest of the local minima that are reached from samples of the whole patch. */
PlaceOnPatch ClosestOnPatch(const NURBSSurface& patch, const Real3& x);

} // namespace sb

#endif
