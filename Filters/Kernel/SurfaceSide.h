// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSide.h
 * @brief On which side of a surface a point lies, told by the face, edge or vertex nearest to it.
 *
 * The side is that of the angle-weighted pseudonormal (Baerentzen and Aanaes, Signed Distance
 * Computation Using the Angle Weighted Pseudonormal, 2005), found without computing it wherever
 * signs suffice:
 * - nearest to a face: the side of that face, by an exact sign;
 * - nearest to an edge of two faces: behind it if it is behind both faces where they meet convexly,
 * behind either where they meet concavely, by exact signs;
 * - nearest to a vertex: the side of all faces around, if they agree; else that of the sum of their
 * normals, each weighted by its angle.
 *
 * What is left is told as undecided: features with a face that has no area, edges that do not have
 * two faces in opposite directions, vertices whose sum nearly vanishes.
 */
#ifndef sb_SurfaceSide_h
#define sb_SurfaceSide_h

#include "NearestTriangle.h"
#include "VertexFans.h"

namespace sb
{

enum class Side : std::int8_t
{
  Behind = -1,
  On = 0,
  InFront = 1,
  Undecided = 2
};

class SurfaceSide
{
public:
  SurfaceSide(const Surface& surface, const VertexFans& fans)
    : Mesh(surface)
    , Fans(fans)
  {
  }

  Side Find(const Vector3& query, const NearestTriangle::Answer& nearest) const;

  /** The angle-weighted pseudonormal of a triangle's feature, of length one; zero where the normals
   * around cancel, or none of the triangles has an area. */
  Vector3 Pseudonormal(std::int32_t triangle, Feature feature) const;

  /** The side of the pseudonormal, for features that Find leaves undecided; in front if the
   * pseudonormal is zero. */
  Side OfPseudonormal(const NearestTriangle::Answer& nearest) const;

private:
  std::array<std::int32_t, 3> Vertices(std::int32_t triangle) const;
  std::array<Vector3, 3> Corners(std::int32_t triangle) const;
  int SideOf(std::int32_t triangle, const Vector3& point) const;
  Side AtEdge(const Vector3& query, std::int32_t triangle, int edge) const;
  Side AtVertex(const Vector3& query, std::int32_t triangle, int corner) const;
  Vector3 EdgeNormal(std::int32_t triangle, int edge) const;
  Vector3 VertexNormal(std::int32_t triangle, int corner, double& angles, bool& regular) const;

  const Surface& Mesh;
  const VertexFans& Fans;
};

} // namespace sb

#endif
