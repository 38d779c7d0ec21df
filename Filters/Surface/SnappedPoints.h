// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SnappedPoints.h
 * @brief Points moved to a grid, so that those which nearly coincide mostly do.
 *
 * This is all that a tolerance ever does here: it moves the input before anything is decided, and
 * no decision is widened by it.
 */
#ifndef SnappedPoints_h
#define SnappedPoints_h

#include "Executor.h"

#include "vtkSmartPointer.h"

class vtkPoints;

namespace sbvtk
{

/**
 * The points at the nearest places of the coarsest grid on which no point moves farther than
 * `tolerance` (positive, unit of the points). The grid's step is a power of two, so that all
 * surfaces share it and float coordinates stay floats. Points nearer to each other than the
 * tolerance can still lie on two sides of the border between two places.
 */
vtkSmartPointer<vtkPoints> SnappedPoints(
  vtkPoints* points, double tolerance, sb::Executor& executor);

} // namespace sbvtk

#endif
