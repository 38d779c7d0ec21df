// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestReference.h
 * @brief Distances by brute force in long double, which share no code with what they check.
 */
#ifndef sb_NearestReference_h
#define sb_NearestReference_h

#include "Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reference
{

using Real = long double;
using Vector = std::array<Real, 3>;

inline Vector Difference(const shapes::Point& a, const shapes::Point& b)
{
  return { Real(a[0]) - b[0], Real(a[1]) - b[1], Real(a[2]) - b[2] };
}
inline Real Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Real ToSegment(const shapes::Point& a, const shapes::Point& b, const shapes::Point& p)
{
  const Vector along = Difference(b, a);
  const Vector offset = Difference(p, a);
  const Real length = Dot(along, along);
  const Real t = length > 0 ? std::clamp(Dot(offset, along) / length, Real(0), Real(1)) : Real(0);
  const Vector rest{ offset[0] - t * along[0], offset[1] - t * along[1], offset[2] - t * along[2] };
  return std::sqrt(Dot(rest, rest));
}

/** The foot of the perpendicular in a frame along the longest edge: a normal by cross product would
 * lose the digits that a needle's slenderness has. */
inline Real ToInterior(
  const shapes::Point& a, const shapes::Point& b, const shapes::Point& c, const shapes::Point& p)
{
  Vector along = Difference(b, a);
  const Real length = std::sqrt(Dot(along, along));
  Vector rise = Difference(c, a);
  Vector rest = Difference(p, a);
  if (!(length > 0))
  {
    return INFINITY;
  }
  const auto takeOff = [](Vector& from, const Vector& unit) {
    const Real part = Dot(from, unit);
    for (std::size_t i = 0; i < 3; ++i)
    {
      from[i] -= part * unit[i];
    }
    return part;
  };
  const auto normalize = [](Vector& v) {
    const Real size = std::sqrt(Dot(v, v));
    for (Real& coordinate : v)
    {
      coordinate /= size;
    }
    return size;
  };
  normalize(along);
  const Real apex = takeOff(rise, along);
  const Real s = takeOff(rest, along);
  const Real width = normalize(rise);
  if (!(width > 0))
  {
    return INFINITY;
  }
  const Real t = takeOff(rest, rise);
  const bool inside =
    t >= 0 && s * width >= t * apex && (length - s) * width >= t * (length - apex);
  return inside ? std::sqrt(Dot(rest, rest)) : Real(INFINITY);
}

inline Real ToTriangle(
  const shapes::Point& a, const shapes::Point& b, const shapes::Point& c, const shapes::Point& p)
{
  const Real ab = Dot(Difference(b, a), Difference(b, a));
  const Real bc = Dot(Difference(c, b), Difference(c, b));
  const Real ca = Dot(Difference(a, c), Difference(a, c));
  const Real interior = ab >= bc && ab >= ca ? ToInterior(a, b, c, p)
    : bc >= ca                               ? ToInterior(b, c, a, p)
                                             : ToInterior(c, a, b, p);
  return std::min({ interior, ToSegment(a, b, p), ToSegment(b, c, p), ToSegment(c, a, p) });
}

inline Real ToMesh(const shapes::Mesh& mesh, const shapes::Point& p)
{
  Real best = INFINITY;
  for (const shapes::Corners& corners : mesh.Triangles)
  {
    best =
      std::min(best, ToTriangle(mesh.At(corners, 0), mesh.At(corners, 1), mesh.At(corners, 2), p));
  }
  return best;
}

} // namespace reference

#endif
