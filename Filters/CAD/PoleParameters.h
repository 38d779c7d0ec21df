// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PoleParameters.h
 * @brief Parameters for facets at a pole.
 *
 * At the pole of a sphere or the tip of a cone one side of the patch is in one place, so one of the
 * two parameters there is arbitrary. A facet with a corner at the pole stands for a wedge of the
 * patch; only with a parameter in the middle of the wedge is what lies between the corners in the
 * parameters also between them in space.
 */
#ifndef PoleParameters_h
#define PoleParameters_h

#include "DesignedSurface.h"

namespace sbvtk
{

/**
 * Give each facet with one corner at a pole a point of its own there, with the mean of the other
 * corners' parameters.
 * @param size of the surface; what is less than a billionth of it is one place
 */
void SetPoleParameters(sb::DesignedSurface& surface, double size);

} // namespace sbvtk

#endif
