// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSetIntersectionFilter
 * @brief   The curves in which a mesh, a CAD body or a plane meets the surface of a cloud of
 * points, without meshing the cloud.
 *
 * After P. Yang, X. Qian: "Direct Boolean intersection between acquired and designed geometry",
 * Computer-Aided Design, 2009, sections 4.2, 5 and 6. Port 0 ("Input") takes any vtkPointSet, or a
 * composite data set of them; vtkMovingLeastSquaresSurface describes its surface. Port 1 ("Tool",
 * which may be missing) takes a vtkPolyData with polygons, open or closed, or a composite data set
 * of them, which counts as one. Without Tool the plane is used. All loops that are wider than two
 * spacings are found, and the open branches of open scans and open meshes. Steps along a curve are
 * as long as its curvature allows for ChordError, which is then measured.
 *
 * Where the Tool carries exact surfaces (those of a CAD file) these are cut and not the facets:
 * each point lies on the patch and on the cloud's surface to rounding, and has the point arrays
 * `UV`, its parameters in the patch, and `FaceId`, which patch, instead of `OriginalCellId`.
 *
 * Output 0 are the curves, one polyline each, with the inside of the cloud's surface on their left
 * as seen from the front of the Tool, or from where the plane's normal points. Where a curve
 * crosses an edge of the Tool its direction breaks, and it has a point.
 * Point arrays: `Normals`, those of the surface; `Curvature`, that of the curve (Eq. 8), positive
 * where it bends to the front of the surface; with a mesh `OriginalCellId`, the cell of the Tool
 * that the curve enters there.
 * Cell arrays: `Length`; `Closed` (0 or 1); `ChordError`, the largest that was measured; `Ends`
 * (2 components), an EndType for the first and the last point; with a Tool `Tangential`, 1 where
 * the surfaces meet at an angle below 0.1 somewhere on the curve, so that its place is uncertain.
 * Field data: `Status` (vtkPointSetSurfaceFilter::StatusType or one of the values below),
 * `Message`, `Spacing`, `Width`, `StageNames` and `StageSeconds`; `NumberOfTouches`, the places
 * where a plane or a mesh comes closer to the surface than ChordError, or a tenth of the spacing,
 * without crossing it; with a Tool `CoincidentArea`, that of the part of it that lies on the cloud
 * within the cloud's noise, where no curve is drawn.
 *
 * Cost: what is near the cloud of a Tool is refined to the spacing; the rest is passed over once.
 */
#ifndef vtkPointSetIntersectionFilter_h
#define vtkPointSetIntersectionFilter_h

#include "sbPointSetModule.h" // for the export macro
#include "vtkSmartPointer.h" // for the plane
#include "vtkWholePolyDataAlgorithm.h"

#include <memory> // for what is kept of the Tool

class vtkPlane;

namespace sbvtk
{
class DesignedInput;
class PreparedCloud;
}

class SBPOINTSET_EXPORT vtkPointSetIntersectionFilter : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPointSetIntersectionFilter* New();
  vtkTypeMacro(vtkPointSetIntersectionFilter, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What ends a curve, in the array `Ends`. */
  enum EndType
  {
    NO_END = 0, ///< the curve is closed
    TOOL_BORDER = 1, ///< the Tool ends
    SCAN_BORDER = 2, ///< the cloud ends
    COINCIDENT = 3, ///< from here on the Tool lies on the cloud
    JUNCTION = 4 ///< more than two triangles of the Tool share the edge
  };

  /** Values of the field array `Status` besides those of vtkPointSetSurfaceFilter. */
  enum StatusType
  {
    COINCIDENT_AREA = 4, ///< warning: part of the Tool lies on the cloud
    FACETS_ONLY = 5, ///< warning: the Tool carries exact surfaces that could not be used
    TOUCHING = 6, ///< warning: plane or mesh touches the surface without crossing it
    NOT_A_SURFACE = 21 ///< error: the Tool is no polygonal surface
  };

  ///@{
  /** The mesh to cut with, instead of the plane. */
  void SetToolData(vtkDataObject* tool) { this->SetInputDataObject(1, tool); }
  void SetToolConnection(vtkAlgorithmOutput* tool) { this->SetInputConnection(1, tool); }
  void RemoveTool() { this->SetInputConnection(1, nullptr); }
  /** 1 if there is one. */
  int GetHasTool() { return this->GetNumberOfInputConnections(1) > 0 ? 1 : 0; }
  ///@}

  ///@{
  /** The plane to cut with if there is no Tool. */
  void SetPlane(vtkPlane* plane);
  vtkPlane* GetPlane();
  ///@}

  ///@{
  /** How far the curve may be from a segment of the polyline, in the unit of the points; 0, the
   * default, takes a tenth of the spacing; less than 1e-8 spacings counts as that. */
  vtkSetMacro(ChordError, double);
  vtkGetMacro(ChordError, double);
  ///@}

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
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** Also that of the plane. */
  vtkMTimeType GetMTime() override;

protected:
  vtkPointSetIntersectionFilter();
  ~vtkPointSetIntersectionFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPointSetIntersectionFilter(const vtkPointSetIntersectionFilter&) = delete;
  void operator=(const vtkPointSetIntersectionFilter&) = delete;

  class Run;

  vtkSmartPointer<vtkPlane> Plane;
  std::unique_ptr<sbvtk::PreparedCloud> Cloud; ///< kept while the points do not change
  std::unique_ptr<sbvtk::DesignedInput> Tool; ///< kept while its input does not change
  double ChordError = 0.0;
  int Definition = 0;
  double Width = 0.0;
  vtkTypeBool FlipNormals = 0;
  int NumberOfThreads = 0;
};

#endif
