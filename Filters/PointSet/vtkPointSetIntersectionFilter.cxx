// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSetIntersectionFilter.h"

#include "CloudCurves.h"
#include "CloudRun.h"
#include "CommonPoint.h"
#include "DesignedInput.h"
#include "FieldArrays.h"
#include "MeshSection.h"
#include "NURBSSection.h"
#include "PlaneSection.h"
#include "TimeSteps.h"
#include "vtkPointSetSurfaceFilter.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
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
class vtkPointSetIntersectionFilter::Run : public sbvtk::CloudRun
{
public:
  Run(vtkPointSetIntersectionFilter* filter, vtkDataObject* input, vtkInformationVector* tool,
    vtkPolyData* output)
    : CloudRun(filter, input, *filter->Cloud, { output })
    , Filter(filter)
    , HasTool(tool && tool->GetNumberOfInformationObjects() > 0)
    , ToolData(this->HasTool ? vtkDataObject::GetData(tool, 0) : nullptr)
    , Output(output)
  {
  }

private:
  void TakeSteps() override;
  void CheckPlane();
  void PrepareTool();
  void Intersect();
  using Curves = std::vector<sbvtk::CloudCurve>;
  Curves CutWithPlane(double chordError, sb::Monitor& monitor);
  Curves CutWithMesh(double chordError, sb::Monitor& monitor);
  Curves CutWithPatches(double chordError, sb::Monitor& monitor);
  void StopIf(bool isAborted);
  void TellOfArea(double area);
  void TellOfTouches(const std::vector<sb::SurfaceTouch>& touches);
  void AddFields(int status, const std::string& message) override;
  std::string AdviceOnMemory() const override
  {
    return "choose a larger ChordError or fewer points";
  }

  vtkPointSetIntersectionFilter* Filter;
  bool HasTool;
  vtkDataObject* ToolData;
  vtkPolyData* Output;
  sb::Real3 Origin{};
  sb::Real3 Normal{};
  double CoincidentArea = 0.0;
  std::int64_t NumberOfTouches = 0;
};

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::TakeSteps()
{
  CheckDefinition(this->Filter->Definition);
  CheckLength("Width", this->Filter->Width);
  CheckLength("ChordError", this->Filter->ChordError);
  if (!this->HasTool)
  {
    this->CheckPlane();
  }
  this->PrepareTool();
  this->ReadCloud();
  this->PrepareCloud(
    { this->Filter->Definition, this->Filter->Width, this->Filter->FlipNormals != 0 }, 0.05, 0.7);
  this->Times.push_back({ "Prepare cloud", this->Watch.Lap() });
  this->Intersect();
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
  if (this->HasTool)
  {
    sbvtk::MarkBlocks(*this->Filter->Tool, this->Output);
  }
  this->Times.push_back({ "Intersect", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
auto vtkPointSetIntersectionFilter::Run::CutWithPlane(double chordError, sb::Monitor& monitor)
  -> Curves
{
  sb::PlaneSection section = sb::IntersectPlane(
    *this->Cloud.Surface, this->Origin, this->Normal, chordError, this->Executor, monitor);
  this->StopIf(section.Aborted);
  this->TellOfTouches(section.Touches);
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
  this->TellOfTouches(section.Touches);
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
  this->TellOfTouches(section.Touches);
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
    throw sbvtk::Stopped();
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
/** Neither noise nor the mesh can tell whether there is a curve, smaller than two spacings. */
void vtkPointSetIntersectionFilter::Run::TellOfTouches(const std::vector<sb::SurfaceTouch>& touches)
{
  this->NumberOfTouches = static_cast<std::int64_t>(touches.size());
  if (touches.empty())
  {
    return;
  }
  const sb::SurfaceTouch& nearest = *std::min_element(touches.begin(), touches.end(),
    [](const sb::SurfaceTouch& a, const sb::SurfaceTouch& b) { return a.Distance < b.Distance; });
  std::ostringstream sentence;
  sentence << (this->HasTool ? "Tool" : "Plane") << " touches the surface of Input at "
           << touches.size() << (touches.size() == 1 ? " place" : " places")
           << " without crossing it, so that there is no curve: it comes as near as "
           << nearest.Distance << " at (" << nearest.Place[0] << ", " << nearest.Place[1] << ", "
           << nearest.Place[2] << "); move it if it should cut.";
  this->Warn(TOUCHING, sentence.str());
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::AddFields(int status, const std::string& message)
{
  this->AddCloudFields(this->Output, status, message);
  sbvtk::AddCount(this->Output, "NumberOfTouches", this->NumberOfTouches);
  if (this->HasTool)
  {
    sbvtk::AddField(this->Output, "CoincidentArea", this->CoincidentArea);
  }
  sbvtk::AddStageFields(this->Output, this->Times);
}

//------------------------------------------------------------------------------
vtkPointSetIntersectionFilter::vtkPointSetIntersectionFilter()
  : Cloud(std::make_unique<sbvtk::PreparedCloud>())
  , Tool(std::make_unique<sbvtk::DesignedInput>())
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
int vtkPointSetIntersectionFilter::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::UniteTimeSteps(inputs, this->GetNumberOfInputPorts(), outputs);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  vtkPolyData* curves = vtkPolyData::GetData(outputs, 0);
  sbvtk::RunWithThreads(
    this->NumberOfThreads, [&] { Run(this, input, inputs[1], curves).Execute(); });
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
