// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitPolyData.h"

#include "ArrayMemory.h"
#include "DistanceSampling.h"
#include "DistanceSurface.h"
#include "KernelExecutor.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

vtkStandardNewMacro(vtkImplicitPolyData);

struct vtkImplicitPolyData::Internals
{
  vtkSmartPointer<vtkPolyData> Input;
  std::mutex Guard;
  sbvtk::DistanceSurface Surface;
  std::atomic<vtkMTimeType> PreparedFor{ 0 }; ///< the state of Input that Surface is of
  std::atomic<bool> Usable{ false };

  /** The prepared surface, or null; prepared by the first thread that comes, the others wait. */
  const sb::SurfaceDistance* Ready(vtkImplicitPolyData* self);

  sb::SignRule Rule(const vtkImplicitPolyData* self) const
  {
    return self->SignMethod == VTK_WINDING_NUMBER ? sb::SignRule::WindingNumber
                                                  : sb::SignRule::Pseudonormal;
  }
};

//------------------------------------------------------------------------------
const sb::SurfaceDistance* vtkImplicitPolyData::Internals::Ready(vtkImplicitPolyData* self)
{
  if (!this->Input)
  {
    return nullptr;
  }
  const vtkMTimeType now = this->Input->GetMTime();
  if (this->PreparedFor.load(std::memory_order_acquire) != now)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->PreparedFor.load(std::memory_order_relaxed) != now)
    {
      sbvtk::KernelExecutor executor;
      const auto remark = this->Surface.Prepare(this->Input, "Input", executor);
      if (remark.IsError)
      {
        vtkErrorWithObjectMacro(self, << remark.Sentence);
      }
      this->Usable = !remark.IsError;
      this->PreparedFor.store(now, std::memory_order_release);
    }
  }
  return this->Usable ? &this->Surface.Distances() : nullptr;
}

//------------------------------------------------------------------------------
vtkImplicitPolyData::vtkImplicitPolyData()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkImplicitPolyData::~vtkImplicitPolyData() = default;

//------------------------------------------------------------------------------
void vtkImplicitPolyData::SetInput(vtkPolyData* input)
{
  if (this->Internal->Input != input)
  {
    this->Internal->Input = input;
    this->Internal->PreparedFor = 0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkImplicitPolyData::GetInput() { return this->Internal->Input; }

//------------------------------------------------------------------------------
vtkMTimeType vtkImplicitPolyData::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Internal->Input ? std::max(own, this->Internal->Input->GetMTime()) : own;
}

//------------------------------------------------------------------------------
double vtkImplicitPolyData::EvaluateFunction(double x[3])
{
  double nearest[3];
  vtkIdType cell;
  return this->EvaluateFunctionAndGetNearest(x, nearest, cell);
}

//------------------------------------------------------------------------------
double vtkImplicitPolyData::EvaluateFunctionAndGetNearest(
  const double x[3], double nearest[3], vtkIdType& cell)
{
  cell = -1;
  std::fill_n(nearest, 3, std::nan(""));
  const sb::SurfaceDistance* surface = this->Internal->Ready(this);
  if (!surface)
  {
    return this->NoValue;
  }
  const sb::SurfaceDistance::Answer answer =
    surface->At({ x[0], x[1], x[2] }, this->Internal->Rule(this));
  if (answer.Triangle < 0)
  {
    return this->NoValue;
  }
  cell = this->Internal->Surface.CellOfTriangle(answer.Triangle);
  nearest[0] = answer.Nearest.X;
  nearest[1] = answer.Nearest.Y;
  nearest[2] = answer.Nearest.Z;
  return std::fabs(answer.Distance) <= this->Tolerance ? 0.0 : answer.Distance;
}

//------------------------------------------------------------------------------
void vtkImplicitPolyData::EvaluateFunction(vtkDataArray* input, vtkDataArray* output)
{
  const vtkIdType count = input->GetNumberOfTuples();
  output->SetNumberOfComponents(1);
  sbvtk::SetTuples(output, count);
  const sb::SurfaceDistance* surface = this->Internal->Ready(this);
  if (!surface)
  {
    output->Fill(this->NoValue);
    return;
  }
  vtkSmartPointer<vtkDoubleArray> points = vtkDoubleArray::FastDownCast(input);
  if (!points)
  {
    points = vtkSmartPointer<vtkDoubleArray>::New();
    sbvtk::CopyTuples(input, points);
  }
  vtkNew<vtkDoubleArray> distances;
  distances->SetName(output->GetName()); // which the copy below takes over
  sbvtk::SetTuples(distances, count);
  sb::DistanceRequest request;
  request.Points = points->GetPointer(0);
  request.Count = count;
  request.Rule = this->Internal->Rule(this);
  sb::DistanceArrays arrays;
  arrays.Distance = distances->GetPointer(0);
  // An implicit function may be asked by many threads at once, so it starts more of them only where
  // vtkSMPTools has been told to.
  sbvtk::RunWithThreads(vtkSMPTools::GetEstimatedNumberOfThreads(), [&] {
    sbvtk::KernelExecutor executor;
    sb::Monitor monitor;
    sb::SampleDistances(*surface, request, arrays, executor, monitor);
  });
  std::for_each(arrays.Distance, arrays.Distance + count, [this](double& distance) {
    distance = std::isnan(distance)            ? this->NoValue
      : std::fabs(distance) <= this->Tolerance ? 0.0
                                               : distance;
  });
  output->DeepCopy(distances);
}

//------------------------------------------------------------------------------
void vtkImplicitPolyData::EvaluateGradient(double x[3], double g[3])
{
  std::copy_n(this->NoGradient, 3, g);
  const sb::SurfaceDistance* surface = this->Internal->Ready(this);
  if (!surface)
  {
    return;
  }
  const sb::SurfaceDistance::Answer answer =
    surface->At({ x[0], x[1], x[2] }, sb::SignRule::Unsigned);
  if (answer.Triangle < 0)
  {
    return;
  }
  const sb::Vector3 normal = surface->Pseudonormal(answer.Triangle, answer.Where);
  if (sb::SquaredLength(normal) > 0.0)
  {
    g[0] = normal.X;
    g[1] = normal.Y;
    g[2] = normal.Z;
  }
}

//------------------------------------------------------------------------------
void vtkImplicitPolyData::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Input: " << this->Internal->Input.GetPointer() << "\n";
  os << indent << "NoValue: " << this->NoValue << "\n";
  os << indent << "NoGradient: (" << this->NoGradient[0] << ", " << this->NoGradient[1] << ", "
     << this->NoGradient[2] << ")\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "SignMethod: " << this->SignMethod << "\n";
}
