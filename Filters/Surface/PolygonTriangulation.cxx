// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonTriangulation.h"

#include <algorithm>
#include <cmath>

namespace sbvtk
{
namespace
{

/** The rounded sum of two doubles and what the rounding lost (Knuth's TwoSum). */
void TwoSum(double a, double b, double& sum, double& lost)
{
  sum = a + b;
  const double bRounded = sum - a;
  lost = (a - (sum - bRounded)) + (b - bRounded);
}

/**
 * Sign of the exact sum of `terms`: each is added to an expansion of non-overlapping doubles,
 * smallest first, whose sign is that of its largest non-zero component (Shewchuk 1997,
 * grow-expansion).
 */
template <std::size_t Size>
int SignOfSum(const std::array<double, Size>& terms)
{
  std::array<double, Size> expansion{};
  for (std::size_t used = 0; used < Size; ++used)
  {
    double carry = terms[used];
    for (std::size_t i = 0; i < used; ++i)
    {
      double lost;
      TwoSum(carry, expansion[i], carry, lost);
      expansion[i] = lost;
    }
    expansion[used] = carry;
  }
  for (std::size_t i = Size; i-- > 0;)
  {
    if (expansion[i] != 0.0)
    {
      return expansion[i] > 0.0 ? 1 : -1;
    }
  }
  return 0;
}

/** Sign of the doubled area of (a, b, c), exact unless a product under- or overflows. */
int ExactTurn(double au, double av, double bu, double bv, double cu, double cv)
{
  // au bv - au cv - cu bv - av bu + av cu + cv bu, each product as its rounded value and its rest.
  const std::array<std::array<double, 2>, 6> factors{ { { au, bv }, { -au, cv }, { -cu, bv },
    { -av, bu }, { av, cu }, { cv, bu } } };
  std::array<double, 12> terms;
  for (std::size_t i = 0; i < factors.size(); ++i)
  {
    const double product = factors[i][0] * factors[i][1];
    terms[2 * i] = std::fma(factors[i][0], factors[i][1], -product);
    terms[2 * i + 1] = product;
  }
  return SignOfSum(terms);
}

} // namespace

int PolygonTriangulation::Turn(std::int32_t a, std::int32_t b, std::int32_t c) const
{
  const Point2& pa = this->Flat[a];
  const Point2& pb = this->Flat[b];
  const Point2& pc = this->Flat[c];
  const double left = (pa.U - pc.U) * (pb.V - pc.V);
  const double right = (pa.V - pc.V) * (pb.U - pc.U);
  const double area = left - right;
  // Shewchuk's bound for the first stage of orient2d: (3 + 16 eps) eps with eps = 2^-53.
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right));
  if (std::abs(area) > bound)
  {
    return area > 0.0 ? 1 : -1;
  }
  return ExactTurn(pa.U, pa.V, pb.U, pb.V, pc.U, pc.V);
}

double PolygonTriangulation::SquaredLength(std::int32_t a, std::int32_t b) const
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double difference = this->Solid[a][axis] - this->Solid[b][axis];
    sum += difference * difference;
  }
  return sum;
}

void PolygonTriangulation::Emit(std::int32_t a, std::int32_t b, std::int32_t c)
{
  this->Triangles.push_back({ a, b, c });
}

const std::vector<std::array<std::int32_t, 3>>& PolygonTriangulation::Cut(
  const double* points, const std::vector<std::int32_t>& corners)
{
  this->Triangles.clear();
  if (corners.size() == 3)
  {
    this->Emit(0, 1, 2);
    return this->Triangles;
  }
  if (!this->Project(points, corners))
  {
    // No area, or a coordinate that is no number: any triangulation is as good as another.
    for (std::int32_t i = 2; i < static_cast<std::int32_t>(corners.size()); ++i)
    {
      this->Emit(0, i - 1, i);
    }
    return this->Triangles;
  }
  if (!(corners.size() == 4 && this->CutQuadrilateral()) && !this->CutConvex())
  {
    this->ClipEars();
  }
  return this->Triangles;
}

/** Look along the axis in which the polygon's area is largest, so that it turns counter-clockwise.
 */
bool PolygonTriangulation::Project(const double* points, const std::vector<std::int32_t>& corners)
{
  const std::size_t size = corners.size();
  this->Solid.resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const double* point = points + 3 * static_cast<std::int64_t>(corners[i]);
    this->Solid[i] = { point[0], point[1], point[2] };
  }
  std::array<double, 3> area{};
  const std::array<double, 3>& origin = this->Solid[0];
  for (std::size_t i = 1; i + 1 < size; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      area[axis] += (this->Solid[i][u] - origin[u]) * (this->Solid[i + 1][v] - origin[v]) -
        (this->Solid[i][v] - origin[v]) * (this->Solid[i + 1][u] - origin[u]);
    }
  }
  int axis = 0;
  for (int other = 1; other < 3; ++other)
  {
    axis = std::abs(area[other]) > std::abs(area[axis]) ? other : axis;
  }
  if (!(std::abs(area[axis]) > 0.0) || !std::isfinite(area[axis]))
  {
    return false;
  }
  const int u = (axis + (area[axis] > 0.0 ? 1 : 2)) % 3;
  const int v = (axis + (area[axis] > 0.0 ? 2 : 1)) % 3;
  this->Flat.resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    this->Flat[i] = { this->Solid[i][u], this->Solid[i][v] };
  }
  return true;
}

/** The shorter of the diagonals that leave two proper triangles; of equal ones that of the smallest
 * corner. */
bool PolygonTriangulation::CutQuadrilateral()
{
  const bool first = this->Turn(0, 1, 2) > 0 && this->Turn(0, 2, 3) > 0;
  const bool second = this->Turn(0, 1, 3) > 0 && this->Turn(1, 2, 3) > 0;
  if (!first && !second)
  {
    return false;
  }
  bool takeFirst = first;
  if (first && second)
  {
    const double firstLength = this->SquaredLength(0, 2);
    const double secondLength = this->SquaredLength(1, 3);
    takeFirst = firstLength < secondLength;
    if (firstLength == secondLength)
    {
      const auto smallest = std::min_element(this->Solid.begin(), this->Solid.end());
      takeFirst = (smallest - this->Solid.begin()) % 2 == 0;
    }
  }
  if (takeFirst)
  {
    this->Emit(0, 1, 2);
    this->Emit(0, 2, 3);
  }
  else
  {
    this->Emit(0, 1, 3);
    this->Emit(1, 2, 3);
  }
  return true;
}

/** A fan, if the polygon is strictly convex and goes round once. */
bool PolygonTriangulation::CutConvex()
{
  const std::int32_t size = static_cast<std::int32_t>(this->Flat.size());
  for (std::int32_t i = 0; i < size; ++i)
  {
    if (this->Turn(i, (i + 1) % size, (i + 2) % size) <= 0)
    {
      return false;
    }
  }
  // A star-shaped polygon that goes round twice turns left everywhere too, but not as seen from its
  // first corner.
  for (std::int32_t i = 2; i < size; ++i)
  {
    if (this->Turn(0, i - 1, i) <= 0)
    {
      return false;
    }
  }
  for (std::int32_t i = 2; i < size; ++i)
  {
    this->Emit(0, i - 1, i);
  }
  return true;
}

/** No other corner lies in or on the triangle; corners at the place of one of its own do not count.
 */
bool PolygonTriangulation::IsEar(std::int32_t before, std::int32_t corner, std::int32_t after) const
{
  if (this->Turn(before, corner, after) <= 0)
  {
    return false;
  }
  const auto samePlace = [this](std::int32_t a, std::int32_t b) {
    return this->Flat[a].U == this->Flat[b].U && this->Flat[a].V == this->Flat[b].V;
  };
  for (std::int32_t i = this->Next[after]; i != before; i = this->Next[i])
  {
    if (samePlace(i, before) || samePlace(i, corner) || samePlace(i, after))
    {
      continue;
    }
    if (this->Turn(before, corner, i) >= 0 && this->Turn(corner, after, i) >= 0 &&
      this->Turn(after, before, i) >= 0)
    {
      return false;
    }
  }
  return true;
}

void PolygonTriangulation::ClipEars()
{
  const std::int32_t size = static_cast<std::int32_t>(this->Flat.size());
  this->Next.resize(size);
  this->Previous.resize(size);
  for (std::int32_t i = 0; i < size; ++i)
  {
    this->Next[i] = (i + 1) % size;
    this->Previous[i] = (i + size - 1) % size;
  }
  std::int32_t corner = 0;
  std::int32_t passedSinceCut = 0;
  for (std::int32_t left = size; left > 2;)
  {
    const std::int32_t before = this->Previous[corner];
    const std::int32_t after = this->Next[corner];
    // A whole round without an ear: the polygon crosses itself. Cutting anywhere ends the work.
    if (!this->IsEar(before, corner, after) && passedSinceCut < left)
    {
      ++passedSinceCut;
      corner = after;
      continue;
    }
    this->Emit(before, corner, after);
    this->Next[before] = after;
    this->Previous[after] = before;
    corner = after;
    passedSinceCut = 0;
    --left;
  }
}

} // namespace sbvtk
