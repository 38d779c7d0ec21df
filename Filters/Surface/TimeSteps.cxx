// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeSteps.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <set>
#include <vector>

namespace sbvtk
{

void UniteTimeSteps(vtkInformationVector** inputs, int numberOfPorts, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::set<double> steps;
  std::vector<double> bounds;
  for (int port = 0; port < numberOfPorts; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      if (input->Has(Pipeline::TIME_STEPS()))
      {
        const double* own = input->Get(Pipeline::TIME_STEPS());
        steps.insert(own, own + input->Length(Pipeline::TIME_STEPS()));
      }
      if (input->Has(Pipeline::TIME_RANGE()))
      {
        const double* own = input->Get(Pipeline::TIME_RANGE());
        bounds.insert(bounds.end(), own, own + 2);
      }
    }
  }
  bounds.insert(bounds.end(), steps.begin(), steps.end());
  if (bounds.empty())
  {
    return;
  }
  const std::vector<double> allSteps(steps.begin(), steps.end());
  const auto ends = std::minmax_element(bounds.begin(), bounds.end());
  const double range[2] = { *ends.first, *ends.second };
  for (int i = 0; i < outputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* output = outputs->GetInformationObject(i);
    output->Set(Pipeline::TIME_RANGE(), range, 2);
    if (!allSteps.empty())
    {
      output->Set(Pipeline::TIME_STEPS(), allSteps.data(), static_cast<int>(allSteps.size()));
    }
  }
}

} // namespace sbvtk
