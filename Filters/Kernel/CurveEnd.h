// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveEnd.h
 * @brief Why the curves end in which the surface of a cloud meets another one.
 */
#ifndef sb_CurveEnd_h
#define sb_CurveEnd_h

#include <cstdint>

namespace sb
{

enum class CurveEnd : std::uint8_t
{
  None = 0, ///< it is closed
  MeshBorder = 1, ///< the mesh or the trimmed patches end
  ScanBorder = 2, ///< the cloud ends
  CoincidentArea = 3, ///< from here on the mesh or patch lies on the cloud
  Junction = 4 ///< more than two triangles share the edge
};

} // namespace sb

#endif
