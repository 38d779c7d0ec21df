// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataClipClosedSurface.h"

#include "ArrayMemory.h"
#include "AttributeUnion.h"
#include "CapBlocks.h"
#include "Clip.h"
#include "ClippedLines.h"
#include "ClippedSurface.h"
#include "ConditionSentences.h"
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
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkPolyDataClipClosedSurface);

/** Moving a plane does not prepare the input again. */
struct vtkPolyDataClipClosedSurface::Cache
{
  sbvtk::PreparedInput Prepared;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataClipClosedSurface::Run
{
public:
  Run(vtkPolyDataClipClosedSurface* filter, vtkInformationVector** inputs,
    vtkInformationVector* outputs)
    : Filter(filter)
    , Inputs(inputs)
    , Surface(vtkPolyData::GetData(outputs, 0))
    , Outline(vtkPolyData::GetData(outputs, 1))
  {
  }

  void Execute();

private:
  void ListPlanes();
  void CheckSettings() const;
  void ReadInput();
  void Compute();
  void BuildOutputs();
  void Build(vtkPolyData* output, const sbvtk::ClippedLines& lines, bool withFaces);
  void AddColors(vtkPolyData* output, vtkIntArray* sources) const;
  void AddLabels(vtkPolyData* output, vtkIntArray* sources) const;
  bool IsFloat() const;
  void Warn(const sbvtk::AttributeUnion& attributes);
  void AddFields(int status, const std::string& message);

  vtkPolyDataClipClosedSurface* Filter;
  vtkInformationVector** Inputs;
  vtkPolyData* Surface;
  vtkPolyData* Outline;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  sbvtk::OperandSurface* Input = nullptr;
  std::vector<sb::ClipPlane> Planes;
  sb::ClipResult Result;
  sbvtk::ClippedLines Lines;
  std::vector<sb::StageTime> Times;
};

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::Execute()
{
  const auto steps = [this] {
    this->ListPlanes();
    this->CheckSettings();
    this->ReadInput();
    this->Compute();
    this->BuildOutputs();
  };
  const auto report = [this](const sbvtk::FilterFailure& failure) {
    this->Surface->Initialize();
    this->Outline->Initialize();
    this->AddFields(failure.Status, failure.Sentence);
  };
  sbvtk::RunSteps(this->Filter, steps,
    { report, sbvtk::FailureOf(sb::Status::Aborted),
      { OUT_OF_MEMORY,
        "The result does not fit into memory; decimate the input or close other data first." } });
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::ListPlanes()
{
  const auto add = [this](const double* origin, const double* normal) {
    this->Planes.push_back(
      { { origin[0], origin[1], origin[2] }, { normal[0], normal[1], normal[2] } });
  };
  if (this->Filter->UsePlane)
  {
    add(this->Filter->Origin, this->Filter->Normal);
  }
  for (const std::array<double, 6>& plane : this->Filter->Planes)
  {
    // A row that was just added to ParaView's table holds zeros until the user fills it in.
    if (plane != std::array<double, 6>{})
    {
      add(plane.data(), plane.data() + 3);
    }
  }
  if (vtkPlaneCollection* collection = this->Filter->ClippingPlanes)
  {
    for (int i = 0; i < collection->GetNumberOfItems(); ++i)
    {
      vtkPlane* plane = collection->GetItem(i);
      add(plane->GetOrigin(), plane->GetNormal());
    }
  }
  for (int side = 0; this->Filter->UseBox && side < 6; ++side)
  {
    double origin[3] = { this->Filter->Box[0], this->Filter->Box[2], this->Filter->Box[4] };
    double normal[3] = { 0.0, 0.0, 0.0 };
    origin[side / 2] = this->Filter->Box[side];
    normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
    add(origin, normal);
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::CheckSettings() const
{
  const int badRequest = static_cast<int>(sb::Status::BadRequest);
  const double* box = this->Filter->Box;
  if (this->Filter->UseBox && (box[0] > box[1] || box[2] > box[3] || box[4] > box[5]))
  {
    throw sbvtk::Failure{ badRequest,
      "Box has a minimum above its maximum; set it to xmin, xmax, ymin, ymax, zmin, zmax." };
  }
  for (std::size_t i = 0; i < this->Planes.size(); ++i)
  {
    if (!sb::IsPlane(this->Planes[i]))
    {
      throw sbvtk::Failure{ badRequest,
        "Plane " + std::to_string(i) +
          " has a normal of length 0 or a number that is not finite; set its Normal to a direction "
          "such as 0, 0, 1." };
    }
  }
  if (!std::isfinite(this->Filter->Tolerance) || this->Filter->Tolerance < 0.0)
  {
    throw sbvtk::Failure{ badRequest,
      "Tolerance is " + std::to_string(this->Filter->Tolerance) +
        "; set it to 0 or a small positive length." };
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::ReadInput()
{
  this->Filter->Input->Prepared.Read(
    this->Inputs[0], NOT_A_SURFACE, this->Filter->Tolerance, this->Executor);
  this->Input = &this->Filter->Input->Prepared.Surface();
  this->Times.push_back({ "Read input", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::Compute()
{
  sb::ClipRequest request;
  request.Mesh = this->Input->Mesh();
  request.FirstTriangles = this->Input->FirstTriangleOfCells();
  request.NumberOfCells = this->Input->NumberOfPolygons() + this->Input->NumberOfStrips();
  request.Planes = this->Planes;
  request.InsideOut = this->Filter->InsideOut != 0;
  request.Seams = this->Filter->PassPointData ? sb::SeamPoints::PerSide : sb::SeamPoints::Shared;
  sbvtk::KernelMonitor monitor(this->Filter, 0.05, 0.9);
  this->Result = sb::ClipSurface(request, this->Executor, monitor);
  this->Times.insert(this->Times.end(), this->Result.Times.begin(), this->Result.Times.end());
  this->Watch.Lap();
  if (sb::IsError(this->Result.Condition))
  {
    throw this->Filter->Input->Prepared.FailureOf(this->Result.Remarks.front());
  }
  if (this->Filter->GenerateOutline)
  {
    sbvtk::AddOutline(this->Result.Outline, this->Lines);
    sbvtk::AddInputLines(this->Input->Data(), request, this->Result, this->Lines);
  }
}

//------------------------------------------------------------------------------
bool vtkPolyDataClipClosedSurface::Run::IsFloat() const
{
  vtkPoints* points = this->Input->Data()->GetPoints();
  return points && vtkFloatArray::FastDownCast(points->GetData()) != nullptr;
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::BuildOutputs()
{
  this->Build(this->Surface, this->Lines, this->Filter->GenerateFaces != 0);
  this->Build(this->Outline, this->Lines, false);
  this->Times.push_back({ "Build outputs", this->Watch.Lap() });
  if (this->Input->NumberOfPolygons() + this->Input->NumberOfStrips() == 0 &&
    this->Lines.NumberOfLines() == 0)
  {
    sb::Remark remark;
    remark.Condition = sb::Status::EmptyOperand;
    const std::string sentence = sbvtk::ConditionSentence(remark, "Input", -1);
    vtkWarningWithObjectMacro(this->Filter, << sentence);
    this->AddFields(static_cast<int>(remark.Condition), sentence);
    return;
  }
  const std::int64_t open = this->Result.OpenContours;
  const std::int64_t joined = this->Result.JoinedContours;
  if (open + joined == 0)
  {
    this->AddFields(0, "The result is complete.");
    return;
  }
  const std::string sentence = "Input is open where the planes cut it: " + std::to_string(open) +
    " contours stayed open and got no cap, " + std::to_string(joined) +
    " were closed along the hull of the contours; fill its holes first if it should enclose a "
    "volume.";
  vtkWarningWithObjectMacro(this->Filter, << sentence);
  this->AddFields(OPEN_CONTOURS, sentence);
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::Build(
  vtkPolyData* output, const sbvtk::ClippedLines& lines, bool withFaces)
{
  const sbvtk::ClippedSurface result(*this->Input, this->Result, lines, withFaces, this->Executor);
  vtkPolyData* input = this->Input->Data();
  // The second source stands for caps and outlines, which have no input cell.
  const auto carry = [&](vtkDataSetAttributes* from, vtkDataSetAttributes* to, std::int64_t count,
                       const char* kind, const sbvtk::TupleSources& tuples) {
    const sbvtk::AttributeUnion attributes({ { from, count, "Input" }, { nullptr, 0, "" } }, kind);
    attributes.CopyTo(to, tuples, this->Executor);
    if (output == this->Surface)
    {
      this->Warn(attributes);
    }
  };
  if (this->Filter->PassPointData)
  {
    carry(input->GetPointData(), output->GetPointData(), input->GetNumberOfPoints(), "point",
      result.Points());
  }
  carry(
    input->GetCellData(), output->GetCellData(), input->GetNumberOfCells(), "cell", result.Cells());
  result.CopyTo(output, this->IsFloat(), this->Executor);
  sbvtk::MarkBlocks(
    input, this->Filter->Input->Prepared.Names(), result.Points(), output, this->Executor);
  if (this->Filter->ScalarMode == COLORS)
  {
    this->AddColors(output, result.Sources());
  }
  else if (this->Filter->ScalarMode == LABELS)
  {
    this->AddLabels(output, result.Sources());
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::AddColors(vtkPolyData* output, vtkIntArray* sources) const
{
  const auto bytes = [](const double* color) {
    std::array<unsigned char, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
    {
      result[i] =
        static_cast<unsigned char>(std::lround(255.0 * std::max(0.0, std::min(1.0, color[i]))));
    }
    return result;
  };
  const std::array<unsigned char, 3> colors[3] = { bytes(this->Filter->BaseColor),
    bytes(this->Filter->ClipColor), bytes(this->Filter->ActivePlaneColor) };
  const char* name = "Colors";
  vtkUnsignedCharArray* old =
    vtkUnsignedCharArray::SafeDownCast(output->GetCellData()->GetScalars());
  old = old && old->GetNumberOfComponents() == 3 ? old : nullptr;
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  sbvtk::SetTuples(array, sources->GetNumberOfValues());
  unsigned char* target = array->GetPointer(0);
  for (vtkIdType i = 0; i < sources->GetNumberOfValues(); ++i)
  {
    const int plane = sources->GetValue(i) - 1;
    const int kind = plane < 0 ? 0 : plane == this->Filter->ActivePlaneId ? 2 : 1;
    const unsigned char* color = kind == 0 && old ? old->GetPointer(3 * i) : colors[kind].data();
    std::copy_n(color, 3, target + 3 * i);
  }
  output->GetCellData()->AddArray(array);
  output->GetCellData()->SetActiveScalars(array->GetName());
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::AddLabels(vtkPolyData* output, vtkIntArray* sources) const
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("Labels");
  sbvtk::SetTuples(array, sources->GetNumberOfValues());
  unsigned char* target = array->GetPointer(0);
  for (vtkIdType i = 0; i < sources->GetNumberOfValues(); ++i)
  {
    const int plane = sources->GetValue(i) - 1;
    target[i] = plane < 0 ? 0 : plane == this->Filter->ActivePlaneId ? 2 : 1;
  }
  output->GetCellData()->AddArray(array);
  output->GetCellData()->SetActiveScalars(array->GetName());
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::Warn(const sbvtk::AttributeUnion& attributes)
{
  for (const std::string& sentence : attributes.Warnings())
  {
    vtkWarningWithObjectMacro(this->Filter, << sentence);
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::Run::AddFields(int status, const std::string& message)
{
  if (vtkDataObject* first = vtkDataObject::GetData(this->Inputs[0], 0))
  {
    this->Surface->GetFieldData()->PassData(first->GetFieldData());
  }
  sbvtk::AddField(this->Surface, "Status", status);
  sbvtk::AddField(this->Surface, "Message", message);
  sbvtk::AddCount(this->Surface, "OpenContourCount", this->Result.OpenContours);
  sbvtk::AddField<vtkDoubleArray>(this->Surface, "CapArea", this->Result.CapAreas);
  sbvtk::AddStageFields(this->Surface, this->Times);
}

//------------------------------------------------------------------------------
vtkPolyDataClipClosedSurface::vtkPolyDataClipClosedSurface()
  : Input(new Cache)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPolyDataClipClosedSurface::~vtkPolyDataClipClosedSurface() = default;

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::SetClippingPlanes(vtkPlaneCollection* planes)
{
  if (this->ClippingPlanes != planes)
  {
    this->ClippingPlanes = planes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPlaneCollection* vtkPolyDataClipClosedSurface::GetClippingPlanes()
{
  return this->ClippingPlanes;
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::SetNumberOfPlanes(int number)
{
  const std::size_t size = static_cast<std::size_t>(std::max(0, number));
  if (size != this->Planes.size())
  {
    this->Planes.resize(size, { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 });
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::SetPlane(int index, double originX, double originY,
  double originZ, double normalX, double normalY, double normalZ)
{
  if (index < 0)
  {
    return;
  }
  if (index >= this->GetNumberOfPlanes())
  {
    this->SetNumberOfPlanes(index + 1);
  }
  const std::array<double, 6> plane{ originX, originY, originZ, normalX, normalY, normalZ };
  if (this->Planes[static_cast<std::size_t>(index)] != plane)
  {
    this->Planes[static_cast<std::size_t>(index)] = plane;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::AddPlane(
  double originX, double originY, double originZ, double normalX, double normalY, double normalZ)
{
  this->SetPlane(this->GetNumberOfPlanes(), originX, originY, originZ, normalX, normalY, normalZ);
}

//------------------------------------------------------------------------------
const char* vtkPolyDataClipClosedSurface::GetScalarModeAsString()
{
  const char* names[] = { "None", "Colors", "Labels" };
  return names[this->ScalarMode];
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPolyDataClipClosedSurface::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->ClippingPlanes)
  {
    time = std::max(time, this->ClippingPlanes->GetMTime());
    for (int i = 0; i < this->ClippingPlanes->GetNumberOfItems(); ++i)
    {
      time = std::max(time, this->ClippingPlanes->GetItem(i)->GetMTime());
    }
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkPolyDataClipClosedSurface::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object: composite ones come whole, and others get a sentence of ours instead of the
  // pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, inputs, outputs).Execute(); });
}

//------------------------------------------------------------------------------
void vtkPolyDataClipClosedSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* values, int size) {
    os << indent << name << ":";
    for (int i = 0; i < size; ++i)
    {
      os << " " << values[i];
    }
    os << "\n";
  };
  os << indent
     << "ClippingPlanes: " << (this->ClippingPlanes ? this->ClippingPlanes->GetNumberOfItems() : 0)
     << "\n";
  os << indent << "UsePlane: " << this->UsePlane << "\n";
  vector("Origin", this->Origin, 3);
  vector("Normal", this->Normal, 3);
  for (const std::array<double, 6>& plane : this->Planes)
  {
    vector("Plane", plane.data(), 6);
  }
  os << indent << "UseBox: " << this->UseBox << "\n";
  vector("Box", this->Box, 6);
  os << indent << "InsideOut: " << this->InsideOut << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "GenerateFaces: " << this->GenerateFaces << "\n";
  os << indent << "GenerateOutline: " << this->GenerateOutline << "\n";
  os << indent << "PassPointData: " << this->PassPointData << "\n";
  os << indent << "ScalarMode: " << this->GetScalarModeAsString() << "\n";
  vector("BaseColor", this->BaseColor, 3);
  vector("ClipColor", this->ClipColor, 3);
  os << indent << "ActivePlaneId: " << this->ActivePlaneId << "\n";
  vector("ActivePlaneColor", this->ActivePlaneColor, 3);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
