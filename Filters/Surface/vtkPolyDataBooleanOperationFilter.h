// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataBooleanOperationFilter
 * @brief   Union, intersection, difference and more of surfaces, by their exact arrangement.
 *
 * After C. Quammen, C. Weigle, R. M. Taylor II: "Boolean Operations on Surfaces in VTK Without
 * External Libraries", The VTK Journal, 2011, whose class of this name had the same options. The
 * answer is computed with exact arithmetic, so that touching, coplanar, identical, nested and
 * disjoint surfaces need no care: a result of closed surfaces is closed.
 *
 * Port 0 ("Input", one or more connections) and port 1 ("Tool", none or more) take vtkPolyData with
 * polygons and triangle strips; vertex and line cells in them are ignored. A composite data set of
 * surfaces counts as one surface. The surfaces of a port are united first; the operation then
 * combines the two unions:
 *
 * | operation            | the result encloses what is                                            |
 * | -------------------- | ---------------------------------------------------------------------- |
 * | union                | inside any surface                                                     |
 * | intersection         | inside an Input and a Tool; without Tool, inside all Inputs            |
 * | difference           | inside an Input and no Tool                                            |
 * | symmetric difference | inside an Input or a Tool, but not both                                |
 * | resolve              | inside any surface, all overlaps and self-intersections of each taken
 * away |
 *
 * Output 0 is the surface. Polygons that no other surface touches are passed on whole, cut ones
 * become triangles. Its points are floats where all surfaces have float points, else doubles. It
 * has all point and cell arrays of all surfaces (NaN, 0 or an empty text where a surface has none);
 * at new points they are interpolated. Cell arrays of its own:
 * - `SourceId` (int): the connection that the cell comes from, those of Input first, counted from
 * 0;
 * - `OriginalCellId` (vtkIdType): the cell of that surface.
 *
 * Output 1 are the curves in which the surfaces meet, as polylines with the cell arrays `Length`
 * (double) and `Closed` (0 or 1).
 *
 * Field data of output 0, after that of the first Input: `Status` (int; see StatusType and
 * sb::Status, 0 is Ok), `Message` (the sentence for it), `OperandVolume` and `OperandArea` (one
 * value a connection), `ResultVolume`, `ResultArea`, `ContactCount` (pairs of triangles that touch
 * or cross), `StageNames` and `StageSeconds`.
 *
 * An input that cannot be used gives one error message that says what, where and what to do, and
 * empty outputs. The same inputs give the same bytes whatever NumberOfThreads is.
 *
 * @par Cost
 * Proportional to the part of the surfaces that lies where they overlap, not to the whole. What
 * depends on one input alone is kept until that input changes.
 */
#ifndef vtkPolyDataBooleanOperationFilter_h
#define vtkPolyDataBooleanOperationFilter_h

#include "sbSurfaceModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

class SBSURFACE_EXPORT vtkPolyDataBooleanOperationFilter : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPolyDataBooleanOperationFilter* New();
  vtkTypeMacro(vtkPolyDataBooleanOperationFilter, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OperationType
  {
    VTK_UNION = 0,
    VTK_INTERSECTION,
    VTK_DIFFERENCE,
    VTK_SYMMETRIC_DIFFERENCE,
    VTK_RESOLVE
  };

  /** Values of the field array `Status` beside those of the kernel (sb::Status in
   * Filters/Kernel/Boolean.h, 0 to 10). */
  enum StatusType
  {
    NOT_A_SURFACE = 20, ///< error: an input is no polygonal surface
    MISSING_TOOL = 21, ///< error: the operation needs a Tool
    OUT_OF_MEMORY = 22, ///< error: the result does not fit into memory
    ONE_SURFACE = 23 ///< warning: a union of one surface, which is that surface
  };

  ///@{
  /** Which operation to compute: one of OperationType. Union is the default. */
  vtkSetMacro(Operation, int);
  vtkGetMacro(Operation, int);
  void SetOperationToUnion() { this->SetOperation(VTK_UNION); }
  void SetOperationToIntersection() { this->SetOperation(VTK_INTERSECTION); }
  void SetOperationToDifference() { this->SetOperation(VTK_DIFFERENCE); }
  void SetOperationToSymmetricDifference() { this->SetOperation(VTK_SYMMETRIC_DIFFERENCE); }
  void SetOperationToResolve() { this->SetOperation(VTK_RESOLVE); }
  ///@}

  ///@{
  /**
   * Whether to turn over the cells of a difference (or symmetric difference) that come from inside
   * the other surface, and to negate their normals, so that all cells of the result face outwards.
   * On by default. Off, they keep the order of their points and their normals as in the input.
   */
  vtkSetMacro(ReorientDifferenceCells, vtkTypeBool);
  vtkGetMacro(ReorientDifferenceCells, vtkTypeBool);
  vtkBooleanMacro(ReorientDifferenceCells, vtkTypeBool);
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
  /** The surfaces of port 1, beside SetInputConnection(1, ...) and AddInputConnection(1, ...). */
  void SetToolData(vtkPolyData* tool) { this->SetInputData(1, tool); }
  void AddToolData(vtkPolyData* tool) { this->AddInputData(1, tool); }
  void SetToolConnection(vtkAlgorithmOutput* tool) { this->SetInputConnection(1, tool); }
  void AddToolConnection(vtkAlgorithmOutput* tool) { this->AddInputConnection(1, tool); }
  void RemoveAllTools() { this->SetInputConnection(1, nullptr); }
  ///@}

  /** Output 1: the curves in which the surfaces meet. */
  vtkPolyData* GetCurvesOutput() { return this->GetOutput(1); }

protected:
  vtkPolyDataBooleanOperationFilter();
  ~vtkPolyDataBooleanOperationFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataBooleanOperationFilter(const vtkPolyDataBooleanOperationFilter&) = delete;
  void operator=(const vtkPolyDataBooleanOperationFilter&) = delete;

  class Run;
  struct Cache;

  int Operation = VTK_UNION;
  vtkTypeBool ReorientDifferenceCells = 1;
  double Tolerance = 0.0;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Inputs;
};

#endif
