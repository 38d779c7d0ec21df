// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolyDataClipClosedSurface
 * @brief   Clips a closed surface by planes, and closes it again with caps.
 *
 * After D. Gobbi's vtkClipClosedSurface ("VTK/Closed Surface Clipping", VTK wiki, 2010), with the
 * same options, and computed exactly: a closed manifold surface gives a closed manifold surface, by
 * the ids of its points (vtkFeatureEdges finds no boundary and no non-manifold edge), also where
 * planes go through vertices, along edges or in faces. Kept is what lies where the normals of all
 * planes point, from each plane on.
 *
 * The planes are, in this order: the plane of SetOrigin and SetNormal (if UsePlane is on), those of
 * SetPlane, those of the collection ClippingPlanes, and the six sides of the box (if UseBox is on;
 * xmin, xmax, ymin, ymax, zmin, zmax). ActivePlaneId and SourceId count them so.
 *
 * Several surfaces in one input are several solids; one that is inside out is a hole in the one
 * around it, and a solid of its own, inside out, if there is none around it. Where an open surface
 * is cut, its contours are joined along the hull of all contours in the plane, counter-clockwise
 * and shortest first; what cannot be joined gets no cap, and a warning counts it.
 *
 * Output 0 is the surface: polygons that no plane touches as they are, parts of cut ones and caps
 * as triangles; lines only if GenerateOutline is on. Its points are floats where the input's are,
 * else doubles. Point arrays are passed if PassPointData is on; cell arrays are passed (NaN, 0 or
 * an empty text on caps). Cell arrays of its own:
 * - `SourceId` (int): 0 for the input's cells, the number of the plane plus one on caps and
 *   outlines;
 * - `OriginalCellId` (vtkIdType): the cell of the input, -1 on caps and outlines;
 * - `Colors` (3 unsigned chars) or `Labels` (unsigned char), as ScalarMode says.
 *
 * Output 1 are the lines alone: where planes cut the surface and each other, and the input's lines
 * as far as they are kept. Vertex cells are ignored.
 *
 * Field data of output 0, after that of the input: `Status` (int; 0 is Ok, see StatusType and
 * sb::Status), `Message` (the sentence for it), `OpenContourCount`, `CapArea` (a value a plane,
 * unit squared), `StageNames` and `StageSeconds`.
 *
 * @par Cost
 * Some nanoseconds for each triangle, and about a microsecond for each one that a plane cuts. The
 * same input gives the same bytes whatever NumberOfThreads is.
 */
#ifndef vtkPolyDataClipClosedSurface_h
#define vtkPolyDataClipClosedSurface_h

#include "sbClippingModule.h" // for the export macro
#include "vtkSmartPointer.h" // for the planes
#include "vtkWholePolyDataAlgorithm.h"

#include <array> // for the table of planes
#include <memory> // for std::unique_ptr
#include <vector> // for the table of planes

class vtkPlaneCollection;

class SBCLIPPING_EXPORT vtkPolyDataClipClosedSurface : public vtkWholePolyDataAlgorithm
{
public:
  static vtkPolyDataClipClosedSurface* New();
  vtkTypeMacro(vtkPolyDataClipClosedSurface, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ScalarModeType
  {
    NONE = 0,
    COLORS,
    LABELS
  };

  /** Values of the field array `Status` beside those of the kernel (sb::Status in
   * Filters/Kernel/Boolean.h, 0 to 10). */
  enum StatusType
  {
    NOT_A_SURFACE = 20, ///< error: the input is no polygonal surface
    OUT_OF_MEMORY = 22, ///< error: the result does not fit into memory
    OPEN_CONTOURS = 24 ///< warning: the surface is open where it was cut
  };

  ///@{
  /** Planes to clip by, beside those of the other methods. None by default. */
  virtual void SetClippingPlanes(vtkPlaneCollection* planes);
  virtual vtkPlaneCollection* GetClippingPlanes();
  ///@}

  ///@{
  /** Whether to clip by the plane of SetOrigin and SetNormal. Off by default. */
  vtkSetMacro(UsePlane, vtkTypeBool);
  vtkGetMacro(UsePlane, vtkTypeBool);
  vtkBooleanMacro(UsePlane, vtkTypeBool);
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /** A table of further planes: origin and normal (of any length but 0) of each. A row of six zeros
   * is none. */
  void SetNumberOfPlanes(int number);
  int GetNumberOfPlanes() const { return static_cast<int>(this->Planes.size()); }
  void SetPlane(int index, double originX, double originY, double originZ, double normalX,
    double normalY, double normalZ);
  void AddPlane(
    double originX, double originY, double originZ, double normalX, double normalY, double normalZ);
  void RemoveAllPlanes() { this->SetNumberOfPlanes(0); }
  ///@}

  ///@{
  /** Whether to clip by the six sides of Box (xmin, xmax, ymin, ymax, zmin, zmax), of which the
   * inside is kept. Off by default. */
  vtkSetMacro(UseBox, vtkTypeBool);
  vtkGetMacro(UseBox, vtkTypeBool);
  vtkBooleanMacro(UseBox, vtkTypeBool);
  vtkSetVector6Macro(Box, double);
  vtkGetVector6Macro(Box, double);
  ///@}

  ///@{
  /** Keep what is not in front of all planes instead. Off by default. */
  vtkSetMacro(InsideOut, vtkTypeBool);
  vtkGetMacro(InsideOut, vtkTypeBool);
  vtkBooleanMacro(InsideOut, vtkTypeBool);
  ///@}

  ///@{
  /**
   * How far a point may be moved, in the unit of the points, before the exact computation starts;
   * zero or more. Closes cracks far smaller than it. It never loosens a comparison. 0 by default.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Whether the output has polygons. On by default; off leaves the outlines alone. */
  vtkSetMacro(GenerateFaces, vtkTypeBool);
  vtkGetMacro(GenerateFaces, vtkTypeBool);
  vtkBooleanMacro(GenerateFaces, vtkTypeBool);
  ///@}

  ///@{
  /** Whether to make lines: the outlines of all caps, and the input's lines, clipped. Off by
   * default. */
  vtkSetMacro(GenerateOutline, vtkTypeBool);
  vtkGetMacro(GenerateOutline, vtkTypeBool);
  vtkBooleanMacro(GenerateOutline, vtkTypeBool);
  ///@}

  ///@{
  /** Whether the point arrays of the input are passed, and interpolated at new points. Off by
   * default: normals of the surface would shade the rims of caps. */
  vtkSetMacro(PassPointData, vtkTypeBool);
  vtkGetMacro(PassPointData, vtkTypeBool);
  vtkBooleanMacro(PassPointData, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Cell scalars that tell caps from the rest: None (the default); Colors, an array `Colors` of
   * three bytes; Labels, an array `Labels` with 0 for the input's cells, 1 for caps and outlines, 2
   * for those of the active plane.
   */
  vtkSetClampMacro(ScalarMode, int, NONE, LABELS);
  vtkGetMacro(ScalarMode, int);
  void SetScalarModeToNone() { this->SetScalarMode(NONE); }
  void SetScalarModeToColors() { this->SetScalarMode(COLORS); }
  void SetScalarModeToLabels() { this->SetScalarMode(LABELS); }
  const char* GetScalarModeAsString();
  ///@}

  ///@{
  /** Colour of the input's cells where ScalarMode is Colors, each component from 0 to 1. Not used
   * if the input has cell scalars of three bytes: these are kept. Red by default. */
  vtkSetVector3Macro(BaseColor, double);
  vtkGetVector3Macro(BaseColor, double);
  ///@}

  ///@{
  /** Colour of caps and outlines where ScalarMode is Colors. Orange by default. */
  vtkSetVector3Macro(ClipColor, double);
  vtkGetVector3Macro(ClipColor, double);
  ///@}

  ///@{
  /** The plane whose caps get ActivePlaneColor; -1, the default, for none. */
  vtkSetMacro(ActivePlaneId, int);
  vtkGetMacro(ActivePlaneId, int);
  ///@}

  ///@{
  /** Colour of caps and outlines of the active plane. Yellow by default. */
  vtkSetVector3Macro(ActivePlaneColor, double);
  vtkGetVector3Macro(ActivePlaneColor, double);
  ///@}

  ///@{
  /** Number of threads; 0, the default, uses all cores. The result does not depend on it. */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /** Output 1: the lines alone. */
  vtkPolyData* GetOutlineOutput() { return this->GetOutput(1); }

  vtkMTimeType GetMTime() override;

protected:
  vtkPolyDataClipClosedSurface();
  ~vtkPolyDataClipClosedSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPolyDataClipClosedSurface(const vtkPolyDataClipClosedSurface&) = delete;
  void operator=(const vtkPolyDataClipClosedSurface&) = delete;

  class Run;
  struct Cache;

  vtkSmartPointer<vtkPlaneCollection> ClippingPlanes;
  vtkTypeBool UsePlane = 0;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  std::vector<std::array<double, 6>> Planes;
  vtkTypeBool UseBox = 0;
  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  vtkTypeBool InsideOut = 0;
  double Tolerance = 0.0;
  vtkTypeBool GenerateFaces = 1;
  vtkTypeBool GenerateOutline = 0;
  vtkTypeBool PassPointData = 0;
  int ScalarMode = NONE;
  double BaseColor[3] = { 1.0, 0.0, 0.0 };
  double ClipColor[3] = { 1.0, 0.5, 0.0 };
  double ActivePlaneColor[3] = { 1.0, 1.0, 0.0 };
  int ActivePlaneId = -1;
  int NumberOfThreads = 0;
  std::unique_ptr<Cache> Input;
};

#endif
