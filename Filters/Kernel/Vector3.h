// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Vector3.h
 * @brief Three doubles with the few operations that measuring needs.
 */
#ifndef sb_Vector3_h
#define sb_Vector3_h

#include <cmath>

namespace sb
{

struct Vector3
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
};

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
inline Vector3 operator-(const Vector3& a) { return { -a.X, -a.Y, -a.Z }; }
inline Vector3 operator*(double factor, const Vector3& a)
{
  return { factor * a.X, factor * a.Y, factor * a.Z };
}
inline double Dot(const Vector3& a, const Vector3& b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
inline double SquaredLength(const Vector3& a) { return Dot(a, a); }
inline double Length(const Vector3& a) { return std::sqrt(Dot(a, a)); }

/** Point `index` of an array x0 y0 z0 x1 ... */
template <class Index>
Vector3 PointAt(const double* points, Index index)
{
  const double* p = points + 3 * static_cast<long long>(index);
  return { p[0], p[1], p[2] };
}

} // namespace sb

#endif
