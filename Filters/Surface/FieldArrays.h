// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FieldArrays.h
 * @brief Arrays of VTK, and field data, from vectors.
 */
#ifndef FieldArrays_h
#define FieldArrays_h

#include "ArrayMemory.h"
#include "Boolean.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace sbvtk
{

/** An array whose values are still to be written, at GetPointer(0). @throw std::bad_alloc */
template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, int components, vtkIdType tuples)
{
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  SetTuples(array, tuples);
  return array;
}

/** An array with a copy of the values. @throw std::bad_alloc */
template <typename Array, typename Values>
vtkSmartPointer<Array> ArrayOf(const char* name, int components, const Values& values)
{
  const auto array =
    NewArray<Array>(name, components, static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

template <typename Array, typename Value>
void AddField(vtkDataObject* output, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  SetTuples(array, static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  output->GetFieldData()->AddArray(array);
}

/** One number, or one text. */
inline void AddField(vtkDataObject* output, const char* name, double value)
{
  AddField<vtkDoubleArray>(output, name, std::vector<double>{ value });
}
inline void AddField(vtkDataObject* output, const char* name, int value)
{
  AddField<vtkIntArray>(output, name, std::vector<int>{ value });
}
inline void AddField(vtkDataObject* output, const char* name, const std::string& text)
{
  AddField<vtkStringArray>(output, name, std::vector<std::string>{ text });
}

/** A number of things, which may be more than an int can count. */
inline void AddCount(vtkDataObject* output, const char* name, std::int64_t count)
{
  AddField<vtkIdTypeArray>(output, name, std::vector<vtkIdType>{ static_cast<vtkIdType>(count) });
}

/** The field arrays StageNames and StageSeconds. */
inline void AddStageFields(vtkDataObject* output, const std::vector<sb::StageTime>& times)
{
  std::vector<std::string> names;
  std::vector<double> seconds;
  for (const sb::StageTime& time : times)
  {
    names.emplace_back(time.Name);
    seconds.push_back(time.Seconds);
  }
  AddField<vtkStringArray>(output, "StageNames", names);
  AddField<vtkDoubleArray>(output, "StageSeconds", seconds);
}

} // namespace sbvtk

#endif
