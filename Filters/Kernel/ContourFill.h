// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ContourFill.h
 * @brief Triangles that fill closed contours of one plane, given as segments between points.
 *
 * What is filled is what an odd number of contours encloses, so it does not matter in which
 * direction a contour runs: contours within contours are holes, those within holes are islands. The
 * plane is that of the points, as near as it goes; decisions are made exactly on the points rounded
 * to the lattice and seen along the plane's dominant axis.
 */
#ifndef sb_ContourFill_h
#define sb_ContourFill_h

#include "Boolean.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct ContourFillRequest
{
  const double* Points = nullptr; ///< x0 y0 z0 x1 ...
  std::int64_t NumberOfPoints = 0;
  std::vector<std::array<std::int32_t, 2>> Segments; ///< valid point ids
};

struct ContourFillResult
{
  Status Condition = Status::Ok;
  std::vector<Remark> Remarks; ///< BadCoordinate, TooLarge
  /** Ids of the points, and of Crossings after them; facing where the contours' area does. */
  std::vector<std::array<std::int32_t, 3>> Triangles;
  std::vector<std::int32_t> PolygonOfTriangle;
  std::vector<std::int32_t> Nesting; ///< by polygon: 0 outermost, 1 in a hole of such a one, ...
  std::vector<InterpolatedPoint> Crossings; ///< where contours cross
  std::int64_t OpenSegments = 0; ///< left out, as they are part of no closed contour
  double Deviation = 0.0; ///< greatest distance of a point from the plane
  double Size = 0.0; ///< greatest distance of a point from the first one
};

ContourFillResult FillLines(const ContourFillRequest& request);

} // namespace sb

#endif
