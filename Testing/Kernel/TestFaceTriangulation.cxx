// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFaceTriangulation.cxx
 * @brief The cells fill the face exactly, every constraint is a chain of edges, and free edges are
 * Delaunay.
 */
#include "Check.h"
#include "FaceTriangulation.h"
#include "Rational.h"
#include "Shapes.h"

#include <ctime>
#include <map>
#include <set>

namespace
{

using sb::ExactPoint;
using sb::FaceTriangulation;
using shapes::Between;
using shapes::Point;
using shapes::Random;
using shapes::operator+;
using shapes::operator*;
using Number = rational::Number;

/** A face, its triangulation, and the segments drawn on it: all points are in the face's plane. */
class Drawing : public sb::ConstraintSource
{
public:
  explicit Drawing(const std::array<Point, 3>& corners)
    : Corners(corners)
    , Normal(sb::ComputeDominantNormal(corners[0].data(), corners[1].data(), corners[2].data()))
  {
    std::array<const ExactPoint*, 3> exact;
    for (std::size_t i = 0; i < 3; ++i)
    {
      exact[i] = this->Keep(ExactPoint::Vertex(corners[i].data()));
    }
    this->Mesh.Reset(exact, this->Normal.Axis, this->Normal.Sign);
  }

  int Insert(const Point& p) { return this->Mesh.Insert(this->Keep(ExactPoint::Vertex(p.data()))); }

  void Draw(const Point& a, const Point& b)
  {
    const int from = this->Insert(a);
    const int to = this->Insert(b);
    this->Segments.push_back({ a, b });
    if (from != to)
    {
      this->Mesh.Constrain(from, to, static_cast<int>(this->Segments.size()) - 1, *this);
    }
  }

  ExactPoint Crossing(int constraint, int other) override
  {
    ++this->NumberOfCrossings;
    const auto& [a, b] = this->Segments[static_cast<std::size_t>(constraint)];
    const auto& [c, d] = this->Segments[static_cast<std::size_t>(other)];
    const ExactPoint point =
      ExactPoint::LineLine(a.data(), b.data(), c.data(), d.data(), this->Normal.Axis);
    CHECK(point.Exists());
    return point;
  }

  void PassesThrough(int constraint, int vertex) override
  {
    this->Passes.insert({ constraint, vertex });
  }

  const ExactPoint* Keep(const ExactPoint& point)
  {
    this->Points.push_back(point);
    return &this->Points.back();
  }

  std::array<Point, 3> Corners;
  sb::DominantNormal Normal;
  FaceTriangulation Mesh;
  std::vector<std::pair<Point, Point>> Segments;
  std::set<std::pair<int, int>> Passes;
  int NumberOfCrossings = 0;

private:
  std::deque<ExactPoint> Points;
};

using Flat = std::array<Number, 2>;

Number Area2(const Flat& a, const Flat& b, const Flat& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** The vertices of a drawing in the projection, seen from where the normal points. */
std::vector<Flat> FlatVertices(const Drawing& drawing)
{
  std::vector<Flat> flat;
  const auto u = static_cast<std::size_t>((drawing.Normal.Axis + 1) % 3);
  const auto v = static_cast<std::size_t>((drawing.Normal.Axis + 2) % 3);
  for (int i = 0; i < drawing.Mesh.NumberOfVertices(); ++i)
  {
    const rational::Point p = rational::ToPoint(drawing.Mesh.Point(i));
    flat.push_back({ drawing.Normal.Sign > 0 ? p[u] : Number(-p[u]), p[v] });
  }
  return flat;
}

/** A valid triangulation of the face: positive cells that add up to it, and links that agree with
 * each other. */
void CheckCells(const Drawing& drawing, const std::vector<Flat>& flat)
{
  const std::vector<FaceTriangulation::Cell>& cells = drawing.Mesh.Cells();
  const auto at = [&](int vertex) { return flat[static_cast<std::size_t>(vertex)]; };
  Number sum = 0;
  std::map<std::pair<int, int>, std::pair<int, int>> edges; // directed edge: cell, edge
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto [a, b, c] = cells[i].Vertices;
    const Number area = Area2(at(a), at(b), at(c));
    CHECK(area > 0);
    sum += area;
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const bool isNew =
        edges
          .insert({ { cells[i].Vertices[(edge + 1) % 3], cells[i].Vertices[(edge + 2) % 3] },
            { static_cast<int>(i), static_cast<int>(edge) } })
          .second;
      CHECK(isNew);
    }
  }
  CHECK(sum == Area2(flat[0], flat[1], flat[2]));
  for (const auto& [ends, place] : edges)
  {
    const FaceTriangulation::Cell& cell = cells[static_cast<std::size_t>(place.first)];
    const int across = cell.Neighbours[static_cast<std::size_t>(place.second)];
    const auto twin = edges.find({ ends.second, ends.first });
    CHECK_EQUAL(across, twin == edges.end() ? FaceTriangulation::None : twin->second.first);
    if (twin != edges.end())
    {
      CHECK_EQUAL(cell.Constraints[static_cast<std::size_t>(place.second)],
        cells[static_cast<std::size_t>(twin->second.first)]
          .Constraints[static_cast<std::size_t>(twin->second.second)]);
    }
  }
}

bool IsBetween(const Flat& p, const Flat& a, const Flat& b)
{
  return Area2(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
    std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}

/** Each segment is covered by marked edges from end to end, and no other edge is marked. */
void CheckConstraints(const Drawing& drawing, const std::vector<Flat>& flat)
{
  std::set<std::pair<int, int>> marked;
  std::size_t explained = 0;
  for (const FaceTriangulation::Cell& cell : drawing.Mesh.Cells())
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      if (cell.Constraints[edge] != FaceTriangulation::None)
      {
        marked.insert(std::minmax(cell.Vertices[(edge + 1) % 3], cell.Vertices[(edge + 2) % 3]));
      }
    }
  }
  std::set<std::pair<int, int>> covered;
  for (const auto& segment : drawing.Segments)
  {
    std::array<Flat, 2> ends;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const Point& p = i == 0 ? segment.first : segment.second;
      const auto u = static_cast<std::size_t>((drawing.Normal.Axis + 1) % 3);
      const auto v = static_cast<std::size_t>((drawing.Normal.Axis + 2) % 3);
      ends[i] = { Number(drawing.Normal.Sign > 0 ? p[u] : -p[u]), Number(p[v]) };
    }
    std::vector<std::pair<Flat, int>> along;
    for (std::size_t i = 0; i < flat.size(); ++i)
    {
      if (IsBetween(flat[i], ends[0], ends[1]))
      {
        along.push_back({ flat[i], static_cast<int>(i) });
      }
    }
    std::sort(along.begin(), along.end());
    for (std::size_t i = 1; i < along.size(); ++i)
    {
      const auto edge = std::minmax(along[i - 1].second, along[i].second);
      CHECK_EQUAL(marked.count(edge), 1u);
      covered.insert(edge);
    }
    explained += along.size();
  }
  CHECK(explained >= drawing.Segments.size());
  CHECK(covered == marked);
}

void CheckAll(const Drawing& drawing)
{
  const std::vector<Flat> flat = FlatVertices(drawing);
  CheckCells(drawing, flat);
  CheckConstraints(drawing, flat);
}

/** In the plane x + y + z = 0 if `tilted`, else in z = 0. */
Point InPlane(double x, double y, bool tilted) { return { x, y, tilted ? -x - y : 0.0 }; }

std::array<Point, 3> Face(double size, bool tilted, bool reversed)
{
  std::array<Point, 3> face{ InPlane(0, 0, tilted), InPlane(size, 0, tilted),
    InPlane(0, size, tilted) };
  if (reversed)
  {
    std::swap(face[1], face[2]);
  }
  return face;
}

void CheckSingle()
{
  for (const bool reversed : { false, true })
  {
    Drawing drawing(Face(12, true, reversed));
    CheckAll(drawing);
    CHECK_EQUAL(drawing.Mesh.Cells().size(), 1u);
    // Corners and points that are there already are found again.
    CHECK_EQUAL(drawing.Insert(InPlane(0, 0, true)), 0);
    const int inside = drawing.Insert(InPlane(3, 4, true));
    CHECK_EQUAL(drawing.Insert(InPlane(3, 4, true)), inside);
    CHECK_EQUAL(drawing.Mesh.Cells().size(), 3u);
    const int onEdge = drawing.Insert(InPlane(6, 6, true));
    CHECK_EQUAL(drawing.Insert(InPlane(6, 6, true)), onEdge);
    CHECK_EQUAL(drawing.Mesh.Cells().size(), 4u);
    CheckAll(drawing);
    // An edge of the face, a line through a point on it, a line through a vertex within, and a
    // crossing.
    drawing.Draw(InPlane(12, 0, true), InPlane(0, 12, true));
    CHECK_EQUAL(drawing.Passes.count({ 0, onEdge }), 1u);
    drawing.Draw(InPlane(0, 4, true), InPlane(6, 4, true));
    CHECK_EQUAL(drawing.Passes.count({ 1, inside }), 1u);
    CHECK_EQUAL(drawing.NumberOfCrossings, 0);
    CheckAll(drawing);
    drawing.Draw(InPlane(5, 0, true), InPlane(5, 7, true));
    CHECK_EQUAL(drawing.NumberOfCrossings, 1);
    CheckAll(drawing);
    // Over one another in part.
    drawing.Draw(InPlane(2, 4, true), InPlane(8, 4, true));
    drawing.Draw(InPlane(8, 4, true), InPlane(1, 4, true));
    CheckAll(drawing);
  }
}

/** Segments between small integers: they cross, touch, and lie on each other and on the face's
 * edges. */
void CheckSmallIntegers()
{
  Random random(3);
  int crossings = 0;
  std::size_t passes = 0;
  for (int round = 0; round < 600; ++round)
  {
    const int size = Between(random, 2, 6);
    const bool tilted = Between(random, 0, 1) == 0;
    Drawing drawing(Face(size, tilted, Between(random, 0, 1) == 0));
    const auto point = [&] {
      const int x = Between(random, 0, size);
      return InPlane(x, Between(random, 0, size - x), tilted);
    };
    for (int i = Between(random, 0, 5); i > 0; --i)
    {
      drawing.Insert(point());
    }
    for (int i = Between(random, 1, 8); i > 0; --i)
    {
      const Point from = point();
      drawing.Draw(from, point());
    }
    CheckAll(drawing);
    crossings += drawing.NumberOfCrossings;
    passes += drawing.Passes.size();
  }
  CHECK(crossings > 300 && passes > 300);
}

/** Points on the edges alone, put in directly and by search: the same vertices. */
void CheckPointsOnEdges()
{
  Random random(4);
  for (int round = 0; round < 20; ++round)
  {
    const std::array<Point, 3> face = Face(40, round % 2 == 0, round % 3 == 0);
    Drawing drawing(face);
    for (int i = 0; i < 40; ++i)
    {
      const int edge = Between(random, 0, 2);
      const double weight = Between(random, 1, 39) / 40.0;
      const Point& a = face[static_cast<std::size_t>(edge)];
      const Point& b = face[static_cast<std::size_t>((edge + 1) % 3)];
      const Point p = (1.0 - weight) * a + weight * b;
      const Point rounded{ std::round(p[0]), std::round(p[1]), std::round(p[2]) };
      const ExactPoint* exact = drawing.Keep(ExactPoint::Vertex(rounded.data()));
      const int vertex = drawing.Mesh.InsertOnEdge(exact, edge);
      CHECK(sb::SamePoint(drawing.Mesh.Point(vertex), *exact));
      CHECK_EQUAL(drawing.Mesh.InsertOnEdge(exact, edge), vertex);
      CHECK_EQUAL(drawing.Mesh.Insert(exact), vertex);
    }
    CheckAll(drawing);
  }
}

/** The processor time that it takes to draw parallel lines across a face, in an order without rule.
 */
double SecondsForParallels(int count)
{
  const int size = 1 << 20;
  Drawing drawing(Face(size, true, false));
  std::vector<int> order;
  std::vector<Point> starts;
  std::vector<Point> ends;
  for (int i = 1; i <= count; ++i)
  {
    const int y = i * (size / (2 * count));
    order.push_back(i - 1);
    starts.push_back(InPlane(0, y, true));
    ends.push_back(InPlane(size - y, y, true));
  }
  for (const std::vector<Point>* side : { &starts, &ends })
  {
    for (const Point& p : *side)
    {
      drawing.Insert(p);
    }
  }
  Random random(6);
  std::shuffle(order.begin(), order.end(), random);
  const std::clock_t begin = std::clock();
  for (const int i : order)
  {
    drawing.Mesh.Constrain(3 + i, 3 + count + i, i, drawing);
  }
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  CHECK_EQUAL(drawing.Mesh.Cells().size(), static_cast<std::size_t>(2 * count + 1));
  CHECK_EQUAL(drawing.NumberOfCrossings, 0);
  return seconds;
}

/** Long segments next to each other: eight times as many take less than twenty times as long, not
 * sixty-four times. */
void CheckParallels()
{
  double few = 1e300;
  for (int i = 0; i < 3; ++i)
  {
    few = std::min(few, SecondsForParallels(1000));
  }
  CHECK(SecondsForParallels(8000) < 20 * few + 0.01);
}

/** How many free edges have the opposite vertex inside the circle of their cell, by rational
 * arithmetic. */
int NumberOfBadEdges(const Drawing& drawing, const std::vector<Flat>& flat)
{
  int bad = 0;
  const std::vector<FaceTriangulation::Cell>& cells = drawing.Mesh.Cells();
  for (const FaceTriangulation::Cell& cell : cells)
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const int across = cell.Neighbours[edge];
      if (across == FaceTriangulation::None || cell.Constraints[edge] != FaceTriangulation::None)
      {
        continue;
      }
      const int a = cell.Vertices[(edge + 1) % 3];
      const int b = cell.Vertices[(edge + 2) % 3];
      int far = 0;
      for (const int vertex : cells[static_cast<std::size_t>(across)].Vertices)
      {
        far = vertex != a && vertex != b ? vertex : far;
      }
      const Flat& d = flat[static_cast<std::size_t>(far)];
      std::array<std::array<Number, 3>, 3> rows;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Flat& p = flat[static_cast<std::size_t>(cell.Vertices[i])];
        const Number x = p[0] - d[0];
        const Number y = p[1] - d[1];
        rows[i] = { x, y, x * x + y * y };
      }
      bad += rational::Dot(rows[0], rational::Cross(rows[1], rows[2])) > 0;
    }
  }
  return bad;
}

/** Many points in one face, in no order at all: valid, and Delaunay. */
void CheckManyPoints()
{
  Random random(5);
  constexpr int size = 1 << 20;
  Drawing drawing(Face(size, false, false));
  for (int i = 0; i < 5000; ++i)
  {
    const int x = Between(random, 0, size);
    const int y = Between(random, 0, size);
    drawing.Insert(x + y <= size ? InPlane(x, y, false) : InPlane(size - x, size - y, false));
  }
  const std::vector<Flat> flat = FlatVertices(drawing);
  CHECK(flat.size() > 4990);
  CheckCells(drawing, flat);
  CHECK_EQUAL(NumberOfBadEdges(drawing, flat), 0);
}

/** On a grid all circles are shared by four points: any of the triangulations will do, but it has
 * to be found. */
void CheckGrid()
{
  constexpr int size = 48;
  Drawing drawing(Face(size, true, true));
  for (int x = 0; x <= size; ++x)
  {
    for (int y = 0; x + y <= size; ++y)
    {
      drawing.Insert(InPlane(x, y, true));
    }
  }
  const std::vector<Flat> flat = FlatVertices(drawing);
  CHECK_EQUAL(flat.size(), std::size_t((size + 1) * (size + 2) / 2));
  CHECK_EQUAL(drawing.Mesh.Cells().size(), std::size_t(size * size));
  CheckCells(drawing, flat);
  CHECK_EQUAL(NumberOfBadEdges(drawing, flat), 0);
}

/** A fan of long lines through many points: constraints that cross hundreds of edges, and each
 * other. */
void CheckLongConstraints()
{
  Random random(6);
  constexpr int size = 1000;
  Drawing drawing(Face(size, false, true));
  for (int i = 0; i < 600; ++i)
  {
    const int x = Between(random, 1, size - 2);
    drawing.Insert(InPlane(x, Between(random, 1, size - x - 1), false));
  }
  for (int i = 0; i < 12; ++i)
  {
    drawing.Draw(InPlane(0, 83 * i, false), InPlane(83 * i, size - 83 * i, false));
  }
  CHECK(drawing.NumberOfCrossings > 20);
  CheckAll(drawing);
}

} // namespace

int main()
{
  CheckSingle();
  CheckSmallIntegers();
  CheckPointsOnEdges();
  CheckManyPoints();
  CheckGrid();
  CheckLongConstraints();
  CheckParallels();
  return check::Verdict("TestFaceTriangulation");
}
