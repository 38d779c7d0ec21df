// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNURBSWriter.h"

#include "CADFile.h"
#include "CADSession.h"
#include "DesignedInput.h"
#include "KernelExecutor.h"
#include "TrimmedFaces.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkNURBSWriter);

//------------------------------------------------------------------------------
vtkNURBSWriter::vtkNURBSWriter() = default;

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
void vtkNURBSWriter::WriteData()
{
  this->NumberOfFaces = this->NumberOfSolids = this->NumberOfOpenShells = 0;
  if (!this->FileName || !*this->FileName)
  {
    this->Refuse(vtkErrorCode::NoFileNameError, "There is no file to write; set FileName.");
    return;
  }
  sbvtk::KernelExecutor executor;
  sbvtk::DesignedInput input;
  const std::string refusal =
    input.Read(this->GetInput(), executor, sbvtk::DesignedInput::Patchless::Keep);
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
      failure = faces.Shape.IsNull()
        ? "would have no faces; there are no facets on exact surfaces in Input."
        : sbvtk::WriteSTEPFile(this->FileName, faces.Shape, progress);
    });
  if (outcome.Status == sbvtk::CADStatus::Aborted)
  {
    return;
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
