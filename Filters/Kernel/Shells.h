// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shells.h
 * @brief The parts of a surface that hang together by edges: their measures, their holes, and how
 * many handles they have.
 *
 * Vertices are counted once for each fan of triangles around them, as if shells that touch in a
 * point had been taken apart there; so the number of handles follows from Euler's formula.
 */
#ifndef sb_Shells_h
#define sb_Shells_h

#include "BVH.h"
#include "Boolean.h"
#include "Executor.h"
#include "MeshEdges.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct Shell
{
  std::int32_t FirstTriangle = 0;
  std::int64_t NumberOfTriangles = 0;
  std::int64_t NumberOfVertices = 0;
  std::int64_t NumberOfEdges = 0;
  std::int64_t NumberOfRims = 0; ///< loops of edges that one triangle has
  bool IsClosed = true; ///< each edge is used as often one way as the other
  bool IsManifold = true; ///< no edge has more than two triangles
  bool IsOrientable = true; ///< turning triangles over can make all neighbours agree
  double Volume = 0.0; ///< signed; of an open shell without meaning
  double Area = 0.0;
  Box Bounds{};
  std::int32_t Genus = -1; ///< number of handles; -1 unless IsManifold and IsOrientable
  // By ShellNesting.h:
  std::int32_t Depth = 0; ///< how many closed shells it lies inside of
  std::int32_t Parent = -1; ///< the innermost of them
  std::int32_t WindingInFront = 0; ///< of all closed shells; 0 in a surface that encloses a solid

  std::int64_t EulerCharacteristic() const
  {
    return this->NumberOfVertices - this->NumberOfEdges + this->NumberOfTriangles;
  }
};

struct ShellSet
{
  std::vector<std::int32_t> OfTriangle; ///< [triangle]; -1 where two corners are one vertex
  std::vector<Shell> Shells; ///< by their first triangles
  std::vector<std::int32_t> RimOfEdge; ///< [irregular edge] the number of its loop, or -1
  std::int32_t NumberOfRims = 0;
  /** [triangle] 1 where it is oriented against most of its shell; empty if there is none. */
  std::vector<std::uint8_t> IsFlipped;
};

/**
 * @param mesh good throughout (finite, ids in range)
 * @param corners three vertices a triangle, as `fans` names them
 */
ShellSet FindShells(const Surface& mesh, const std::vector<std::int32_t>& corners,
  const VertexFans& fans, const MeshEdges& edges, Executor& executor);

} // namespace sb

#endif
