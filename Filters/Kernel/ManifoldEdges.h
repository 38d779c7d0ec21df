// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ManifoldEdges.h
 * @brief Gives points a second instance where more than two triangles share an edge.
 *
 * A solid cut through a re-entrant edge touches itself along that edge: four triangles meet there.
 * They are joined in pairs, and the points of the edge are multiplied, so that each edge of the
 * result, by the ids of its points, has two triangles.
 */
#ifndef sb_ManifoldEdges_h
#define sb_ManifoldEdges_h

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/**
 * Separate what meets at edges of more than two triangles.
 * @param triangles point ids; changed where a point gets a further instance
 * @param numberOfPieces triangles before this one are of the surface, the others of caps; like is
 * joined with like
 * @param firstPoint points below this may have other triangles, too, and are left alone
 * @param numberOfPoints the first id to give out
 * @return for each id given out, the point that it is an instance of
 */
std::vector<std::int32_t> SeparateContacts(std::vector<std::array<std::int32_t, 3>>& triangles,
  std::int64_t numberOfPieces, std::int32_t firstPoint, std::int32_t numberOfPoints);

} // namespace sb

#endif
