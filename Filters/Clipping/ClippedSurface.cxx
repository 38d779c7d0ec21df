// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClippedSurface.h"

#include "ArrayMemory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <unordered_map>

namespace sbvtk
{
namespace
{

constexpr std::int64_t grain = 16384;

} // namespace

//------------------------------------------------------------------------------
/** A range of the input's cells: counts what is kept of them, and then writes it. */
class ClippedSurface::Block
{
public:
  Block(const ClippedSurface& surface, std::int64_t begin, std::int64_t end)
    : Surface(surface)
    , Begin(begin)
    , End(end)
  {
  }

  std::int64_t Cells = 0;
  std::int64_t Corners = 0;

  void Count()
  {
    this->Visit([this](std::int32_t, const std::int32_t*, std::int64_t size) {
      ++this->Cells;
      this->Corners += size;
    });
  }

  /** @param cell, corner where this block's output begins */
  void Write(std::int64_t cell, std::int64_t corner) const
  {
    const std::vector<std::int32_t>& map = this->Surface.Result.PointMap;
    vtkTypeInt64* offsets = this->Surface.Offsets->GetPointer(0);
    vtkTypeInt64* connectivity = this->Surface.Connectivity->GetPointer(0);
    vtkIdType* originals =
      this->Surface.OriginalCellIds->GetPointer(this->Surface.Lines.NumberOfLines());
    const std::int32_t first = this->Surface.Input.FirstCell();
    this->Visit([&](std::int32_t original, const std::int32_t* corners, std::int64_t size) {
      for (std::int64_t i = 0; i < size; ++i)
      {
        connectivity[corner + i] = map[static_cast<std::size_t>(corners[i])];
      }
      corner += size;
      originals[cell] = first + original;
      offsets[++cell] = corner;
    });
  }

private:
  bool IsKept(std::int32_t triangle) const
  {
    return this->Surface.Result.Fates[static_cast<std::size_t>(triangle)] == sb::Fate::Kept;
  }

  template <typename Visitor>
  void Visit(Visitor&& visit) const
  {
    const OperandSurface& input = this->Surface.Input;
    const std::int32_t* triangles = input.Mesh().Triangles;
    std::vector<std::int32_t> corners;
    for (std::int32_t cell = static_cast<std::int32_t>(this->Begin); cell < this->End; ++cell)
    {
      if (input.AllTriangles())
      {
        if (this->IsKept(cell))
        {
          visit(cell, triangles + 3 * std::int64_t(cell), 3);
        }
        continue;
      }
      this->VisitCell(cell, corners, visit);
    }
  }

  template <typename Visitor>
  void VisitCell(std::int32_t cell, std::vector<std::int32_t>& corners, Visitor&& visit) const
  {
    const OperandSurface& input = this->Surface.Input;
    const std::int32_t first = input.FirstTriangle(cell);
    const std::int32_t last = input.FirstTriangle(cell + 1);
    std::int32_t kept = 0;
    for (std::int32_t triangle = first; triangle < last; ++triangle)
    {
      kept += this->IsKept(triangle);
    }
    if (kept == last - first && kept > 0 && cell < input.NumberOfPolygons())
    {
      input.Corners(cell, corners);
      visit(cell, corners.data(), static_cast<std::int64_t>(corners.size()));
      return;
    }
    for (std::int32_t triangle = first; triangle < last && kept > 0; ++triangle)
    {
      if (this->IsKept(triangle))
      {
        visit(cell, input.Mesh().Triangles + 3 * std::int64_t(triangle), 3);
      }
    }
  }

  const ClippedSurface& Surface;
  std::int64_t Begin;
  std::int64_t End;
};

//------------------------------------------------------------------------------
ClippedSurface::ClippedSurface(OperandSurface& input, const sb::ClipResult& result,
  const ClippedLines& lines, bool withFaces, sb::Executor& executor)
  : Input(input)
  , Result(result)
  , Lines(lines)
{
  if (withFaces)
  {
    this->KeepAllPoints();
    this->AddKeptCells(executor);
    this->AddTriangles(result.Pieces);
    this->AddTriangles(result.Caps);
  }
  else
  {
    this->KeepPointsOfLines();
    this->AllocateCells(0, 0);
  }
  this->AddLines();
  this->AddCellSources();
}

//------------------------------------------------------------------------------
void ClippedSurface::KeepAllPoints()
{
  CopyRun run;
  run.Count = static_cast<std::int64_t>(this->Result.KeptPoints.size());
  run.PointIds = this->Result.KeptPoints.data();
  if (run.Count > 0)
  {
    this->PointSources.Runs.push_back(run);
  }
  this->PointSources.Interpolated = &this->Result.Created;
  this->PointSources.FirstInterpolated = run.Count;
  this->PointSources.NumberOfTuples =
    run.Count + static_cast<std::int64_t>(this->Result.Created.size());
  this->LineIds = this->Lines.Connectivity;
}

//------------------------------------------------------------------------------
void ClippedSurface::KeepPointsOfLines()
{
  const auto firstCreated = static_cast<std::int32_t>(this->Result.KeptPoints.size());
  std::unordered_map<std::int32_t, std::int32_t> ids;
  for (const std::int32_t point : this->Lines.Connectivity)
  {
    const auto known = ids.emplace(point, static_cast<std::int32_t>(this->PointsOfLines.size()));
    if (known.second)
    {
      // Lines have points of their own making only.
      this->PointsOfLines.push_back(
        this->Result.Created[static_cast<std::size_t>(point - firstCreated)]);
    }
    this->LineIds.push_back(known.first->second);
  }
  this->PointSources.Interpolated = &this->PointsOfLines;
  this->PointSources.NumberOfTuples = static_cast<std::int64_t>(this->PointsOfLines.size());
}

//------------------------------------------------------------------------------
void ClippedSurface::AllocateCells(std::int64_t numberOfPolygons, std::int64_t numberOfCorners)
{
  SetTuples(this->Offsets, numberOfPolygons + 1);
  this->Offsets->SetValue(0, 0);
  SetTuples(this->Connectivity, numberOfCorners);
  this->OriginalCellIds->SetName("OriginalCellId");
  SetTuples(this->OriginalCellIds, this->Lines.NumberOfLines() + numberOfPolygons);
  this->SourceIds->SetName("SourceId");
  SetTuples(this->SourceIds, this->Lines.NumberOfLines() + numberOfPolygons);
}

//------------------------------------------------------------------------------
void ClippedSurface::AddKeptCells(sb::Executor& executor)
{
  const std::int64_t numberOfCells =
    std::int64_t(this->Input.NumberOfPolygons()) + this->Input.NumberOfStrips();
  std::vector<Block> blocks;
  for (std::int64_t begin = 0; begin < numberOfCells; begin += grain)
  {
    blocks.emplace_back(*this, begin, std::min(numberOfCells, begin + grain));
  }
  const auto forEach = [&](auto&& body) {
    executor.For(
      static_cast<std::int64_t>(blocks.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end; ++block)
        {
          body(blocks[static_cast<std::size_t>(block)], static_cast<std::size_t>(block));
        }
      });
  };
  forEach([](Block& block, std::size_t) { block.Count(); });
  std::vector<std::int64_t> firstCells;
  std::vector<std::int64_t> firstCorners;
  for (const Block& block : blocks)
  {
    firstCells.push_back(this->NumberOfKeptCells);
    firstCorners.push_back(this->NumberOfKeptCorners);
    this->NumberOfKeptCells += block.Cells;
    this->NumberOfKeptCorners += block.Corners;
  }
  const auto added =
    static_cast<std::int64_t>(this->Result.Pieces.size() + this->Result.Caps.size());
  this->AllocateCells(this->NumberOfKeptCells + added, this->NumberOfKeptCorners + 3 * added);
  forEach([&](const Block& block, std::size_t i) { block.Write(firstCells[i], firstCorners[i]); });
  this->NextPolygon = this->NumberOfKeptCells;
  this->NextCorner = this->NumberOfKeptCorners;
}

//------------------------------------------------------------------------------
void ClippedSurface::AddTriangles(const std::vector<std::array<std::int32_t, 3>>& triangles)
{
  vtkTypeInt64* offsets = this->Offsets->GetPointer(0);
  vtkTypeInt64* connectivity = this->Connectivity->GetPointer(0);
  for (const std::array<std::int32_t, 3>& triangle : triangles)
  {
    std::copy(triangle.begin(), triangle.end(), connectivity + this->NextCorner);
    this->NextCorner += 3;
    offsets[++this->NextPolygon] = this->NextCorner;
  }
}

//------------------------------------------------------------------------------
void ClippedSurface::AddLines()
{
  int* sources = this->SourceIds->GetPointer(0);
  vtkIdType* originals = this->OriginalCellIds->GetPointer(0);
  const std::int64_t numberOfLines = this->Lines.NumberOfLines();
  std::copy(this->Lines.Sources.begin(), this->Lines.Sources.end(), sources);
  std::copy(this->Lines.Cells.begin(), this->Lines.Cells.end(), originals);
  const std::int64_t firstPiece = numberOfLines + this->NumberOfKeptCells;
  if (this->NextPolygon == 0)
  {
    return;
  }
  const std::int64_t firstCap = firstPiece + static_cast<std::int64_t>(this->Result.Pieces.size());
  std::fill(sources + numberOfLines, sources + firstCap, 0);
  for (std::size_t i = 0; i < this->Result.Pieces.size(); ++i)
  {
    originals[firstPiece + static_cast<std::int64_t>(i)] =
      this->Input.CellOfTriangle(this->Result.Parents[i]);
  }
  for (std::size_t i = 0; i < this->Result.Caps.size(); ++i)
  {
    sources[firstCap + static_cast<std::int64_t>(i)] = this->Result.PlaneOfCap[i] + 1;
    originals[firstCap + static_cast<std::int64_t>(i)] = -1;
  }
}

//------------------------------------------------------------------------------
/** Runs of cells that have, or have not, an input cell to copy from. */
void ClippedSurface::AddCellSources()
{
  const vtkIdType* originals = this->OriginalCellIds->GetPointer(0);
  const std::int64_t count = this->OriginalCellIds->GetNumberOfValues();
  this->CellSources.NumberOfTuples = count;
  // Where cells are kept in bulk, none is without origin.
  const std::int64_t firstKept = this->Lines.NumberOfLines();
  for (std::int64_t begin = 0, end = 0; begin < count; begin = end)
  {
    end = begin == firstKept ? begin + this->NumberOfKeptCells : begin;
    while (end < count && (originals[end] < 0) == (originals[begin] < 0) &&
      (end >= firstKept) == (begin >= firstKept))
    {
      ++end;
    }
    CopyRun run;
    run.Operand = originals[begin] < 0 ? 1 : 0;
    run.First = begin;
    run.Count = end - begin;
    run.CellIds = originals + begin;
    this->CellSources.Runs.push_back(run);
  }
}

//------------------------------------------------------------------------------
template <typename Value>
void ClippedSurface::CopyPoints(Value* target, sb::Executor& executor) const
{
  const double* source = this->Input.Mesh().Points;
  for (const CopyRun& run : this->PointSources.Runs)
  {
    executor.For(run.Count, grain, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          target[3 * i + axis] = static_cast<Value>(source[3 * run.Id(i) + axis]);
        }
      }
    });
  }
  Value* created = target + 3 * this->PointSources.FirstInterpolated;
  for (const sb::InterpolatedPoint& point : *this->PointSources.Interpolated)
  {
    for (const double coordinate : point.Position)
    {
      *created++ = static_cast<Value>(coordinate);
    }
  }
}

//------------------------------------------------------------------------------
void ClippedSurface::CopyTo(vtkPolyData* output, bool singlePrecision, sb::Executor& executor) const
{
  vtkNew<vtkPoints> points;
  points->SetDataType(singlePrecision ? VTK_FLOAT : VTK_DOUBLE);
  SetTuples(points, this->PointSources.NumberOfTuples);
  if (singlePrecision)
  {
    this->CopyPoints(vtkFloatArray::FastDownCast(points->GetData())->GetPointer(0), executor);
  }
  else
  {
    this->CopyPoints(vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0), executor);
  }
  output->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(this->Offsets, this->Connectivity);
  output->SetPolys(polygons);
  if (this->Lines.NumberOfLines() > 0)
  {
    vtkNew<vtkTypeInt64Array> offsets;
    vtkNew<vtkTypeInt64Array> connectivity;
    SetTuples(offsets, static_cast<vtkIdType>(this->Lines.Offsets.size()));
    SetTuples(connectivity, static_cast<vtkIdType>(this->LineIds.size()));
    std::copy(this->Lines.Offsets.begin(), this->Lines.Offsets.end(), offsets->GetPointer(0));
    std::copy(this->LineIds.begin(), this->LineIds.end(), connectivity->GetPointer(0));
    vtkNew<vtkCellArray> lines;
    lines->SetData(offsets, connectivity);
    output->SetLines(lines);
  }
  output->GetCellData()->AddArray(this->SourceIds);
  output->GetCellData()->AddArray(this->OriginalCellIds);
}

} // namespace sbvtk
