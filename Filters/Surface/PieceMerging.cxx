// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceMerging.h"

#include "BorderJoining.h"
#include "CellLists.h"
#include "PointSubstitution.h"
#include "SurfaceInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>

namespace sbvtk
{
namespace
{

constexpr auto kinds = { &vtkPolyData::GetVerts, &vtkPolyData::GetLines, &vtkPolyData::GetPolys,
  &vtkPolyData::GetStrips };

/** A mark each of so many points or cells, or null. */
const unsigned char* MarksOf(vtkDataSetAttributes* attributes, vtkIdType count)
{
  vtkUnsignedCharArray* marks = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  return marks && marks->GetNumberOfTuples() == count ? marks->GetPointer(0) : nullptr;
}

std::vector<bool> UsedPoints(vtkPolyData* surface)
{
  std::vector<bool> used(static_cast<std::size_t>(surface->GetNumberOfPoints()), false);
  for (const auto cellsOf : kinds)
  {
    ForEachId((surface->*cellsOf)(), used.size(),
      [&used](const auto& id) { used[static_cast<std::size_t>(id)] = true; });
  }
  return used;
}

/** The piece with all of its points and the cells that are not marked. */
vtkSmartPointer<vtkPolyData> WithoutCells(vtkPolyData* piece, const unsigned char* marks)
{
  constexpr int others = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(piece);
  vtkNew<vtkIdList> kept;
  vtkNew<vtkIdList> places;
  vtkIdType cell = 0;
  const auto keptOf = [&](vtkCellArray* cells) {
    const auto own = vtkSmartPointer<vtkCellArray>::New();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++cell)
    {
      if (!(marks[cell] & others))
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        cells->GetCellAtId(i, size, corners);
        own->InsertNextCell(size, corners);
        places->InsertNextId(kept->GetNumberOfIds());
        kept->InsertNextId(cell);
      }
    }
    return own;
  };
  result->SetVerts(keptOf(piece->GetVerts()));
  result->SetLines(keptOf(piece->GetLines()));
  result->SetPolys(keptOf(piece->GetPolys()));
  result->SetStrips(keptOf(piece->GetStrips()));
  vtkNew<vtkCellData> attributes;
  attributes->CopyAllOn();
  attributes->CopyAllocate(piece->GetCellData(), kept->GetNumberOfIds());
  attributes->CopyData(piece->GetCellData(), kept, places);
  result->GetCellData()->ShallowCopy(attributes);
  return result;
}

void MergeFieldData(const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkPolyData* merged)
{
  vtkNew<vtkFieldData> fields;
  for (const bool withValues : { true, false })
  {
    for (vtkPolyData* piece : pieces)
    {
      vtkFieldData* own = piece->GetFieldData();
      for (int i = 0; i < own->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* array = own->GetAbstractArray(i);
        if ((array->GetNumberOfTuples() > 0) == withValues && array->GetName() &&
          !fields->HasArray(array->GetName()))
        {
          fields->AddArray(array);
        }
      }
    }
  }
  merged->SetFieldData(fields);
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithoutGhosts(vtkPolyData* piece)
{
  const unsigned char* ofCells = MarksOf(piece->GetCellData(), piece->GetNumberOfCells());
  const unsigned char* ofPoints = MarksOf(piece->GetPointData(), piece->GetNumberOfPoints());
  sb::SerialExecutor executor;
  if ((!ofCells && !ofPoints) || piece->GetNumberOfPoints() == 0 ||
    !DamageOfCells(piece, executor).empty()) // which whoever gets it will tell
  {
    return piece;
  }
  const vtkSmartPointer<vtkPolyData> copy =
    ofCells ? WithoutCells(piece, ofCells) : vtkSmartPointer<vtkPolyData>(piece);
  const std::vector<bool> before = UsedPoints(piece);
  const std::vector<bool> after = UsedPoints(copy);
  constexpr int others = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  Substitutes substitutes(before.size());
  for (std::size_t i = 0; i < substitutes.size(); ++i)
  {
    const bool leave = !after[i] && (before[i] || (ofPoints && (ofPoints[i] & others)));
    substitutes[i] = leave ? -1 : static_cast<vtkIdType>(i);
  }
  const auto result = Substitute(copy, substitutes);
  result->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  result->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MergePieces(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, sb::Executor& executor)
{
  vtkNew<vtkPartitionedDataSet> filled; // whose parts become one surface
  std::vector<vtkIdType> ends;
  vtkIdType end = 0;
  for (vtkPolyData* piece : pieces)
  {
    if (!DamageOfCells(piece, executor).empty())
    {
      return piece; // nothing can be made of it, and whoever gets it will tell
    }
    if (piece->GetNumberOfPoints() > 0)
    {
      filled->SetPartition(filled->GetNumberOfPartitions(), piece);
      ends.push_back(end += piece->GetNumberOfPoints());
    }
  }
  const auto merged = vtkSmartPointer<vtkPolyData>::New();
  SurfaceInput parts;
  if (ends.size() > 1 && parts.Read(filled, executor).empty())
  {
    merged->ShallowCopy(JoinBorders(parts.Surface(), ends));
  }
  else
  {
    merged->ShallowCopy(ends.empty() ? pieces.front().Get() : filled->GetPartitionAsDataObject(0));
  }
  MergeFieldData(pieces, merged);
  return merged;
}

} // namespace sbvtk
