// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FlippedTriangles.h"

#include <algorithm>
#include <utility>

namespace sb
{

namespace
{

using Quarrel = std::pair<std::int32_t, std::int32_t>; ///< two patches

/** Both ways round, sorted. */
std::vector<Quarrel> ListQuarrels(const DisjointSets& patches, const MeshEdges& edges)
{
  std::vector<Quarrel> quarrels;
  for (const IrregularEdge& edge : edges.Irregular)
  {
    if (edge.NumberOfUses == 2)
    {
      const std::int32_t a = patches.Root(edges.Uses[std::size_t(edge.FirstUse)] / 3);
      const std::int32_t b = patches.Root(edges.Uses[std::size_t(edge.FirstUse) + 1] / 3);
      quarrels.emplace_back(a, b);
      quarrels.emplace_back(b, a);
    }
  }
  std::sort(quarrels.begin(), quarrels.end());
  quarrels.erase(std::unique(quarrels.begin(), quarrels.end()), quarrels.end());
  return quarrels;
}

class Colouring
{
public:
  Colouring(const DisjointSets& patches, const MeshEdges& edges)
    : Quarrels(ListQuarrels(patches, edges))
    , Sizes(std::size_t(patches.Size()), 0)
    , Colours(std::size_t(patches.Size()), 0)
  {
    for (std::int32_t triangle = 0; triangle < patches.Size(); ++triangle)
    {
      ++this->Sizes[std::size_t(patches.Root(triangle))];
    }
  }

  FlippedTriangles Run(const DisjointSets& patches)
  {
    FlippedTriangles result;
    if (this->Quarrels.empty())
    {
      return result;
    }
    for (const Quarrel& quarrel : this->Quarrels)
    {
      if (this->Colours[std::size_t(quarrel.first)] == 0 && !this->Spread(quarrel.first))
      {
        result.OneSided.push_back(quarrel.first);
      }
    }
    result.IsFlipped.resize(this->Sizes.size(), 0);
    for (std::int32_t triangle = 0; triangle < patches.Size(); ++triangle)
    {
      result.IsFlipped[std::size_t(triangle)] =
        this->Colours[std::size_t(patches.Root(triangle))] < 0;
    }
    return result;
  }

private:
  /** Colour all that a patch's quarrels reach, +1 those to stay and -1 those to turn over; @return
   * whether that is possible. */
  bool Spread(std::int32_t start)
  {
    bool isPossible = true;
    std::vector<std::int32_t> reached{ start };
    this->Colours[std::size_t(start)] = 1;
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      const std::int32_t here = reached[i];
      for (auto it =
             std::lower_bound(this->Quarrels.begin(), this->Quarrels.end(), Quarrel(here, 0));
           it != this->Quarrels.end() && it->first == here; ++it)
      {
        std::int8_t& colour = this->Colours[std::size_t(it->second)];
        const auto wanted = static_cast<std::int8_t>(-this->Colours[std::size_t(here)]);
        isPossible = isPossible && (colour == 0 || colour == wanted);
        if (colour == 0)
        {
          colour = wanted;
          reached.push_back(it->second);
        }
      }
    }
    this->LetTheLargerStay(reached, isPossible);
    return isPossible;
  }

  void LetTheLargerStay(const std::vector<std::int32_t>& reached, bool isPossible)
  {
    std::int64_t balance = 0;
    for (const std::int32_t patch : reached)
    {
      balance += this->Colours[std::size_t(patch)] * this->Sizes[std::size_t(patch)];
    }
    for (const std::int32_t patch : reached)
    {
      std::int8_t& colour = this->Colours[std::size_t(patch)];
      // On a one-sided part nobody is more wrong than the others.
      colour = !isPossible ? std::int8_t(1) : balance < 0 ? std::int8_t(-colour) : colour;
    }
  }

  const std::vector<Quarrel> Quarrels;
  std::vector<std::int64_t> Sizes; ///< [patch]
  std::vector<std::int8_t> Colours; ///< [patch]; 0 not yet known
};

} // namespace

FlippedTriangles FindFlippedTriangles(const DisjointSets& patches, const MeshEdges& edges)
{
  const bool isAny = std::any_of(edges.Irregular.begin(), edges.Irregular.end(),
    [](const IrregularEdge& edge) { return edge.NumberOfUses == 2; });
  return isAny ? Colouring(patches, edges).Run(patches) : FlippedTriangles();
}

} // namespace sb
