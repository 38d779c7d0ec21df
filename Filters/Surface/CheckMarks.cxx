// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckMarks.h"

#include "AttributeUnion.h"
#include "FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>

namespace sbvtk
{
namespace
{

/** Of several, the first is shown. */
constexpr sb::Defect ByGravity[] = { sb::Defect::BadIndex, sb::Defect::NotFinite,
  sb::Defect::Duplicate, sb::Defect::NoArea, sb::Defect::SelfIntersection, sb::Defect::WrongWay,
  sb::Defect::ContradictoryEdge, sb::Defect::ManyFoldEdge, sb::Defect::TouchingVertex,
  sb::Defect::RimEdge };

sb::Defect GravestOf(std::uint16_t marks)
{
  for (const sb::Defect defect : ByGravity)
  {
    if ((marks & sb::BitOf(defect)) != 0)
    {
      return defect;
    }
  }
  return sb::Defect::None;
}

/** A new array with one value for each cell or point, which `valueOf` gives. */
template <typename Array, typename ValueOf>
void AddArray(
  vtkDataSetAttributes* attributes, const char* name, vtkIdType count, ValueOf&& valueOf)
{
  const auto array = NewArray<Array>(name, 1, count);
  auto* const values = array->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    values[i] = valueOf(i);
  }
  attributes->AddArray(array);
}

vtkSmartPointer<vtkIdTypeArray> IdsOf(const std::vector<vtkIdType>& values)
{
  const auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  SetTuples(array, static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/** What stays of the points and of the cells, by their ids in the data set; null if all do. */
struct Kept
{
  vtkSmartPointer<vtkIdList> Points;
  vtkSmartPointer<vtkIdList> Cells;

  vtkIdType Point(vtkIdType i) const { return this->Points ? this->Points->GetId(i) : i; }
  vtkIdType Cell(vtkIdType i) const { return this->Cells ? this->Cells->GetId(i) : i; }
};

/** The tuples of what stays, in the attributes of the output; `count` is how many there were. */
void CopyTuples(
  vtkDataSetAttributes* from, vtkIdType count, vtkIdList* kept, vtkDataSetAttributes* to)
{
  TupleSources tuples;
  tuples.NumberOfTuples = kept->GetNumberOfIds();
  tuples.Runs.push_back({ 0, 0, kept->GetNumberOfIds(), nullptr, kept->GetPointer(0) });
  sb::SerialExecutor executor;
  AttributeUnion({ { from, count, "Input" } }, "").CopyTo(to, tuples, executor);
}

/** The surface without its unusable cells, and without points that have no place. */
class UsablePart
{
public:
  UsablePart(vtkPolyData* surface, const sb::SurfaceCheckResult& result, const CellMarks& marks)
    : Surface(surface)
    , Marks(marks)
  {
    this->Left.Points = vtkSmartPointer<vtkIdList>::New();
    this->Left.Cells = vtkSmartPointer<vtkIdList>::New();
    for (const std::uint16_t mark : result.PointMarks)
    {
      const bool isPlace = (mark & sb::BitOf(sb::Defect::NotFinite)) == 0;
      this->NewIds.push_back(isPlace ? this->Left.Points->GetNumberOfIds() : -1);
      if (isPlace)
      {
        this->Left.Points->InsertNextId(static_cast<vtkIdType>(this->NewIds.size()) - 1);
      }
    }
  }

  Kept CopyTo(vtkPolyData* output)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(this->Surface->GetPoints()->GetDataType());
    SetTuples(points, this->Left.Points->GetNumberOfIds());
    this->Surface->GetPoints()->GetData()->GetTuples(this->Left.Points, points->GetData());
    output->SetPoints(points);
    vtkIdType first = 0;
    for (const auto& [get, set] : { std::make_pair(&vtkPolyData::GetVerts, &vtkPolyData::SetVerts),
           std::make_pair(&vtkPolyData::GetLines, &vtkPolyData::SetLines),
           std::make_pair(&vtkPolyData::GetPolys, &vtkPolyData::SetPolys),
           std::make_pair(&vtkPolyData::GetStrips, &vtkPolyData::SetStrips) })
    {
      vtkCellArray* cells = (this->Surface->*get)();
      (output->*set)(this->Selected(cells, first));
      first += cells->GetNumberOfCells();
    }
    output->GetFieldData()->ShallowCopy(this->Surface->GetFieldData());
    CopyTuples(this->Surface->GetPointData(), this->Surface->GetNumberOfPoints(), this->Left.Points,
      output->GetPointData());
    CopyTuples(this->Surface->GetCellData(), this->Surface->GetNumberOfCells(), this->Left.Cells,
      output->GetCellData());
    return this->Left;
  }

private:
  vtkSmartPointer<vtkCellArray> Selected(vtkCellArray* cells, vtkIdType first)
  {
    std::vector<vtkIdType> offsets{ 0 };
    std::vector<vtkIdType> corners;
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      cells->GetCellAtId(i, ids);
      if (!this->Marks.IsUnusable(first + i) && this->Rename(ids))
      {
        corners.insert(corners.end(), ids->begin(), ids->end());
        offsets.push_back(static_cast<vtkIdType>(corners.size()));
        this->Left.Cells->InsertNextId(first + i);
      }
    }
    const auto result = vtkSmartPointer<vtkCellArray>::New();
    result->SetData(IdsOf(offsets), IdsOf(corners));
    return result;
  }

  /** @return false if one of the points is not there. */
  bool Rename(vtkIdList* ids) const
  {
    const auto count = static_cast<vtkIdType>(this->NewIds.size());
    for (vtkIdType& id : *ids)
    {
      id = id >= 0 && id < count ? this->NewIds[static_cast<std::size_t>(id)] : -1;
      if (id < 0)
      {
        return false;
      }
    }
    return true;
  }

  vtkPolyData* Surface;
  const CellMarks& Marks;
  Kept Left;
  std::vector<vtkIdType> NewIds; ///< [point] -1 if it has no place
};

/** [cell of the data set] its shell and the number of others that it meets, from its triangles. */
struct CellNumbers
{
  std::vector<std::int32_t> Shell;
  std::vector<std::int32_t> Meetings;
};

CellNumbers NumbersOf(const OperandSurface& surface, const sb::SurfaceCheckResult& result)
{
  CellNumbers numbers;
  const auto count = static_cast<std::size_t>(surface.Data()->GetNumberOfCells());
  numbers.Shell.resize(count, -1);
  numbers.Meetings.resize(count, 0);
  const std::int32_t cells = surface.NumberOfPolygons() + surface.NumberOfStrips();
  for (std::int32_t cell = 0; cell < cells; ++cell)
  {
    const auto place = static_cast<std::size_t>(surface.FirstCell() + cell);
    for (std::int32_t i = surface.FirstTriangle(cell); i < surface.FirstTriangle(cell + 1); ++i)
    {
      numbers.Shell[place] = std::max(numbers.Shell[place], result.ShellOfTriangle[i]);
      numbers.Meetings[place] +=
        result.MeetingsOfTriangle.empty() ? 0 : result.MeetingsOfTriangle[i];
    }
  }
  return numbers;
}

void AddCellArrays(const OperandSurface& surface, const sb::SurfaceCheckResult& result,
  const CellMarks& marks, const Kept& kept, vtkPolyData* output)
{
  const CellNumbers numbers = NumbersOf(surface, result);
  const vtkIdType count = output->GetNumberOfCells();
  vtkCellData* data = output->GetCellData();
  const auto cellAt = [&kept](vtkIdType i) { return kept.Cell(i); };
  AddArray<vtkUnsignedCharArray>(data, "Defect", count,
    [&](vtkIdType i) { return static_cast<unsigned char>(marks.Gravest(cellAt(i))); });
  AddArray<vtkIntArray>(
    data, "ShellId", count, [&](vtkIdType i) { return numbers.Shell[cellAt(i)]; });
  AddArray<vtkIntArray>(
    data, "SelfIntersections", count, [&](vtkIdType i) { return numbers.Meetings[cellAt(i)]; });
  AddArray<vtkUnsignedCharArray>(data, "Duplicate", count, [&](vtkIdType i) {
    return static_cast<unsigned char>(marks.Has(cellAt(i), sb::Defect::Duplicate));
  });
  AddArray<vtkUnsignedCharArray>(data, "WrongWay", count, [&](vtkIdType i) {
    return static_cast<unsigned char>(marks.Has(cellAt(i), sb::Defect::WrongWay));
  });
  data->SetActiveScalars("Defect"); // ParaView colours by it at once
}

void AddPointArrays(const sb::SurfaceCheckResult& result, const Kept& kept, vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfPoints();
  vtkPointData* data = output->GetPointData();
  AddArray<vtkUnsignedCharArray>(data, "PointDefect", count, [&](vtkIdType i) {
    // Points at one place are no defect: that is how creases have several normals.
    return static_cast<unsigned char>(
      GravestOf(result.PointMarks[kept.Point(i)] & ~sb::BitOf(sb::Defect::Duplicate)));
  });
  AddArray<vtkUnsignedCharArray>(data, "DuplicatePoint", count, [&](vtkIdType i) {
    return static_cast<unsigned char>(
      (result.PointMarks[kept.Point(i)] & sb::BitOf(sb::Defect::Duplicate)) != 0);
  });
  AddArray<vtkIntArray>(data, "LoopId", count,
    [&](vtkIdType i) { return result.RimOfPoint.empty() ? -1 : result.RimOfPoint[kept.Point(i)]; });
}

} // namespace

//------------------------------------------------------------------------------
CellMarks::CellMarks(const OperandSurface& surface, const sb::SurfaceCheckResult& result)
  : Marks(static_cast<std::size_t>(surface.Data()->GetNumberOfCells()), 0)
{
  const std::int32_t cells = surface.NumberOfPolygons() + surface.NumberOfStrips();
  for (std::int32_t cell = 0; cell < cells; ++cell)
  {
    std::uint16_t& marks = this->Marks[static_cast<std::size_t>(surface.FirstCell() + cell)];
    const std::int32_t end = surface.FirstTriangle(cell + 1);
    if (surface.FirstTriangle(cell) == end)
    {
      marks = sb::BitOf(sb::Defect::NoArea); // fewer than three corners
    }
    for (std::int32_t i = surface.FirstTriangle(cell); i < end; ++i)
    {
      marks |= result.TriangleMarks[i];
    }
  }
}

//------------------------------------------------------------------------------
std::int64_t CellMarks::Count(sb::Defect defect) const
{
  return std::count_if(this->Marks.begin(), this->Marks.end(),
    [defect](std::uint16_t marks) { return (marks & sb::BitOf(defect)) != 0; });
}

//------------------------------------------------------------------------------
sb::Defect CellMarks::Gravest(vtkIdType cell) const
{
  return GravestOf(this->Marks[static_cast<std::size_t>(cell)]);
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> CellMarks::Unusable() const
{
  std::vector<vtkIdType> cells;
  for (std::size_t cell = 0; cell < this->Marks.size(); ++cell)
  {
    if (this->IsUnusable(static_cast<vtkIdType>(cell)))
    {
      cells.push_back(static_cast<vtkIdType>(cell));
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> PointsWithoutPlace(const sb::SurfaceCheckResult& result)
{
  std::vector<vtkIdType> points;
  for (std::size_t i = 0; i < result.PointMarks.size(); ++i)
  {
    if ((result.PointMarks[i] & sb::BitOf(sb::Defect::NotFinite)) != 0)
    {
      points.push_back(static_cast<vtkIdType>(i));
    }
  }
  return points;
}

//------------------------------------------------------------------------------
void BuildMarkedSurface(const OperandSurface& surface, const sb::SurfaceCheckResult& result,
  const CellMarks& marks, vtkPolyData* output)
{
  Kept kept;
  if (marks.Unusable().empty() && result.Counts.NotFinitePoints == 0)
  {
    output->ShallowCopy(surface.Data());
  }
  else
  {
    kept = UsablePart(surface.Data(), result, marks).CopyTo(output);
  }
  AddCellArrays(surface, result, marks, kept, output);
  AddPointArrays(result, kept, output);
}

} // namespace sbvtk
