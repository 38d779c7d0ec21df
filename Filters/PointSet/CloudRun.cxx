// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudRun.h"

#include "CloudSentences.h"
#include "FieldArrays.h"
#include "vtkPointSetSurfaceFilter.h"

#include <cmath>

namespace sbvtk
{

using CloudFilter = vtkPointSetSurfaceFilter;

CloudRun::CloudRun(vtkAlgorithm* filter, vtkDataObject* cloud, PreparedCloud& kept,
  const std::vector<vtkDataObject*>& outputs)
  : FilterRun(filter, outputs)
  , CloudData(cloud)
  , Kept(kept)
  , Input(kept.Input())
  , Cloud(kept.Surface())
{
}

void CloudRun::CheckDefinition(int definition)
{
  if (definition != 0 && definition != 1)
  {
    throw Failure{ CloudFilter::BAD_REQUEST,
      "Definition is " + std::to_string(definition) +
        "; set it to 0 (Unbiased) or 1 (Amenta-Kil)." };
  }
}

void CloudRun::CheckLength(const char* name, double length)
{
  if (!std::isfinite(length) || length < 0.0)
  {
    throw Failure{ CloudFilter::BAD_REQUEST,
      std::string(name) + " is " + Text(length) + "; set it to 0 or a positive length." };
  }
}

void CloudRun::ReadCloud()
{
  const std::string refusal = this->Kept.Read(this->CloudData);
  if (!refusal.empty())
  {
    throw Failure{ CloudFilter::NOT_POINTS, "Input " + refusal };
  }
  if (!this->Input.Warning().empty())
  {
    this->Warn(CloudFilter::BAD_NORMALS, this->Input.Warning());
  }
}

void CloudRun::PrepareCloud(const PreparedCloud::Settings& settings, double first, double last)
{
  KernelMonitor monitor(this->Owner, first, last);
  this->Kept.Prepare(settings, this->Executor, monitor);
  const int status = StatusOf(this->Cloud.Status);
  if (status != CloudFilter::OK)
  {
    throw Failure{ status, RefusalOf(this->Cloud, this->Input.NumberOfPoints()) };
  }
}

void CloudRun::AddCloudFields(vtkDataObject* output, int status, const std::string& message) const
{
  AddField(output, "Status", status);
  AddField(output, "Message", message);
  AddField(output, "Spacing", this->Cloud.Spacing);
  AddField(output, "Width", this->Cloud.Surface ? this->Cloud.Surface->Width() : 0.0);
}

} // namespace sbvtk
