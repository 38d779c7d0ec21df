// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TimeSteps.h
 * @brief Time steps of a filter with several inputs: those of all of them.
 */
#ifndef TimeSteps_h
#define TimeSteps_h

#include "sbSurfaceModule.h" // for the export macro

class vtkInformationVector;

namespace sbvtk
{

/**
 * Give every output the union of the time steps of all connections of all ports, and the range that
 * holds all of theirs. The pipeline by itself passes on those of the first connection only, so that
 * a moving second input would stand still.
 */
SBSURFACE_EXPORT void UniteTimeSteps(
  vtkInformationVector** inputs, int numberOfPorts, vtkInformationVector* outputs);

} // namespace sbvtk

#endif
