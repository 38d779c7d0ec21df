// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNURBSReader
 * @brief   Reads STEP and IGES files: facets to look at, and the exact surfaces behind them.
 *
 * Every face becomes a rational B-spline patch, which planes, cylinders, cones, spheres, tori and
 * free forms are without error, and facets on it. Facets of neighbouring faces meet in points of
 * equal coordinates, so solids are watertight; faces that the file does not join (IGES) are sewn as
 * far as they meet. Assemblies come with their parts in place. Solids are oriented outwards.
 * Coordinates are in millimetres, whatever the file's unit.
 *
 * The output has the point arrays `UV`, the parameters in the patch of the point's face, and
 * `Normals`; the cell arrays `FaceId` and `SolidId` (-1: a face of no solid), and, where a STEP
 * file names its products or colours them, `PartId`, a place in the field array `PartNames` (one
 * part for each use of a product; -1: of none), and `PartColor` (red, green, blue; white where the
 * file has none). Faces that had to be sewn have no part. The field arrays `NURBSDegrees`,
 * `NURBSCounts`, `NURBSKnots` and `NURBSPoles` are the patches. Filters of this project take them
 * from there, also after ParaView's Transform. Further field arrays: `Status` (StatusType),
 * `Message`, `Unit`, `NumberOfFaces`, `NumberOfSolids`, `NumberOfApproximatedFaces`, `Closed` (0 or
 * 1), `Volume` and `Area` of the facets, `ChordError`, the largest distance measured between a
 * facet and its patch, `Gap`, the largest between a point and its patch (inside of faces it is
 * zero, on edges as small as the file has joined them), `StageNames` and `StageSeconds`.
 */
#ifndef vtkNURBSReader_h
#define vtkNURBSReader_h

#include "sbCADModule.h" // for the export macro
#include "vtkWholePolyDataAlgorithm.h"

class SBCAD_EXPORT vtkNURBSReader : public vtkWholePolyDataAlgorithm
{
public:
  static vtkNURBSReader* New();
  vtkTypeMacro(vtkNURBSReader, vtkWholePolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Field data `Status`; below 5 there is a result. */
  enum StatusType
  {
    OK = 0,
    OPEN = 2, ///< warning: the facets are not closed
    APPROXIMATED = 3, ///< warning: some faces are not exact, or not within ChordError
    INCOMPLETE = 4, ///< warning: some faces could not be cut into triangles
    ABORTED = 9,
    BAD_REQUEST = 10, ///< a setting cannot be used
    OUT_OF_MEMORY = 22,
    NOT_READABLE = 50, ///< no such file, not of this kind, or damaged
    NO_FACES = 51,
    TOO_MANY_FACETS = 52 ///< ChordError asks for more than ten million
  };

  ///@{
  /** A file that ends in .step, .stp, .iges or .igs. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** How far a facet may be from its face, as a share of the diagonal of the box around all of it;
   * 0.001 by default. Edges never turn by more than half a radian at a corner. */
  vtkSetMacro(ChordError, double);
  vtkGetMacro(ChordError, double);
  ///@}

protected:
  vtkNURBSReader();
  ~vtkNURBSReader() override;

  void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkNURBSReader(const vtkNURBSReader&) = delete;
  void operator=(const vtkNURBSReader&) = delete;

  class Run;

  char* FileName = nullptr;
  double ChordError = 1e-3;
};

#endif
