// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPatchOutline.cxx
 * @brief Outlines are judged as a comparison of all edges and winding numbers at many places judge
 * them.
 */
#include "Check.h"
#include "PatchOutline.h"
#include "Predicates.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <set>

namespace
{

struct Outline
{
  std::vector<shapes::Point> Places;
  std::vector<sb::OutlineEdge> Edges;
};

bool IsEnclosing(const Outline& outline, sb::View view)
{
  return sb::EnclosesOnce(outline.Places.front().data(), outline.Edges, view);
}

// --- by definition
// -------------------------------------------------------------------------------------------------

/** Whether c lies on the closed segment ab in the view along z. */
bool IsOn(const double* a, const double* b, const double* c)
{
  return sb::Orient2D(a, b, c, 2) == 0 && std::min(a[0], b[0]) <= c[0] &&
    c[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= c[1] && c[1] <= std::max(a[1], b[1]);
}

bool Meet(const double* a, const double* b, const double* c, const double* d)
{
  return IsOn(a, b, c) || IsOn(a, b, d) || IsOn(c, d, a) || IsOn(c, d, b) ||
    (sb::Orient2D(a, b, c, 2) * sb::Orient2D(a, b, d, 2) < 0 &&
      sb::Orient2D(c, d, a, 2) * sb::Orient2D(c, d, b, 2) < 0);
}

/** Whether edges meet but in vertices that both have. */
bool MeetsItself(const Outline& outline)
{
  for (std::size_t i = 0; i < outline.Edges.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const auto [a, b] = outline.Edges[i];
      auto [c, d] = outline.Edges[j];
      const auto at = [&](std::int32_t k) { return outline.Places[std::size_t(k)].data(); };
      if (a == c || a == d || b == c || b == d)
      {
        const std::int32_t common = a == c || a == d ? a : b;
        const std::int32_t mine = common == a ? b : a;
        const std::int32_t other = common == c ? d : c;
        if (mine == other || IsOn(at(a), at(b), at(other)) || IsOn(at(c), at(d), at(mine)))
        {
          return true;
        }
      }
      else if (Meet(at(a), at(b), at(c), at(d)))
      {
        return true;
      }
    }
  }
  return false;
}

/** Around a place that is on no line through two lattice points near it. */
int WindingAround(const Outline& outline, double x, double y)
{
  int winding = 0;
  for (const auto [from, to] : outline.Edges)
  {
    const shapes::Point& a = outline.Places[std::size_t(from)];
    const shapes::Point& b = outline.Places[std::size_t(to)];
    if ((a[1] < y) != (b[1] < y))
    {
      const double crossing = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]);
      winding += crossing > x ? (b[1] > a[1] ? 1 : -1) : 0;
    }
  }
  return winding;
}

bool WindsOnceAtMost(const Outline& outline, double side)
{
  constexpr double step = 0.0503; // closer than any two lines of such small numbers leave open
  for (double x = 0.0117; x < side; x += step)
  {
    for (double y = 0.0231; y < side; y += step)
    {
      const int winding = WindingAround(outline, x, y);
      if (winding != 0 && winding != 1)
      {
        return false;
      }
    }
  }
  return true;
}

// --- outlines
// ------------------------------------------------------------------------------------------------------

/** A few closed curves, whose corners lie on a small grid and now and then are one vertex. */
Outline RandomOutline(shapes::Random& random, int side, int curves)
{
  Outline outline;
  std::vector<std::int32_t> vertices;
  for (int curve = 0; curve < curves; ++curve)
  {
    vertices.clear();
    const int corners = shapes::Between(random, 3, 6);
    for (int i = 0; i < corners; ++i)
    {
      const auto known = static_cast<int>(outline.Places.size());
      if (known > 0 && shapes::Between(random, 0, 3) == 0)
      {
        vertices.push_back(shapes::Between(random, 0, known - 1));
        continue;
      }
      vertices.push_back(known);
      outline.Places.push_back({ double(shapes::Between(random, 0, side)),
        double(shapes::Between(random, 0, side)), double(shapes::Between(random, 0, side)) });
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const std::int32_t next = vertices[(i + 1) % vertices.size()];
      const shapes::Point& p = outline.Places[std::size_t(vertices[i])];
      const shapes::Point& q = outline.Places[std::size_t(next)];
      if (p[0] == q[0] && p[1] == q[1])
      {
        return RandomOutline(random, side, curves); // no triangle is seen edge-on
      }
      outline.Edges.push_back({ vertices[i], next });
    }
  }
  return outline;
}

void TestAgainstDefinition()
{
  shapes::Random random(5);
  constexpr sb::View above{ 2, false };
  constexpr sb::View below{ 2, true };
  std::array<int, 2> verdicts{};
  for (int round = 0; round < 6000; ++round)
  {
    const int side = 3 + round % 3;
    Outline outline = RandomOutline(random, side, 1 + round % 3);
    std::set<std::pair<double, double>> places;
    for (const shapes::Point& p : outline.Places)
    {
      places.insert({ p[0], p[1] });
    }
    const bool expected = places.size() == outline.Places.size() && !MeetsItself(outline) &&
      WindsOnceAtMost(outline, side);
    CHECK_EQUAL(IsEnclosing(outline, above), expected);
    ++verdicts[expected];
    for (sb::OutlineEdge& edge : outline.Edges)
    {
      std::swap(edge.From, edge.To);
    }
    CHECK_EQUAL(IsEnclosing(outline, below), expected);
  }
  CHECK(verdicts[0] > 1000);
  CHECK(verdicts[1] > 300);
}

/** Two squares around each other, both counter-clockwise: the inner one is covered twice. */
void TestNestedCurves()
{
  Outline outline;
  for (const double margin : { 0.0, 1.0 })
  {
    const auto first = static_cast<std::int32_t>(outline.Places.size());
    outline.Places.insert(outline.Places.end(),
      { { margin, margin, 0 }, { 4 - margin, margin, 0 }, { 4 - margin, 4 - margin, 0 },
        { margin, 4 - margin, 0 } });
    for (std::int32_t i = 0; i < 4; ++i)
    {
      outline.Edges.push_back({ first + i, first + (i + 1) % 4 });
    }
  }
  CHECK(!IsEnclosing(outline, { 2, false }));
  for (std::size_t i = 4; i < 8; ++i)
  {
    std::swap(outline.Edges[i].From, outline.Edges[i].To);
  }
  CHECK(IsEnclosing(outline, { 2, false }));
  CHECK(!IsEnclosing(outline, { 2, true }));
}

void TestViews()
{
  const shapes::Point o{ 0, 0, 0 };
  const shapes::Point x{ 1, 0, 0 };
  const shapes::Point y{ 0, 1, 0 };
  const shapes::Point z{ 0, 0, 1 };
  const auto views = [](const shapes::Point& a, const shapes::Point& b, const shapes::Point& c) {
    return int(sb::ViewsFacing(a.data(), b.data(), c.data()));
  };
  CHECK_EQUAL(views(o, x, y), 1 << 4);
  CHECK_EQUAL(views(o, y, x), 1 << 5);
  CHECK_EQUAL(views(x, y, z), (1 << 0) | (1 << 2) | (1 << 4));
  CHECK_EQUAL(views(x, z, y), (1 << 1) | (1 << 3) | (1 << 5));
  CHECK_EQUAL(views(x, x, y), 0);
}

} // namespace

int main()
{
  TestAgainstDefinition();
  TestNestedCurves();
  TestViews();
  return check::Verdict("TestPatchOutline");
}
