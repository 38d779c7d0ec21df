// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataDistanceField.h"

#include "ArrayMemory.h"
#include "ArrayRanges.h"
#include "DistanceMap.h"
#include "DistanceSampling.h"
#include "DistanceSurface.h"
#include "FieldArrays.h"
#include "KernelExecutor.h"
#include "RankGathering.h"
#include "SurfaceConnections.h"
#include "SurfaceInput.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPolyDataDistanceField);

/** What is kept from one update to the next. */
struct vtkPolyDataDistanceField::Cache
{
  sbvtk::RankGathering Ranks;
  std::pair<vtkMTimeType, double> Stamp; ///< of the pipeline, when Whole was gathered
  vtkSmartPointer<vtkDataObject> Whole;
  sbvtk::SurfaceInput Input;
  sbvtk::DistanceSurface Surface;
};

/** One update: its steps in their order, and what they share. */
class vtkPolyDataDistanceField::Run
{
public:
  Run(vtkPolyDataDistanceField* filter, vtkInformationVector** inputs, vtkImageData* image,
    vtkInformation* output)
    : Filter(filter)
    , Inputs(inputs)
    , Image(image)
    , Output(output)
  {
  }

  void Execute();

  /** The samples along each axis, before the update; of an input that cannot be used 1. */
  std::array<int, 3> Foresee();

private:
  using Remark = sbvtk::DistanceSurface::Remark;

  void CheckSettings() const;
  void ReadInput();
  void PlaceImage();
  void TakeOwnPart();
  void Sample();
  void SampleSlices(int firstSlice, int lastSlice, float* target, sb::Monitor& monitor);
  void Finish(const Remark& remark);

  vtkPolyDataDistanceField* Filter;
  vtkInformationVector** Inputs;
  vtkDataObject* Input = nullptr;
  vtkImageData* Image;
  vtkInformation* Output;
  sbvtk::KernelExecutor Executor;
  Remark Gravest;
  int WholeExtent[6]{ 0, 0, 0, 0, 0, 0 };
};

//------------------------------------------------------------------------------
void vtkPolyDataDistanceField::Run::Execute()
{
  try
  {
    this->Input = this->Filter->WholeInput(this->Inputs);
    this->CheckSettings();
    this->ReadInput();
    this->PlaceImage();
    this->TakeOwnPart();
    this->Sample();
    sbvtk::StopIfAsked(this->Filter);
    this->Finish(this->Gravest);
  }
  catch (const Remark& failure)
  {
    this->Finish(failure);
  }
  catch (const sbvtk::Stopped&)
  {
    const sbvtk::FilterFailure stopped = sbvtk::FailureOf(sb::Status::Aborted);
    this->Finish({ stopped.Status, stopped.Sentence, true });
  }
  catch (const std::bad_alloc&)
  {
    this->Finish({ sbvtk::DistanceSurface::OUT_OF_MEMORY,
      "The image does not fit into memory; choose smaller Dimensions or a larger Spacing.", true });
  }
}

//------------------------------------------------------------------------------
std::array<int, 3> vtkPolyDataDistanceField::Run::Foresee()
{
  std::array<int, 3> dimensions{ 1, 1, 1 };
  try
  {
    this->Input = this->Filter->WholeInput(this->Inputs);
    this->CheckSettings();
    this->ReadInput();
    this->PlaceImage();
    this->Image->GetDimensions(dimensions.data());
  }
  catch (const Remark&)
  {
    // It is told when the image is asked for.
  }
  catch (const std::bad_alloc&)
  {
  }
  return dimensions;
}

//------------------------------------------------------------------------------
void vtkPolyDataDistanceField::Run::CheckSettings() const
{
  const int badRequest = static_cast<int>(sb::Status::BadRequest);
  const struct
  {
    const char* Name;
    double Value;
  } lengths[] = { { "Spacing", this->Filter->Spacing }, { "Margin", this->Filter->Margin },
    { "NarrowBand", this->Filter->NarrowBand } };
  for (const auto& length : lengths)
  {
    if (!std::isfinite(length.Value) || length.Value < 0.0)
    {
      throw Remark{ badRequest,
        std::string(length.Name) + " is " + std::to_string(length.Value) +
          "; set it to 0 or a positive number.",
        true };
    }
  }
  const int* dimensions = this->Filter->Dimensions;
  if (this->Filter->SampleBy == VTK_DIMENSIONS && *std::min_element(dimensions, dimensions + 3) < 2)
  {
    throw Remark{ badRequest, "Dimensions has a number below 2; set all three to 2 or more.",
      true };
  }
  if (!this->Input)
  {
    throw Remark{ badRequest,
      "Input has no surface; set Input (in ParaView: right-click the filter in the Pipeline "
      "Browser, Change Input).",
      true };
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataDistanceField::Run::ReadInput()
{
  Cache& kept = *this->Filter->Kept;
  const std::string refusal = kept.Input.Read(this->Input, this->Executor);
  if (!refusal.empty())
  {
    throw Remark{ sbvtk::DistanceSurface::NOT_A_SURFACE, "Input " + refusal, true };
  }
  const Remark remark = kept.Surface.Prepare(kept.Input.Surface(), "Input", this->Executor);
  if (remark.IsError)
  {
    throw remark;
  }
  if (this->Filter->SignedDistance && this->Filter->SignMethod == VTK_PSEUDONORMAL)
  {
    this->Gravest = remark;
  }
}

//------------------------------------------------------------------------------
/** The box of the polygons, a margin, and samples on both ends of it or somewhat beyond. */
void vtkPolyDataDistanceField::Run::PlaceImage()
{
  const std::array<double, 6> box = this->Filter->Kept->Surface.Distances().Bounds();
  double longest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, box[2 * axis + 1] - box[2 * axis]);
  }
  const double margin = this->Filter->Margin * longest;
  const double spacing =
    this->Filter->Spacing > 0.0 ? this->Filter->Spacing : 0.01 * (longest + 2.0 * margin);
  double origin[3];
  double steps[3];
  double count = 1.0;
  std::array<double, 3> samples{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double side = box[2 * axis + 1] - box[2 * axis] + 2.0 * margin;
    const bool byDimensions = this->Filter->SampleBy == VTK_DIMENSIONS;
    samples[axis] = byDimensions ? this->Filter->Dimensions[axis]
                                 : std::max(2.0, std::ceil(side / spacing * (1.0 - 1e-12)) + 1.0);
    steps[axis] = byDimensions ? side / (samples[axis] - 1.0) : spacing;
    steps[axis] = steps[axis] > 0.0 ? steps[axis] : spacing > 0.0 ? spacing : 1.0;
    origin[axis] =
      0.5 * (box[2 * axis] + box[2 * axis + 1]) - 0.5 * (samples[axis] - 1.0) * steps[axis];
    count *= samples[axis];
  }
  if (!(count <= std::numeric_limits<std::int32_t>::max()))
  {
    throw Remark{ static_cast<int>(sb::Status::TooLarge),
      "The image would have more samples than this filter can count (2147483647); choose smaller "
      "Dimensions or a larger Spacing.",
      true };
  }
  this->Image->SetDimensions(
    static_cast<int>(samples[0]), static_cast<int>(samples[1]), static_cast<int>(samples[2]));
  this->Image->SetOrigin(origin);
  this->Image->SetSpacing(steps);
}

//------------------------------------------------------------------------------
/** Each of several processes makes the part of the image that it is asked for. */
void vtkPolyDataDistanceField::Run::TakeOwnPart()
{
  this->Image->GetExtent(this->WholeExtent);
  if (this->Filter->Kept->Ranks.IsParallel())
  {
    int extent[6];
    this->Output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
    for (int side = 0; side < 6; side += 2)
    {
      extent[side] = std::max(extent[side], this->WholeExtent[side]);
      extent[side + 1] = std::min(extent[side + 1], this->WholeExtent[side + 1]);
    }
    this->Image->SetExtent(extent);
  }
}

//------------------------------------------------------------------------------
/** A few slices at a time, so that the samples' coordinates need little memory. */
void vtkPolyDataDistanceField::Run::Sample()
{
  vtkNew<vtkFloatArray> distances;
  distances->SetName("Distance");
  sbvtk::SetTuples(distances, this->Image->GetNumberOfPoints());
  int dimensions[3];
  this->Image->GetDimensions(dimensions);
  const std::int64_t slice = std::max(std::int64_t(1), std::int64_t(dimensions[0]) * dimensions[1]);
  const int slices = static_cast<int>(std::max<std::int64_t>(1, (std::int64_t(1) << 21) / slice));
  for (int first = 0; first < dimensions[2]; first += slices)
  {
    const int last = std::min(dimensions[2], first + slices);
    sbvtk::KernelMonitor monitor(
      this->Filter, 0.1 + 0.85 * first / dimensions[2], 0.1 + 0.85 * last / dimensions[2]);
    this->SampleSlices(first, last, distances->GetPointer(0) + first * slice, monitor);
  }
  this->Image->GetPointData()->SetScalars(distances);
}

//------------------------------------------------------------------------------
void vtkPolyDataDistanceField::Run::SampleSlices(
  int firstSlice, int lastSlice, float* target, sb::Monitor& monitor)
{
  int dimensions[3];
  this->Image->GetDimensions(dimensions);
  const double* origin = this->Image->GetOrigin();
  const double* spacing = this->Image->GetSpacing();
  const int* extent = this->Image->GetExtent();
  const std::int64_t rows = std::int64_t(lastSlice - firstSlice) * dimensions[1];
  const std::int64_t count = rows * dimensions[0];
  std::vector<double> places(3 * count);
  std::vector<double> values(count);
  this->Executor.For(rows, 64, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t row = begin; row < end; ++row)
    {
      double* place = places.data() + 3 * row * dimensions[0];
      for (int i = 0; i < dimensions[0]; ++i, place += 3)
      {
        const std::int64_t j = extent[2] + row % dimensions[1];
        const std::int64_t k = extent[4] + firstSlice + row / dimensions[1];
        place[0] = origin[0] + (extent[0] + i) * spacing[0];
        place[1] = origin[1] + static_cast<double>(j) * spacing[1];
        place[2] = origin[2] + static_cast<double>(k) * spacing[2];
      }
    }
  });
  sb::DistanceRequest request;
  request.Points = places.data();
  request.Count = count;
  request.Rule = !this->Filter->SignedDistance       ? sb::SignRule::Unsigned
    : this->Filter->SignMethod == VTK_WINDING_NUMBER ? sb::SignRule::WindingNumber
                                                     : sb::SignRule::Pseudonormal;
  request.Limit = this->Filter->NarrowBand > 0.0 ? this->Filter->NarrowBand
                                                 : std::numeric_limits<double>::infinity();
  sb::DistanceArrays arrays;
  arrays.Distance = values.data();
  if (!sb::SampleDistances(
        this->Filter->Kept->Surface.Distances(), request, arrays, this->Executor, monitor))
  {
    throw sbvtk::Stopped();
  }
  const double factor = this->Filter->NegateDistance && this->Filter->SignedDistance ? -1.0 : 1.0;
  std::transform(values.begin(), values.end(), target,
    [factor](double value) { return static_cast<float>(value == 0.0 ? 0.0 : factor * value); });
}

//------------------------------------------------------------------------------
void vtkPolyDataDistanceField::Run::Finish(const Remark& remark)
{
  if (remark.IsError)
  {
    this->Image->Initialize();
  }
  sbvtk::AddField(this->Image, "Status", remark.Status);
  sbvtk::AddField(this->Image, "Message",
    remark.Sentence.empty() ? std::string("The result is complete.") : remark.Sentence);
  this->Output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(),
    remark.IsError ? this->Image->GetExtent() : this->WholeExtent, 6);
  const bool isOfAll = remark.Status != sbvtk::DistanceSurface::OUT_OF_MEMORY;
  if (isOfAll && !this->Filter->Kept->Ranks.IsFirst())
  {
    return; // the first process tells it
  }
  if (remark.IsError && remark.Status != static_cast<int>(sb::Status::Aborted))
  {
    vtkErrorWithObjectMacro(this->Filter, << remark.Sentence);
  }
  else if (!remark.IsError && !remark.Sentence.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << remark.Sentence);
  }
}

//------------------------------------------------------------------------------
vtkPolyDataDistanceField::vtkPolyDataDistanceField()
  : Kept(new Cache)
{
}

//------------------------------------------------------------------------------
vtkPolyDataDistanceField::~vtkPolyDataDistanceField() = default;

//------------------------------------------------------------------------------
int vtkPolyDataDistanceField::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object, and none: what is wrong is told in a sentence of ours.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
/** Filters after this one ask for an extent before the image is made. Where the spacing is given it
 * depends on the surface, which therefore is updated already now. */
int vtkPolyDataDistanceField::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  std::array<int, 3> dimensions{ std::max(1, this->Dimensions[0]), std::max(1, this->Dimensions[1]),
    std::max(1, this->Dimensions[2]) };
  if (this->SampleBy == VTK_SPACING && this->GetNumberOfInputConnections(0) > 0)
  {
    this->Kept->Ranks.RequestPieces(inputs, 1);
    this->GetInputAlgorithm()->Update(this->GetInputConnection(0, 0)->GetIndex());
    vtkNew<vtkImageData> scratch;
    sbvtk::RunWithThreads(
      this->NumberOfThreads, [&] { dimensions = Run(this, inputs, scratch, nullptr).Foresee(); });
  }
  const int extent[6] = { 0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, dimensions[2] - 1 };
  vtkInformation* output = outputs->GetInformationObject(0);
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(output, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
/**
 * The surface of all processes, for each of them. They come
 * together only when the pipeline or the time has changed, which all of them notice: another extent
 * may be asked for in one process alone.
 */
vtkDataObject* vtkPolyDataDistanceField::WholeInput(vtkInformationVector** inputs)
{
  Cache& kept = *this->Kept;
  vtkDataObject* own = vtkDataObject::GetData(inputs[0], 0);
  if (!kept.Ranks.IsParallel())
  {
    return own;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* time = inputs[0]->GetInformationObject(0);
  const std::pair<vtkMTimeType, double> stamp{
    Pipeline::SafeDownCast(this->GetExecutive())->GetPipelineMTime(),
    time && time->Has(Pipeline::UPDATE_TIME_STEP()) ? time->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0
  };
  if (stamp != kept.Stamp)
  {
    kept.Whole = nullptr;
    kept.Whole = kept.Ranks.Gather(own, 0, 0, sbvtk::RankGathering::Receiver::All);
    kept.Stamp = stamp;
  }
  return kept.Whole;
}

//------------------------------------------------------------------------------
int vtkPolyDataDistanceField::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  this->Kept->Ranks.RequestPieces(inputs, 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataDistanceField::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->GetController())
  {
    this->Kept->Ranks.SetController(controller);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkPolyDataDistanceField::GetController()
{
  return this->Kept->Ranks.GetController();
}

//------------------------------------------------------------------------------
int vtkPolyDataDistanceField::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] {
    Run(this, inputs, vtkImageData::GetData(outputs, 0), outputs->GetInformationObject(0))
      .Execute();
    sbvtk::KeepRangesOfOutputs(this);
  });
  this->SetAbortOutput(
    false); // a run that was stopped says so in its field data, which the pipeline would clear
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataDistanceField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SampleBy: " << this->SampleBy << "\n";
  os << indent << "Dimensions: (" << this->Dimensions[0] << ", " << this->Dimensions[1] << ", "
     << this->Dimensions[2] << ")\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "NarrowBand: " << this->NarrowBand << "\n";
  os << indent << "SignedDistance: " << this->SignedDistance << "\n";
  os << indent << "SignMethod: " << this->SignMethod << "\n";
  os << indent << "NegateDistance: " << this->NegateDistance << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
