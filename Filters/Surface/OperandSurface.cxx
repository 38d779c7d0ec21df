// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OperandSurface.h"

#include "ArrayMemory.h"
#include "PolygonTriangulation.h"
#include "SnappedPoints.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace sbvtk
{
namespace
{

constexpr std::int64_t grain = 16384;
constexpr std::int64_t largest = std::numeric_limits<std::int32_t>::max();

} // namespace

//------------------------------------------------------------------------------
OperandSurface::OperandSurface(vtkPolyData* data, sb::Executor& executor, double tolerance)
  : Copy(vtkSmartPointer<vtkPolyData>::New())
  , Stamp(GeometryStamp(data))
  , Tolerance(tolerance)
{
  if (tolerance > 0.0 && data->GetPoints())
  {
    this->MovedPoints = SnappedPoints(data->GetPoints(), tolerance, executor);
  }
  this->SetAttributesFrom(data);
  this->NumberOfCellsBefore =
    static_cast<std::int32_t>(data->GetNumberOfVerts() + data->GetNumberOfLines());
  this->Polygons = IdsOf(data->GetPolys());
  this->Strips = IdsOf(data->GetStrips());
  this->PolygonCount = static_cast<std::int32_t>(this->Polygons.NumberOfCells);
  this->StripCount = static_cast<std::int32_t>(this->Strips.NumberOfCells);
  this->ConvertPoints(executor);
  if (this->OnlyTriangles(executor))
  {
    this->ConvertTriangles(executor);
  }
  else
  {
    this->ConvertPolygonsAndStrips(executor);
  }
}

//------------------------------------------------------------------------------
bool OperandSurface::FitsInt32(vtkPolyData* data)
{
  // A cell gives fewer triangles than it has entries in the connectivity.
  return data->GetNumberOfPoints() <= largest && data->GetNumberOfCells() <= largest &&
    IdsOf(data->GetPolys()).Size + IdsOf(data->GetStrips()).Size <= 3 * largest;
}

//------------------------------------------------------------------------------
std::vector<vtkMTimeType> OperandSurface::GeometryStamp(vtkPolyData* data)
{
  // Modification times are given out once in a process, so they tell arrays apart as well as their
  // states.
  std::vector<vtkMTimeType> stamp;
  stamp.push_back(data->GetPoints() ? data->GetPoints()->GetMTime() : 0);
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    stamp.push_back(cells ? cells->GetMTime() : 0);
    stamp.push_back(cells ? cells->GetOffsetsArray()->GetMTime() : 0);
    stamp.push_back(cells ? cells->GetConnectivityArray()->GetMTime() : 0);
  }
  stamp.push_back(static_cast<vtkMTimeType>(data->GetNumberOfVerts() + data->GetNumberOfLines()));
  return stamp;
}

//------------------------------------------------------------------------------
bool OperandSurface::IsConversionOf(vtkPolyData* data, double tolerance) const
{
  return this->Stamp == GeometryStamp(data) && this->Tolerance == tolerance;
}

//------------------------------------------------------------------------------
void OperandSurface::SetAttributesFrom(vtkPolyData* data)
{
  this->Copy->ShallowCopy(data);
  if (this->MovedPoints)
  {
    this->Copy->SetPoints(this->MovedPoints);
  }
}

//------------------------------------------------------------------------------
OperandSurface::CellIds OperandSurface::IdsOf(vtkCellArray* cells)
{
  CellIds ids;
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return ids;
  }
  ids.Is64Bit = cells->IsStorage64Bit();
  ids.NumberOfCells = cells->GetNumberOfCells();
  ids.Size = cells->GetConnectivityArray()->GetNumberOfValues();
  ids.Offsets = cells->GetOffsetsArray()->GetVoidPointer(0);
  ids.Connectivity = cells->GetConnectivityArray()->GetVoidPointer(0);
  return ids;
}

//------------------------------------------------------------------------------
inline std::int64_t OperandSurface::CellIds::Offset(std::int64_t cell) const
{
  return this->Is64Bit ? static_cast<const vtkTypeInt64*>(this->Offsets)[cell]
                       : static_cast<const vtkTypeInt32*>(this->Offsets)[cell];
}

//------------------------------------------------------------------------------
inline std::int64_t OperandSurface::CellIds::Id(std::int64_t place) const
{
  return this->Is64Bit ? static_cast<const vtkTypeInt64*>(this->Connectivity)[place]
                       : static_cast<const vtkTypeInt32*>(this->Connectivity)[place];
}

//------------------------------------------------------------------------------
inline void OperandSurface::CellIds::Range(
  std::int64_t cell, std::int64_t& begin, std::int64_t& end) const
{
  begin = this->Offset(cell);
  end = this->Offset(cell + 1);
  if (begin < 0 || end > this->Size || begin > end)
  {
    begin = end = 0;
  }
}

//------------------------------------------------------------------------------
/** An id that names no point becomes -1, which the kernel reports with its triangle. */
inline std::int32_t OperandSurface::ValidId(std::int64_t id) const
{
  return id >= 0 && id < this->Triangulated.NumberOfPoints ? static_cast<std::int32_t>(id) : -1;
}

//------------------------------------------------------------------------------
void OperandSurface::ConvertPoints(sb::Executor& executor)
{
  vtkPoints* points = this->Copy->GetPoints();
  const std::int64_t numberOfPoints = points ? points->GetNumberOfPoints() : 0;
  this->Triangulated.NumberOfPoints = numberOfPoints;
  if (numberOfPoints == 0)
  {
    return;
  }
  if (vtkDoubleArray* inPlace = vtkDoubleArray::FastDownCast(points->GetData()))
  {
    this->Triangulated.Points = inPlace->GetPointer(0);
    return;
  }
  this->OwnPoints.reset(new double[3 * numberOfPoints]);
  this->Triangulated.Points = this->OwnPoints.get();
  double* target = this->OwnPoints.get();
  if (vtkFloatArray* floats = vtkFloatArray::FastDownCast(points->GetData()))
  {
    const float* source = floats->GetPointer(0);
    executor.For(3 * numberOfPoints, grain, [=](std::int64_t begin, std::int64_t end) {
      std::copy(source + begin, source + end, target + begin);
    });
    return;
  }
  vtkNew<vtkDoubleArray> doubles; // other number types and memory layouts are rare
  CopyTuples(points->GetData(), doubles);
  std::copy_n(doubles->GetPointer(0), 3 * numberOfPoints, target);
}

//------------------------------------------------------------------------------
bool OperandSurface::OnlyTriangles(sb::Executor& executor) const
{
  if (this->StripCount > 0 || this->Polygons.Size != 3 * this->Polygons.NumberOfCells)
  {
    return false;
  }
  std::atomic<bool> only{ true };
  executor.For(this->Polygons.NumberOfCells, grain, [&](std::int64_t begin, std::int64_t end) {
    bool all = true;
    for (std::int64_t cell = begin; cell < end; ++cell)
    {
      all &= this->Polygons.Offset(cell) == 3 * cell;
    }
    if (!all)
    {
      only = false;
    }
  });
  return only;
}

//------------------------------------------------------------------------------
void OperandSurface::ConvertTriangles(sb::Executor& executor)
{
  this->Triangulated.NumberOfTriangles = this->Polygons.NumberOfCells;
  if (this->Polygons.NumberOfCells == 0)
  {
    return;
  }
  if (!this->Polygons.Is64Bit)
  {
    this->Triangulated.Triangles = static_cast<const std::int32_t*>(this->Polygons.Connectivity);
    return;
  }
  this->OwnTriangles.reset(new std::int32_t[this->Polygons.Size]);
  this->Triangulated.Triangles = this->OwnTriangles.get();
  const vtkTypeInt64* source = static_cast<const vtkTypeInt64*>(this->Polygons.Connectivity);
  executor.For(this->Polygons.Size, grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t place = begin; place < end; ++place)
    {
      this->OwnTriangles[place] = this->ValidId(source[place]);
    }
  });
}

//------------------------------------------------------------------------------
void OperandSurface::ConvertPolygonsAndStrips(sb::Executor& executor)
{
  const std::int32_t numberOfCells = this->PolygonCount + this->StripCount;
  this->FirstTriangles.resize(static_cast<std::size_t>(numberOfCells) + 1);
  std::int32_t numberOfTriangles = 0;
  for (std::int32_t cell = 0; cell < numberOfCells; ++cell)
  {
    this->FirstTriangles[cell] = numberOfTriangles;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    const bool polygon = cell < this->PolygonCount;
    (polygon ? this->Polygons : this->Strips)
      .Range(polygon ? cell : cell - this->PolygonCount, begin, end);
    numberOfTriangles += static_cast<std::int32_t>(std::max<std::int64_t>(0, end - begin - 2));
  }
  this->FirstTriangles[numberOfCells] = numberOfTriangles;

  this->OwnTriangles.reset(new std::int32_t[3 * static_cast<std::int64_t>(numberOfTriangles)]);
  this->Triangulated.Triangles = this->OwnTriangles.get();
  this->Triangulated.NumberOfTriangles = numberOfTriangles;
  executor.For(numberOfCells, grain / 4, [&](std::int64_t begin, std::int64_t end) {
    PolygonTriangulation cutter;
    std::vector<std::int32_t> corners;
    for (std::int32_t cell = static_cast<std::int32_t>(begin); cell < end; ++cell)
    {
      std::int32_t* triangles =
        this->OwnTriangles.get() + 3 * static_cast<std::int64_t>(this->FirstTriangles[cell]);
      if (cell < this->PolygonCount)
      {
        this->CutPolygon(cell, cutter, corners, triangles);
      }
      else
      {
        this->CutStrip(cell - this->PolygonCount, triangles);
      }
    }
  });
}

//------------------------------------------------------------------------------
void OperandSurface::CutPolygon(std::int32_t polygon, PolygonTriangulation& cutter,
  std::vector<std::int32_t>& corners, std::int32_t* triangles) const
{
  this->Corners(polygon, corners);
  if (corners.size() < 3)
  {
    return;
  }
  if (std::find(corners.begin(), corners.end(), -1) != corners.end())
  {
    std::fill_n(triangles, 3 * (corners.size() - 2), -1);
    return;
  }
  for (const std::array<std::int32_t, 3>& triangle : cutter.Cut(this->Triangulated.Points, corners))
  {
    for (const std::int32_t place : triangle)
    {
      *triangles++ = corners[place];
    }
  }
}

//------------------------------------------------------------------------------
void OperandSurface::CutStrip(std::int32_t strip, std::int32_t* triangles) const
{
  std::int64_t begin = 0;
  std::int64_t end = 0;
  this->Strips.Range(strip, begin, end);
  for (std::int64_t place = begin; place + 2 < end; ++place)
  {
    const std::int64_t odd = (place - begin) % 2;
    *triangles++ = this->ValidId(this->Strips.Id(place + odd));
    *triangles++ = this->ValidId(this->Strips.Id(place + 1 - odd));
    *triangles++ = this->ValidId(this->Strips.Id(place + 2));
  }
}

//------------------------------------------------------------------------------
void OperandSurface::Corners(std::int32_t polygon, std::vector<std::int32_t>& corners) const
{
  std::int64_t begin = 0;
  std::int64_t end = 0;
  this->Polygons.Range(polygon, begin, end);
  corners.resize(end - begin);
  for (std::int64_t place = begin; place < end; ++place)
  {
    corners[place - begin] = this->ValidId(this->Polygons.Id(place));
  }
}

//------------------------------------------------------------------------------
std::int32_t OperandSurface::CellOfTriangle(std::int64_t triangle) const
{
  if (this->AllTriangles())
  {
    return this->NumberOfCellsBefore + static_cast<std::int32_t>(triangle);
  }
  const auto after = std::upper_bound(
    this->FirstTriangles.begin(), this->FirstTriangles.end(), static_cast<std::int32_t>(triangle));
  return this->NumberOfCellsBefore +
    static_cast<std::int32_t>(after - this->FirstTriangles.begin()) - 1;
}

//------------------------------------------------------------------------------
const std::shared_ptr<const sb::Examination>& OperandSurface::Examination(
  sb::Executor& executor, sb::OpenSurfaces open)
{
  if (!this->Examined)
  {
    this->Examined = sb::Examine(this->Triangulated, executor, open);
  }
  return this->Examined;
}

} // namespace sbvtk
