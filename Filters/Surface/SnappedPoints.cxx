// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SnappedPoints.h"

#include "ArrayMemory.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <cmath>

namespace sbvtk
{
namespace
{

/** The power of two that is the grid's step, as its exponent. */
int ExponentOfStep(double tolerance)
{
  // Rounding moves a point by at most half a step along each axis.
  int binade = 0;
  std::frexp(2.0 * tolerance / std::sqrt(3.0), &binade);
  return binade - 1;
}

template <typename Value>
void Snap(Value* values, std::int64_t count, int exponent, sb::Executor& executor)
{
  executor.For(count, 1 << 16, [=](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      const double steps = std::ldexp(static_cast<double>(values[i]), -exponent);
      // Beyond 2^52 steps a double has no fraction to round; that includes what is not finite.
      if (std::abs(steps) < 4503599627370496.0)
      {
        values[i] = static_cast<Value>(std::ldexp(std::nearbyint(steps), exponent));
      }
    }
  });
}

} // namespace

vtkSmartPointer<vtkPoints> SnappedPoints(
  vtkPoints* points, double tolerance, sb::Executor& executor)
{
  const bool isFloat = vtkFloatArray::FastDownCast(points->GetData()) != nullptr;
  auto snapped = vtkSmartPointer<vtkPoints>::New();
  snapped->SetDataType(isFloat ? VTK_FLOAT : VTK_DOUBLE);
  CopyTuples(points->GetData(), snapped->GetData());
  const std::int64_t count = 3 * snapped->GetNumberOfPoints();
  const int exponent = ExponentOfStep(tolerance);
  if (isFloat)
  {
    Snap(vtkFloatArray::FastDownCast(snapped->GetData())->GetPointer(0), count, exponent, executor);
  }
  else
  {
    Snap(
      vtkDoubleArray::FastDownCast(snapped->GetData())->GetPointer(0), count, exponent, executor);
  }
  return snapped;
}

} // namespace sbvtk
