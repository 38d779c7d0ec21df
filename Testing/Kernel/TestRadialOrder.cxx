// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRadialOrder.cxx
 * @brief Half-planes around an edge come in the order of their angles; those that coincide in the
 * order of their layers.
 */
#include "Check.h"
#include "PointTable.h"
#include "RadialOrder.h"
#include "Shapes.h"

#include <cmath>

namespace
{

using namespace shapes;

/** Directions across the edge, as integer multiples of two axes. */
struct Direction
{
  int X;
  int Y;
};

double Angle(const Direction& d) { return std::atan2(double(d.Y), double(d.X)); }

/** In (0, 2 pi], or 0 where the directions are the same: directions this short differ by more than
 * rounding does. */
double AngleBetween(const Direction& from, const Direction& to)
{
  const double turn = Angle(to) - Angle(from);
  return std::abs(turn) < 1e-9 ? 0.0 : turn < 0.0 ? turn + 2.0 * 3.14159265358979323846 : turn;
}

/** A face at the edge: one half-plane if the edge is one of its own, two if it runs through its
 * inside. */
struct FaceAtEdge
{
  Direction Towards;
  bool Through;
  bool RunsUp; ///< on the side of Towards
};

/** A frame of integer vectors, right-handed, the third along the edge. */
struct Frame
{
  Point X;
  Point Y;
  Point Z;

  Point operator()(double x, double y, double z) const
  {
    return x * this->X + y * this->Y + z * this->Z;
  }
};

constexpr double Low = -3.0;
constexpr double High = 5.0;

Mesh MakeFace(const Frame& frame, const FaceAtEdge& face, Random& random)
{
  const double x = face.Towards.X;
  const double y = face.Towards.Y;
  const double reach = Between(random, 1, 3);
  const Point tip = frame(reach * x, reach * y, Between(random, -9, 9));
  // Running up: low end, high end, then the tip on the left.
  Mesh mesh = face.Through ? Triangle(frame(-x, -y, Low - 20), frame(-x, -y, High + 20), tip)
                           : Triangle(frame(0, 0, Low - Between(random, 0, 3)),
                               frame(0, 0, High + Between(random, 0, 3)), tip);
  if (!face.RunsUp)
  {
    mesh = mesh.Reversed();
  }
  std::rotate(mesh.Triangles[0].begin(), mesh.Triangles[0].begin() + Between(random, 0, 2),
    mesh.Triangles[0].end());
  return mesh;
}

/** What the kernel is asked to sort, and what is known of it. */
struct Known
{
  Direction Towards;
  bool TurnsAlongAxis; ///< the plane's dominant axis points in the direction of turning
};

void CheckAround(const Frame& frame, const std::vector<FaceAtEdge>& faces, Random& random)
{
  Case given;
  for (const FaceAtEdge& face : faces)
  {
    given.Inputs.push_back(MakeFace(frame, face, random));
  }
  Stage stage(given);
  // The edge's ends in lattice units, found from any face's scale.
  const double scale = stage.World.Grid().Scale;
  sb::PointTable table;
  const auto node = [&](double z) {
    const Point p = scale * frame(0, 0, z);
    return table.Insert({ { sb::ExactPoint::Vertex(p.data()), -1 } }, stage.Executor).front();
  };
  const sb::NodeId low = node(Low);
  const sb::NodeId high = node(High);

  std::vector<sb::HalfPlane> pieces;
  std::vector<Known> known; // by region
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int side = 0; side < (faces[i].Through ? 2 : 1); ++side)
    {
      const int sign = side == 0 ? 1 : -1;
      const Direction towards{ sign * faces[i].Towards.X, sign * faces[i].Towards.Y };
      const bool runsUp = faces[i].RunsUp == (side == 0);
      // The direction of turning is across the half-plane: edge x direction.
      const Point turning = Cross(frame(0, 0, 1), frame(towards.X, towards.Y, 0));
      std::size_t axis = 0;
      for (std::size_t k = 1; k < 3; ++k)
      {
        axis = std::abs(turning[k]) > std::abs(turning[axis]) ? k : axis;
      }
      const auto region = static_cast<std::int32_t>(known.size());
      pieces.push_back({ region, static_cast<std::int32_t>(i), runsUp });
      known.push_back({ towards, turning[axis] > 0 });
    }
  }
  std::shuffle(pieces.begin(), pieces.end(), random);
  const std::vector<sb::HalfPlane> before = pieces;
  sb::RadialOrder order(stage.World, table);
  order.Sort(low, high, pieces);

  // A permutation.
  CHECK_EQUAL(pieces.size(), before.size());
  std::vector<int> seen(known.size(), 0);
  for (const sb::HalfPlane& piece : pieces)
  {
    ++seen[static_cast<std::size_t>(piece.Region)];
  }
  CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(seen.size()));

  const auto of = [&](std::size_t i) -> const Known& {
    return known[static_cast<std::size_t>(pieces[i % pieces.size()].Region)];
  };
  // Once around, and no more: all steps together are one full turn.
  double sum = 0.0;
  bool allSame = true;
  int startsOfLayers = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const double step = AngleBetween(of(i).Towards, of(i + 1).Towards);
    sum += step;
    if (step != 0.0)
    {
      allSame = false;
      continue;
    }
    const std::int32_t here = pieces[i].Face;
    const std::int32_t next = pieces[(i + 1) % pieces.size()].Face;
    startsOfLayers += (here < next) != of(i).TurnsAlongAxis;
  }
  if (allSame)
  {
    CHECK_EQUAL(startsOfLayers, 1); // from the last layer back to the first
  }
  else
  {
    CHECK_EQUAL(startsOfLayers, 0);
    CHECK(std::abs(sum - 2.0 * 3.14159265358979323846) < 1e-9);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    for (std::size_t j = 0; j < pieces.size(); ++j)
    {
      const Direction& a = of(i).Towards;
      const Direction& b = of(j).Towards;
      const int cross = a.X * b.Y - a.Y * b.X;
      CHECK_EQUAL(order.Turn(i, j), (cross > 0) - (cross < 0));
    }
  }
  // Wherever it starts, and whichever order they came in: the same circle.
  std::vector<sb::HalfPlane> again = before;
  std::shuffle(again.begin(), again.end(), random);
  order.Sort(low, high, again);
  const auto start = std::find_if(again.begin(), again.end(),
    [&](const sb::HalfPlane& piece) { return piece.Region == pieces.front().Region; });
  std::rotate(again.begin(), start, again.end());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    CHECK_EQUAL(again[i].Region, pieces[i].Region);
  }
}

Frame RandomFrame(Random& random)
{
  for (;;)
  {
    const Frame frame{ IntegerPoint(random, -2, 2), IntegerPoint(random, -2, 2),
      IntegerPoint(random, -2, 2) };
    if (Dot(Cross(frame.X, frame.Y), frame.Z) > 0.0)
    {
      return frame;
    }
  }
}

} // namespace

int main()
{
  Random random(1);
  const Frame upright{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (int round = 0; round < 3000; ++round)
  {
    const Frame frame = round % 3 == 0 ? upright : RandomFrame(random);
    const int extent = round % 2 == 0 ? 1 : 4; // few directions, so that they coincide, or many
    std::vector<FaceAtEdge> faces;
    for (int i = Between(random, 1, 7); i >= 0; --i)
    {
      FaceAtEdge face{ { Between(random, -extent, extent), Between(random, -extent, extent) },
        Between(random, 0, 2) == 0, Between(random, 0, 1) == 0 };
      if (face.Towards.X == 0 && face.Towards.Y == 0)
      {
        face.Towards.X = 1;
      }
      faces.push_back(face);
    }
    CheckAround(frame, faces, random);
  }
  return check::Verdict("TestRadialOrder");
}
