// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeFacets.h
 * @brief A shape's faces as patches, and facets on them.
 *
 * Open CASCADE cuts the faces into triangles. Where two faces meet, both get the same points, to
 * the bit; the parameters of each point are then those of the nearest point of its own patch. That
 * is the point itself inside of a face, and on an edge as near as the file has joined the faces.
 * Open CASCADE's bound on the chord is a wish; it is measured on the patches, and facets that do
 * not keep it are cut.
 */
#ifndef ShapeFacets_h
#define ShapeFacets_h

#include "DesignedSurface.h"
#include "Executor.h"

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <vector>

namespace sbvtk
{

struct ShapeFacets
{
  sb::DesignedSurface Surface; ///< triangles point out of solids
  std::vector<double> Normals; ///< of the patches at the points
  std::vector<std::int32_t> SolidOfFace; ///< counted from 0; -1: of none
  std::vector<TopoDS_Shape> Faces; ///< of each patch, where it came from
  std::int64_t NumberOfSolids = 0;
  std::int64_t NumberOfApproximations = 0; ///< faces that no rational B-spline can be
  std::int64_t NumberOfBareFaces = 0; ///< could not be cut into triangles
  double Diagonal = 0.0; ///< of the box
  double LargestGap = 0.0; ///< between a point and its patch
  double LargestChordError = 0.0; ///< between a facet and its patch, at the middles
  bool IsTooFine = false; ///< the bound would take more than the most triangles; nothing is made
};

/**
 * @param chordError the bound, as a share of the diagonal of the shape's box
 */
ShapeFacets MakeShapeFacets(const TopoDS_Shape& shape, double chordError,
  std::int64_t mostTriangles, sb::Executor& executor, sb::Monitor& monitor,
  const Message_ProgressRange& progress);

} // namespace sbvtk

#endif
