// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultCurves.h"

#include "ArrayMemory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace sbvtk
{
namespace
{

template <typename Value>
void CopyPoints(const sb::Curves& curves, void* target)
{
  Value* out = static_cast<Value*>(target);
  for (const std::array<double, 3>& point : curves.Points)
  {
    for (const double coordinate : point)
    {
      *out++ = static_cast<Value>(coordinate);
    }
  }
}

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace

void CopyCurves(const sb::Curves& curves, bool singlePrecision, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(singlePrecision ? VTK_FLOAT : VTK_DOUBLE);
  SetTuples(points, static_cast<vtkIdType>(curves.Points.size()));
  if (!curves.Points.empty())
  {
    void* target = points->GetData()->GetVoidPointer(0);
    singlePrecision ? CopyPoints<float>(curves, target) : CopyPoints<double>(curves, target);
  }

  const std::size_t numberOfCurves = curves.Offsets.empty() ? 0 : curves.Offsets.size() - 1;
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  vtkNew<vtkDoubleArray> lengths;
  vtkNew<vtkUnsignedCharArray> closed;
  lengths->SetName("Length");
  closed->SetName("Closed");
  SetTuples(offsets, static_cast<vtkIdType>(numberOfCurves) + 1);
  SetTuples(connectivity, static_cast<vtkIdType>(curves.Connectivity.size()));
  SetTuples(lengths, static_cast<vtkIdType>(numberOfCurves));
  SetTuples(closed, static_cast<vtkIdType>(numberOfCurves));
  std::copy(curves.Connectivity.begin(), curves.Connectivity.end(), connectivity->GetPointer(0));
  vtkTypeInt64* offsetsOut = offsets->GetPointer(0);
  *offsetsOut = 0;
  std::copy(curves.Offsets.begin(), curves.Offsets.end(), offsetsOut);
  double* lengthsOut = lengths->GetPointer(0);
  unsigned char* closedOut = closed->GetPointer(0);
  for (std::size_t curve = 0; curve < numberOfCurves; ++curve)
  {
    const std::int32_t* ids = curves.Connectivity.data() + curves.Offsets[curve];
    const std::int32_t count = curves.Offsets[curve + 1] - curves.Offsets[curve];
    double length = 0.0;
    for (std::int32_t i = 0; i + 1 < count; ++i)
    {
      length += Distance(curves.Points[ids[i]], curves.Points[ids[i + 1]]);
    }
    lengthsOut[curve] = length;
    closedOut[curve] = count > 1 && ids[0] == ids[count - 1];
  }

  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(lengths);
  output->GetCellData()->AddArray(closed);
}

} // namespace sbvtk
