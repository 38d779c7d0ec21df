// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImplicitPolyData
 * @brief   A surface as an implicit function: the signed distance to it.
 *
 * After C. Quammen, C. Weigle, R. M. Taylor II: "Boolean Operations on Surfaces in VTK Without
 * External Libraries", The VTK Journal, 2011, sections 3 and 3.1. The function is the distance to
 * the nearest point of the surface's polygons and strips, negative inside (behind the surface); its
 * gradient is the angle-weighted pseudonormal of the face, edge or vertex that this point lies on,
 * of length one. Every class that takes a vtkImplicitFunction can use it: vtkSampleFunction,
 * vtkCutter, vtkClipPolyData, vtkExtractGeometry.
 *
 * Points at the same place count as one vertex, so split normals make no difference. The sign is
 * right everywhere if the surface is closed. Of an open one it tells the side of the nearest
 * polygon, and beyond the rim that of the rim's own polygons; at edges with more than two polygons
 * it is that of the sum of their normals, unless the surface is closed all the same. See
 * SetSignMethod for a sign by the winding number.
 *
 * Any number of threads may evaluate it at once. It is prepared at the first evaluation, and again
 * after its input has changed.
 *
 * @par Cost
 * Preparing takes about a microsecond of processor time and 110 bytes a triangle, an evaluation one
 * to four microseconds at a million triangles; less near the surface, little more far away.
 */
#ifndef vtkImplicitPolyData_h
#define vtkImplicitPolyData_h

#include "sbSurfaceModule.h" // for the export macro
#include "vtkImplicitFunction.h"

#include <memory> // for std::unique_ptr

class vtkPolyData;

class SBSURFACE_EXPORT vtkImplicitPolyData : public vtkImplicitFunction
{
public:
  static vtkImplicitPolyData* New();
  vtkTypeMacro(vtkImplicitPolyData, vtkImplicitFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SignMethodType
  {
    VTK_PSEUDONORMAL = 0, ///< the side of the nearest face, edge or vertex
    VTK_WINDING_NUMBER = 1 ///< inside where the surface winds around the point
  };

  ///@{
  /** The surface. Without one, or if it has no polygon, a point that is not finite or an id that
   * does not exist, NoValue and NoGradient are returned. */
  void SetInput(vtkPolyData* input);
  vtkPolyData* GetInput();
  ///@}

  ///@{
  /** The value returned where there is no distance. 0 by default. */
  vtkSetMacro(NoValue, double);
  vtkGetMacro(NoValue, double);
  ///@}

  ///@{
  /** The gradient returned where there is no pseudonormal. (0, 0, 1) by default. */
  vtkSetVector3Macro(NoGradient, double);
  vtkGetVector3Macro(NoGradient, double);
  ///@}

  ///@{
  /** Distances of this size or less are returned as 0. In the unit of the points; 0 by default, so
   * that only points on the surface have distance 0. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * What the sign is told by: VTK_PSEUDONORMAL, the default, or VTK_WINDING_NUMBER, which suits
   * surfaces with holes, with contradicting orientations or that run through themselves, and costs
   * several times as much for points within the surface's box.
   */
  vtkSetClampMacro(SignMethod, int, VTK_PSEUDONORMAL, VTK_WINDING_NUMBER);
  vtkGetMacro(SignMethod, int);
  void SetSignMethodToPseudonormal() { this->SetSignMethod(VTK_PSEUDONORMAL); }
  void SetSignMethodToWindingNumber() { this->SetSignMethod(VTK_WINDING_NUMBER); }
  ///@}

  using vtkImplicitFunction::EvaluateFunction;
  /** The signed distance at x. */
  double EvaluateFunction(double x[3]) override;
  /** The signed distances at many points, which is faster than one by one. */
  void EvaluateFunction(vtkDataArray* input, vtkDataArray* output) override;
  /** The pseudonormal at the surface's point nearest to x. */
  void EvaluateGradient(double x[3], double g[3]) override;

  /** The signed distance at x as EvaluateFunction, the nearest point of the surface and its cell;
   * -1 where there is none. */
  double EvaluateFunctionAndGetNearest(const double x[3], double nearest[3], vtkIdType& cell);

  /** Also that of the input. */
  vtkMTimeType GetMTime() override;

protected:
  vtkImplicitPolyData();
  ~vtkImplicitPolyData() override;

private:
  vtkImplicitPolyData(const vtkImplicitPolyData&) = delete;
  void operator=(const vtkImplicitPolyData&) = delete;

  struct Internals;

  double NoValue = 0.0;
  double NoGradient[3] = { 0.0, 0.0, 1.0 };
  double Tolerance = 0.0;
  int SignMethod = VTK_PSEUDONORMAL;
  std::unique_ptr<Internals> Internal;
};

#endif
