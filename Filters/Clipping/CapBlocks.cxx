// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CapBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace sbvtk
{
namespace
{

constexpr int OfNone = -1;
constexpr int OfSeveral = -2;

/** Call `visit(cell, number of points, point ids)` for all cells in their order. */
template <class Visit>
void ForCells(vtkPolyData* data, Visit&& visit)
{
  vtkIdType cell = 0;
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      cells->GetCellAtId(i, size, points);
      visit(cell, size, points);
    }
  }
}

/** Of each point of the input the block of a cell at it; blocks share no points. */
vtkSmartPointer<vtkIntArray> BlocksOfPoints(vtkPolyData* input)
{
  const vtkSmartPointer<vtkIntArray> ofCells = NumbersFrom(0, input->GetCellData());
  const vtkIdType count = input->GetNumberOfPoints();
  const auto ofPoints = vtkSmartPointer<vtkIntArray>::New();
  ofPoints->SetName(BlockArray);
  ofPoints->SetNumberOfValues(count);
  ofPoints->FillValue(OfNone);
  ForCells(input, [&](vtkIdType cell, vtkIdType size, const vtkIdType* points) {
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (points[i] >= 0 && points[i] < count)
      {
        ofPoints->SetValue(points[i], ofCells->GetValue(cell));
      }
    }
  });
  return ofPoints;
}

int Together(int one, int other)
{
  return one == OfNone || one == other ? other : other == OfNone ? one : OfSeveral;
}

} // namespace

void MarkBlocks(vtkPolyData* input, const BlockNames& names, const TupleSources& points,
  vtkPolyData* output, sb::Executor& executor)
{
  if (names.empty())
  {
    return;
  }
  AddBlockNames(output, names);
  vtkNew<vtkPointData> ofInput;
  vtkNew<vtkPointData> ofOutput;
  ofInput->AddArray(BlocksOfPoints(input));
  AttributeUnion({ { ofInput, input->GetNumberOfPoints(), "Input" }, { nullptr, 0, "" } }, "point")
    .CopyTo(ofOutput, points, executor);
  vtkIntArray* corners = vtkIntArray::SafeDownCast(ofOutput->GetArray(BlockArray));
  vtkIntArray* blocks = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray(BlockArray));
  vtkNew<vtkIntArray> made;
  if (!blocks)
  {
    made->SetName(BlockArray);
    made->SetNumberOfValues(output->GetNumberOfCells());
    made->FillValue(OfNone);
    output->GetCellData()->AddArray(made);
    blocks = made;
  }
  ForCells(output, [&](vtkIdType cell, vtkIdType size, const vtkIdType* ids) {
    int block = blocks->GetValue(cell);
    for (vtkIdType i = 0; block != OfSeveral && corners && blocks->GetValue(cell) < 0 && i < size;
         ++i)
    {
      block = Together(block, corners->GetValue(ids[i]));
    }
    blocks->SetValue(cell, block == OfSeveral ? OfNone : block);
  });
}

} // namespace sbvtk
