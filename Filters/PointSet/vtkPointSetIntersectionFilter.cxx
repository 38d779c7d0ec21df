// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSetIntersectionFilter.h"

#include "CloudInput.h"
#include "CloudSentences.h"
#include "CloudSurface.h"
#include "FieldArrays.h"
#include "KernelExecutor.h"
#include "PlaneSection.h"
#include "Stopwatch.h"
#include "vtkPointSetSurfaceFilter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
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
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPointSetIntersectionFilter);

namespace
{
constexpr double ChordErrorInSpacings = 0.1;
using StatusType = vtkPointSetSurfaceFilter::StatusType;
}

/** One update: its steps in their order, and what they share. */
class vtkPointSetIntersectionFilter::Run
{
public:
  Run(vtkPointSetIntersectionFilter* filter, vtkDataObject* input, vtkPolyData* curves)
    : Filter(filter)
    , Data(input)
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
  void Prepare();
  void Intersect();
  void BuildCurves(const sb::PlaneSection& section);
  void AddFields(int status, const std::string& message);

  vtkPointSetIntersectionFilter* Filter;
  vtkDataObject* Data;
  vtkPolyData* Curves;
  sbvtk::CloudInput Input;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  std::vector<sb::StageTime> Times;
  sb::CloudSurface Cloud;
  sb::Real3 Origin{};
  sb::Real3 Normal{};
  std::string Warning;
};

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::Execute()
{
  Failure failure{ StatusType::OK, "" };
  try
  {
    this->CheckSettings();
    this->Prepare();
    this->Intersect();
    this->AddFields(
      this->Warning.empty() ? StatusType::OK : StatusType::BAD_NORMALS, this->Warning);
    return;
  }
  catch (const Failure& caught)
  {
    failure = caught;
  }
  catch (const std::bad_alloc&)
  {
    failure = { StatusType::OUT_OF_MEMORY,
      "The result does not fit into memory; choose a larger ChordError or fewer points." };
  }
  this->Curves->Initialize();
  this->AddFields(failure.Status, failure.Sentence);
  if (failure.Status != StatusType::ABORTED)
  {
    vtkErrorWithObjectMacro(this->Filter, << failure.Sentence);
  }
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::CheckSettings()
{
  const auto refuse = [](const std::string& sentence) {
    throw Failure{ StatusType::BAD_REQUEST, sentence };
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
  if (!this->Filter->Plane)
  {
    refuse("There is no plane; set Plane.");
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
void vtkPointSetIntersectionFilter::Run::Prepare()
{
  const std::string notPoints = this->Input.Read(this->Data);
  if (!notPoints.empty())
  {
    throw Failure{ StatusType::NOT_POINTS, "Input " + notPoints };
  }
  this->Warning = this->Input.Warning();
  if (!this->Warning.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << this->Warning);
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
  if (status != StatusType::OK)
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
  const sb::PlaneSection section = sb::IntersectPlane(
    *this->Cloud.Surface, this->Origin, this->Normal, bound, this->Executor, monitor);
  if (section.Aborted)
  {
    throw Failure{ StatusType::ABORTED, "The filter was stopped." };
  }
  this->BuildCurves(section);
  this->Times.push_back({ "Intersect", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkPointSetIntersectionFilter::Run::BuildCurves(const sb::PlaneSection& section)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> normals;
  vtkNew<vtkDoubleArray> curvatures;
  vtkNew<vtkDoubleArray> lengths;
  vtkNew<vtkDoubleArray> errors;
  vtkNew<vtkIntArray> closed;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  curvatures->SetName("Curvature");
  lengths->SetName("Length");
  errors->SetName("ChordError");
  closed->SetName("Closed");
  sb::MovingLeastSquares::Neighbourhood near;
  for (const sb::SectionCurve& curve : section.Curves)
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
        curvatures->InsertNextValue(sb::SectionCurvature(f, this->Normal));
      }
    }
    lengths->InsertNextValue(length);
    errors->InsertNextValue(curve.LargestChordError);
    closed->InsertNextValue(curve.Closed ? 1 : 0);
  }
  this->Curves->SetPoints(points);
  this->Curves->SetLines(lines);
  this->Curves->GetPointData()->SetNormals(normals);
  this->Curves->GetPointData()->AddArray(curvatures);
  this->Curves->GetCellData()->AddArray(lengths);
  this->Curves->GetCellData()->AddArray(closed);
  this->Curves->GetCellData()->AddArray(errors);
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
  sbvtk::AddStageFields(this->Curves, this->Times);
}

//------------------------------------------------------------------------------
vtkPointSetIntersectionFilter::vtkPointSetIntersectionFilter() = default;

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
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, input, curves).Execute(); });
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
