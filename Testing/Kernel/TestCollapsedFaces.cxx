// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCollapsedFaces.cxx
 * @brief Triangles without area that stitch a surface together change nothing: closed stays closed,
 * volumes stay.
 */
#include "Check.h"
#include "CollapsedFaces.h"
#include "Shapes.h"

namespace
{

using namespace shapes;
using sb::Operation;

/**
 * Split an edge of one triangle, not of its neighbour, and close the gap by a triangle without
 * area. `quarter` of the way along the edge; the coordinates have to be multiples of four for the
 * new point to be on the line exactly.
 */
void SplitOneSide(Mesh& mesh, std::size_t triangle, std::size_t edge, int quarter)
{
  const Corners t = mesh.Triangles[triangle];
  const std::int32_t from = t[edge];
  const std::int32_t to = t[(edge + 1) % 3];
  const std::int32_t apex = t[(edge + 2) % 3];
  const Point& a = mesh.Points[static_cast<std::size_t>(from)];
  const Point& b = mesh.Points[static_cast<std::size_t>(to)];
  const auto middle = static_cast<std::int32_t>(mesh.Points.size());
  mesh.Points.push_back(a + (quarter / 4.0) * (b - a));
  mesh.Triangles[triangle] = { from, middle, apex };
  mesh.Triangles.push_back({ middle, to, apex });
  mesh.Triangles.push_back({ from, to, middle });
}

bool HasArea(const Mesh& mesh, std::size_t triangle)
{
  const Corners& t = mesh.Triangles[triangle];
  return Length(Cross(mesh.At(t, 1) - mesh.At(t, 0), mesh.At(t, 2) - mesh.At(t, 0))) > 0.0;
}

void CheckFinding()
{
  Mesh box = Cube(0, 4);
  SplitOneSide(box, 2, 0, 2); // an edge of the top
  const std::size_t stitch = box.Triangles.size() - 1;
  CHECK(!HasArea(box, stitch));
  CHECK_EQUAL(NumberOfOpenEdges(box), 0);
  const Point middle = box.Points.back();

  // Near another surface it is found, and its middle becomes a point on the neighbour's edge.
  const CutStage near({ { box }, { Box({ 1, -1, 3 }, { 3, 5, 6 }) }, Operation::Union });
  CHECK_EQUAL(near.Collapsed.size(), std::size_t(near.World.NumberOfFaces()));
  for (std::size_t i = 0; i < near.Collapsed.size(); ++i)
  {
    CHECK_EQUAL(int(near.Collapsed[i]), i == stitch ? 1 : 0);
  }
  int stitches = 0;
  for (const sb::Contact& contact : near.Contacts.Contacts)
  {
    if (contact.Face == contact.Other)
    {
      ++stitches;
      CHECK(sb::IsEdge(contact.Ends[0]) && contact.Ends[0] == contact.Ends[1]);
      const sb::ContactPoint& point =
        near.Contacts.Points[static_cast<std::size_t>(contact.Points[0])];
      CHECK_EQUAL(point.Vertex, std::int32_t(box.Points.size() - 1));
      const auto edge = static_cast<std::size_t>(contact.Ends[0] - 3);
      const Corners& t = box.Triangles[static_cast<std::size_t>(contact.Face)];
      CHECK(0.5 * (box.At(t, edge) + box.At(t, (edge + 1) % 3)) == middle);
    }
    CHECK(std::size_t(contact.Face) != stitch && std::size_t(contact.Other) != stitch);
  }
  CHECK_EQUAL(stitches, 1);
  CHECK(std::is_sorted(near.Contacts.Contacts.begin(), near.Contacts.Contacts.end(),
    [](const sb::Contact& l, const sb::Contact& r) {
      return std::make_pair(l.Face, l.Other) < std::make_pair(r.Face, r.Other);
    }));

  // Far from all others it is of no interest.
  const CutStage far({ { box }, { Cube(-1, 1) }, Operation::Union });
  CHECK(far.Collapsed.empty());
}

/** A chain of them: those beyond the near one are collapsed with it, as far as they hang together.
 */
void CheckSpreading()
{
  Mesh box = Cube(0, 64);
  SplitOneSide(box, 2, 0, 2);
  SplitOneSide(box, box.Triangles.size() - 1, 0, 1); // the stitch itself is split and stitched
  SplitOneSide(box, box.Triangles.size() - 1, 0, 3);
  CHECK_EQUAL(NumberOfOpenEdges(box), 0);
  std::size_t flat = 0;
  for (std::size_t i = 0; i < box.Triangles.size(); ++i)
  {
    flat += !HasArea(box, i);
  }
  CHECK_EQUAL(flat, 5u);
  const CutStage near({ { box }, { Box({ 60, -2, 60 }, { 66, 2, 66 }) }, Operation::Union });
  CHECK(!near.Collapsed.empty());
  CHECK_EQUAL(std::size_t(std::count(near.Collapsed.begin(), near.Collapsed.end(), 1)), flat);
}

/** The measured T-junction: a box with one, cut by another box, in every operation. */
void CheckOneJunction()
{
  Random random(1);
  const Mesh clean = Cube(0, 4);
  for (std::size_t triangle = 0; triangle < 12; ++triangle)
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      Mesh box = clean;
      SplitOneSide(box, triangle, edge, 2);
      for (int round = 0; round < 6; ++round)
      {
        const Mesh other = RandomBox(random, -1, 5);
        for (const Operation op : { Operation::Union, Operation::Intersection,
               Operation::Difference, Operation::SymmetricDifference, Operation::Resolve })
        {
          const Mesh result = ComputeMesh({ { box }, { other }, op });
          CHECK_EQUAL(NumberOfOpenEdges(result), 0);
          const double volume = result.Triangles.empty() ? 0.0 : Volume(result);
          CHECK(std::abs(volume - VolumeOf({ { clean }, { other }, op })) < 1e-9);
        }
      }
    }
  }
}

/** Many, over and beside each other, on both operands. */
void CheckManyJunctions()
{
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    const long failures = check::Total().Failures;
    Random random(seed);
    const auto body = [&] {
      return (Between(random, 0, 1) == 0 ? RandomBox(random, -2, 2)
                                         : RandomConvex(random, -2, 2, Between(random, 4, 6)))
        .Scaled(1024.0);
    };
    const auto stitched = [&](Mesh mesh) {
      for (int i = Between(random, 1, 6); i > 0; --i)
      {
        const std::size_t triangle = Between(random, 0, 1) == 0
          ? mesh.Triangles.size() - 1
          : static_cast<std::size_t>(random() % mesh.Triangles.size());
        SplitOneSide(
          mesh, triangle, static_cast<std::size_t>(Between(random, 0, 2)), Between(random, 1, 3));
      }
      return mesh;
    };
    const Mesh a = body();
    const Mesh b = body();
    const Mesh stitchedA = stitched(a);
    const Mesh stitchedB = stitched(b);
    CHECK_EQUAL(NumberOfOpenEdges(stitchedA), 0);
    const double scale = Volume(a) + Volume(b);
    for (const Operation op : { Operation::Union, Operation::Intersection, Operation::Difference,
           Operation::SymmetricDifference, Operation::Resolve })
    {
      const double expected = VolumeOf({ { a }, { b }, op });
      for (const Case& given : { Case{ { stitchedA }, { b }, op }, Case{ { a }, { stitchedB }, op },
             Case{ { stitchedA }, { stitchedB }, op } })
      {
        const Mesh result = ComputeMesh(given);
        CHECK_EQUAL(NumberOfOpenEdges(result), 0);
        const double volume = result.Triangles.empty() ? 0.0 : Volume(result);
        CHECK(std::abs(volume - expected) < 1e-9 * scale);
      }
    }
    if (check::Total().Failures > failures && failures < 100)
    {
      std::cerr << "  in CheckManyJunctions, seed " << seed << "\n";
    }
  }
}

} // namespace

int main()
{
  CheckFinding();
  CheckSpreading();
  CheckOneJunction();
  CheckManyJunctions();
  return check::Verdict("TestCollapsedFaces");
}
