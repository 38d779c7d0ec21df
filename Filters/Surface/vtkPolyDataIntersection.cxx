// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataIntersection.h"

#include "ArrayMemory.h"
#include "AttributeUnion.h"
#include "BlockNames.h"
#include "FieldArrays.h"
#include "FilterRun.h"
#include "Intersection.h"
#include "KernelExecutor.h"
#include "ResultCurves.h"
#include "ResultSurface.h"
#include "Stopwatch.h"
#include "SurfaceConnections.h"
#include "TimeSteps.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPolyDataIntersection);

struct vtkPolyDataIntersection::Cache
{
  sbvtk::SurfaceConnections Connections;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataIntersection::Run
{
public:
  Run(vtkPolyDataIntersection* filter, vtkInformationVector** inputs, vtkInformationVector* outputs)
    : Filter(filter)
    , Inputs(inputs)
    , Curves(vtkPolyData::GetData(outputs, 0))
    , Splits{ vtkPolyData::GetData(outputs, 1), vtkPolyData::GetData(outputs, 2) }
    , Connections(filter->Inputs->Connections)
  {
  }

  void Execute();

private:
  using Failure = sbvtk::FilterFailure;

  void CheckSettings() const;
  void ReadInputs();
  void Compute();
  void Report();
  void BuildCurves();
  void BuildSplit(std::size_t operand);
  void CarryAttributes(
    std::size_t operand, bool ofPoints, const sbvtk::TupleSources& from, vtkPolyData* output);
  void AddCurveArrays();
  void AddSplitArrays(
    const sb::SplitSurface& split, const sbvtk::ResultSurface& result, vtkPolyData* output);
  void AddFields(int status, const std::string& message);

  vtkPolyDataIntersection* Filter;
  vtkInformationVector** Inputs;
  vtkPolyData* Curves;
  vtkPolyData* Splits[2];
  sbvtk::SurfaceConnections& Connections;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  std::vector<std::shared_ptr<sbvtk::OperandSurface>> Operands;
  std::vector<sb::StageTime> Times;
  sb::IntersectionResult Result;
  bool SinglePrecision = false;
};

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::Execute()
{
  const auto steps = [this] {
    this->CheckSettings();
    this->ReadInputs();
    this->Compute();
    this->Report();
    this->BuildCurves();
    for (std::size_t operand = 0; operand < this->Operands.size(); ++operand)
    {
      if (!this->Result.Surfaces[operand].Fates.empty())
      {
        this->BuildSplit(operand);
      }
    }
    this->Times.push_back({ "Build outputs", this->Watch.Lap() });
    const bool none = this->Result.Intersection.Segments.empty();
    const bool self = this->Operands.size() == 1;
    this->AddFields(none ? static_cast<int>(NO_CURVE) : static_cast<int>(this->Result.Condition),
      none ? (self ? "The surface does not meet itself, so there is no curve."
                   : "The surfaces do not meet, so there is no curve.")
           : "The result is complete.");
  };
  const auto report = [this](const sbvtk::FilterFailure& failure) {
    this->Curves->Initialize();
    this->Splits[0]->Initialize();
    this->Splits[1]->Initialize();
    this->AddFields(failure.Status, failure.Sentence);
  };
  sbvtk::RunSteps(this->Filter, steps,
    { report, sbvtk::FailureOf(sb::Status::Aborted),
      { OUT_OF_MEMORY,
        "The result does not fit into memory; decimate the inputs or close other data first." } });
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::CheckSettings() const
{
  const int badRequest = static_cast<int>(sb::Status::BadRequest);
  if (!std::isfinite(this->Filter->Tolerance) || this->Filter->Tolerance < 0.0)
  {
    throw Failure{ badRequest,
      "Tolerance is " + std::to_string(this->Filter->Tolerance) +
        "; set it to 0 or a small positive length." };
  }
  if (this->Inputs[0]->GetNumberOfInformationObjects() == 0)
  {
    throw Failure{ badRequest,
      "Input has no surface; set Input (in ParaView: right-click the filter in the Pipeline "
      "Browser, Change Input)." };
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::ReadInputs()
{
  sbvtk::MatchConnections(this->Connections, this->Inputs);
  sbvtk::ReadConnections(
    this->Connections, this->Inputs, NOT_A_SURFACE, this->Filter->Tolerance, this->Executor);
  this->Operands = sbvtk::SurfacesOf(this->Connections);
  // The same everywhere, so that what meets in one output meets in the others.
  this->SinglePrecision = sbvtk::HaveFloatPoints(this->Connections);
  this->Times.push_back({ "Read inputs", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::Compute()
{
  sb::IntersectionRequest request;
  for (const sbvtk::SurfaceConnection& connection : this->Connections)
  {
    request.Operands.push_back({ connection.Surface->Mesh(), connection.Side,
      connection.Surface->Examination(this->Executor, sb::OpenSurfaces::Accept) });
    request.Split.push_back(connection.Side == sb::Group::Input
        ? this->Filter->SplitFirstOutput != 0
        : this->Filter->SplitSecondOutput != 0);
  }
  const double secondsOfExaminations = this->Watch.Lap();
  sbvtk::KernelMonitor monitor(this->Filter, 0.05, 0.9);
  this->Result = sb::ComputeIntersection(request, this->Executor, monitor);
  sbvtk::AppendTimes(this->Result.Times, secondsOfExaminations, this->Times);
  this->Watch.Lap();
}

//------------------------------------------------------------------------------
/** Say what the kernel remarked; a grave remark ends the update. */
void vtkPolyDataIntersection::Run::Report()
{
  for (const sb::Remark& remark : this->Result.Remarks)
  {
    const std::string sentence = sbvtk::RemarkSentence(remark, this->Connections);
    if (sb::IsError(remark.Condition))
    {
      throw Failure{ static_cast<int>(remark.Condition), sentence };
    }
    vtkWarningWithObjectMacro(this->Filter, << sentence);
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::BuildCurves()
{
  sbvtk::CopyCurves(this->Result.Intersection, this->SinglePrecision, this->Curves);
  this->AddCurveArrays();
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::AddCurveArrays()
{
  const sb::Curves& curves = this->Result.Intersection;
  const vtkIdType numberOfCurves = this->Curves->GetNumberOfCells();
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkIntArray> sources;
  ids->SetName("CurveId");
  sbvtk::SetTuples(ids, numberOfCurves);
  sources->SetName("SourceIds");
  sources->SetNumberOfComponents(2);
  sbvtk::SetTuples(sources, numberOfCurves);
  for (vtkIdType curve = 0; curve < numberOfCurves; ++curve)
  {
    ids->SetValue(curve, static_cast<int>(curve));
    // A polyline of n points has n - 1 segments.
    const auto& makers = curves.Segments[static_cast<std::size_t>(
      curves.Offsets[static_cast<std::size_t>(curve)] - curve)];
    sources->SetTypedComponent(curve, 0, makers.Operand[0]);
    sources->SetTypedComponent(curve, 1, makers.Operand[1]);
  }
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("SegmentCellIds");
  cells->SetNumberOfComponents(2);
  sbvtk::SetTuples(cells, static_cast<vtkIdType>(curves.Segments.size()));
  vtkIdType* out = cells->GetPointer(0);
  for (const sb::Curves::Makers& makers : curves.Segments)
  {
    for (std::size_t side = 0; side < 2; ++side)
    {
      *out++ = this->Operands[makers.Operand[side]]->CellOfTriangle(makers.Triangle[side]);
    }
  }
  this->Curves->GetCellData()->AddArray(ids);
  this->Curves->GetCellData()->AddArray(sources);
  this->Curves->GetCellData()->SetActiveScalars("CurveId"); // ParaView colours by it at once
  // ParaView tells of no field data at all where one array in them has no tuple.
  if (!curves.Segments.empty())
  {
    this->Curves->GetFieldData()->AddArray(cells);
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::BuildSplit(std::size_t operand)
{
  const sb::SplitSurface& split = this->Result.Surfaces[operand];
  vtkPolyData* output = this->Splits[operand];
  sbvtk::ResultOptions options;
  options.SinglePrecision = this->SinglePrecision;
  options.KeepOrigins = true;
  options.Loose.resize(this->Operands.size());
  options.Loose[operand] = split.HasCurveEdge;
  const sbvtk::ResultSurface result(this->Operands, split, options, this->Executor);
  this->CarryAttributes(operand, true, result.Points(), output);
  this->CarryAttributes(operand, false, result.Cells(), output);
  result.CopyTo(output, this->Executor);
  this->AddSplitArrays(split, result, output);
  output->GetFieldData()->Initialize(); // the pipeline gives every output that of Input
  if (vtkDataObject* input = vtkDataObject::GetData(this->Inputs[operand], 0))
  {
    output->GetFieldData()->PassData(input->GetFieldData());
  }
  sbvtk::AddBlockNames(output, sbvtk::BlockNamesOf(this->Connections));
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::CarryAttributes(
  std::size_t operand, bool ofPoints, const sbvtk::TupleSources& from, vtkPolyData* output)
{
  std::vector<sbvtk::AttributeUnion::Source> sources(this->Operands.size());
  sources[operand] = sbvtk::AttributesOf(this->Connections[operand], ofPoints);
  const sbvtk::AttributeUnion attributes(sources, ofPoints ? "point" : "cell");
  for (const std::string& sentence : attributes.Warnings())
  {
    vtkWarningWithObjectMacro(this->Filter, << sentence);
  }
  attributes.CopyTo(
    ofPoints ? static_cast<vtkDataSetAttributes*>(output->GetPointData()) : output->GetCellData(),
    from, this->Executor);
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::AddSplitArrays(
  const sb::SplitSurface& split, const sbvtk::ResultSurface& result, vtkPolyData* output)
{
  vtkNew<vtkIntArray> patches;
  patches->SetName("PatchId");
  sbvtk::SetTuples(patches, static_cast<vtkIdType>(result.Origins().size()));
  std::transform(result.Origins().begin(), result.Origins().end(), patches->GetPointer(0),
    [&split](std::int32_t origin) {
      return origin >= 0 ? split.PatchOfTriangle[origin] : split.PatchOfPiece[~origin];
    });
  vtkNew<vtkUnsignedCharArray> seam;
  seam->SetName("SeamPoint");
  sbvtk::SetTuples(seam, static_cast<vtkIdType>(split.IsOnCurve.size()));
  std::copy(split.IsOnCurve.begin(), split.IsOnCurve.end(), seam->GetPointer(0));
  output->GetCellData()->AddArray(patches);
  output->GetCellData()->SetActiveScalars("PatchId"); // ParaView colours by it at once
  output->GetPointData()->AddArray(seam);
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::Run::AddFields(int status, const std::string& message)
{
  double length = 0.0;
  if (vtkDataArray* lengths = this->Curves->GetCellData()->GetArray("Length"))
  {
    for (vtkIdType curve = 0; curve < lengths->GetNumberOfTuples(); ++curve)
    {
      length += lengths->GetComponent(curve, 0);
    }
  }
  sbvtk::AddField(this->Curves, "Status", status);
  sbvtk::AddField(this->Curves, "Message", message);
  sbvtk::AddField(this->Curves, "TotalLength", length);
  sbvtk::AddCount(this->Curves, "ContactCount", this->Result.NumberOfContacts);
  sbvtk::AddStageFields(this->Curves, this->Times);
}

//------------------------------------------------------------------------------
vtkPolyDataIntersection::vtkPolyDataIntersection()
  : Inputs(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkPolyDataIntersection::~vtkPolyDataIntersection() = default;

//------------------------------------------------------------------------------
int vtkPolyDataIntersection::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object: composite ones come whole, and others get a sentence of ours instead of the
  // pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  // Nor is Input required by the pipeline: its error would not say what to do.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPolyDataIntersection::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::UniteTimeSteps(inputs, this->GetNumberOfInputPorts(), outputs);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, inputs, outputs).Execute(); });
}

//------------------------------------------------------------------------------
void vtkPolyDataIntersection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitFirstOutput: " << this->SplitFirstOutput << "\n";
  os << indent << "SplitSecondOutput: " << this->SplitSecondOutput << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
