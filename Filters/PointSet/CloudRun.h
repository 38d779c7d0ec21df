// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudRun.h
 * @brief An update of a filter whose input is a cloud: what all of them do with it.
 */
#ifndef CloudRun_h
#define CloudRun_h

#include "CloudInput.h"
#include "CloudSurface.h"
#include "FilterRun.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace sbvtk
{

class CloudRun : public FilterRun
{
protected:
  struct Settings
  {
    int Definition = 0;
    double Width = 0.0;
    bool FlipNormals = false;
  };

  CloudRun(vtkAlgorithm* filter, vtkDataObject* cloud, const std::vector<vtkDataObject*>& outputs);

  static void CheckDefinition(int definition);

  /** Refuse a length that is negative or not finite. */
  static void CheckLength(const char* name, double length);

  void ReadCloud();

  /** Make its surface, which takes that part of the filter's progress. */
  void PrepareCloud(const Settings& settings, double first, double last);

  /** The field data that all these filters have. */
  void AddCloudFields(vtkDataObject* output, int status, const std::string& message) const;

  vtkDataObject* CloudData;
  CloudInput Input;
  sb::CloudSurface Cloud;
};

} // namespace sbvtk

#endif
