// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShellNesting.h
 * @brief Which shell lies inside of which, and whether its orientation fits there.
 *
 * A surface encloses a solid if the winding number is 0 in front of each of its shells and 1
 * behind: so a shell in the hollow of another one has to be oriented like that, and a hollow the
 * other way round. An exact vertical line through a triangle of each shell tells which others are
 * around it. Shells that cross each other are inside of one another at that triangle, or not.
 */
#ifndef sb_ShellNesting_h
#define sb_ShellNesting_h

#include "Executor.h"
#include "Scene.h"
#include "Shells.h"

#include <cstdint>
#include <vector>

namespace sb
{

/**
 * Set Depth, Parent and WindingInFront of all shells.
 * @param scene with the surface as its one operand, not swapped
 * @param collapsed [face] whether it has no area; empty if none
 */
void FindNesting(const Scene& scene, const std::vector<std::uint8_t>& collapsed, ShellSet& shells,
  Executor& executor, Monitor& monitor);

} // namespace sb

#endif
