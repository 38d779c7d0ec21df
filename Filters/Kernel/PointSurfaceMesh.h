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
 */
#ifndef sb_PointSurfaceMesh_h
#define sb_PointSurfaceMesh_h

#include "MovingLeastSquares.h"

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
  enum class Ending
  {
    Done,
    Aborted,
    TooFine ///< more than 2^31 vertices, or cells across the cloud
  } End = Ending::Done;
};

/** @param cell the edge of the cells, positive; about two spacings give triangles as fine as the
 * cloud. */
PointSurfaceMesh MeshPointSurface(
  const MovingLeastSquares& surface, double cell, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
