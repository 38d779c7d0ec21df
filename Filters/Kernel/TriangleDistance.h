// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleDistance.h
 * @brief The point of one triangle that is nearest to the origin, and the feature that it lies on.
 *
 * The query is the origin: corners are given relative to it, so that differences of near
 * coordinates are taken once, and exactly. Well-shaped triangles go by the signs of Ericson
 * (Real-Time Collision Detection, 2005, section 5.1.5). Their products lose digits in proportion to
 * the triangle's slenderness, so a slender or degenerate triangle is measured in a frame along its
 * longest edge, in which nothing is amplified, and beside its three edges.
 */
#ifndef sb_TriangleDistance_h
#define sb_TriangleDistance_h

#include "Vector3.h"

#include <cstdint>

namespace sb
{

/** Vertex k is corner k; edge k goes from corner k to the next one. */
enum class Feature : std::uint8_t
{
  Vertex0,
  Vertex1,
  Vertex2,
  Edge0,
  Edge1,
  Edge2,
  Face
};

struct NearestOnTriangle
{
  Vector3 Place; ///< relative to the query
  double SquaredDistance = 0.0;
  Feature Where = Feature::Face;
};

/** The point of the triangle a b c that is nearest to the origin. */
NearestOnTriangle FindNearestOnTriangle(const Vector3& a, const Vector3& b, const Vector3& c);

} // namespace sb

#endif
