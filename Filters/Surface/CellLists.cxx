// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellLists.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <atomic>
#include <cstdint>
#include <limits>

namespace sbvtk
{
namespace
{

constexpr std::int64_t grain = 65536;
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

/** The first cell that begins before the one before it ends, or ends beyond the list. */
template <class Id>
std::int64_t FirstOutside(
  const Id* offsets, std::int64_t count, std::int64_t length, sb::Executor& executor)
{
  std::atomic<std::int64_t> first{ none };
  executor.For(count, grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t cell = begin; cell < end; ++cell)
    {
      if (offsets[cell] < 0 || offsets[cell] > offsets[cell + 1] || offsets[cell + 1] > length)
      {
        std::int64_t before = first;
        while (cell < before && !first.compare_exchange_weak(before, cell))
        {
        }
        return;
      }
    }
  });
  return first;
}

std::int64_t FirstOutside(vtkCellArray* cells, sb::Executor& executor)
{
  const std::int64_t count = cells->GetNumberOfCells();
  const std::int64_t length = cells->GetNumberOfConnectivityIds();
  const void* offsets = count > 0 ? cells->GetOffsetsArray()->GetVoidPointer(0) : nullptr;
  return cells->IsStorage64Bit()
    ? FirstOutside(static_cast<const vtkTypeInt64*>(offsets), count, length, executor)
    : FirstOutside(static_cast<const vtkTypeInt32*>(offsets), count, length, executor);
}

} // namespace

std::string DamageOfCells(vtkPolyData* surface, sb::Executor& executor)
{
  std::int64_t before = 0;
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    const std::int64_t cell = FirstOutside(cells, executor);
    if (cell != none)
    {
      return "is damaged: cell " + std::to_string(before + cell) +
        " begins or ends outside of the list of the cells' points; repair the file or the filter "
        "that it comes from.";
    }
    before += cells->GetNumberOfCells();
  }
  return "";
}

} // namespace sbvtk
