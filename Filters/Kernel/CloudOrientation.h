// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudOrientation.h
 * @brief Whether a cloud that encloses something faces outwards.
 *
 * The winding number jumps by one at the surface; just on it, without the sample's own part, it is
 * one half for a closed cloud that faces outwards, minus one half for one that is inside out, and
 * about zero where a scan is a flat sheet, which has no inside. A few samples tell, and a few
 * thousand dipoles at them, whatever the size of the cloud.
 */
#ifndef sb_CloudOrientation_h
#define sb_CloudOrientation_h

#include "Executor.h"
#include "MovingLeastSquares.h"

namespace sb
{

/** The mean of the winding number on the surface, from -0.5 to 0.5. */
double WindingOnSurface(const MovingLeastSquares& surface, Executor& executor);

/** Below it a cloud is closed and inside out; of half a sphere that is seen from inside, as bowls
 * are, it is -0.3. */
constexpr double WindingOfInsideOut = -0.4;

} // namespace sb

#endif
