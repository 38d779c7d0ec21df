// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Reference.h
 * @brief What the exact kernel is tested against: integers of any length, and random lattice points
 * of all temperaments.
 */
#ifndef sb_Reference_h
#define sb_Reference_h

#include "WideInteger.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace reference
{

using Integer = boost::multiprecision::cpp_int;
using Vector = std::array<Integer, 3>;
using Point = std::array<double, 3>;

constexpr std::int64_t LatticeLimit = (std::int64_t{ 1 } << 52) - 1;

template <int Size>
Integer ToInteger(const sb::WideInteger<Size>& value)
{
  Integer result = 0;
  for (int i = Size - 1; i >= 0; --i)
  {
    result = (result << 64) + value.GetWord(i);
  }
  return value.IsNegative() ? Integer(result - (Integer(1) << (64 * Size))) : result;
}

inline Integer ToInteger(double integral) { return Integer(static_cast<std::int64_t>(integral)); }

inline Vector ToVector(const double* p)
{
  return { ToInteger(p[0]), ToInteger(p[1]), ToInteger(p[2]) };
}

inline Vector Subtract(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline Integer Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline int Sign(const Integer& value) { return value.sign(); }

/** (b - a) x (c - a). */
inline Vector TriangleNormal(const double* a, const double* b, const double* c)
{
  return Cross(Subtract(ToVector(b), ToVector(a)), Subtract(ToVector(c), ToVector(a)));
}

/** The double nearest to numerator / denominator > 0, ties to even, by long division. */
inline double NearestDouble(const Integer& numerator, const Integer& denominator)
{
  if (numerator == 0)
  {
    return 0.0;
  }
  const Integer magnitude = abs(numerator);
  // A quotient of 60 bits at least; what is left of the division only breaks ties.
  const int lengths = static_cast<int>(msb(magnitude)) - static_cast<int>(msb(denominator));
  const int shift = 60 - lengths;
  const Integer dividend = shift > 0 ? Integer(magnitude << shift) : magnitude;
  const Integer divisor = shift < 0 ? Integer(denominator << -shift) : denominator;
  Integer quotient;
  Integer rest;
  divide_qr(dividend, divisor, quotient, rest);
  const int surplus = static_cast<int>(msb(quotient)) - 52;
  Integer kept = quotient >> surplus;
  const Integer lost = quotient - (kept << surplus);
  const Integer half = Integer(1) << (surplus - 1);
  if (lost > half || (lost == half && (rest != 0 || (kept & 1) != 0)))
  {
    ++kept;
  }
  const double value =
    std::ldexp(static_cast<double>(static_cast<std::int64_t>(kept)), surplus - shift);
  return numerator < 0 ? -value : value;
}

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  std::uint64_t Word() { return this->Engine(); }

  /** Uniform in [low, high]. */
  std::int64_t Between(std::int64_t low, std::int64_t high)
  {
    return low +
      static_cast<std::int64_t>(
        this->Engine() % (static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1));
  }

  /** A lattice coordinate: small, of any size, of few significant bits, or at the very limit. */
  double Coordinate()
  {
    switch (this->Between(0, 4))
    {
      case 0:
        return static_cast<double>(this->Between(-3, 3));
      case 1:
        return std::ldexp(
          static_cast<double>(this->Between(-15, 15)), static_cast<int>(this->Between(0, 48)));
      case 2:
        return static_cast<double>(
          (this->Between(0, 1) * 2 - 1) * (LatticeLimit - this->Between(0, 2)));
      default:
        return static_cast<double>(
          this->Between(-LatticeLimit, LatticeLimit) >> this->Between(0, 50));
    }
  }

  /** A point whose coordinates share one temperament more often than not. */
  Point LatticePoint()
  {
    Point point;
    switch (this->Between(0, 3))
    {
      case 0:
        for (double& x : point)
        {
          x = static_cast<double>(this->Between(-4, 4));
        }
        break;
      case 1:
        for (double& x : point)
        {
          x = static_cast<double>(this->Between(-LatticeLimit, LatticeLimit));
        }
        break;
      case 2:
        for (double& x : point)
        {
          x = static_cast<double>(LatticeLimit - this->Between(0, 1000));
        }
        break;
      default:
        for (double& x : point)
        {
          x = this->Coordinate();
        }
        break;
    }
    return point;
  }

  /** Points of one scale: all of them within `extent` of a centre. */
  template <std::size_t Count>
  std::array<Point, Count> Cluster(std::int64_t extent)
  {
    std::array<std::int64_t, 3> centre;
    for (std::int64_t& x : centre)
    {
      x = this->Between(-(LatticeLimit - extent), LatticeLimit - extent);
    }
    std::array<Point, Count> points;
    for (Point& point : points)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = static_cast<double>(centre[axis] + this->Between(-extent, extent));
      }
    }
    return points;
  }

private:
  std::mt19937_64 Engine;
};

/** a + i (b - a) + j (c - a), or `instead` where that leaves the lattice. */
inline Point Combine(const Point& a, const Point& b, const Point& c, std::int64_t i, std::int64_t j,
  const Point& instead)
{
  Point point;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Integer x = ToInteger(a[axis]) + i * (ToInteger(b[axis]) - ToInteger(a[axis])) +
      j * (ToInteger(c[axis]) - ToInteger(a[axis]));
    if (abs(x) > LatticeLimit)
    {
      return instead;
    }
    point[axis] = static_cast<double>(static_cast<std::int64_t>(x));
  }
  return point;
}

/** The same point one lattice step away along a random axis, or itself at the limit. */
inline Point Nudge(const Point& point, Random& random)
{
  Point result = point;
  double& x = result[random.Between(0, 2)];
  const double moved = x + static_cast<double>(random.Between(0, 1) * 2 - 1);
  x = std::fabs(moved) <= static_cast<double>(LatticeLimit) ? moved : x;
  return result;
}

} // namespace reference

#endif
