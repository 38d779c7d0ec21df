// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CapFilling.h
 * @brief The contour of one plane, by its nodes, as triangles.
 */
#ifndef sb_CapFilling_h
#define sb_CapFilling_h

#include "CapContours.h"
#include "CapTriangulation.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct CapFilling
{
  std::vector<std::array<std::int32_t, 3>> Triangles; ///< instances of ClipPoints
  std::vector<std::int32_t> Regions; ///< by triangle; see Filling
  std::vector<std::int32_t> Depths; ///< by region; see Filling
};

/**
 * Fill a closed contour.
 * @param splits gets the points that this puts inside segments
 */
CapFilling FillCapContour(ClipPoints& points, std::int32_t plane, const Contour& contour,
  FillRule rule, SplitSegments& splits);

} // namespace sb

#endif
