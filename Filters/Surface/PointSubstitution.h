// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointSubstitution.h
 * @brief A surface in which some points give way to others, or are left out.
 */
#ifndef PointSubstitution_h
#define PointSubstitution_h

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

namespace sbvtk
{

/** For each point the one that stands for it, itself or an earlier one that stands for itself; -1
 * if it is left out. */
using Substitutes = std::vector<vtkIdType>;

/** The surface with those points only that stand for themselves; cells with points that are left
 * out have to be gone already. */
vtkSmartPointer<vtkPolyData> Substitute(vtkPolyData* surface, const Substitutes& substitutes);

/** Call `visit` with each point id of the cells that names a point. */
template <class Ids, class Visitor>
void ForEachId(Ids* ids, std::size_t numberOfPoints, const Visitor& visit)
{
  for (auto id = ids->GetPointer(0); id != ids->GetPointer(0) + ids->GetNumberOfValues(); ++id)
  {
    if (*id >= 0 && static_cast<std::size_t>(*id) < numberOfPoints)
    {
      visit(*id);
    }
  }
}
template <class Visitor>
void ForEachId(vtkCellArray* cells, std::size_t numberOfPoints, const Visitor& visit)
{
  cells->IsStorage64Bit() ? ForEachId(cells->GetConnectivityArray64(), numberOfPoints, visit)
                          : ForEachId(cells->GetConnectivityArray32(), numberOfPoints, visit);
}

} // namespace sbvtk

#endif
