// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SamplePlaces.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace sbvtk
{
namespace
{

constexpr std::int64_t grain = 16384;

/** The means of the cells of one array. */
template <class Id>
void MeansOfCells(
  vtkCellArray* cells, const SamplePlaces& points, double* means, sb::Executor& executor)
{
  const Id* offsets = static_cast<const Id*>(cells->GetOffsetsArray()->GetVoidPointer(0));
  const Id* ids = static_cast<const Id*>(cells->GetConnectivityArray()->GetVoidPointer(0));
  const double* coordinates = points.Coordinates();
  const std::int64_t limit = points.Count();
  const Id end = static_cast<Id>(cells->GetNumberOfConnectivityIds());
  executor.For(cells->GetNumberOfCells(), grain, [=](std::int64_t first, std::int64_t last) {
    for (std::int64_t cell = first; cell < last; ++cell)
    {
      double sum[3] = { 0.0, 0.0, 0.0 };
      std::int64_t count = 0;
      for (Id place = std::max<Id>(0, offsets[cell]); place < std::min(end, offsets[cell + 1]);
           ++place)
      {
        if (ids[place] >= 0 && ids[place] < limit)
        {
          const double* point = coordinates + 3 * static_cast<std::int64_t>(ids[place]);
          for (int axis = 0; axis < 3; ++axis)
          {
            sum[axis] += point[axis];
          }
          ++count;
        }
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        means[3 * cell + axis] = sum[axis] / static_cast<double>(count); // NaN without points
      }
    }
  });
}

} // namespace

SamplePlaces SamplePlaces::Points(vtkDataSet* data, sb::Executor& executor)
{
  SamplePlaces places;
  places.Number = data->GetNumberOfPoints();
  vtkPointSet* pointSet = vtkPointSet::SafeDownCast(data);
  vtkPoints* points = pointSet ? pointSet->GetPoints() : nullptr;
  if (places.Number == 0)
  {
    return places;
  }
  if (vtkDoubleArray* inPlace = points ? vtkDoubleArray::FastDownCast(points->GetData()) : nullptr)
  {
    places.Foreign = inPlace->GetPointer(0);
    return places;
  }
  places.Own.resize(3 * places.Number);
  if (vtkFloatArray* floats = points ? vtkFloatArray::FastDownCast(points->GetData()) : nullptr)
  {
    const float* source = floats->GetPointer(0);
    double* target = places.Own.data();
    executor.For(3 * places.Number, grain, [=](std::int64_t begin, std::int64_t end) {
      std::copy(source + begin, source + end, target + begin);
    });
    return places;
  }
  for (vtkIdType i = 0; i < places.Number; ++i)
  {
    data->GetPoint(i, places.Own.data() + 3 * i);
  }
  return places;
}

SamplePlaces SamplePlaces::CellCenters(vtkDataSet* data, sb::Executor& executor)
{
  SamplePlaces places;
  places.Number = data->GetNumberOfCells();
  places.Own.resize(3 * places.Number);
  if (places.Number == 0)
  {
    return places;
  }
  const SamplePlaces points = Points(data, executor);
  std::vector<vtkCellArray*> parts;
  if (vtkPolyData* surface = vtkPolyData::SafeDownCast(data))
  {
    parts = { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() };
  }
  else if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    parts = { grid->GetCells() };
  }
  double* next = places.Own.data();
  for (vtkCellArray* cells : parts)
  {
    if (cells && cells->GetNumberOfCells() > 0)
    {
      cells->IsStorage64Bit() ? MeansOfCells<vtkTypeInt64>(cells, points, next, executor)
                              : MeansOfCells<vtkTypeInt32>(cells, points, next, executor);
      next += 3 * cells->GetNumberOfCells();
    }
  }
  if (!parts.empty())
  {
    return places;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < places.Number; ++cell, next += 3)
  {
    data->GetCellPoints(cell, ids);
    std::fill_n(next, 3, 0.0);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        next[axis] += points.Coordinates()[3 * ids->GetId(k) + axis];
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      next[axis] /= static_cast<double>(ids->GetNumberOfIds());
    }
  }
  return places;
}

} // namespace sbvtk
