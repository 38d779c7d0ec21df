// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceBranches.h
 * @brief The branches of the curves in which the surface of a cloud meets one patch, before they
 * are trimmed: from signs at the corners of cells, as in a plane (PlaneSection.h), and areas of
 * cells where both coincide instead.
 */
#ifndef sb_FaceBranches_h
#define sb_FaceBranches_h

#include "ChordSteps.h"
#include "CoincidentArea.h"
#include "CurveEnd.h"
#include "PatchQuadtree.h"
#include "TouchSearch.h"

#include <vector>

namespace sb
{

struct FaceBranch
{
  std::vector<CurveNode> Nodes; ///< where it crosses the cells' edges; the first again if closed
  bool Closed = false;
  CurveEnd Begin = CurveEnd::ScanBorder;
  CurveEnd End = CurveEnd::ScanBorder;
};

struct FaceBranches
{
  std::vector<FaceBranch> Branches; ///< the cloud's inside is on the left, seen from S_u x S_v
  double CoincidentArea = 0.0;
  std::vector<std::uint8_t> IsCrossed; ///< of each cell, by a branch
  /** Where the patch, within its domain, comes near to the surface without crossing it. */
  std::vector<SurfaceTouch> Touches;
};

struct BranchRequest
{
  const MovingLeastSquares& Surface;
  const NURBSSurface& Patch;
  const TrimmedDomain& Domain;
  const PatchQuadtree& Tree;
  CoincidenceTolerance& Tolerance;
  double NearestTouch; ///< how near a patch has to come to touch
};

FaceBranches FindBranches(const BranchRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
