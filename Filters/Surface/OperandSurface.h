// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OperandSurface.h
 * @brief A vtkPolyData as the kernel's triangle surface, with the way back from its triangles to
 * its cells.
 *
 * The cells of a vtkPolyData are numbered vertices first, then lines, polygons and strips. A
 * polygon becomes its number of corners minus two triangles, a strip its number of points minus
 * two; vertices and lines have no part in a Boolean.
 */
#ifndef OperandSurface_h
#define OperandSurface_h

#include "Boolean.h"
#include "sbSurfaceModule.h" // for the export macro

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkCellArray;
class vtkPoints;

namespace sbvtk
{

class PolygonTriangulation;

/** The triangles of one operand. Arrays of the data set that the kernel can read as they are, are
 * not copied. */
class SBSURFACE_EXPORT OperandSurface
{
public:
  /**
   * Convert. `data` must not have more than 2^31 - 1 points, cells or triangles: see FitsInt32.
   * With a positive tolerance the points are moved by at most that (SnappedPoints.h), in Data()
   * too.
   */
  OperandSurface(vtkPolyData* data, sb::Executor& executor, double tolerance = 0.0);

  /** Whether 32-bit ids can count the points, cells and triangles. */
  static bool FitsInt32(vtkPolyData* data);

  /** Whether this was made with that tolerance of the geometry that `data` has now; its attributes
   * are not looked at. */
  bool IsConversionOf(vtkPolyData* data, double tolerance = 0.0) const;

  /** Take the attributes that `data` has now; its geometry has to be the one that was converted. */
  void SetAttributesFrom(vtkPolyData* data);

  vtkPolyData* Data() const { return this->Copy; }
  const sb::Surface& Mesh() const { return this->Triangulated; }

  /** The kernel's examination of the surface, made when first asked for; `open` has to be the same
   * every time. */
  const std::shared_ptr<const sb::Examination>& Examination(
    sb::Executor& executor, sb::OpenSurfaces open = sb::OpenSurfaces::Diagnose);

  /** Cells before the first polygon (vertices and lines). */
  std::int32_t FirstCell() const { return this->NumberOfCellsBefore; }
  std::int32_t NumberOfPolygons() const { return this->PolygonCount; }
  std::int32_t NumberOfStrips() const { return this->StripCount; }

  /** Whether each cell is one triangle: triangle t is then cell FirstCell() + t. */
  bool AllTriangles() const { return this->FirstTriangles.empty(); }

  /** First triangle of the polygon or strip `cell` (counted from FirstCell()); that of the last
   * plus one is the end. */
  std::int32_t FirstTriangle(std::int32_t cell) const
  {
    return this->AllTriangles() ? cell : this->FirstTriangles[cell];
  }

  /** The cell of the data set that a triangle was cut from. */
  std::int32_t CellOfTriangle(std::int64_t triangle) const;

  /** The corners of a polygon (counted from FirstCell()). */
  void Corners(std::int32_t polygon, std::vector<std::int32_t>& corners) const;

private:
  struct CellIds
  {
    const void* Offsets = nullptr;
    const void* Connectivity = nullptr;
    std::int64_t NumberOfCells = 0;
    std::int64_t Size = 0;
    bool Is64Bit = false;

    std::int64_t Offset(std::int64_t cell) const;
    std::int64_t Id(std::int64_t place) const;
    /** Begin and end in the connectivity; an empty range if they lie outside of it. */
    void Range(std::int64_t cell, std::int64_t& begin, std::int64_t& end) const;
  };

  static CellIds IdsOf(vtkCellArray* cells);
  static std::vector<vtkMTimeType> GeometryStamp(vtkPolyData* data);
  std::int32_t ValidId(std::int64_t id) const;
  bool OnlyTriangles(sb::Executor& executor) const;
  void ConvertPoints(sb::Executor& executor);
  void ConvertTriangles(sb::Executor& executor);
  void ConvertPolygonsAndStrips(sb::Executor& executor);
  void CutPolygon(std::int32_t polygon, PolygonTriangulation& cutter,
    std::vector<std::int32_t>& corners, std::int32_t* triangles) const;
  void CutStrip(std::int32_t strip, std::int32_t* triangles) const;

  vtkSmartPointer<vtkPolyData> Copy; // shallow: keeps alive what is read in place
  vtkSmartPointer<vtkPoints> MovedPoints; // null without a tolerance
  std::vector<vtkMTimeType> Stamp;
  double Tolerance;
  sb::Surface Triangulated;
  CellIds Polygons;
  CellIds Strips;
  std::int32_t NumberOfCellsBefore = 0;
  std::int32_t PolygonCount = 0;
  std::int32_t StripCount = 0;
  std::shared_ptr<const sb::Examination> Examined;
  std::unique_ptr<double[]> OwnPoints;
  std::unique_ptr<std::int32_t[]> OwnTriangles;
  std::vector<std::int32_t> FirstTriangles;
};

} // namespace sbvtk

#endif
