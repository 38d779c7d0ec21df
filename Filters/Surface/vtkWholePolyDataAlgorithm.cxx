// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWholePolyDataAlgorithm.h"

#include "FieldArrays.h"
#include "RankGathering.h"

#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <new>

namespace
{

/** The Status of this name in all filters. */
constexpr int OUT_OF_MEMORY = 22;

void Empty(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

/** As the pipeline does with the piece of this process. */
void PassFieldData(vtkDataObject* first, vtkInformationVector* outputs)
{
  for (int port = 0; first && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->GetFieldData()->PassData(first->GetFieldData());
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkWholePolyDataAlgorithm::vtkWholePolyDataAlgorithm()
  : Ranks(new sbvtk::RankGathering)
{
}

//------------------------------------------------------------------------------
vtkWholePolyDataAlgorithm::~vtkWholePolyDataAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkWholePolyDataAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->GetController())
  {
    this->Ranks->SetController(controller);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkWholePolyDataAlgorithm::GetController()
{
  return this->Ranks->GetController();
}

//------------------------------------------------------------------------------
/** Without this the pipeline would run a reader in the first process alone, where it would wait for
 * the others. */
int vtkWholePolyDataAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkWholePolyDataAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  this->Ranks->RequestPieces(inputs, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
int vtkWholePolyDataAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int asked = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  if (this->Ranks->IsParallel())
  {
    if (this->Ranks->IsNews(this, outputs->GetInformationObject(asked)))
    {
      this->ComputeOnFirst(inputs, outputs);
      this->Ranks->Keep(outputs);
    }
    else // the answer is that of the last time, whatever piece is asked for
    {
      this->Ranks->Restore(outputs);
    }
  }
  else if (outputs->GetInformationObject(asked)->Get(Pipeline::UPDATE_PIECE_NUMBER()) == 0)
  {
    this->ComputeWhole(inputs, outputs);
  }
  // else: who streams piece by piece gets all in the first one
  // A run that was stopped says so in its field data, which the pipeline would clear.
  this->SetAbortOutput(false);
  return 1;
}

//------------------------------------------------------------------------------
void vtkWholePolyDataAlgorithm::ComputeOnFirst(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  try
  {
    sbvtk::WholeInputs whole = this->Ranks->Gather(inputs, this->GetNumberOfInputPorts());
    std::exception_ptr failure;
    Empty(outputs);
    if (this->Ranks->IsFirst())
    {
      try
      {
        if (this->GetNumberOfInputPorts() > 0)
        {
          PassFieldData(vtkDataObject::GetData(whole.Ports()[0], 0), outputs);
        }
        this->ComputeWhole(whole.Ports(), outputs);
      }
      catch (...)
      {
        failure = std::current_exception();
        Empty(outputs);
      }
    }
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      this->Ranks->ShareArrays(vtkPolyData::GetData(outputs, port));
    }
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }
  catch (const std::bad_alloc&)
  {
    const std::string sentence =
      "The pieces of the inputs do not fit into the memory of one of the server's processes, of "
      "which the first has to hold all; decimate the inputs first, or give it more memory.";
    Empty(outputs);
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      sbvtk::AddField(vtkDataObject::GetData(outputs, port), "Status", OUT_OF_MEMORY);
      sbvtk::AddField(vtkDataObject::GetData(outputs, port), "Message", sentence);
    }
    if (this->Ranks->IsFirst())
    {
      vtkErrorMacro(<< sentence);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWholePolyDataAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->GetController() << "\n";
}
