// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Clip.h
 * @brief Clips a closed surface by planes and closes it again with caps.
 *
 * The solid that the surface encloses is intersected with all half-spaces at once. One pass over
 * the vertices finds on which sides they lie, one over the triangles finds what is kept, dropped or
 * cut; only what is cut costs more than a few nanoseconds. The result is the limit of what is left
 * when every plane is moved forward by an infinitesimal step, so there are no special positions: no
 * part without volume is left, and a surface that is closed before is closed after.
 *
 * Stages: sides and fates (here), FaceClip (cut triangles), CapContours (outlines of the caps),
 * CapTriangulation (their triangles), ManifoldEdges (contacts).
 */
#ifndef sb_Clip_h
#define sb_Clip_h

#include "Boolean.h"
#include "HalfSpace.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct ClipRequest
{
  Surface Mesh;
  /** The first triangle of each cell, and the end of the last; null if each triangle is one. A cell
   * that is flat stays one polygon through all planes. */
  const std::int32_t* FirstTriangles = nullptr;
  std::int64_t NumberOfCells = 0;
  std::vector<ClipPlane> Planes; ///< kept is what lies in front of all
  /** Kept is what does not lie in front of all planes. */
  bool InsideOut = false;
  /** PerSide: points of the input that coincide stay apart on the rim, so that each keeps its
   * attributes. */
  SeamPoints Seams = SeamPoints::Shared;
};

/** A segment of an outline, between points of the result. */
struct OutlineSegment
{
  std::array<std::int32_t, 2> Points;
  std::int32_t Plane;
};

struct ClipResult
{
  Status Condition = Status::Ok;
  std::vector<Remark> Remarks; ///< BadIndex, BadCoordinate, BadRequest, TooLarge, Aborted

  std::vector<Fate> Fates; ///< by triangle; Split ones are replaced by pieces
  std::vector<std::int32_t> PointMap; ///< by point: its id in the result, or -1
  /** The points copied to the result, ascending; they come first. */
  std::vector<std::int32_t> KeptPoints;
  /** The points that follow; Operand is 0, or 1 for a point inside the solid, without attributes.
   */
  std::vector<InterpolatedPoint> Created;

  std::vector<std::array<std::int32_t, 3>> Pieces; ///< ids of the result
  std::vector<std::int32_t> Parents; ///< by piece: the triangle that it is a part of
  std::vector<std::array<std::int32_t, 3>> Caps; ///< looking away from what is kept
  std::vector<std::int32_t> PlaneOfCap; ///< by triangle of Caps
  std::vector<double> CapAreas; ///< by plane, in the unit of the points, squared
  std::vector<OutlineSegment> Outline; ///< where the planes cut the surface and each other

  std::int64_t JoinedContours = 0; ///< open contours that were closed along the hull
  std::int64_t OpenContours = 0; ///< open contours that stayed open, and got no cap
  std::vector<StageTime> Times;
};

/** As ComputeBoolean in its promises. */
ClipResult ClipSurface(const ClipRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
