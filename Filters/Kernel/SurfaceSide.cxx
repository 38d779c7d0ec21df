// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSide.h"

#include "ExactOrientation.h"

#include <algorithm>
#include <cmath>

namespace sb
{
namespace
{

/** A triangle whose sine at a corner is smaller has a normal of rounding errors. */
constexpr double FlatSine = 1e-9;
/** A cosine between query and pseudonormal that rounding might have turned. */
constexpr double DoubtfulCosine = 1e-7;
/** Squared distances in the frame that may be rounding errors of zero. */
constexpr double OnSurface = 1e-26;

Vector3 UnitOrZero(const Vector3& a)
{
  const double size = std::max({ std::fabs(a.X), std::fabs(a.Y), std::fabs(a.Z) });
  if (!(size > 0.0))
  {
    return {};
  }
  const Vector3 scaled = (1.0 / size) * a;
  return (1.0 / Length(scaled)) * scaled;
}

/** The angle between two unit vectors; accurate for small ones (Kahan). */
double Angle(const Vector3& u, const Vector3& v)
{
  return 2.0 * std::atan2(Length(u - v), Length(u + v));
}

Side FromSign(int sign) { return static_cast<Side>(sign); }

} // namespace

std::array<std::int32_t, 3> SurfaceSide::Vertices(std::int32_t triangle) const
{
  const std::int32_t* ids = this->Mesh.Triangles + 3 * std::int64_t(triangle);
  return { this->Fans.VertexOf(ids[0]), this->Fans.VertexOf(ids[1]), this->Fans.VertexOf(ids[2]) };
}

std::array<Vector3, 3> SurfaceSide::Corners(std::int32_t triangle) const
{
  const std::int32_t* ids = this->Mesh.Triangles + 3 * std::int64_t(triangle);
  return { PointAt(this->Mesh.Points, ids[0]), PointAt(this->Mesh.Points, ids[1]),
    PointAt(this->Mesh.Points, ids[2]) };
}

int SurfaceSide::SideOf(std::int32_t triangle, const Vector3& point) const
{
  const std::array<Vector3, 3> corners = this->Corners(triangle);
  return SideOfTriangle(corners[0], corners[1], corners[2], point);
}

Side SurfaceSide::Find(const Vector3& query, const NearestTriangle::Answer& nearest) const
{
  if (nearest.SquaredDistance == 0.0)
  {
    return Side::On;
  }
  const int feature = static_cast<int>(nearest.Where);
  if (feature < 3)
  {
    return this->AtVertex(query, nearest.Triangle, feature);
  }
  const Side side = nearest.Where == Feature::Face
    ? FromSign(this->SideOf(nearest.Triangle, query))
    : this->AtEdge(query, nearest.Triangle, feature - 3);
  // A point in the plane of its nearest face, but not on it: the face has no area.
  return side == Side::On && nearest.SquaredDistance > OnSurface ? Side::Undecided : side;
}

/** The wedge of two faces is decided by three signs: which side of it the query has, and whether
 * the edge is convex. */
Side SurfaceSide::AtEdge(const Vector3& query, std::int32_t triangle, int edge) const
{
  const std::array<std::int32_t, 3> own = this->Vertices(triangle);
  const std::int32_t from = own[static_cast<std::size_t>(edge)];
  const std::int32_t to = own[static_cast<std::size_t>((edge + 1) % 3)];
  std::int32_t neighbour = -1;
  int apex = -1;
  for (const std::int32_t other : this->Fans.Around(from))
  {
    const std::array<std::int32_t, 3> corners = this->Vertices(other);
    const auto end = std::find(corners.begin(), corners.end(), to);
    if (other == triangle || end == corners.end())
    {
      continue;
    }
    const int place = static_cast<int>(end - corners.begin());
    if (neighbour >= 0 || corners[static_cast<std::size_t>((place + 1) % 3)] != from)
    {
      return Side::Undecided;
    }
    neighbour = other;
    apex = (place + 2) % 3;
  }
  if (neighbour < 0 || from == to)
  {
    return Side::Undecided;
  }
  const int ofOwn = this->SideOf(triangle, query);
  const int ofNeighbour = this->SideOf(neighbour, query);
  const int fold = this->SideOf(triangle, this->Corners(neighbour)[static_cast<std::size_t>(apex)]);
  if (fold < 0) // convex: behind the wedge is behind both
  {
    return FromSign(std::max(ofOwn, ofNeighbour));
  }
  if (fold > 0)
  {
    return FromSign(std::min(ofOwn, ofNeighbour));
  }
  // One plane; if the faces do not fold back on each other they have the query on the same side.
  return ofOwn != 0 && ofOwn == ofNeighbour ? FromSign(ofOwn) : Side::Undecided;
}

Side SurfaceSide::AtVertex(const Vector3& query, std::int32_t triangle, int corner) const
{
  const std::int32_t vertex = this->Vertices(triangle)[static_cast<std::size_t>(corner)];
  const Vector3 apex = PointAt(this->Mesh.Points, vertex);
  bool allInFront = true;
  bool allBehind = true;
  for (const std::int32_t other : this->Fans.Around(vertex))
  {
    const std::array<Vector3, 3> corners = this->Corners(other);
    const Vector3 u = corners[1] - corners[0];
    const Vector3 v = corners[2] - corners[0];
    const Vector3 normal = Cross(u, v);
    const Vector3 offset = query - apex;
    const double height = Dot(normal, offset);
    const double doubt = 1e-14 * Length(u) * Length(v) * Length(offset);
    allInFront = allInFront && height > doubt;
    allBehind = allBehind && height < -doubt;
  }
  if (allInFront != allBehind)
  {
    return allInFront ? Side::InFront : Side::Behind;
  }
  double angles = 0.0;
  bool regular = true;
  const Vector3 normal = this->VertexNormal(triangle, corner, angles, regular);
  const double cosine = Dot(normal, UnitOrZero(query - apex));
  if (!regular || !(std::fabs(cosine) > DoubtfulCosine * angles))
  {
    return Side::Undecided;
  }
  return cosine > 0.0 ? Side::InFront : Side::Behind;
}

/** The sum over all faces of the edge, however many. */
Vector3 SurfaceSide::EdgeNormal(std::int32_t triangle, int edge) const
{
  const std::array<std::int32_t, 3> own = this->Vertices(triangle);
  const std::int32_t from = own[static_cast<std::size_t>(edge)];
  const std::int32_t to = own[static_cast<std::size_t>((edge + 1) % 3)];
  Vector3 sum;
  for (const std::int32_t other : this->Fans.Around(from))
  {
    const std::array<std::int32_t, 3> corners = this->Vertices(other);
    if (std::find(corners.begin(), corners.end(), to) != corners.end())
    {
      sum = sum + this->Pseudonormal(other, Feature::Face);
    }
  }
  return sum;
}

/** @param angles becomes the sum of all angles. @param regular becomes false if a face around is
 * too thin to have a normal. */
Vector3 SurfaceSide::VertexNormal(
  std::int32_t triangle, int corner, double& angles, bool& regular) const
{
  const std::int32_t vertex = this->Vertices(triangle)[static_cast<std::size_t>(corner)];
  Vector3 sum;
  for (const std::int32_t other : this->Fans.Around(vertex))
  {
    const std::array<std::int32_t, 3> ids = this->Vertices(other);
    const std::array<Vector3, 3> corners = this->Corners(other);
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (ids[k] != vertex)
      {
        continue;
      }
      const Vector3 u = UnitOrZero(corners[(k + 1) % 3] - corners[k]);
      const Vector3 v = UnitOrZero(corners[(k + 2) % 3] - corners[k]);
      const Vector3 normal = Cross(u, v);
      regular = regular && Length(normal) > FlatSine;
      const double angle = Angle(u, v);
      angles += angle;
      sum = sum + angle * UnitOrZero(normal);
    }
  }
  return sum;
}

Vector3 SurfaceSide::Pseudonormal(std::int32_t triangle, Feature feature) const
{
  const int number = static_cast<int>(feature);
  if (feature == Feature::Face)
  {
    const std::array<Vector3, 3> corners = this->Corners(triangle);
    return UnitOrZero(
      Cross(UnitOrZero(corners[1] - corners[0]), UnitOrZero(corners[2] - corners[0])));
  }
  if (number >= 3)
  {
    return UnitOrZero(this->EdgeNormal(triangle, number - 3));
  }
  double angles = 0.0;
  bool regular = true;
  return UnitOrZero(this->VertexNormal(triangle, number, angles, regular));
}

Side SurfaceSide::OfPseudonormal(const NearestTriangle::Answer& nearest) const
{
  const Vector3 normal = this->Pseudonormal(nearest.Triangle, nearest.Where);
  return Dot(normal, nearest.Place) > 0.0 ? Side::Behind : Side::InFront;
}

} // namespace sb
