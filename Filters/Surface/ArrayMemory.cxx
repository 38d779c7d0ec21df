// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayMemory.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"

#include <cstdlib>
#include <new>

namespace sbvtk
{

//------------------------------------------------------------------------------
void SetTuples(vtkAbstractArray* array, vtkIdType count)
{
  const vtkIdType values = count * array->GetNumberOfComponents();
  const bool plain =
    array->IsNumeric() && array->GetDataType() != VTK_BIT && array->HasStandardMemoryLayout();
  if (values <= 0 || !plain)
  {
    array->SetNumberOfTuples(count); // of objects: those throw by themselves
    return;
  }
  void* memory = std::malloc(
    static_cast<std::size_t>(values) * static_cast<std::size_t>(array->GetDataTypeSize()));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  array->SetVoidArray(memory, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
}

//------------------------------------------------------------------------------
void SetTuples(vtkPoints* points, vtkIdType count)
{
  SetTuples(points->GetData(), count);
  points->Modified();
}

//------------------------------------------------------------------------------
void CopyTuples(vtkDataArray* original, vtkDataArray* copy)
{
  copy->SetNumberOfComponents(original->GetNumberOfComponents());
  SetTuples(copy, original->GetNumberOfTuples());
  copy->DeepCopy(original); // finds enough memory, and asks for none
}

//------------------------------------------------------------------------------
void CopyTuples(vtkPoints* original, vtkPoints* copy)
{
  copy->SetDataType(original->GetDataType());
  CopyTuples(original->GetData(), copy->GetData());
  copy->Modified();
}

} // namespace sbvtk
