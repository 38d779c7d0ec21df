// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataCutClosedSurface
 * @brief   Filled cross-sections of a closed surface by one plane or by a series of parallel ones.
 *
 * The caps alone of what vtkPolyDataClipClosedSurface would make ("VTK/Closed Surface Clipping",
 * 2010, vtkCutClosedSurface): slices for printing or for comparison with images. Each connected
 * part of a cross-section is a polygon, which may have holes. Solids that overlap are united. A
 * cross-section is what has the solid just in front of its plane.
 *
 * The output has triangles, which face where the normal points, or, with Triangulate off, the
 * outlines of the polygons as closed polylines: first the one around a polygon, counter-clockwise
 * as seen from where the normal points, then those around its holes. Its points are floats where
 * the input's are, else doubles. Cell arrays:
 * - `SourceId` (int): the plane, an index into the offsets;
 * - `Offset` (double): its offset;
 * - `PolygonId` (vtkIdType): the polygon, counted over all planes;
 * - `Area`, `Perimeter` (double): of the whole polygon, without its holes, with the perimeter of
 *   the holes; in the unit of the points;
 * - `Nesting` (int): 0 for a polygon that no other encloses, 1 for one in a hole of such a polygon,
 *   and so on;
 * - `Hole` (unsigned char; outlines only): 1 for the outline of a hole.
 *
 * Point arrays of the input are interpolated if PassPointData is on.
 *
 * Field data, after that of the input: `Status`, `Message`, `OpenContourCount` as in
 * vtkPolyDataClipClosedSurface, `PolygonCount`, `SliceArea` (a value a plane), `StageNames` and
 * `StageSeconds`.
 *
 * @par Cost
 * A search among the planes for each triangle, and about a microsecond for each pair of a triangle
 * and a plane that cuts it.
 */
#ifndef vtkPolyDataCutClosedSurface_h
#define vtkPolyDataCutClosedSurface_h

#include "sbClippingModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <vector> // for the offsets

class SBCLIPPING_EXPORT vtkPolyDataCutClosedSurface : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPolyDataCutClosedSurface* New();
  vtkTypeMacro(vtkPolyDataCutClosedSurface, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** As in vtkPolyDataClipClosedSurface. */
  enum StatusType
  {
    NOT_A_SURFACE = 20,
    OUT_OF_MEMORY = 22,
    OPEN_CONTOURS = 24
  };

  ///@{
  /** A point of the plane of offset 0, and the normal of all planes, of any length but 0. */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /** Where the planes lie: distances along the normal from the origin, in the unit of the points.
   * One plane of offset 0 by default. */
  void SetNumberOfOffsets(int number);
  int GetNumberOfOffsets() const { return static_cast<int>(this->Offsets.size()); }
  void SetOffset(int index, double offset);
  double GetOffset(int index) const;
  /** `number` planes from the first to the last offset, evenly spaced. */
  void GenerateOffsets(int number, double first, double last);
  ///@}

  ///@{
  /** Whether the output has triangles (the default) or outlines. */
  vtkSetMacro(Triangulate, vtkTypeBool);
  vtkGetMacro(Triangulate, vtkTypeBool);
  vtkBooleanMacro(Triangulate, vtkTypeBool);
  ///@}

  ///@{
  /** Whether point arrays of the input are interpolated along the outlines. Off by default. */
  vtkSetMacro(PassPointData, vtkTypeBool);
  vtkGetMacro(PassPointData, vtkTypeBool);
  vtkBooleanMacro(PassPointData, vtkTypeBool);
  ///@}

  ///@{
  /** As in vtkPolyDataClipClosedSurface. 0 by default. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkPolyDataCutClosedSurface();
  ~vtkPolyDataCutClosedSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataCutClosedSurface(const vtkPolyDataCutClosedSurface&) = delete;
  void operator=(const vtkPolyDataCutClosedSurface&) = delete;

  class Run;
  struct Cache;

  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  std::vector<double> Offsets{ 0.0 };
  vtkTypeBool Triangulate = 1;
  vtkTypeBool PassPointData = 0;
  double Tolerance = 0.0;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Input;
};

#endif
