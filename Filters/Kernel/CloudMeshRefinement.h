// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudMeshRefinement.h
 * @brief The mesh of a cloud with smaller triangles where a tool is near it.
 *
 * Where the two are joined, each vertex of the seam has to be moved from a chord of the mesh to the
 * cloud's surface, by the sagitta of its triangles. That falls with the square of their edges, so
 * where edges are a quarter as long, moves are a sixteenth, and short against the triangles that
 * they could turn over. Edges are halved and their middles moved onto the surface; both triangles
 * at an edge get the same point, so the mesh stays closed by point ids.
 */
#ifndef sb_CloudMeshRefinement_h
#define sb_CloudMeshRefinement_h

#include "MovingLeastSquares.h"
#include "PointSurfaceMesh.h"
#include "ToolSurface.h"

namespace sb
{

/**
 * Halve the edges of all triangles closer to the tool than a quarter of a cell, twice, unless that
 * would more than double a large mesh, as where a whole side of the tool lies along the cloud.
 * Edges whose halves would turn a triangle aside stay.
 * @param cell the edge of the cells that the mesh was made with
 */
void RefineNearTool(PointSurfaceMesh& mesh, const MovingLeastSquares& surface,
  const ToolSurface& tool, double cell, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
