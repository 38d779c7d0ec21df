// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudBooleanOutputs.h
 * @brief The data sets of a Boolean of a cloud: its surface, its points and its seam.
 */
#ifndef CloudBooleanOutputs_h
#define CloudBooleanOutputs_h

#include "CloudBoolean.h"
#include "CloudInput.h"
#include "DesignedInput.h"

class vtkPolyData;

namespace sbvtk
{

struct CloudBooleanParts
{
  const sb::CloudSurface& Cloud;
  const CloudInput& Input;
  const DesignedInput& Tool;
  const sb::CloudBooleanResult& Result;
};

struct CloudBooleanOutputs
{
  vtkPolyData* Surface;
  vtkPolyData* Points;
  vtkPolyData* Curves;
};

void BuildCloudBoolean(
  const CloudBooleanParts& parts, const CloudBooleanOutputs& outputs, sb::Executor& executor);

} // namespace sbvtk

#endif
