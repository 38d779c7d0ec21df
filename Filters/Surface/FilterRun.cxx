// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"

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

FilterRun::FilterRun(vtkAlgorithm* filter, const std::vector<vtkDataObject*>& outputs)
  : Owner(filter)
  , Outputs(outputs)
{
}

FilterRun::~FilterRun() = default;

void FilterRun::Execute()
{
  try
  {
    this->TakeSteps();
    this->AddFields(this->Status, this->Message);
    StopIfAsked(this->Owner);
  }
  catch (const Failure& failure)
  {
    this->Fail(failure);
  }
  catch (const Stopped&)
  {
    this->Fail({ Aborted, "The filter was stopped." });
  }
  catch (const std::bad_alloc&)
  {
    this->Fail(
      { OutOfMemory, "The result does not fit into memory; " + this->AdviceOnMemory() + "." });
  }
}

void FilterRun::Fail(const Failure& failure)
{
  for (vtkDataObject* output : this->Outputs)
  {
    output->Initialize();
  }
  this->AddFields(failure.Status, failure.Sentence);
  if (failure.Status != Aborted)
  {
    vtkErrorWithObjectMacro(this->Owner, << failure.Sentence);
  }
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
