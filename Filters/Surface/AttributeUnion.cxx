// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AttributeUnion.h"

#include "ArrayMemory.h"
#include "BlockNames.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace sbvtk
{
namespace
{

constexpr std::int64_t grain = 8192;

bool IsFloating(int type) { return type == VTK_FLOAT || type == VTK_DOUBLE; }

bool IsSigned(int type) { return vtkDataArray::GetDataTypeMin(type) < 0.0; }

/** The smallest number type that holds the values of both; 64-bit integers against other kinds
 * become doubles. */
int CommonType(int a, int b)
{
  const int sizeA = vtkAbstractArray::GetDataTypeSize(a);
  const int sizeB = vtkAbstractArray::GetDataTypeSize(b);
  if (a == b)
  {
    return a;
  }
  if (IsFloating(a) || IsFloating(b))
  {
    const bool fitsFloat = (a == VTK_FLOAT || (!IsFloating(a) && sizeA <= 2)) &&
      (b == VTK_FLOAT || (!IsFloating(b) && sizeB <= 2));
    return fitsFloat ? VTK_FLOAT : VTK_DOUBLE;
  }
  if (IsSigned(a) == IsSigned(b))
  {
    return sizeA >= sizeB ? a : b;
  }
  const int unsignedSize = IsSigned(a) ? sizeB : sizeA;
  const int size = std::max(std::max(sizeA, sizeB), 2 * unsignedSize);
  return size <= 2 ? VTK_SHORT : size <= 4 ? VTK_INT : size <= 8 ? VTK_LONG_LONG : VTK_DOUBLE;
}

/** As a plain array of that number type, copied only where it is none. */
vtkSmartPointer<vtkAbstractArray> AsType(vtkAbstractArray* array, int type)
{
  if (array->GetDataType() == type && array->HasStandardMemoryLayout())
  {
    return array;
  }
  const auto converted = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  CopyTuples(vtkDataArray::SafeDownCast(array), converted);
  return converted;
}

/** Bits have no address of their own, so they are carried as bytes. */
int CarriedType(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array->GetDataType();
}

/** Numbers of faces, solids and blocks: there is none between two of them, and 0 is one. */
bool NamesAPart(const std::string& name)
{
  return name == "FaceId" || name == "SolidId" || name == BlockArray;
}

template <typename Value>
Value FillValue(const std::string& name)
{
  if (std::is_floating_point<Value>::value)
  {
    return std::numeric_limits<Value>::quiet_NaN();
  }
  return NamesAPart(name) ? Value(-1) : Value(0);
}

template <typename Value>
Value Rounded(double value)
{
  return static_cast<Value>(std::is_floating_point<Value>::value ? value : std::nearbyint(value));
}

int NearestCorner(const sb::InterpolatedPoint& point)
{
  return static_cast<int>(
    std::max_element(point.Weights.begin(), point.Weights.end()) - point.Weights.begin());
}

/** One array's tuples as numbers of one type. */
template <typename Value>
struct NumberColumn
{
  std::vector<const Value*> Sources;
  Value* Target = nullptr;
  Value Fill = Value();
  int Components = 1;
  bool TakeNearest = false;

  void Copy(const CopyRun& run, std::int64_t begin, std::int64_t end) const
  {
    if (const Value* source = this->Sources[run.Operand])
    {
      CopyEntries(run, begin, end, reinterpret_cast<const char*>(source),
        reinterpret_cast<char*>(this->Target),
        static_cast<std::int64_t>(sizeof(Value)) * this->Components);
      return;
    }
    std::fill(this->Target + (run.First + begin) * this->Components,
      this->Target + (run.First + end) * this->Components, this->Fill);
  }

  void Interpolate(const sb::InterpolatedPoint& point, std::int64_t tuple) const
  {
    Value* target = this->Target + tuple * this->Components;
    const Value* source = this->Sources[point.Operand];
    if (!source)
    {
      std::fill_n(target, this->Components, this->Fill);
      return;
    }
    if (this->TakeNearest)
    {
      const std::int64_t id = point.PointIds[NearestCorner(point)];
      std::copy_n(source + id * this->Components, this->Components, target);
      return;
    }
    for (int component = 0; component < this->Components; ++component)
    {
      double sum = 0.0;
      for (int corner = 0; corner < 3; ++corner)
      {
        // A corner without weight has no say, not even with a NaN.
        if (point.Weights[corner] != 0.0)
        {
          const std::int64_t id = point.PointIds[corner];
          sum +=
            point.Weights[corner] * static_cast<double>(source[id * this->Components + component]);
        }
      }
      target[component] = Rounded<Value>(sum);
    }
  }
};

template <typename Value>
void CarryNumbers(
  const NumberColumn<Value>& column, const TupleSources& from, sb::Executor& executor)
{
  for (const CopyRun& run : from.Runs)
  {
    executor.For(run.Count, grain,
      [&](std::int64_t begin, std::int64_t end) { column.Copy(run, begin, end); });
  }
  if (from.Interpolated)
  {
    executor.For(static_cast<std::int64_t>(from.Interpolated->size()), grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          column.Interpolate((*from.Interpolated)[i], from.FirstInterpolated + i);
        }
      });
  }
  const std::int64_t firstRepeated =
    from.NumberOfTuples - static_cast<std::int64_t>(from.Repeated.size());
  for (std::size_t i = 0; i < from.Repeated.size(); ++i)
  {
    std::copy_n(column.Target + static_cast<std::int64_t>(from.Repeated[i]) * column.Components,
      column.Components,
      column.Target + (firstRepeated + static_cast<std::int64_t>(i)) * column.Components);
  }
}

template <typename Value>
void CarryNumbers(const std::vector<vtkSmartPointer<vtkAbstractArray>>& sources,
  vtkAbstractArray* target, bool takeNearest, const TupleSources& from, sb::Executor& executor)
{
  NumberColumn<Value> column;
  for (const vtkSmartPointer<vtkAbstractArray>& source : sources)
  {
    column.Sources.push_back(
      source ? static_cast<const Value*>(source->GetVoidPointer(0)) : nullptr);
  }
  column.Target = static_cast<Value*>(target->GetVoidPointer(0));
  column.Fill = FillValue<Value>(target->GetName());
  column.Components = target->GetNumberOfComponents();
  column.TakeNearest = takeNearest;
  CarryNumbers(column, from, executor);
}

/** Texts and variants: through the arrays' own interface, one tuple at a time. */
void CarryObjects(const std::vector<vtkSmartPointer<vtkAbstractArray>>& sources,
  vtkAbstractArray* target, const TupleSources& from)
{
  for (const CopyRun& run : from.Runs)
  {
    for (std::int64_t i = 0; sources[run.Operand] && i < run.Count; ++i)
    {
      target->SetTuple(run.First + i, run.Id(i), sources[run.Operand]);
    }
  }
  for (std::size_t i = 0; from.Interpolated && i < from.Interpolated->size(); ++i)
  {
    const sb::InterpolatedPoint& point = (*from.Interpolated)[i];
    if (sources[point.Operand])
    {
      target->SetTuple(from.FirstInterpolated + static_cast<std::int64_t>(i),
        point.PointIds[NearestCorner(point)], sources[point.Operand]);
    }
  }
  const std::int64_t firstRepeated =
    from.NumberOfTuples - static_cast<std::int64_t>(from.Repeated.size());
  for (std::size_t i = 0; i < from.Repeated.size(); ++i)
  {
    target->SetTuple(firstRepeated + static_cast<std::int64_t>(i), from.Repeated[i], target);
  }
}

template <typename Value>
void NegateTuples(vtkDataArray* array, std::size_t source,
  const std::vector<std::int32_t>& operands, const std::vector<std::uint8_t>& reversed)
{
  Value* values = static_cast<Value*>(array->GetVoidPointer(0));
  const int components = array->GetNumberOfComponents();
  for (std::size_t tuple = 0; tuple < reversed.size(); ++tuple)
  {
    if (reversed[tuple] && operands[tuple] == static_cast<std::int32_t>(source))
    {
      for (int component = 0; component < components; ++component)
      {
        Value& value = values[static_cast<std::int64_t>(tuple) * components + component];
        value = -value;
      }
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
AttributeUnion::AttributeUnion(const std::vector<Source>& sources, const std::string& kind)
  : Sources(sources)
  , Kind(kind)
{
  for (std::size_t source = 0; source < this->Sources.size(); ++source)
  {
    vtkDataSetAttributes* attributes = this->Sources[source].Attributes;
    for (int i = 0; attributes && i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = attributes->GetAbstractArray(i);
      const int role = attributes->IsArrayAnAttribute(i);
      const std::string name = array->GetName() ? array->GetName()
        : role >= 0 ? vtkDataSetAttributes::GetAttributeTypeAsString(role)
                    : "Array" + std::to_string(i);
      this->Add(source, array, name);
    }
  }
  for (Column& column : this->Columns)
  {
    this->Unify(column);
  }
}

//------------------------------------------------------------------------------
void AttributeUnion::Add(std::size_t source, vtkAbstractArray* array, const std::string& name)
{
  const Source& from = this->Sources[source];
  if (from.NumberOfTuples == 0)
  {
    return;
  }
  if (array->GetNumberOfTuples() != from.NumberOfTuples)
  {
    this->Sentences.push_back("The " + this->Kind + " array '" + name + "' of " + from.Name +
      " has " + std::to_string(array->GetNumberOfTuples()) + " tuples for " +
      std::to_string(from.NumberOfTuples) + " " + this->Kind +
      "s, so it was left out; give it one tuple a " + this->Kind + ".");
    return;
  }
  auto column = std::find_if(this->Columns.begin(), this->Columns.end(),
    [&name](const Column& other) { return other.Name == name; });
  if (column == this->Columns.end())
  {
    this->Columns.emplace_back();
    column = this->Columns.end() - 1;
    column->Name = name;
    column->Arrays.resize(this->Sources.size());
    column->First = array;
  }
  const bool numbers = array->IsNumeric() && column->First->IsNumeric();
  if (array->GetNumberOfComponents() != column->First->GetNumberOfComponents() ||
    (!numbers && array->GetDataType() != column->First->GetDataType()))
  {
    this->Sentences.push_back("The " + this->Kind + " array '" + name + "' of " + from.Name +
      " is of another kind (" + std::to_string(array->GetNumberOfComponents()) + " components of " +
      array->GetDataTypeAsString() + ") than that of an operand before it (" +
      std::to_string(column->First->GetNumberOfComponents()) + " of " +
      column->First->GetDataTypeAsString() + "), so it was left out; rename one of the two.");
    return;
  }
  column->Arrays[source] = array;
  const vtkDataSetAttributes* attributes = from.Attributes;
  column->TakeNearest |= array == const_cast<vtkDataSetAttributes*>(attributes)->GetGlobalIds() ||
    array == const_cast<vtkDataSetAttributes*>(attributes)->GetPedigreeIds();
}

//------------------------------------------------------------------------------
void AttributeUnion::Unify(Column& column)
{
  if (!column.First->IsNumeric())
  {
    return;
  }
  int type = CarriedType(column.First);
  for (const vtkSmartPointer<vtkAbstractArray>& array : column.Arrays)
  {
    type = array ? CommonType(type, CarriedType(array)) : type;
  }
  for (vtkSmartPointer<vtkAbstractArray>& array : column.Arrays)
  {
    array = array ? AsType(array, type) : nullptr;
  }
  // Integers of 64 bits are ids, VTK's and numpy's own.
  column.TakeNearest |=
    NamesAPart(column.Name) || (!IsFloating(type) && vtkAbstractArray::GetDataTypeSize(type) == 8);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> AttributeUnion::Carry(
  const Column& column, const TupleSources& from, sb::Executor& executor) const
{
  vtkAbstractArray* model = nullptr;
  for (const vtkSmartPointer<vtkAbstractArray>& array : column.Arrays)
  {
    model = model ? model : array.Get();
  }
  const auto target =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(model->GetDataType()));
  target->SetName(column.Name.c_str());
  target->SetNumberOfComponents(column.First->GetNumberOfComponents());
  target->CopyComponentNames(column.First);
  SetTuples(target, from.NumberOfTuples);
  switch (target->GetDataType())
  {
    vtkTemplateMacro(
      CarryNumbers<VTK_TT>(column.Arrays, target, column.TakeNearest, from, executor));
    default:
      CarryObjects(column.Arrays, target, from);
  }
  return target;
}

//------------------------------------------------------------------------------
void AttributeUnion::CopyTo(
  vtkDataSetAttributes* target, const TupleSources& from, sb::Executor& executor) const
{
  for (const Column& column : this->Columns)
  {
    target->AddArray(this->Carry(column, from, executor));
  }
  this->SetActive(target);
}

//------------------------------------------------------------------------------
std::string AttributeUnion::ActiveName(std::size_t source, int role) const
{
  vtkAbstractArray* array = this->Sources[source].Attributes
    ? this->Sources[source].Attributes->GetAbstractAttribute(role)
    : nullptr;
  if (!array)
  {
    return "";
  }
  return array->GetName() ? array->GetName() : vtkDataSetAttributes::GetAttributeTypeAsString(role);
}

//------------------------------------------------------------------------------
void AttributeUnion::SetActive(vtkDataSetAttributes* target) const
{
  for (const int role : { vtkDataSetAttributes::SCALARS, vtkDataSetAttributes::VECTORS,
         vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TCOORDS,
         vtkDataSetAttributes::TENSORS, vtkDataSetAttributes::TANGENTS })
  {
    // A renderer uses these at every point, so they must not hold fill values.
    const bool neededEverywhere = role == vtkDataSetAttributes::NORMALS ||
      role == vtkDataSetAttributes::TCOORDS || role == vtkDataSetAttributes::TANGENTS;
    std::string name;
    bool agreed = true;
    for (std::size_t source = 0; source < this->Sources.size(); ++source)
    {
      const std::string own = this->ActiveName(source, role);
      name = name.empty() ? own : name;
      agreed &= own == name || this->Sources[source].NumberOfTuples == 0;
    }
    if (!name.empty() && (agreed || !neededEverywhere) && target->HasArray(name.c_str()))
    {
      target->SetActiveAttribute(name.c_str(), role);
    }
  }
}

//------------------------------------------------------------------------------
bool AttributeUnion::HasNormals() const
{
  for (std::size_t source = 0; source < this->Sources.size(); ++source)
  {
    if (!this->ActiveName(source, vtkDataSetAttributes::NORMALS).empty())
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void AttributeUnion::NegateNormals(vtkDataSetAttributes* target,
  const std::vector<std::int32_t>& operands, const std::vector<std::uint8_t>& reversed) const
{
  for (std::size_t source = 0; source < this->Sources.size(); ++source)
  {
    const std::string name = this->ActiveName(source, vtkDataSetAttributes::NORMALS);
    vtkDataArray* normals = name.empty() ? nullptr : target->GetArray(name.c_str());
    if (normals && normals->GetDataType() == VTK_FLOAT)
    {
      NegateTuples<float>(normals, source, operands, reversed);
    }
    else if (normals && normals->GetDataType() == VTK_DOUBLE)
    {
      NegateTuples<double>(normals, source, operands, reversed);
    }
  }
}

} // namespace sbvtk
