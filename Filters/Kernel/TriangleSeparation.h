// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleSeparation.h
 * @brief Whether two triangles of a mesh certainly meet in common corners and edges only.
 *
 * Nearly all triangles whose boxes meet are neighbours that do no wrong: a plane through one of the
 * two, or through an edge of one, has the other on its other side. Signs are taken from doubles
 * with an error bound; what they leave open is not certain.
 */
#ifndef sb_TriangleSeparation_h
#define sb_TriangleSeparation_h

#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sb
{

/**
 * A triangle of lattice points and its plane. The normal, from exact differences, gives signs of
 * Orient3D wherever their size is above Error times the offset (the bound of Predicates.h, with the
 * largest of three factors).
 */
struct FlatTriangle
{
  double P[3][3];
  double Normal[3];
  double Error;
  std::int32_t Vertices[3];
  std::int32_t Face;
};

inline void SetPlane(FlatTriangle& triangle)
{
  const double* a = triangle.P[0];
  double p[3];
  double q[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = triangle.P[1][axis] - a[axis];
    q[axis] = triangle.P[2][axis] - a[axis];
  }
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double left = p[(axis + 1) % 3] * q[(axis + 2) % 3];
    const double right = p[(axis + 2) % 3] * q[(axis + 1) % 3];
    triangle.Normal[axis] = left - right;
    largest = std::max(largest, std::fabs(left) + std::fabs(right));
  }
  constexpr double sevenRoundings = 7.0 / 9007199254740992.0;
  triangle.Error = sevenRoundings * largest;
}

/** Which corners of one triangle are corners of another one: bit i for corner i. */
inline unsigned CommonCorners(const FlatTriangle& of, const FlatTriangle& with)
{
  unsigned common = 0;
  for (unsigned i = 0; i < 3; ++i)
  {
    const std::int32_t v = of.Vertices[i];
    common |= static_cast<unsigned>(
                (v == with.Vertices[0]) | (v == with.Vertices[1]) | (v == with.Vertices[2]))
      << i;
  }
  return common;
}

/** Whether all corners of `b` that are not `common` are certainly off a's plane on one side. */
inline bool IsOffPlane(const FlatTriangle& a, const FlatTriangle& b, unsigned common)
{
  int side = 0;
  for (unsigned i = 0; i < 3; ++i)
  {
    if (common >> i & 1u)
    {
      continue;
    }
    const double r[3] = { b.P[i][0] - a.P[0][0], b.P[i][1] - a.P[0][1], b.P[i][2] - a.P[0][2] };
    const double height = r[0] * a.Normal[0] + r[1] * a.Normal[1] + r[2] * a.Normal[2];
    const double reach = std::fabs(r[0]) + std::fabs(r[1]) + std::fabs(r[2]);
    if (!(std::fabs(height) > a.Error * reach))
    {
      return false;
    }
    const int sign = height > 0.0 ? 1 : -1;
    if (sign == -side)
    {
      return false;
    }
    side = sign;
  }
  return true;
}

/**
 * Whether an edge of `a` has `b` beyond it, seen along a's dominant axis: the plane through the
 * edge along that axis then parts the two, but for corners that they have in common.
 */
inline bool IsBeyondEdge(
  const FlatTriangle& a, const FlatTriangle& b, unsigned commonOfA, unsigned commonOfB)
{
  int axis = std::fabs(a.Normal[1]) > std::fabs(a.Normal[0]) ? 1 : 0;
  axis = std::fabs(a.Normal[2]) > std::fabs(a.Normal[axis]) ? 2 : axis;
  const int turn = Orient2D(a.P[0], a.P[1], a.P[2], axis);
  for (unsigned edge = 0; edge < 3 && turn != 0; ++edge)
  {
    const unsigned head = (edge + 1) % 3;
    const unsigned apex = (edge + 2) % 3;
    bool isBeyond = (commonOfA >> apex & 1u) == 0;
    for (unsigned i = 0; i < 3 && isBeyond; ++i)
    {
      isBeyond =
        (commonOfB >> i & 1u) != 0 || Orient2D(a.P[edge], a.P[head], b.P[i], axis) * turn < 0;
    }
    if (isBeyond)
    {
      return true;
    }
  }
  return false;
}

/** Whether two triangles certainly have no more than corners or an edge in common. */
inline bool AreApart(const FlatTriangle& a, const FlatTriangle& b)
{
  const unsigned commonOfB = CommonCorners(b, a);
  const unsigned commonOfA = commonOfB == 0 ? 0 : CommonCorners(a, b);
  if (commonOfB == 7)
  {
    return false; // copies: which of them count, is for others to say
  }
  return IsOffPlane(a, b, commonOfB) || IsOffPlane(b, a, commonOfA) ||
    IsBeyondEdge(a, b, commonOfA, commonOfB) || IsBeyondEdge(b, a, commonOfB, commonOfA);
}

} // namespace sb

#endif
