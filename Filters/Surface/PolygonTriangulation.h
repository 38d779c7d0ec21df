// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonTriangulation.h
 * @brief Cuts one polygon into triangles over its own corners.
 */
#ifndef PolygonTriangulation_h
#define PolygonTriangulation_h

#include <array>
#include <cstdint>
#include <vector>

namespace sbvtk
{

/**
 * Triangulates polygons, keeping its working memory from one to the next.
 *
 * The polygon is looked at along the axis in which its area is largest, where the orientation of
 * three corners is decided exactly. A quadrilateral is cut along its shorter diagonal (as
 * vtkTriangleFilter does), a convex polygon as a fan, any other by ear clipping (Meisters 1975),
 * which is right for every polygon that does not cross itself in that projection. Corners on a
 * straight line and corners that repeat are allowed. A polygon that crosses itself, or that has no
 * area, still gives its number of corners minus two triangles.
 */
class PolygonTriangulation
{
public:
  /**
   * Cut one polygon.
   * @param points x0 y0 z0 x1 ..., indexed by the corners
   * @param corners point ids of the polygon, at least three, all valid
   * @return number of corners - 2 triangles, as positions in `corners`, oriented as the polygon.
   * Valid until the next call.
   */
  const std::vector<std::array<std::int32_t, 3>>& Cut(
    const double* points, const std::vector<std::int32_t>& corners);

private:
  struct Point2
  {
    double U;
    double V;
  };

  bool Project(const double* points, const std::vector<std::int32_t>& corners);
  bool CutQuadrilateral();
  bool CutConvex();
  void ClipEars();
  bool IsEar(std::int32_t before, std::int32_t corner, std::int32_t after) const;
  void Emit(std::int32_t a, std::int32_t b, std::int32_t c);
  int Turn(std::int32_t a, std::int32_t b, std::int32_t c) const;
  double SquaredLength(std::int32_t a, std::int32_t b) const;

  std::vector<Point2> Flat; // counter-clockwise
  std::vector<std::array<double, 3>> Solid;
  std::vector<std::int32_t> Next;
  std::vector<std::int32_t> Previous;
  std::vector<std::array<std::int32_t, 3>> Triangles;
};

} // namespace sbvtk

#endif
