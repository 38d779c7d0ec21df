// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudBooleanOutputs.h
 * @brief The data sets of a Boolean of a cloud: its surface, its points and its seam.
 */
#ifndef CloudBooleanOutputs_h
#define CloudBooleanOutputs_h

#include "CloudBooleanAttributes.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace sbvtk
{

struct CloudBooleanOutputs
{
  vtkPolyData* Surface;
  vtkPolyData* Points;
  vtkPolyData* Curves;
};

/** @return one sentence for each array of the inputs that could not be carried. */
std::vector<std::string> BuildCloudBoolean(
  const CloudBooleanParts& parts, const CloudBooleanOutputs& outputs, sb::Executor& executor);

} // namespace sbvtk

#endif
