// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshSection.h
 * @brief The curves in which a triangle mesh meets the surface of a cloud, with a bound on the
 * chord error (Yang and Qian 2009, section 5).
 *
 * The mesh is refined to the cloud's spacing where the cloud is near, and nothing else of it is
 * looked at. The signs of the cloud's function at the corners of the small triangles give all
 * branches at once: a loop wider than two spacings contains a corner and cannot be missed, inside
 * of one triangle of the mesh or not. Where a curve crosses an edge is computed once for the edge,
 * so that curves go on from triangle to triangle by construction. Within each triangle of the mesh
 * the curve is a plane one, and its points are chosen as in a section with a plane; where it
 * crosses an edge of the mesh its direction breaks, and there is a point.
 */
#ifndef sb_MeshSection_h
#define sb_MeshSection_h

#include "CurveEnd.h"
#include "DesignedSurface.h"
#include "MovingLeastSquares.h"
#include "SectionRequest.h"
#include "TouchSearch.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct MeshSectionCurve
{
  std::vector<Real3> Points; ///< the first again at the end if Closed
  std::vector<std::int32_t> Triangles; ///< of the mesh, that each segment lies in
  bool Closed = false;
  std::array<CurveEnd, 2> Ends{ CurveEnd::None, CurveEnd::None };
  bool IsTangential = false; ///< somewhere the surfaces meet at an angle below 0.1
  double LargestChordError = 0.0; ///< as measured
};

enum class MeshSectionStatus
{
  Ok,
  TooLarge, ///< the mesh would be refined to more triangles than 32-bit numbers can name
  Aborted
};

struct MeshSection
{
  MeshSectionStatus Status = MeshSectionStatus::Ok;
  std::vector<MeshSectionCurve> Curves;
  /** Where the mesh comes nearer to the surface than the chord error, or a tenth of the spacing,
   * without crossing it. */
  std::vector<SurfaceTouch> Touches;
  double CoincidentArea = 0.0; ///< of the mesh, where it lies on the cloud; no curves are in it
};

/** The inside of the cloud lies on the left of the curves, seen from the front of the mesh. */
MeshSection IntersectMesh(const MovingLeastSquares& surface, const DesignedSurface& mesh,
  const SectionRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
