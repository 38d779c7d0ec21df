// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointSubstitution.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <type_traits>

namespace sbvtk
{
namespace
{

vtkSmartPointer<vtkCellArray> Renumbered(vtkCellArray* cells, const std::vector<vtkIdType>& names)
{
  const auto copy = vtkSmartPointer<vtkCellArray>::New();
  copy->DeepCopy(cells);
  ForEachId(copy, names.size(), [&names](auto& id) {
    id = static_cast<std::decay_t<decltype(id)>>(names[static_cast<std::size_t>(id)]);
  });
  return copy;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Substitute(vtkPolyData* surface, const Substitutes& substitutes)
{
  vtkNew<vtkIdList> kept;
  vtkNew<vtkIdList> places;
  std::vector<vtkIdType> names(substitutes.size(), 0);
  for (std::size_t i = 0; i < substitutes.size(); ++i)
  {
    const vtkIdType point = static_cast<vtkIdType>(i);
    if (substitutes[i] == point)
    {
      names[i] = kept->GetNumberOfIds();
      places->InsertNextId(kept->GetNumberOfIds());
      kept->InsertNextId(point);
    }
    else if (substitutes[i] >= 0)
    {
      names[i] = names[static_cast<std::size_t>(substitutes[i])];
    }
  }
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  surface->GetPoints()->GetPoints(kept, points);
  result->SetPoints(points);
  vtkNew<vtkPointData> attributes;
  attributes->CopyAllOn();
  attributes->CopyAllocate(surface->GetPointData(), kept->GetNumberOfIds());
  attributes->CopyData(surface->GetPointData(), kept, places);
  result->GetPointData()->ShallowCopy(attributes);
  result->SetVerts(Renumbered(surface->GetVerts(), names));
  result->SetLines(Renumbered(surface->GetLines(), names));
  result->SetPolys(Renumbered(surface->GetPolys(), names));
  result->SetStrips(Renumbered(surface->GetStrips(), names));
  return result;
}

} // namespace sbvtk
