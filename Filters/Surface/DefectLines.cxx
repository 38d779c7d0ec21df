// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DefectLines.h"

#include "ArrayMemory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace sbvtk
{
namespace
{

using Place = std::array<double, 3>;

/** One cell of the output; both ends are the same for a vertex. */
struct Item
{
  std::array<vtkIdType, 2> Points;
  sb::Defect Kind;
  std::int32_t Loop;
  std::int32_t NumberOfTriangles;
  std::array<std::int32_t, 2> Triangles;

  bool IsVertex() const { return this->Points[0] == this->Points[1]; }
};

class DefectLister
{
public:
  DefectLister(const OperandSurface& surface, const sb::SurfaceCheckResult& result)
    : Source(surface)
    , Result(result)
  {
  }

  void Run()
  {
    for (const sb::DefectEdge& edge : this->Result.Edges)
    {
      this->Items.push_back({ { this->PointAt(this->PlaceOf(edge.Points[0])),
                                this->PointAt(this->PlaceOf(edge.Points[1])) },
        edge.Kind, edge.Rim, edge.NumberOfTriangles, edge.Triangles });
    }
    for (const std::int32_t point : this->Result.TouchingVertices)
    {
      const vtkIdType id = this->PointAt(this->PlaceOf(point));
      this->Items.push_back({ { id, id }, sb::Defect::TouchingVertex, -1, 0, { -1, -1 } });
    }
    for (const sb::SelfContact& contact : this->Result.SelfContacts)
    {
      this->Items.push_back({ { this->PointAt(contact.Ends[0]), this->PointAt(contact.Ends[1]) },
        sb::Defect::SelfIntersection, -1, 2, contact.Triangles });
    }
    this->AddTrianglesWithoutArea();
    // vtkPolyData numbers vertices before lines.
    std::stable_partition(
      this->Items.begin(), this->Items.end(), [](const Item& item) { return item.IsVertex(); });
  }

  std::vector<Item> Items;
  std::vector<Place> Places;

private:
  Place PlaceOf(std::int32_t point) const
  {
    const double* p = this->Source.Mesh().Points + 3 * std::int64_t(point);
    return { p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 }; // the two zeros are one place
  }

  vtkIdType PointAt(const Place& place)
  {
    const auto [it, isNew] = this->Known.emplace(place, this->Places.size());
    if (isNew)
    {
      this->Places.push_back(place);
    }
    return static_cast<vtkIdType>(it->second);
  }

  /** Each by its longest edge, on which its third corner lies. */
  void AddTrianglesWithoutArea()
  {
    for (std::size_t i = 0; i < this->Result.TriangleMarks.size(); ++i)
    {
      if ((this->Result.TriangleMarks[i] & sb::BitOf(sb::Defect::NoArea)) == 0)
      {
        continue;
      }
      const std::int32_t* ids = this->Source.Mesh().Triangles + 3 * i;
      int longest = 0;
      for (int edge = 1; edge < 3; ++edge)
      {
        longest = this->LengthOf(ids, edge) > this->LengthOf(ids, longest) ? edge : longest;
      }
      this->Items.push_back({ { this->PointAt(this->PlaceOf(ids[longest])),
                                this->PointAt(this->PlaceOf(ids[(longest + 1) % 3])) },
        sb::Defect::NoArea, -1, 1, { static_cast<std::int32_t>(i), -1 } });
    }
  }

  double LengthOf(const std::int32_t* ids, int edge) const
  {
    const Place a = this->PlaceOf(ids[edge]);
    const Place b = this->PlaceOf(ids[(edge + 1) % 3]);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  const OperandSurface& Source;
  const sb::SurfaceCheckResult& Result;
  std::map<Place, std::size_t> Known;
};

template <typename Value>
void CopyPlaces(const std::vector<Place>& places, void* target)
{
  Value* out = static_cast<Value*>(target);
  for (const Place& place : places)
  {
    out = std::transform(
      place.begin(), place.end(), out, [](double x) { return static_cast<Value>(x); });
  }
}

vtkSmartPointer<vtkPoints> PointsOf(const std::vector<Place>& places, bool singlePrecision)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(singlePrecision ? VTK_FLOAT : VTK_DOUBLE);
  SetTuples(points, static_cast<vtkIdType>(places.size()));
  if (!places.empty())
  {
    void* target = points->GetData()->GetVoidPointer(0);
    singlePrecision ? CopyPlaces<float>(places, target) : CopyPlaces<double>(places, target);
  }
  return points;
}

/** Cells of one or of two points from items that follow each other. */
vtkSmartPointer<vtkCellArray> CellsOf(const Item* begin, const Item* end, int size)
{
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  const auto count = static_cast<vtkIdType>(end - begin);
  SetTuples(offsets, count + 1);
  SetTuples(connectivity, size * count);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, size * i);
  }
  vtkTypeInt64* out = connectivity->GetPointer(0);
  for (; begin != end; ++begin)
  {
    out = std::copy_n(begin->Points.begin(), size, out);
  }
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

void AddArrays(const std::vector<Item>& items, const OperandSurface& surface, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(items.size());
  vtkNew<vtkUnsignedCharArray> kinds;
  vtkNew<vtkIntArray> loops;
  vtkNew<vtkIntArray> counts;
  vtkNew<vtkIdTypeArray> cells;
  kinds->SetName("Defect");
  loops->SetName("LoopId");
  counts->SetName("TriangleCount");
  cells->SetName("CellIds");
  cells->SetNumberOfComponents(2);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(kinds), static_cast<vtkDataArray*>(loops),
         static_cast<vtkDataArray*>(counts), static_cast<vtkDataArray*>(cells) })
  {
    SetTuples(array, count);
    output->GetCellData()->AddArray(array);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Item& item = items[static_cast<std::size_t>(i)];
    kinds->SetValue(i, static_cast<unsigned char>(item.Kind));
    loops->SetValue(i, item.Loop);
    counts->SetValue(i, item.NumberOfTriangles);
    for (int side = 0; side < 2; ++side)
    {
      const std::int32_t triangle = item.Triangles[static_cast<std::size_t>(side)];
      cells->SetTypedComponent(i, side, triangle < 0 ? -1 : surface.CellOfTriangle(triangle));
    }
  }
  output->GetCellData()->SetActiveScalars("Defect"); // ParaView colours by it at once
}

} // namespace

//------------------------------------------------------------------------------
void BuildDefectLines(const OperandSurface& surface, const sb::SurfaceCheckResult& result,
  bool singlePrecision, vtkPolyData* output)
{
  DefectLister lister(surface, result);
  lister.Run();
  const Item* const begin = lister.Items.data();
  const Item* const end = begin + lister.Items.size();
  const Item* const firstLine =
    std::find_if(begin, end, [](const Item& item) { return !item.IsVertex(); });
  output->SetPoints(PointsOf(lister.Places, singlePrecision));
  output->SetVerts(CellsOf(begin, firstLine, 1));
  output->SetLines(CellsOf(firstLine, end, 2));
  AddArrays(lister.Items, surface, output);
}

} // namespace sbvtk
