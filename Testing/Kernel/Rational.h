// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Rational.h
 * @brief Points with rational coordinates, and where they lie on triangles: by definition, not by
 * the kernel's predicates.
 */
#ifndef sb_Rational_h
#define sb_Rational_h

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // inside of boost, where it is not so
#endif

#include "Contacts.h"
#include "ExactPoint.h"
#include "Reference.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace rational
{

using Number = boost::multiprecision::cpp_rational;
using Point = std::array<Number, 3>;
using Triangle = std::array<Point, 3>;

inline Point ToPoint(const double* p)
{
  return { Number(reference::ToInteger(p[0])), Number(reference::ToInteger(p[1])),
    Number(reference::ToInteger(p[2])) };
}

inline Point ToPoint(const sb::ExactPoint& p)
{
  const reference::Integer denominator = reference::ToInteger(p.GetDenominator());
  return { Number(reference::ToInteger(p.GetNumerator(0)), denominator),
    Number(reference::ToInteger(p.GetNumerator(1)), denominator),
    Number(reference::ToInteger(p.GetNumerator(2)), denominator) };
}

inline Point operator-(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline Number Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point Normal(const Triangle& t) { return Cross(t[1] - t[0], t[2] - t[0]); }

/** Where along ab, from 0 at a, the function with these values at the ends is zero. */
inline Point Between(const Point& a, const Point& b, const Number& atA, const Number& atB)
{
  const Number weight = atA / (atA - atB);
  return { a[0] + weight * (b[0] - a[0]), a[1] + weight * (b[1] - a[1]),
    a[2] + weight * (b[2] - a[2]) };
}

/** Positive on the inner side of an edge, in the triangle's plane. */
inline Number InsideEdge(const Triangle& t, std::size_t edge, const Point& p)
{
  return Dot(Normal(t), Cross(t[(edge + 1) % 3] - t[edge], p - t[edge]));
}

constexpr sb::Location Outside = -1;

/** The place of a point on a triangle. */
inline sb::Location Locate(const Triangle& t, const Point& p)
{
  if (Dot(Normal(t), p - t[0]) != 0)
  {
    return Outside;
  }
  std::vector<int> on;
  for (int edge = 0; edge < 3; ++edge)
  {
    const Number side = InsideEdge(t, static_cast<std::size_t>(edge), p);
    if (side < 0)
    {
      return Outside;
    }
    if (side == 0)
    {
      on.push_back(edge);
    }
  }
  if (on.empty())
  {
    return sb::Interior;
  }
  if (on.size() == 1)
  {
    return static_cast<sb::Location>(3 + on[0]);
  }
  // Edge i runs from corner i to the next: edges 0 and 1 meet in corner 1.
  return static_cast<sb::Location>(on[0] == 0 && on[1] == 2 ? 0 : on[1]);
}

inline void Unify(std::vector<Point>& points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

/** The corners of the set that two triangles (with area) have in common: none, a point, a segment's
 * ends, a polygon. */
inline std::vector<Point> Intersection(const Triangle& a, const Triangle& b)
{
  // A convex polygon, or a segment or point, cut down by the half-spaces that make up b.
  std::vector<Point> kept(a.begin(), a.end());
  const auto cut = [&](auto&& height) {
    std::vector<Point> next;
    for (std::size_t i = 0; i < kept.size(); ++i)
    {
      const Point& p = kept[i];
      const Point& q = kept[(i + 1) % kept.size()];
      const Number atP = height(p);
      const Number atQ = height(q);
      if (atP >= 0)
      {
        next.push_back(p);
      }
      if ((atP < 0 && atQ > 0) || (atP > 0 && atQ < 0))
      {
        next.push_back(Between(p, q, atP, atQ));
      }
    }
    kept = next;
  };
  const Point normal = Normal(b);
  cut([&](const Point& p) { return Dot(normal, p - b[0]); });
  cut([&](const Point& p) { return Number(-Dot(normal, p - b[0])); });
  for (std::size_t edge = 0; edge < 3; ++edge)
  {
    cut([&](const Point& p) { return InsideEdge(b, edge, p); });
  }
  Unify(kept);
  // What lies between two others is no corner.
  std::vector<Point> corners;
  for (const Point& p : kept)
  {
    bool between = false;
    for (const Point& q : kept)
    {
      for (const Point& r : kept)
      {
        between = between || (Cross(q - p, r - p) == Point{ 0, 0, 0 } && Dot(q - p, r - p) < 0);
      }
    }
    if (!between)
    {
      corners.push_back(p);
    }
  }
  return corners;
}

} // namespace rational

#endif
