// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"

#include "ArrayRanges.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <new>

namespace sbvtk
{
namespace
{

// The same in the StatusType of every filter.
constexpr int Ok = 0;
constexpr int Aborted = 9;
constexpr int OutOfMemory = 22;

} // namespace

void RunSteps(
  vtkAlgorithm* filter, const std::function<void()>& steps, const UpdateEndings& endings)
{
  FilterFailure failure{ Ok, "" };
  try
  {
    steps();
    StopIfAsked(filter);
    KeepRangesOfOutputs(filter);
    return;
  }
  catch (const FilterFailure& thrown)
  {
    failure = thrown;
  }
  catch (const Stopped&)
  {
    failure = endings.IfStopped;
  }
  catch (const std::bad_alloc&)
  {
    failure = endings.IfOutOfMemory;
  }
  endings.Report(failure);
  if (failure.Status != Aborted)
  {
    vtkErrorWithObjectMacro(filter, << failure.Sentence);
  }
}

FilterRun::FilterRun(vtkAlgorithm* filter, const std::vector<vtkDataObject*>& outputs)
  : Owner(filter)
  , Outputs(outputs)
{
}

FilterRun::~FilterRun() = default;

void FilterRun::Execute()
{
  const auto steps = [this] {
    this->TakeSteps();
    this->AddFields(this->Status, this->Message);
  };
  const auto report = [this](const Failure& failure) {
    for (vtkDataObject* output : this->Outputs)
    {
      output->Initialize();
    }
    this->AddFields(failure.Status, failure.Sentence);
  };
  RunSteps(this->Owner, steps,
    { report, { Aborted, "The filter was stopped." },
      { OutOfMemory, "The result does not fit into memory; " + this->AdviceOnMemory() + "." } });
}

void FilterRun::Warn(int status, const std::string& sentence)
{
  vtkWarningWithObjectMacro(this->Owner, << sentence);
  if (this->Status == Ok)
  {
    this->Status = status;
    this->Message = sentence;
  }
}

} // namespace sbvtk
