// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CubeCases.h
 * @brief The triangles in a cube for each choice of its corners that are inside (marching cubes,
 * Lorensen and Cline 1987), derived by rule and not from a printed table.
 *
 * On a face of the cube each run of inside corners is cut off by one segment. That depends on the
 * face alone, so two cubes that share it have the same segments and no gap. The segments form loops
 * around the cube; each is filled without a diagonal in a face, which the neighbour might have as
 * well. So a surface of such cubes is a manifold.
 *
 * Corner c lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge 4 a + k runs along axis a; bit 0 of k is
 * the coordinate on axis a + 1, bit 1 that on axis a + 2, axes counted in a ring.
 */
#ifndef sb_CubeCases_h
#define sb_CubeCases_h

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** The lower corner of an edge; the upper one has bit `edge / 4` set in addition. */
int LowerCornerOfCubeEdge(int edge);

/** Three edges of the cube, on which the corners of the triangle lie. Counter-clockwise as seen
 * from where it is not inside. */
using CubeTriangle = std::array<std::uint8_t, 3>;

/** The triangles that fill one loop. */
using CubeFill = std::vector<CubeTriangle>;

/** All ways to fill one loop, of which each fits to the neighbouring cubes; at least one. */
using CubeLoop = std::vector<CubeFill>;

/** @param inside bit c is set if corner c is inside. */
const std::vector<CubeLoop>& LoopsOfCube(int inside);

} // namespace sb

#endif
