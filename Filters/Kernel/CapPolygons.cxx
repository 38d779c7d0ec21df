// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CapPolygons.h"

#include "Hash.h"

#include <unordered_map>

namespace sb
{

namespace
{

class LoopFinder
{
public:
  LoopFinder(const std::vector<std::array<std::int32_t, 3>>& triangles,
    const std::vector<std::int32_t>& regions)
    : Triangles(triangles)
    , Regions(regions)
  {
    this->SideOfEdge.reserve(3 * triangles.size());
    for (std::size_t side = 0; side < 3 * triangles.size(); ++side)
    {
      this->SideOfEdge.emplace(Key(this->From(side), this->From(Next(side))), side);
    }
  }

  RegionLoops Run()
  {
    RegionLoops loops;
    std::vector<std::uint8_t> done(3 * this->Triangles.size(), 0);
    for (std::size_t first = 0; first < done.size(); ++first)
    {
      if (done[first] || !this->IsOutline(first))
      {
        continue;
      }
      for (std::size_t side = first; !done[side]; side = this->NextOnOutline(side))
      {
        done[side] = 1;
        loops.Connectivity.push_back(this->From(side));
      }
      loops.Offsets.push_back(static_cast<std::int32_t>(loops.Connectivity.size()));
      loops.Regions.push_back(this->Regions[first / 3]);
    }
    return loops;
  }

private:
  static constexpr std::size_t none = ~std::size_t(0);

  static std::uint64_t Key(std::int32_t from, std::int32_t to)
  {
    return (std::uint64_t(static_cast<std::uint32_t>(from)) << 32) | static_cast<std::uint32_t>(to);
  }
  static std::size_t Next(std::size_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  std::int32_t From(std::size_t side) const { return this->Triangles[side / 3][side % 3]; }

  /** The same edge of the triangle across it, if that is of the same region. */
  std::size_t Across(std::size_t side) const
  {
    const auto found = this->SideOfEdge.find(Key(this->From(Next(side)), this->From(side)));
    return found != this->SideOfEdge.end() &&
        this->Regions[found->second / 3] == this->Regions[side / 3]
      ? found->second
      : none;
  }

  bool IsOutline(std::size_t side) const { return this->Across(side) == none; }

  /** Turn about the end of a side, from triangle to triangle, until there is no further one. */
  std::size_t NextOnOutline(std::size_t side) const
  {
    side = Next(side);
    for (std::size_t across = this->Across(side); across != none; across = this->Across(side))
    {
      side = Next(across);
    }
    return side;
  }

  struct Hasher
  {
    std::size_t operator()(std::uint64_t key) const { return static_cast<std::size_t>(Mix(key)); }
  };

  const std::vector<std::array<std::int32_t, 3>>& Triangles;
  const std::vector<std::int32_t>& Regions;
  std::unordered_map<std::uint64_t, std::size_t, Hasher> SideOfEdge;
};

} // namespace

RegionLoops FindRegionLoops(const std::vector<std::array<std::int32_t, 3>>& triangles,
  const std::vector<std::int32_t>& regions)
{
  return LoopFinder(triangles, regions).Run();
}

} // namespace sb
