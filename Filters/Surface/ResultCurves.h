// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ResultCurves.h
 * @brief The intersection curves as polylines, with the cell arrays Length and Closed.
 */
#ifndef ResultCurves_h
#define ResultCurves_h

#include "Boolean.h"

class vtkPolyData;

namespace sbvtk
{

/**
 * Give `output` the curves, one polyline cell each; a closed one names its first point again at its
 * end. Length is in the unit of the points; Closed is 1 or 0.
 */
void CopyCurves(const sb::Curves& curves, bool singlePrecision, vtkPolyData* output);

} // namespace sbvtk

#endif
