// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DefectLines.h
 * @brief The places where a surface has defects, as lines and points to be drawn.
 */
#ifndef DefectLines_h
#define DefectLines_h

#include "OperandSurface.h"
#include "SurfaceCheck.h"

class vtkPolyData;

namespace sbvtk
{

/**
 * Edges, self-intersections and triangles without area become lines; points of contact, and what
 * has collapsed to one, become vertices. Edges that follow each other have points in common.
 */
void BuildDefectLines(const OperandSurface& surface, const sb::SurfaceCheckResult& result,
  bool singlePrecision, vtkPolyData* output);

} // namespace sbvtk

#endif
