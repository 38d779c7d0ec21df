// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceMap.h"

#include "ArrayMemory.h"
#include "FieldArrays.h"

#include "DistanceSampling.h"
#include "SamplePlaces.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>

namespace sbvtk
{

bool DistanceMap::AddTo(vtkDataSet* data, sb::Executor& executor, sb::Monitor& monitor)
{
  double* distances = nullptr;
  const SamplePlaces points = SamplePlaces::Points(data, executor);
  if (!this->AddArrays(data->GetPointData(), points, distances, executor, monitor))
  {
    return false;
  }
  this->All.insert(this->All.end(), distances, distances + points.Count());
  this->BadPoints += std::count_if(
    distances, distances + points.Count(), [](double distance) { return std::isnan(distance); });
  if (!this->Options.CellCenters)
  {
    return true;
  }
  const SamplePlaces centers = SamplePlaces::CellCenters(data, executor);
  return this->AddArrays(data->GetCellData(), centers, distances, executor, monitor);
}

bool DistanceMap::AddArrays(vtkDataSetAttributes* attributes, const SamplePlaces& places,
  double*& distances, sb::Executor& executor, sb::Monitor& monitor)
{
  const std::int64_t count = places.Count();
  sb::DistanceRequest request;
  request.Points = places.Coordinates();
  request.Count = count;
  request.Rule = this->Surface.HasSides() ? this->Options.Rule : sb::SignRule::Unsigned;
  request.Limit = this->Options.Limit;
  sb::DistanceArrays arrays;
  const auto distance = NewArray<vtkDoubleArray>("Distance", 1, count);
  std::vector<std::int32_t> triangles;
  distances = arrays.Distance = distance->GetPointer(0);
  if (this->Options.NearestPoint)
  {
    const auto nearest = NewArray<vtkDoubleArray>("NearestPoint", 3, count);
    arrays.Nearest = nearest->GetPointer(0);
    attributes->AddArray(nearest);
  }
  if (this->Options.Direction)
  {
    const auto direction = NewArray<vtkDoubleArray>("Direction", 3, count);
    arrays.Direction = direction->GetPointer(0);
    attributes->AddArray(direction);
  }
  if (this->Options.NearestCellId)
  {
    triangles.resize(count);
    arrays.Triangle = triangles.data();
  }
  if (!sb::SampleDistances(this->Surface.Distances(), request, arrays, executor, monitor))
  {
    return false;
  }
  if (this->Options.Negate && request.Rule != sb::SignRule::Unsigned)
  {
    std::transform(distances, distances + count, distances,
      [](double value) { return value == 0.0 ? 0.0 : -value; });
  }
  attributes->AddArray(distance);
  attributes->SetActiveScalars("Distance");
  if (this->Options.NearestCellId)
  {
    const auto cells = NewArray<vtkIdTypeArray>("NearestCellId", 1, count);
    std::transform(
      triangles.begin(), triangles.end(), cells->GetPointer(0), [this](std::int32_t triangle) {
        return triangle < 0 ? vtkIdType(-1) : vtkIdType(this->Surface.CellOfTriangle(triangle));
      });
    attributes->AddArray(cells);
  }
  return true;
}

void AddSummaryFields(vtkDataObject* output, const sb::DistanceSummary& summary)
{
  AddField(output, "DistanceMinimum", summary.Minimum);
  AddField(output, "DistanceMaximum", summary.Maximum);
  AddField(output, "DistanceMean", summary.Mean);
  AddField(output, "DistanceRMS", summary.RootMeanSquare);
  for (std::size_t i = 0; i < summary.Quantiles.size(); ++i)
  {
    const std::string name = "DistanceQuantile" + std::to_string(sb::DistanceSummary::Percent[i]);
    AddField(output, name.c_str(), summary.Quantiles[i]);
  }
}

} // namespace sbvtk
