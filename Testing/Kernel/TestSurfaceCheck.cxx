// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceCheck.cxx
 * @brief The check finds on random soups what naive definitions find, and each defect made on
 * purpose.
 */
#include "Check.h"
#include "Rational.h"
#include "Shapes.h"
#include "SurfaceCheck.h"
#include "ThreadExecutor.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>

namespace
{

sb::SurfaceCheckResult CheckMesh(const shapes::Mesh& mesh, int threads = 1)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  sb::SurfaceCheckRequest request;
  request.Mesh = mesh.View();
  request.Cells.NumberOfCells = request.Mesh.NumberOfTriangles;
  return sb::CheckSurface(request, executor, monitor);
}

// --- by definition
// -------------------------------------------------------------------------------------------------

using Place = shapes::Point;
using PlacePair = std::pair<Place, Place>;

/** What the check has to find, without a thought of speed. */
struct Definition
{
  explicit Definition(const shapes::Mesh& mesh)
    : Mesh(mesh)
  {
    this->ListEdges();
    this->FindShells();
    this->FindTouching();
    this->FindCells();
    this->FindMeetings();
  }

  struct Use
  {
    std::size_t Triangle;
    bool RunsUp;
  };

  const shapes::Mesh& Mesh;
  std::map<PlacePair, std::vector<Use>> Edges;
  std::map<std::size_t, std::size_t> ShellOf; ///< the first triangle of a triangle's shell
  std::set<Place> Touching;
  std::set<std::size_t> WithoutArea;
  std::set<std::size_t> Duplicates;
  std::set<std::pair<std::size_t, std::size_t>> Meetings;

private:
  Place At(std::size_t triangle, std::size_t corner) const
  {
    return this->Mesh.At(this->Mesh.Triangles[triangle], corner % 3);
  }

  std::set<Place> PlacesOf(std::size_t triangle) const
  {
    return { this->At(triangle, 0), this->At(triangle, 1), this->At(triangle, 2) };
  }

  bool HasEdges(std::size_t triangle) const { return this->PlacesOf(triangle).size() == 3; }

  void ListEdges()
  {
    for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
    {
      for (std::size_t k = 0; k < 3 && this->HasEdges(i); ++k)
      {
        const Place a = this->At(i, k);
        const Place b = this->At(i, k + 1);
        this->Edges[std::minmax(a, b)].push_back({ i, a < b });
      }
    }
  }

  void FindShells()
  {
    for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
    {
      if (this->HasEdges(i))
      {
        this->ShellOf[i] = i;
      }
    }
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const auto& [edge, uses] : this->Edges)
      {
        for (const Use& use : uses)
        {
          std::size_t& mine = this->ShellOf[use.Triangle];
          std::size_t& first = this->ShellOf[uses.front().Triangle];
          changed = changed || mine != first;
          mine = first = std::min(mine, first);
        }
      }
    }
  }

  /** Vertices whose triangles cannot all be reached from one by edges at the vertex. */
  void FindTouching()
  {
    std::map<Place, std::set<std::size_t>> around;
    for (const auto& [edge, uses] : this->Edges)
    {
      for (const Use& use : uses)
      {
        around[edge.first].insert(use.Triangle);
        around[edge.second].insert(use.Triangle);
      }
    }
    for (const auto& [place, triangles] : around)
    {
      std::set<std::size_t> reached{ *triangles.begin() };
      for (std::size_t before = 0; before != reached.size();)
      {
        before = reached.size();
        for (const auto& [edge, uses] : this->Edges)
        {
          const bool isHere = edge.first == place || edge.second == place;
          const bool isReached = std::any_of(uses.begin(), uses.end(),
            [&](const Use& use) { return reached.count(use.Triangle) > 0; });
          for (std::size_t i = 0; isHere && isReached && i < uses.size(); ++i)
          {
            reached.insert(uses[i].Triangle);
          }
        }
      }
      if (reached != triangles)
      {
        this->Touching.insert(place);
      }
    }
  }

  rational::Triangle Exact(std::size_t triangle) const
  {
    rational::Triangle result;
    for (std::size_t k = 0; k < 3; ++k)
    {
      result[k] = rational::ToPoint(this->At(triangle, k).data());
    }
    return result;
  }

  void FindCells()
  {
    std::set<std::set<Place>> known;
    for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
    {
      if (rational::Normal(this->Exact(i)) == rational::Point{ 0, 0, 0 })
      {
        this->WithoutArea.insert(i);
      }
      if (!known.insert(this->PlacesOf(i)).second)
      {
        this->Duplicates.insert(i);
      }
    }
  }

  void FindMeetings()
  {
    for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
    {
      for (std::size_t j = i + 1; j < this->Mesh.Triangles.size(); ++j)
      {
        if (this->WithoutArea.count(i) == 0 && this->WithoutArea.count(j) == 0 && this->Meet(i, j))
        {
          this->Meetings.insert({ i, j });
        }
      }
    }
  }

  /** Elsewhere than in corners or an edge that both have. */
  bool Meet(std::size_t i, std::size_t j) const
  {
    const std::set<Place> ofI = this->PlacesOf(i);
    const std::set<Place> ofJ = this->PlacesOf(j);
    if (ofI == ofJ)
    {
      return false;
    }
    std::set<rational::Point> common;
    for (const Place& place : ofI)
    {
      if (ofJ.count(place) > 0)
      {
        common.insert(rational::ToPoint(place.data()));
      }
    }
    const std::vector<rational::Point> met = rational::Intersection(this->Exact(i), this->Exact(j));
    return std::any_of(met.begin(), met.end(),
             [&](const rational::Point& point) { return common.count(point) == 0; }) &&
      !this->IsSewn(i, j, met);
  }

  /** The triangle without area beyond an edge that just the two of them have, each its own way. */
  std::set<std::size_t> SeamAt(const PlacePair& edge, std::size_t triangle) const
  {
    const std::vector<Use>& uses = this->Edges.at(std::minmax(edge.first, edge.second));
    std::set<std::size_t> seam;
    if (uses.size() == 2 && uses[0].RunsUp != uses[1].RunsUp)
    {
      const std::size_t other = uses[uses[0].Triangle == triangle].Triangle;
      if (this->WithoutArea.count(other) > 0)
      {
        seam.insert(other);
      }
    }
    return seam;
  }

  /** Whether all points lie on an edge of either that one seam of triangles without area joins. */
  bool IsSewn(std::size_t i, std::size_t j, const std::vector<rational::Point>& met) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::set<std::size_t> seam = this->SeamAt({ this->At(i, k), this->At(i, k + 1) }, i);
      for (std::size_t before = 0; before != seam.size();)
      {
        before = seam.size();
        for (const std::size_t t : std::set<std::size_t>(seam))
        {
          for (std::size_t e = 0; e < 3 && this->HasEdges(t); ++e)
          {
            seam.merge(this->SeamAt({ this->At(t, e), this->At(t, e + 1) }, t));
          }
        }
      }
      for (std::size_t l = 0; l < 3; ++l)
      {
        const std::set<std::size_t> its = this->SeamAt({ this->At(j, l), this->At(j, l + 1) }, j);
        const bool isOneSeam = !its.empty() && seam.count(*its.begin()) > 0;
        if (isOneSeam && std::all_of(met.begin(), met.end(), [&](const rational::Point& point) {
              return rational::InsideEdge(this->Exact(i), k, point) == 0 &&
                rational::InsideEdge(this->Exact(j), l, point) == 0;
            }))
        {
          return true;
        }
      }
    }
    return false;
  }
};

template <class Holds>
std::set<std::size_t> Marked(const std::vector<std::uint16_t>& marks, Holds&& holds)
{
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (holds(marks[i]))
    {
      found.insert(i);
    }
  }
  return found;
}

std::set<std::size_t> Marked(const sb::SurfaceCheckResult& result, sb::Defect defect)
{
  return Marked(
    result.TriangleMarks, [=](std::uint16_t mark) { return (mark & sb::BitOf(defect)) != 0; });
}

sb::Defect KindOf(const std::vector<Definition::Use>& uses)
{
  if (uses.size() != 2)
  {
    return uses.size() == 1 ? sb::Defect::RimEdge : sb::Defect::ManyFoldEdge;
  }
  return uses[0].RunsUp == uses[1].RunsUp ? sb::Defect::ContradictoryEdge : sb::Defect::None;
}

void CompareEdges(const Definition& expected, const sb::SurfaceCheckResult& result)
{
  std::set<std::tuple<Place, Place, sb::Defect, std::size_t>> wanted;
  std::set<std::tuple<Place, Place, sb::Defect, std::size_t>> found;
  std::int64_t contradictions = 0;
  for (const auto& [edge, uses] : expected.Edges)
  {
    if (KindOf(uses) != sb::Defect::None)
    {
      wanted.insert({ edge.first, edge.second, KindOf(uses), uses.size() });
    }
    const auto up = std::count_if(
      uses.begin(), uses.end(), [](const Definition::Use& use) { return use.RunsUp; });
    contradictions += uses.size() % 2 == 0 && std::size_t(2 * up) != uses.size();
  }
  for (const sb::DefectEdge& edge : result.Edges)
  {
    const auto ends = std::minmax(expected.Mesh.Points[std::size_t(edge.Points[0])],
      expected.Mesh.Points[std::size_t(edge.Points[1])]);
    found.insert(
      { ends.first, ends.second, edge.Kind, static_cast<std::size_t>(edge.NumberOfTriangles) });
    CHECK((edge.Rim >= 0) == (edge.Kind == sb::Defect::RimEdge));
  }
  CHECK(wanted == found);
  CHECK_EQUAL(found.size(), result.Edges.size());
  CHECK_EQUAL(result.Counts.ContradictoryEdges, contradictions);
  CHECK_EQUAL(result.Counts.Edges, std::int64_t(expected.Edges.size()));
}

void CompareParts(const Definition& expected, const sb::SurfaceCheckResult& result)
{
  std::map<std::size_t, std::size_t> shells;
  for (std::size_t i = 0; i < result.ShellOfTriangle.size(); ++i)
  {
    if (result.ShellOfTriangle[i] >= 0)
    {
      shells[i] = std::size_t(result.Shells[std::size_t(result.ShellOfTriangle[i])].FirstTriangle);
    }
  }
  CHECK(shells == expected.ShellOf);
  std::set<Place> touching;
  for (const std::int32_t point : result.TouchingVertices)
  {
    touching.insert(expected.Mesh.Points[std::size_t(point)]);
  }
  CHECK(touching == expected.Touching);
  CHECK_EQUAL(result.TouchingVertices.size(), expected.Touching.size());
}

void CompareMeetings(const Definition& expected, const sb::SurfaceCheckResult& result)
{
  std::set<std::pair<std::size_t, std::size_t>> meetings;
  for (const sb::SelfContact& contact : result.SelfContacts)
  {
    meetings.insert({ std::size_t(contact.Triangles[0]), std::size_t(contact.Triangles[1]) });
  }
  CHECK(meetings == expected.Meetings);
  CHECK_EQUAL(result.Counts.SelfIntersections, std::int64_t(expected.Meetings.size()));
  std::vector<std::int32_t> counts(result.TriangleMarks.size(), 0);
  for (const auto& [i, j] : expected.Meetings)
  {
    ++counts[i];
    ++counts[j];
  }
  CHECK(result.MeetingsOfTriangle.empty() ? expected.Meetings.empty()
                                          : counts == result.MeetingsOfTriangle);
}

bool AreSame(const sb::SurfaceCheckResult& a, const sb::SurfaceCheckResult& b)
{
  const auto same = [](const auto& l, const auto& r) {
    return l.size() == r.size() &&
      (l.empty() || std::memcmp(l.data(), r.data(), l.size() * sizeof(l[0])) == 0);
  };
  bool areSame = same(a.ShellOfTriangle, b.ShellOfTriangle) &&
    same(a.TriangleMarks, b.TriangleMarks) && same(a.PointMarks, b.PointMarks) &&
    same(a.RimOfPoint, b.RimOfPoint) && same(a.MeetingsOfTriangle, b.MeetingsOfTriangle) &&
    same(a.TouchingVertices, b.TouchingVertices) && a.Shells.size() == b.Shells.size() &&
    a.Edges.size() == b.Edges.size() && same(a.SelfContacts, b.SelfContacts);
  for (std::size_t i = 0; areSame && i < a.Shells.size(); ++i)
  {
    areSame = a.Shells[i].Volume == b.Shells[i].Volume && a.Shells[i].Area == b.Shells[i].Area &&
      a.Shells[i].Parent == b.Shells[i].Parent && a.Shells[i].Genus == b.Shells[i].Genus;
  }
  return areSame && a.Report.Volume == b.Report.Volume && a.Report.Area == b.Report.Area;
}

/** Triangles between few integer points, some of which are at one place. */
shapes::Mesh RandomSoup(shapes::Random& random, int side, int points, int triangles)
{
  shapes::Mesh mesh;
  for (int i = 0; i < points; ++i)
  {
    mesh.Points.push_back(shapes::IntegerPoint(random, 0, side));
  }
  for (int i = 0; i < triangles; ++i)
  {
    mesh.Triangles.push_back({ shapes::Between(random, 0, points - 1),
      shapes::Between(random, 0, points - 1), shapes::Between(random, 0, points - 1) });
  }
  return mesh;
}

void Compare(const shapes::Mesh& mesh)
{
  const Definition expected(mesh);
  const sb::SurfaceCheckResult result = CheckMesh(mesh);
  CompareEdges(expected, result);
  CompareParts(expected, result);
  CompareMeetings(expected, result);
  CHECK(Marked(result, sb::Defect::NoArea) == expected.WithoutArea);
  CHECK(Marked(result, sb::Defect::Duplicate) == expected.Duplicates);
  const std::set<Place> places(mesh.Points.begin(), mesh.Points.end());
  CHECK_EQUAL(result.Counts.DuplicatePoints, std::int64_t(mesh.Points.size() - places.size()));
  CHECK(AreSame(result, CheckMesh(mesh, 4)));
}

void TestRandomSoups()
{
  shapes::Random random(1);
  for (int round = 0; round < 60; ++round)
  {
    Compare(RandomSoup(random, 2 + round % 4, 6 + round % 15, 4 + round % 40));
  }
  for (int round = 0; round < 12; ++round)
  {
    Compare(shapes::RandomBoxes(random, 0, 6, 2 + round % 4));
    Compare(shapes::RandomConvex(random, 0, 5, 12));
  }
}

/**
 * A square net in which points are off their places by up to `noise`, along z by up to `height`.
 * Four units are between neighbours, so that it folds over from a noise of about 4 on.
 */
shapes::Mesh RoughNet(shapes::Random& random, int cells, int noise, int height)
{
  shapes::Mesh mesh;
  for (int i = 0; i <= cells; ++i)
  {
    for (int j = 0; j <= cells; ++j)
    {
      mesh.Points.push_back({ double(4 * i + shapes::Between(random, -noise, noise)),
        double(4 * j + shapes::Between(random, -noise, noise)),
        double(shapes::Between(random, -height, height)) });
    }
  }
  for (std::int32_t i = 0; i < cells; ++i)
  {
    for (std::int32_t j = 0; j < cells; ++j)
    {
      const std::int32_t a = i * (cells + 1) + j;
      const std::int32_t b = a + cells + 1;
      mesh.Triangles.push_back({ a, b, b + 1 });
      mesh.Triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return mesh;
}

/** Sheets that are plain, nearly plain, and run into themselves and each other. */
void TestRoughNets()
{
  shapes::Random random(6);
  int withMeetings = 0;
  for (int round = 0; round < 24; ++round)
  {
    const int noise = round % 6;
    shapes::Mesh net = RoughNet(random, 5, noise, 1 + round / 2 % 8);
    if (round % 3 == 1)
    {
      net.Append(RoughNet(random, 3, noise, 3));
    }
    const Definition expected(net);
    withMeetings += !expected.Meetings.empty();
    CompareMeetings(expected, CheckMesh(net));
    CHECK(AreSame(CheckMesh(net), CheckMesh(net, 4)));
  }
  CHECK(withMeetings > 6 && withMeetings < 20);
}

/** A ramp that winds up around an axis: all of it faces upwards and hangs together. */
shapes::Mesh Ramp(int turns, int rise)
{
  constexpr std::int32_t steps = 12;
  shapes::Mesh mesh;
  for (std::int32_t i = 0; i <= steps * turns; ++i)
  {
    const double angle = 2 * 3.14159265358979 * (i % steps) / steps;
    for (const double radius : { 100.0, 200.0, 300.0 })
    {
      mesh.Points.push_back({ std::round(radius * std::cos(angle)),
        std::round(radius * std::sin(angle)), double(rise * i) });
    }
  }
  for (std::int32_t i = 0; i < 3 * steps * turns; ++i)
  {
    if (i % 3 < 2)
    {
      mesh.Triangles.push_back({ i, i + 1, i + 4 });
      mesh.Triangles.push_back({ i, i + 4, i + 3 });
    }
  }
  return mesh;
}

/** Floors over each other are no intersection; one that goes down through the other is one, though
 * all faces look upwards still. */
void TestRamps()
{
  shapes::Mesh ramp = Ramp(2, 2);
  CHECK_EQUAL(CheckMesh(ramp).Counts.SelfIntersections, 0);
  for (std::size_t i = ramp.Points.size() / 2 + 1; i < ramp.Points.size(); ++i)
  {
    ramp.Points[i][2] = 49.0 - ramp.Points[i][2];
  }
  const Definition expected(ramp);
  CHECK(expected.Meetings.size() > 3);
  CompareMeetings(expected, CheckMesh(ramp));
}

/** The segments are where two known triangles cross. */
void TestWhereTrianglesMeet()
{
  shapes::Mesh mesh = shapes::Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 });
  mesh.Append(shapes::Triangle({ 1, 1, -1 }, { 1, 1, 1 }, { 1, 9, 1 }));
  const sb::SurfaceCheckResult result = CheckMesh(mesh);
  CHECK_EQUAL(result.SelfContacts.size(), std::size_t(1));
  const auto ends = std::minmax(result.SelfContacts[0].Ends[0], result.SelfContacts[0].Ends[1]);
  CHECK((ends.first == std::array<double, 3>{ 1, 1, 0 }));
  CHECK((ends.second == std::array<double, 3>{ 1, 3, 0 }));
}

// --- shells
// --------------------------------------------------------------------------------------------------------

/** Nothing is found on clean bodies, and Euler's formula counts as by hand. */
void TestCleanBodies()
{
  const shapes::Mesh ball = shapes::Sphere({ 1, 2, 3 }, 2.0, 20);
  const sb::SurfaceCheckResult result = CheckMesh(ball);
  CHECK(Marked(result.TriangleMarks, [](std::uint16_t mark) { return mark != 0; }).empty());
  CHECK(Marked(result.PointMarks, [](std::uint16_t mark) { return mark != 0; }).empty());
  CHECK(result.Edges.empty() && result.SelfContacts.empty() && result.TouchingVertices.empty());
  CHECK(result.Report.Closed && !result.IsInsideOut);
  CHECK_EQUAL(result.Shells.size(), std::size_t(1));
  CHECK_EQUAL(result.Shells[0].NumberOfTriangles, 3200);
  CHECK_EQUAL(result.Shells[0].NumberOfEdges, 4800);
  CHECK_EQUAL(result.Shells[0].NumberOfVertices, 1602);
  CHECK_EQUAL(result.Genus(), 0);
  CHECK(std::abs(result.Shells[0].Volume - shapes::Volume(ball)) < 1e-12 * 32);
  CHECK(std::abs(result.Shells[0].Area - shapes::Area(ball)) < 1e-12 * 50);
}

/** Boxes in one another, each oriented at random: depth, parent and winding numbers by counting. */
void TestNesting()
{
  shapes::Random random(2);
  for (int round = 0; round < 40; ++round)
  {
    shapes::Mesh mesh;
    std::vector<int> signs;
    const int depth = 1 + round % 5;
    for (int i = 0; i < depth; ++i)
    {
      const shapes::Mesh box = shapes::Cube(i, 20 - i);
      signs.push_back(random() % 2 == 0 ? 1 : -1);
      mesh.Append(signs.back() > 0 ? box : box.Reversed());
    }
    mesh.Append(shapes::Cube(30, 31)); // beside them
    const sb::SurfaceCheckResult result = CheckMesh(mesh, 1 + round % 2);
    CHECK_EQUAL(result.Shells.size(), std::size_t(depth + 1));
    int winding = 0;
    for (std::size_t i = 0; i < std::size_t(depth); ++i)
    {
      const sb::Shell& shell = result.Shells[i];
      CHECK_EQUAL(shell.Depth, std::int32_t(i));
      CHECK_EQUAL(shell.Parent, std::int32_t(i) - 1);
      CHECK_EQUAL(shell.WindingInFront, signs[i] > 0 ? winding : winding - 1);
      winding += signs[i];
    }
    CHECK_EQUAL(result.Shells.back().Depth, 0);
    CHECK_EQUAL(result.Shells.back().WindingInFront, 0);
  }
}

/** A sphere in which some triangles are turned over: just these are the wrong way. */
void TestFlippedTriangles()
{
  shapes::Random random(3);
  for (int round = 0; round < 20; ++round)
  {
    shapes::Mesh ball = shapes::Sphere({ 0, 0, 0 }, 1.0, 8);
    std::set<std::size_t> turned;
    for (int i = 0; i < 1 + 5 * round; ++i)
    {
      turned.insert(random() % ball.Triangles.size());
    }
    for (const std::size_t i : turned)
    {
      std::swap(ball.Triangles[i][1], ball.Triangles[i][2]);
    }
    const sb::SurfaceCheckResult result = CheckMesh(ball);
    CHECK(Marked(result, sb::Defect::WrongWay) == turned);
    CHECK(result.Shells[0].IsOrientable && result.Genus() == 0);
    CHECK(!result.Report.Closed && result.IsContradictory);
  }
}

/** A band of quads whose ends are joined after so many half turns. */
shapes::Mesh Band(int quads, int halfTurns)
{
  shapes::Mesh mesh;
  for (int i = 0; i < quads; ++i)
  {
    const double around = 2 * 3.14159265358979323846 * i / quads;
    const double tilt = halfTurns * around / 2;
    for (const double side : { -0.3, 0.3 })
    {
      const double reach = 1 + side * std::cos(tilt);
      mesh.Points.push_back(
        { reach * std::cos(around), reach * std::sin(around), side * std::sin(tilt) });
    }
  }
  for (int i = 0; i < quads; ++i)
  {
    const bool isLast = i + 1 == quads;
    const bool isCrossed = isLast && halfTurns % 2 == 1;
    const std::int32_t a = 2 * i;
    const std::int32_t b = isLast ? (isCrossed ? 1 : 0) : a + 2;
    const std::int32_t c = isLast ? (isCrossed ? 0 : 1) : a + 3;
    mesh.Triangles.push_back({ a, b, c });
    mesh.Triangles.push_back({ a, c, a + 1 });
  }
  return mesh;
}

void TestBands()
{
  const sb::SurfaceCheckResult ring = CheckMesh(Band(40, 0));
  CHECK(ring.Shells[0].IsOrientable && ring.Counts.Rims == 2 && ring.Genus() == 0);
  const sb::SurfaceCheckResult moebius = CheckMesh(Band(40, 1));
  CHECK(!moebius.Shells[0].IsOrientable && moebius.Counts.Rims == 1 && moebius.Genus() == -1);
  CHECK_EQUAL(moebius.Counts.OneSidedShells, 1);
  CHECK_EQUAL(moebius.Counts.ContradictoryEdges, 1);
  CHECK_EQUAL(moebius.Counts.SelfIntersections, 0);
  CHECK_EQUAL(moebius.Counts.RimEdges, 80);
}

// --- bad input
// -----------------------------------------------------------------------------------------------------

void TestUnsoundTriangles()
{
  shapes::Mesh cube = shapes::Cube(0, 1);
  cube.Points.push_back({ std::numeric_limits<double>::quiet_NaN(), 0, 0 });
  cube.Triangles.insert(cube.Triangles.begin(), { 0, 1, 99 });
  cube.Triangles.insert(cube.Triangles.begin() + 5, { 0, 1, 8 });
  cube.Triangles.push_back({ -1, 1, 8 });
  const sb::SurfaceCheckResult result = CheckMesh(cube);
  CHECK((Marked(result, sb::Defect::BadIndex) == std::set<std::size_t>{ 0, 14 }));
  CHECK((Marked(result, sb::Defect::NotFinite) == std::set<std::size_t>{ 5 }));
  CHECK_EQUAL(result.Counts.NotFinitePoints, 1);
  CHECK(result.Report.Closed && result.Report.Volume == 1.0);
  CHECK_EQUAL(result.ShellOfTriangle[5], -1);
  CHECK_EQUAL(result.ShellOfTriangle[13], 0);

  // A million points that are no numbers take no longer than others.
  shapes::Mesh cloud = shapes::Cube(0, 1);
  cloud.Points.resize(1000000, cube.Points.back());
  CHECK_EQUAL(CheckMesh(cloud).Counts.NotFinitePoints, 999992);
}

void TestEmptyAndLargeNumbers()
{
  const sb::SurfaceCheckResult nothing = CheckMesh({});
  CHECK(nothing.Condition == sb::Status::Ok && nothing.Shells.empty());
  for (const double scale : { 1e-300, 1e-150, 1e150, 1e300 })
  {
    const sb::SurfaceCheckResult result =
      CheckMesh(shapes::Sphere({ 0, 0, 0 }, 1.0, 6).Scaled(scale));
    CHECK(result.Report.Closed && result.Edges.empty() && result.Counts.SelfIntersections == 0);
    CHECK_EQUAL(result.Counts.WithoutArea, 0);
  }
}

/** Polygons of four and more corners are copies of one another wherever they start. */
void TestDuplicatePolygons()
{
  shapes::Mesh mesh = shapes::Sheet({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
  mesh.Append(shapes::Sheet({ 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 0 })); // other diagonal
  mesh.Append(shapes::Sheet({ 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }));
  const std::vector<std::int32_t> firsts{ 0, 2, 4, 6 };
  sb::SerialExecutor executor;
  sb::Monitor monitor;
  const sb::SurfaceCheckResult result =
    sb::CheckSurface({ mesh.View(), { firsts.data(), 3 }, true }, executor, monitor);
  CHECK_EQUAL(result.Counts.DuplicateCells, 1);
  CHECK((Marked(result, sb::Defect::Duplicate) == std::set<std::size_t>{ 2, 3 }));
  CHECK_EQUAL(result.Counts.SelfIntersections, 0);
}

class Impatient : public sb::Monitor
{
public:
  explicit Impatient(int questions)
    : Left(questions)
  {
  }
  bool Aborted() override { return this->Left.fetch_sub(1) <= 0; }

private:
  std::atomic<int> Left;
};

void TestStopping()
{
  const shapes::Mesh ball = shapes::Sphere({ 0, 0, 0 }, 1.0, 40);
  sb::ThreadExecutor executor(2);
  for (int questions = 0; questions < 60; ++questions)
  {
    Impatient monitor(questions);
    sb::SurfaceCheckRequest request;
    request.Mesh = ball.View();
    request.Cells.NumberOfCells = request.Mesh.NumberOfTriangles;
    const sb::SurfaceCheckResult result = sb::CheckSurface(request, executor, monitor);
    const bool isWhole = result.Condition == sb::Status::Ok && result.Shells.size() == 1;
    const bool isNothing = result.Condition == sb::Status::Aborted && result.Shells.empty() &&
      result.TriangleMarks.empty();
    CHECK(isWhole || isNothing);
    CHECK(questions > 0 || isNothing);
  }
}

} // namespace

int main()
{
  TestRandomSoups();
  TestRoughNets();
  TestRamps();
  TestWhereTrianglesMeet();
  TestCleanBodies();
  TestNesting();
  TestFlippedTriangles();
  TestBands();
  TestUnsoundTriangles();
  TestEmptyAndLargeNumbers();
  TestDuplicatePolygons();
  TestStopping();
  return check::Verdict("TestSurfaceCheck");
}
