// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceInput.h"

#include "ArrayMemory.h"
#include "AttributeUnion.h"
#include "CellLists.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <numeric>

namespace sbvtk
{
namespace
{

std::string Refusal(vtkDataObject* data)
{
  return std::string("is of type ") + data->GetClassName() +
    ", not a polygonal surface; apply Extract Surface to it first.";
}

/** Points of all leaves in one array, single precision only if all have it. */
vtkSmartPointer<vtkPoints> MergedPoints(const std::vector<vtkPolyData*>& leaves)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(VTK_FLOAT);
  vtkIdType numberOfPoints = 0;
  for (vtkPolyData* leaf : leaves)
  {
    numberOfPoints += leaf->GetNumberOfPoints();
    if (leaf->GetPoints() && leaf->GetPoints()->GetDataType() != VTK_FLOAT)
    {
      points->SetDataType(VTK_DOUBLE);
    }
  }
  SetTuples(points, numberOfPoints);
  vtkIdType first = 0;
  for (vtkPolyData* leaf : leaves)
  {
    if (leaf->GetNumberOfPoints() > 0)
    {
      points->InsertPoints(first, leaf->GetNumberOfPoints(), 0, leaf->GetPoints());
      first += leaf->GetNumberOfPoints();
    }
  }
  return points;
}

/** Copy ids of 32 or of 64 bits, each plus `shift`. @return the end of the copies */
vtkTypeInt64* CopyShifted(
  vtkDataArray* ids, vtkIdType count, vtkTypeInt64 shift, vtkTypeInt64* target)
{
  const void* source = count > 0 ? ids->GetVoidPointer(0) : nullptr;
  const auto shifted = [shift](vtkTypeInt64 id) { return id + shift; };
  return ids->GetDataTypeSize() == 8
    ? std::transform(static_cast<const vtkTypeInt64*>(source),
        static_cast<const vtkTypeInt64*>(source) + count, target, shifted)
    : std::transform(static_cast<const vtkTypeInt32*>(source),
        static_cast<const vtkTypeInt32*>(source) + count, target, shifted);
}

/** Cells of one kind of all leaves, in the order of the leaves. */
vtkSmartPointer<vtkCellArray> MergedCells(
  const std::vector<vtkPolyData*>& leaves, vtkCellArray* (vtkPolyData::*cellsOf)())
{
  vtkIdType numberOfCells = 0;
  vtkIdType numberOfCorners = 0;
  for (vtkPolyData* leaf : leaves)
  {
    numberOfCells += (leaf->*cellsOf)()->GetNumberOfCells();
    numberOfCorners += (leaf->*cellsOf)()->GetNumberOfConnectivityIds();
  }
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> corners;
  SetTuples(offsets, numberOfCells + 1);
  SetTuples(corners, numberOfCorners);
  vtkTypeInt64* nextOffset = offsets->GetPointer(0);
  vtkTypeInt64* nextCorner = corners->GetPointer(0);
  vtkTypeInt64 firstCorner = 0;
  vtkTypeInt64 firstPoint = 0;
  for (vtkPolyData* leaf : leaves)
  {
    vtkCellArray* cells = (leaf->*cellsOf)();
    const vtkIdType count = cells->GetNumberOfCells();
    nextOffset = CopyShifted(cells->GetOffsetsArray(), count, firstCorner, nextOffset);
    firstCorner += cells->GetNumberOfConnectivityIds();
    nextCorner = CopyShifted(
      cells->GetConnectivityArray(), cells->GetNumberOfConnectivityIds(), firstPoint, nextCorner);
    firstPoint += leaf->GetNumberOfPoints();
  }
  *nextOffset = firstCorner;
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, corners);
  return cells;
}

/** Numbers from 0 on, for as many as the largest leaf has tuples. */
std::vector<vtkIdType> Identity(std::int64_t count)
{
  std::vector<vtkIdType> ids(count);
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

void MergePointArrays(
  const std::vector<vtkPolyData*>& leaves, vtkPolyData* merged, sb::Executor& executor)
{
  std::vector<AttributeUnion::Source> sources;
  TupleSources from;
  std::int64_t most = 0;
  for (vtkPolyData* leaf : leaves)
  {
    sources.push_back({ leaf->GetPointData(), leaf->GetNumberOfPoints(), "a block" });
    most = std::max<std::int64_t>(most, leaf->GetNumberOfPoints());
  }
  const std::vector<vtkIdType> ids = Identity(most);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    from.Runs.push_back({ static_cast<std::int32_t>(leaf), from.NumberOfTuples,
      leaves[leaf]->GetNumberOfPoints(), nullptr, ids.data() });
    from.NumberOfTuples += leaves[leaf]->GetNumberOfPoints();
  }
  AttributeUnion(sources, "point").CopyTo(merged->GetPointData(), from, executor);
}

/** Call `visit(leaf, cells)` in the order of the merged cells, which goes by kind first: all
 * vertices, all lines, polygons, strips. */
template <class Visit>
void ForCellsOfLeaves(const std::vector<vtkPolyData*>& leaves, Visit&& visit)
{
  for (const auto cellsOf : { &vtkPolyData::GetVerts, &vtkPolyData::GetLines,
         &vtkPolyData::GetPolys, &vtkPolyData::GetStrips })
  {
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    {
      visit(leaf, (leaves[leaf]->*cellsOf)()->GetNumberOfCells());
    }
  }
}

void MergeCellArrays(
  const std::vector<vtkPolyData*>& leaves, vtkPolyData* merged, sb::Executor& executor)
{
  std::vector<AttributeUnion::Source> sources;
  std::int64_t most = 0;
  for (vtkPolyData* leaf : leaves)
  {
    sources.push_back({ leaf->GetCellData(), leaf->GetNumberOfCells(), "a block" });
    most = std::max<std::int64_t>(most, leaf->GetNumberOfCells());
  }
  const std::vector<vtkIdType> ids = Identity(most);
  std::vector<std::int64_t> firstOfKind(leaves.size(), 0);
  TupleSources from;
  ForCellsOfLeaves(leaves, [&](std::size_t leaf, std::int64_t count) {
    from.Runs.push_back({ static_cast<std::int32_t>(leaf), from.NumberOfTuples, count, nullptr,
      ids.data() + firstOfKind[leaf] });
    from.NumberOfTuples += count;
    firstOfKind[leaf] += count;
  });
  AttributeUnion(sources, "cell").CopyTo(merged->GetCellData(), from, executor);
}

vtkSmartPointer<vtkPolyData> Merge(const std::vector<vtkPolyData*>& leaves, sb::Executor& executor)
{
  const auto merged = vtkSmartPointer<vtkPolyData>::New();
  merged->SetPoints(MergedPoints(leaves));
  merged->SetVerts(MergedCells(leaves, &vtkPolyData::GetVerts));
  merged->SetLines(MergedCells(leaves, &vtkPolyData::GetLines));
  merged->SetPolys(MergedCells(leaves, &vtkPolyData::GetPolys));
  merged->SetStrips(MergedCells(leaves, &vtkPolyData::GetStrips));
  MergePointArrays(leaves, merged, executor);
  MergeCellArrays(leaves, merged, executor);
  return merged;
}

/** The surfaces of all leaves as one. */
vtkSmartPointer<vtkPolyData> Together(
  const std::vector<vtkPolyData*>& leaves, sb::Executor& executor)
{
  if (leaves.size() != 1)
  {
    return Merge(leaves, executor);
  }
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(leaves.front());
  return copy;
}

void MarkBlocks(const std::vector<vtkPolyData*>& leaves, const std::vector<int>& blockOfLeaf,
  int firstBlock, vtkPolyData* merged)
{
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(BlockArray);
  numbers->SetNumberOfValues(merged->GetNumberOfCells());
  int* next = numbers->GetPointer(0);
  ForCellsOfLeaves(leaves, [&](std::size_t leaf, std::int64_t count) {
    next = std::fill_n(next, count, firstBlock + blockOfLeaf[leaf]);
  });
  merged->GetCellData()->AddArray(numbers);
}

} // namespace

//------------------------------------------------------------------------------
std::string SurfaceInput::Read(vtkDataObject* data, sb::Executor& executor, int firstBlock)
{
  if (vtkPolyData* surface = vtkPolyData::SafeDownCast(data))
  {
    const std::string damage = DamageOfCells(surface, executor);
    if (damage.empty())
    {
      this->ReadSurface(surface, firstBlock);
    }
    return damage;
  }
  if (!vtkCompositeDataSet::SafeDownCast(data))
  {
    return data ? Refusal(data) : "has no data; update the filter before it.";
  }
  Blocks blocks = BlocksOf(data);
  std::vector<vtkPolyData*> leaves;
  std::vector<vtkMTimeType> leafTimes;
  for (vtkDataObject* leaf : blocks.Leaves)
  {
    if (!vtkPolyData::SafeDownCast(leaf))
    {
      return "has a block that " + Refusal(leaf);
    }
    const std::string damage = DamageOfCells(vtkPolyData::SafeDownCast(leaf), executor);
    if (!damage.empty())
    {
      return "has a block that " + damage;
    }
    leaves.push_back(vtkPolyData::SafeDownCast(leaf));
    leafTimes.push_back(leaf->GetMTime());
  }
  if (leafTimes.empty() || leafTimes != this->LeafTimes || firstBlock != this->FirstBlock ||
    blocks.Names != this->NamesOfBlocks)
  {
    this->Current = Together(leaves, executor);
    if (!blocks.Names.empty())
    {
      MarkBlocks(leaves, blocks.BlockOfLeaf, firstBlock, this->Current);
    }
    this->LeafTimes = std::move(leafTimes);
    this->NamesOfBlocks = std::move(blocks.Names);
    this->FirstBlock = firstBlock;
  }
  return "";
}

//------------------------------------------------------------------------------
/** A surface that was merged of blocks by an earlier filter still has them. */
void SurfaceInput::ReadSurface(vtkPolyData* surface, int firstBlock)
{
  this->LeafTimes.clear();
  this->Current = surface;
  this->NamesOfBlocks = CarriedBlockNames(surface, surface->GetCellData());
  if (!this->NamesOfBlocks.empty() && firstBlock > 0)
  {
    this->Current = vtkSmartPointer<vtkPolyData>::New();
    this->Current->ShallowCopy(surface);
    this->Current->GetCellData()->AddArray(NumbersFrom(firstBlock, surface->GetCellData()));
  }
}

} // namespace sbvtk
