// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSetIntersectionFilter.h"

#include "CloudCurves.h"
#include "CloudInput.h"
#include "CloudSentences.h"
#include "CloudSurface.h"
#include "CommonPoint.h"
#include "DesignedInput.h"
#include "FieldArrays.h"
#include "KernelExecutor.h"
#include "MeshSection.h"
#include "NURBSSection.h"
#include "PlaneSection.h"
#include "Stopwatch.h"
#include "vtkPointSetSurfaceFilter.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
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
constexpr double LeastChordErrorInSpacings = 1e-8; ///< less costs much and is lost in rounding
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

/** One update: its steps in their order, and what they share. */
class vtkPointSetIntersectionFilter::Run
{
public:
  Run(vtkPointSetIntersectionFilter* filter, vtkDataObject* input, vtkInformationVector* tool,
    vtkPolyData* output)
    : Filter(filter)
    , Data(input)
    , HasTool(tool && tool->GetNumberOfInformationObjects() > 0)
    , ToolData(this->HasTool ? vtkDataObject::GetData(tool, 0) : nullptr)
    , Output(output)
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
  using Curves = std::vector<sbvtk::CloudCurve>;
  Curves CutWithPlane(double chordError, sb::Monitor& monitor);
  Curves CutWithMesh(double chordError, sb::Monitor& monitor);
  Curves CutWithPatches(double chordError, sb::Monitor& monitor);
  void StopIf(bool isAborted);
  void TellOfArea(double area);
  void Warn(int status, const std::string& sentence);
  void AddFields(int status, const std::string& message);

  vtkPointSetIntersectionFilter* Filter;
  vtkDataObject* Data;
  bool HasTool;
  vtkDataObject* ToolData;
  vtkPolyData* Output;
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
    sbvtk::StopIfAsked(this->Filter);
    return;
  }
  catch (const Failure& caught)
  {
    failure = caught;
  }
  catch (const sbvtk::Stopped&)
  {
    failure = { CloudFilter::ABORTED, "The filter was stopped." };
  }
  catch (const std::bad_alloc&)
  {
    failure = { CloudFilter::OUT_OF_MEMORY,
      "The result does not fit into memory; choose a larger ChordError or fewer points." };
  }
  this->Output->Initialize();
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
  const double bound = this->Filter->ChordError > 0.0
    ? std::max(this->Filter->ChordError, LeastChordErrorInSpacings * this->Cloud.Spacing)
    : ChordErrorInSpacings * this->Cloud.Spacing;
  sbvtk::KernelMonitor monitor(this->Filter, 0.7, 1.0);
  const sbvtk::CutWith cutter = !this->HasTool   ? sbvtk::CutWith::Plane
    : this->Filter->Tool->Surface().HasPatches() ? sbvtk::CutWith::Patches
                                                 : sbvtk::CutWith::Mesh;
  const Curves curves = cutter == sbvtk::CutWith::Plane ? this->CutWithPlane(bound, monitor)
    : cutter == sbvtk::CutWith::Mesh                    ? this->CutWithMesh(bound, monitor)
                                                        : this->CutWithPatches(bound, monitor);
  sbvtk::BuildCurves(curves, *this->Cloud.Surface, cutter, this->Output);
  this->Times.push_back({ "Intersect", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
auto vtkPointSetIntersectionFilter::Run::CutWithPlane(double chordError, sb::Monitor& monitor)
  -> Curves
{
  sb::PlaneSection section = sb::IntersectPlane(
    *this->Cloud.Surface, this->Origin, this->Normal, chordError, this->Executor, monitor);
  this->StopIf(section.Aborted);
  Curves curves;
  for (sb::SectionCurve& cut : section.Curves)
  {
    sbvtk::CloudCurve curve;
    curve.Closed = cut.Closed;
    curve.Ends.fill(cut.Closed ? sb::CurveEnd::None : sb::CurveEnd::ScanBorder);
    curve.ChordError = cut.LargestChordError;
    curve.Places.resize(cut.Points.size());
    for (sbvtk::CurvePlace& place : curve.Places)
    {
      place.Normal = this->Normal;
    }
    curve.Points = std::move(cut.Points);
    curves.push_back(std::move(curve));
  }
  return curves;
}

//------------------------------------------------------------------------------
auto vtkPointSetIntersectionFilter::Run::CutWithMesh(double chordError, sb::Monitor& monitor)
  -> Curves
{
  const sbvtk::DesignedInput& tool = *this->Filter->Tool;
  sb::MeshSection section = sb::IntersectMesh(*this->Cloud.Surface, tool.Surface(),
    { this->Cloud.Spacing, chordError }, this->Executor, monitor);
  this->StopIf(section.Status == sb::MeshSectionStatus::Aborted);
  if (section.Status == sb::MeshSectionStatus::TooLarge)
  {
    throw Failure{ CloudFilter::TOO_LARGE,
      "Tool would have to be cut into more than 2147483647 triangles as small as the spacing of "
      "Input; choose a part of either." };
  }
  this->TellOfArea(section.CoincidentArea);
  Curves curves;
  for (sb::MeshSectionCurve& cut : section.Curves)
  {
    sbvtk::CloudCurve curve;
    curve.Closed = cut.Closed;
    curve.IsTangential = cut.IsTangential;
    curve.Ends = cut.Ends;
    curve.ChordError = cut.LargestChordError;
    for (std::size_t i = 0; i < cut.Points.size(); ++i)
    {
      const std::int32_t triangle = cut.Triangles[std::min(i, cut.Triangles.size() - 1)];
      sbvtk::CurvePlace place;
      place.Cell = tool.CellOfTriangle(triangle);
      place.Normal = NormalOf(tool.Surface(), triangle);
      curve.Places.push_back(place);
    }
    curve.Points = std::move(cut.Points);
    curves.push_back(std::move(curve));
  }
  return curves;
}

//------------------------------------------------------------------------------
auto vtkPointSetIntersectionFilter::Run::CutWithPatches(double chordError, sb::Monitor& monitor)
  -> Curves
{
  const sb::DesignedSurface& body = this->Filter->Tool->Surface();
  sb::NURBSSection section = sb::IntersectPatches(
    *this->Cloud.Surface, body, { this->Cloud.Spacing, chordError }, this->Executor, monitor);
  this->StopIf(section.Aborted);
  this->TellOfArea(section.CoincidentArea);
  sb::MovingLeastSquares::Neighbourhood near;
  Curves curves;
  for (sb::NURBSCurve& cut : section.Curves)
  {
    sbvtk::CloudCurve curve;
    curve.Closed = cut.Closed;
    curve.IsTangential = cut.IsTangential;
    curve.Ends = cut.Ends;
    curve.ChordError = cut.LargestChordError;
    for (std::size_t i = 0; i < cut.Points.size(); ++i)
    {
      sbvtk::CurvePlace place;
      place.Face = cut.FaceId[i];
      place.UV = cut.UV[i];
      place.CurvatureVector =
        sb::CurvatureOfCommonCurve(this->Cloud.Surface->EvaluateAt(cut.Points[i], 2, near),
          sb::EvaluatePatch(
            body.Patches[static_cast<std::size_t>(place.Face)], place.UV[0], place.UV[1], 2));
      curve.Places.push_back(place);
    }
    curve.Points = std::move(cut.Points);
    curves.push_back(std::move(curve));
  }
  return curves;
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::StopIf(bool isAborted)
{
  if (isAborted)
  {
    throw Failure{ CloudFilter::ABORTED, "The filter was stopped." };
  }
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::TellOfArea(double area)
{
  this->CoincidentArea = area;
  if (area > 0.0)
  {
    std::ostringstream sentence;
    sentence << "Tool lies on the surface of Input, within its noise, over an area of " << area
             << "; there are no curves there, only up to its border.";
    this->Warn(COINCIDENT_AREA, sentence.str());
  }
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::AddFields(int status, const std::string& message)
{
  using sbvtk::AddField;
  AddField(this->Output, "Status", status);
  AddField(this->Output, "Message", message);
  AddField(this->Output, "Spacing", this->Cloud.Spacing);
  AddField<vtkDoubleArray>(this->Output, "Width",
    std::vector<double>{ this->Cloud.Surface ? this->Cloud.Surface->Width() : 0.0 });
  if (this->HasTool)
  {
    AddField(this->Output, "CoincidentArea", this->CoincidentArea);
  }
  sbvtk::AddStageFields(this->Output, this->Times);
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
