// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExactPoint.cxx
 * @brief How created points are made and rounded, and their predicates in integers
 * of fixed width.
 */
#include "ExactPoint.h"

#include <cstring>
#include <limits>
#include <type_traits>

namespace sb
{

static_assert(std::is_trivially_copyable<ExactPoint>::value, "points are moved in bulk");
static_assert(sizeof(ExactPoint) == 224, "the header says so");

namespace
{

using Difference = WideInteger<1>;
using Component = WideInteger<2>; // of a triangle's normal

Difference Subtract(const double* b, const double* a, int axis)
{
  return Difference::FromIntegral(b[axis] - a[axis]);
}

/** (b - a) x (c - a): 107 bits. */
void CrossProduct(const double* a, const double* b, const double* c, Component normal[3])
{
  const Difference p[3] = { Subtract(b, a, 0), Subtract(b, a, 1), Subtract(b, a, 2) };
  const Difference q[3] = { Subtract(c, a, 0), Subtract(c, a, 1), Subtract(c, a, 2) };
  normal[0] = Multiply(p[1], q[2]) - Multiply(p[2], q[1]);
  normal[1] = Multiply(p[2], q[0]) - Multiply(p[0], q[2]);
  normal[2] = Multiply(p[0], q[1]) - Multiply(p[1], q[0]);
}

template <int A, int B>
WideInteger<A + B> Dot(const WideInteger<A> a[3], const WideInteger<B> b[3])
{
  return Multiply(a[0], b[0]) + Multiply(a[1], b[1]) + Multiply(a[2], b[2]);
}

/** 2^exponent within the range of normal doubles. */
double PowerOfTwo(int exponent)
{
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
  double power = 0.0;
  std::memcpy(&power, &bits, sizeof(power));
  return power;
}

/** A positive integer as (High + Low) * 2^Exponent, good to 2^-105 of it; 2^52 <= High < 2^53, 0 <=
 * Low < 1. */
struct DoubleDouble
{
  double High;
  double Low;
  int Exponent;
};

template <int Size>
DoubleDouble LeadingDoubles(const WideInteger<Size>& value)
{
  const LeadingBits bits = value.Leading();
  const std::uint64_t low = ((bits.High & 0x7ff) << 42) | (bits.Low >> 22);
  return DoubleDouble{ static_cast<double>(static_cast<std::int64_t>(bits.High >> 11)),
    static_cast<double>(static_cast<std::int64_t>(low)) / 9007199254740992.0, bits.Exponent + 75 };
}

/** numerator - quotient * denominator, where quotient is their rounded quotient: then it is exact.
 */
double Remainder(double numerator, double quotient, double denominator)
{
#ifdef FP_FAST_FMA
  return std::fma(-quotient, denominator, numerator);
#else
  // T. J. Dekker's product (1971): halves of 26 bits multiply exactly.
  constexpr double splitter = 134217729.0;
  const double scaledA = splitter * quotient;
  const double highA = scaledA - (scaledA - quotient);
  const double lowA = quotient - highA;
  const double scaledB = splitter * denominator;
  const double highB = scaledB - (scaledB - denominator);
  const double lowB = denominator - highB;
  const double product = quotient * denominator;
  const double error = ((highA * highB - product) + highA * lowB + lowA * highB) + lowA * lowB;
  return (numerator - product) - error;
#endif
}

/**
 * Whether numerator / denominator is above (+1), below (-1) or at (0) the midpoint between the
 * positive double `below` times 2^exponent and the next one.
 */
template <int Size>
int CompareWithMidpoint(const WideInteger<Size>& numerator, const WideInteger<Size>& denominator,
  double below, int exponent)
{
  int binade = 0;
  const double mantissa = std::frexp(below, &binade);
  const std::int64_t twice = 2 * static_cast<std::int64_t>(mantissa * 9007199254740992.0) + 1;
  // The midpoint is twice * 2^shift. It is close to the quotient, so each of the two products that
  // are compared is close to the other; the one without the shift, and hence both, fits one more
  // word.
  const int shift = binade + exponent - 54;
  const WideInteger<Size + 1> left = numerator;
  const WideInteger<Size + 1> right = Multiply(denominator, WideInteger<1>(twice));
  return shift >= 0 ? left.Compare(right.ShiftLeft(shift)) : left.ShiftLeft(-shift).Compare(right);
}

/**
 * The double nearest to numerator / denominator, ties to even; denominator > 0, `divisor` its
 * leading doubles. Nothing overflows or becomes subnormal: the quotient is 0 or between 2^-324 and
 * 2^378 in magnitude.
 */
template <int Size>
double RoundedQuotient(const WideInteger<Size>& numerator, const WideInteger<Size>& denominator,
  const DoubleDouble& divisor)
{
  if (numerator.IsZero())
  {
    return 0.0;
  }
  const WideInteger<Size> magnitude = numerator.Magnitude();
  const DoubleDouble dividend = LeadingDoubles(magnitude);
  const double first = dividend.High / divisor.High;
  const double rest =
    (Remainder(dividend.High, first, divisor.High) + dividend.Low) - first * divisor.Low;
  const double second = rest / divisor.High;
  double rounded = first + second;
  const double tail = second - (rounded - first);
  const int exponent = dividend.Exponent - divisor.Exponent;

  // The leading doubles are good to 2^-104 in the quotient; what the above adds to that stays below
  // 2^-101. As in A. Ziv's strategy (1991), the quotient is decided where both ends of that
  // interval round to the same double.
  const double error = rounded * (1.0 / 633825300114114700748351602688.0); // 2^-99
  if (rounded + (tail + error) != rounded || rounded + (tail - error) != rounded)
  {
    const double below = tail > 0.0 ? rounded : std::nextafter(rounded, 0.0);
    const double above = tail > 0.0 ? std::nextafter(rounded, 4.0) : rounded;
    const int side = CompareWithMidpoint(magnitude, denominator, below, exponent);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &below, sizeof(bits));
    const bool up = side > 0 || (side == 0 && (bits & 1) != 0);
    rounded = up ? above : below;
  }
  const double result = rounded * PowerOfTwo(exponent);
  return numerator.IsNegative() ? -result : result;
}

/** The homogeneous coordinates of a projected point, in no more words than it takes. */
template <int Size>
struct Projected
{
  WideInteger<Size> U, V, W;

  Projected(const ExactPoint& point, int axis)
    : U(point.GetNumerator((axis + 1) % 3).template Narrow<Size>())
    , V(point.GetNumerator((axis + 2) % 3).template Narrow<Size>())
    , W(point.GetDenominator().template Narrow<Size>())
  {
  }
};

/**
 * The 3 x 3 determinant of the homogeneous coordinates, which is that of the differences times the
 * denominators: six monomials, 3 + 2 * 215 + 162 = 595 bits of 768 for Size 4, 3 + 2 * 378 + 324 =
 * 1083 bits of 1152 for Size 6.
 */
template <int Size>
int HomogeneousOrient2D(
  const ExactPoint& pointA, const ExactPoint& pointB, const ExactPoint& pointC, int axis)
{
  const Projected<Size> a(pointA, axis);
  const Projected<Size> b(pointB, axis);
  const Projected<Size> c(pointC, axis);
  const auto determinant = Multiply(Multiply(a.U, b.V) - Multiply(b.U, a.V), c.W) +
    Multiply(Multiply(b.U, c.V) - Multiply(c.U, b.V), a.W) +
    Multiply(Multiply(c.U, a.V) - Multiply(a.U, c.V), b.W);
  return determinant.Sign();
}

/** As HomogeneousOrient2D, with s for c: 2 + 2 * 378 + 8 and 2 + 378 + 324 + 60 bits at most, 768
 * of 832. */
template <int Size>
int HomogeneousOrient2DRefined(
  const ExactPoint& pointA, const ExactPoint& pointB, const std::int64_t s[2], int axis)
{
  const Projected<Size> a(pointA, axis);
  const Projected<Size> b(pointB, axis);
  const auto determinant = Multiply(Multiply(a.U, b.V) - Multiply(b.U, a.V), WideInteger<1>(256)) +
    Multiply(Multiply(a.V, b.W) - Multiply(b.V, a.W), WideInteger<1>(s[0])) +
    Multiply(Multiply(b.U, a.W) - Multiply(a.U, b.W), WideInteger<1>(s[1]));
  return determinant.Sign();
}

/** The sign of (b - a)[axis], times both denominators: 378 + 324 + 1 bits of 768. */
template <int Size>
int HomogeneousCompareAlong(const ExactPoint& a, const ExactPoint& b, int axis)
{
  return Multiply(
    b.GetNumerator(axis).template Narrow<Size>(), a.GetDenominator().template Narrow<Size>())
    .Compare(Multiply(
      a.GetNumerator(axis).template Narrow<Size>(), b.GetDenominator().template Narrow<Size>()));
}

/** 256 times the height of a plane at s, as Numerator / Denominator. */
struct Height
{
  WideInteger<3> Numerator; ///< 256 Offset - N_u s_u - N_v s_v: 170 bits
  Component Denominator;

  Height(const double* const corners[3], const std::int64_t s[2], int axis)
  {
    const ExactPlane plane = ExactPlane::Through(corners[0], corners[1], corners[2]);
    this->Numerator = plane.Offset.ShiftLeft(8) -
      Multiply(plane.Normal[(axis + 1) % 3], WideInteger<1>(s[0])) -
      Multiply(plane.Normal[(axis + 2) % 3], WideInteger<1>(s[1]));
    this->Denominator = plane.Normal[axis];
  }
};

} // namespace

ExactPlane ExactPlane::Through(const double* a, const double* b, const double* c)
{
  ExactPlane plane;
  CrossProduct(a, b, c, plane.Normal);
  const WideInteger<1> origin[3] = { WideInteger<1>::FromIntegral(a[0]),
    WideInteger<1>::FromIntegral(a[1]), WideInteger<1>::FromIntegral(a[2]) };
  plane.Offset = Dot(plane.Normal, origin);
  return plane;
}

ExactPlane ExactPlane::Vertical(const double* s, const double* t, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const Difference du = Subtract(t, s, u);
  const Difference dv = Subtract(t, s, v);
  ExactPlane plane;
  plane.Normal[u] = -Component(dv);
  plane.Normal[v] = Component(du);
  plane.Offset =
    Multiply(du, Difference::FromIntegral(s[v])) - Multiply(dv, Difference::FromIntegral(s[u]));
  return plane;
}

ExactPoint::ExactPoint()
  : Approximate{ std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN() }
  , Width(6)
{
}

template <int Size>
ExactPoint ExactPoint::FromHomogeneous(
  const WideInteger<Size> numerator[3], const WideInteger<Size>& denominator)
{
  ExactPoint point;
  if (denominator.IsZero())
  {
    return point;
  }
  const bool negative = denominator.IsNegative();
  const WideInteger<Size> positive = negative ? -denominator : denominator;
  const DoubleDouble divisor = LeadingDoubles(positive);
  for (int axis = 0; axis < 3; ++axis)
  {
    const WideInteger<Size> signedNumerator = negative ? -numerator[axis] : numerator[axis];
    point.Approximate[axis] = RoundedQuotient(signedNumerator, positive, divisor);
    point.Numerator[axis] = signedNumerator;
  }
  point.Denominator = positive;
  point.Width = Size;
  // Lattice points are told exactly by their doubles, at a fraction of the cost: wherever faces are
  // axis-aligned, most points are.
  return point.IsIntegral() ? Vertex(point.Approximate) : point;
}

ExactPoint ExactPoint::Between(const double* u, const double* v, const WideInteger<3>& heightOfU,
  const WideInteger<3>& heightOfV)
{
  WideInteger<4> numerator[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    numerator[axis] = Multiply(heightOfU, WideInteger<1>::FromIntegral(v[axis])) -
      Multiply(heightOfV, WideInteger<1>::FromIntegral(u[axis]));
  }
  return FromHomogeneous<4>(numerator, heightOfU - heightOfV);
}

ExactPoint ExactPoint::Vertex(const double* p)
{
  ExactPoint point;
  for (int axis = 0; axis < 3; ++axis)
  {
    point.Approximate[axis] = p[axis];
    point.Numerator[axis] = WideInteger<6>::FromIntegral(p[axis]);
  }
  point.Denominator = WideInteger<6>(1);
  point.Width = 1;
  return point;
}

ExactPoint ExactPoint::LinePlane(
  const double* u, const double* v, const double* a, const double* b, const double* c)
{
  Component normal[3];
  CrossProduct(a, b, c, normal);
  const Difference fromU[3] = { Subtract(u, a, 0), Subtract(u, a, 1), Subtract(u, a, 2) };
  const Difference fromV[3] = { Subtract(v, a, 0), Subtract(v, a, 1), Subtract(v, a, 2) };
  return Between(u, v, Dot(normal, fromU), Dot(normal, fromV));
}

ExactPoint ExactPoint::LinePlane(const double* u, const double* v, const ExactPlane& plane)
{
  const WideInteger<1> first[3] = { WideInteger<1>::FromIntegral(u[0]),
    WideInteger<1>::FromIntegral(u[1]), WideInteger<1>::FromIntegral(u[2]) };
  const WideInteger<1> second[3] = { WideInteger<1>::FromIntegral(v[0]),
    WideInteger<1>::FromIntegral(v[1]), WideInteger<1>::FromIntegral(v[2]) };
  return Between(
    u, v, Dot(plane.Normal, first) - plane.Offset, Dot(plane.Normal, second) - plane.Offset);
}

ExactPoint ExactPoint::LineLine(
  const double* u, const double* v, const double* s, const double* t, int axis)
{
  const int first = (axis + 1) % 3;
  const int second = (axis + 2) % 3;
  const Difference du = Subtract(t, s, first);
  const Difference dv = Subtract(t, s, second);
  const Component heightOfU =
    Multiply(du, Subtract(u, s, second)) - Multiply(dv, Subtract(u, s, first));
  const Component heightOfV =
    Multiply(du, Subtract(v, s, second)) - Multiply(dv, Subtract(v, s, first));
  return Between(u, v, heightOfU, heightOfV);
}

ExactPoint ExactPoint::ThreePlanes(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r)
{
  // Cramer's rule: x = (p.o (q x r) + q.o (r x p) + r.o (p x q)) / (p . (q x r)).
  WideInteger<4> qr[3];
  WideInteger<4> rp[3];
  WideInteger<4> pq[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    qr[axis] = Multiply(q.Normal[u], r.Normal[v]) - Multiply(q.Normal[v], r.Normal[u]);
    rp[axis] = Multiply(r.Normal[u], p.Normal[v]) - Multiply(r.Normal[v], p.Normal[u]);
    pq[axis] = Multiply(p.Normal[u], q.Normal[v]) - Multiply(p.Normal[v], q.Normal[u]);
  }
  WideInteger<6> numerator[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    // 378 bits and a sign, in 384.
    numerator[axis] =
      (Multiply(p.Offset, qr[axis]) + Multiply(q.Offset, rp[axis]) + Multiply(r.Offset, pq[axis]))
        .Narrow<6>();
  }
  return FromHomogeneous<6>(numerator, Dot(p.Normal, qr));
}

bool ExactPoint::IsIntegral() const
{
  if (!this->Exists())
  {
    return false;
  }
  for (int axis = 0; axis < 3 && this->Width > 1; ++axis)
  {
    const double approximate = this->Approximate[axis];
    if (!(std::fabs(approximate) < 9007199254740992.0)) // off the lattice, far beyond its limit
    {
      return false;
    }
    const std::int64_t integer = static_cast<std::int64_t>(approximate);
    // Below 2^53 every integer is a double, so that an integral coordinate is its own
    // approximation.
    if (static_cast<double>(integer) != approximate ||
      Multiply(this->Denominator, WideInteger<1>(integer)) != WideInteger<7>(this->Numerator[axis]))
    {
      return false;
    }
  }
  return true;
}

int exact::Orient2D(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis)
{
  const int width = std::max(a.GetWidth(), std::max(b.GetWidth(), c.GetWidth()));
  if (width == 1)
  {
    return sb::Orient2D(a.Approximation(), b.Approximation(), c.Approximation(), axis);
  }
  return width <= 4 ? HomogeneousOrient2D<4>(a, b, c, axis) : HomogeneousOrient2D<6>(a, b, c, axis);
}

int exact::Orient2DRefined(
  const ExactPoint& a, const ExactPoint& b, const std::int64_t s[2], int axis)
{
  return std::max(a.GetWidth(), b.GetWidth()) <= 4 ? HomogeneousOrient2DRefined<4>(a, b, s, axis)
                                                   : HomogeneousOrient2DRefined<6>(a, b, s, axis);
}

int exact::CompareAlong(const ExactPoint& a, const ExactPoint& b, int axis)
{
  if (a.GetWidth() == 1 && b.GetWidth() == 1)
  {
    return SignOf(b.Approximation()[axis] - a.Approximation()[axis]);
  }
  return std::max(a.GetWidth(), b.GetWidth()) <= 4 ? HomogeneousCompareAlong<4>(a, b, axis)
                                                   : HomogeneousCompareAlong<6>(a, b, axis);
}

bool exact::SamePoint(const ExactPoint& a, const ExactPoint& b)
{
  // Only lattice points have width 1, and they are what their doubles say.
  if (a.GetWidth() == 1 || b.GetWidth() == 1)
  {
    return a.GetWidth() == b.GetWidth() &&
      std::equal(a.Approximation(), a.Approximation() + 3, b.Approximation());
  }
  return exact::CompareAlong(a, b, 0) == 0 && exact::CompareAlong(a, b, 1) == 0 &&
    exact::CompareAlong(a, b, 2) == 0;
}

int CompareHeights(
  const double* const T[3], const double* const G[3], const std::int64_t s[2], int axis)
{
  const Height ofT(T, s, axis);
  const Height ofG(G, s, axis);
  // Cross multiplication by two denominators of either sign; 277 bits of 320.
  const int comparison =
    Multiply(ofT.Numerator, ofG.Denominator).Compare(Multiply(ofG.Numerator, ofT.Denominator));
  return comparison * ofT.Denominator.Sign() * ofG.Denominator.Sign();
}

int Orient2DRefined(const double* a, const double* b, const std::int64_t s[2], int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  // s - 256 a stays below 2^61, and the cross product below 2^115.
  const Difference su(s[0] - 256 * static_cast<std::int64_t>(a[u]));
  const Difference sv(s[1] - 256 * static_cast<std::int64_t>(a[v]));
  return (Multiply(Subtract(b, a, u), sv) - Multiply(Subtract(b, a, v), su)).Sign();
}

} // namespace sb
