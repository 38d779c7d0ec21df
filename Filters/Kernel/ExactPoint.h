// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExactPoint.h
 * @brief Points that are created where surfaces cross, held as exact rationals, and the predicates
 * on them.
 *
 * A point is X/W, Y/W, Z/W in lattice units with integers X, Y, Z and W > 0. Nothing is rounded, so
 * it does not matter by which construction a point is reached: equal points compare equal and round
 * to the same doubles. The bits needed, with lattice coordinates of B = 52 bits (magnitudes; a sign
 * comes on top):
 *
 * | value                                | bits                                   |
 * | ------------------------------------ | -------------------------------------- |
 * | difference of coordinates            | B + 1 = 53                             |
 * | component of a triangle's normal     | 2 (B + 1) + 1 = 107                    |
 * | offset of its plane                  | 107 + B + 2 = 161                      |
 * | LinePlane: W                         | 107 + (B + 1) + 2 = 162                |
 * | LinePlane: X                         | 162 + B + 1 = 215                      |
 * | LineLine: W, X                       | 107, 160                               |
 * | ThreePlanes: W                       | 3 * 107 + 3 = 324                      |
 * | ThreePlanes: X                       | 2 * 107 + 161 + 3 = 378                |
 */
#ifndef sb_ExactPoint_h
#define sb_ExactPoint_h

#include "Predicates.h"
#include "WideInteger.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sb
{

/** The points p with Normal . p = Offset; in front of it Normal . p > Offset. */
struct ExactPlane
{
  WideInteger<2> Normal[3]; ///< components below 2^107
  WideInteger<3> Offset; ///< below 2^161

  /** The plane of a triangle, its front where the right-hand normal points. */
  static ExactPlane Through(const double* a, const double* b, const double* c);

  /** The plane of line st that is parallel to `axis`; front: Orient2D(s, t, p, axis) > 0. */
  static ExactPlane Vertical(const double* s, const double* t, int axis);
};

/** Trivially copyable, 224 bytes. A default-constructed one is no point: it is NaN, NaN, NaN. */
class ExactPoint
{
public:
  ExactPoint();

  /** A lattice point. */
  static ExactPoint Vertex(const double* p);

  /** Where the line uv meets the plane of the triangle abc; they must not be parallel. */
  static ExactPoint LinePlane(
    const double* u, const double* v, const double* a, const double* b, const double* c);

  /** Where the line uv meets a plane; they must not be parallel. */
  static ExactPoint LinePlane(const double* u, const double* v, const ExactPlane& plane);

  /**
   * The point of the line uv where it meets the line st, both in one plane; in the projection that
   * drops `axis` they must not be parallel.
   */
  static ExactPoint LineLine(
    const double* u, const double* v, const double* s, const double* t, int axis);

  /** The one point in three planes. */
  static ExactPoint ThreePlanes(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r);

  /** Whether there is such a point; not, if it was asked for with parallel lines or planes. */
  bool Exists() const { return !this->Denominator.IsZero(); }

  /**
   * In lattice units, shape (3); each coordinate is the double nearest to the exact one, the even
   * one of two, and hence the same however the point was constructed, and monotone in the exact
   * coordinate.
   */
  const double* Approximation() const { return this->Approximate; }

  /** Whether the exact point lies on the lattice; its approximation is then exact. */
  bool IsIntegral() const;

  /** Coordinate = Numerator / Denominator, not always in lowest terms; Denominator > 0, and 1 for a
   * lattice point. */
  const WideInteger<6>& GetNumerator(int axis) const { return this->Numerator[axis]; }
  const WideInteger<6>& GetDenominator() const { return this->Denominator; }

  /** How many words the numerators and the denominator need: 1 (then that is 1), 4 or 6. */
  int GetWidth() const { return this->Width; }

private:
  template <int Size>
  static ExactPoint FromHomogeneous(
    const WideInteger<Size> numerator[3], const WideInteger<Size>& denominator);
  static ExactPoint Between(const double* u, const double* v, const WideInteger<3>& heightOfU,
    const WideInteger<3>& heightOfV);

  double Approximate[3];
  int Width;
  WideInteger<6> Numerator[3];
  WideInteger<6> Denominator;
};

namespace exact
{
/** The predicates of the same names without a filter. */
int Orient2D(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis);
int Orient2DRefined(const ExactPoint& a, const ExactPoint& b, const std::int64_t s[2], int axis);
bool SamePoint(const ExactPoint& a, const ExactPoint& b);
int CompareAlong(const ExactPoint& a, const ExactPoint& b, int axis);
} // namespace exact

namespace filter
{
/** What a filter says when it cannot decide. */
constexpr int Undecided = 2;

/**
 * The sign of (b - a) x (c - a) where each coordinate is known to half an ulp, or Undecided.
 * With u = 2^-53 and |coordinate| <= m, a difference d of two is off by at most 2 u m of the
 * coordinates and u |d| of its own rounding, so by 4 u m at most; 5 u m covers the second order.
 * The product of two differences d and d' is then off by |d| 5 u m' + |d'| 5 u m + 25 u^2 m m' and
 * by its own rounding.
 */
inline int Orient2D(double au, double av, double bu, double bv, double cu, double cv)
{
  constexpr double unit = 1.0 / 9007199254740992.0;
  const double pu = bu - au, pv = bv - av;
  const double qu = cu - au, qv = cv - av;
  const double left = pu * qv;
  const double right = pv * qu;
  const double determinant = left - right;
  const double errorU =
    5.0 * unit * std::max(std::fabs(au), std::max(std::fabs(bu), std::fabs(cu)));
  const double errorV =
    5.0 * unit * std::max(std::fabs(av), std::max(std::fabs(bv), std::fabs(cv)));
  const double bound = (std::fabs(pu) + std::fabs(qu)) * errorV +
    (std::fabs(pv) + std::fabs(qv)) * errorU + 2.0 * errorU * errorV +
    2.0 * unit * (std::fabs(left) + std::fabs(right));
  // The factor covers the rounding of the bound itself.
  if (std::fabs(determinant) > 1.0000001 * bound)
  {
    return determinant > 0.0 ? 1 : -1;
  }
  return Undecided;
}
} // namespace filter

/** As the Orient2D of lattice points. */
inline int Orient2D(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double* pa = a.Approximation();
  const double* pb = b.Approximation();
  const double* pc = c.Approximation();
  const int sign = filter::Orient2D(pa[u], pa[v], pb[u], pb[v], pc[u], pc[v]);
  return sign != filter::Undecided ? sign : exact::Orient2D(a, b, c, axis);
}

/** Whether the two are the same point, exactly. */
inline bool SamePoint(const ExactPoint& a, const ExactPoint& b)
{
  const double* pa = a.Approximation();
  const double* pb = b.Approximation();
  // Correctly rounded coordinates are a function of the exact ones: different ones tell points
  // apart.
  return pa[0] == pb[0] && pa[1] == pb[1] && pa[2] == pb[2] && exact::SamePoint(a, b);
}

/** The sign of (b - a)[axis], exactly. */
inline int CompareAlong(const ExactPoint& a, const ExactPoint& b, int axis)
{
  const double pa = a.Approximation()[axis];
  const double pb = b.Approximation()[axis];
  // Correct rounding is monotone: where the doubles differ, the exact coordinates differ the same
  // way.
  return pa != pb ? (pa < pb ? 1 : -1) : exact::CompareAlong(a, b, axis);
}

/**
 * @name On a refined lattice
 * A ray's foot s may lie between lattice points: it is given in units of 1/256, s = 256 (u, v),
 * below 2^60, in the projection that drops `axis` (u and v as for Orient2D).
 */
///@{

/**
 * The sign of (height of the plane of T) - (height of the plane of G) at s, along +axis. T and G
 * are the three corners of triangles that are not parallel to `axis`.
 */
int CompareHeights(
  const double* const T[3], const double* const G[3], const std::int64_t s[2], int axis);

/** The turn of a, b, s: the sign of (b - a) x (s - a). */
int Orient2DRefined(const double* a, const double* b, const std::int64_t s[2], int axis);

inline int Orient2DRefined(
  const ExactPoint& a, const ExactPoint& b, const std::int64_t s[2], int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double* pa = a.Approximation();
  const double* pb = b.Approximation();
  const double su = static_cast<double>(s[0]) / 256.0;
  const double sv = static_cast<double>(s[1]) / 256.0;
  const int sign = filter::Orient2D(pa[u], pa[v], pb[u], pb[v], su, sv);
  return sign != filter::Undecided ? sign : exact::Orient2DRefined(a, b, s, axis);
}
///@}

} // namespace sb

#endif
