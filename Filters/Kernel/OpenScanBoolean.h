// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpenScanBoolean.h
 * @brief The Boolean of a scan that is not closed with a closed tool.
 *
 * An open mesh has no inside, but its samples have a winding number everywhere. So both surfaces
 * are cut along their curves, and whole patches are kept or dropped: those of the scan by the
 * tool's winding number, which is exact; those of the tool by the mean winding number of the scan's
 * oriented samples at their places. How far that is from one half says how sure it is.
 */
#ifndef sb_OpenScanBoolean_h
#define sb_OpenScanBoolean_h

#include "CloudBoolean.h"
#include "CombinedMesh.h"
#include "ToolSurface.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct OpenScanResult
{
  Status Condition = Status::Ok;
  std::vector<Remark> Remarks;
  CombinedMesh Mesh;
  Curves Seam;
  double LeastConfidence = 1.0; ///< of the tool's patches: |2 w - 1|
  double LeastWinding = 0.0; ///< the smallest mean winding number of a patch of the tool
  std::vector<StageTime> Times;
};

OpenScanResult CombineOpenScan(const MovingLeastSquares& cloud, const Surface& cloudMesh,
  const ToolSurface& tool, CloudOperation operation, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
