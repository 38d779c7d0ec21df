// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cut.h
 * @brief Filled cross-sections of a closed surface by parallel planes.
 *
 * The cross-section of a plane is the cap that clipping by it would make (Clip.h), seen from in
 * front: what of the plane has the solid just in front of it. Each triangle is given to the planes
 * that it may reach, by a search among their heights; then the planes are independent.
 */
#ifndef sb_Cut_h
#define sb_Cut_h

#include "Boolean.h"
#include "HalfSpace.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct CutRequest
{
  Surface Mesh;
  const std::int32_t* FirstTriangles = nullptr; ///< as in ClipRequest
  std::int64_t NumberOfCells = 0;
  ClipPlane Plane;
  /** Where the planes lie: distances along the normal, in the unit of the points. */
  std::vector<double> Offsets{ 0.0 };
};

/** A connected part of a cross-section, with its holes. */
struct CutPolygon
{
  std::int32_t Plane; ///< index into Offsets
  std::int32_t Nesting; ///< 0 outermost, 1 in a hole of such a one, ...
  double Area; ///< without holes, in the unit of the points, squared
  double Perimeter; ///< with that of the holes
};

struct CutResult
{
  Status Condition = Status::Ok;
  std::vector<Remark> Remarks;

  std::vector<InterpolatedPoint> Points;
  std::vector<std::array<std::int32_t, 3>> Triangles; ///< ids of Points; facing along the normal
  std::vector<std::int32_t> PolygonOfTriangle;
  std::vector<CutPolygon> Polygons; ///< plane by plane
  /** The outlines of the polygons: first around, then around holes the other way round. */
  std::vector<std::int32_t> LoopPoints; ///< ids of Points; the first is not repeated
  std::vector<std::int32_t> LoopOffsets{ 0 };
  std::vector<std::int32_t> PolygonOfLoop;
  std::vector<std::uint8_t> IsHole; ///< by loop

  std::int64_t JoinedContours = 0; ///< as in ClipResult
  std::int64_t OpenContours = 0;
  std::vector<StageTime> Times;
};

/** As ComputeBoolean in its promises. */
CutResult CutSurface(const CutRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
