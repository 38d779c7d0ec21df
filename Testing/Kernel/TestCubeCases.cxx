// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCubeCases.cxx
 * @brief Cubes filled by all cases side by side make closed oriented manifolds, and all triangles
 * face away from what is inside.
 */
#include "Check.h"
#include "CubeCases.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

using Place = std::array<int, 3>;

/** The middle of an edge of the cube at `cube`, in half units. */
Place MiddleOf(int edge, const Place& cube)
{
  const int corner = sb::LowerCornerOfCubeEdge(edge);
  Place place{ 2 * cube[0] + 2 * (corner & 1), 2 * cube[1] + (corner & 2),
    2 * cube[2] + (corner >> 1 & 2) };
  ++place[static_cast<std::size_t>(edge / 4)];
  return place;
}

/** The loops of a case filled in one of the possible ways each. */
sb::CubeFill SomeFill(int inside, unsigned choice)
{
  sb::CubeFill triangles;
  for (const sb::CubeLoop& loop : sb::LoopsOfCube(inside))
  {
    const sb::CubeFill& fill = loop[choice % loop.size()];
    triangles.insert(triangles.end(), fill.begin(), fill.end());
  }
  return triangles;
}

bool IsCrossed(int edge, int inside)
{
  const int lower = sb::LowerCornerOfCubeEdge(edge);
  return (inside >> lower & 1) != (inside >> (lower | 1 << edge / 4) & 1);
}

void EachCaseUsesItsCrossedEdges()
{
  for (int inside = 0; inside < 256; ++inside)
  {
    for (unsigned choice = 0; choice < 12; ++choice)
    {
      std::set<int> used;
      for (const sb::CubeTriangle& triangle : SomeFill(inside, choice))
      {
        used.insert(triangle.begin(), triangle.end());
      }
      for (int edge = 0; edge < 12; ++edge)
      {
        CHECK_EQUAL(used.count(edge) == 1, IsCrossed(edge, inside));
      }
    }
  }
}

/** Of one inside corner, the triangle's normal points away from it. */
void TrianglesFaceOutwards()
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const sb::CubeFill triangles = SomeFill(1 << corner, 0);
    CHECK_EQUAL(triangles.size(), 1u);
    std::array<Place, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
    {
      p[k] = MiddleOf(triangles[0][k], { 0, 0, 0 });
    }
    int volume = 0; // of the tetrahedron with the corner: positive if seen from outside
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::size_t b = (a + 1) % 3;
      const std::size_t c = (a + 2) % 3;
      const int from = 2 * (corner >> a & 1) - p[0][a];
      volume -= from *
        ((p[1][b] - p[0][b]) * (p[2][c] - p[0][c]) - (p[1][c] - p[0][c]) * (p[2][b] - p[0][b]));
    }
    CHECK(volume > 0);
  }
}

/** Random corners in a block of cubes, outside on its border; each loop filled in a random way. */
void RandomBlocksAreClosedManifolds()
{
  std::mt19937 random(3);
  constexpr int size = 9;
  std::set<int> seen;
  for (int block = 0; block < 21; ++block)
  {
    const int density = 1 + block % 7;
    bool corners[size][size][size] = {};
    for (int x = 1; x + 1 < size; ++x)
    {
      for (int y = 1; y + 1 < size; ++y)
      {
        for (int z = 1; z + 1 < size; ++z)
        {
          corners[x][y][z] = static_cast<int>(random() % 8) < density;
        }
      }
    }
    std::map<std::pair<Place, Place>, int> edges;
    std::map<Place, std::map<Place, Place>> links;
    for (int cube = 0; cube < (size - 1) * (size - 1) * (size - 1); ++cube)
    {
      const Place at{ cube % (size - 1), cube / (size - 1) % (size - 1),
        cube / (size - 1) / (size - 1) };
      int inside = 0;
      for (int c = 0; c < 8; ++c)
      {
        inside |= corners[at[0] + (c & 1)][at[1] + (c >> 1 & 1)][at[2] + (c >> 2)] ? 1 << c : 0;
      }
      seen.insert(inside);
      for (const sb::CubeTriangle& triangle : SomeFill(inside, static_cast<unsigned>(random())))
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          const Place a = MiddleOf(triangle[k], at);
          const Place b = MiddleOf(triangle[(k + 1) % 3], at);
          const Place c = MiddleOf(triangle[(k + 2) % 3], at);
          ++edges[{ a, b }];
          links[a][b] = c;
        }
      }
    }
    for (const auto& edge : edges)
    {
      CHECK_EQUAL(edge.second, 1);
      CHECK(edges.count({ edge.first.second, edge.first.first }) == 1);
    }
    for (const auto& link : links) // the triangles around a point form one ring
    {
      Place at = link.second.begin()->first;
      std::size_t steps = 0;
      do
      {
        at = link.second.at(at);
        ++steps;
      } while (at != link.second.begin()->first && steps <= link.second.size());
      CHECK_EQUAL(steps, link.second.size());
    }
  }
  CHECK_EQUAL(seen.size(), 256u);
}

} // namespace

int main()
{
  EachCaseUsesItsCrossedEdges();
  TrianglesFaceOutwards();
  RandomBlocksAreClosedManifolds();
  return check::Verdict("TestCubeCases");
}
