// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataBooleanOperationFilter.h"

#include "AttributeUnion.h"
#include "BlockNames.h"
#include "FieldArrays.h"
#include "FilterRun.h"
#include "KernelExecutor.h"
#include "ResultCurves.h"
#include "ResultMeasures.h"
#include "ResultSurface.h"
#include "Stopwatch.h"
#include "SurfaceConnections.h"
#include "TimeSteps.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPolyDataBooleanOperationFilter);

struct vtkPolyDataBooleanOperationFilter::Cache
{
  sbvtk::SurfaceConnections Connections;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataBooleanOperationFilter::Run
{
public:
  Run(vtkPolyDataBooleanOperationFilter* filter, vtkInformationVector** inputs,
    vtkInformationVector* outputs)
    : Filter(filter)
    , Inputs(inputs)
    , Surface(vtkPolyData::GetData(outputs, 0))
    , Curves(vtkPolyData::GetData(outputs, 1))
  {
  }

  void Execute();

private:
  using Failure = sbvtk::FilterFailure;

  void CheckSettings() const;
  void ReadInputs();
  void Compute();
  void Report();
  void BuildOutputs();
  sbvtk::AttributeUnion Attributes(bool ofPoints);
  void Warn(const sbvtk::AttributeUnion& attributes);
  void AddFields(int status, const std::string& message);
  bool IsUnionOfOne() const;

  vtkPolyDataBooleanOperationFilter* Filter;
  vtkInformationVector** Inputs;
  vtkPolyData* Surface;
  vtkPolyData* Curves;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  std::vector<std::shared_ptr<sbvtk::OperandSurface>> Operands;
  std::optional<sbvtk::AttributeUnion> PointArrays;
  std::optional<sbvtk::AttributeUnion> CellArrays;
  std::vector<sb::StageTime> Times;
  sb::BooleanResult Result;
  sbvtk::ResultMeasures Measures;
};

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::Run::Execute()
{
  const auto steps = [this] {
    sbvtk::MatchConnections(this->Filter->Inputs->Connections, this->Inputs);
    this->CheckSettings();
    this->ReadInputs();
    this->Compute();
    this->Report();
    this->BuildOutputs();
  };
  const auto report = [this](const sbvtk::FilterFailure& failure) {
    this->Surface->Initialize();
    this->Curves->Initialize();
    this->AddFields(failure.Status, failure.Sentence);
  };
  sbvtk::RunSteps(this->Filter, steps,
    { report, sbvtk::FailureOf(sb::Status::Aborted),
      { OUT_OF_MEMORY,
        "The result does not fit into memory; decimate the inputs or close other data first." } });
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::Run::CheckSettings() const
{
  const int badRequest = static_cast<int>(sb::Status::BadRequest);
  const int operation = this->Filter->Operation;
  if (operation < VTK_UNION || operation > VTK_RESOLVE)
  {
    throw Failure{ badRequest,
      "Operation is " + std::to_string(operation) +
        "; set it to 0 (Union), 1 (Intersection), 2 (Difference), 3 (Symmetric Difference) or 4 "
        "(Resolve)." };
  }
  if (!std::isfinite(this->Filter->Tolerance) || this->Filter->Tolerance < 0.0)
  {
    throw Failure{ badRequest,
      "Tolerance is " + std::to_string(this->Filter->Tolerance) +
        "; set it to 0 or a small positive length." };
  }
  const int numberOfInputs = this->Inputs[0]->GetNumberOfInformationObjects();
  if (numberOfInputs == 0)
  {
    throw Failure{ badRequest,
      "Input has no surface; set Input (in ParaView: right-click the filter in the Pipeline "
      "Browser, Change Input)." };
  }
  const int numberOfTools = this->Inputs[1]->GetNumberOfInformationObjects();
  const bool needsTool = operation == VTK_DIFFERENCE || operation == VTK_SYMMETRIC_DIFFERENCE ||
    (operation == VTK_INTERSECTION && numberOfInputs == 1);
  if (needsTool && numberOfTools == 0)
  {
    const char* names[] = { "union", "intersection", "difference", "symmetric difference",
      "resolve" };
    throw Failure{ MISSING_TOOL,
      std::string("The ") + names[operation] +
        " needs a second surface, but Tool has none; set Tool (in ParaView: right-click the filter "
        "in the Pipeline Browser, Change Input)." };
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::Run::ReadInputs()
{
  sbvtk::SurfaceConnections& connections = this->Filter->Inputs->Connections;
  sbvtk::ReadConnections(
    connections, this->Inputs, NOT_A_SURFACE, this->Filter->Tolerance, this->Executor);
  this->Operands = sbvtk::SurfacesOf(connections);
  this->Times.push_back({ "Read inputs", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::Run::Compute()
{
  sb::BooleanRequest request;
  request.Op = static_cast<sb::Operation>(this->Filter->Operation);
  for (const sbvtk::SurfaceConnection& connection : this->Filter->Inputs->Connections)
  {
    request.Operands.push_back({ connection.Surface->Mesh(), connection.Side,
      connection.Surface->Examination(this->Executor) });
  }
  const double secondsOfExaminations = this->Watch.Lap();
  this->PointArrays.emplace(this->Attributes(true));
  this->CellArrays.emplace(this->Attributes(false));
  sbvtk::KernelMonitor monitor(this->Filter, 0.05, 0.9);
  this->Result = sb::ComputeBoolean(request,
    this->PointArrays->IsEmpty() ? sb::SeamPoints::Shared : sb::SeamPoints::PerSide, this->Executor,
    monitor);
  sbvtk::AppendTimes(this->Result.Times, secondsOfExaminations, this->Times);
  this->Watch.Lap();
}

//------------------------------------------------------------------------------
/** Say what the kernel remarked; a grave remark ends the update. */
void vtkPolyDataBooleanOperationFilter::Run::Report()
{
  for (const sb::Remark& remark : this->Result.Remarks)
  {
    const std::string sentence = sbvtk::RemarkSentence(remark, this->Filter->Inputs->Connections);
    if (sb::IsError(remark.Condition))
    {
      throw Failure{ static_cast<int>(remark.Condition), sentence };
    }
    if (remark.Condition != sb::Status::Ok)
    {
      vtkWarningWithObjectMacro(this->Filter, << sentence);
    }
  }
  if (sb::IsError(this->Result.Condition))
  {
    sb::Remark remark;
    remark.Condition = this->Result.Condition;
    throw Failure{ static_cast<int>(this->Result.Condition),
      sbvtk::RemarkSentence(remark, this->Filter->Inputs->Connections) };
  }
}

//------------------------------------------------------------------------------
sbvtk::AttributeUnion vtkPolyDataBooleanOperationFilter::Run::Attributes(bool ofPoints)
{
  std::vector<sbvtk::AttributeUnion::Source> sources;
  for (const sbvtk::SurfaceConnection& connection : this->Filter->Inputs->Connections)
  {
    sources.push_back(sbvtk::AttributesOf(connection, ofPoints));
  }
  return sbvtk::AttributeUnion(sources, ofPoints ? "point" : "cell");
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::Run::Warn(const sbvtk::AttributeUnion& attributes)
{
  for (const std::string& sentence : attributes.Warnings())
  {
    vtkWarningWithObjectMacro(this->Filter, << sentence);
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::Run::BuildOutputs()
{
  const bool difference = this->Filter->Operation == VTK_DIFFERENCE ||
    this->Filter->Operation == VTK_SYMMETRIC_DIFFERENCE;
  const sbvtk::AttributeUnion& pointArrays = *this->PointArrays;
  const sbvtk::AttributeUnion& cellArrays = *this->CellArrays;
  this->Warn(pointArrays);
  this->Warn(cellArrays);

  sbvtk::ResultOptions options;
  options.SinglePrecision = sbvtk::HaveFloatPoints(this->Filter->Inputs->Connections);
  options.TurnReversed = !difference || this->Filter->ReorientDifferenceCells;
  options.SeparateReversed = pointArrays.HasNormals();
  options.KeepReversal = pointArrays.HasNormals() || cellArrays.HasNormals();
  const sbvtk::ResultSurface result(this->Operands, this->Result, options, this->Executor);
  pointArrays.CopyTo(this->Surface->GetPointData(), result.Points(), this->Executor);
  cellArrays.CopyTo(this->Surface->GetCellData(), result.Cells(), this->Executor);
  if (result.HasReversed())
  {
    std::vector<std::int32_t> operands;
    std::vector<std::uint8_t> reversed;
    result.FindReversedPoints(operands, reversed);
    pointArrays.NegateNormals(this->Surface->GetPointData(), operands, reversed);
    cellArrays.NegateNormals(
      this->Surface->GetCellData(), result.OperandsOfCells(), result.ReversedCells());
  }
  result.CopyTo(
    this->Surface, this->Executor); // last, as SourceId of an earlier Boolean gives way to ours
  sbvtk::CopyCurves(this->Result.Intersection, options.SinglePrecision, this->Curves);
  this->Measures = sbvtk::MeasureResult(this->Operands, this->Result, this->Executor);
  this->Times.push_back({ "Build outputs", this->Watch.Lap() });

  const auto gravest = std::find_if(this->Result.Remarks.begin(), this->Result.Remarks.end(),
    [this](const sb::Remark& remark) { return remark.Condition == this->Result.Condition; });
  const sb::Remark remark = gravest == this->Result.Remarks.end() ? sb::Remark() : *gravest;
  if (this->IsUnionOfOne() && this->Result.Condition == sb::Status::Ok)
  {
    const std::string sentence =
      "There is only one surface, so its union is that surface; set Tool to unite it with another "
      "one, or choose Resolve to unite its own overlapping parts.";
    vtkWarningWithObjectMacro(this->Filter, << sentence);
    this->AddFields(ONE_SURFACE, sentence);
    return;
  }
  this->AddFields(static_cast<int>(this->Result.Condition),
    sbvtk::RemarkSentence(remark, this->Filter->Inputs->Connections));
}

//------------------------------------------------------------------------------
bool vtkPolyDataBooleanOperationFilter::Run::IsUnionOfOne() const
{
  return this->Filter->Operation == VTK_UNION && this->Operands.size() == 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::Run::AddFields(int status, const std::string& message)
{
  if (vtkDataObject* first = vtkDataObject::GetData(this->Inputs[0], 0))
  {
    this->Surface->GetFieldData()->PassData(first->GetFieldData());
  }
  std::vector<double> volumes;
  std::vector<double> areas;
  for (const sb::OperandReport& operand : this->Result.Operands)
  {
    volumes.push_back(operand.Volume);
    areas.push_back(operand.Area);
  }
  sbvtk::AddField(this->Surface, "Status", status);
  sbvtk::AddField(this->Surface, "Message", message);
  sbvtk::AddField<vtkDoubleArray>(this->Surface, "OperandVolume", volumes);
  sbvtk::AddField<vtkDoubleArray>(this->Surface, "OperandArea", areas);
  sbvtk::AddField(this->Surface, "ResultVolume", this->Measures.Volume);
  sbvtk::AddField(this->Surface, "ResultArea", this->Measures.Area);
  sbvtk::AddCount(this->Surface, "ContactCount", this->Result.NumberOfContacts);
  sbvtk::AddStageFields(this->Surface, this->Times);
  sbvtk::AddBlockNames(this->Surface, sbvtk::BlockNamesOf(this->Filter->Inputs->Connections));
}

//------------------------------------------------------------------------------
vtkPolyDataBooleanOperationFilter::vtkPolyDataBooleanOperationFilter()
  : Inputs(new Cache)
{
  static_assert(static_cast<int>(sb::Operation::Union) == VTK_UNION &&
      static_cast<int>(sb::Operation::Intersection) == VTK_INTERSECTION &&
      static_cast<int>(sb::Operation::Difference) == VTK_DIFFERENCE &&
      static_cast<int>(sb::Operation::SymmetricDifference) == VTK_SYMMETRIC_DIFFERENCE &&
      static_cast<int>(sb::Operation::Resolve) == VTK_RESOLVE,
    "the kernel's numbers of the operations are the filter's");
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPolyDataBooleanOperationFilter::~vtkPolyDataBooleanOperationFilter() = default;

//------------------------------------------------------------------------------
int vtkPolyDataBooleanOperationFilter::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object: composite ones come whole, and others get a sentence of ours instead of the
  // pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  // Nor is Input required by the pipeline: its error would not say what to do.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPolyDataBooleanOperationFilter::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::UniteTimeSteps(inputs, this->GetNumberOfInputPorts(), outputs);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, inputs, outputs).Execute(); });
}

//------------------------------------------------------------------------------
void vtkPolyDataBooleanOperationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operation: " << this->Operation << "\n";
  os << indent << "ReorientDifferenceCells: " << this->ReorientDifferenceCells << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
