// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudRun.h
 * @brief An update of a filter whose input is a cloud: what all of them do with it.
 */
#ifndef CloudRun_h
#define CloudRun_h

#include "FilterRun.h"
#include "PreparedCloud.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace sbvtk
{

class CloudRun : public FilterRun
{
protected:
  /** @param kept from the last update, and for the next */
  CloudRun(vtkAlgorithm* filter, vtkDataObject* cloud, PreparedCloud& kept,
    const std::vector<vtkDataObject*>& outputs);

  static void CheckDefinition(int definition);

  /** Refuse a length that is negative or not finite. */
  static void CheckLength(const char* name, double length);

  void ReadCloud();

  /** Make its surface, which takes that part of the filter's progress. */
  void PrepareCloud(const PreparedCloud::Settings& settings, double first, double last);

  /** The field data that all these filters have. */
  void AddCloudFields(vtkDataObject* output, int status, const std::string& message) const;

  vtkDataObject* CloudData;
  PreparedCloud& Kept;
  const CloudInput& Input;
  const sb::CloudSurface& Cloud;
};

} // namespace sbvtk

#endif
