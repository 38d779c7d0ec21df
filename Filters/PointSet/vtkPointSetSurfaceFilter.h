// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSetSurfaceFilter
 * @brief   The moving-least-squares surface of a cloud of points: the points on it, their normals
 * and curvatures, and on request a mesh.
 *
 * After P. Yang, X. Qian: "Direct Boolean intersection between acquired and designed geometry",
 * Computer-Aided Design, 2009, section 3; vtkMovingLeastSquaresSurface describes the surface. The
 * input is any vtkPointSet, or a composite data set of them, whose points count as one cloud. Its
 * point normals are used if it has any; else normals are estimated from the nearest points (16,
 * and up to 64 as the width grows), and turned so that neighbours agree and each connected part
 * encloses a positive volume (an open part bulges forwards).
 *
 * Output 0 are the points, all of them and in their order, one vertex cell each, with the input's
 * point data and
 * - `Normals`: the unit normal of the surface at the point's place on it;
 * - `Residual`: how far the point was from there, negative behind the surface. NaN where it could
 *   not be projected; such a point stays where it is;
 * - `Validity` (vtkMovingLeastSquaresSurface::ValidityType): 0 on the surface, 1 too few points
 * near it, 2 at the border of an open scan or of a hole, 3 the normals near it cancel each other;
 * - `MaximumCurvature`, `MinimumCurvature`, `MeanCurvature`, `GaussCurvature`, if
 *   ComputeCurvatures is on: positive where the surface bulges forwards;
 * - `DoubtfulNormal`: 1 where the side, or an estimated direction, may be wrong.
 *
 * Output 1 is the mesh, if GenerateSurface is on: triangles whose corners lie on the surface,
 * with `Normals`, and the curvatures if they are computed. The mesh of a closed cloud is closed and
 * free of self-intersections; that of an open scan ends where the scan ends.
 *
 * Field data of output 0: `Status` (int, StatusType), `Message`, `Spacing` (the typical distance of
 * neighbours), `Width` (h), `ResidualRMS`, `DoubtfulShare`, `NumberOfValidPoints`,
 * `NumberOfDuplicates`, `NumberOfBadPoints` (not finite), `NumberWithoutNormal`, `NormalsEstimated`
 * (0 or 1), `NumberOfBorderEdges` of the mesh (0: watertight), `NumberOfSpecks` (pieces of the mesh
 * that were left out, as outliers make them: smaller than three widths), `ThinShare` (of the
 * points, on walls or beside gaps thinner than the width) and `ThinWall` (the median of their
 * thickness), `StageNames` and `StageSeconds`.
 *
 * An input that cannot be used gives one error message and empty outputs. The same points in any
 * order give the same values whatever NumberOfThreads is.
 */
#ifndef vtkPointSetSurfaceFilter_h
#define vtkPointSetSurfaceFilter_h

#include "sbPointSetModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

namespace sbvtk
{
class PreparedCloud;
}

class SBPOINTSET_EXPORT vtkPointSetSurfaceFilter : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPointSetSurfaceFilter* New();
  vtkTypeMacro(vtkPointSetSurfaceFilter, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of the field array `Status`; those from 5 on are errors, with empty outputs. The
   * numbers that vtkPolyDataBooleanOperationFilter has too mean the same there. */
  enum StatusType
  {
    OK = 0,
    BAD_NORMALS = 1, ///< warning: points without a usable normal were left out, or none was usable
    DOUBTFUL_NORMALS = 2, ///< warning: many normals may be wrong, or contradict each other
    INVALID_POINTS = 3, ///< warning: more than a fifth of the points are not on the surface
    THIN_PARTS = 4, ///< warning: some walls or gaps are thinner than the width
    TOO_LARGE = 8,
    ABORTED = 9,
    BAD_REQUEST = 10,
    NOT_POINTS = 20, ///< error: the input is no set of points
    OUT_OF_MEMORY = 22,
    TOO_FEW_POINTS = 30, ///< error: less than six different points
    NO_PLANE = 31, ///< error: all points lie on lines
    TOO_FINE = 32, ///< error: the mesh would have too many cells
    THIN_WALL =
      38, ///< error: more than a fifth of the points lie on walls or gaps that are too thin
    OUT_OF_SCALE = 39 ///< error: the points are less than 1e-60 or more than 1e60 apart
  };

  ///@{
  /** vtkMovingLeastSquaresSurface::DefinitionType: unbiased (0, the default) or Amenta-Kil (1). */
  vtkSetMacro(Definition, int);
  vtkGetMacro(Definition, int);
  void SetDefinitionToUnbiased() { this->SetDefinition(0); }
  void SetDefinitionToAmentaKil() { this->SetDefinition(1); }
  ///@}

  ///@{
  /** The scale factor h, in the unit of the points; 0, the default, takes 3.15 spacings, more
   * where the cloud is sparser than elsewhere, and less where a wall is thin. */
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
  /** Move the points onto the surface. On by default; off, they stay where they are. */
  vtkSetMacro(ProjectPoints, vtkTypeBool);
  vtkGetMacro(ProjectPoints, vtkTypeBool);
  vtkBooleanMacro(ProjectPoints, vtkTypeBool);
  ///@}

  ///@{
  /** Add the curvatures. On by default. */
  vtkSetMacro(ComputeCurvatures, vtkTypeBool);
  vtkGetMacro(ComputeCurvatures, vtkTypeBool);
  vtkBooleanMacro(ComputeCurvatures, vtkTypeBool);
  ///@}

  ///@{
  /** Make the mesh of output 1. Off by default. */
  vtkSetMacro(GenerateSurface, vtkTypeBool);
  vtkGetMacro(GenerateSurface, vtkTypeBool);
  vtkBooleanMacro(GenerateSurface, vtkTypeBool);
  ///@}

  ///@{
  /** About the edge of the mesh's triangles, in the unit of the points; 0, the default, takes two
   * spacings. */
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** Output 1: the mesh. */
  vtkPolyData* GetSurfaceOutput() { return this->GetOutput(1); }

protected:
  vtkPointSetSurfaceFilter();
  ~vtkPointSetSurfaceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPointSetSurfaceFilter(const vtkPointSetSurfaceFilter&) = delete;
  void operator=(const vtkPointSetSurfaceFilter&) = delete;

  class Run;

  std::unique_ptr<sbvtk::PreparedCloud> Cloud; ///< kept while the points do not change
  int Definition = 0;
  double Width = 0.0;
  vtkTypeBool FlipNormals = 0;
  vtkTypeBool ProjectPoints = 1;
  vtkTypeBool ComputeCurvatures = 1;
  vtkTypeBool GenerateSurface = 0;
  double CellSize = 0.0;
  int NumberOfThreads = 0;
};

#endif
