// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BorderJoining.h"

#include "Hash.h"
#include "PointSubstitution.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace sbvtk
{
namespace
{

constexpr double ulps = 8.0; ///< of the largest value, that rounding may account for

/** Directed edges of the polygons around each point: where they cancel, polygons close up around
 * it. */
class Fans
{
public:
  explicit Fans(vtkPolyData* surface)
    : Sums(static_cast<std::size_t>(surface->GetNumberOfPoints()), 0)
    , Used(this->Sums.size(), false)
  {
    vtkCellArray* polygons = surface->GetPolys();
    for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      polygons->GetCellAtId(cell, size, corners);
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->AddEdge(corners[i], corners[i + 1 < size ? i + 1 : 0]);
      }
    }
    vtkCellArray* strips = surface->GetStrips();
    for (vtkIdType cell = 0; cell < strips->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      strips->GetCellAtId(cell, size, corners);
      for (vtkIdType i = 0; i + 2 < size; ++i)
      {
        this->AddEdge(corners[i + i % 2], corners[i + 1 - i % 2]);
        this->AddEdge(corners[i + 1 - i % 2], corners[i + 2]);
        this->AddEdge(corners[i + 2], corners[i + i % 2]);
      }
    }
  }

  bool AreOpenAt(vtkIdType point) const
  {
    const auto i = static_cast<std::size_t>(point);
    return !this->Used[i] || this->Sums[i] != 0;
  }

  /** Whether there is a point without a polygon. */
  bool LeavePointsOut() const
  {
    return std::find(this->Used.begin(), this->Used.end(), false) != this->Used.end();
  }

private:
  void AddEdge(vtkIdType from, vtkIdType to)
  {
    const auto count = static_cast<vtkIdType>(this->Sums.size());
    if (from >= 0 && to >= 0 && from < count && to < count)
    {
      this->Sums[static_cast<std::size_t>(from)] += sb::Mix(static_cast<std::uint64_t>(to) + 1);
      this->Sums[static_cast<std::size_t>(to)] -= sb::Mix(static_cast<std::uint64_t>(from) + 1);
      this->Used[static_cast<std::size_t>(from)] = this->Used[static_cast<std::size_t>(to)] = true;
    }
  }

  std::vector<std::uint64_t> Sums;
  std::vector<bool> Used;
};

/** Numbers that may differ by rounding. */
template <class Real>
class Floats
{
public:
  explicit Floats(vtkAOSDataArrayTemplate<Real>* array)
    : Values(array->GetPointer(0))
    , Components(static_cast<std::size_t>(array->GetNumberOfComponents()))
  {
    double largest = 0.0;
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      const double size = std::fabs(static_cast<double>(this->Values[i]));
      largest = std::isfinite(size) ? std::max(largest, size) : largest;
    }
    this->Slack = ulps * std::numeric_limits<Real>::epsilon() * largest;
  }

  Real* Tuple(vtkIdType i) const
  {
    return this->Values + static_cast<std::size_t>(i) * this->Components;
  }

  bool Agree(vtkIdType a, vtkIdType b) const
  {
    return std::equal(
      this->Tuple(a), this->Tuple(a) + this->Components, this->Tuple(b), [this](Real x, Real y) {
        return std::fabs(static_cast<double>(x) - static_cast<double>(y)) <= this->Slack ||
          (std::isnan(x) && std::isnan(y)) || std::memcmp(&x, &y, sizeof x) == 0;
      });
  }

  double Rounding() const { return this->Slack; }

private:
  Real* Values;
  std::size_t Components;
  double Slack;
};

/** Compares points of one surface by their arrays. */
class Arrays
{
public:
  explicit Arrays(vtkPointData* attributes)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      this->Add(attributes->GetAbstractArray(i));
    }
  }

  bool Agree(vtkIdType a, vtkIdType b) const
  {
    const auto agree = [a, b](const auto& column) { return column.Agree(a, b); };
    return std::all_of(this->Singles.begin(), this->Singles.end(), agree) &&
      std::all_of(this->Doubles.begin(), this->Doubles.end(), agree) &&
      std::all_of(this->Others.begin(), this->Others.end(), agree) &&
      std::all_of(this->Texts.begin(), this->Texts.end(), [a, b](vtkStringArray* texts) {
        const vtkIdType count = texts->GetNumberOfComponents();
        return std::equal(texts->GetPointer(a * count), texts->GetPointer(a * count) + count,
          texts->GetPointer(b * count));
      });
  }

private:
  struct Bytes
  {
    const char* Values;
    std::size_t Size; ///< of a tuple

    bool Agree(vtkIdType a, vtkIdType b) const
    {
      return std::memcmp(this->Values + static_cast<std::size_t>(a) * this->Size,
               this->Values + static_cast<std::size_t>(b) * this->Size, this->Size) == 0;
    }
  };

  void Add(vtkAbstractArray* array)
  {
    if (auto* singles = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
    {
      this->Singles.emplace_back(singles);
    }
    else if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array))
    {
      this->Doubles.emplace_back(doubles);
    }
    else if (vtkStringArray* texts = vtkStringArray::SafeDownCast(array))
    {
      this->Texts.push_back(texts);
    }
    else if (array->GetDataType() != VTK_BIT)
    {
      this->Others.push_back({ static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetDataTypeSize() * array->GetNumberOfComponents()) });
    }
  }

  std::vector<Floats<float>> Singles;
  std::vector<Floats<double>> Doubles;
  std::vector<Bytes> Others;
  std::vector<vtkStringArray*> Texts;
};

/** Which points of other pieces a point goes with. */
struct Partners
{
  Substitutes Place; ///< the first that lies there
  Substitutes Point; ///< the first that is the same in all arrays, too
};

void ResolveChains(Substitutes& substitutes)
{
  for (vtkIdType& point : substitutes)
  {
    point = substitutes[static_cast<std::size_t>(point)]; // itself or an earlier one
  }
}

/**
 * Points are looked at in the order of their projections on a slanted line, in which few are
 * neighbours that are not neighbours in space.
 */
template <class Real>
Partners FindPartners(const Floats<Real>& places, const Arrays& arrays, const Fans& fans,
  const std::vector<vtkIdType>& ends)
{
  Partners found;
  std::vector<std::pair<double, vtkIdType>> order;
  const bool all = fans.LeavePointsOut(); // which may lie inside of another piece
  for (vtkIdType i = 0; i < ends.back(); ++i)
  {
    found.Place.push_back(i);
    const Real* x = places.Tuple(i);
    const double along = 0.5432 * x[0] + 0.6789 * x[1] + 0.4938 * x[2];
    if ((all || fans.AreOpenAt(i)) && std::isfinite(along))
    {
      order.emplace_back(along, i);
    }
  }
  found.Point = found.Place;
  std::sort(order.begin(), order.end());
  const auto pieceOf = [&ends](
                         vtkIdType i) { return std::upper_bound(ends.begin(), ends.end(), i); };
  auto first = order.begin();
  for (auto point = order.begin(); point != order.end(); ++point)
  {
    while (point->first - first->first > 2.0 * places.Rounding())
    {
      ++first;
    }
    for (auto other = first; other != point; ++other)
    {
      const auto ids = std::minmax(other->second, point->second);
      if (pieceOf(ids.first) != pieceOf(ids.second) && places.Agree(ids.first, ids.second))
      {
        const auto later = static_cast<std::size_t>(ids.second);
        found.Place[later] = std::min(found.Place[later], ids.first);
        found.Point[later] = arrays.Agree(ids.first, ids.second)
          ? std::min(found.Point[later], ids.first)
          : found.Point[later];
      }
    }
  }
  ResolveChains(found.Place);
  ResolveChains(found.Point);
  return found;
}

template <class Real>
vtkSmartPointer<vtkPolyData> Join(vtkPolyData* surface, vtkAOSDataArrayTemplate<Real>* coordinates,
  const std::vector<vtkIdType>& ends)
{
  const Floats<Real> places(coordinates);
  const Partners partners =
    FindPartners(places, Arrays(surface->GetPointData()), Fans(surface), ends);
  bool any = false;
  for (vtkIdType i = 0; i < ends.back(); ++i)
  {
    const auto point = static_cast<std::size_t>(i);
    std::copy_n(places.Tuple(partners.Place[point]), 3, places.Tuple(i));
    any |= partners.Point[point] != i;
  }
  return any ? Substitute(surface, partners.Point) : vtkSmartPointer<vtkPolyData>(surface);
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> JoinBorders(vtkPolyData* surface, const std::vector<vtkIdType>& ends)
{
  vtkDataArray* coordinates = surface->GetPoints()->GetData();
  if (auto* singles = vtkAOSDataArrayTemplate<float>::FastDownCast(coordinates))
  {
    return Join(surface, singles, ends);
  }
  return Join(surface, vtkAOSDataArrayTemplate<double>::FastDownCast(coordinates), ends);
}

} // namespace sbvtk
