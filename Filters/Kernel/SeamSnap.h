// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SeamSnap.h
 * @brief Moves the seam of a Boolean of a cloud's mesh with a tool onto the cloud's surface and the
 * tool at once.
 *
 * A seam vertex is where a chord of the cloud's mesh meets the tool, and so it is off the cloud's
 * surface by the sagitta of the mesh. It is moved along the tool, by the shortest way, to where the
 * cloud's function is zero: in the plane of its triangle, along an edge of the tool it lies on, or
 * on the exact patch behind the triangle, or where two patches meet.
 *
 * Triangles that are thinner than such a move would turn over. So short edges at the seam are
 * collapsed first, under the link condition (Dey, Edelsbrunner, Guha, Nekhayev, Topology preserving
 * edge contraction, 1999), a move is halved or dropped where it turns a triangle over, and for a
 * vertex that cannot be moved the edges in its way are flipped, the points in its way go into
 * others, or it goes into a neighbour on the seam itself, if that turns nothing over. At last the
 * kernel looks whether the triangles that changed cross others; where they do, all is done again
 * with more caution there.
 */
#ifndef sb_SeamSnap_h
#define sb_SeamSnap_h

#include "CombinedMesh.h"
#include "MovingLeastSquares.h"
#include "ToolSurface.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct SeamSnapRequest
{
  const MovingLeastSquares* Cloud = nullptr;
  const std::vector<double>* CloudNormals = nullptr; ///< of the points of operand 0
  Surface CloudMesh; ///< operand 0
  const ToolSurface* Tool = nullptr; ///< operand 1
  double Spacing = 0.0;
};

struct SeamVertex
{
  std::int32_t Point = -1; ///< of the mesh
  double Residual = 0.0; ///< how far it is from the cloud's surface: |f| / |grad f|
  double Tangency = 0.0; ///< the cosine between the two surfaces' normals, 0 or more
  bool Snapped = false; ///< it is where it should be
};

struct SeamSnap
{
  CombinedMesh Mesh;
  /** Of each point of the mesh before, the point of the new mesh that it is or became part of. */
  std::vector<std::int32_t> PointMap;
  std::vector<SeamVertex> Vertices; ///< ascending
  std::int64_t NumberOfCollapses = 0;
  std::int64_t NumberOfBackedOff = 0; ///< seam vertices that are not Snapped
  std::int64_t NumberOfCrossings = 0; ///< pairs of triangles that crossed after the last round
  double LargestResidual = 0.0;
  bool Aborted = false;
};

/** The direction that the front of a triangle of the mesh has to face, of length one or zero: that
 * of the cloud's normals, or of the tool's triangle. */
Real3 FrontOfTriangle(
  const CombinedMesh& mesh, std::int32_t triangle, const SeamSnapRequest& request);

SeamSnap SnapSeam(
  const CombinedMesh& mesh, const SeamSnapRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
