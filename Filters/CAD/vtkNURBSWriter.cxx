// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNURBSWriter.h"

#include "CADFile.h"
#include "CADSession.h"
#include "DesignedInput.h"
#include "KernelExecutor.h"
#include "RankGathering.h"
#include "TrimmedFaces.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>
#include <string>

vtkStandardNewMacro(vtkNURBSWriter);

namespace
{

/** What is said of patches that are left out; nothing if none is. */
std::string LeftOut(const sbvtk::TrimmedFaces& faces)
{
  return faces.NumberOfUnfitPatches == 0
    ? std::string()
    : "Input has " + std::to_string(faces.NumberOfUnfitPatches) +
      " exact surfaces whose facets do not fit together in u and v, which are left out; choose the "
      "surface as it came from the file or from a Boolean.";
}

/** What is said of a file without faces. */
std::string NoFaces(const sbvtk::TrimmedFaces& faces)
{
  const std::string leftOut = LeftOut(faces);
  return "would have no faces; " +
    (leftOut.empty() ? "there are no facets on exact surfaces in Input." : leftOut);
}

} // namespace

//------------------------------------------------------------------------------
vtkNURBSWriter::vtkNURBSWriter()
  : Ranks(new sbvtk::RankGathering)
{
}

//------------------------------------------------------------------------------
vtkNURBSWriter::~vtkNURBSWriter() { delete[] this->FileName; }

//------------------------------------------------------------------------------
int vtkNURBSWriter::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object: others get a sentence of ours instead of the pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
void vtkNURBSWriter::Refuse(unsigned long error, const std::string& sentence)
{
  this->SetErrorCode(error);
  vtkErrorMacro(<< sentence);
}

//------------------------------------------------------------------------------
void vtkNURBSWriter::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->GetController())
  {
    this->Ranks->SetController(controller);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkNURBSWriter::GetController() { return this->Ranks->GetController(); }

//------------------------------------------------------------------------------
vtkTypeBool vtkNURBSWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    this->Ranks->RequestPieces(inputs, this->GetNumberOfInputPorts());
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkNURBSWriter::WriteData()
{
  this->NumberOfFaces = this->NumberOfSolids = this->NumberOfOpenShells = 0;
  try
  {
    const vtkSmartPointer<vtkDataObject> whole =
      this->Ranks->Gather(this->GetInput(), 0, 0, sbvtk::RankGathering::Receiver::First);
    if (this->Ranks->IsFirst())
    {
      this->WriteWhole(whole);
    }
  }
  catch (const std::bad_alloc&)
  {
    this->Refuse(
      vtkErrorCode::UserError, "The facets do not fit into memory; write fewer at a time.");
  }
}

//------------------------------------------------------------------------------
void vtkNURBSWriter::WriteWhole(vtkDataObject* data)
{
  if (!this->FileName || !*this->FileName)
  {
    this->Refuse(vtkErrorCode::NoFileNameError, "There is no file to write; set FileName.");
    return;
  }
  sbvtk::KernelExecutor executor;
  sbvtk::DesignedInput input;
  const std::string refusal = input.Read(data, executor, sbvtk::DesignedInput::Patchless::Keep);
  if (!refusal.empty())
  {
    this->Refuse(vtkErrorCode::UserError, "Input " + refusal);
    return;
  }
  const sb::DesignedSurface& surface = input.Surface();
  if (!surface.HasPatches())
  {
    const std::string reason = input.Warning().empty()
      ? "carries no exact surfaces; only what was read from a CAD file can be written as STEP."
      : input.Warning();
    this->Refuse(vtkErrorCode::UserError, "Input " + reason);
    return;
  }
  sbvtk::TrimmedFaces faces;
  std::string failure;
  sbvtk::KernelMonitor monitor(this, 0.0, 1.0);
  const sbvtk::CADOutcome outcome =
    sbvtk::RunCAD(monitor, 0.0, 1.0, "Write file", [&](const Message_ProgressRange& progress) {
      faces = sbvtk::MakeTrimmedFaces(surface);
      failure = faces.Shape.IsNull() ? NoFaces(faces)
                                     : sbvtk::WriteSTEPFile(this->FileName, faces.Shape, progress);
    });
  if (outcome.Status == sbvtk::CADStatus::Aborted)
  {
    return;
  }
  if (outcome.Status == sbvtk::CADStatus::OutOfMemory)
  {
    throw std::bad_alloc();
  }
  if (outcome.Status != sbvtk::CADStatus::Ok)
  {
    failure = "could not be written, for Open CASCADE gave up on it (" + outcome.Reason +
      "); try facets read with another ChordError.";
  }
  if (!failure.empty())
  {
    this->Refuse(
      vtkErrorCode::CannotOpenFileError, std::string("The file ") + this->FileName + " " + failure);
    return;
  }
  this->NumberOfFaces = static_cast<int>(faces.NumberOfFaces);
  this->NumberOfSolids = static_cast<int>(faces.NumberOfSolids);
  this->NumberOfOpenShells = static_cast<int>(faces.NumberOfOpenShells);
  if (const std::string leftOut = LeftOut(faces); !leftOut.empty())
  {
    vtkWarningMacro(<< leftOut);
  }
  const auto without = std::count_if(
    surface.FaceId.begin(), surface.FaceId.end(), [](std::int32_t face) { return face < 0; });
  if (without > 0)
  {
    vtkWarningMacro(<< "Input has " << without
                    << " facets that are on no exact surface, which are left out; what they close "
                       "is open in the file.");
  }
}

//------------------------------------------------------------------------------
void vtkNURBSWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "NumberOfFaces: " << this->NumberOfFaces << "\n";
  os << indent << "NumberOfSolids: " << this->NumberOfSolids << "\n";
  os << indent << "NumberOfOpenShells: " << this->NumberOfOpenShells << "\n";
}
