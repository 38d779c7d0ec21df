// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NURBSArrays.h"

#include "ArrayMemory.h"
#include "FieldArrays.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdint>

namespace sbvtk
{
namespace
{

constexpr const char* degreesName = "NURBSDegrees";
constexpr const char* countsName = "NURBSCounts";
constexpr const char* knotsName = "NURBSKnots";
constexpr const char* polesName = "NURBSPoles";

/** The numbers of a field array one by one, whatever their type. */
class Numbers
{
public:
  Numbers(vtkDataObject* data, const char* name, int components)
  {
    vtkDataArray* array = data->GetFieldData()->GetArray(name);
    if (array && array->GetNumberOfComponents() == components)
    {
      CopyTuples(array, this->Values);
      this->Found = true;
    }
  }

  bool AreThere() const { return this->Found; }
  std::int64_t Left() const { return this->Values->GetNumberOfValues() - this->Next; }

  int TakeInt()
  {
    const double value = *this->Take(1);
    return value >= 0.0 && value < 1e9 ? static_cast<int>(value) : 0;
  }

  const double* Take(std::int64_t count)
  {
    const double* values = this->Values->GetPointer(this->Next);
    this->Next += count;
    return values;
  }

private:
  vtkNew<vtkDoubleArray> Values;
  std::int64_t Next = 0;
  bool Found = false;
};

/** All four arrays, read patch by patch. */
struct Arrays
{
  explicit Arrays(vtkDataObject* data)
    : Degrees(data, degreesName, 2)
    , Counts(data, countsName, 2)
    , Knots(data, knotsName, 1)
    , Poles(data, polesName, 4)
  {
  }

  bool AreThere() const
  {
    return this->Degrees.AreThere() && this->Counts.AreThere() && this->Knots.AreThere() &&
      this->Poles.AreThere();
  }

  /** The next patch; false if the arrays are too short for it. */
  bool Read(sb::NURBSSurface& patch)
  {
    patch.DegreeU = this->Degrees.TakeInt();
    patch.DegreeV = this->Degrees.TakeInt();
    patch.CountU = this->Counts.TakeInt();
    patch.CountV = this->Counts.TakeInt();
    const std::int64_t knotsU = std::int64_t{ patch.CountU } + patch.DegreeU + 1;
    const std::int64_t knotsV = std::int64_t{ patch.CountV } + patch.DegreeV + 1;
    const std::int64_t poles = std::int64_t{ patch.CountU } * patch.CountV;
    if (this->Knots.Left() < knotsU + knotsV || this->Poles.Left() / 4 < poles)
    {
      return false;
    }
    const double* knots = this->Knots.Take(knotsU + knotsV);
    patch.KnotsU.assign(knots, knots + knotsU);
    patch.KnotsV.assign(knots + knotsU, knots + knotsU + knotsV);
    const double* values = this->Poles.Take(4 * poles);
    patch.Poles.assign(values, values + 4 * poles);
    return true;
  }

  Numbers Degrees;
  Numbers Counts;
  Numbers Knots;
  Numbers Poles;
};

template <typename Array>
Array* AddArray(vtkDataObject* data, const char* name, int components)
{
  const auto array = NewArray<Array>(name, components, 0);
  data->GetFieldData()->AddArray(array);
  return array;
}

} // namespace

void AttachPatches(vtkDataObject* data, const std::vector<sb::NURBSSurface>& patches)
{
  auto* degrees = AddArray<vtkIntArray>(data, degreesName, 2);
  auto* counts = AddArray<vtkIntArray>(data, countsName, 2);
  auto* knots = AddArray<vtkDoubleArray>(data, knotsName, 1);
  auto* poles = AddArray<vtkDoubleArray>(data, polesName, 4);
  for (const sb::NURBSSurface& patch : patches)
  {
    degrees->InsertNextTuple2(patch.DegreeU, patch.DegreeV);
    counts->InsertNextTuple2(patch.CountU, patch.CountV);
    for (const std::vector<double>* values : { &patch.KnotsU, &patch.KnotsV })
    {
      for (const double knot : *values)
      {
        knots->InsertNextValue(knot);
      }
    }
    for (std::size_t i = 0; i < patch.Poles.size(); i += 4)
    {
      poles->InsertNextTuple(patch.Poles.data() + i);
    }
  }
}

bool HasPatchArrays(vtkDataObject* data)
{
  const char* const names[] = { degreesName, countsName, knotsName, polesName };
  return std::any_of(std::begin(names), std::end(names),
    [data](const char* name) { return data->GetFieldData()->GetArray(name) != nullptr; });
}

std::string ReadPatches(vtkDataObject* data, std::vector<sb::NURBSSurface>& patches)
{
  patches.clear();
  if (!HasPatchArrays(data))
  {
    return "";
  }
  Arrays arrays(data);
  if (!arrays.AreThere() || arrays.Degrees.Left() != arrays.Counts.Left())
  {
    return std::string("has not all of the field arrays ") + degreesName + ", " + countsName +
      ", " + knotsName + " and " + polesName + " of exact surfaces";
  }
  std::vector<sb::NURBSSurface> found(static_cast<std::size_t>(arrays.Degrees.Left() / 2));
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const bool complete = arrays.Read(found[i]);
    const char* fault = complete ? sb::FaultOf(found[i]) : "is cut off";
    if (fault)
    {
      return "has field arrays of exact surfaces of which number " + std::to_string(i) + " " +
        fault;
    }
  }
  patches = std::move(found);
  return "";
}

} // namespace sbvtk
