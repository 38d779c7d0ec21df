// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClippedSurface.h
 * @brief Builds the output of a clip from the kernel's answer, and lists where each point and cell
 * comes from.
 *
 * Order of the cells: lines, input cells that are kept whole, pieces of cut ones, caps. A polygon
 * of which every triangle is kept is passed on whole; strips become triangles.
 */
#ifndef ClippedSurface_h
#define ClippedSurface_h

#include "AttributeUnion.h"
#include "ClippedLines.h"
#include "OperandSurface.h"

#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"

#include <vector>

namespace sbvtk
{

class ClippedSurface
{
public:
  /**
   * @param lines the lines of the output; none for a surface without outline
   * @param withFaces whether the output has polygons; without them, it has the lines' points only
   */
  ClippedSurface(OperandSurface& input, const sb::ClipResult& result, const ClippedLines& lines,
    bool withFaces, sb::Executor& executor);

  /** Give `output` the points, lines and polygons, and the arrays SourceId and OriginalCellId. */
  void CopyTo(vtkPolyData* output, bool singlePrecision, sb::Executor& executor) const;

  const TupleSources& Points() const { return this->PointSources; }
  const TupleSources& Cells() const { return this->CellSources; }
  /** By cell: 0 for the input, else plane + 1. */
  vtkIntArray* Sources() const { return this->SourceIds; }

private:
  class Block;

  void KeepAllPoints();
  void KeepPointsOfLines();
  void AddLines();
  void AddKeptCells(sb::Executor& executor);
  void AddTriangles(const std::vector<std::array<std::int32_t, 3>>& triangles);
  void AllocateCells(std::int64_t numberOfPolygons, std::int64_t numberOfCorners);
  void AddCellSources();
  template <typename Value>
  void CopyPoints(Value* target, sb::Executor& executor) const;

  OperandSurface& Input;
  const sb::ClipResult& Result;
  const ClippedLines& Lines;
  std::vector<sb::InterpolatedPoint> PointsOfLines; ///< without faces: all points
  std::vector<std::int32_t> LineIds; ///< connectivity of the lines in the output
  std::int64_t NumberOfKeptCells = 0;
  std::int64_t NumberOfKeptCorners = 0;
  vtkNew<vtkTypeInt64Array> Offsets;
  vtkNew<vtkTypeInt64Array> Connectivity;
  vtkNew<vtkIntArray> SourceIds;
  vtkNew<vtkIdTypeArray> OriginalCellIds;
  std::int64_t NextPolygon = 0; ///< where the next one goes
  std::int64_t NextCorner = 0;
  TupleSources PointSources;
  TupleSources CellSources;
};

} // namespace sbvtk

#endif
