// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayRanges.h"

#include "KernelExecutor.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <set>
#include <vector>

namespace sbvtk
{
namespace
{

constexpr vtkIdType Grain = 1 << 14; ///< tuples for one thread at a time
constexpr int Lanes = 4;

struct Range
{
  double Ends[2] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };

  /** Nothing is less or more than NaN, which therefore leaves the range as it is. */
  void Add(double value)
  {
    Ends[0] = value < Ends[0] ? value : Ends[0];
    Ends[1] = value > Ends[1] ? value : Ends[1];
  }

  void Add(const Range& other)
  {
    Ends[0] = std::min(Ends[0], other.Ends[0]);
    Ends[1] = std::max(Ends[1], other.Ends[1]);
  }

  bool IsEmpty() const { return Ends[0] > Ends[1]; }

  bool HasInfinity() const { return !IsEmpty() && (std::isinf(Ends[0]) || std::isinf(Ends[1])); }
};

/** The ranges of an array's components; after them that of the square of the magnitude. */
struct Ranges
{
  std::vector<Range> All;
  std::vector<Range> Finite;

  explicit Ranges(int components)
    : All(components + 1)
    , Finite(components + 1)
  {
  }

  void Add(const Ranges& other)
  {
    for (std::size_t place = 0; place < All.size(); ++place)
    {
      All[place].Add(other.All[place]);
      Finite[place].Add(other.Finite[place]);
    }
  }
};

/** One component after the other, which keeps the ends in registers; several ends of each, since a
 * comparison waits for the one before. */
template <typename Value, typename Counts>
std::vector<Range> RangesOf(
  const Value* values, int components, vtkIdType tuples, const Counts& counts)
{
  std::vector<Range> ranges(components + 1);
  const auto add = [&](int place, const auto& valueOf) {
    Range lanes[Lanes];
    const auto addTuple = [&](vtkIdType tuple, Range& range) {
      const double value = valueOf(values + tuple * components);
      if (counts(value))
      {
        range.Add(value);
      }
    };
    vtkIdType tuple = 0;
    for (; tuple + Lanes <= tuples; tuple += Lanes)
    {
      for (int lane = 0; lane < Lanes; ++lane)
      {
        addTuple(tuple + lane, lanes[lane]);
      }
    }
    for (; tuple < tuples; ++tuple)
    {
      addTuple(tuple, lanes[0]);
    }
    for (const Range& lane : lanes)
    {
      ranges[place].Add(lane);
    }
  };
  for (int component = 0; component < components; ++component)
  {
    add(component, [=](const Value* tuple) { return static_cast<double>(tuple[component]); });
  }
  if (components > 1) // else nobody asks
  {
    add(components, [=](const Value* tuple) {
      double square = 0.0;
      for (int component = 0; component < components; ++component)
      {
        square += static_cast<double>(tuple[component]) * static_cast<double>(tuple[component]);
      }
      return square;
    });
  }
  return ranges;
}

template <typename Value>
void FindRangesOfPart(const Value* values, vtkIdType tuples, Ranges& ranges)
{
  const int components = static_cast<int>(ranges.All.size()) - 1;
  ranges.All = RangesOf(values, components, tuples, [](double) { return true; });
  const bool finite = std::none_of(
    ranges.All.begin(), ranges.All.end(), [](const Range& range) { return range.HasInfinity(); });
  ranges.Finite = finite
    ? ranges.All
    : RangesOf(values, components, tuples, [](double value) { return std::isfinite(value); });
}

template <typename Value>
Ranges FindRanges(const Value* values, int components, vtkIdType tuples)
{
  std::vector<Ranges> parts((tuples + Grain - 1) / Grain, Ranges(components));
  KernelExecutor executor;
  executor.For(
    static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t part = begin; part < end; ++part)
      {
        const vtkIdType first = part * Grain;
        FindRangesOfPart(values + first * components, std::min(Grain, tuples - first), parts[part]);
      }
    });
  Ranges whole(components);
  for (const Ranges& part : parts)
  {
    whole.Add(part);
  }
  return whole;
}

/** For what has no value VTK has a range of its own, which it is left to find. */
void KeepComponents(
  vtkDataArray* array, vtkInformationInformationVectorKey* place, const std::vector<Range>& ranges)
{
  const int components = array->GetNumberOfComponents();
  const auto isEmpty = [](const Range& range) { return range.IsEmpty(); };
  if (std::any_of(ranges.begin(), ranges.begin() + components, isEmpty))
  {
    return;
  }
  vtkNew<vtkInformationVector> kept;
  kept->SetNumberOfInformationObjects(components);
  for (int component = 0; component < components; ++component)
  {
    kept->GetInformationObject(component)->Set(
      vtkDataArray::COMPONENT_RANGE(), ranges[component].Ends, 2);
  }
  array->GetInformation()->Set(place, kept);
}

void KeepMagnitude(vtkDataArray* array, vtkInformationDoubleVectorKey* place, const Range& square)
{
  if (!square.IsEmpty())
  {
    const double ends[2] = { std::sqrt(square.Ends[0]), std::sqrt(square.Ends[1]) };
    array->GetInformation()->Set(place, ends, 2);
  }
}

void KeepRanges(vtkDataArray* array)
{
  Ranges ranges(array->GetNumberOfComponents());
  switch (array->GetDataType())
  {
    vtkTemplateMacro(ranges = FindRanges(static_cast<const VTK_TT*>(array->GetVoidPointer(0)),
                       array->GetNumberOfComponents(), array->GetNumberOfTuples()));
    default:
      return;
  }
  KeepComponents(array, vtkAbstractArray::PER_COMPONENT(), ranges.All);
  KeepComponents(array, vtkAbstractArray::PER_FINITE_COMPONENT(), ranges.Finite);
  KeepMagnitude(array, vtkDataArray::L2_NORM_RANGE(), ranges.All.back());
  KeepMagnitude(array, vtkDataArray::L2_NORM_FINITE_RANGE(), ranges.Finite.back());
}

std::set<vtkDataArray*> ArraysOf(vtkDataObject* data)
{
  std::set<vtkDataArray*> arrays;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    for (vtkDataSetAttributes* attributes :
      { static_cast<vtkDataSetAttributes*>(block->GetPointData()),
        static_cast<vtkDataSetAttributes*>(block->GetCellData()) })
    {
      for (int index = 0; index < attributes->GetNumberOfArrays(); ++index)
      {
        arrays.insert(attributes->GetArray(index));
      }
    }
    const auto points = vtkPointSet::SafeDownCast(block);
    arrays.insert(points && points->GetPoints() ? points->GetPoints()->GetData() : nullptr);
  }
  arrays.erase(nullptr); // also what is no vtkDataArray
  return arrays;
}

void KeepRanges(vtkAlgorithm* filter)
{
  // Another thread may be looking at an input's arrays.
  std::set<vtkDataArray*> shared;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int index = 0; index < filter->GetNumberOfInputConnections(port); ++index)
    {
      shared.merge(ArraysOf(filter->GetInputDataObject(port, index)));
    }
  }
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    for (vtkDataArray* array : ArraysOf(filter->GetOutputDataObject(port)))
    {
      // One that has ranges is of an earlier update, which was asked for another port.
      const bool known = array->GetInformation()->Has(vtkAbstractArray::PER_COMPONENT());
      if (!known && !shared.count(array) && array->HasStandardMemoryLayout())
      {
        KeepRanges(array);
      }
    }
  }
}

} // namespace

void KeepRangesOfOutputs(vtkAlgorithm* filter)
{
  try
  {
    KeepRanges(filter);
  }
  catch (const std::bad_alloc&)
  {
  }
}

} // namespace sbvtk
