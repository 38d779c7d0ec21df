// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DisjointSets.h
 * @brief Union-find over 0..n-1 whose sets are named by their smallest member.
 *
 * The name of a set depends on the unions made only, not on their order, and so whatever is
 * numbered by it is deterministic. Union by lower root gives up the logarithmic bound of union by
 * rank; with path halving the cost stays logarithmic amortised (Tarjan and van Leeuwen 1984), and
 * ids in mesh order keep the trees flat in practice.
 */
#ifndef sb_DisjointSets_h
#define sb_DisjointSets_h

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace sb
{

class DisjointSets
{
public:
  DisjointSets() = default;
  explicit DisjointSets(std::int32_t count) { this->Reset(count); }

  /** Make `count` sets of one member each. */
  void Reset(std::int32_t count)
  {
    this->Parent.resize(static_cast<std::size_t>(count));
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  /** Go on with `count` members, those that are new in sets of their own; never fewer than before.
   */
  void Extend(std::int32_t count)
  {
    for (std::int32_t i = this->Size(); i < count; ++i)
    {
      this->Parent.push_back(i);
    }
  }

  /** Make one more set; @return its member. */
  std::int32_t Add()
  {
    this->Parent.push_back(this->Size());
    return this->Size() - 1;
  }

  std::int32_t Size() const { return static_cast<std::int32_t>(this->Parent.size()); }

  /** The smallest member of the set of i. */
  std::int32_t Find(std::int32_t i)
  {
    std::int32_t* const parent = this->Parent.data();
    while (parent[i] != i)
    {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  /** The same as Find without shortening paths: may be called from several threads while no set
   * changes. */
  std::int32_t Root(std::int32_t i) const
  {
    const std::int32_t* const parent = this->Parent.data();
    while (parent[i] != i)
    {
      i = parent[i];
    }
    return i;
  }

  /** Join the sets of i and j; returns whether they were two. */
  bool Unite(std::int32_t i, std::int32_t j)
  {
    // The two paths are climbed together, the one with the higher parent first (Rem's algorithm, in
    // Dijkstra 1976): where i and j are in one set already, as mostly on a mesh, the climb ends
    // where the paths meet.
    std::int32_t* const parent = this->Parent.data();
    while (parent[i] != parent[j])
    {
      if (parent[i] < parent[j])
      {
        std::swap(i, j);
      }
      const std::int32_t above = parent[i];
      parent[i] = parent[j];
      if (above == i)
      {
        return true;
      }
      i = above;
    }
    return false;
  }

private:
  std::vector<std::int32_t> Parent;
};

} // namespace sb

#endif
