// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshEdges.h
 * @brief How the triangles of a surface hang together: at edges of two, of one or of many, and
 * around each vertex.
 *
 * Everything is decided from the triangles around one vertex at a time. Their other corners are the
 * vertex's *link*; an edge is a node of the links of both its ends, and the end with the lower
 * number speaks for it. So no table of edges is sorted, and vertices are independent of each other.
 */
#ifndef sb_MeshEdges_h
#define sb_MeshEdges_h

#include "Executor.h"
#include "VertexFans.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** The edge of triangle t from its corner e to the next is the half-edge 3 t + e. */
using HalfEdge = std::int32_t;

/** An edge that is not one of two triangles which agree on which side is front. */
struct IrregularEdge
{
  std::int32_t FirstUse; ///< into MeshEdges::Uses
  std::int32_t NumberOfUses;
  std::int32_t Balance; ///< uses from the lower to the higher vertex, less those the other way

  bool IsRim() const { return this->NumberOfUses == 1; }
  bool IsManifold() const { return this->NumberOfUses <= 2; }
  /** Whether the surface is not closed there whatever is done about orientations. */
  bool IsOdd() const { return this->NumberOfUses % 2 == 1; }
  /** Whether it would be closed there, were some triangles turned over. */
  bool IsContradiction() const { return !this->IsOdd() && this->Balance != 0; }
};

/** Of a vertex whose triangles do not all hang together by edges at it: one of the fans that they
 * make, but the first. */
struct FurtherFan
{
  std::int32_t Vertex;
  std::int32_t Triangle; ///< the first one in it
};

struct MeshEdges
{
  /** [half-edge] the other one of an edge that two triangles use, each its own way; else -1. */
  std::vector<HalfEdge> Mates;
  std::vector<IrregularEdge> Irregular; ///< by their lower vertex, then the higher
  std::vector<HalfEdge> Uses;
  std::vector<FurtherFan> FurtherFans; ///< by vertex, then triangle
  std::vector<std::array<HalfEdge, 2>> RimJoins; ///< rim edges that follow each other along a fan
};

/** Whether two corners of a triangle are one vertex; it then has no edges to speak of. */
inline bool IsPinched(const std::int32_t* corners)
{
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

/**
 * @param corners three vertices a triangle, as `fans` names them
 * @param numberOfPoints the number of vertices is at most that
 */
MeshEdges FindMeshEdges(const std::vector<std::int32_t>& corners, std::int64_t numberOfPoints,
  const VertexFans& fans, Executor& executor);

} // namespace sb

#endif
