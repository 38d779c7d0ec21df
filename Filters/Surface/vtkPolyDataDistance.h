// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataDistance
 * @brief   The distance from the points of one data set to a surface, with a sign.
 *
 * After C. Quammen, C. Weigle, R. M. Taylor II: "Boolean Operations on Surfaces in VTK Without
 * External Libraries", The VTK Journal, 2011, section 3.2, whose class of this name had the options
 * SignedDistance, NegateDistance and ComputeSecondDistance.
 *
 * Port 0 ("Input") takes any vtkDataSet, or a composite data set of them; port 1 ("Tool") a
 * vtkPolyData with polygons or strips, or a composite of such, which counts as one surface.
 *
 * Output 0 is the Input with the point array `Distance` (double, in the unit of the points), its
 * active scalars: negative inside the Tool, positive outside, zero on it. Output 1 is the Tool;
 * with ComputeSecondDistance it has the array, too: its points' distances to the Input, whose
 * polygons count if it has any, else its points (then without sign). GetOutput() is null if the
 * Input is no vtkPolyData: use GetOutputDataObject(0).
 *
 * On request: `Distance` on cells, at the mean of a cell's points; `NearestPoint`, `NearestCellId`
 * (the cell of the Tool; -1 if there is none) and `Direction` (from the point to the nearest one,
 * of length one; zero on the surface). Points that are not finite have NaN and a warning.
 *
 * Field data of both outputs: `Status` (int, 0 is Ok), `Message` (the sentence for it); of those
 * with distances `DistanceMinimum`, `DistanceMaximum`, `DistanceMean`, `DistanceRMS` and
 * `DistanceQuantile5`, `25`, `50`, `75`, `95` of the point array; `HausdorffInputToTool`, the
 * largest distance of a point of the Input from the Tool; with ComputeSecondDistance also
 * `HausdorffToolToInput` and `HausdorffDistance`, the larger of both.
 *
 * @par Sign
 * Where the Tool is closed the sign is right everywhere: at the nearest face, edge or vertex it is
 * that of the angle-weighted pseudonormal. An open Tool gives a warning; the sign tells the side of
 * the nearest polygon. SetSignMethodToWindingNumber suits open and dirty surfaces,
 * SignedDistanceOff gives the distance without sign.
 *
 * @par Cost
 * About a microsecond of processor time a triangle of the Tool to prepare it, which is kept until
 * the Tool changes, and one to four microseconds a point at a million triangles. 110 bytes a
 * triangle of the Tool, and some 40 bytes a point, 8 of which stay.
 *
 * @par Parallel servers
 * Input and Tool stay where they are: each process has the whole Tool (with ComputeSecondDistance
 * the whole Input, too) and measures its own piece. Cells of the Tool count through all pieces, in
 * the order of the processes. For the summary the first process gets all points, 32 bytes each.
 */
#ifndef vtkPolyDataDistance_h
#define vtkPolyDataDistance_h

#include "sbSurfaceModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

class vtkMultiProcessController;

class SBSURFACE_EXPORT vtkPolyDataDistance : public vtkPolyDataAlgorithm
{
public:
  static vtkPolyDataDistance* New();
  vtkTypeMacro(vtkPolyDataDistance, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SignMethodType
  {
    VTK_PSEUDONORMAL = 0, ///< the side of the nearest face, edge or vertex
    VTK_WINDING_NUMBER = 1 ///< inside where the Tool winds around the point
  };

  /** Values of the field array `Status` beside those of the kernel (sb::Status in
   * Filters/Kernel/Boolean.h, 0 to 10). */
  enum StatusType
  {
    NOT_A_SURFACE = 20, ///< error: Tool is no polygonal surface, or Input no data set
    MISSING_TOOL = 21, ///< error: there is no Tool
    OUT_OF_MEMORY = 22, ///< error: the result does not fit into memory
    EMPTY_SURFACE = 30, ///< error: Tool has no polygon
    POINTS_NOT_FINITE = 31, ///< warning: some points of Input have no distance
    SIGNS_CONTRADICT = 32 ///< warning: neighbouring polygons are oriented against each other
  };

  ///@{
  /** Whether the distance has a sign. On by default; off, it is the plain distance. */
  vtkSetMacro(SignedDistance, vtkTypeBool);
  vtkGetMacro(SignedDistance, vtkTypeBool);
  vtkBooleanMacro(SignedDistance, vtkTypeBool);
  ///@}

  ///@{
  /** Whether to turn the sign over, so that it is positive inside. Without effect if SignedDistance
   * is off. Off by default. */
  vtkSetMacro(NegateDistance, vtkTypeBool);
  vtkGetMacro(NegateDistance, vtkTypeBool);
  vtkBooleanMacro(NegateDistance, vtkTypeBool);
  ///@}

  ///@{
  /** Whether to compute the distance of the Tool's points to the Input, too. Off by default. */
  vtkSetMacro(ComputeSecondDistance, vtkTypeBool);
  vtkGetMacro(ComputeSecondDistance, vtkTypeBool);
  vtkBooleanMacro(ComputeSecondDistance, vtkTypeBool);
  ///@}

  /** Output 1: the Tool, with its distances if ComputeSecondDistance is on. */
  vtkPolyData* GetSecondDistanceOutput() { return this->GetOutput(1); }

  ///@{
  /** What the sign is told by: VTK_PSEUDONORMAL, the default, or VTK_WINDING_NUMBER. */
  vtkSetClampMacro(SignMethod, int, VTK_PSEUDONORMAL, VTK_WINDING_NUMBER);
  vtkGetMacro(SignMethod, int);
  void SetSignMethodToPseudonormal() { this->SetSignMethod(VTK_PSEUDONORMAL); }
  void SetSignMethodToWindingNumber() { this->SetSignMethod(VTK_WINDING_NUMBER); }
  ///@}

  ///@{
  /**
   * Points farther from the surface than this get this distance and no nearest cell. In the unit of
   * the points; 0, the default, for no limit. Saves time where SignedDistance is off, and outside
   * of the box of a closed surface.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /** Whether cells get an array `Distance`, too. Off by default. */
  vtkSetMacro(ComputeCellCenterDistance, vtkTypeBool);
  vtkGetMacro(ComputeCellCenterDistance, vtkTypeBool);
  vtkBooleanMacro(ComputeCellCenterDistance, vtkTypeBool);
  ///@}

  ///@{
  /** Whether to add the array `NearestPoint`. Off by default. */
  vtkSetMacro(ComputeNearestPoint, vtkTypeBool);
  vtkGetMacro(ComputeNearestPoint, vtkTypeBool);
  vtkBooleanMacro(ComputeNearestPoint, vtkTypeBool);
  ///@}

  ///@{
  /** Whether to add the array `NearestCellId`. Off by default. */
  vtkSetMacro(ComputeNearestCellId, vtkTypeBool);
  vtkGetMacro(ComputeNearestCellId, vtkTypeBool);
  vtkBooleanMacro(ComputeNearestCellId, vtkTypeBool);
  ///@}

  ///@{
  /** Whether to add the array `Direction`. Off by default. */
  vtkSetMacro(ComputeDirection, vtkTypeBool);
  vtkGetMacro(ComputeDirection, vtkTypeBool);
  vtkBooleanMacro(ComputeDirection, vtkTypeBool);
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
  ///@}

  ///@{
  /**
   * The processes that share the data; by default those of ParaView's server. All of them have to
   * update the filter. Null: the filter works for this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  int ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkPolyDataDistance();
  ~vtkPolyDataDistance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataDistance(const vtkPolyDataDistance&) = delete;
  void operator=(const vtkPolyDataDistance&) = delete;

  class Run;
  struct Cache;

  vtkTypeBool SignedDistance = 1;
  vtkTypeBool NegateDistance = 0;
  vtkTypeBool ComputeSecondDistance = 0;
  int SignMethod = VTK_PSEUDONORMAL;
  double MaximumDistance = 0.0;
  vtkTypeBool ComputeCellCenterDistance = 0;
  vtkTypeBool ComputeNearestPoint = 0;
  vtkTypeBool ComputeNearestCellId = 0;
  vtkTypeBool ComputeDirection = 0;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Kept;
};

#endif
