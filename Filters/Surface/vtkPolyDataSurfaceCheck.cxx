// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataSurfaceCheck.h"

#include "BlockNames.h"
#include "CheckMarks.h"
#include "CheckVerdict.h"
#include "ConditionSentences.h"
#include "DefectLines.h"
#include "FieldArrays.h"
#include "FilterRun.h"
#include "KernelExecutor.h"
#include "OperandSurface.h"
#include "Stopwatch.h"
#include "SurfaceConnections.h"
#include "SurfaceInput.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkPolyDataSurfaceCheck);

/** What is kept from one update to the next: the surface of a composite input, merged. */
struct vtkPolyDataSurfaceCheck::Cache
{
  sbvtk::SurfaceInput Input;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataSurfaceCheck::Run
{
public:
  Run(vtkPolyDataSurfaceCheck* filter, vtkInformationVector** inputs, vtkInformationVector* outputs)
    : Filter(filter)
    , Input(vtkDataObject::GetData(inputs[0], 0))
    , Surface(vtkPolyData::GetData(outputs, 0))
    , Defects(vtkPolyData::GetData(outputs, 1))
  {
  }

  void Execute();

private:
  using Failure = sbvtk::FilterFailure;

  void ReadInput();
  void Compute();
  void BuildOutputs();
  void AddCounts(const sbvtk::CheckFindings& findings);
  void AddShells();
  template <typename Array, typename Value, typename ValueOf>
  void AddShellField(const char* name, ValueOf&& valueOf);
  void AddCount(const char* name, std::int64_t count);
  void AddStatus(int status, const std::string& message);

  vtkPolyDataSurfaceCheck* Filter;
  vtkDataObject* Input;
  vtkPolyData* Surface;
  vtkPolyData* Defects;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  std::unique_ptr<sbvtk::OperandSurface> Operand;
  std::vector<sb::StageTime> Times;
  sb::SurfaceCheckResult Result;
};

namespace
{

bool HasFloatPoints(vtkPolyData* surface)
{
  return surface->GetPoints() && surface->GetPoints()->GetDataType() == VTK_FLOAT;
}

} // namespace

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::Execute()
{
  const auto steps = [this] {
    this->ReadInput();
    this->Compute();
    this->BuildOutputs();
  };
  const auto report = [this](const sbvtk::FilterFailure& failure) {
    this->Surface->Initialize();
    this->Defects->Initialize();
    this->Times.clear();
    this->AddStatus(failure.Status, failure.Sentence);
  };
  sbvtk::RunSteps(this->Filter, steps,
    { report, sbvtk::FailureOf(sb::Status::Aborted),
      { OUT_OF_MEMORY,
        "The check does not fit into memory; decimate the Input, switch Self Intersections off, or "
        "close other data first." } });
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::ReadInput()
{
  if (!this->Input)
  {
    throw Failure{ static_cast<int>(sb::Status::BadRequest),
      "Input has no surface; set Input (in ParaView: right-click the filter in the Pipeline "
      "Browser, Change Input)." };
  }
  const std::string refusal = this->Filter->Kept->Input.Read(this->Input, this->Executor);
  if (!refusal.empty())
  {
    throw Failure{ NOT_A_SURFACE, "Input " + refusal };
  }
  vtkPolyData* surface = this->Filter->Kept->Input.Surface();
  if (!sbvtk::OperandSurface::FitsInt32(surface))
  {
    throw sbvtk::FailureOf(sb::Status::TooLarge);
  }
  this->Operand.reset(new sbvtk::OperandSurface(surface, this->Executor));
  this->Times.push_back({ "Read input", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::Compute()
{
  sb::SurfaceCheckRequest request;
  request.Mesh = this->Operand->Mesh();
  request.Cells = { this->Operand->FirstTriangleOfCells(),
    this->Operand->NumberOfPolygons() + this->Operand->NumberOfStrips() };
  request.SelfIntersections = this->Filter->SelfIntersections != 0;
  sbvtk::KernelMonitor monitor(this->Filter, 0.05, 0.9);
  this->Result = sb::CheckSurface(request, this->Executor, monitor);
  if (sb::IsError(this->Result.Condition))
  {
    throw sbvtk::FailureOf(this->Result.Condition);
  }
  this->Times.insert(this->Times.end(), this->Result.Times.begin(), this->Result.Times.end());
  this->Watch.Lap();
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::BuildOutputs()
{
  const sbvtk::CellMarks marks(*this->Operand, this->Result);
  sbvtk::BuildMarkedSurface(*this->Operand, this->Result, marks, this->Surface);
  sbvtk::BuildDefectLines(
    *this->Operand, this->Result, HasFloatPoints(this->Operand->Data()), this->Defects);
  this->Times.push_back({ "Build outputs", this->Watch.Lap() });

  const sbvtk::CheckFindings findings{ this->Result, this->Operand->Mesh().NumberOfTriangles,
    marks.Count(sb::Defect::NoArea), marks.Count(sb::Defect::BadIndex),
    marks.Count(sb::Defect::NotFinite), this->Filter->SelfIntersections != 0 };
  for (vtkPolyData* output : { this->Surface, this->Defects })
  {
    sbvtk::AddField(output, "Verdict", sbvtk::Verdict(findings));
    sbvtk::AddField(output, "Fit", static_cast<int>(sbvtk::IsFit(findings)));
    sbvtk::AddField(output, "Clean", static_cast<int>(sbvtk::IsClean(findings)));
  }
  sbvtk::AddBlockNames(this->Surface, this->Filter->Kept->Input.Names());
  this->AddStatus(0, "The check is complete.");
  this->AddCounts(findings);
  this->AddShells();
  // ParaView tells of no field data at all where one array in them has no tuple.
  const std::vector<vtkIdType> badCells = marks.Unusable();
  if (!badCells.empty())
  {
    sbvtk::AddField<vtkIdTypeArray>(this->Surface, "BadCellIds", badCells);
  }
  const std::vector<vtkIdType> badPoints = sbvtk::PointsWithoutPlace(this->Result);
  if (!badPoints.empty())
  {
    sbvtk::AddField<vtkIdTypeArray>(this->Surface, "BadPointIds", badPoints);
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::AddCounts(const sbvtk::CheckFindings& findings)
{
  const sb::SurfaceCheckCounts& counts = this->Result.Counts;
  const std::int64_t genus = this->Result.Genus();
  std::int64_t characteristic = 0;
  for (const sb::Shell& shell : this->Result.Shells)
  {
    characteristic += shell.EulerCharacteristic();
  }
  const bool isClosed = this->Result.Report.Closed && findings.Triangles > 0;
  sbvtk::AddField(this->Surface, "Closed", static_cast<int>(isClosed));
  sbvtk::AddField(this->Surface, "Volume", this->Result.Report.Volume);
  sbvtk::AddField(this->Surface, "Area", this->Result.Report.Area);
  this->AddCount("Genus", genus);
  this->AddCount("EulerCharacteristic", characteristic);
  this->AddCount("TriangleCount", findings.Triangles);
  this->AddCount("VertexCount", counts.Vertices);
  this->AddCount("EdgeCount", counts.Edges);
  this->AddCount("BoundaryEdgeCount", counts.RimEdges);
  this->AddCount("BoundaryLoopCount", counts.Rims);
  this->AddCount("NonManifoldEdgeCount", counts.ManyFoldEdges);
  this->AddCount("NonManifoldPointCount", counts.TouchingVertices);
  this->AddCount("InconsistentEdgeCount", counts.ContradictoryEdges);
  this->AddCount(
    "SelfIntersectionCount", findings.LookedForSelfIntersections ? counts.SelfIntersections : -1);
  this->AddCount("DegenerateCellCount", findings.DegenerateCells);
  this->AddCount("DuplicateCellCount", counts.DuplicateCells);
  this->AddCount("DuplicatePointCount", counts.DuplicatePoints);
  this->AddCount("WrongWayTriangleCount", counts.WrongWayTriangles);
  this->AddCount("NonFinitePointCount", counts.NotFinitePoints);
  this->AddCount("NonFiniteCellCount", findings.NotFiniteCells);
  this->AddCount("BadIndexCellCount", findings.BadCells);
  this->AddCount("ShellCount", static_cast<std::int64_t>(this->Result.Shells.size()));
  this->AddCount("ClosedShellCount", counts.ClosedShells);
  this->AddCount("OneSidedShellCount", counts.OneSidedShells);
  this->AddCount("InvertedShellCount", counts.InvertedShells);
  this->AddCount("CoveredShellCount", counts.CoveredShells);
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::AddShells()
{
  using S = const sb::Shell&;
  this->AddShellField<vtkIntArray, int>("ShellClosed", [](S s) { return s.IsClosed; });
  this->AddShellField<vtkDoubleArray, double>("ShellVolume", [](S s) { return s.Volume; });
  this->AddShellField<vtkDoubleArray, double>("ShellArea", [](S s) { return s.Area; });
  this->AddShellField<vtkIdTypeArray, vtkIdType>(
    "ShellTriangleCount", [](S s) { return s.NumberOfTriangles; });
  this->AddShellField<vtkIdTypeArray, vtkIdType>(
    "ShellLoopCount", [](S s) { return s.NumberOfRims; });
  this->AddShellField<vtkIntArray, int>("ShellGenus", [](S s) { return s.Genus; });
  this->AddShellField<vtkIntArray, int>("ShellDepth", [](S s) { return s.Depth; });
  this->AddShellField<vtkIntArray, int>("ShellParent", [](S s) { return s.Parent; });
  this->AddShellField<vtkIntArray, int>("ShellWrongWay", [](S s) {
    return !s.IsClosed || s.WindingInFront == 0 ? 0 : s.WindingInFront < 0 ? 1 : 2;
  });
}

//------------------------------------------------------------------------------
template <typename Array, typename Value, typename ValueOf>
void vtkPolyDataSurfaceCheck::Run::AddShellField(const char* name, ValueOf&& valueOf)
{
  if (this->Result.Shells.empty())
  {
    return;
  }
  std::vector<Value> values;
  for (const sb::Shell& shell : this->Result.Shells)
  {
    values.push_back(static_cast<Value>(valueOf(shell)));
  }
  sbvtk::AddField<Array>(this->Surface, name, values);
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::AddCount(const char* name, std::int64_t count)
{
  sbvtk::AddCount(this->Surface, name, count);
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::Run::AddStatus(int status, const std::string& message)
{
  for (vtkPolyData* output : { this->Surface, this->Defects })
  {
    sbvtk::AddField(output, "Status", status);
    sbvtk::AddField(output, "Message", message);
  }
  if (!this->Times.empty())
  {
    sbvtk::AddStageFields(this->Surface, this->Times);
  }
}

//------------------------------------------------------------------------------
vtkPolyDataSurfaceCheck::vtkPolyDataSurfaceCheck()
  : Kept(new Cache)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPolyDataSurfaceCheck::~vtkPolyDataSurfaceCheck() = default;

//------------------------------------------------------------------------------
int vtkPolyDataSurfaceCheck::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object: composite ones come whole, and others get a sentence of ours instead of the
  // pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  // Nor is Input required by the pipeline: its error would not say what to do.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, inputs, outputs).Execute(); });
}

//------------------------------------------------------------------------------
void vtkPolyDataSurfaceCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SelfIntersections: " << this->SelfIntersections << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
