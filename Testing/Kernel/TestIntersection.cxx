// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestIntersection.cxx
 * @brief Curves and cut surfaces: the same surfaces, the curves are edges of them, and patches are
 * what a flood over the pieces finds that does not cross a curve.
 */
#include "Check.h"
#include "ContactCurves.h"
#include "Intersection.h"
#include "Shapes.h"
#include "ThreadExecutor.h"

#include <map>
#include <set>

namespace
{

using namespace shapes;
using sb::IntersectionResult;
using sb::SplitSurface;
using sb::Status;
using Edge = std::pair<Point, Point>;

sb::IntersectionRequest Request(const std::vector<Mesh>& surfaces, bool split = true)
{
  sb::IntersectionRequest request;
  for (const Mesh& surface : surfaces)
  {
    request.Operands.emplace_back();
    request.Operands.back().Mesh = surface.View();
    request.Split.push_back(split);
  }
  return request;
}

IntersectionResult Compute(const std::vector<Mesh>& surfaces, bool split = true)
{
  sb::SerialExecutor executor;
  sb::Monitor monitor;
  return sb::ComputeIntersection(Request(surfaces, split), executor, monitor);
}

Edge EdgeOf(const Point& a, const Point& b) { return a < b ? Edge{ a, b } : Edge{ b, a }; }

std::set<Edge> SegmentsOf(const sb::Curves& curves)
{
  std::set<Edge> segments;
  for (std::size_t line = 0; line + 1 < curves.Offsets.size(); ++line)
  {
    for (auto i = static_cast<std::size_t>(curves.Offsets[line]);
         i + 1 < static_cast<std::size_t>(curves.Offsets[line + 1]); ++i)
    {
      segments.insert(
        EdgeOf(curves.Points[static_cast<std::size_t>(curves.Connectivity[i])] + Point{},
          curves.Points[static_cast<std::size_t>(curves.Connectivity[i + 1])] + Point{}));
    }
  }
  return segments;
}

double LengthOf(const std::set<Edge>& segments)
{
  double length = 0.0;
  for (const Edge& edge : segments)
  {
    length += Length(edge.second - edge.first);
  }
  return length;
}

/** A cut surface as a mesh, with the patch of each triangle. */
struct Pieces
{
  Mesh Surface;
  std::vector<std::int32_t> Patches;
};

Pieces PiecesOf(const Mesh& given, const SplitSurface& split, std::size_t operand)
{
  Pieces pieces;
  for (const std::int32_t point : split.KeptPoints[operand])
  {
    pieces.Surface.Points.push_back(given.Points[static_cast<std::size_t>(point)]);
  }
  for (const sb::InterpolatedPoint& point : split.Interpolated)
  {
    pieces.Surface.Points.push_back(point.Position);
    CHECK_EQUAL(point.Operand, std::int32_t(operand));
  }
  CHECK_EQUAL(split.IsOnCurve.size(), pieces.Surface.Points.size());
  for (std::size_t i = 0; i < given.Triangles.size(); ++i)
  {
    if (split.Fates[operand][i] == sb::Fate::Kept)
    {
      Corners t = given.Triangles[i];
      for (std::int32_t& corner : t)
      {
        corner = split.PointMap[operand][static_cast<std::size_t>(corner)];
      }
      pieces.Surface.Triangles.push_back(t);
      pieces.Patches.push_back(split.PatchOfTriangle[i]);
    }
    else
    {
      CHECK_EQUAL(split.PatchOfTriangle[i], -1);
    }
  }
  CHECK_EQUAL(split.PatchOfPiece.size(), split.Split.Corners.size());
  for (std::size_t i = 0; i < split.Split.Corners.size(); ++i)
  {
    CHECK_EQUAL(split.Split.Operand[i], std::int32_t(operand));
    CHECK(split.Split.Reversed[i] == 0);
    pieces.Surface.Triangles.push_back(split.Split.Corners[i]);
    pieces.Patches.push_back(split.PatchOfPiece[i]);
  }
  return pieces;
}

/** Patches the slow way: flood from triangle to triangle across edges that are not on a curve, and
 * through points off the curves. */
std::vector<std::int32_t> Flood(const Mesh& mesh, const std::set<Edge>& curves)
{
  std::set<Point> onCurve;
  for (const Edge& edge : curves)
  {
    onCurve.insert(edge.first);
    onCurve.insert(edge.second);
  }
  std::map<Edge, std::vector<std::size_t>> acrossEdges;
  std::map<Point, std::vector<std::size_t>> aroundPoints;
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point a = mesh.At(mesh.Triangles[i], k) + Point{};
      const Edge edge = EdgeOf(a, mesh.At(mesh.Triangles[i], (k + 1) % 3) + Point{});
      if (curves.count(edge) == 0)
      {
        acrossEdges[edge].push_back(i);
      }
      if (onCurve.count(a) == 0)
      {
        aroundPoints[a].push_back(i);
      }
    }
  }
  std::vector<std::vector<std::size_t>> neighbours(mesh.Triangles.size());
  const auto relate = [&](const std::vector<std::size_t>& group) {
    for (const std::size_t i : group)
    {
      neighbours[i].push_back(group.front());
      neighbours[group.front()].push_back(i);
    }
  };
  for (const auto& entry : acrossEdges)
  {
    relate(entry.second);
  }
  for (const auto& entry : aroundPoints)
  {
    relate(entry.second);
  }
  std::vector<std::int32_t> patch(mesh.Triangles.size(), -1);
  std::int32_t count = 0;
  for (std::size_t seed = 0; seed < patch.size(); ++seed)
  {
    std::vector<std::size_t> front{ seed };
    while (!front.empty())
    {
      const std::size_t i = front.back();
      front.pop_back();
      if (patch[i] < 0)
      {
        patch[i] = count;
        front.insert(front.end(), neighbours[i].begin(), neighbours[i].end());
      }
    }
    count += patch[seed] == count;
  }
  return patch;
}

/** Whether two numberings divide in the same way. */
bool AreSamePartition(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b)
{
  std::map<std::int32_t, std::int32_t> there;
  std::map<std::int32_t, std::int32_t> back;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    if (there.emplace(a[i], b[i]).first->second != b[i] ||
      back.emplace(b[i], a[i]).first->second != a[i])
    {
      return false;
    }
  }
  return a.size() == b.size();
}

void CheckSplit(const Mesh& given, const SplitSurface& split, std::size_t operand,
  const std::set<Edge>& curves, bool crossesItself)
{
  const Pieces pieces = PiecesOf(given, split, operand);
  CHECK(std::abs(Area(pieces.Surface) - Area(given)) <= 1e-12 * Area(given));
  CHECK_EQUAL(NumberOfOpenEdges(pieces.Surface) == 0, NumberOfOpenEdges(given) == 0);

  std::set<Edge> edges;
  std::set<std::int32_t> patches;
  for (std::size_t i = 0; i < pieces.Surface.Triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.insert(EdgeOf(pieces.Surface.At(pieces.Surface.Triangles[i], k) + Point{},
        pieces.Surface.At(pieces.Surface.Triangles[i], (k + 1) % 3) + Point{}));
    }
    patches.insert(pieces.Patches[i]);
  }
  CHECK(std::includes(edges.begin(), edges.end(), curves.begin(), curves.end()));
  CHECK_EQUAL(patches.size(), std::size_t(split.NumberOfPatches));
  CHECK(
    patches.empty() || (*patches.begin() == 0 && *patches.rbegin() == split.NumberOfPatches - 1));
  if (!crossesItself)
  {
    CHECK(AreSamePartition(pieces.Patches, Flood(pieces.Surface, curves)));
  }

  std::set<Point> ends;
  std::set<Point> marked;
  for (const Edge& edge : curves)
  {
    ends.insert(edge.first);
    ends.insert(edge.second);
  }
  for (std::size_t i = 0; i < split.IsOnCurve.size(); ++i)
  {
    if (split.IsOnCurve[i])
    {
      marked.insert(pieces.Surface.Points[i] + Point{});
    }
  }
  CHECK(marked == ends);
}

std::set<Edge> Check(const std::vector<Mesh>& surfaces, bool crossesItself = false)
{
  const IntersectionResult result = Compute(surfaces);
  CHECK(result.Condition == Status::Ok);
  const std::set<Edge> curves = SegmentsOf(result.Intersection);
  CHECK_EQUAL(curves.size(), result.Intersection.Segments.size());
  CHECK_EQUAL(result.Surfaces.size(), surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    CheckSplit(surfaces[i], result.Surfaces[i], i, curves, crossesItself);
  }
  CHECK(SegmentsOf(Compute(surfaces, false).Intersection) == curves);
  return curves;
}

/** The same from either side. */
std::set<Edge> CheckBoth(const Mesh& a, const Mesh& b, bool crossesItself = false)
{
  const std::set<Edge> curves = Check({ a, b }, crossesItself);
  CHECK(Check({ b, a }, crossesItself) == curves);
  return curves;
}

Mesh Joined(const Mesh& a, const Mesh& b)
{
  Mesh both = a;
  for (const Corners& t : b.Triangles)
  {
    both.AddTriangle(b.At(t, 0), b.At(t, 1), b.At(t, 2));
  }
  return both;
}

void CheckBoxes()
{
  const Mesh cube = Cube(0, 4);
  CHECK_EQUAL(LengthOf(CheckBoth(cube, Cube(2, 6))), 12.0);
  CHECK_EQUAL(LengthOf(CheckBoth(cube, Box({ 1, 1, -1 }, { 3, 3, 5 }))), 16.0);
  CHECK_EQUAL(LengthOf(CheckBoth(cube, Box({ 1, 1, 4 }, { 3, 3, 6 }))), 8.0);
  CHECK_EQUAL(LengthOf(CheckBoth(cube, Box({ 0, 0, 4 }, { 4, 4, 6 }))), 16.0);
  CHECK_EQUAL(LengthOf(CheckBoth(cube, Cube(0, 2))), 12.0);
  CHECK(CheckBoth(cube, cube).empty());
  CHECK(CheckBoth(cube, Cube(4, 6)).empty());
  CHECK(CheckBoth(cube, Cube(5, 6)).empty());
  CHECK_EQUAL(Compute({ cube, Box({ 1, 1, 4 }, { 3, 5, 6 }) }).Surfaces[0].NumberOfPatches, 2);
  CHECK_EQUAL(Compute({ cube, Box({ 1, 1, -1 }, { 3, 3, 5 }) }).Surfaces[0].NumberOfPatches, 3);
  CHECK_EQUAL(Compute({ cube, cube }).Surfaces[0].NumberOfPatches, 1);
}

void CheckOpenAndTurned()
{
  const Mesh plane = Sheet({ -9, -9, 1 }, { 9, -9, 1 }, { 9, 9, 1 }, { -9, 9, 1 });
  CHECK_EQUAL(LengthOf(CheckBoth(Cube(0, 4), plane)), 16.0);
  const Mesh part = Sheet({ -9, 1, 1 }, { 2, 1, 1 }, { 2, 3, 1 }, { -9, 3, 1 });
  CHECK_EQUAL(LengthOf(CheckBoth(Cube(0, 4), part)), 2.0);
  CHECK_EQUAL(Compute({ Cube(0, 4), part }).Surfaces[0].NumberOfPatches, 1);

  Mesh turned = Cube(0, 4);
  for (std::size_t i = 0; i < turned.Triangles.size(); i += 3)
  {
    std::swap(turned.Triangles[i][1], turned.Triangles[i][2]);
  }
  const IntersectionResult result = Compute({ turned, plane });
  CHECK(result.Condition == Status::Ok && result.Remarks.empty());
  CHECK(SegmentsOf(result.Intersection) == Check({ Cube(0, 4), plane }));
  const Mesh pieces = PiecesOf(turned, result.Surfaces[0], 0).Surface;
  CHECK(std::abs(Area(pieces) - Area(turned)) < 1e-12);

  Mesh inwards = Cube(0, 4);
  for (Corners& t : inwards.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  CHECK_EQUAL(LengthOf(CheckBoth(inwards, plane)), 16.0);
}

void CheckSelf()
{
  const Mesh crossing = Joined(Cube(0, 4), Cube(2, 6));
  CHECK_EQUAL(LengthOf(Check({ crossing })), 12.0);
  CHECK_EQUAL(Compute({ crossing }).Surfaces[0].NumberOfPatches, 4);
  CHECK(Check({ Cube(0, 4) }).empty());
  CHECK(Check({ Sphere({ 0, 0, 0 }, 1.0, 8) }).empty());
  // Faces that meet others' corners: untouched ones beside them have corners on the curve.
  const Mesh fan = ConvexHull({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 } });
  const Mesh blade = Sheet({ 0, 0, 0 }, { 4, 4, -4 }, { 4, 4, 4 }, { 2, 2, 4 });
  CHECK(!Check({ Joined(fan, blade) }).empty());
  Mesh welded = fan;
  welded.Points.push_back({ 3, 3, 1 });
  welded.Points.push_back({ 3, 3, -1 });
  const auto tip = static_cast<std::int32_t>(fan.Points.size());
  welded.Triangles.push_back({ 0, tip, tip + 1 }); // shares a corner with the faces that it crosses
  CHECK(!Check({ welded }).empty());
  // Cut by another surface, where it crosses itself, too: only the mutual curves, with branch
  // points.
  const Mesh plane = Sheet({ -9, -9, 3 }, { 9, -9, 3 }, { 9, 9, 3 }, { -9, 9, 3 });
  const std::set<Edge> curves = CheckBoth(crossing, plane, true);
  CHECK_EQUAL(LengthOf(curves), 32.0);
  CHECK_EQUAL(Compute({ crossing, plane }).Surfaces[1].NumberOfPatches, 4);
}

void CheckRandom()
{
  Random random(3);
  std::size_t curves = 0;
  for (int round = 0; round < 120; ++round)
  {
    const Mesh a = Rotated(RandomConvex(random, -2, 2, 6), RandomRotation(random));
    const Mesh b = Rotated(RandomConvex(random, -2, 2, 6), RandomRotation(random));
    curves += !CheckBoth(a, b).empty();
    Check({ Joined(a, b) });
    Mesh pinned = b; // one corner at the other's
    for (Point& p : pinned.Points)
    {
      p = p - b.Points.front() + a.Points.front();
    }
    Check({ Joined(a, pinned) });
    CheckBoth(a, pinned);
  }
  for (int round = 0; round < 200; ++round)
  {
    const Mesh a = RandomConvex(random, -2, 2, Between(random, 4, 7));
    const Mesh b = Between(random, 0, 1) == 0 ? RandomBox(random, -2, 2)
                                              : RandomConvex(random, -2, 2, Between(random, 4, 7));
    curves += !CheckBoth(a, b).empty();
  }
  for (int round = 0; round < 60; ++round)
  {
    const Mesh boxes = RandomBoxes(random, -3, 3, 3);
    curves += !CheckBoth(boxes, RandomConvex(random, -3, 3, 6), true).empty();
    Check({ boxes }, true);
  }
  CHECK(curves > 300);
}

bool AreSame(const IntersectionResult& a, const IntersectionResult& b)
{
  bool same = a.Intersection.Points == b.Intersection.Points &&
    a.Intersection.Connectivity == b.Intersection.Connectivity &&
    a.Intersection.Offsets == b.Intersection.Offsets && a.Surfaces.size() == b.Surfaces.size();
  for (std::size_t i = 0; same && i < a.Surfaces.size(); ++i)
  {
    const SplitSurface& l = a.Surfaces[i];
    const SplitSurface& r = b.Surfaces[i];
    same = l.Fates == r.Fates && l.PointMap == r.PointMap && l.KeptPoints == r.KeptPoints &&
      l.Split.Corners == r.Split.Corners && l.Split.Parent == r.Split.Parent &&
      l.PatchOfTriangle == r.PatchOfTriangle && l.PatchOfPiece == r.PatchOfPiece &&
      l.IsOnCurve == r.IsOnCurve && l.HasCurveEdge == r.HasCurveEdge;
    for (std::size_t k = 0; same && k < l.Interpolated.size(); ++k)
    {
      same = l.Interpolated[k].Position == r.Interpolated[k].Position &&
        l.Interpolated[k].Weights == r.Interpolated[k].Weights;
    }
  }
  return same;
}

void CheckThreads()
{
  const std::vector<Mesh> surfaces{ Sphere({ 0, 0, 0 }, 1.0, 60),
    Sphere({ 0.3, 0.2, 0.1 }, 1.0, 60) };
  for (const bool split : { false, true })
  {
    const IntersectionResult wanted = Compute(surfaces, split);
    CHECK(!wanted.Intersection.Segments.empty());
    for (const int threads : { 2, 3, 8 })
    {
      sb::ThreadExecutor executor(threads);
      sb::Monitor monitor;
      CHECK(AreSame(wanted, sb::ComputeIntersection(Request(surfaces, split), executor, monitor)));
    }
  }
}

/** Whether the curves can be had without cutting faces; then they are those of the cut faces. */
bool AreFoundWithoutCuts(const Mesh& a, const Mesh& b)
{
  CutStage stage({ { a }, { b }, sb::Operation::Union });
  sb::PointTable nodes;
  const auto found = sb::FindSegmentsOfContacts(stage.World, stage.Contacts, nodes, stage.Executor);
  if (!found)
  {
    return false;
  }
  const auto wanted = sb::FindCurveSegments(stage.World, stage.Cuts, sb::CurveKind::Mutual);
  CHECK_EQUAL(found->size(), wanted.size());
  for (std::size_t i = 0; i < std::min(found->size(), wanted.size()); ++i)
  {
    CHECK((*found)[i].Ends == wanted[i].Ends);
    CHECK((*found)[i].Makers.Operand == wanted[i].Makers.Operand);
    CHECK((*found)[i].Makers.Triangle == wanted[i].Makers.Triangle);
  }
  return true;
}

void CheckWithoutCuts()
{
  Random random(7);
  int found = 0;
  for (int round = 0; round < 100; ++round)
  {
    found += AreFoundWithoutCuts(Rotated(RandomConvex(random, -2, 2, 6), RandomRotation(random)),
      Rotated(RandomConvex(random, -2, 2, 6), RandomRotation(random)));
  }
  CHECK(found > 95);
  const Mesh plane = Sheet({ -9, -9, 1 }, { 9, -9, 1 }, { 9, 9, 1 }, { -9, 9, 1 });
  CHECK(AreFoundWithoutCuts(Sphere({ 0, 0, 0 }, 1.0, 30), Sphere({ 0.3, 0.2, 0.1 }, 1.0, 30)));
  CHECK(AreFoundWithoutCuts(Sphere({ 0, 0, 0.7 }, 1.0, 30), plane));
  // Contacts in one line, one after the other, are no obstacle; areas in common are, and faces that
  // cross on another one.
  CHECK(AreFoundWithoutCuts(Cube(0, 4), plane));
  CHECK(!AreFoundWithoutCuts(Cube(0, 4), Box({ 1, 1, 4 }, { 3, 3, 6 })));
  CHECK(!AreFoundWithoutCuts(Joined(Cube(0, 4), Box({ 2, 2, -2 }, { 6, 6, 2 })), plane));
  for (int round = 0; round < 200; ++round) // whatever is found is right, in all degenerate cases
  {
    AreFoundWithoutCuts(RandomBoxes(random, -3, 3, 2), RandomConvex(random, -3, 3, 6));
    AreFoundWithoutCuts(RandomConvex(random, -2, 2, 5), RandomConvex(random, -2, 2, 5));
  }
}

class Impatient : public sb::Monitor
{
public:
  bool Aborted() override { return true; }
};

void CheckBadInput()
{
  Mesh bad = Cube(0, 4);
  bad.Triangles[3][1] = 99;
  CHECK(Compute({ bad, Cube(2, 6) }).Condition == Status::BadIndex);
  bad = Cube(0, 4);
  bad.Points[2][0] = std::nan("");
  CHECK(Compute({ Cube(2, 6), bad }).Condition == Status::BadCoordinate);
  CHECK(Compute({}).Condition == Status::BadRequest);
  CHECK(Compute({ Mesh(), Cube(0, 4) }).Condition == Status::EmptyOperand);
  CHECK(Compute({ Mesh(), Mesh() }).Intersection.Segments.empty());

  const std::vector<Mesh> surfaces{ Cube(0, 4), Cube(2, 6) };
  sb::IntersectionRequest request = Request(surfaces);
  request.Split.pop_back();
  sb::SerialExecutor executor;
  sb::Monitor monitor;
  CHECK(sb::ComputeIntersection(request, executor, monitor).Condition == Status::BadRequest);
  Impatient impatient;
  const IntersectionResult stopped =
    sb::ComputeIntersection(Request(surfaces), executor, impatient);
  CHECK(stopped.Condition == Status::Aborted && stopped.Surfaces.empty());
  CHECK(stopped.Intersection.Segments.empty());
}

} // namespace

int main()
{
  CheckBoxes();
  CheckOpenAndTurned();
  CheckSelf();
  CheckRandom();
  CheckWithoutCuts();
  CheckThreads();
  CheckBadInput();
  return check::Verdict("TestIntersection");
}
