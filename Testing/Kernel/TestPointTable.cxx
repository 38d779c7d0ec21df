// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPointTable.cxx
 * @brief Equal points get one node whatever made them and whenever they come; different ones never
 * do, however near.
 */
#include "Check.h"
#include "PointTable.h"
#include "Rational.h"
#include "Shapes.h"
#include "ThreadExecutor.h"

#include <map>

namespace
{

using sb::ContactPoint;
using sb::ExactPoint;
using sb::NodeId;
using shapes::IntegerPoint;
using shapes::Point;
using shapes::Random;

/** Where a random line meets a random plane, or a corner; all within a few units. */
ContactPoint RandomPoint(Random& random)
{
  static std::int32_t vertex = 0;
  for (;;)
  {
    Point p[5];
    for (Point& x : p)
    {
      x = IntegerPoint(random, -2, 2);
    }
    if (shapes::Between(random, 0, 2) == 0)
    {
      return { ExactPoint::Vertex(p[0].data()), ++vertex };
    }
    if (sb::Orient3D(p[2].data(), p[3].data(), p[4].data(), p[0].data()) *
        sb::Orient3D(p[2].data(), p[3].data(), p[4].data(), p[1].data()) <
      0)
    {
      return {
        ExactPoint::LinePlane(p[0].data(), p[1].data(), p[2].data(), p[3].data(), p[4].data()), -1
      };
    }
  }
}

void CheckRandom()
{
  Random random(1);
  sb::SerialExecutor one;
  sb::ThreadExecutor two(2);
  for (int round = 0; round < 20; ++round)
  {
    sb::PointTable table;
    sb::PointTable twin;
    std::map<rational::Point, NodeId> known;
    std::map<NodeId, std::int32_t> lowest;
    for (int batch = 0; batch < 4; ++batch)
    {
      std::vector<ContactPoint> points;
      for (int i = 0; i < 300; ++i)
      {
        points.push_back(RandomPoint(random));
      }
      const std::vector<NodeId> nodes = table.Insert(points, one);
      CHECK(nodes == twin.Insert(points, two));
      CHECK_EQUAL(nodes.size(), points.size());
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        CHECK(nodes[i] >= 0 && nodes[i] < table.Size());
        const auto place = known.emplace(rational::ToPoint(points[i].Point), nodes[i]).first;
        CHECK_EQUAL(nodes[i], place->second);
        CHECK(sb::SamePoint(table.Point(nodes[i]), points[i].Point));
        const auto vertex = lowest.emplace(nodes[i], points[i].Vertex).first;
        if (points[i].Vertex >= 0 && (vertex->second < 0 || points[i].Vertex < vertex->second))
        {
          vertex->second = points[i].Vertex;
        }
      }
      CHECK_EQUAL(std::size_t(table.Size()), known.size());
      for (const auto& [node, vertex] : lowest)
      {
        CHECK_EQUAL(table.Vertex(node), vertex);
      }
    }
    CHECK(known.size() > 100 && known.size() < 1100); // so points did meet
  }
}

/** One point by its corner, by line and plane, by two lines and by three planes. */
void CheckConstructions()
{
  const Point origin{ 0, 0, 0 };
  const Point x{ 2, 0, 0 };
  const Point y{ 0, 2, 0 };
  const Point z{ 0, 0, 2 };
  const Point back{ -4, 0, 0 };
  const std::vector<ContactPoint> points{ { ExactPoint::Vertex(origin.data()), 7 },
    { ExactPoint::LinePlane(x.data(), back.data(), origin.data(), y.data(), z.data()), -1 },
    { ExactPoint::LineLine(x.data(), back.data(), y.data(), origin.data(), 2), -1 },
    { ExactPoint::ThreePlanes(sb::ExactPlane::Through(origin.data(), x.data(), y.data()),
        sb::ExactPlane::Through(origin.data(), y.data(), z.data()),
        sb::ExactPlane::Through(origin.data(), z.data(), x.data())),
      -1 },
    { ExactPoint::Vertex(origin.data()), 3 } };
  sb::SerialExecutor executor;
  for (std::size_t first = 0; first < points.size(); ++first)
  {
    sb::PointTable table;
    const NodeId node = table.Insert({ points[first] }, executor).front();
    for (const NodeId same : table.Insert(points, executor))
    {
      CHECK_EQUAL(same, node);
    }
    CHECK_EQUAL(table.Size(), 1);
    CHECK_EQUAL(table.Vertex(node), 3);
  }
}

/** Different points that round to the same doubles are different nodes: here, 2^-104 apart. */
void CheckSameDoubles()
{
  const double far = 4503599627370495.0;
  const Point flat[2] = { { 0, 0, 0 }, { far, 1, 0 } };
  std::vector<ContactPoint> points;
  for (int i = 0; i < 6; ++i)
  {
    const Point steep[2] = { { 1, 0, 0 }, { 1.0 + i, far, 0 } };
    points.push_back(
      { ExactPoint::LineLine(flat[0].data(), flat[1].data(), steep[0].data(), steep[1].data(), 2),
        -1 });
    CHECK_EQUAL(points.back().Point.Approximation()[0], 1.0);
    CHECK_EQUAL(points.back().Point.Approximation()[1], points[0].Point.Approximation()[1]);
  }
  sb::SerialExecutor executor;
  sb::PointTable table;
  const std::vector<NodeId> nodes = table.Insert(points, executor);
  CHECK_EQUAL(table.Size(), 6);
  std::reverse(points.begin(), points.end());
  std::vector<NodeId> again = table.Insert(points, executor);
  std::reverse(again.begin(), again.end());
  CHECK(again == nodes);
  CHECK_EQUAL(table.Size(), 6);
}

void CheckEmpty()
{
  sb::SerialExecutor executor;
  sb::PointTable table;
  CHECK(table.Insert({}, executor).empty());
  CHECK_EQUAL(table.Size(), 0);
}

} // namespace

int main()
{
  CheckRandom();
  CheckConstructions();
  CheckSameDoubles();
  CheckEmpty();
  return check::Verdict("TestPointTable");
}
