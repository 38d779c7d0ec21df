// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSetIntersectionFilter.h"

#include "CloudInput.h"
#include "CloudSentences.h"
#include "CloudSurface.h"
#include "DesignedInput.h"
#include "FieldArrays.h"
#include "KernelExecutor.h"
#include "MeshSection.h"
#include "PlaneSection.h"
#include "Stopwatch.h"
#include "vtkPointSetSurfaceFilter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPointSetIntersectionFilter);

namespace
{
constexpr double ChordErrorInSpacings = 0.1;
using CloudFilter = vtkPointSetSurfaceFilter;

/** A unit vector, or 0 where the triangle has no area. */
sb::Real3 NormalOf(const sb::DesignedSurface& mesh, std::int32_t triangle)
{
  sb::Real3 corners[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t point =
      static_cast<std::size_t>(mesh.Triangles[3 * static_cast<std::size_t>(triangle) + k]);
    std::copy_n(mesh.Points.data() + 3 * point, 3, corners[k].data());
  }
  return sb::UnitNormalOf(corners[0], corners[1], corners[2]);
}
}

/** A curve, whatever it was cut with. */
struct vtkPointSetIntersectionFilter::Curve
{
  std::vector<sb::Real3> Points; ///< the first again at the end if Closed
  std::vector<sb::Real3> PlaneNormals; ///< of the plane that the curve lies in, for each point
  std::vector<vtkIdType> Cells; ///< of the Tool, for each point
  bool Closed = false;
  bool IsTangential = false;
  int Ends[2] = { NO_END, NO_END };
  double ChordError = 0.0;
};

/** One update: its steps in their order, and what they share. */
class vtkPointSetIntersectionFilter::Run
{
public:
  Run(vtkPointSetIntersectionFilter* filter, vtkDataObject* input, vtkInformationVector* tool,
    vtkPolyData* curves)
    : Filter(filter)
    , Data(input)
    , HasTool(tool && tool->GetNumberOfInformationObjects() > 0)
    , ToolData(this->HasTool ? vtkDataObject::GetData(tool, 0) : nullptr)
    , Curves(curves)
  {
  }

  void Execute();

private:
  struct Failure
  {
    int Status;
    std::string Sentence;
  };

  void CheckSettings();
  void CheckPlane();
  void PrepareTool();
  void PrepareCloud();
  void Intersect();
  std::vector<Curve> CutWithPlane(double chordError, sb::Monitor& monitor);
  std::vector<Curve> CutWithMesh(double chordError, sb::Monitor& monitor);
  void Warn(int status, const std::string& sentence);
  void BuildCurves(const std::vector<Curve>& curves);
  void AddFields(int status, const std::string& message);

  vtkPointSetIntersectionFilter* Filter;
  vtkDataObject* Data;
  bool HasTool;
  vtkDataObject* ToolData;
  vtkPolyData* Curves;
  sbvtk::CloudInput Input;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  std::vector<sb::StageTime> Times;
  sb::CloudSurface Cloud;
  sb::Real3 Origin{};
  sb::Real3 Normal{};
  double CoincidentArea = 0.0;
  int WarningStatus = CloudFilter::OK;
  std::string Warning;
};

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::Execute()
{
  Failure failure{ CloudFilter::OK, "" };
  try
  {
    this->CheckSettings();
    this->PrepareTool();
    this->PrepareCloud();
    this->Intersect();
    this->AddFields(this->WarningStatus, this->Warning);
    return;
  }
  catch (const Failure& caught)
  {
    failure = caught;
  }
  catch (const std::bad_alloc&)
  {
    failure = { CloudFilter::OUT_OF_MEMORY,
      "The result does not fit into memory; choose a larger ChordError or fewer points." };
  }
  this->Curves->Initialize();
  this->AddFields(failure.Status, failure.Sentence);
  if (failure.Status != CloudFilter::ABORTED)
  {
    vtkErrorWithObjectMacro(this->Filter, << failure.Sentence);
  }
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::CheckSettings()
{
  const auto refuse = [](const std::string& sentence) {
    throw Failure{ CloudFilter::BAD_REQUEST, sentence };
  };
  if (this->Filter->Definition != 0 && this->Filter->Definition != 1)
  {
    refuse("Definition is " + std::to_string(this->Filter->Definition) +
      "; set it to 0 (Unbiased) or 1 (Amenta-Kil).");
  }
  if (!std::isfinite(this->Filter->Width) || this->Filter->Width < 0.0)
  {
    refuse(
      "Width is " + std::to_string(this->Filter->Width) + "; set it to 0 or a positive length.");
  }
  if (!std::isfinite(this->Filter->ChordError) || this->Filter->ChordError < 0.0)
  {
    refuse("ChordError is " + std::to_string(this->Filter->ChordError) +
      "; set it to 0 or a positive length.");
  }
  if (!this->HasTool)
  {
    this->CheckPlane();
  }
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::CheckPlane()
{
  const auto refuse = [](const std::string& sentence) {
    throw Failure{ CloudFilter::BAD_REQUEST, sentence };
  };
  if (!this->Filter->Plane)
  {
    refuse("There is no plane and no Tool; set Plane, or connect a Tool.");
  }
  this->Filter->Plane->GetOrigin(this->Origin.data());
  this->Filter->Plane->GetNormal(this->Normal.data());
  const double length = sb::Length(this->Normal);
  if (!sb::IsFinite(this->Origin) || !(length > 0.0) || !std::isfinite(length))
  {
    refuse("Plane has an origin or a normal that is not finite, or a normal of length zero; set "
           "both anew.");
  }
  this->Normal = sb::Scaled(this->Normal, 1.0 / length);
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::PrepareTool()
{
  if (!this->HasTool)
  {
    return;
  }
  sbvtk::DesignedInput& tool = *this->Filter->Tool;
  const std::string noSurface = tool.Read(this->ToolData, this->Executor);
  if (!noSurface.empty())
  {
    throw Failure{ NOT_A_SURFACE, "Tool " + noSurface };
  }
  if (!tool.Warning().empty())
  {
    this->Warn(FACETS_ONLY, "Tool " + tool.Warning());
  }
  this->Times.push_back({ "Prepare tool", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::Warn(int status, const std::string& sentence)
{
  vtkWarningWithObjectMacro(this->Filter, << sentence);
  if (this->WarningStatus == CloudFilter::OK)
  {
    this->WarningStatus = status;
    this->Warning = sentence;
  }
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::PrepareCloud()
{
  const std::string notPoints = this->Input.Read(this->Data);
  if (!notPoints.empty())
  {
    throw Failure{ CloudFilter::NOT_POINTS, "Input " + notPoints };
  }
  if (!this->Input.Warning().empty())
  {
    this->Warn(CloudFilter::BAD_NORMALS, this->Input.Warning());
  }
  sb::CloudRequest request;
  request.Points = this->Input.Points();
  request.Normals = this->Input.Normals();
  request.Count = this->Input.NumberOfPoints();
  request.Definition = static_cast<sb::SurfaceDefinition>(this->Filter->Definition);
  request.Width = this->Filter->Width;
  request.Flip = this->Filter->FlipNormals != 0;
  sbvtk::KernelMonitor monitor(this->Filter, 0.05, 0.7);
  this->Cloud = sb::MakeCloudSurface(request, this->Executor, monitor);
  const int status = sbvtk::StatusOf(this->Cloud.Status);
  if (status != CloudFilter::OK)
  {
    throw Failure{ status, sbvtk::RefusalOf(this->Cloud, request.Count) };
  }
  this->Times.push_back({ "Prepare cloud", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::Intersect()
{
  const double bound = this->Filter->ChordError > 0.0 ? this->Filter->ChordError
                                                      : ChordErrorInSpacings * this->Cloud.Spacing;
  sbvtk::KernelMonitor monitor(this->Filter, 0.7, 1.0);
  this->BuildCurves(
    this->HasTool ? this->CutWithMesh(bound, monitor) : this->CutWithPlane(bound, monitor));
  this->Times.push_back({ "Intersect", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
std::vector<vtkPointSetIntersectionFilter::Curve> vtkPointSetIntersectionFilter::Run::CutWithPlane(
  double chordError, sb::Monitor& monitor)
{
  sb::PlaneSection section = sb::IntersectPlane(
    *this->Cloud.Surface, this->Origin, this->Normal, chordError, this->Executor, monitor);
  if (section.Aborted)
  {
    throw Failure{ CloudFilter::ABORTED, "The filter was stopped." };
  }
  std::vector<Curve> curves;
  for (sb::SectionCurve& cut : section.Curves)
  {
    Curve curve;
    curve.Closed = cut.Closed;
    std::fill_n(curve.Ends, 2, cut.Closed ? NO_END : SCAN_BORDER);
    curve.ChordError = cut.LargestChordError;
    curve.PlaneNormals.assign(cut.Points.size(), this->Normal);
    curve.Points = std::move(cut.Points);
    curves.push_back(std::move(curve));
  }
  return curves;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSetIntersectionFilter::Curve> vtkPointSetIntersectionFilter::Run::CutWithMesh(
  double chordError, sb::Monitor& monitor)
{
  const sbvtk::DesignedInput& tool = *this->Filter->Tool;
  const sb::DesignedSurface& mesh = tool.Surface();
  sb::MeshSection section = sb::IntersectMesh(
    *this->Cloud.Surface, mesh, { this->Cloud.Spacing, chordError }, this->Executor, monitor);
  if (section.Status == sb::MeshSectionStatus::Aborted)
  {
    throw Failure{ CloudFilter::ABORTED, "The filter was stopped." };
  }
  if (section.Status == sb::MeshSectionStatus::TooLarge)
  {
    throw Failure{ CloudFilter::TOO_LARGE,
      "Tool would have to be cut into more than 2147483647 triangles as small as the spacing of "
      "Input; choose a part of either." };
  }
  if (section.CoincidentArea > 0.0)
  {
    this->CoincidentArea = section.CoincidentArea;
    std::ostringstream sentence;
    sentence << "Tool lies on the surface of Input, within its noise, over an area of "
             << section.CoincidentArea << "; there are no curves there, only up to its border.";
    this->Warn(COINCIDENT_AREA, sentence.str());
  }
  std::vector<Curve> curves;
  for (sb::MeshSectionCurve& cut : section.Curves)
  {
    Curve curve;
    curve.Closed = cut.Closed;
    curve.IsTangential = cut.IsTangential;
    curve.Ends[0] = static_cast<int>(cut.Ends[0]);
    curve.Ends[1] = static_cast<int>(cut.Ends[1]);
    curve.ChordError = cut.LargestChordError;
    for (std::size_t i = 0; i < cut.Points.size(); ++i)
    {
      const std::int32_t triangle = cut.Triangles[std::min(i, cut.Triangles.size() - 1)];
      curve.Cells.push_back(tool.CellOfTriangle(triangle));
      curve.PlaneNormals.push_back(NormalOf(mesh, triangle));
    }
    curve.Points = std::move(cut.Points);
    curves.push_back(std::move(curve));
  }
  return curves;
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::BuildCurves(const std::vector<Curve>& curves)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> normals;
  vtkNew<vtkDoubleArray> curvatures;
  vtkNew<vtkDoubleArray> lengths;
  vtkNew<vtkDoubleArray> errors;
  vtkNew<vtkIntArray> closed;
  vtkNew<vtkIntArray> ends;
  vtkNew<vtkIntArray> tangential;
  vtkNew<vtkIdTypeArray> cells;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  curvatures->SetName("Curvature");
  lengths->SetName("Length");
  errors->SetName("ChordError");
  closed->SetName("Closed");
  ends->SetName("Ends");
  ends->SetNumberOfComponents(2);
  tangential->SetName("Tangential");
  cells->SetName("OriginalCellId");
  sb::MovingLeastSquares::Neighbourhood near;
  for (const Curve& curve : curves)
  {
    // A loop has its first point once, as a point, and twice in its line.
    const std::size_t distinct = curve.Points.size() - (curve.Closed ? 1 : 0);
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(curve.Points.size()));
    double length = 0.0;
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      lines->InsertCellPoint(first + static_cast<vtkIdType>(i < distinct ? i : 0));
      length += i > 0 ? sb::Length(sb::Difference(curve.Points[i], curve.Points[i - 1])) : 0.0;
      if (i < distinct)
      {
        const sb::SurfaceValue f = this->Cloud.Surface->EvaluateAt(curve.Points[i], 2, near);
        const double steepness = sb::Length(f.Gradient);
        const sb::Real3 normal =
          steepness > 0.0 ? sb::Scaled(f.Gradient, 1.0 / steepness) : sb::Real3{};
        points->InsertNextPoint(curve.Points[i].data());
        normals->InsertNextTuple(normal.data());
        curvatures->InsertNextValue(sb::SectionCurvature(f, curve.PlaneNormals[i]));
        if (this->HasTool)
        {
          cells->InsertNextValue(curve.Cells[i]);
        }
      }
    }
    lengths->InsertNextValue(length);
    errors->InsertNextValue(curve.ChordError);
    closed->InsertNextValue(curve.Closed ? 1 : 0);
    ends->InsertNextTypedTuple(curve.Ends);
    tangential->InsertNextValue(curve.IsTangential ? 1 : 0);
  }
  this->Curves->SetPoints(points);
  this->Curves->SetLines(lines);
  this->Curves->GetPointData()->SetNormals(normals);
  this->Curves->GetPointData()->AddArray(curvatures);
  this->Curves->GetCellData()->AddArray(lengths);
  this->Curves->GetCellData()->AddArray(closed);
  this->Curves->GetCellData()->AddArray(errors);
  this->Curves->GetCellData()->AddArray(ends);
  if (this->HasTool)
  {
    this->Curves->GetPointData()->AddArray(cells);
    this->Curves->GetCellData()->AddArray(tangential);
  }
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::AddFields(int status, const std::string& message)
{
  using sbvtk::AddField;
  AddField(this->Curves, "Status", status);
  AddField(this->Curves, "Message", message);
  AddField(this->Curves, "Spacing", this->Cloud.Spacing);
  AddField<vtkDoubleArray>(this->Curves, "Width",
    std::vector<double>{ this->Cloud.Surface ? this->Cloud.Surface->Width() : 0.0 });
  if (this->HasTool)
  {
    AddField(this->Curves, "CoincidentArea", this->CoincidentArea);
  }
  sbvtk::AddStageFields(this->Curves, this->Times);
}

//------------------------------------------------------------------------------
vtkPointSetIntersectionFilter::vtkPointSetIntersectionFilter()
  : Tool(std::make_unique<sbvtk::DesignedInput>())
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkPointSetIntersectionFilter::~vtkPointSetIntersectionFilter() = default;

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::SetPlane(vtkPlane* plane)
{
  if (this->Plane != plane)
  {
    this->Plane = plane;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPlane* vtkPointSetIntersectionFilter::GetPlane() { return this->Plane; }

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSetIntersectionFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Plane ? std::max(own, this->Plane->GetMTime()) : own;
}

//------------------------------------------------------------------------------
int vtkPointSetIntersectionFilter::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object, and optional: others get a sentence of ours instead of the pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPointSetIntersectionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  vtkPolyData* curves = vtkPolyData::GetData(outputs, 0);
  sbvtk::RunWithThreads(
    this->NumberOfThreads, [&] { Run(this, input, inputs[1], curves).Execute(); });
  this->SetAbortOutput(
    false); // a run that was stopped says so in its field data, which the pipeline would clear
  return 1;
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Plane: " << this->Plane.GetPointer() << "\n";
  os << indent << "ChordError: " << this->ChordError << "\n";
  os << indent << "Definition: " << this->Definition << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "FlipNormals: " << this->FlipNormals << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
