// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FieldArrays.h
 * @brief Field data from vectors.
 */
#ifndef FieldArrays_h
#define FieldArrays_h

#include "ArrayMemory.h"
#include "Boolean.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

namespace sbvtk
{

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
