// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataIntersection
 * @brief   The curves in which two surfaces meet, and both surfaces cut along them.
 *
 * After C. Quammen, C. Weigle, R. M. Taylor II: "Boolean Operations on Surfaces in VTK Without
 * External Libraries", The VTK Journal, 2011, sections 5.1 to 5.3, whose class of this name had the
 * same options. The curves are found with exact arithmetic: touching and coplanar triangles are
 * ordinary cases, and no tolerance decides which points are one.
 *
 * Port 0 ("Input") and port 1 ("Tool", which may be missing) each take one vtkPolyData with
 * polygons and triangle strips; vertex and line cells in them are ignored. A composite data set of
 * surfaces counts as one surface. Without Tool, the curves are those in which Input meets itself.
 * Surfaces may be open, and their polygons may be oriented against each other.
 *
 * Output 0, the curves, as polylines joined end to end; each point is there once. A curve ends
 * where more or fewer than two segments meet; a closed one names its first point again at its end.
 * Where surfaces have an area in common, its outline is a curve. Cell arrays:
 * - `CurveId` (int): 0, 1, ...;
 * - `Length` (double), in the unit of the points;
 * - `Closed` (unsigned char): 1 or 0;
 * - `SourceIds` (int, 2 components): the surfaces that meet there, 0 (Input) and 1 (Tool), or 0 and
 * 0.
 *
 * Field data of output 0: `SegmentCellIds` (vtkIdType, 2 components), the cells of these surfaces
 * that make each segment, in the order of the polylines (a polyline of n points has n - 1
 * segments); `TotalLength`, `ContactCount` (pairs of triangles that touch or cross), `Status` (int;
 * see StatusType and sb::Status, 0 is Ok), `Message` (the sentence for it), `StageNames` and
 * `StageSeconds`.
 *
 * Outputs 1 and 2, Input and Tool cut so that the curves are edges of them. Polygons that no curve
 * touches are passed on whole, cut ones become triangles, without a T-junction between them. All
 * point and cell arrays are carried and interpolated at new points. Where a surface has several
 * points at one place, to have several normals there, so has a cut through that crease. Arrays of
 * its own:
 * - cell array `PatchId` (int): the parts into which the curves divide the surface, 0, 1, ...;
 * - cell array `OriginalCellId` (vtkIdType): the cell of the surface that it comes from;
 * - cell array `SourceId` (int): 0 in output 1, 1 in output 2;
 * - point array `SeamPoint` (unsigned char): 1 on a curve.
 *
 * Surfaces that do not meet are no error: there are no curves, the surfaces come out as they are,
 * and `Status` is NO_CURVE. An input that cannot be used gives one error message that says what,
 * where and what to do, and empty outputs. The points of all outputs are floats where both surfaces
 * have float points, else doubles. The same inputs give the same bytes whatever NumberOfThreads is.
 *
 * @par Cost
 * Proportional to the part of the surfaces that lies where they overlap; an output of a cut surface
 * costs a pass over the whole of it. Without Tool, all of Input is searched.
 */
#ifndef vtkPolyDataIntersection_h
#define vtkPolyDataIntersection_h

#include "sbSurfaceModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

class SBSURFACE_EXPORT vtkPolyDataIntersection : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPolyDataIntersection* New();
  vtkTypeMacro(vtkPolyDataIntersection, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of the field array `Status` beside those of the kernel (sb::Status in
   * Filters/Kernel/Boolean.h, 0 to 10). */
  enum StatusType
  {
    NOT_A_SURFACE = 20, ///< error: an input is no polygonal surface
    OUT_OF_MEMORY = 22, ///< error: the result does not fit into memory
    NO_CURVE = 40 ///< no error and no warning: the surfaces do not meet in a curve
  };

  ///@{
  /** Whether output 1 is made: Input, cut along the curves. On by default. */
  vtkSetMacro(SplitFirstOutput, vtkTypeBool);
  vtkGetMacro(SplitFirstOutput, vtkTypeBool);
  vtkBooleanMacro(SplitFirstOutput, vtkTypeBool);
  ///@}

  ///@{
  /** Whether output 2 is made: Tool, cut along the curves. On by default. */
  vtkSetMacro(SplitSecondOutput, vtkTypeBool);
  vtkGetMacro(SplitSecondOutput, vtkTypeBool);
  vtkBooleanMacro(SplitSecondOutput, vtkTypeBool);
  ///@}

  ///@{
  /**
   * How far a point may be moved, in the unit of the points, before the exact computation starts;
   * zero or more. Points move to the nearest places of a grid of about that width, which closes
   * gaps far smaller than it, within a surface and between surfaces. It never loosens a comparison.
   * 0 by default.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /** The surface of port 1, beside SetInputConnection(1, ...). */
  void SetToolData(vtkPolyData* tool) { this->SetInputData(1, tool); }
  void SetToolConnection(vtkAlgorithmOutput* tool) { this->SetInputConnection(1, tool); }
  void RemoveTool() { this->SetInputConnection(1, nullptr); }
  ///@}

  ///@{
  /** Outputs 0, 1 and 2. */
  vtkPolyData* GetCurvesOutput() { return this->GetOutput(0); }
  vtkPolyData* GetSplitInputOutput() { return this->GetOutput(1); }
  vtkPolyData* GetSplitToolOutput() { return this->GetOutput(2); }
  ///@}

protected:
  vtkPolyDataIntersection();
  ~vtkPolyDataIntersection() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataIntersection(const vtkPolyDataIntersection&) = delete;
  void operator=(const vtkPolyDataIntersection&) = delete;

  class Run;
  struct Cache;

  vtkTypeBool SplitFirstOutput = 1;
  vtkTypeBool SplitSecondOutput = 1;
  double Tolerance = 0.0;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Inputs;
};

#endif
