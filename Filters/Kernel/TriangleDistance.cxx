// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleDistance.h"

#include <algorithm>
#include <array>

namespace sb
{
namespace
{

/** Below this squared sine of the angle at a corner the products of Ericson's tests lose too many
 * digits. */
constexpr double SlenderSine = 0.02;

NearestOnTriangle At(const Vector3& place, Feature where)
{
  return { place, SquaredLength(place), where };
}

/** The nearest point of edge `edge`, from a to b. */
NearestOnTriangle NearestOnEdge(const Vector3& a, const Vector3& b, int edge)
{
  const Vector3 along = b - a;
  const double forward = -Dot(along, a);
  const double backward = Dot(along, b);
  if (!(forward > 0.0))
  {
    return At(a, static_cast<Feature>(edge));
  }
  if (!(backward > 0.0))
  {
    return At(b, static_cast<Feature>((edge + 1) % 3));
  }
  // From the nearer end, so that the rounding of the weight counts least.
  const double both = forward + backward;
  const Vector3 place =
    forward < backward ? a + (forward / both) * along : b - (backward / both) * along;
  return At(place, static_cast<Feature>(3 + edge));
}

/** The foot of the perpendicular on a slender triangle's plane, if it is inside: in a frame along
 * the longest edge. */
bool FootOnSlenderTriangle(const std::array<Vector3, 3>& corners, Vector3& foot)
{
  int base = 0;
  double longest = -1.0;
  for (int edge = 0; edge < 3; ++edge)
  {
    const double length = SquaredLength(
      corners[static_cast<std::size_t>((edge + 1) % 3)] - corners[static_cast<std::size_t>(edge)]);
    if (length > longest)
    {
      longest = length;
      base = edge;
    }
  }
  const Vector3& a = corners[static_cast<std::size_t>(base)];
  const double length = std::sqrt(longest);
  if (!(length > 0.0))
  {
    return false;
  }
  const Vector3 along = (1.0 / length) * (corners[static_cast<std::size_t>((base + 1) % 3)] - a);
  const Vector3 side = corners[static_cast<std::size_t>((base + 2) % 3)] - a;
  const double apexAlong = Dot(side, along);
  const Vector3 rise = side - apexAlong * along;
  const double width = Length(rise);
  if (!(width > 0.0))
  {
    return false;
  }
  const Vector3 across = (1.0 / width) * rise;
  const double s = -Dot(a, along);
  const double t = Dot(-(a + s * along), across); // what is left, so that the length does not count
  if (!(t > 0.0 && s * width > t * apexAlong && (length - s) * width > t * (length - apexAlong)))
  {
    return false;
  }
  foot = a + s * along + t * across;
  return true;
}

NearestOnTriangle NearestOnSlenderTriangle(const std::array<Vector3, 3>& corners)
{
  NearestOnTriangle best = NearestOnEdge(corners[0], corners[1], 0);
  for (int edge = 1; edge < 3; ++edge)
  {
    const NearestOnTriangle other = NearestOnEdge(corners[static_cast<std::size_t>(edge)],
      corners[static_cast<std::size_t>((edge + 1) % 3)], edge);
    if (other.SquaredDistance < best.SquaredDistance)
    {
      best = other;
    }
  }
  Vector3 foot;
  if (FootOnSlenderTriangle(corners, foot) && SquaredLength(foot) < best.SquaredDistance)
  {
    best = At(foot, Feature::Face);
  }
  return best;
}

} // namespace

NearestOnTriangle FindNearestOnTriangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const double abab = Dot(ab, ab);
  const double acac = Dot(ac, ac);
  const double abac = Dot(ab, ac);
  if (!(abab * acac - abac * abac > SlenderSine * std::max(abab, acac) * std::max(abab, acac)))
  {
    return NearestOnSlenderTriangle({ a, b, c });
  }
  const double abA = -Dot(ab, a);
  const double acA = -Dot(ac, a);
  if (abA <= 0.0 && acA <= 0.0)
  {
    return At(a, Feature::Vertex0);
  }
  const double abB = -Dot(ab, b);
  const double acB = -Dot(ac, b);
  if (abB >= 0.0 && acB <= abB)
  {
    return At(b, Feature::Vertex1);
  }
  const double weightC = abA * acB - abB * acA;
  if (weightC <= 0.0 && abA >= 0.0 && abB <= 0.0)
  {
    return NearestOnEdge(a, b, 0);
  }
  const double abC = -Dot(ab, c);
  const double acC = -Dot(ac, c);
  if (acC >= 0.0 && abC <= acC)
  {
    return At(c, Feature::Vertex2);
  }
  const double weightB = abC * acA - abA * acC;
  if (weightB <= 0.0 && acA >= 0.0 && acC <= 0.0)
  {
    return NearestOnEdge(c, a, 2);
  }
  const double weightA = abB * acC - abC * acB;
  if (weightA <= 0.0 && acB >= abB && abC >= acC)
  {
    return NearestOnEdge(b, c, 1);
  }
  if (!(weightA > 0.0 && weightB > 0.0 && weightC > 0.0))
  {
    return NearestOnSlenderTriangle({ a, b, c });
  }
  const Vector3 normal = Cross(ab, ac);
  return At((Dot(normal, a) / Dot(normal, normal)) * normal, Feature::Face);
}

} // namespace sb
