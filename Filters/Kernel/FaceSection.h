// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceSection.h
 * @brief The pieces of curves in which the surface of a cloud meets one trimmed patch, as points
 * that are close together, each on both.
 *
 * Where a branch (FaceBranches.h) crosses the border of the trimmed domain, it is cut in a point of
 * that border.
 */
#ifndef sb_FaceSection_h
#define sb_FaceSection_h

#include "ChordSteps.h"
#include "CoincidentArea.h"
#include "CurveEnd.h"
#include "MovingLeastSquares.h"
#include "TouchSearch.h"
#include "TrimmedDomain.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

struct SectionPiece
{
  std::int32_t Face = 0;
  std::vector<CurveNode> Nodes; ///< the first again at the end if closed
  CurveEnd Begin = CurveEnd::None;
  CurveEnd End = CurveEnd::None;
  /** The borders that the piece is cut by, where it is. */
  TrimmedDomain::Edge BeginEdge{};
  TrimmedDomain::Edge EndEdge{};
};

struct FaceSection
{
  std::vector<SectionPiece> Pieces; ///< the cloud's inside is on the left, seen from outside
  double CoincidentArea = 0.0;
  std::vector<SurfaceTouch> Touches; ///< without a curve of this face near them
};

/** What all faces share. */
struct FaceSectionRequest
{
  const MovingLeastSquares& Surface;
  const DesignedSurface& Designed;
  double Spacing; ///< of the cloud
  CoincidenceTolerance& Tolerance;
  double NearestTouch; ///< how near a face has to come to touch
};

/**
 * @param triangles of one face that has a patch, their numbers
 * @param halvings how often the cells that branches cross are cut into four. Where two branches run
 * through one cell (the face is nearly tangential at a saddle), its corners do not tell which ends
 * belong together.
 */
FaceSection SectionOfFace(const FaceSectionRequest& request,
  const std::vector<std::int32_t>& triangles, int halvings, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
