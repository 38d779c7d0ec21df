// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataSurfaceCheck
 * @brief   What is wrong with a surface before a Boolean, where, and what to do about it.
 *
 * Port 0 ("Input") takes one vtkPolyData with polygons and triangle strips; vertex and line cells
 * beside them are passed on unchecked. A composite data set of surfaces is checked as one surface.
 * Nothing is repaired. Points at one place count as one, as they do for a Boolean; whether
 * triangles meet or have an area is decided exactly, as it is there.
 *
 * Output 0, the surface with marks. Points whose coordinates are not finite numbers, cells that use
 * them, and cells that name points which do not exist, are left out, since they cannot be drawn.
 * Cell arrays:
 * - `Defect` (unsigned char): the gravest one of the cell, by the numbers of sb::Defect
 * (SurfaceCheck.h): 0 none, 1 at an edge of one polygon only, 2 at an edge of more than two, 3 at
 * an edge whose polygons are oriented against each other, 5 meets others elsewhere than in common
 * points and edges, 6 has no area, 7 repeats an earlier cell, 8 is the wrong way round;
 * - `ShellId` (int): the parts that hang together by edges, by their first cells; -1 for cells
 * without edges;
 * - `SelfIntersections` (int): how many triangles of others it meets;
 * - `Duplicate` (unsigned char): 1 if it has the same points as an earlier cell;
 * - `WrongWay` (unsigned char): 1 if it is oriented against most of its shell, or if that is inside
 * out where it is.
 *
 * Point arrays: `PointDefect` (unsigned char; as above, and 4: parts touch in the point without an
 * edge in common there), `DuplicatePoint` (unsigned char; 1 if an earlier point is
 * at the same place), `LoopId` (int; a loop of edges of one polygon that goes through it, or -1).
 *
 * Output 1, the defects: a line for each edge that is not one of two polygons of the same
 * orientation, for each segment in which triangles meet that should not, and for each triangle
 * without area; a vertex for each point in which parts touch. Cell arrays: `Defect` as above;
 * `LoopId` (int; -1 where it is on none); `CellIds` (vtkIdType, 2 components; cells of Input that
 * make it, -1 for none); `TriangleCount` (int; how many triangles the edge has).
 *
 * Field data of both: `Verdict` (one paragraph: what is wrong, and which filter or setting cures
 * it), `Fit` (1: Surface Boolean takes it as a solid, without a warning), `Clean` (1: nothing at
 * all was found), `Status` (int; see StatusType and sb::Status) and `Message` (whether the check
 * itself went well). Of output 0 also `Closed`, `Volume`, `Area`, `Genus` (-1 if it has none),
 * `EulerCharacteristic`, counts (names end in `Count`; `SelfIntersectionCount` is -1 if they were
 * not looked for), `BadCellIds` and `BadPointIds` (what is left out), one value a shell in
 * `ShellClosed`, `ShellVolume`, `ShellArea`, `ShellTriangleCount`, `ShellLoopCount`, `ShellGenus`,
 * `ShellDepth` (how many shells it is inside of), `ShellParent` (the innermost of them, or -1),
 * `ShellWrongWay` (1 inside out, 2 faces outwards inside of another one that does), and
 * `StageNames`, `StageSeconds`.
 *
 * The same input gives the same bytes whatever NumberOfThreads is.
 *
 * @par Cost
 * Linear, but for self-intersections; they take about as long as all the rest together, and longer
 * where there are many.
 */
#ifndef vtkPolyDataSurfaceCheck_h
#define vtkPolyDataSurfaceCheck_h

#include "sbSurfaceModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

class SBSURFACE_EXPORT vtkPolyDataSurfaceCheck : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPolyDataSurfaceCheck* New();
  vtkTypeMacro(vtkPolyDataSurfaceCheck, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of the field array `Status` beside those of the kernel (sb::Status in
   * Filters/Kernel/Boolean.h: 0, 8, 9 and 10). */
  enum StatusType
  {
    NOT_A_SURFACE = 20, ///< error: the input is no polygonal surface
    OUT_OF_MEMORY = 22 ///< error: the check does not fit into memory
  };

  ///@{
  /** Whether self-intersections are looked for. On by default. */
  vtkSetMacro(SelfIntersections, vtkTypeBool);
  vtkGetMacro(SelfIntersections, vtkTypeBool);
  vtkBooleanMacro(SelfIntersections, vtkTypeBool);
  ///@}

  ///@{
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /** Outputs 0 and 1. */
  vtkPolyData* GetSurfaceOutput() { return this->GetOutput(0); }
  vtkPolyData* GetDefectsOutput() { return this->GetOutput(1); }
  ///@}

protected:
  vtkPolyDataSurfaceCheck();
  ~vtkPolyDataSurfaceCheck() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataSurfaceCheck(const vtkPolyDataSurfaceCheck&) = delete;
  void operator=(const vtkPolyDataSurfaceCheck&) = delete;

  class Run;
  struct Cache;

  vtkTypeBool SelfIntersections = 1;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Kept;
};

#endif
