// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceClip.h
 * @brief What is left of one input triangle in front of all planes, and what it adds to the
 * contours of their caps.
 *
 * The triangle is cut by one plane after the other (Sutherland and Hodgman, "Reentrant polygon
 * clipping", 1974) and stays one convex polygon. Sides are exact, and *on the plane counts as
 * behind it*, as if the plane were moved forward by an infinitesimal step: then no case is special,
 * and what is left of a solid has no parts without volume. The one exception is a triangle that
 * lies in the plane and looks backwards: it is the skin of what is kept, and stays.
 *
 * The contour of plane j is the boundary of all that is kept after planes 0 to j, as far as it lies
 * in plane j, turned round: the cap is what has that boundary.
 */
#ifndef sb_FaceClip_h
#define sb_FaceClip_h

#include "ClipPoints.h"
#include "Contour.h"

#include <cstdint>
#include <vector>

namespace sb
{

class FaceClip
{
public:
  struct Corner
  {
    std::int32_t Vertex; ///< input vertex, or -1
    std::int32_t Instance; ///< of ClipPoints, or -1 for a vertex that lies on no plane
  };

  /** @param keepsFacesInPlane false: triangles in a plane are never kept, but left to the cap. */
  explicit FaceClip(ClipPoints& points, bool keepsFacesInPlane = true)
    : Points(points)
    , KeepsFacesInPlane(keepsFacesInPlane)
  {
  }

  /**
   * Clip a triangle.
   * @param contours one a plane; the triangle's segments are appended
   * @return the corners of what is left, in the triangle's orientation; empty if nothing is. Valid
   * until the next call.
   */
  const std::vector<Corner>& Clip(std::int32_t face, std::vector<Contour>& contours);

private:
  int SideOf(const Corner& corner, std::int32_t plane) const;
  bool LooksBackwards(std::int32_t plane) const;
  bool ClipBy(std::int32_t plane, std::vector<Contour>& contours);
  void Cut(std::int32_t plane, Contour& contour);
  Corner Crossing(std::size_t side, std::int32_t plane);
  Carrier CarrierOf(std::int32_t label) const;
  std::int32_t InstanceOf(Corner& corner);

  ClipPoints& Points;
  const bool KeepsFacesInPlane;
  std::int32_t Face = -1;
  std::vector<Corner> Polygon;
  /** By side, from each corner to the next: 0 to 2 for an edge of the triangle, else 3 + plane. */
  std::vector<std::int32_t> Labels;
  std::vector<int> Sides; ///< by corner
  std::vector<Corner> NextPolygon;
  std::vector<std::int32_t> NextLabels;
};

} // namespace sb

#endif
