// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FlippedTriangles.h
 * @brief Where neighbours are oriented against each other: which side of the quarrel is the smaller
 * one.
 *
 * Triangles that agree with their neighbours make *patches*; patches that quarrel at an edge want
 * opposite colours. Where two colours do not suffice, the surface is one-sided (a Moebius strip),
 * and nothing can be turned over to make it agree.
 */
#ifndef sb_FlippedTriangles_h
#define sb_FlippedTriangles_h

#include "DisjointSets.h"
#include "MeshEdges.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct FlippedTriangles
{
  std::vector<std::uint8_t> IsFlipped; ///< [triangle]; empty if no neighbours disagree
  std::vector<std::int32_t>
    OneSided; ///< a triangle of each part that two colours do not suffice for
};

/** @param patches of triangles, joined across the edges at which two agree. */
FlippedTriangles FindFlippedTriangles(const DisjointSets& patches, const MeshEdges& edges);

} // namespace sb

#endif
