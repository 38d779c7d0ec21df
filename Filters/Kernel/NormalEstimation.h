// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NormalEstimation.h
 * @brief Normals of a cloud that has none: the plane through the neighbours of each point, and then
 * one side for all.
 *
 * The plane is that of least squares through the nearest neighbours (Hoppe et al. 1992), which
 * leaves the sign open. Signs are spread along a spanning tree over neighbours that begins with the
 * surest pairs. A pair is judged as if the two points lay on a common circle: the second normal,
 * mirrored in the plane half-way between the points, should equal the first (Koenig and Gumhold
 * 2009). That is exact on spheres however coarse the sampling, and across a thin wall it says that
 * the two normals are opposite. A pair of which one lies above the other says little, and comes
 * last. Each connected part is then turned so that it encloses a positive volume; an open one so
 * that it bulges forwards.
 */
#ifndef sb_NormalEstimation_h
#define sb_NormalEstimation_h

#include "PointTree.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct EstimatedNormals
{
  /** Three doubles a point, in the order of the tree; zero where the neighbours lie on a line. */
  std::vector<double> Normals;
  /** 1 where the normal may be wrong: its neighbours do not lie near a plane, or a quarter of them
   * disagree about the side. */
  std::vector<std::uint8_t> Doubtful;
  std::int64_t NumberOfDoubtful = 0;
  std::int64_t NumberOfParts = 0;
  bool Aborted = false;
};

/**
 * Estimate and orient the normals of all points of a tree.
 * @param neighbours that a plane is fitted to, beside the point itself; 8 to 64. More of them
 * smooth more noise, and more of the shape.
 */
EstimatedNormals EstimateNormals(
  const PointTree& tree, int neighbours, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
