// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchPlacement.h
 * @brief Moves exact patches to where their facets are.
 */
#ifndef PatchPlacement_h
#define PatchPlacement_h

#include "DesignedSurface.h"
#include "Executor.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sbvtk
{

/**
 * Find the affine map from where the patches have the facets' corners to where these are, and apply
 * it to the patches.
 * @param surface with UV, FaceId (-1: no patch) and Patches
 * @param groupOfPatch patches that have moved together have the same number, counted from 0
 * @return empty, or the end of a sentence "Tool ..." that says why the patches do not fit the
 * facets; the surface is then unchanged.
 */
std::string PlacePatches(sb::DesignedSurface& surface,
  const std::vector<std::int32_t>& groupOfPatch, sb::Executor& executor);

} // namespace sbvtk

#endif
