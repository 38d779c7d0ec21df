// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestExactOrientation.cxx
 * @brief The side of a triangle against rational arithmetic, at points in its plane and one unit of
 * the last place off it.
 */
#include "Rational.h" // first: it silences a false warning

#include "Check.h"
#include "ExactOrientation.h"

#include <cmath>
#include <random>

namespace
{

using rational::Number;
using sb::Vector3;

int RationalSide(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p)
{
  const auto differ = [](const Vector3& q, const Vector3& r, Number* out) {
    out[0] = Number(q.X) - Number(r.X);
    out[1] = Number(q.Y) - Number(r.Y);
    out[2] = Number(q.Z) - Number(r.Z);
  };
  Number u[3];
  Number v[3];
  Number w[3];
  differ(b, a, u);
  differ(c, a, v);
  differ(p, a, w);
  const Number height = w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
    w[2] * (u[0] * v[1] - u[1] * v[0]);
  return height.sign();
}

double Nudged(double value, int steps)
{
  steps = value == 0.0 ? 0 : steps; // its neighbours' products underflow
  for (; steps > 0; --steps)
  {
    value = std::nextafter(value, 1e300);
  }
  for (; steps < 0; ++steps)
  {
    value = std::nextafter(value, -1e300);
  }
  return value;
}

void TestPointsNearThePlane()
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::uniform_int_distribution<int> few(-2, 2);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i)
  {
    // On every other round coordinates of few bits, so that many points lie in the plane.
    const double grid = i % 2 == 0 ? 0x1p-3 : 0x1p-50;
    const auto point = [&] {
      const double scale = std::ldexp(1.0, (i % 5) * 8 - 16);
      return Vector3{ std::round(any(random) / grid) * grid * scale,
        std::round(any(random) / grid) * grid, std::round(any(random) / grid) * grid };
    };
    const Vector3 a = point();
    const Vector3 b = point();
    const Vector3 c = point();
    const double s = any(random);
    const double t = any(random);
    Vector3 p = a + s * (b - a) + t * (c - a);
    p = { Nudged(p.X, few(random)), Nudged(p.Y, few(random)), Nudged(p.Z, few(random)) };
    p = i % 7 == 0 ? 0.5 * (a + b) : p;
    const int side = sb::SideOfTriangle(a, b, c, p);
    CHECK_EQUAL(side, RationalSide(a, b, c, p));
    CHECK_EQUAL(sb::SideOfTriangle(b, a, c, p), -side);
    CHECK_EQUAL(sb::SideOfTriangle(b, c, a, p), side);
    zeros += side == 0;
  }
  CHECK(zeros > 1000);
}

void TestTheFrontIsWhereCornersTurnLeft()
{
  const Vector3 a{ 0, 0, 0 };
  const Vector3 b{ 1, 0, 0 };
  const Vector3 c{ 0, 1, 0 };
  CHECK_EQUAL(sb::SideOfTriangle(a, b, c, { 0.2, 0.2, 1e-300 }), 1);
  CHECK_EQUAL(sb::SideOfTriangle(a, b, c, { 7.0, -9.0, -1e-300 }), -1);
  CHECK_EQUAL(sb::SideOfTriangle(a, b, c, { 1e9, 1e-9, 0.0 }), 0);
}

} // namespace

int main()
{
  TestPointsNearThePlane();
  TestTheFrontIsWhereCornersTurnLeft();
  return check::Verdict("TestExactOrientation");
}
