// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataDistance.h"

#include "DistanceMap.h"
#include "DistanceSurface.h"
#include "FieldArrays.h"
#include "KernelExecutor.h"
#include "SamplePlaces.h"
#include "SurfaceConnections.h"
#include "SurfaceInput.h"
#include "TimeSteps.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPolyDataDistance);

/** What is kept from one update to the next. */
struct vtkPolyDataDistance::Cache
{
  sbvtk::SurfaceInput Tool;
  sbvtk::DistanceSurface ToolSurface;
  sbvtk::SurfaceInput Input;
  sbvtk::DistanceSurface InputSurface;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataDistance::Run
{
public:
  Run(vtkPolyDataDistance* filter, vtkInformationVector** inputs, vtkInformationVector* outputs)
    : Filter(filter)
    , Input(vtkDataObject::GetData(inputs[0], 0))
    , Tool(vtkDataObject::GetData(inputs[1], 0))
    , First(vtkDataObject::GetData(outputs, 0))
    , Second(vtkPolyData::GetData(outputs, 1))
  {
  }

  void Execute();

private:
  using Remark = sbvtk::DistanceSurface::Remark;

  void CheckSettings() const;
  void ReadTool();
  void MapInput();
  void MapTool();
  void PrepareInput();
  sbvtk::DistanceOptions Options() const;
  void CopyInput();
  void Note(const Remark& remark);
  void NoteBadPoints(const sbvtk::DistanceMap& map, const std::string& name);
  void Fail(const Remark& failure);

  vtkPolyDataDistance* Filter;
  vtkDataObject* Input;
  vtkDataObject* Tool;
  vtkDataObject* First;
  vtkPolyData* Second;
  sbvtk::KernelExecutor Executor;
  std::vector<vtkDataSet*> Leaves; ///< of output 0
  Remark Gravest;
  double InputToTool = 0.0;
};

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::Execute()
{
  try
  {
    this->CheckSettings();
    this->ReadTool();
    this->MapInput();
    this->MapTool();
    for (vtkDataObject* output : { this->First, static_cast<vtkDataObject*>(this->Second) })
    {
      sbvtk::AddField(output, "Status", this->Gravest.Status);
      sbvtk::AddField(output, "Message",
        this->Gravest.Sentence.empty() ? std::string("The result is complete.")
                                       : this->Gravest.Sentence);
    }
    sbvtk::StopIfAsked(this->Filter);
  }
  catch (const Remark& failure)
  {
    this->Fail(failure);
  }
  catch (const sbvtk::Stopped&)
  {
    const sbvtk::FilterFailure stopped = sbvtk::FailureOf(sb::Status::Aborted);
    this->Fail({ stopped.Status, stopped.Sentence, true });
  }
  catch (const std::bad_alloc&)
  {
    this->Fail({ OUT_OF_MEMORY,
      "The result does not fit into memory; decimate the Tool or close other data first.", true });
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::CheckSettings() const
{
  const int badRequest = static_cast<int>(sb::Status::BadRequest);
  const double limit = this->Filter->MaximumDistance;
  if (!std::isfinite(limit) || limit < 0.0)
  {
    throw Remark{ badRequest,
      "MaximumDistance is " + std::to_string(limit) +
        "; set it to 0 (no limit) or a positive length.",
      true };
  }
  if (!this->Input)
  {
    throw Remark{ badRequest,
      "Input has no data; set Input (in ParaView: right-click the filter in the Pipeline Browser, "
      "Change Input).",
      true };
  }
  if (!vtkDataSet::SafeDownCast(this->Input) && !vtkCompositeDataSet::SafeDownCast(this->Input))
  {
    throw Remark{ NOT_A_SURFACE,
      std::string("Input is of type ") + this->Input->GetClassName() +
        ", which has no points; choose a surface, a grid or a cloud of points.",
      true };
  }
  if (!this->Tool)
  {
    throw Remark{ MISSING_TOOL,
      "Distances need a surface to be measured to, but Tool has none; set Tool (in ParaView: "
      "right-click the filter in the Pipeline Browser, Change Input).",
      true };
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::ReadTool()
{
  Cache& kept = *this->Filter->Kept;
  const std::string refusal = kept.Tool.Read(this->Tool, this->Executor);
  if (!refusal.empty())
  {
    throw Remark{ NOT_A_SURFACE, "Tool " + refusal, true };
  }
  this->Note(kept.ToolSurface.Prepare(kept.Tool.Surface(), "Tool", this->Executor));
}

//------------------------------------------------------------------------------
/** An error ends the update; a reservation about signs matters only where there are any. */
void vtkPolyDataDistance::Run::Note(const Remark& remark)
{
  if (remark.IsError)
  {
    throw remark;
  }
  const bool byNormals =
    this->Filter->SignedDistance && this->Filter->SignMethod == VTK_PSEUDONORMAL;
  const bool aboutSigns = remark.Status != POINTS_NOT_FINITE;
  if (!remark.Sentence.empty() && (byNormals || !aboutSigns))
  {
    vtkWarningWithObjectMacro(this->Filter, << remark.Sentence);
    this->Gravest = this->Gravest.Sentence.empty() ? remark : this->Gravest;
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::NoteBadPoints(const sbvtk::DistanceMap& map, const std::string& name)
{
  if (map.NumberOfBadPoints() > 0)
  {
    this->Note({ POINTS_NOT_FINITE,
      name + " has points with coordinates that are not finite numbers (" +
        std::to_string(map.NumberOfBadPoints()) +
        "), so their Distance is NaN; remove or repair "
        "them first.",
      false });
  }
}

//------------------------------------------------------------------------------
sbvtk::DistanceOptions vtkPolyDataDistance::Run::Options() const
{
  sbvtk::DistanceOptions options;
  options.Rule = !this->Filter->SignedDistance       ? sb::SignRule::Unsigned
    : this->Filter->SignMethod == VTK_WINDING_NUMBER ? sb::SignRule::WindingNumber
                                                     : sb::SignRule::Pseudonormal;
  options.Negate = this->Filter->NegateDistance != 0;
  options.CellCenters = this->Filter->ComputeCellCenterDistance != 0;
  options.NearestPoint = this->Filter->ComputeNearestPoint != 0;
  options.NearestCellId = this->Filter->ComputeNearestCellId != 0;
  options.Direction = this->Filter->ComputeDirection != 0;
  options.Limit = this->Filter->MaximumDistance > 0.0 ? this->Filter->MaximumDistance
                                                      : std::numeric_limits<double>::infinity();
  return options;
}

//------------------------------------------------------------------------------
/** Output 0 becomes a shallow copy of the Input. */
void vtkPolyDataDistance::Run::CopyInput()
{
  vtkCompositeDataSet* blocks = vtkCompositeDataSet::SafeDownCast(this->Input);
  if (!blocks)
  {
    this->First->ShallowCopy(this->Input);
    this->Leaves = { vtkDataSet::SafeDownCast(this->First) };
    return;
  }
  vtkCompositeDataSet* copies = vtkCompositeDataSet::SafeDownCast(this->First);
  copies->CopyStructure(blocks);
  copies->GetFieldData()->PassData(blocks->GetFieldData());
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    const auto copy = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
    copy->ShallowCopy(leaf);
    copies->SetDataSet(iterator, copy);
    if (vtkDataSet* data = vtkDataSet::SafeDownCast(copy))
    {
      this->Leaves.push_back(data);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::MapInput()
{
  sbvtk::KernelMonitor monitor(this->Filter, 0.2, this->Filter->ComputeSecondDistance ? 0.6 : 0.95);
  sbvtk::DistanceMap map(this->Filter->Kept->ToolSurface, this->Options());
  this->CopyInput();
  for (vtkDataSet* leaf : this->Leaves)
  {
    if (!map.AddTo(leaf, this->Executor, monitor))
    {
      throw sbvtk::Stopped();
    }
  }
  this->NoteBadPoints(map, "Input");
  const sb::DistanceSummary summary = map.Summary();
  this->InputToTool = summary.LargestMagnitude;
  sbvtk::AddSummaryFields(this->First, summary);
  sbvtk::AddField(this->First, "HausdorffInputToTool", this->InputToTool);
}

//------------------------------------------------------------------------------
/** The Input as something to measure distances to: its polygons, or else its points. */
void vtkPolyDataDistance::Run::PrepareInput()
{
  Cache& kept = *this->Filter->Kept;
  if (kept.Input.Read(this->Input, this->Executor).empty())
  {
    vtkPolyData* surface = kept.Input.Surface();
    if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
    {
      this->Note(kept.InputSurface.Prepare(surface, "Input", this->Executor));
      return;
    }
  }
  std::vector<double> points;
  for (vtkDataSet* leaf : this->Leaves)
  {
    const sbvtk::SamplePlaces places = sbvtk::SamplePlaces::Points(leaf, this->Executor);
    points.insert(points.end(), places.Coordinates(), places.Coordinates() + 3 * places.Count());
  }
  this->Note(kept.InputSurface.PreparePoints(std::move(points), "Input", this->Executor));
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::MapTool()
{
  this->Second->ShallowCopy(this->Filter->Kept->Tool.Surface());
  if (!this->Filter->ComputeSecondDistance)
  {
    return;
  }
  this->PrepareInput();
  sbvtk::KernelMonitor monitor(this->Filter, 0.6, 0.95);
  sbvtk::DistanceMap map(this->Filter->Kept->InputSurface, this->Options());
  if (!map.AddTo(this->Second, this->Executor, monitor))
  {
    throw sbvtk::Stopped();
  }
  const sb::DistanceSummary summary = map.Summary();
  sbvtk::AddSummaryFields(this->Second, summary);
  for (vtkDataObject* output : { this->First, static_cast<vtkDataObject*>(this->Second) })
  {
    sbvtk::AddField(output, "HausdorffInputToTool", this->InputToTool);
    sbvtk::AddField(output, "HausdorffToolToInput", summary.LargestMagnitude);
    sbvtk::AddField(
      output, "HausdorffDistance", std::max(this->InputToTool, summary.LargestMagnitude));
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::Fail(const Remark& failure)
{
  for (vtkDataObject* output : { this->First, static_cast<vtkDataObject*>(this->Second) })
  {
    output->Initialize();
    sbvtk::AddField(output, "Status", failure.Status);
    sbvtk::AddField(output, "Message", failure.Sentence);
  }
  if (failure.Status != static_cast<int>(sb::Status::Aborted))
  {
    vtkErrorWithObjectMacro(this->Filter, << failure.Sentence);
  }
}

//------------------------------------------------------------------------------
vtkPolyDataDistance::vtkPolyDataDistance()
  : Kept(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPolyDataDistance::~vtkPolyDataDistance() = default;

//------------------------------------------------------------------------------
int vtkPolyDataDistance::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object: composite ones come whole, and others get a sentence of ours instead of the
  // pipeline's. Nor is one required by the pipeline: its error would not say what to do.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPolyDataDistance::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
/** Output 0 is of the Input's type. */
int vtkPolyDataDistance::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  const bool usable = vtkDataSet::SafeDownCast(input) || vtkCompositeDataSet::SafeDownCast(input);
  const char* wanted = usable ? input->GetClassName() : "vtkPolyData";
  vtkDataObject* output = vtkDataObject::GetData(outputs, 0);
  if (!output || std::string(output->GetClassName()) != wanted)
  {
    vtkSmartPointer<vtkDataObject> made;
    if (usable)
    {
      made.TakeReference(input->NewInstance());
    }
    else
    {
      made = vtkSmartPointer<vtkPolyData>::New();
    }
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  if (!vtkDataObject::GetData(outputs, 1))
  {
    const auto made = vtkSmartPointer<vtkPolyData>::New();
    outputs->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPolyDataDistance::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::UniteTimeSteps(inputs, this->GetNumberOfInputPorts(), outputs);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkPolyDataDistance::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, inputs, outputs).Execute(); });
  this->SetAbortOutput(
    false); // a run that was stopped says so in its field data, which the pipeline would clear
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SignedDistance: " << this->SignedDistance << "\n";
  os << indent << "NegateDistance: " << this->NegateDistance << "\n";
  os << indent << "ComputeSecondDistance: " << this->ComputeSecondDistance << "\n";
  os << indent << "SignMethod: " << this->SignMethod << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "ComputeCellCenterDistance: " << this->ComputeCellCenterDistance << "\n";
  os << indent << "ComputeNearestPoint: " << this->ComputeNearestPoint << "\n";
  os << indent << "ComputeNearestCellId: " << this->ComputeNearestCellId << "\n";
  os << indent << "ComputeDirection: " << this->ComputeDirection << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
