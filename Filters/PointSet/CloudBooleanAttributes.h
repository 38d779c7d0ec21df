// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudBooleanAttributes.h
 * @brief The arrays that a Boolean of a cloud carries: those of the cloud from the nearest sample,
 * those of the tool from its cells, and interpolated in them.
 *
 * A point of the seam is one of both. An array that only one of them has gets its value there from
 * that one; where both have it, from the cloud.
 */
#ifndef CloudBooleanAttributes_h
#define CloudBooleanAttributes_h

#include "CloudBoolean.h"
#include "CloudInput.h"
#include "DesignedInput.h"

#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataSetAttributes;
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

/** Give points the cloud's arrays. @param ids of each the point of the input to copy, or -1 */
void CarryCloudArrays(const CloudInput& input, const std::vector<std::int32_t>& ids,
  vtkDataSetAttributes* target, sb::Executor& executor);

/**
 * Give the surface, which has its points and cells, the arrays of both.
 * @param cells of the tool, of each cell of the surface; -1 for those of the cloud
 * @return one sentence for each array that could not be carried.
 */
std::vector<std::string> CarrySurfaceArrays(const CloudBooleanParts& parts,
  const std::vector<vtkIdType>& cells, vtkPolyData* surface, sb::Executor& executor);

} // namespace sbvtk

#endif
