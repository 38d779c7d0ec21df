// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMovingLeastSquaresSurface.h"

#include "CloudInput.h"
#include "CloudSentences.h"
#include "CloudSurface.h"
#include "KernelExecutor.h"
#include "LineIntersection.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

vtkStandardNewMacro(vtkMovingLeastSquaresSurface);

namespace
{

sb::Real3 Read(const double x[3]) { return { x[0], x[1], x[2] }; }

/** A thread's memory for neighbours, kept from one evaluation to the next. */
sb::MovingLeastSquares::Neighbourhood& Scratch()
{
  static thread_local sb::MovingLeastSquares::Neighbourhood near;
  return near;
}

} // namespace

struct vtkMovingLeastSquaresSurface::Internals
{
  vtkSmartPointer<vtkPointSet> Input;
  std::mutex Guard;
  std::atomic<vtkMTimeType> PreparedFor{ 0 }; ///< the state of Input and settings
  sb::CloudSurface Cloud;

  /** The prepared surface, or null; prepared by the first thread that comes, the others wait. */
  const sb::MovingLeastSquares* Ready(vtkMovingLeastSquaresSurface* self)
  {
    const vtkMTimeType now = self->GetMTime();
    if (this->PreparedFor.load(std::memory_order_acquire) != now)
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      if (this->PreparedFor.load(std::memory_order_relaxed) != now)
      {
        this->Prepare(self);
        this->PreparedFor.store(now, std::memory_order_release);
      }
    }
    return this->Cloud.Surface.get();
  }

  void Prepare(vtkMovingLeastSquaresSurface* self)
  {
    this->Cloud = {};
    if (!this->Input)
    {
      return;
    }
    sbvtk::CloudInput input;
    input.Read(this->Input);
    if (!input.Warning().empty())
    {
      vtkWarningWithObjectMacro(self, << input.Warning());
    }
    sb::CloudRequest request;
    request.Points = input.Points();
    request.Normals = input.Normals();
    request.Count = input.NumberOfPoints();
    request.Definition = static_cast<sb::SurfaceDefinition>(self->Definition);
    request.Width = std::isfinite(self->Width) ? self->Width : 0.0;
    request.Flip = self->FlipNormals != 0;
    sbvtk::KernelExecutor executor;
    sb::Monitor monitor;
    this->Cloud = sb::MakeCloudSurface(request, executor, monitor);
    const std::string refusal = sbvtk::RefusalOf(this->Cloud, request.Count);
    if (!refusal.empty())
    {
      vtkErrorWithObjectMacro(self, << refusal);
    }
  }
};

//------------------------------------------------------------------------------
vtkMovingLeastSquaresSurface::vtkMovingLeastSquaresSurface()
  : Internal(new Internals)
{
  static_assert(static_cast<int>(sb::Support::Defined) == VTK_DEFINED &&
      static_cast<int>(sb::Support::Far) == VTK_FAR &&
      static_cast<int>(sb::Support::Border) == VTK_BORDER &&
      static_cast<int>(sb::Support::Contradicting) == VTK_CONTRADICTING &&
      static_cast<int>(sb::SurfaceDefinition::Unbiased) == VTK_UNBIASED &&
      static_cast<int>(sb::SurfaceDefinition::AmentaKil) == VTK_AMENTA_KIL,
    "the kernel's numbers are the class's");
}

//------------------------------------------------------------------------------
vtkMovingLeastSquaresSurface::~vtkMovingLeastSquaresSurface() = default;

//------------------------------------------------------------------------------
void vtkMovingLeastSquaresSurface::SetInput(vtkPointSet* input)
{
  if (this->Internal->Input != input)
  {
    this->Internal->Input = input;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPointSet* vtkMovingLeastSquaresSurface::GetInput() { return this->Internal->Input; }

//------------------------------------------------------------------------------
vtkMTimeType vtkMovingLeastSquaresSurface::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Internal->Input ? std::max(own, this->Internal->Input->GetMTime()) : own;
}

//------------------------------------------------------------------------------
double vtkMovingLeastSquaresSurface::EvaluateFunction(double x[3])
{
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  const sb::Real3 place = Read(x);
  if (!surface || !sb::IsFinite(place))
  {
    return this->NoValue;
  }
  const sb::SurfaceValue f = surface->EvaluateAt(place, 0, Scratch());
  return f.IsNear ? f.Value : surface->DistanceToSamples(place, nullptr);
}

//------------------------------------------------------------------------------
void vtkMovingLeastSquaresSurface::EvaluateGradient(double x[3], double g[3])
{
  std::copy_n(this->NoGradient, 3, g);
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  const sb::Real3 place = Read(x);
  if (!surface || !sb::IsFinite(place))
  {
    return;
  }
  sb::SurfaceValue f = surface->EvaluateAt(place, 1, Scratch());
  if (!f.IsNear)
  {
    surface->DistanceToSamples(place, &f.Gradient);
  }
  std::copy_n(f.Gradient.begin(), 3, g);
}

//------------------------------------------------------------------------------
void vtkMovingLeastSquaresSurface::EvaluateHessian(const double x[3], double hessian[9])
{
  std::fill_n(hessian, 9, 0.0);
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  if (!surface || !sb::IsFinite(Read(x)))
  {
    return;
  }
  const sb::SurfaceValue f = surface->EvaluateAt(Read(x), 2, Scratch());
  for (std::size_t row = 0; row < 3; ++row)
  {
    std::copy_n(f.Hessian[row].begin(), 3, hessian + 3 * row);
  }
}

//------------------------------------------------------------------------------
int vtkMovingLeastSquaresSurface::GetValidity(const double x[3])
{
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  if (!surface || !sb::IsFinite(Read(x)))
  {
    return VTK_FAR;
  }
  return static_cast<int>(surface->EvaluateAt(Read(x), 0, Scratch()).Where);
}

//------------------------------------------------------------------------------
bool vtkMovingLeastSquaresSurface::Project(const double x[3], double projected[3])
{
  sb::Real3 place = Read(x);
  std::copy_n(x, 3, projected);
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  if (!surface || !sb::IsFinite(place) ||
    surface->Project(place, Scratch()).Where != sb::Support::Defined)
  {
    return false;
  }
  std::copy_n(place.begin(), 3, projected);
  return true;
}

//------------------------------------------------------------------------------
int vtkMovingLeastSquaresSurface::IntersectWithLine(
  const double p1[3], const double p2[3], vtkPoints* points)
{
  if (points)
  {
    points->SetDataTypeToDouble();
    points->Reset();
  }
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  if (!surface || !sb::IsFinite(Read(p1)) || !sb::IsFinite(Read(p2)))
  {
    return 0;
  }
  const std::vector<double> roots = sb::IntersectSegment(*surface, Read(p1), Read(p2), Scratch());
  for (const double t : roots)
  {
    if (points)
    {
      points->InsertNextPoint(
        p1[0] + t * (p2[0] - p1[0]), p1[1] + t * (p2[1] - p1[1]), p1[2] + t * (p2[2] - p1[2]));
    }
  }
  return static_cast<int>(roots.size());
}

//------------------------------------------------------------------------------
double vtkMovingLeastSquaresSurface::EvaluateSectionCurvature(
  const double x[3], const double planeNormal[3])
{
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  const double length = std::hypot(planeNormal[0], planeNormal[1], planeNormal[2]);
  if (!surface || !sb::IsFinite(Read(x)) || !(length > 0.0))
  {
    return 0.0;
  }
  return sb::SectionCurvature(
    surface->EvaluateAt(Read(x), 2, Scratch()), sb::Scaled(Read(planeNormal), 1.0 / length));
}

//------------------------------------------------------------------------------
void vtkMovingLeastSquaresSurface::EvaluatePrincipalCurvatures(
  const double x[3], double curvatures[2])
{
  std::fill_n(curvatures, 2, 0.0);
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  if (surface && sb::IsFinite(Read(x)))
  {
    const sb::SurfaceCurvature found = sb::CurvatureOf(surface->EvaluateAt(Read(x), 2, Scratch()));
    curvatures[0] = found.Maximum;
    curvatures[1] = found.Minimum;
  }
}

//------------------------------------------------------------------------------
double vtkMovingLeastSquaresSurface::GetSpacing()
{
  return this->Internal->Ready(this) ? this->Internal->Cloud.Spacing : 0.0;
}

//------------------------------------------------------------------------------
double vtkMovingLeastSquaresSurface::GetActualWidth()
{
  const sb::MovingLeastSquares* surface = this->Internal->Ready(this);
  return surface ? surface->Width() : 0.0;
}

//------------------------------------------------------------------------------
void vtkMovingLeastSquaresSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Input: " << this->Internal->Input.GetPointer() << "\n";
  os << indent << "Definition: " << this->Definition << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "FlipNormals: " << this->FlipNormals << "\n";
  os << indent << "NoValue: " << this->NoValue << "\n";
  os << indent << "NoGradient: (" << this->NoGradient[0] << ", " << this->NoGradient[1] << ", "
     << this->NoGradient[2] << ")\n";
}
