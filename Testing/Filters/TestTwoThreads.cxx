// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTwoThreads.cxx
 * @brief Two filters of a class may run at once, on the same inputs: each gives what it gives
 * alone.
 *
 * Build it with -fsanitize=thread to see that nothing is shared that one of them writes to
 * (ARCHITECTURE.md, Tests).
 */
#include "vtkPointSetBooleanFilter.h"
#include "vtkPointSetIntersectionFilter.h"
#include "vtkPointSetSurfaceFilter.h"
#include "vtkPolyDataBooleanOperationFilter.h"
#include "vtkPolyDataClipClosedSurface.h"
#include "vtkPolyDataContourTriangulator.h"
#include "vtkPolyDataCutClosedSurface.h"
#include "vtkPolyDataDistance.h"
#include "vtkPolyDataDistanceField.h"
#include "vtkPolyDataIntersection.h"
#include "vtkPolyDataSurfaceCheck.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace
{

using Maker = std::function<vtkSmartPointer<vtkAlgorithm>()>;

vtkSmartPointer<vtkPolyData> Ball(double x)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(60);
  source->SetPhiResolution(40);
  source->SetCenter(x, 0.02, 0.01);
  source->Update();
  return source->GetOutput();
}

template <class Filter>
vtkSmartPointer<Filter> Made(const std::vector<vtkSmartPointer<vtkPolyData>>& inputs)
{
  const auto filter = vtkSmartPointer<Filter>::New();
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    filter->SetInputDataObject(static_cast<int>(port), inputs[port]);
  }
  filter->SetNumberOfThreads(2);
  return filter;
}

/** The points and the polygons of all outputs, and the active scalars. */
std::vector<double> Content(vtkAlgorithm* filter)
{
  std::vector<double> content;
  const auto add = [&content](vtkDataArray* array) {
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      content.push_back(array->GetVariantValue(i).ToDouble());
    }
  };
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataSet* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    add(data->GetPointData()->GetScalars());
    if (vtkPolyData* surface = vtkPolyData::SafeDownCast(data))
    {
      add(surface->GetPoints() ? surface->GetPoints()->GetData() : nullptr);
      add(surface->GetPolys()->GetConnectivityArray());
      add(surface->GetLines()->GetConnectivityArray());
    }
  }
  return content;
}

std::vector<double> Updated(const Maker& make)
{
  const vtkSmartPointer<vtkAlgorithm> filter = make();
  filter->Update();
  return Content(filter);
}

/** @return whether two at once give what one alone does, every time. */
bool AgreesWithItself(const Maker& make)
{
  const std::vector<double> alone = Updated(make);
  bool agrees = !alone.empty();
  for (int round = 0; round < 3; ++round)
  {
    std::vector<double> answers[2];
    std::thread first([&] { answers[0] = Updated(make); });
    std::thread second([&] { answers[1] = Updated(make); });
    first.join();
    second.join();
    agrees = agrees && answers[0] == alone && answers[1] == alone;
  }
  return agrees;
}

} // namespace

int main()
{
  const vtkSmartPointer<vtkPolyData> body = Ball(0.0);
  const vtkSmartPointer<vtkPolyData> tool = Ball(0.3);
  const auto outline = [&body] {
    const auto filter = Made<vtkPolyDataClipClosedSurface>({ body });
    filter->SetUsePlane(1);
    filter->SetNormal(0.1, 0.2, 1.0);
    filter->SetGenerateOutline(1);
    return filter;
  };
  const auto clipped = outline();
  clipped->Update();
  const vtkSmartPointer<vtkPolyData> contours =
    vtkPolyData::SafeDownCast(clipped->GetOutputDataObject(1));

  const std::vector<std::pair<std::string, Maker>> filters = {
    { "Boolean",
      [&] {
        return Made<vtkPolyDataBooleanOperationFilter>({ body, tool });
      } },
    { "Intersection",
      [&] {
        return Made<vtkPolyDataIntersection>({ body, tool });
      } },
    { "Distance",
      [&] {
        return Made<vtkPolyDataDistance>({ body, tool });
      } },
    { "DistanceField",
      [&] {
        const auto filter = Made<vtkPolyDataDistanceField>({ body });
        filter->SetDimensions(20, 20, 20);
        return filter;
      } },
    { "SurfaceCheck", [&] { return Made<vtkPolyDataSurfaceCheck>({ body }); } },
    { "ClipClosedSurface", outline },
    { "CutClosedSurface", [&] { return Made<vtkPolyDataCutClosedSurface>({ body }); } },
    { "ContourTriangulator",
      [&] {
        const auto filter = vtkSmartPointer<vtkPolyDataContourTriangulator>::New();
        filter->SetInputDataObject(contours);
        return filter;
      } },
    { "PointSetSurface",
      [&] {
        const auto filter = Made<vtkPointSetSurfaceFilter>({ body });
        filter->SetGenerateSurface(1);
        return filter;
      } },
    { "PointSetIntersection",
      [&] {
        return Made<vtkPointSetIntersectionFilter>({ body, tool });
      } },
    { "PointSetBoolean",
      [&] {
        return Made<vtkPointSetBooleanFilter>({ body, tool });
      } },
  };
  int failures = 0;
  for (const auto& [name, make] : filters)
  {
    const bool agrees = AgreesWithItself(make);
    std::printf("%s %s\n", agrees ? "ok  " : "FAIL", name.c_str());
    failures += agrees ? 0 : 1;
  }
  return failures;
}
