// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AllFilters.h
 * @brief The filters of surfaces and clouds in C++, for tests that need threads beside that of an
 * update, which Python does not let run.
 */
#ifndef AllFilters_h
#define AllFilters_h

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

#include <functional>
#include <string>
#include <utility>
#include <vector>

using Maker = std::function<vtkSmartPointer<vtkAlgorithm>()>;

inline vtkSmartPointer<vtkPolyData> Ball(int resolution, double x)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(3 * resolution);
  source->SetPhiResolution(2 * resolution);
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
inline std::vector<double> Content(vtkAlgorithm* filter)
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

/** All by their names, each with bodies of 12 resolution^2 triangles. */
inline std::vector<std::pair<std::string, Maker>> AllFilters(int resolution)
{
  const vtkSmartPointer<vtkPolyData> body = Ball(resolution, 0.0);
  const vtkSmartPointer<vtkPolyData> tool = Ball(resolution, 0.3);
  const auto outline = [body] {
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

  return {
    { "Boolean",
      [body, tool] {
        return Made<vtkPolyDataBooleanOperationFilter>({ body, tool });
      } },
    { "Intersection",
      [body, tool] {
        return Made<vtkPolyDataIntersection>({ body, tool });
      } },
    { "Distance",
      [body, tool] {
        return Made<vtkPolyDataDistance>({ body, tool });
      } },
    { "DistanceField",
      [body] {
        const auto filter = Made<vtkPolyDataDistanceField>({ body });
        filter->SetDimensions(20, 20, 20);
        return filter;
      } },
    { "SurfaceCheck", [body] { return Made<vtkPolyDataSurfaceCheck>({ body }); } },
    { "ClipClosedSurface", outline },
    { "CutClosedSurface", [body] { return Made<vtkPolyDataCutClosedSurface>({ body }); } },
    { "ContourTriangulator",
      [contours] {
        const auto filter = vtkSmartPointer<vtkPolyDataContourTriangulator>::New();
        filter->SetInputDataObject(contours);
        return filter;
      } },
    { "PointSetSurface",
      [body] {
        const auto filter = Made<vtkPointSetSurfaceFilter>({ body });
        filter->SetGenerateSurface(1);
        return filter;
      } },
    { "PointSetIntersection",
      [body, tool] {
        return Made<vtkPointSetIntersectionFilter>({ body, tool });
      } },
    { "PointSetBoolean",
      [body, tool] {
        return Made<vtkPointSetBooleanFilter>({ body, tool });
      } },
  };
}

#endif
