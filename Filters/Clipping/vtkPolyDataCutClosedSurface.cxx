// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataCutClosedSurface.h"

#include "ArrayMemory.h"
#include "AttributeUnion.h"
#include "CapBlocks.h"
#include "Cut.h"
#include "FieldArrays.h"
#include "FilterRun.h"
#include "KernelExecutor.h"
#include "PlaneOnLattice.h"
#include "PreparedInput.h"
#include "Stopwatch.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkPolyDataCutClosedSurface);

/** Moving the plane does not prepare the input again. */
struct vtkPolyDataCutClosedSurface::Cache
{
  sbvtk::PreparedInput Prepared;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataCutClosedSurface::Run
{
public:
  Run(vtkPolyDataCutClosedSurface* filter, vtkInformationVector** inputs,
    vtkInformationVector* outputs)
    : Filter(filter)
    , Inputs(inputs)
    , Caps(vtkPolyData::GetData(outputs, 0))
  {
  }

  void Execute();

private:
  void CheckSettings() const;
  void Compute();
  void BuildPoints();
  sbvtk::TupleSources Points() const;
  void BuildTriangles();
  void BuildOutlines();
  void AddCellArrays(const std::vector<std::int32_t>& polygons);
  void Report();
  void AddFields(int status, const std::string& message);

  vtkPolyDataCutClosedSurface* Filter;
  vtkInformationVector** Inputs;
  vtkPolyData* Caps;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  sb::CutResult Result;
  std::vector<sb::StageTime> Times;
};

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::Execute()
{
  const auto steps = [this] {
    this->CheckSettings();
    this->Filter->Input->Prepared.Read(
      this->Inputs[0], NOT_A_SURFACE, this->Filter->Tolerance, this->Executor);
    this->Times.push_back({ "Read input", this->Watch.Lap() });
    this->Compute();
    this->BuildPoints();
    this->Filter->Triangulate ? this->BuildTriangles() : this->BuildOutlines();
    sbvtk::MarkBlocks(this->Filter->Input->Prepared.Surface().Data(),
      this->Filter->Input->Prepared.Names(), this->Points(), this->Caps, this->Executor);
    this->Times.push_back({ "Build output", this->Watch.Lap() });
    this->Report();
  };
  const auto report = [this](const sbvtk::FilterFailure& failure) {
    this->Result = sb::CutResult();
    this->Caps->Initialize();
    this->AddFields(failure.Status, failure.Sentence);
  };
  sbvtk::RunSteps(this->Filter, steps,
    { report, sbvtk::FailureOf(sb::Status::Aborted),
      { OUT_OF_MEMORY,
        "The result does not fit into memory; decimate the input or close other data first." } });
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::CheckSettings() const
{
  const auto refuse = [](const std::string& sentence) {
    throw sbvtk::Failure{ static_cast<int>(sb::Status::BadRequest), sentence };
  };
  sb::ClipPlane plane;
  std::copy_n(this->Filter->Origin, 3, plane.Origin.begin());
  std::copy_n(this->Filter->Normal, 3, plane.Normal.begin());
  if (!sb::IsPlane(plane))
  {
    refuse("The plane has a normal of length 0 or a number that is not finite; set Normal to a "
           "direction such as 0, 0, 1.");
  }
  for (const double offset : this->Filter->Offsets)
  {
    if (!std::isfinite(offset))
    {
      refuse("An offset is not a finite number; set Offsets to distances along the normal.");
    }
  }
  if (!std::isfinite(this->Filter->Tolerance) || this->Filter->Tolerance < 0.0)
  {
    refuse("Tolerance is " + std::to_string(this->Filter->Tolerance) +
      "; set it to 0 or a small positive length.");
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::Compute()
{
  sb::CutRequest request;
  const sbvtk::OperandSurface& surface = this->Filter->Input->Prepared.Surface();
  request.Mesh = surface.Mesh();
  request.FirstTriangles = surface.FirstTriangleOfCells();
  request.NumberOfCells = surface.NumberOfPolygons() + surface.NumberOfStrips();
  std::copy_n(this->Filter->Origin, 3, request.Plane.Origin.begin());
  std::copy_n(this->Filter->Normal, 3, request.Plane.Normal.begin());
  request.Offsets = this->Filter->Offsets;
  sbvtk::KernelMonitor monitor(this->Filter, 0.05, 0.9);
  this->Result = sb::CutSurface(request, this->Executor, monitor);
  this->Times.insert(this->Times.end(), this->Result.Times.begin(), this->Result.Times.end());
  this->Watch.Lap();
  if (sb::IsError(this->Result.Condition))
  {
    throw this->Filter->Input->Prepared.FailureOf(this->Result.Remarks.front());
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::BuildPoints()
{
  vtkPolyData* input = this->Filter->Input->Prepared.Surface().Data();
  const bool isFloat =
    input->GetPoints() && vtkFloatArray::FastDownCast(input->GetPoints()->GetData());
  vtkNew<vtkPoints> points;
  points->SetDataType(isFloat ? VTK_FLOAT : VTK_DOUBLE);
  sbvtk::SetTuples(points, static_cast<vtkIdType>(this->Result.Points.size()));
  for (std::size_t i = 0; i < this->Result.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), this->Result.Points[i].Position.data());
  }
  this->Caps->SetPoints(points);
  if (!this->Filter->PassPointData)
  {
    return;
  }
  const sbvtk::AttributeUnion attributes(
    { { input->GetPointData(), input->GetNumberOfPoints(), "Input" }, { nullptr, 0, "" } },
    "point");
  attributes.CopyTo(this->Caps->GetPointData(), this->Points(), this->Executor);
  for (const std::string& sentence : attributes.Warnings())
  {
    vtkWarningWithObjectMacro(this->Filter, << sentence);
  }
}

//------------------------------------------------------------------------------
/** Where the points come from: all are new. */
sbvtk::TupleSources vtkPolyDataCutClosedSurface::Run::Points() const
{
  sbvtk::TupleSources tuples;
  tuples.NumberOfTuples = static_cast<std::int64_t>(this->Result.Points.size());
  tuples.Interpolated = &this->Result.Points;
  return tuples;
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::BuildTriangles()
{
  const auto count = static_cast<vtkIdType>(this->Result.Triangles.size());
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  sbvtk::SetTuples(offsets, count + 1);
  sbvtk::SetTuples(connectivity, 3 * count);
  vtkTypeInt64* id = connectivity->GetPointer(0);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  for (const std::array<std::int32_t, 3>& triangle : this->Result.Triangles)
  {
    id = std::copy(triangle.begin(), triangle.end(), id);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  this->Caps->SetPolys(polygons);
  this->AddCellArrays(this->Result.PolygonOfTriangle);
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::BuildOutlines()
{
  const sb::CutResult& result = this->Result;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> holes;
  holes->SetName("Hole");
  for (std::size_t loop = 0; loop < result.PolygonOfLoop.size(); ++loop)
  {
    const std::int32_t begin = result.LoopOffsets[loop];
    const std::int32_t end = result.LoopOffsets[loop + 1];
    lines->InsertNextCell(end - begin + 1);
    for (std::int32_t i = begin; i <= end; ++i)
    {
      lines->InsertCellPoint(result.LoopPoints[static_cast<std::size_t>(i < end ? i : begin)]);
    }
    holes->InsertNextValue(result.IsHole[loop]);
  }
  this->Caps->SetLines(lines);
  this->AddCellArrays(result.PolygonOfLoop);
  this->Caps->GetCellData()->AddArray(holes);
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::AddCellArrays(const std::vector<std::int32_t>& polygons)
{
  vtkNew<vtkIntArray> sources;
  vtkNew<vtkDoubleArray> offsets;
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> areas;
  vtkNew<vtkDoubleArray> perimeters;
  vtkNew<vtkIntArray> nestings;
  const std::pair<vtkDataArray*, const char*> arrays[] = { { sources, "SourceId" },
    { offsets, "Offset" }, { ids, "PolygonId" }, { areas, "Area" }, { perimeters, "Perimeter" },
    { nestings, "Nesting" } };
  for (const auto& array : arrays)
  {
    array.first->SetName(array.second);
    sbvtk::SetTuples(array.first, static_cast<vtkIdType>(polygons.size()));
    this->Caps->GetCellData()->AddArray(array.first);
  }
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    const sb::CutPolygon& polygon = this->Result.Polygons[static_cast<std::size_t>(polygons[i])];
    const auto cell = static_cast<vtkIdType>(i);
    sources->SetValue(cell, polygon.Plane);
    offsets->SetValue(cell, this->Filter->Offsets[static_cast<std::size_t>(polygon.Plane)]);
    ids->SetValue(cell, polygons[i]);
    areas->SetValue(cell, polygon.Area);
    perimeters->SetValue(cell, polygon.Perimeter);
    nestings->SetValue(cell, polygon.Nesting);
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::Report()
{
  const std::int64_t open = this->Result.OpenContours;
  const std::int64_t joined = this->Result.JoinedContours;
  if (open + joined == 0)
  {
    this->AddFields(0, "The result is complete.");
    return;
  }
  const std::string sentence = "Input is open where the planes cut it: " + std::to_string(open) +
    " contours stayed open and were left out, " + std::to_string(joined) +
    " were closed along the hull of the contours; fill its holes first if it should enclose a "
    "volume.";
  vtkWarningWithObjectMacro(this->Filter, << sentence);
  this->AddFields(OPEN_CONTOURS, sentence);
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::Run::AddFields(int status, const std::string& message)
{
  if (vtkDataObject* first = vtkDataObject::GetData(this->Inputs[0], 0))
  {
    this->Caps->GetFieldData()->PassData(first->GetFieldData());
  }
  std::vector<double> areas(this->Filter->Offsets.size(), 0.0);
  for (const sb::CutPolygon& polygon : this->Result.Polygons)
  {
    areas[static_cast<std::size_t>(polygon.Plane)] += polygon.Area;
  }
  sbvtk::AddField(this->Caps, "Status", status);
  sbvtk::AddField(this->Caps, "Message", message);
  sbvtk::AddCount(this->Caps, "OpenContourCount", this->Result.OpenContours);
  sbvtk::AddCount(
    this->Caps, "PolygonCount", static_cast<std::int64_t>(this->Result.Polygons.size()));
  sbvtk::AddField<vtkDoubleArray>(this->Caps, "SliceArea", areas);
  sbvtk::AddStageFields(this->Caps, this->Times);
}

//------------------------------------------------------------------------------
vtkPolyDataCutClosedSurface::vtkPolyDataCutClosedSurface()
  : Input(new Cache)
{
}

//------------------------------------------------------------------------------
vtkPolyDataCutClosedSurface::~vtkPolyDataCutClosedSurface() = default;

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::SetNumberOfOffsets(int number)
{
  const std::size_t size = static_cast<std::size_t>(std::max(0, number));
  if (size != this->Offsets.size())
  {
    this->Offsets.resize(size, 0.0);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::SetOffset(int index, double offset)
{
  if (index < 0)
  {
    return;
  }
  if (index >= this->GetNumberOfOffsets())
  {
    this->SetNumberOfOffsets(index + 1);
  }
  if (this->Offsets[static_cast<std::size_t>(index)] != offset)
  {
    this->Offsets[static_cast<std::size_t>(index)] = offset;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkPolyDataCutClosedSurface::GetOffset(int index) const
{
  return index >= 0 && index < this->GetNumberOfOffsets()
    ? this->Offsets[static_cast<std::size_t>(index)]
    : 0.0;
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::GenerateOffsets(int number, double first, double last)
{
  this->SetNumberOfOffsets(number);
  for (int i = 0; i < number; ++i)
  {
    this->SetOffset(i, number > 1 ? first + i * (last - first) / (number - 1) : first);
  }
}

//------------------------------------------------------------------------------
int vtkPolyDataCutClosedSurface::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object: composite ones come whole, and others get a sentence of ours instead of the
  // pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, inputs, outputs).Execute(); });
}

//------------------------------------------------------------------------------
void vtkPolyDataCutClosedSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "Normal: " << this->Normal[0] << " " << this->Normal[1] << " " << this->Normal[2]
     << "\n";
  os << indent << "Offsets:";
  for (const double offset : this->Offsets)
  {
    os << " " << offset;
  }
  os << "\n";
  os << indent << "Triangulate: " << this->Triangulate << "\n";
  os << indent << "PassPointData: " << this->PassPointData << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
