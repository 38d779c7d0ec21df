// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataContourTriangulator
 * @brief   Fills closed contours of one plane with triangles.
 *
 * After D. Gobbi's vtkContourTriangulator ("VTK/Closed Surface Clipping", 2010), by a constrained
 * Delaunay triangulation whose topology is exact: no holes, no overlaps, however the contours lie;
 * near n log n. Contours are line cells, of two points or more, that close where ends have the same
 * coordinates. Filled is what an odd number of contours encloses, so their directions do not
 * matter: a contour within a contour is a hole. No points are added but where contours cross;
 * points along a straight line stay.
 *
 * The output has the input's points and their arrays, and triangles that face where the contours'
 * area does, or upwards if they have no direction in common. Cell arrays: `PolygonId` (vtkIdType),
 * the connected part that a triangle belongs to, and `Nesting` (int), 0 for one that no other
 * encloses, 1 for one in a hole of such a one, and so on.
 *
 * Lines that are part of no closed contour are left out, with a warning that counts them; so are
 * vertex and polygon cells, without. Points off the plane, by more than a thousandth of the
 * contours' size, give a warning: they are filled as seen along the plane's normal.
 *
 * Field data, after that of the input: `Status`, `Message`, `PolygonCount`.
 *
 * Blocks of composite data are filled one by one, and the output has the same blocks; where several
 * processes share them, the output is one surface of all blocks.
 */
#ifndef vtkPolyDataContourTriangulator_h
#define vtkPolyDataContourTriangulator_h

#include "sbClippingModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

class vtkCompositeDataSet;

class SBCLIPPING_EXPORT vtkPolyDataContourTriangulator : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPolyDataContourTriangulator* New();
  vtkTypeMacro(vtkPolyDataContourTriangulator, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of the field array `Status` beside those of the kernel (sb::Status in
   * Filters/Kernel/Boolean.h, 0 to 10). */
  enum StatusType
  {
    NOT_A_SURFACE = 20, ///< error: an input is no polygonal data
    OUT_OF_MEMORY = 22, ///< error: the result does not fit into memory
    OPEN_CONTOURS = 24, ///< warning: lines that are part of no closed contour
    NOT_PLANAR = 25 ///< warning: points off the plane
  };

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkPolyDataContourTriangulator() = default;
  ~vtkPolyDataContourTriangulator() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataContourTriangulator(const vtkPolyDataContourTriangulator&) = delete;
  void operator=(const vtkPolyDataContourTriangulator&) = delete;

  class Run;

  void Fill(vtkDataObject* input, vtkPolyData* output);
  static void Merge(vtkCompositeDataSet* filled, vtkPolyData* output);
};

#endif
