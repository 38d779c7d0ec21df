// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataDistanceField
 * @brief   The signed distance to a surface, sampled on an image around it.
 *
 * The input is a vtkPolyData with polygons or strips, or a composite data set of such, which counts
 * as one surface. The output is a vtkImageData with the point array `Distance` (float, in the unit
 * of the points), its active scalars: negative inside, positive outside, as vtkPolyDataDistance
 * computes it. Its contour at 0 is the surface, at another value a surface offset by that distance.
 *
 * The image covers the surface's box and a margin around it; its spacing is the same along all axes
 * unless Dimensions say otherwise. With a NarrowBand, samples farther away than it have its value
 * with their sign, which takes less time where SignedDistance is off, and outside of the surface's
 * box.
 *
 * Field data: `Status` (int, 0 is Ok; the numbers are those of vtkPolyDataDistance) and `Message`
 * (the sentence for it). An input that cannot be used gives one error message and an empty image.
 *
 * @par Cost
 * One to four microseconds of processor time a sample at a million triangles; 4 bytes a sample, and
 * 110 bytes a triangle of the surface. The same bytes with any number of threads.
 */
#ifndef vtkPolyDataDistanceField_h
#define vtkPolyDataDistanceField_h

#include "sbSurfaceModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for std::unique_ptr

class vtkMultiProcessController;

class SBSURFACE_EXPORT vtkPolyDataDistanceField : public vtkImageAlgorithm
{
public:
  static vtkPolyDataDistanceField* New();
  vtkTypeMacro(vtkPolyDataDistanceField, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SampleByType
  {
    VTK_DIMENSIONS = 0, ///< so many samples along each axis
    VTK_SPACING = 1 ///< so far from one sample to the next
  };

  enum SignMethodType
  {
    VTK_PSEUDONORMAL = 0, ///< the side of the nearest face, edge or vertex
    VTK_WINDING_NUMBER = 1 ///< inside where the surface winds around the point
  };

  ///@{
  /** Whether Dimensions (the default) or Spacing says how fine the image is. */
  vtkSetClampMacro(SampleBy, int, VTK_DIMENSIONS, VTK_SPACING);
  vtkGetMacro(SampleBy, int);
  void SetSampleByToDimensions() { this->SetSampleBy(VTK_DIMENSIONS); }
  void SetSampleByToSpacing() { this->SetSampleBy(VTK_SPACING); }
  ///@}

  ///@{
  /** Samples along x, y and z; at least 2 each, (64, 64, 64) by default. The spacing follows. */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /** Distance between neighbouring samples, in the unit of the points; the dimensions follow. 0,
   * the default, for a hundredth of the longest side. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** How far the image goes beyond the surface's box on each side, as a share of the box's longest
   * side. 0.1 by default. */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /** Samples farther from the surface than this have this distance with their sign. In the unit of
   * the points; 0, the default, measures all. */
  vtkSetMacro(NarrowBand, double);
  vtkGetMacro(NarrowBand, double);
  ///@}

  ///@{
  /** As in vtkPolyDataDistance. */
  vtkSetMacro(SignedDistance, vtkTypeBool);
  vtkGetMacro(SignedDistance, vtkTypeBool);
  vtkBooleanMacro(SignedDistance, vtkTypeBool);
  vtkSetClampMacro(SignMethod, int, VTK_PSEUDONORMAL, VTK_WINDING_NUMBER);
  vtkGetMacro(SignMethod, int);
  void SetSignMethodToPseudonormal() { this->SetSignMethod(VTK_PSEUDONORMAL); }
  void SetSignMethodToWindingNumber() { this->SetSignMethod(VTK_WINDING_NUMBER); }
  vtkSetMacro(NegateDistance, vtkTypeBool);
  vtkGetMacro(NegateDistance, vtkTypeBool);
  vtkBooleanMacro(NegateDistance, vtkTypeBool);
  ///@}

  ///@{
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The processes that share the data; by default those of ParaView's server. All of them have to
   * update the filter. Null: the filter works for this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkPolyDataDistanceField();
  ~vtkPolyDataDistanceField() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataDistanceField(const vtkPolyDataDistanceField&) = delete;
  void operator=(const vtkPolyDataDistanceField&) = delete;

  class Run;
  struct Cache;

  vtkDataObject* WholeInput(vtkInformationVector** inputs);

  int SampleBy = VTK_DIMENSIONS;
  int Dimensions[3] = { 64, 64, 64 };
  double Spacing = 0.0;
  double Margin = 0.1;
  double NarrowBand = 0.0;
  vtkTypeBool SignedDistance = 1;
  int SignMethod = VTK_PSEUDONORMAL;
  vtkTypeBool NegateDistance = 0;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Kept;
};

#endif
