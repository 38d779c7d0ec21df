// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudCurves.h
 * @brief Curves on the surface of a cloud, whatever it was cut with, and the polylines and arrays
 * that are made of them.
 */
#ifndef CloudCurves_h
#define CloudCurves_h

#include "CurveEnd.h"
#include "MovingLeastSquares.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkPolyData;

namespace sbvtk
{

class DesignedInput;

/** What a curve bends in: a plane, or a patch. */
struct CurvePlace
{
  sb::Real3 Normal{}; ///< of the plane or patch, a unit vector
  sb::Real3 CurvatureVector{}; ///< on a patch
  vtkIdType Cell = -1; ///< of a mesh
  int Face = -1; ///< of a body with patches
  std::array<double, 2> UV{};
};

struct CloudCurve
{
  std::vector<sb::Real3> Points; ///< the first again at the end if Closed
  std::vector<CurvePlace> Places; ///< of each point
  bool Closed = false;
  bool IsTangential = false;
  std::array<sb::CurveEnd, 2> Ends{ sb::CurveEnd::None, sb::CurveEnd::None };
  double ChordError = 0.0;
};

enum class CutWith
{
  Plane,
  Mesh,
  Patches
};

/** Fill `output` with a polyline for each curve, and with the arrays that its cutter has. */
void BuildCurves(const std::vector<CloudCurve>& curves, const sb::MovingLeastSquares& surface,
  CutWith cutter, vtkPolyData* output);

/** Add to the curves' points the block of the tool that each lies on, and the blocks' names. */
void MarkBlocks(const DesignedInput& tool, vtkPolyData* output);

} // namespace sbvtk

#endif
