// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMovingLeastSquaresSurface
 * @brief   The surface of a cloud of points, without a mesh, as an implicit function.
 *
 * After P. Yang, X. Qian: "Direct Boolean intersection between acquired and designed geometry",
 * Computer-Aided Design, 2009, sections 3 and 4.1. The function is zero on the moving-least-squares
 * surface of the points, negative behind it (behind: against the normals) and, near the surface,
 * about the signed distance to it. Value, gradient and Hessian are closed formulas. Every class
 * that takes a vtkImplicitFunction can use it: vtkSampleFunction, vtkCutter, vtkClipPolyData.
 *
 * There are two definitions. That of the paper (Amenta and Kil's energy, Eq. 2 to 5) lies inside of
 * what was sampled by the square of the width times half the mean curvature. The default is without
 * this bias; on points of a sphere it is exact.
 *
 * The normals are the input's point normals; without these they are estimated. Points that are not
 * finite, duplicates and points whose normal has no direction are left out.
 *
 * Where there are less than six points within the reach of the weights (2.2 widths; for the paper's
 * definition 4.5), and for the paper's definition beyond width / sqrt(3) from the surface, the
 * function is not defined. The value is then the distance to the nearest point of the cloud,
 * with the sign of the side that the points there face; IsDefined tells.
 *
 * Any number of threads may evaluate it at once. It is prepared at the first evaluation, and again
 * after its input or its settings have changed.
 *
 * @par Cost
 * Preparing takes about half a microsecond a point, estimated normals some microseconds more; an
 * evaluation takes a few microseconds with the default width, growing with its square.
 */
#ifndef vtkMovingLeastSquaresSurface_h
#define vtkMovingLeastSquaresSurface_h

#include "sbPointSetModule.h" // for the export macro
#include "vtkImplicitFunction.h"

#include <memory> // for std::unique_ptr

class vtkPointSet;
class vtkPoints;

class SBPOINTSET_EXPORT vtkMovingLeastSquaresSurface : public vtkImplicitFunction
{
public:
  static vtkMovingLeastSquaresSurface* New();
  vtkTypeMacro(vtkMovingLeastSquaresSurface, vtkImplicitFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DefinitionType
  {
    VTK_UNBIASED = 0,
    VTK_AMENTA_KIL = 1
  };

  /** What the samples say about a place; the values of the array Validity of
   * vtkPointSetSurfaceFilter. */
  enum ValidityType
  {
    VTK_DEFINED = 0,
    VTK_FAR = 1, ///< too few samples near it
    VTK_BORDER = 2, ///< beyond the border of an open scan or in a hole: the samples lie on one side
    VTK_CONTRADICTING = 3 ///< the normals near it cancel each other
  };

  ///@{
  /** The cloud. Without one, or if it has less than six different points, NoValue and NoGradient
   * are returned. */
  void SetInput(vtkPointSet* input);
  vtkPointSet* GetInput();
  ///@}

  ///@{
  /** Which surface: VTK_UNBIASED, the default, or VTK_AMENTA_KIL, the paper's. */
  vtkSetClampMacro(Definition, int, VTK_UNBIASED, VTK_AMENTA_KIL);
  vtkGetMacro(Definition, int);
  void SetDefinitionToUnbiased() { this->SetDefinition(VTK_UNBIASED); }
  void SetDefinitionToAmentaKil() { this->SetDefinition(VTK_AMENTA_KIL); }
  ///@}

  ///@{
  /**
   * The scale factor h of Eq. 3, in the unit of the points: features smaller than it are smoothed
   * away. 0, the default, takes 3.15 times the spacing of the points, more where the cloud is
   * sparser than elsewhere, and less where a wall is thin.
   */
  vtkSetClampMacro(Width, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /** Turn all normals over, and with them front and back. Off by default. */
  vtkSetMacro(FlipNormals, vtkTypeBool);
  vtkGetMacro(FlipNormals, vtkTypeBool);
  vtkBooleanMacro(FlipNormals, vtkTypeBool);
  ///@}

  ///@{
  /** The value returned where there is none: without input, and at points that are not finite. 0 by
   * default. */
  vtkSetMacro(NoValue, double);
  vtkGetMacro(NoValue, double);
  ///@}

  ///@{
  /** The gradient returned there. (0, 0, 1) by default. */
  vtkSetVector3Macro(NoGradient, double);
  vtkGetVector3Macro(NoGradient, double);
  ///@}

  using vtkImplicitFunction::EvaluateFunction;
  /** The value at x. */
  double EvaluateFunction(double x[3]) override;
  /** The gradient at x, close to but not of length one. */
  void EvaluateGradient(double x[3], double g[3]) override;

  /** The Hessian at x by rows; zeros where the function is not defined. */
  void EvaluateHessian(const double x[3], double hessian[9]);

  /** What the samples say about x: one of ValidityType. */
  int GetValidity(const double x[3]);
  /** Whether that is VTK_DEFINED. */
  bool IsDefined(const double x[3]) { return this->GetValidity(x) == VTK_DEFINED; }

  /**
   * The point of the surface that x is projected to: by the paper's procedure or, for the unbiased
   * definition, by Newton steps along the gradient. No point is moved by more than the width.
   * @return whether there is one; else `projected` is x.
   */
  bool Project(const double x[3], double projected[3]);

  /**
   * All points in which the segment from p1 to p2 meets the surface, in their order (section 4.1).
   * Signs are compared at steps of an eighth of the width, and the least distance between two of
   * equal sign is looked at, so that no pair of points is stepped over where the surface is smooth
   * at that scale. Each is found to the last digits.
   * @return their number.
   */
  int IntersectWithLine(const double p1[3], const double p2[3], vtkPoints* points);

  /**
   * The curvature at x of the section of the surface with the plane through x of this normal (Eq.
   * 8). Positive if the curve bends to the front. 0 where the plane is tangent or the function is
   * not defined.
   */
  double EvaluateSectionCurvature(const double x[3], const double planeNormal[3]);

  /** The principal curvatures of the level set at x, the larger one first: 1 / radius on a sphere
   * whose normals point outwards. */
  void EvaluatePrincipalCurvatures(const double x[3], double curvatures[2]);

  /** The typical distance of neighbouring points; 0 without a surface. */
  double GetSpacing();
  /** The typical width in use: Width, or 3.15 spacings. */
  double GetActualWidth();

  /** Also that of the input. */
  vtkMTimeType GetMTime() override;

protected:
  vtkMovingLeastSquaresSurface();
  ~vtkMovingLeastSquaresSurface() override;

private:
  vtkMovingLeastSquaresSurface(const vtkMovingLeastSquaresSurface&) = delete;
  void operator=(const vtkMovingLeastSquaresSurface&) = delete;

  struct Internals;

  int Definition = VTK_UNBIASED;
  double Width = 0.0;
  vtkTypeBool FlipNormals = 0;
  double NoValue = 0.0;
  double NoGradient[3] = { 0.0, 0.0, 1.0 };
  std::unique_ptr<Internals> Internal;
};

#endif
