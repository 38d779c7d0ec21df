// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataDistance.h"

#include "ArrayMemory.h"
#include "ArrayRanges.h"
#include "BlockNames.h"
#include "DistanceMap.h"
#include "DistanceSurface.h"
#include "FieldArrays.h"
#include "KernelExecutor.h"
#include "RankGathering.h"
#include "SamplePlaces.h"
#include "SurfaceConnections.h"
#include "SurfaceInput.h"
#include "TimeSteps.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <new>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPolyDataDistance);

/** What is kept from one update to the next. */
struct vtkPolyDataDistance::Cache
{
  sbvtk::RankGathering Ranks;
  sbvtk::SurfaceInput ToolPiece; ///< of this process
  sbvtk::SurfaceInput Tool;
  sbvtk::DistanceSurface ToolSurface;
  sbvtk::SurfaceInput Input;
  sbvtk::DistanceSurface InputSurface;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataDistance::Run
{
public:
  Run(vtkPolyDataDistance* filter, vtkInformationVector** inputs, vtkInformationVector* outputs,
    int outputPort)
    : Filter(filter)
    , Ranks(filter->Kept->Ranks)
    , Input(vtkDataObject::GetData(inputs[0], 0))
    , Tool(vtkDataObject::GetData(inputs[1], 0))
    , First(vtkDataObject::GetData(outputs, 0))
    , Second(vtkPolyData::GetData(outputs, 1))
    , Asked(outputs->GetInformationObject(std::max(0, outputPort)))
  {
  }

  void Execute();

private:
  using Remark = sbvtk::DistanceSurface::Remark;

  void Alone(const std::function<void()>& step);
  void CheckSettings() const;
  void ReadTool(vtkDataObject* whole);
  void MapInput();
  void MapTool();
  sb::DistanceSummary Summary(const std::vector<vtkDataSet*>& leaves);
  void SummarizeInput();
  void SummarizeTool();
  vtkSmartPointer<vtkDataObject> WholeInput();
  std::vector<double> PointsOf(const std::vector<vtkDataSet*>& leaves);
  void PrepareInput(vtkDataObject* whole);
  void BringTogether();
  sbvtk::DistanceOptions Options() const;
  void CopyInput();
  void Note(const Remark& remark);
  void NoteBadPoints(std::int64_t count);
  void Fail(const Remark& failure);

  vtkPolyDataDistance* Filter;
  sbvtk::RankGathering& Ranks;
  vtkDataObject* Input;
  vtkDataObject* Tool;
  vtkDataObject* First;
  vtkPolyData* Second;
  vtkInformation* Asked; ///< of the output that is asked for
  sbvtk::KernelExecutor Executor;
  std::vector<vtkDataSet*> Leaves; ///< of output 0
  std::vector<double> Distances; ///< measured last
  Remark Gravest;
  std::int64_t BadPoints = 0; ///< of the Input
  double InputToTool = 0.0;
};

namespace
{

void FillPlaces(
  const std::vector<double>& coordinates, const std::vector<double>& distances, vtkPolyData* places)
{
  vtkNew<vtkPoints> points;
  points->SetData(sbvtk::ArrayOf<vtkDoubleArray>("Points", 3, coordinates));
  places->SetPoints(points);
  places->GetPointData()->AddArray(sbvtk::ArrayOf<vtkDoubleArray>("Distance", 1, distances));
}

std::vector<double> DistancesOf(vtkPolyData* places)
{
  auto* values = vtkDoubleArray::FastDownCast(places->GetPointData()->GetArray("Distance"));
  return { values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues() };
}

/** Do it. @return what went wrong, an error if anything did */
sbvtk::DistanceSurface::Remark Try(const std::function<void()>& work)
{
  try
  {
    work();
    return {};
  }
  catch (const sbvtk::DistanceSurface::Remark& failure)
  {
    return failure;
  }
  catch (const sbvtk::Stopped&)
  {
    const sbvtk::FilterFailure stopped = sbvtk::FailureOf(sb::Status::Aborted);
    return { stopped.Status, stopped.Sentence, true };
  }
  catch (const std::bad_alloc&)
  {
    return { vtkPolyDataDistance::OUT_OF_MEMORY,
      "The result does not fit into memory; decimate the Tool or close other data first.", true };
  }
}

} // namespace

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::Execute()
{
  using Receiver = sbvtk::RankGathering::Receiver;
  const Remark failure = Try([this] {
    this->Alone([this] { this->CheckSettings(); });
    const vtkSmartPointer<vtkDataObject> tool = this->Ranks.Gather(this->Tool, 1, 0, Receiver::All);
    this->Alone([&] {
      this->ReadTool(tool);
      this->MapInput();
    });
    this->SummarizeInput();
    if (this->Filter->ComputeSecondDistance)
    {
      const vtkSmartPointer<vtkDataObject> input = this->WholeInput();
      this->Alone([&] {
        this->PrepareInput(input);
        this->MapTool();
      });
      this->SummarizeTool();
    }
    for (vtkDataObject* output : { this->First, static_cast<vtkDataObject*>(this->Second) })
    {
      sbvtk::AddField(output, "Status", this->Gravest.Status);
      sbvtk::AddField(output, "Message",
        this->Gravest.Sentence.empty() ? std::string("The result is complete.")
                                       : this->Gravest.Sentence);
    }
    this->Alone([this] { sbvtk::StopIfAsked(this->Filter); });
  });
  if (failure.IsError)
  {
    this->Fail(failure);
  }
  this->BringTogether();
}

//------------------------------------------------------------------------------
/** A step that this process takes by itself; what goes wrong in one process ends the update in
 * all, with the sentence of the first. */
void vtkPolyDataDistance::Run::Alone(const std::function<void()>& step)
{
  if (!this->Ranks.IsParallel())
  {
    step();
    return;
  }
  Remark failure = Try(step);
  if (this->Ranks.InAll(!failure.IsError))
  {
    return;
  }
  std::vector<char> bytes;
  if (failure.IsError)
  {
    bytes.resize(sizeof failure.Status);
    std::memcpy(bytes.data(), &failure.Status, sizeof failure.Status);
    bytes.insert(bytes.end(), failure.Sentence.begin(), failure.Sentence.end());
  }
  this->Ranks.DistributeFirstOf(bytes);
  std::memcpy(&failure.Status, bytes.data(), sizeof failure.Status);
  failure.Sentence.assign(bytes.begin() + sizeof failure.Status, bytes.end());
  failure.IsError = true;
  throw failure;
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
void vtkPolyDataDistance::Run::ReadTool(vtkDataObject* whole)
{
  Cache& kept = *this->Filter->Kept;
  std::string refusal = kept.Tool.Read(whole, this->Executor);
  if (refusal.empty() && this->Ranks.IsParallel())
  {
    refusal = kept.ToolPiece.Read(this->Tool, this->Executor);
  }
  if (!refusal.empty())
  {
    throw Remark{ NOT_A_SURFACE, "Tool " + refusal, true };
  }
  this->Note(kept.ToolSurface.Prepare(kept.Tool.Surface(), "Tool", this->Executor));
  const sbvtk::SurfaceInput& own = this->Ranks.IsParallel() ? kept.ToolPiece : kept.Tool;
  this->Second->ShallowCopy(own.Surface());
  sbvtk::AddBlockNames(this->Second, own.Names());
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
    if (this->Ranks.IsFirst())
    {
      vtkWarningWithObjectMacro(this->Filter, << remark.Sentence);
    }
    this->Gravest = this->Gravest.Sentence.empty() ? remark : this->Gravest;
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::NoteBadPoints(std::int64_t count)
{
  if (count > 0)
  {
    this->Note({ POINTS_NOT_FINITE,
      "Input has points with coordinates that are not finite numbers (" + std::to_string(count) +
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
  this->BadPoints = map.NumberOfBadPoints();
  this->Distances = map.TakeDistances();
}

//------------------------------------------------------------------------------
/** A summary is one of all processes, in which a point that several of them have counts once. */
sb::DistanceSummary vtkPolyDataDistance::Run::Summary(const std::vector<vtkDataSet*>& leaves)
{
  if (!this->Ranks.IsParallel())
  {
    return sb::Summarize(std::move(this->Distances));
  }
  vtkNew<vtkPolyData> places;
  this->Alone([&] { FillPlaces(this->PointsOf(leaves), this->Distances, places); });
  const vtkSmartPointer<vtkDataObject> all =
    sbvtk::RankGathering(this->Ranks.GetController())
      .Gather(places, 0, 0, sbvtk::RankGathering::Receiver::First);
  std::vector<char> bytes;
  this->Alone([&] {
    if (vtkPolyData* whole = vtkPolyData::SafeDownCast(all))
    {
      const sb::DistanceSummary summary = sb::Summarize(DistancesOf(whole));
      bytes.resize(sizeof summary);
      std::memcpy(bytes.data(), &summary, sizeof summary);
    }
  });
  this->Ranks.Distribute(bytes);
  sb::DistanceSummary summary;
  std::memcpy(&summary, bytes.data(), sizeof summary);
  return summary;
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::SummarizeInput()
{
  this->NoteBadPoints(this->Ranks.Sum(this->BadPoints));
  const sb::DistanceSummary summary = this->Summary(this->Leaves);
  this->InputToTool = summary.LargestMagnitude;
  sbvtk::AddSummaryFields(this->First, summary);
  sbvtk::AddField(this->First, "HausdorffInputToTool", this->InputToTool);
}

//------------------------------------------------------------------------------
/** The coordinates of all points, one data set after another. */
std::vector<double> vtkPolyDataDistance::Run::PointsOf(const std::vector<vtkDataSet*>& leaves)
{
  std::vector<double> points;
  for (vtkDataSet* leaf : leaves)
  {
    const sbvtk::SamplePlaces places = sbvtk::SamplePlaces::Points(leaf, this->Executor);
    points.insert(points.end(), places.Coordinates(), places.Coordinates() + 3 * places.Count());
  }
  return points;
}

//------------------------------------------------------------------------------
/** The Input of all processes; what is no surface comes as points. */
vtkSmartPointer<vtkDataObject> vtkPolyDataDistance::Run::WholeInput()
{
  if (!this->Ranks.IsParallel())
  {
    return this->Input;
  }
  vtkSmartPointer<vtkDataObject> own = this->Input;
  if (!this->Ranks.InAll(
        std::all_of(this->Leaves.begin(), this->Leaves.end(), vtkPolyData::SafeDownCast)))
  {
    vtkNew<vtkPolyData> points;
    this->Alone([&] { FillPlaces(this->PointsOf(this->Leaves), {}, points); });
    own = points;
  }
  return this->Ranks.Gather(own, 0, 0, sbvtk::RankGathering::Receiver::All);
}

//------------------------------------------------------------------------------
/** The Input as something to measure distances to: its polygons, or else its points. */
void vtkPolyDataDistance::Run::PrepareInput(vtkDataObject* whole)
{
  Cache& kept = *this->Filter->Kept;
  std::vector<vtkDataSet*> leaves = this->Leaves;
  if (kept.Input.Read(whole, this->Executor).empty())
  {
    vtkPolyData* surface = kept.Input.Surface();
    if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
    {
      this->Note(kept.InputSurface.Prepare(surface, "Input", this->Executor));
      return;
    }
    leaves = { surface };
  }
  this->Note(kept.InputSurface.PreparePoints(this->PointsOf(leaves), "Input", this->Executor));
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::MapTool()
{
  sbvtk::KernelMonitor monitor(this->Filter, 0.6, 0.95);
  sbvtk::DistanceMap map(this->Filter->Kept->InputSurface, this->Options());
  if (!map.AddTo(this->Second, this->Executor, monitor))
  {
    throw sbvtk::Stopped();
  }
  this->Distances = map.TakeDistances();
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::Run::SummarizeTool()
{
  const sb::DistanceSummary summary = this->Summary({ this->Second });
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
/** A filter downstream that wants all of a surface in the first process gets it there; the pipeline
 * takes what one output is asked for as the request to all of them. Else each process has what it
 * had, and the arrays of the others where it has no point. */
void vtkPolyDataDistance::Run::BringTogether()
{
  if (!this->Ranks.IsParallel())
  {
    return;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int pieces = this->Asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  const bool move = this->Ranks.InAll(!this->Ranks.IsFirst() || pieces == 1);
  for (vtkDataObject* output : { this->First, static_cast<vtkDataObject*>(this->Second) })
  {
    if (vtkPolyData* surface = vtkPolyData::SafeDownCast(output))
    {
      move ? this->Ranks.MoveToFirst(surface) : this->Ranks.ShareArraysWithEmpty(surface);
    }
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
  if (this->Ranks.IsFirst() && failure.Status != static_cast<int>(sb::Status::Aborted))
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
int vtkPolyDataDistance::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  this->Kept->Ranks.RequestPieces(inputs, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataDistance::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->GetController())
  {
    this->Kept->Ranks.SetController(controller);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkPolyDataDistance::GetController()
{
  return this->Kept->Ranks.GetController();
}

//------------------------------------------------------------------------------
int vtkPolyDataDistance::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int port = request->Get(vtkExecutive::FROM_OUTPUT_PORT());
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] {
    Run(this, inputs, outputs, port).Execute();
    sbvtk::KeepRangesOfOutputs(this);
  });
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
