// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArrayRanges.h
 * @brief Leaves with each array of a filter's outputs the ranges of its values.
 *
 * ParaView asks for them after every update: those of each component and of the magnitude, all of
 * them a second time without infinite values. VTK takes a pass over the array for each, and then
 * keeps the answer with the array until that is modified (vtkDataArray::GetRange). The packaged VTK
 * is built without optimisation, so that this takes longer than a small Boolean; one pass by all
 * threads finds the same, and leaves it where VTK looks first.
 */
#ifndef ArrayRanges_h
#define ArrayRanges_h

#include "sbSurfaceModule.h" // for the export macro

class vtkAlgorithm;

namespace sbvtk
{

/** Do so for the points, and for the point and cell arrays that the filter does not share with its
 * inputs. Where there is no memory for it VTK is left to find the ranges. */
SBSURFACE_EXPORT void KeepRangesOfOutputs(vtkAlgorithm* filter);

} // namespace sbvtk

#endif
