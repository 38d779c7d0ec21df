// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Predicates.h
 * @brief Exact signs of determinants of lattice points: which side, which turn, which axis.
 *
 * All coordinates are integral doubles below 2^52 in magnitude (Lattice.h). A difference of two is
 * thus below 2^53 and exact in a double, so that a filter has to bound the rounding of products and
 * sums alone (J. R. Shewchuk: "Adaptive precision floating-point arithmetic and fast robust
 * geometric predicates", 1997, section 4, there with rounded differences). With u = 2^-53, each of
 * the six monomials of the 3 x 3 determinant passes at most five roundings: its two products, the
 * minor's subtraction, and two additions. The error is therefore at most ((1 + u)^5 - 1) P, where P
 * is the sum of the monomials' magnitudes. Where a filter cannot decide, integers of fixed width
 * do.
 */
#ifndef sb_Predicates_h
#define sb_Predicates_h

#include <algorithm>
#include <cmath>

namespace sb
{

struct DominantNormal
{
  int Axis; ///< 0, 1 or 2
  int Sign; ///< of the normal's component along Axis; 0 if and only if the triangle is collinear
};

namespace exact
{
/** The predicates of the same names without a filter. */
int Orient3D(const double* a, const double* b, const double* c, const double* d);
int Orient2D(const double* a, const double* b, const double* c, int axis);
DominantNormal ComputeDominantNormal(const double* a, const double* b, const double* c);
} // namespace exact

/** -1, 0 or +1. */
inline int SignOf(double value)
{
  return static_cast<int>(value > 0.0) - static_cast<int>(value < 0.0);
}

/**
 * The sign of ((b - a) x (c - a)) . (d - a): +1 if d lies on the side to which the right-hand
 * normal of abc points, 0 if the four points are coplanar.
 */
inline int Orient3D(const double* a, const double* b, const double* c, const double* d)
{
  const double px = b[0] - a[0], py = b[1] - a[1], pz = b[2] - a[2];
  const double qx = c[0] - a[0], qy = c[1] - a[1], qz = c[2] - a[2];
  const double rx = d[0] - a[0], ry = d[1] - a[1], rz = d[2] - a[2];
  const double pyqz = py * qz, pzqy = pz * qy;
  const double pzqx = pz * qx, pxqz = px * qz;
  const double pxqy = px * qy, pyqx = py * qx;
  const double determinant = rx * (pyqz - pzqy) + ry * (pzqx - pxqz) + rz * (pxqy - pyqx);

  // Static bound: P < 6 * 2^159 always, and 5.0001 u * 6 * 2^159 < 2^111.
  constexpr double certain = 2596148429267413814265248164610048.0;
  if (determinant > certain || determinant < -certain)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  // With the P of these differences; 6 u instead of 5 u covers the second order and the rounding of
  // P itself.
  const double permanent = std::fabs(rx) * (std::fabs(pyqz) + std::fabs(pzqy)) +
    std::fabs(ry) * (std::fabs(pzqx) + std::fabs(pxqz)) +
    std::fabs(rz) * (std::fabs(pxqy) + std::fabs(pyqx));
  constexpr double sixRoundings = 6.0 / 9007199254740992.0;
  if (std::fabs(determinant) > sixRoundings * permanent || permanent == 0.0)
  {
    return SignOf(
      determinant); // a zero P has zero monomials only: points in one plane across an axis
  }
  return exact::Orient3D(a, b, c, d);
}

/**
 * The sign of (b - a) x (c - a) in the projection that drops `axis`: u = coordinate (axis + 1) % 3,
 * v = coordinate (axis + 2) % 3; +1 if a, b, c turn left there, 0 if their projections are
 * collinear.
 */
inline int Orient2D(const double* a, const double* b, const double* c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double left = (b[u] - a[u]) * (c[v] - a[v]);
  const double right = (b[v] - a[v]) * (c[u] - a[u]);
  // Rounding is monotone: where the rounded products differ, the exact ones differ the same way.
  // And a rounded product of integers is zero only if the exact one is.
  if (left != right)
  {
    return left > right ? 1 : -1;
  }
  if (left == 0.0)
  {
    return 0;
  }
  return exact::Orient2D(a, b, c, axis);
}

/** The axis of the exactly largest |component| of (b - a) x (c - a), the lowest of equals, and that
 * component's sign. */
inline DominantNormal ComputeDominantNormal(const double* a, const double* b, const double* c)
{
  const double p[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double q[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const double normal[3] = { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
    p[0] * q[1] - p[1] * q[0] };
  const double size[3] = { std::fabs(normal[0]), std::fabs(normal[1]), std::fabs(normal[2]) };
  int axis = size[1] > size[0] ? 1 : 0;
  axis = size[2] > size[axis] ? 2 : axis;
  // A component passes two roundings of values up to |p| |q|, in the maximum norm: it is off by
  // less than 5 u |p| |q|. Two components that differ by more than twice that are told apart.
  const double norms = std::max(std::fabs(p[0]), std::max(std::fabs(p[1]), std::fabs(p[2]))) *
    std::max(std::fabs(q[0]), std::max(std::fabs(q[1]), std::fabs(q[2])));
  constexpr double tenRoundings = 10.0 / 9007199254740992.0;
  const double second = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
  if (size[axis] - second > tenRoundings * norms)
  {
    return DominantNormal{ axis, normal[axis] > 0.0 ? 1 : -1 };
  }
  return exact::ComputeDominantNormal(a, b, c);
}

} // namespace sb

#endif
