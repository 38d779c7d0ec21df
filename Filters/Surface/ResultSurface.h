// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ResultSurface.h
 * @brief Builds the output surface's points and cells from the kernel's answer, and lists where
 * each comes from.
 *
 * Order of the cells: operand by operand the untouched cells in their own order, then operand by
 * operand the pieces of cut triangles. A polygon of which every triangle is untouched is passed on
 * whole; strips become triangles.
 */
#ifndef ResultSurface_h
#define ResultSurface_h

#include "AttributeUnion.h"
#include "OperandSurface.h"

#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"

#include <memory>
#include <vector>

namespace sbvtk
{

struct ResultOptions
{
  bool SinglePrecision = false; ///< float points; right only where all operands have float points
  bool TurnReversed = true; ///< turn over the cells that the kernel names reversed
  bool KeepReversal = false; ///< remember which cells are turned over
  /** Give reversed and other cells points of their own, so that each can have its own normal. Needs
   * KeepReversal. */
  bool SeparateReversed = false;
  bool KeepOrigins = false; ///< remember which triangle or piece each cell is
  /** [operand][triangle] 1: a polygon with this triangle is not passed on whole. Empty, or empty
   * for an operand: there is none. */
  std::vector<std::vector<std::uint8_t>> Loose;
};

class ResultSurface
{
public:
  ResultSurface(const std::vector<std::shared_ptr<OperandSurface>>& operands,
    const sb::CutSurfaces& result, const ResultOptions& options, sb::Executor& executor);

  /** Give `output` the points and polygons, and the cell arrays SourceId and OriginalCellId. */
  void CopyTo(vtkPolyData* output, sb::Executor& executor) const;

  const TupleSources& Points() const { return this->PointSources; }
  const TupleSources& Cells() const { return this->CellSources; }

  /** Whether any cell is turned over; known only with KeepReversal. */
  bool HasReversed() const;
  /** For each cell the triangle that it is (the first one, of a polygon), or ~piece. Known only
   * with KeepOrigins. */
  const std::vector<std::int32_t>& Origins() const { return this->CellOrigins; }
  /** For each cell 1 where it is turned over. */
  const std::vector<std::uint8_t>& ReversedCells() const { return this->Reversed; }
  std::vector<std::int32_t> OperandsOfCells() const;
  /** For each point 1 where a reversed cell uses it, and its operand there. */
  void FindReversedPoints(
    std::vector<std::int32_t>& operands, std::vector<std::uint8_t>& reversed) const;

private:
  /** A part of the output's cells: a block of one operand's input cells, or all pieces of its cut
   * triangles. */
  struct Part
  {
    std::int32_t Operand = 0;
    bool OfPieces = false;
    std::int64_t Begin =
      0; ///< of the input cells (counted from the first polygon), or of PieceOrder
    std::int64_t End = 0;
    std::int64_t FirstCell = 0; ///< of the output
    std::int64_t FirstCorner = 0;
    std::int64_t NumberOfCells = 0;
    std::int64_t NumberOfCorners = 0;
  };
  class Counter;
  class Writer;

  void AddPointSources();
  void OrderPieces();
  void MakeParts();
  template <typename Sink>
  void Visit(const Part& part, Sink& sink) const;
  template <typename Sink>
  void VisitTriangles(const Part& part, Sink& sink) const;
  template <typename Sink>
  void VisitCells(const Part& part, Sink& sink) const;
  template <typename Sink>
  bool VisitWholePolygon(std::int32_t operand, std::int32_t polygon,
    std::vector<std::int32_t>& corners, Sink& sink) const;
  bool IsLoose(std::int32_t operand, std::int32_t begin, std::int32_t end) const;
  template <typename Sink>
  void VisitPieces(const Part& part, Sink& sink) const;
  void Place();
  void Allocate();
  void AddCellSources();
  void SeparateReversedPoints();
  template <typename Value>
  void CopyPoints(Value* target, sb::Executor& executor) const;

  const std::vector<std::shared_ptr<OperandSurface>>& Operands;
  const sb::CutSurfaces& Result;
  ResultOptions Options;
  std::vector<std::int32_t> PieceOrder; ///< pieces, operand by operand
  std::vector<Part> Parts;
  vtkNew<vtkTypeInt64Array> Offsets;
  vtkNew<vtkTypeInt64Array> Connectivity;
  vtkNew<vtkIntArray> SourceIds;
  vtkNew<vtkIdTypeArray> OriginalCellIds;
  std::vector<std::uint8_t> Reversed;
  std::vector<std::int32_t> CellOrigins;
  TupleSources PointSources;
  TupleSources CellSources;
};

} // namespace sbvtk

#endif
