// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Predicates.cxx
 * @brief The predicates on lattice points in integers of fixed width, for what the filters leave
 * undecided.
 */
#include "Predicates.h"

#include "WideInteger.h"

namespace sb
{

namespace
{

using Difference = WideInteger<1>; // 53 bits and a sign

Difference Subtract(const double* b, const double* a, int axis)
{
  return Difference::FromIntegral(b[axis] - a[axis]);
}

/** p_u q_v - p_v q_u: 107 bits and a sign, in 128. */
WideInteger<2> Cross(
  const Difference& pu, const Difference& pv, const Difference& qu, const Difference& qv)
{
  return Multiply(pu, qv) - Multiply(pv, qu);
}

} // namespace

int exact::Orient3D(const double* a, const double* b, const double* c, const double* d)
{
  const Difference p[3] = { Subtract(b, a, 0), Subtract(b, a, 1), Subtract(b, a, 2) };
  const Difference q[3] = { Subtract(c, a, 0), Subtract(c, a, 1), Subtract(c, a, 2) };
  // 162 bits and a sign, in 192.
  WideInteger<3> determinant;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    determinant = determinant + Multiply(Cross(p[u], p[v], q[u], q[v]), Subtract(d, a, axis));
  }
  return determinant.Sign();
}

int exact::Orient2D(const double* a, const double* b, const double* c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return Cross(Subtract(b, a, u), Subtract(b, a, v), Subtract(c, a, u), Subtract(c, a, v)).Sign();
}

DominantNormal exact::ComputeDominantNormal(const double* a, const double* b, const double* c)
{
  const Difference p[3] = { Subtract(b, a, 0), Subtract(b, a, 1), Subtract(b, a, 2) };
  const Difference q[3] = { Subtract(c, a, 0), Subtract(c, a, 1), Subtract(c, a, 2) };
  DominantNormal dominant{ 0, 0 };
  WideInteger<2> largest;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const WideInteger<2> component = Cross(p[u], p[v], q[u], q[v]);
    const WideInteger<2> magnitude = component.Magnitude();
    if (magnitude > largest)
    {
      largest = magnitude;
      dominant = DominantNormal{ axis, component.IsNegative() ? -1 : 1 };
    }
  }
  return dominant;
}

} // namespace sb
