// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchBounds.h
 * @brief A box around a part of a patch and bounds on the lengths of its parameter lines, which no
 * sampling could guarantee.
 *
 * Within a span of the knots the part over any rectangle is a Bezier patch, whose poles are the
 * values of the blossom at the rectangle's ends (Ramshaw 1989). It lies in their convex hull, and
 * their differences bound its derivatives; both bounds close in as the rectangle shrinks.
 */
#ifndef sb_PatchBounds_h
#define sb_PatchBounds_h

#include "NURBSSurface.h"

namespace sb
{

struct ParameterBox
{
  double FirstU = 0.0;
  double LastU = 0.0;
  double FirstV = 0.0;
  double LastV = 0.0;
};

struct PatchBounds
{
  Real3 Lower{};
  Real3 Upper{};
  double LengthU = 0.0; ///< no line along u over the rectangle is longer
  double LengthV = 0.0;
};

/** Of the part of the rectangle that lies in the domain; at least its border does. */
PatchBounds BoundsOf(const NURBSSurface& surface, const ParameterBox& box);

} // namespace sb

#endif
