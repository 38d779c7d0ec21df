// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultSurface.h"

#include "ArrayMemory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace sbvtk
{
namespace
{

constexpr std::int64_t grain = 16384;

bool IsUntouched(sb::Fate fate) { return fate == sb::Fate::Kept || fate == sb::Fate::KeptReversed; }

} // namespace

//------------------------------------------------------------------------------
/** Learns how much room a part of the output needs. */
class ResultSurface::Counter
{
public:
  std::int64_t Cells = 0;
  std::int64_t Corners = 0;

  void Triangle(std::int32_t, std::int32_t, std::int32_t, std::int32_t, std::int32_t, bool)
  {
    ++this->Cells;
    this->Corners += 3;
  }
  void Polygon(std::int32_t, std::int32_t, const std::vector<std::int32_t>& corners, bool)
  {
    ++this->Cells;
    this->Corners += static_cast<std::int64_t>(corners.size());
  }
};

//------------------------------------------------------------------------------
/** Writes the cells of a part at their place. Turned-over ones keep their first corner. */
class ResultSurface::Writer
{
public:
  Writer(ResultSurface& surface, const Part& part)
    : Operand(part.Operand)
    , Corner(part.FirstCorner)
    , Connectivity(surface.Connectivity->GetPointer(0))
    , End(surface.Offsets->GetPointer(0) + part.FirstCell + 1)
    , Source(surface.SourceIds->GetPointer(0) + part.FirstCell)
    , Original(surface.OriginalCellIds->GetPointer(0) + part.FirstCell)
    , Reversed(surface.Reversed.empty() ? nullptr : surface.Reversed.data() + part.FirstCell)
    , Origin(surface.CellOrigins.empty() ? nullptr : surface.CellOrigins.data() + part.FirstCell)
  {
  }

  void Triangle(std::int32_t cell, std::int32_t origin, std::int32_t a, std::int32_t b,
    std::int32_t c, bool turn)
  {
    this->Connectivity[this->Corner] = a;
    this->Connectivity[this->Corner + 1] = turn ? c : b;
    this->Connectivity[this->Corner + 2] = turn ? b : c;
    this->Corner += 3;
    this->Finish(cell, origin, turn);
  }
  void Polygon(
    std::int32_t cell, std::int32_t origin, const std::vector<std::int32_t>& corners, bool turn)
  {
    vtkTypeInt64* out = this->Connectivity + this->Corner;
    std::copy(corners.begin(), corners.end(), out);
    if (turn)
    {
      std::reverse(out + 1, out + corners.size());
    }
    this->Corner += static_cast<std::int64_t>(corners.size());
    this->Finish(cell, origin, turn);
  }

private:
  void Finish(std::int32_t cell, std::int32_t origin, bool turn)
  {
    *this->End++ = this->Corner;
    *this->Source++ = this->Operand;
    *this->Original++ = cell;
    if (this->Reversed)
    {
      *this->Reversed++ = turn;
    }
    if (this->Origin)
    {
      *this->Origin++ = origin;
    }
  }

  std::int32_t Operand;
  std::int64_t Corner;
  vtkTypeInt64* Connectivity;
  vtkTypeInt64* End;
  int* Source;
  vtkIdType* Original;
  std::uint8_t* Reversed;
  std::int32_t* Origin;
};

//------------------------------------------------------------------------------
ResultSurface::ResultSurface(const std::vector<std::shared_ptr<OperandSurface>>& operands,
  const sb::CutSurfaces& result, const ResultOptions& options, sb::Executor& executor)
  : Operands(operands)
  , Result(result)
  , Options(options)
{
  this->SourceIds->SetName("SourceId");
  this->OriginalCellIds->SetName("OriginalCellId");
  this->AddPointSources();
  this->OrderPieces();
  this->MakeParts();
  const auto forEachPart = [&](const auto& work) {
    executor.For(
      static_cast<std::int64_t>(this->Parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        std::for_each(this->Parts.begin() + begin, this->Parts.begin() + end, work);
      });
  };
  forEachPart([this](Part& part) {
    Counter counter;
    this->Visit(part, counter);
    part.NumberOfCells = counter.Cells;
    part.NumberOfCorners = counter.Corners;
  });
  this->Place();
  this->Allocate();
  forEachPart([this](Part& part) {
    Writer writer(*this, part);
    this->Visit(part, writer);
  });
  this->AddCellSources();
  if (this->Options.SeparateReversed && this->HasReversed())
  {
    this->SeparateReversedPoints();
  }
}

//------------------------------------------------------------------------------
void ResultSurface::AddPointSources()
{
  for (std::size_t operand = 0; operand < this->Result.KeptPoints.size(); ++operand)
  {
    const std::vector<std::int32_t>& kept = this->Result.KeptPoints[operand];
    CopyRun run;
    run.Operand = static_cast<std::int32_t>(operand);
    run.First = this->PointSources.NumberOfTuples;
    run.Count = static_cast<std::int64_t>(kept.size());
    run.PointIds = kept.data();
    if (run.Count > 0)
    {
      this->PointSources.Runs.push_back(run);
    }
    this->PointSources.NumberOfTuples += run.Count;
  }
  this->PointSources.Interpolated = &this->Result.Interpolated;
  this->PointSources.FirstInterpolated = this->PointSources.NumberOfTuples;
  this->PointSources.NumberOfTuples += static_cast<std::int64_t>(this->Result.Interpolated.size());
}

//------------------------------------------------------------------------------
void ResultSurface::OrderPieces()
{
  const std::vector<std::int32_t>& operands = this->Result.Split.Operand;
  this->PieceOrder.resize(operands.size());
  std::iota(this->PieceOrder.begin(), this->PieceOrder.end(), 0);
  std::stable_sort(this->PieceOrder.begin(), this->PieceOrder.end(),
    [&operands](std::int32_t a, std::int32_t b) { return operands[a] < operands[b]; });
}

//------------------------------------------------------------------------------
void ResultSurface::MakeParts()
{
  const std::int32_t numberOfOperands = static_cast<std::int32_t>(this->Operands.size());
  Part part;
  for (part.Operand = 0; part.Operand < numberOfOperands; ++part.Operand)
  {
    const OperandSurface& surface = *this->Operands[part.Operand];
    const std::int64_t numberOfCells = this->Result.Fates[part.Operand].empty()
      ? 0
      : std::int64_t(surface.NumberOfPolygons()) + surface.NumberOfStrips();
    for (part.Begin = 0; part.Begin < numberOfCells; part.Begin += grain)
    {
      part.End = std::min(numberOfCells, part.Begin + grain);
      this->Parts.push_back(part);
    }
  }
  part.OfPieces = true;
  const std::int64_t numberOfPieces = static_cast<std::int64_t>(this->PieceOrder.size());
  for (part.Begin = 0; part.Begin < numberOfPieces; part.Begin = part.End)
  {
    part.Operand = this->Result.Split.Operand[this->PieceOrder[part.Begin]];
    part.End = part.Begin;
    while (part.End < numberOfPieces && part.End < part.Begin + grain &&
      this->Result.Split.Operand[this->PieceOrder[part.End]] == part.Operand)
    {
      ++part.End;
    }
    this->Parts.push_back(part);
  }
}

//------------------------------------------------------------------------------
template <typename Sink>
void ResultSurface::Visit(const Part& part, Sink& sink) const
{
  if (part.OfPieces)
  {
    this->VisitPieces(part, sink);
  }
  else if (this->Operands[part.Operand]->AllTriangles())
  {
    this->VisitTriangles(part, sink);
  }
  else
  {
    this->VisitCells(part, sink);
  }
}

//------------------------------------------------------------------------------
template <typename Sink>
void ResultSurface::VisitTriangles(const Part& part, Sink& sink) const
{
  const sb::Fate* fates = this->Result.Fates[part.Operand].data();
  const std::int32_t* pointMap = this->Result.PointMap[part.Operand].data();
  const std::int32_t* triangles = this->Operands[part.Operand]->Mesh().Triangles;
  const std::int32_t firstCell = this->Operands[part.Operand]->FirstCell();
  for (std::int64_t triangle = part.Begin; triangle < part.End; ++triangle)
  {
    if (IsUntouched(fates[triangle]))
    {
      const std::int32_t* corners = triangles + 3 * triangle;
      const auto origin = static_cast<std::int32_t>(triangle);
      sink.Triangle(firstCell + origin, origin, pointMap[corners[0]], pointMap[corners[1]],
        pointMap[corners[2]],
        this->Options.TurnReversed && fates[triangle] == sb::Fate::KeptReversed);
    }
  }
}

//------------------------------------------------------------------------------
template <typename Sink>
void ResultSurface::VisitCells(const Part& part, Sink& sink) const
{
  const OperandSurface& surface = *this->Operands[part.Operand];
  const sb::Fate* fates = this->Result.Fates[part.Operand].data();
  const std::int32_t* pointMap = this->Result.PointMap[part.Operand].data();
  std::vector<std::int32_t> corners;
  for (std::int32_t cell = static_cast<std::int32_t>(part.Begin); cell < part.End; ++cell)
  {
    if (cell < surface.NumberOfPolygons() &&
      this->VisitWholePolygon(part.Operand, cell, corners, sink))
    {
      continue;
    }
    for (std::int32_t triangle = surface.FirstTriangle(cell);
         triangle < surface.FirstTriangle(cell + 1); ++triangle)
    {
      if (IsUntouched(fates[triangle]))
      {
        const std::int32_t* ids =
          surface.Mesh().Triangles + 3 * static_cast<std::int64_t>(triangle);
        sink.Triangle(surface.FirstCell() + cell, triangle, pointMap[ids[0]], pointMap[ids[1]],
          pointMap[ids[2]],
          this->Options.TurnReversed && fates[triangle] == sb::Fate::KeptReversed);
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Pass a polygon on as it is, if all its triangles are untouched and alike. */
template <typename Sink>
bool ResultSurface::VisitWholePolygon(
  std::int32_t operand, std::int32_t polygon, std::vector<std::int32_t>& corners, Sink& sink) const
{
  const OperandSurface& surface = *this->Operands[operand];
  const sb::Fate* fates = this->Result.Fates[operand].data();
  const std::int32_t begin = surface.FirstTriangle(polygon);
  const std::int32_t end = surface.FirstTriangle(polygon + 1);
  if (begin == end || !IsUntouched(fates[begin]) || this->IsLoose(operand, begin, end) ||
    std::any_of(
      fates + begin, fates + end, [fates, begin](sb::Fate fate) { return fate != fates[begin]; }))
  {
    return false;
  }
  surface.Corners(polygon, corners);
  for (std::int32_t& corner : corners)
  {
    corner = this->Result.PointMap[operand][corner];
  }
  sink.Polygon(surface.FirstCell() + polygon, begin, corners,
    this->Options.TurnReversed && fates[begin] == sb::Fate::KeptReversed);
  return true;
}

//------------------------------------------------------------------------------
/** Whether any of the triangles is to be given out for itself. */
bool ResultSurface::IsLoose(std::int32_t operand, std::int32_t begin, std::int32_t end) const
{
  if (this->Options.Loose.empty() || this->Options.Loose[operand].empty())
  {
    return false;
  }
  const std::uint8_t* loose = this->Options.Loose[operand].data();
  return std::find(loose + begin, loose + end, 1) != loose + end;
}

//------------------------------------------------------------------------------
template <typename Sink>
void ResultSurface::VisitPieces(const Part& part, Sink& sink) const
{
  const sb::Pieces& pieces = this->Result.Split;
  for (std::int64_t place = part.Begin; place < part.End; ++place)
  {
    const std::int32_t piece = this->PieceOrder[place];
    const std::array<std::int32_t, 3>& corners = pieces.Corners[piece];
    sink.Triangle(this->Operands[part.Operand]->CellOfTriangle(pieces.Parent[piece]), ~piece,
      corners[0], corners[1], corners[2], this->Options.TurnReversed && pieces.Reversed[piece]);
  }
}

//------------------------------------------------------------------------------
void ResultSurface::Place()
{
  std::int64_t cell = 0;
  std::int64_t corner = 0;
  for (Part& part : this->Parts)
  {
    part.FirstCell = cell;
    part.FirstCorner = corner;
    cell += part.NumberOfCells;
    corner += part.NumberOfCorners;
  }
}

//------------------------------------------------------------------------------
void ResultSurface::Allocate()
{
  const Part end = this->Parts.empty() ? Part() : this->Parts.back();
  const std::int64_t numberOfCells = end.FirstCell + end.NumberOfCells;
  this->CellSources.NumberOfTuples = numberOfCells;
  SetTuples(this->Connectivity, end.FirstCorner + end.NumberOfCorners);
  SetTuples(this->Offsets, numberOfCells + 1);
  this->Offsets->SetValue(0, 0);
  SetTuples(this->SourceIds, numberOfCells);
  SetTuples(this->OriginalCellIds, numberOfCells);
  this->Reversed.resize(this->Options.KeepReversal ? numberOfCells : 0);
  this->CellOrigins.resize(this->Options.KeepOrigins ? numberOfCells : 0);
}

//------------------------------------------------------------------------------
void ResultSurface::AddCellSources()
{
  for (const Part& part : this->Parts)
  {
    std::vector<CopyRun>& runs = this->CellSources.Runs;
    if (runs.empty() || runs.back().Operand != part.Operand)
    {
      CopyRun run;
      run.Operand = part.Operand;
      run.First = part.FirstCell;
      run.CellIds = this->OriginalCellIds->GetPointer(part.FirstCell);
      runs.push_back(run);
    }
    runs.back().Count += part.NumberOfCells;
  }
}

//------------------------------------------------------------------------------
bool ResultSurface::HasReversed() const
{
  return std::find(this->Reversed.begin(), this->Reversed.end(), 1) != this->Reversed.end();
}

//------------------------------------------------------------------------------
/** A point that both a reversed and another cell use gets a second instance, which the reversed
 * cells take. */
void ResultSurface::SeparateReversedPoints()
{
  const std::int64_t numberOfPoints = this->PointSources.NumberOfTuples;
  const vtkTypeInt64* ends = this->Offsets->GetPointer(1);
  vtkTypeInt64* corners = this->Connectivity->GetPointer(0);
  const std::int64_t numberOfCells = this->CellSources.NumberOfTuples;
  std::vector<std::uint8_t> usedForward(numberOfPoints, 0);
  std::int64_t corner = 0;
  for (std::int64_t cell = 0; cell < numberOfCells; ++cell)
  {
    for (; corner < ends[cell]; ++corner)
    {
      usedForward[corners[corner]] |= !this->Reversed[cell];
    }
  }
  std::vector<std::int32_t> secondInstance(numberOfPoints, -1);
  corner = 0;
  for (std::int64_t cell = 0; cell < numberOfCells; ++cell)
  {
    for (; corner < ends[cell]; ++corner)
    {
      if (!this->Reversed[cell] || !usedForward[corners[corner]])
      {
        continue;
      }
      std::int32_t& second = secondInstance[corners[corner]];
      if (second < 0)
      {
        second = static_cast<std::int32_t>(
          numberOfPoints + static_cast<std::int64_t>(this->PointSources.Repeated.size()));
        this->PointSources.Repeated.push_back(static_cast<std::int32_t>(corners[corner]));
      }
      corners[corner] = second;
    }
  }
  this->PointSources.NumberOfTuples +=
    static_cast<std::int64_t>(this->PointSources.Repeated.size());
}

//------------------------------------------------------------------------------
template <typename Value>
void ResultSurface::CopyPoints(Value* target, sb::Executor& executor) const
{
  for (const CopyRun& run : this->PointSources.Runs)
  {
    const OperandSurface& surface = *this->Operands[run.Operand];
    const void* source = this->Options.SinglePrecision
      ? surface.Data()->GetPoints()->GetData()->GetVoidPointer(0)
      : static_cast<const void*>(surface.Mesh().Points);
    executor.For(run.Count, grain, [&](std::int64_t begin, std::int64_t end) {
      CopyEntries(run, begin, end, static_cast<const char*>(source),
        reinterpret_cast<char*>(target), 3 * sizeof(Value));
    });
  }
  Value* out = target + 3 * this->PointSources.FirstInterpolated;
  for (const sb::InterpolatedPoint& point : this->Result.Interpolated)
  {
    for (const double coordinate : point.Position)
    {
      *out++ = static_cast<Value>(coordinate);
    }
  }
  for (const std::int32_t original : this->PointSources.Repeated)
  {
    out = std::copy_n(target + 3 * static_cast<std::int64_t>(original), 3, out);
  }
}

//------------------------------------------------------------------------------
void ResultSurface::CopyTo(vtkPolyData* output, sb::Executor& executor) const
{
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Options.SinglePrecision ? VTK_FLOAT : VTK_DOUBLE);
  SetTuples(points, this->PointSources.NumberOfTuples);
  if (this->Options.SinglePrecision)
  {
    this->CopyPoints(vtkFloatArray::FastDownCast(points->GetData())->GetPointer(0), executor);
  }
  else
  {
    this->CopyPoints(vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0), executor);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(this->Offsets, this->Connectivity);
  output->SetPoints(points);
  output->SetPolys(polygons);
  output->GetCellData()->AddArray(this->SourceIds);
  output->GetCellData()->AddArray(this->OriginalCellIds);
  // ParaView colours by it at once. SetScalars would remove the scalars of the inputs.
  output->GetCellData()->SetActiveScalars(this->SourceIds->GetName());
}

//------------------------------------------------------------------------------
std::vector<std::int32_t> ResultSurface::OperandsOfCells() const
{
  const int* operands = this->SourceIds->GetPointer(0);
  return std::vector<std::int32_t>(operands, operands + this->CellSources.NumberOfTuples);
}

//------------------------------------------------------------------------------
void ResultSurface::FindReversedPoints(
  std::vector<std::int32_t>& operands, std::vector<std::uint8_t>& reversed) const
{
  operands.assign(this->PointSources.NumberOfTuples, -1);
  reversed.assign(this->PointSources.NumberOfTuples, 0);
  const vtkTypeInt64* ends = this->Offsets->GetPointer(1);
  const vtkTypeInt64* corners = this->Connectivity->GetPointer(0);
  std::int64_t corner = 0;
  for (std::int64_t cell = 0; cell < this->CellSources.NumberOfTuples; ++cell)
  {
    for (; corner < ends[cell]; ++corner)
    {
      if (this->Reversed[cell])
      {
        operands[corners[corner]] = this->SourceIds->GetPointer(0)[cell];
        reversed[corners[corner]] = 1;
      }
    }
  }
}

} // namespace sbvtk
