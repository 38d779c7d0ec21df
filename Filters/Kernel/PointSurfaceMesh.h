// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointSurfaceMesh.h
 * @brief A triangle mesh of a moving-least-squares surface, by marching cubes along the surface.
 *
 * It starts in the cells of a grid that hold samples, and goes on through every face that the
 * surface crosses; no other cell is ever evaluated, and no memory is taken for the box around the
 * cloud. A vertex is the root of the function on an edge of the grid. As it stays on its edge and
 * each triangle in its cube, no triangle crosses another one. What cannot be judged is left open: a
 * triangle with a corner beyond the border of the scan, or in a hole that the samples do not span.
 * Pieces with a diagonal of less than three widths are left out: outliers make such specks, while a
 * body of a size that the width can show, two widths at least, has a longer diagonal. The longest
 * piece always stays.
 */
#ifndef sb_PointSurfaceMesh_h
#define sb_PointSurfaceMesh_h

#include "MovingLeastSquares.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sb
{

struct PointSurfaceMesh
{
  std::vector<double> Points;
  std::vector<double> Normals; ///< unit gradients
  std::vector<std::int32_t> Triangles; ///< counter-clockwise seen from where the normals point
  std::int64_t NumberOfBorderEdges = 0; ///< 0 if the mesh is closed
  std::int64_t NumberOfSpecks = 0; ///< pieces that were left out
  enum class Ending
  {
    Done,
    Aborted,
    TooFine ///< more than 2^31 vertices, or cells across the cloud
  } End = Ending::Done;
};

/** Cells of two spacings give triangles as fine as the cloud; where the width is small they must be
 * smaller, for the function to be known at all their corners. */
inline double CellSizeFor(const MovingLeastSquares& surface, double spacing)
{
  return std::min(2.0 * spacing, 2.0 / 3.0 * surface.NarrowWidth());
}

/** @param cell the edge of the cells, positive; CellSizeFor gives a good one. */
PointSurfaceMesh MeshPointSurface(
  const MovingLeastSquares& surface, double cell, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
