// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FacePoints.h
 * @brief Gives a mesh that has parts of a designed body a point for each u and v: each face of the
 * body has points of its own, and so has what is on no face; where a patch meets itself, as at the
 * seam of a cylinder or the poles of a sphere, each side of it.
 */
#ifndef sb_FacePoints_h
#define sb_FacePoints_h

#include "CombinedMesh.h"
#include "ToolSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct FacePoints
{
  /** Of each corner of the mesh's triangles: its point there, or one after all of these. */
  std::vector<std::int32_t> Triangles;
  std::vector<std::int32_t> Repeated; ///< of each point that is new, the one it is a copy of
  /** Of each point, the new ones included: a triangle of the mesh that has it as a corner and is on
   * a face, or -1. */
  std::vector<std::int32_t> TriangleOnFace;
  /** Of each point: its u and v in the patch of that face, in the part of the domain in which its
   * triangles are; NaN on no face. */
  std::vector<std::array<double, 2>> UV;
  std::vector<std::uint8_t> IsExact; ///< of each point: 0 if its u and v are only near
};

/**
 * @param mesh of operand 0, which has no faces, and operand 1, the tool
 * @param tool with patches
 */
FacePoints FindFacePoints(const CombinedMesh& mesh, const ToolSurface& tool);

} // namespace sb

#endif
