// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSetBooleanFilter
 * @brief   Union, intersection and differences of the solid that a scanned cloud encloses with a
 * designed body.
 *
 * After P. Yang, X. Qian: "Direct Boolean intersection between acquired and designed geometry",
 * Computer-Aided Design, 2009. Port 0 is the cloud: any vtkPointSet, or a composite data set of
 * them, as for vtkPointSetSurfaceFilter; its surface is that of vtkMovingLeastSquaresSurface. Port
 * 1 is the tool: a closed surface of polygons, or a designed body whose exact faces travel with it
 * (vtkNURBSReader); composite data are merged.
 *
 * The cloud's surface is meshed, the tool refined where the cloud is near, and the two are joined
 * by the exact Boolean of vtkPolyDataBooleanOperationFilter. The seam, which is then off by the
 * chords of the meshes, is moved onto the cloud's surface and the tool (its exact faces, where they
 * are known) at once, without turning a triangle over.
 *
 * Output 0, the surface, is a triangle mesh. It is closed by point ids if the scan is closed; with
 * exact faces it is closed by coordinates, as each face has its own `UV`. Cell arrays: `SourceId`
 * (0 from the cloud, 1 from the tool), `OriginalCellId` (of the tool; -1 from the cloud), `FaceId`
 * (of the tool, -1 elsewhere; if the tool has it), `Confidence` (0 to 1: how sure it is that the
 * cell belongs to the result; 1 if the scan is closed). Point arrays: `Normals`; `Residual`, the
 * distance from the cloud's surface (NaN where the point is not on it); `SeamPoint`, 1 on the seam;
 * `UV` (if the tool has it; NaN on the cloud); and those of the cloud, from the nearest sample, and
 * of the tool, interpolated. Cells have the tool's cell arrays, too. Where there is no value for an
 * array, it is NaN, or 0 in arrays of integers.
 *
 * Output 1 are the points that are left of the cloud, with their arrays, and those of the seam, one
 * vertex each. `SeamPoint` tells them apart; `OriginalPointId` is -1 on the seam, where the cloud's
 * arrays are those of the nearest sample. `Normals` are the cloud's, and on the seam those of its
 * surface.
 *
 * Output 2 is the seam as polylines, with point arrays `Normals` (of the cloud's surface),
 * `Residual` and `UV`, and cell arrays `Length`, `Closed` (0 or 1) and `ChordError`, the largest
 * that was measured.
 *
 * Field data of output 0: `Status` (int, StatusType), `Message`, `Spacing`, `Width`,
 * `CellSize`; what is known of the error, as lengths: `NoiseError` (of the cloud's surface, from
 * the samples' residuals), `FacetError` (of its triangles), `SeamChordError`, `ToolError` (of the
 * tool's facets against its exact faces), `SeamResidual`, the largest distance of a seam point from
 * the cloud's surface; `ErrorBudget`, the sum of these five; `NumberOfSnappedPoints` and
 * `NumberOfBackedOffPoints` of the seam; `NumberOfFlippedTriangles`; `NumberOfSelfIntersections`
 * near the seam; `NumberOfBorderEdges` (0: watertight); `NumberOfSeamEnds` (0: all of it closed);
 * `NumberOfSpecks`, parts of the cloud too small to be more than noise, which are left out;
 * `Confidence`, the smallest; `CloudVolume`, `ToolVolume`, `ResultVolume`, `ResultArea`;
 * `StageNames` and `StageSeconds`.
 *
 * The cloud's surface and its mesh are kept: they are made again only when the points, their
 * normals or the settings change, so moving the tool takes much less time than the first update.
 *
 * An input that cannot be used gives one error message and empty outputs. The same points in any
 * order give the same surface whatever NumberOfThreads is.
 */
#ifndef vtkPointSetBooleanFilter_h
#define vtkPointSetBooleanFilter_h

#include "sbPointSetModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

#include <memory> // for the cache

class SBPOINTSET_EXPORT vtkPointSetBooleanFilter : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPointSetBooleanFilter* New();
  vtkTypeMacro(vtkPointSetBooleanFilter, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OperationType
  {
    UNION = 0, ///< what is in the cloud's solid or in the tool
    INTERSECTION = 1, ///< what is in both
    DIFFERENCE = 2, ///< the cloud's solid without the tool
    REVERSE_DIFFERENCE = 3 ///< the tool without the cloud's solid
  };

  /** Values of the field array `Status`. Those of vtkPointSetSurfaceFilter mean the same there. */
  enum StatusType
  {
    OK = 0,
    BAD_NORMALS = 1, ///< warning
    TOO_LARGE = 8,
    ABORTED = 9,
    BAD_REQUEST = 10,
    NOT_POINTS = 20, ///< error: Input is no set of points
    NOT_A_SURFACE = 21, ///< error: Tool is no surface, or there is none
    OUT_OF_MEMORY = 22,
    TOO_FEW_POINTS = 30,
    NO_PLANE = 31,
    TOO_FINE = 32, ///< error: the mesh would have too many cells
    NO_SURFACE = 33, ///< error: the cloud's surface has no triangle
    INSIDE_OUT = 34, ///< error: the normals of the cloud do not point outwards
    DOUBTFUL_NORMALS = 35, ///< error: more than a fifth of the estimated normals may be wrong
    OPEN_TOOL = 36, ///< error
    BAD_TOOL = 37, ///< error: Tool has a defect
    NO_OVERLAP = 40, ///< warning: the surfaces do not meet
    OPEN_SCAN = 41, ///< warning: the scan is not closed, and so is the result
    OPEN_SEAM = 42, ///< warning: the border of the scan crosses the tool
    COINCIDENT = 43, ///< warning: the surfaces nearly coincide somewhere
    SEAM_NOT_SNAPPED = 44, ///< warning: a part of the seam is farther off than all else
    INEXACT_TOOL = 45, ///< warning: the tool's exact faces are not used
    TOOL_TURNED = 46 ///< warning: the tool was inside out
  };

  ///@{
  /** OperationType; UNION by default. */
  vtkSetMacro(Operation, int);
  vtkGetMacro(Operation, int);
  void SetOperationToUnion() { this->SetOperation(UNION); }
  void SetOperationToIntersection() { this->SetOperation(INTERSECTION); }
  void SetOperationToDifference() { this->SetOperation(DIFFERENCE); }
  void SetOperationToReverseDifference() { this->SetOperation(REVERSE_DIFFERENCE); }
  ///@}

  ///@{
  /** About the edge of the cloud's triangles, in the unit of the points; 0, the default, takes two
   * spacings. */
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /** The scale factor h, in the unit of the points; 0, the default, takes 3.15 spacings. */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /** Turn all normals over. Off by default. */
  vtkSetMacro(FlipNormals, vtkTypeBool);
  vtkGetMacro(FlipNormals, vtkTypeBool);
  vtkBooleanMacro(FlipNormals, vtkTypeBool);
  ///@}

  ///@{
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** Set the connection of the tool. */
  void SetToolConnection(vtkAlgorithmOutput* connection)
  {
    this->SetInputConnection(1, connection);
  }
  void SetToolData(vtkDataObject* tool) { this->SetInputData(1, tool); }

  /** Output 1: what is left of the cloud, and the points of the seam. */
  vtkPolyData* GetPointsOutput() { return this->GetOutput(1); }

  /** Output 2: the seam. */
  vtkPolyData* GetCurvesOutput() { return this->GetOutput(2); }

protected:
  vtkPointSetBooleanFilter();
  ~vtkPointSetBooleanFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPointSetBooleanFilter(const vtkPointSetBooleanFilter&) = delete;
  void operator=(const vtkPointSetBooleanFilter&) = delete;

  class Run;
  struct Cache;

  int Operation = UNION;
  double CellSize = 0.0;
  double Width = 0.0;
  vtkTypeBool FlipNormals = 0;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Kept;
};

#endif
