// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FieldArrays.h
 * @brief Plain values as arrays of a data set's field data.
 */
#ifndef FieldArrays_h
#define FieldArrays_h

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <vector>

namespace sbvtk
{

template <typename Array, typename Value>
void AddField(vtkDataObject* output, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  output->GetFieldData()->AddArray(array);
}

} // namespace sbvtk

#endif
