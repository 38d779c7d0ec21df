// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSetBooleanFilter.h"

#include "CloudBoolean.h"
#include "CloudBooleanOutputs.h"
#include "CloudRun.h"
#include "CloudSentences.h"
#include "ConditionSentences.h"
#include "DesignedInput.h"
#include "FieldArrays.h"
#include "NURBSArrays.h"
#include "PointSurfaceMesh.h"
#include "TimeSteps.h"
#include "vtkPointSetSurfaceFilter.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkPointSetBooleanFilter);

namespace
{

constexpr double LargestShareOfDoubtful = 0.2;
constexpr double LargestShareOfTangent = 0.3; ///< of the seam, where it is called coincident

} // namespace

struct vtkPointSetBooleanFilter::Cache
{
  sbvtk::PreparedCloud Cloud;
  sbvtk::DesignedInput Tool;
};

/** One update: its steps in their order, and what they share. */
class vtkPointSetBooleanFilter::Run : public sbvtk::CloudRun
{
public:
  Run(vtkPointSetBooleanFilter* filter, vtkInformationVector** inputs,
    const sbvtk::CloudBooleanOutputs& outputs)
    : CloudRun(filter, vtkDataObject::GetData(inputs[0], 0), filter->Kept->Cloud,
        { outputs.Surface, outputs.Points, outputs.Curves })
    , Filter(filter)
    , ToolData(vtkDataObject::GetData(inputs[1], 0))
    , Tool(filter->Kept->Tool)
    , Outputs(outputs)
    , Surface(outputs.Surface)
  {
  }

private:
  void TakeSteps() override;
  void CheckSettings() const;
  void ReadTool();
  void JudgeNormals();
  void Compute();
  void RefuseResult() const;
  std::string ToolSentence() const;
  void Judge();
  void JudgeOverlap();
  void JudgeScan();
  void AddFields(int status, const std::string& message) override;
  std::string AdviceOnMemory() const override { return "choose a larger CellSize or fewer points"; }

  vtkPointSetBooleanFilter* Filter;
  vtkDataObject* ToolData;
  sbvtk::DesignedInput& Tool;
  sbvtk::CloudBooleanOutputs Outputs;
  vtkPolyData* Surface;
  sb::CloudBooleanResult Result;
  double CellSize = 0.0;
};

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::TakeSteps()
{
  this->CheckSettings();
  this->ReadCloud();
  this->ReadTool();
  this->Times.push_back({ "Read inputs", this->Watch.Lap() });
  this->PrepareCloud({ 0, this->Filter->Width, this->Filter->FlipNormals != 0 }, 0.02, 0.3);
  this->JudgeNormals();
  this->Times.push_back({ "Prepare cloud", this->Watch.Lap() });
  this->Compute();
  this->Judge();
  const sbvtk::CloudBooleanParts parts{ this->Cloud, this->Input, this->Tool, this->Result };
  for (const std::string& sentence : sbvtk::BuildCloudBoolean(parts, this->Outputs, this->Executor))
  {
    vtkWarningWithObjectMacro(this->Filter, << sentence);
  }
  this->Times.push_back({ "Build outputs", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::CheckSettings() const
{
  const int operation = this->Filter->Operation;
  if (operation < UNION || operation > REVERSE_DIFFERENCE)
  {
    throw Failure{ BAD_REQUEST,
      "Operation is " + std::to_string(operation) +
        "; set it to 0 (Union), 1 (Intersection), 2 (Difference) or 3 (Reverse Difference)." };
  }
  CheckLength("Width", this->Filter->Width);
  CheckLength("CellSize", this->Filter->CellSize);
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::ReadTool()
{
  if (!this->ToolData)
  {
    throw Failure{ NOT_A_SURFACE,
      "There is no Tool; set it to the designed body (in ParaView: right-click the filter in the "
      "Pipeline Browser, Change Input)." };
  }
  const std::string notSurface = this->Tool.Read(this->ToolData, this->Executor);
  if (!notSurface.empty())
  {
    throw Failure{ NOT_A_SURFACE, "Tool " + notSurface };
  }
  if (this->Tool.Surface().Triangles.empty())
  {
    throw Failure{ NOT_A_SURFACE,
      "Tool has no polygon, so it is no body; choose a closed surface as Tool and the scanned "
      "points as Input." };
  }
  if (!this->Tool.Warning().empty())
  {
    this->Warn(INEXACT_TOOL, "Tool " + this->Tool.Warning());
  }
  if (this->Tool.WasInsideOut())
  {
    this->Warn(TOOL_TURNED,
      "Tool has its normals inwards (its volume is negative), so it was turned over; apply Reverse "
      "Sense to it to silence this.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::JudgeNormals()
{
  const auto doubtful =
    std::count(this->Cloud.Doubtful.begin(), this->Cloud.Doubtful.end(), std::uint8_t(1));
  const double share = static_cast<double>(doubtful) /
    static_cast<double>(std::max<std::int64_t>(1, this->Input.NumberOfPoints()));
  if (share > LargestShareOfDoubtful)
  {
    throw Failure{ DOUBTFUL_NORMALS,
      sbvtk::PercentOf(share) +
        " of the normals that were estimated for Input may be wrong, which is too much to know "
        "its inside; give it normals that point outwards, or more points where it is thin or "
        "sharp." };
  }
  if (!this->Cloud.Estimated && this->Cloud.NumberWithoutNormal > 0)
  {
    this->Warn(BAD_NORMALS,
      std::to_string(this->Cloud.NumberWithoutNormal) +
        " points of Input have a normal that is zero or not finite, and were left out; give them "
        "one, or remove all normals to have them estimated.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::Compute()
{
  static_assert(static_cast<int>(sb::CloudOperation::ReverseDifference) == REVERSE_DIFFERENCE &&
      static_cast<int>(sb::CloudOperation::Difference) == DIFFERENCE &&
      static_cast<int>(sb::CloudOperation::Intersection) == INTERSECTION,
    "the kernel's numbers of the operations are the filter's");
  sb::CloudBooleanRequest request;
  request.Cloud = &this->Cloud;
  request.Tool = &this->Tool.Surface();
  request.Op = static_cast<sb::CloudOperation>(this->Filter->Operation);
  request.Cell = this->CellSize = this->Filter->CellSize > 0.0
    ? this->Filter->CellSize
    : sb::CellSizeFor(*this->Cloud.Surface, this->Cloud.Spacing);
  request.CloudMesh = this->Kept.Mesh(this->CellSize);
  request.WithNearestSamples = this->Input.Data()->GetPointData()->GetNumberOfArrays() > 0;
  sbvtk::KernelMonitor monitor(this->Filter, 0.3, 0.95);
  this->Result = sb::ComputeCloudBoolean(request, this->Executor, monitor);
  this->Times.insert(this->Times.end(), this->Result.Times.begin(), this->Result.Times.end());
  this->RefuseResult();
  this->Kept.KeepMesh(this->CellSize, this->Result.CloudMesh);
  this->Watch.Lap();
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::RefuseResult() const
{
  switch (this->Result.Status)
  {
    case sb::CloudBooleanStatus::Ok:
      return;
    case sb::CloudBooleanStatus::OpenTool:
      throw Failure{ OPEN_TOOL, this->ToolSentence() };
    case sb::CloudBooleanStatus::BadTool:
      throw Failure{ BAD_TOOL, this->ToolSentence() };
    case sb::CloudBooleanStatus::NoSurface:
      throw Failure{ NO_SURFACE,
        "The points of Input do not define a surface (they are too few, or too far from one "
        "another, within Width); choose a larger Width, or look at Input with Point Set Surface." };
    case sb::CloudBooleanStatus::InsideOut:
      throw Failure{ INSIDE_OUT,
        "The normals of Input do not point outwards everywhere, so its inside is outside; switch "
        "on Flip Normals, or orient the normals of all parts outwards." };
    case sb::CloudBooleanStatus::TooFine:
      throw Failure{ TOO_FINE,
        "The meshes would have too many triangles at a CellSize of " + sbvtk::Text(this->CellSize) +
          "; choose a larger one." };
    case sb::CloudBooleanStatus::TooLarge:
      throw Failure{ TOO_LARGE, "The result would have more than 2147483647 points; divide it." };
    case sb::CloudBooleanStatus::Aborted:
      throw sbvtk::Stopped();
  }
}

//------------------------------------------------------------------------------
std::string vtkPointSetBooleanFilter::Run::ToolSentence() const
{
  for (sb::Remark remark : this->Result.ToolRemarks)
  {
    const std::int64_t cell =
      remark.Triangle >= 0 ? this->Tool.CellOfTriangle(remark.Triangle) : -1;
    if (sb::IsError(remark.Condition))
    {
      return sbvtk::ConditionSentence(remark, "Tool", cell);
    }
    if (remark.Condition == sb::Status::OpenOperand)
    {
      const std::string where = cell >= 0 ? " at cell " + std::to_string(cell) : "";
      return "Tool is not closed" + where +
        ", so it is no solid; fill its holes, or choose a closed surface.";
    }
  }
  return "Tool cannot be combined with the cloud; look at it with Surface Boolean.";
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::Judge()
{
  this->JudgeOverlap();
  this->JudgeScan();
  if (this->Result.TangentShare > LargestShareOfTangent)
  {
    this->Warn(COINCIDENT,
      "Along " + sbvtk::PercentOf(this->Result.TangentShare) +
        " of the seam the cloud and Tool run nearly in one surface, where noise decides which of "
        "them is in front; move Tool by more than " +
        sbvtk::Text(2.0 * this->Result.Errors.Sum()) +
        ", or cut with a body that crosses the cloud.");
  }
  const sb::ErrorBudget& errors = this->Result.Errors;
  if (this->Result.NumberOfBackedOff > 0 && errors.Seam > errors.Sum() - errors.Seam)
  {
    this->Warn(SEAM_NOT_SNAPPED,
      std::to_string(this->Result.NumberOfBackedOff) + " of " +
        std::to_string(this->Result.NumberOfBackedOff + this->Result.NumberOfSnapped) +
        " seam points could not be moved onto both surfaces without turning a triangle over, and "
        "are off by up to " +
        sbvtk::Text(errors.Seam) +
        " (Residual), more than all else in ErrorBudget; choose a smaller CellSize.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::JudgeOverlap()
{
  if (!this->Result.Seam.Curves.empty())
  {
    return;
  }
  if (this->Result.Mesh.Triangles.empty())
  {
    this->Warn(NO_OVERLAP,
      "The surfaces of the cloud and Tool do not meet, and nothing is left by this operation; move "
      "Tool, or choose another Operation.");
    return;
  }
  this->Warn(NO_OVERLAP,
    "The surfaces of the cloud and Tool do not meet, so the result is whole surfaces of one or "
    "both; move Tool if they should.");
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::JudgeScan()
{
  if (!this->Result.ScanIsOpen)
  {
    return;
  }
  const std::string sure = " (smallest Confidence " + sbvtk::Text(this->Result.Confidence) + ")";
  if (this->Result.Seam.NumberOfEnds > 0)
  {
    this->Warn(OPEN_SEAM,
      "The border of the scan crosses Tool: the seam has " +
        std::to_string(this->Result.Seam.NumberOfEnds) + " ends, and the result is open there" +
        sure + "; scan more of the object, or move Tool to where the scan is complete.");
  }
  else
  {
    this->Warn(OPEN_SCAN,
      "The scan is open, so what is inside of it was judged by its points" + sure +
        ", and the result is open where the scan is; scan the missing part, or choose a larger "
        "Width if the holes are small.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::Run::AddFields(int status, const std::string& message)
{
  if (this->CloudData)
  {
    this->Surface->GetFieldData()->PassData(this->CloudData->GetFieldData());
  }
  const auto addDouble = [this](const char* name, double value) {
    sbvtk::AddField(this->Surface, name, value);
  };
  const auto addCount = [this](const char* name, std::int64_t value) {
    sbvtk::AddCount(this->Surface, name, value);
  };
  const sb::CloudBooleanResult& result = this->Result;
  this->AddCloudFields(this->Surface, status, message);
  addDouble("CellSize", this->CellSize);
  addDouble("NoiseError", result.Errors.Noise);
  addDouble("FacetError", result.Errors.Facet);
  addDouble("SeamChordError", result.Errors.Chord);
  addDouble("ToolError", result.Errors.Tool);
  addDouble("ErrorBudget", result.Errors.Sum());
  addDouble("SeamResidual", result.LargestResidual);
  addCount("NumberOfSnappedPoints", result.NumberOfSnapped);
  addCount("NumberOfBackedOffPoints", result.NumberOfBackedOff);
  addCount("NumberOfFlippedTriangles", result.NumberOfFlipped);
  addCount("NumberOfSelfIntersections", result.NumberOfCrossings);
  addCount("NumberOfBorderEdges", result.NumberOfBorderEdges);
  addCount("NumberOfSeamEnds", result.Seam.NumberOfEnds);
  addCount("NumberOfSpecks", result.NumberOfSpecks);
  addDouble("Confidence", result.Confidence);
  addDouble("CloudVolume", result.CloudVolume);
  addDouble("ToolVolume", result.ToolVolume);
  addDouble("ResultVolume", result.Volume);
  addDouble("ResultArea", result.Area);
  sbvtk::AddStageFields(this->Surface, this->Times);
  if (!result.FaceId.empty()) // an empty array would hide all field data in the window
  {
    sbvtk::AttachPatches(this->Surface, this->Tool.Surface().Patches);
  }
}

//------------------------------------------------------------------------------
vtkPointSetBooleanFilter::vtkPointSetBooleanFilter()
  : Kept(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkPointSetBooleanFilter::~vtkPointSetBooleanFilter() = default;

//------------------------------------------------------------------------------
int vtkPointSetBooleanFilter::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object, and optional: others get a sentence of ours instead of the pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPointSetBooleanFilter::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::UniteTimeSteps(inputs, this->GetNumberOfInputPorts(), outputs);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const sbvtk::CloudBooleanOutputs filled{ vtkPolyData::GetData(outputs, 0),
    vtkPolyData::GetData(outputs, 1), vtkPolyData::GetData(outputs, 2) };
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, inputs, filled).Execute(); });
}

//------------------------------------------------------------------------------
void vtkPointSetBooleanFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operation: " << this->Operation << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "FlipNormals: " << this->FlipNormals << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
