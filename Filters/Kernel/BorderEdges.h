// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BorderEdges.h
 * @brief How far a mesh is from being closed by point ids.
 */
#ifndef sb_BorderEdges_h
#define sb_BorderEdges_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

/** How many edges triangles go along more often in one direction than in the other, each as often
 * as that is so: 0 if the mesh is closed. */
std::int64_t CountBorderEdges(
  const std::vector<std::int32_t>& triangles, std::size_t numberOfPoints);

} // namespace sb

#endif
