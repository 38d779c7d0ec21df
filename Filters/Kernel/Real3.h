// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Real3.h
 * @brief Vectors and matrices of three doubles whose coordinates are numbered, for sums of tensors
 * over them.
 */
#ifndef sb_Real3_h
#define sb_Real3_h

#include <array>
#include <cmath>
#include <cstddef>

namespace sb
{

using Real3 = std::array<double, 3>;

/** Rows of a matrix. */
using Real3x3 = std::array<Real3, 3>;

inline double Dot(const Real3& a, const Real3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Real3 Cross(const Real3& a, const Real3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Real3& a) { return std::sqrt(Dot(a, a)); }

inline Real3 Difference(const Real3& a, const Real3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/** a + factor * b. */
inline Real3 PlusScaled(const Real3& a, double factor, const Real3& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

inline Real3 Scaled(const Real3& a, double factor)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

/** The part of a that is orthogonal to the unit vector n. */
inline Real3 WithoutPartAlong(const Real3& a, const Real3& n)
{
  return PlusScaled(a, -Dot(a, n), n);
}

inline Real3 Times(const Real3x3& m, const Real3& a)
{
  return { Dot(m[0], a), Dot(m[1], a), Dot(m[2], a) };
}

/** The transpose of m, times a. */
inline Real3 TransposeTimes(const Real3x3& m, const Real3& a)
{
  return PlusScaled(PlusScaled(Scaled(m[0], a[0]), a[1], m[1]), a[2], m[2]);
}

/** The unit normal of a triangle, or 0 if it has no area. */
inline Real3 UnitNormalOf(const Real3& a, const Real3& b, const Real3& c)
{
  const Real3 normal = Cross(Difference(b, a), Difference(c, a));
  const double size = Length(normal);
  return size > 0.0 ? Scaled(normal, 1.0 / size) : Real3{};
}

inline bool IsFinite(const Real3& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

} // namespace sb

#endif
