// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DesignedSurface.h
 * @brief The surface of a designed body: facets and, where they are known, the exact patches that
 * the facets stand for.
 */
#ifndef sb_DesignedSurface_h
#define sb_DesignedSurface_h

#include "NURBSSurface.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** Each face has points of its own, so facets of neighbouring faces meet in points of equal
 * coordinates and not of equal numbers. */
struct DesignedSurface
{
  std::vector<double> Points; ///< x, y, z
  std::vector<std::int32_t> Triangles; ///< counter-clockwise seen from outside
  /** Of each point, u and v in the patch of the triangles that use it; empty: facets only. */
  std::vector<double> UV;
  std::vector<std::int32_t> FaceId; ///< of each triangle, an index into Patches; empty: facets only
  std::vector<NURBSSurface> Patches; ///< empty: facets only

  bool HasPatches() const { return !this->Patches.empty(); }
};

} // namespace sb

#endif
