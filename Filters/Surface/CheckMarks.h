// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckMarks.h
 * @brief The surface that was checked, with arrays to colour and select by.
 */
#ifndef CheckMarks_h
#define CheckMarks_h

#include "OperandSurface.h"
#include "SurfaceCheck.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace sbvtk
{

/** [cell of the data set] what is wrong with it: sb::BitOf of each defect. */
class CellMarks
{
public:
  CellMarks(const OperandSurface& surface, const sb::SurfaceCheckResult& result);

  bool Has(vtkIdType cell, sb::Defect defect) const
  {
    return (this->Marks[static_cast<std::size_t>(cell)] & sb::BitOf(defect)) != 0;
  }
  std::int64_t Count(sb::Defect defect) const;

  /** The one to show: what hides others behind it comes first. */
  sb::Defect Gravest(vtkIdType cell) const;

  /** Cells that cannot be drawn: they name no point, or one without a place. */
  bool IsUnusable(vtkIdType cell) const
  {
    return this->Has(cell, sb::Defect::BadIndex) || this->Has(cell, sb::Defect::NotFinite);
  }
  /** All of them, ascending. */
  std::vector<vtkIdType> Unusable() const;

private:
  std::vector<std::uint16_t> Marks;
};

/** The points whose coordinates are not finite, ascending. */
std::vector<vtkIdType> PointsWithoutPlace(const sb::SurfaceCheckResult& result);

/** Make `output` the surface without its unusable cells and the points that have no place, and add
 * the arrays. */
void BuildMarkedSurface(const OperandSurface& surface, const sb::SurfaceCheckResult& result,
  const CellMarks& marks, vtkPolyData* output);

} // namespace sbvtk

#endif
