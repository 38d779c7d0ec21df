// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSetIntersectionFilter
 * @brief   The curves in which a plane meets the surface of a cloud of points, without meshing it.
 *
 * After P. Yang, X. Qian: "Direct Boolean intersection between acquired and designed geometry",
 * Computer-Aided Design, 2009, section 4.2. The input is any vtkPointSet, or a composite data set
 * of them; vtkMovingLeastSquaresSurface describes its surface. All loops that are wider than two
 * spacings are found, and the open branches of open scans. Steps along a curve are as long as its
 * curvature allows for ChordError, which is then measured.
 *
 * Output 0 are the curves, one polyline each, with the inside of the surface on their left as seen
 * from where the plane's normal points. Point arrays: `Normals`, those of the surface, and
 * `Curvature`, that of the curve (Eq. 8), positive where it bends to the front of the surface. Cell
 * arrays: `Length`, `Closed` (0 or 1) and `ChordError`, the largest that was measured. Field data:
 * `Status` (vtkPointSetSurfaceFilter::StatusType), `Message`, `Spacing`, `Width`, `StageNames` and
 * `StageSeconds`.
 */
#ifndef vtkPointSetIntersectionFilter_h
#define vtkPointSetIntersectionFilter_h

#include "sbPointSetModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the plane

class vtkPlane;

class SBPOINTSET_EXPORT vtkPointSetIntersectionFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSetIntersectionFilter* New();
  vtkTypeMacro(vtkPointSetIntersectionFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The plane to cut with. */
  void SetPlane(vtkPlane* plane);
  vtkPlane* GetPlane();
  ///@}

  ///@{
  /** How far the curve may be from a segment of the polyline, in the unit of the points; 0, the
   * default, takes a tenth of the spacing. */
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
  /** The scale factor h, in the unit of the points; 0, the default, takes three spacings, more
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
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPointSetIntersectionFilter(const vtkPointSetIntersectionFilter&) = delete;
  void operator=(const vtkPointSetIntersectionFilter&) = delete;

  class Run;

  vtkSmartPointer<vtkPlane> Plane;
  double ChordError = 0.0;
  int Definition = 0;
  double Width = 0.0;
  vtkTypeBool FlipNormals = 0;
  int NumberOfThreads = 0;
};

#endif
