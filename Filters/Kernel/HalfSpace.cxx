// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HalfSpace.h"

#include <algorithm>

namespace sb
{

HalfSpace::HalfSpace(const ClipPlane& plane, const Lattice& lattice)
  : Largest{ 0, 0 }
{
  const std::array<double, 3>& n = plane.Normal;
  const double largest = std::max(std::fabs(n[0]), std::max(std::fabs(n[1]), std::fabs(n[2])));
  int binade = 0;
  const double mantissa = std::frexp(largest, &binade);
  // The largest double of a binade would be rounded up to 2^52 itself.
  const int exponent = (mantissa * Lattice::Limit > Lattice::Limit - 1.0 ? 51 : 52) - binade;
  for (int axis = 0; axis < 3; ++axis)
  {
    // In two steps, as the power of two alone may be beyond a double.
    const double scaled = std::ldexp(n[std::size_t(axis)], exponent);
    this->Normal[axis] = std::nearbyint(scaled) + 0.0;
    this->Exact.Normal[axis] = WideInteger<2>(WideInteger<1>::FromIntegral(this->Normal[axis]));
    if (std::fabs(n[std::size_t(axis)]) == largest && this->Largest.Sign == 0)
    {
      this->Largest = { axis, n[std::size_t(axis)] > 0.0 ? 1 : -1 };
    }
  }
  lattice.Quantise(plane.Origin.data(), this->Origin);
  WideInteger<3> offset;
  for (int axis = 0; axis < 3; ++axis)
  {
    offset =
      offset + Multiply(this->Exact.Normal[axis], WideInteger<1>::FromIntegral(this->Origin[axis]));
  }
  this->Exact.Offset = offset;
}

int HalfSpace::ExactSide(const double* q) const
{
  WideInteger<2> height;
  for (int axis = 0; axis < 3; ++axis)
  {
    height = height +
      Multiply(WideInteger<1>::FromIntegral(this->Normal[axis]),
        WideInteger<1>::FromIntegral(q[axis] - this->Origin[axis]));
  }
  return height.Sign();
}

template <int Size>
int HalfSpace::ExactSide(const ExactPoint& point) const
{
  WideInteger<Size + 2> height;
  for (int axis = 0; axis < 3; ++axis)
  {
    height = height +
      WideInteger<Size + 2>(Multiply(point.GetNumerator(axis).template Narrow<Size>(),
        WideInteger<1>::FromIntegral(this->Normal[axis])));
  }
  height = height -
    Multiply(
      point.GetDenominator().template Narrow<Size>(), this->Exact.Offset.template Narrow<2>());
  return height.Sign();
}

int HalfSpace::Side(const ExactPoint& point) const
{
  const double* p = point.Approximation();
  if (point.GetWidth() == 1)
  {
    return this->Side(p);
  }
  // A coordinate is off by half an ulp, its difference rounds, each product passes three roundings
  // more.
  constexpr double unit = 1.0 / 9007199254740992.0;
  double height = 0.0;
  double bound = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double difference = p[axis] - this->Origin[axis];
    height += this->Normal[axis] * difference;
    bound += std::fabs(this->Normal[axis]) * (std::fabs(p[axis]) + 5.0 * std::fabs(difference));
  }
  if (std::fabs(height) > 1.01 * unit * bound)
  {
    return SignOf(height);
  }
  return point.GetWidth() <= 4 ? this->ExactSide<4>(point) : this->ExactSide<6>(point);
}

} // namespace sb
