// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CubeCases.h"

#include <algorithm>
#include <cstddef>

namespace sb
{
namespace
{

int EdgeBetween(int corner, int other)
{
  const int bit = corner ^ other;
  const int axis = bit == 1 ? 0 : bit == 2 ? 1 : 2;
  return 4 * axis + (corner >> (axis + 1) % 3 & 1) + 2 * (corner >> (axis + 2) % 3 & 1);
}

bool LieOnOneFace(int edge, int other)
{
  const int lower = LowerCornerOfCubeEdge(edge);
  const int upper = lower | 1 << edge / 4;
  const int otherLower = LowerCornerOfCubeEdge(other);
  const int otherUpper = otherLower | 1 << other / 4;
  // One coordinate is the same at all four corners.
  return (lower & upper & otherLower & otherUpper) != 0 ||
    (~lower & ~upper & ~otherLower & ~otherUpper & 7) != 0;
}

/**
 * The corners of a face, in a ring, counter-clockwise as seen from outside of the cube.
 * @param face 2 a for the lower and 2 a + 1 for the upper one on axis a
 */
std::array<int, 4> CornersOfCubeFace(int face)
{
  const int axis = face / 2;
  const int side = (face & 1) << axis;
  const int u = 1 << (axis + 1) % 3;
  const int v = 1 << (axis + 2) % 3;
  std::array<int, 4> ring{ side, side | u, side | u | v, side | v };
  if ((face & 1) == 0)
  {
    std::swap(ring[1], ring[3]);
  }
  return ring;
}

/** The edge that follows each crossed edge in the loops; -1 for others. */
std::array<int, 12> Successors(int inside)
{
  std::array<int, 12> next;
  next.fill(-1);
  for (int face = 0; face < 6; ++face)
  {
    const std::array<int, 4> ring = CornersOfCubeFace(face);
    const auto isInside = [&](int k) {
      return (inside >> ring[static_cast<std::size_t>(k & 3)] & 1) != 0;
    };
    const auto edge = [&](int k) {
      return EdgeBetween(
        ring[static_cast<std::size_t>(k & 3)], ring[static_cast<std::size_t>((k + 1) & 3)]);
    };
    for (int leaves = 0; leaves < 4; ++leaves)
    {
      if (isInside(leaves) && !isInside(leaves + 1))
      {
        int enters = leaves + 3;
        while (isInside(enters))
        {
          --enters;
        }
        next[static_cast<std::size_t>(edge(leaves))] = edge(enters);
      }
    }
  }
  return next;
}

/** All ways to fill the part of a loop from its corner `first` to `last`, whose chord is an edge
 * already. */
std::vector<CubeFill> Fills(const std::vector<int>& loop, std::size_t first, std::size_t last)
{
  if (last - first < 2)
  {
    return { CubeFill{} };
  }
  const auto mayJoin = [&](std::size_t a, std::size_t b) {
    return b - a == 1 || !LieOnOneFace(loop[a], loop[b]);
  };
  std::vector<CubeFill> fills;
  for (std::size_t apex = first + 1; apex < last; ++apex)
  {
    if (!mayJoin(first, apex) || !mayJoin(apex, last))
    {
      continue;
    }
    const std::vector<CubeFill> after = Fills(loop, apex, last);
    for (CubeFill fill : Fills(loop, first, apex))
    {
      const std::size_t own = fill.size();
      for (const CubeFill& rest : after)
      {
        fill.resize(own);
        fill.insert(fill.end(), rest.begin(), rest.end());
        fill.push_back({ static_cast<std::uint8_t>(loop[first]),
          static_cast<std::uint8_t>(loop[last]), static_cast<std::uint8_t>(loop[apex]) });
        fills.push_back(fill);
      }
    }
  }
  return fills;
}

std::vector<CubeLoop> Derive(int inside)
{
  std::vector<CubeLoop> loops;
  std::array<int, 12> next = Successors(inside);
  for (std::size_t start = 0; start < 12; ++start)
  {
    std::vector<int> loop;
    for (int edge = static_cast<int>(start); next[static_cast<std::size_t>(edge)] >= 0;)
    {
      loop.push_back(edge);
      const int following = next[static_cast<std::size_t>(edge)];
      next[static_cast<std::size_t>(edge)] = -1;
      edge = following;
    }
    if (!loop.empty())
    {
      loops.push_back(Fills(loop, 0, loop.size() - 1));
    }
  }
  return loops;
}

} // namespace

int LowerCornerOfCubeEdge(int edge)
{
  const int axis = edge / 4;
  return (edge & 1) << (axis + 1) % 3 | (edge >> 1 & 1) << (axis + 2) % 3;
}

const std::vector<CubeLoop>& LoopsOfCube(int inside)
{
  static const std::array<std::vector<CubeLoop>, 256> cases = [] {
    std::array<std::vector<CubeLoop>, 256> derived;
    for (int c = 0; c < 256; ++c)
    {
      derived[static_cast<std::size_t>(c)] = Derive(c);
    }
    return derived;
  }();
  return cases[static_cast<std::size_t>(inside)];
}

} // namespace sb
