// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CapPolygons.h
 * @brief The outlines of the regions of a triangulation, as closed loops.
 */
#ifndef sb_CapPolygons_h
#define sb_CapPolygons_h

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct RegionLoops
{
  std::vector<std::int32_t> Connectivity; ///< points of all loops; the first is not repeated
  std::vector<std::int32_t> Offsets{ 0 };
  std::vector<std::int32_t> Regions; ///< by loop
};

/**
 * Walk along the outlines of regions, each region to the left as its triangles turn. Loops that
 * meet in a point stay apart there, as far as the region does.
 */
RegionLoops FindRegionLoops(const std::vector<std::array<std::int32_t, 3>>& triangles,
  const std::vector<std::int32_t>& regions);

} // namespace sb

#endif
