// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceLoops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

namespace sbvtk
{
namespace
{

using sb::Real3;

// Edges of facets turn by half a radian at most where the face's edge is smooth.
constexpr double cosineOfCorner = 0.8;

// What is left of the facets' areas in the parameters if those that are turned over are taken off:
// slender ones are, where a seam bends; all are, where a cylinder's facets do not end at its seam.
constexpr double leastUprightShare = 0.5;

/** A side of one facet that no other facet of its face has. */
struct Side
{
  std::int32_t Face;
  std::int32_t From; ///< points
  std::int32_t To;
  std::int32_t Next = -1; ///< the side that follows in the loop
  std::int32_t Previous = -1;
  std::int32_t Twin = -1; ///< the same edge seen from the other side
  bool IsPole = false;
  bool StartsChain = false;
};

/** The same number for equal keys, in the order in which they sort. */
template <std::size_t N>
std::vector<std::int32_t> Numbered(const std::vector<std::array<double, N>>& keys)
{
  std::vector<std::int32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::int32_t i) { return keys[static_cast<std::size_t>(i)]; };
  std::sort(
    order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  std::vector<std::int32_t> numbers(keys.size());
  std::int32_t number = -1;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    number += i == 0 || key(order[i]) != key(order[i - 1]) ? 1 : 0;
    numbers[static_cast<std::size_t>(order[i])] = number;
  }
  return numbers;
}

class LoopFinder
{
public:
  explicit LoopFinder(const sb::DesignedSurface& surface)
    : Surface(surface)
  {
    this->NamePoints();
  }

  FaceLoops Find()
  {
    this->FindSides();
    this->ClosePoles();
    this->JoinSides();
    this->FindTwins();
    this->DivideIntoChains();
    FaceLoops result = this->Collect();
    this->DropUnfit(result);
    return result;
  }

private:
  std::int32_t Spot(std::int32_t point) const
  {
    return this->Spots[static_cast<std::size_t>(point)];
  }
  std::int32_t Place(std::int32_t point) const
  {
    return this->Places[static_cast<std::size_t>(point)];
  }
  Side& At(std::int32_t side) { return this->Sides[static_cast<std::size_t>(side)]; }
  const Side& At(std::int32_t side) const { return this->Sides[static_cast<std::size_t>(side)]; }
  double U(std::int32_t point) const
  {
    return this->Surface.UV[2 * static_cast<std::size_t>(point)];
  }
  double V(std::int32_t point) const
  {
    return this->Surface.UV[2 * static_cast<std::size_t>(point) + 1];
  }
  Real3 Coordinates(std::int32_t point) const
  {
    const double* x = this->Surface.Points.data() + 3 * static_cast<std::size_t>(point);
    return { x[0], x[1], x[2] };
  }

  void NamePoints()
  {
    const std::size_t count = this->Surface.Points.size() / 3;
    std::vector<double> faces(count, -1.0);
    for (std::size_t corner = 0; corner < this->Surface.Triangles.size(); ++corner)
    {
      double& face = faces[static_cast<std::size_t>(this->Surface.Triangles[corner])];
      face = std::max(face, static_cast<double>(this->Surface.FaceId[corner / 3]));
    }
    std::vector<std::array<double, 3>> places(count);
    std::vector<std::array<double, 3>> spots(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const double* x = this->Surface.Points.data() + 3 * i;
      // A filter that knows nothing of parameters has NaN for them, which does not sort.
      const bool placed = faces[i] >= 0.0;
      places[i] = { x[0], x[1], x[2] };
      spots[i] = { faces[i], placed ? this->Surface.UV[2 * i] : 0.0,
        placed ? this->Surface.UV[2 * i + 1] : 0.0 };
    }
    this->Places = Numbered(places);
    this->Spots = Numbered(spots);
  }

  /** What is left when all sides that two facets of a face share are taken away. */
  void FindSides()
  {
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<Side>> open;
    for (std::size_t i = 0; i < this->Surface.Triangles.size(); ++i)
    {
      const std::int32_t face = this->Surface.FaceId[i / 3];
      const std::int32_t from = this->Surface.Triangles[i];
      const std::int32_t to = this->Surface.Triangles[i % 3 == 2 ? i - 2 : i + 1];
      if (face < 0 || this->Spot(from) == this->Spot(to))
      {
        continue;
      }
      const auto other = open.find({ this->Spot(to), this->Spot(from) });
      if (other == open.end())
      {
        open[{ this->Spot(from), this->Spot(to) }].push_back({ face, from, to });
        continue;
      }
      other->second.pop_back();
      if (other->second.empty())
      {
        open.erase(other);
      }
    }
    for (const auto& entry : open)
    {
      this->Sides.insert(this->Sides.end(), entry.second.begin(), entry.second.end());
    }
    std::stable_sort(this->Sides.begin(), this->Sides.end(),
      [](const Side& a, const Side& b) { return a.Face < b.Face; });
  }

  /** At a pole a face has a row of spots in one place. Facets between two of these have no area and
   * may be missing; in the parameters they are not nothing. */
  void ClosePoles()
  {
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::size_t>>
      leaving; // spot, place
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      leaving[{ this->Spot(this->Sides[i].From), this->Place(this->Sides[i].To) }].push_back(i);
    }
    std::vector<char> closed(this->Sides.size());
    std::vector<Side> poles;
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      const Side side = this->Sides[i];
      const auto found = leaving.find({ this->Spot(side.To), this->Place(side.From) });
      if (closed[i] || found == leaving.end())
      {
        continue;
      }
      for (const std::size_t back : found->second)
      {
        if (!closed[back] && back != i && this->Sides[back].Face == side.Face)
        {
          closed[i] = closed[back] = 1;
          poles.push_back({ side.Face, side.From, this->Sides[back].To });
          break;
        }
      }
    }
    std::vector<Side> kept;
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      if (!closed[i])
      {
        kept.push_back(this->Sides[i]);
      }
    }
    kept.insert(kept.end(), poles.begin(), poles.end());
    for (Side& side : kept)
    {
      side.IsPole = this->Place(side.From) == this->Place(side.To);
    }
    this->Sides = std::move(kept);
  }

  /** How far to the left it turns from one side to the next, in the parameters. */
  double Turn(const Side& side, const Side& next) const
  {
    const double au = this->U(side.To) - this->U(side.From);
    const double av = this->V(side.To) - this->V(side.From);
    const double bu = this->U(next.To) - this->U(next.From);
    const double bv = this->V(next.To) - this->V(next.From);
    return std::atan2(au * bv - av * bu, au * bu + av * bv);
  }

  /** Where loops touch in a spot, the one that turns most to the left stays on its own facets. */
  void JoinSides()
  {
    std::map<std::int32_t, std::vector<std::int32_t>> leaving; // spot
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      leaving[this->Spot(this->Sides[i].From)].push_back(static_cast<std::int32_t>(i));
    }
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      Side& side = this->Sides[i];
      for (const std::int32_t next : leaving[this->Spot(side.To)])
      {
        const bool isFree = this->At(next).Previous < 0;
        if (isFree &&
          (side.Next < 0 ||
            this->Turn(side, this->At(next)) > this->Turn(side, this->At(side.Next))))
        {
          side.Next = next;
        }
      }
      if (side.Next >= 0)
      {
        this->At(side.Next).Previous = static_cast<std::int32_t>(i);
      }
    }
  }

  void FindTwins()
  {
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> open; // places
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      Side& side = this->Sides[i];
      if (side.IsPole)
      {
        continue;
      }
      std::vector<std::int32_t>& others = open[{ this->Place(side.To), this->Place(side.From) }];
      if (others.empty())
      {
        open[{ this->Place(side.From), this->Place(side.To) }].push_back(
          static_cast<std::int32_t>(i));
        continue;
      }
      side.Twin = others.front();
      this->At(side.Twin).Twin = static_cast<std::int32_t>(i);
      others.erase(others.begin());
    }
  }

  bool IsCorner(const Side& side, const Side& next) const
  {
    const Real3 a = sb::Difference(this->Coordinates(side.To), this->Coordinates(side.From));
    const Real3 b = sb::Difference(this->Coordinates(next.To), this->Coordinates(next.From));
    return !(sb::Dot(a, b) > cosineOfCorner * sb::Length(a) * sb::Length(b));
  }

  bool EndsBetween(const Side& side, const Side& next) const
  {
    if (side.IsPole || next.IsPole)
    {
      return side.IsPole != next.IsPole;
    }
    if ((side.Twin < 0) != (next.Twin < 0) || this->IsCorner(side, next))
    {
      return true;
    }
    // On the other side, too, the two have to follow each other.
    return side.Twin >= 0 && this->At(next.Twin).Next != side.Twin;
  }

  void DivideIntoChains()
  {
    std::vector<char> seen(this->Sides.size());
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      if (seen[i])
      {
        continue;
      }
      bool hasStart = false;
      std::int32_t least =
        static_cast<std::int32_t>(i); // the start of a loop without any, on both sides
      for (std::int32_t k = static_cast<std::int32_t>(i);
           k >= 0 && !seen[static_cast<std::size_t>(k)]; k = this->At(k).Next)
      {
        Side& side = this->At(k);
        seen[static_cast<std::size_t>(k)] = 1;
        side.StartsChain = side.Previous < 0 || this->EndsBetween(this->At(side.Previous), side);
        hasStart = hasStart || side.StartsChain;
        least = this->Place(side.From) < this->Place(this->At(least).From) ? k : least;
      }
      this->At(least).StartsChain = this->At(least).StartsChain || !hasStart;
    }
  }

  FaceLoops Collect() const
  {
    FaceLoops result;
    std::vector<std::int32_t> chainOf(this->Sides.size(), -1);
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      if (chainOf[i] < 0 && this->Sides[i].StartsChain)
      {
        this->CollectLoop(static_cast<std::int32_t>(i), result, chainOf);
      }
    }
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      if (this->Sides[i].Twin >= 0 && chainOf[i] >= 0)
      {
        result.Chains[static_cast<std::size_t>(chainOf[i])].Twin =
          chainOf[static_cast<std::size_t>(this->Sides[i].Twin)];
      }
    }
    return result;
  }

  void CollectLoop(std::int32_t start, FaceLoops& result, std::vector<std::int32_t>& chainOf) const
  {
    FaceLoop loop;
    loop.Face = this->At(start).Face;
    const std::int32_t first = this->At(start).From;
    std::int32_t k = start;
    for (; k >= 0 && chainOf[static_cast<std::size_t>(k)] < 0; k = this->At(k).Next)
    {
      const Side& side = this->At(k);
      if (side.StartsChain)
      {
        loop.Chains.push_back(static_cast<std::int32_t>(result.Chains.size()));
        FaceChain chain;
        chain.Face = side.Face;
        chain.IsPole = side.IsPole;
        chain.Points = { side.From };
        chain.Places = { this->Place(side.From) };
        result.Chains.push_back(chain);
      }
      FaceChain& chain = result.Chains.back();
      chain.Points.push_back(side.To);
      chain.Places.push_back(this->Place(side.To));
      chainOf[static_cast<std::size_t>(k)] = loop.Chains.back();
      loop.Area += this->AreaBetween(first, side.From, side.To);
    }
    if (k == start)
    {
      result.Loops.push_back(loop);
    }
    else
    {
      result.Unfit.push_back(loop.Face);
    }
  }

  void DropUnfit(FaceLoops& result) const
  {
    const std::vector<std::int32_t> covered = this->FacesThatCoverThemselves();
    std::vector<std::int32_t>& unfit = result.Unfit;
    unfit.insert(unfit.end(), covered.begin(), covered.end());
    std::sort(unfit.begin(), unfit.end());
    unfit.erase(std::unique(unfit.begin(), unfit.end()), unfit.end());
    result.Loops.erase(std::remove_if(result.Loops.begin(), result.Loops.end(),
                         [&](const FaceLoop& loop) {
                           return std::binary_search(unfit.begin(), unfit.end(), loop.Face);
                         }),
      result.Loops.end());
  }

  std::vector<std::int32_t> FacesThatCoverThemselves() const
  {
    std::vector<double> areas(this->Surface.Patches.size(), 0.0);
    std::vector<double> sizes(this->Surface.Patches.size(), 0.0);
    for (std::size_t i = 0; i < this->Surface.FaceId.size(); ++i)
    {
      if (this->Surface.FaceId[i] >= 0)
      {
        const std::int32_t* const corners = this->Surface.Triangles.data() + 3 * i;
        const double area = this->AreaBetween(corners[0], corners[1], corners[2]);
        areas[static_cast<std::size_t>(this->Surface.FaceId[i])] += area;
        sizes[static_cast<std::size_t>(this->Surface.FaceId[i])] += std::abs(area);
      }
    }
    std::vector<std::int32_t> found;
    for (std::size_t face = 0; face < areas.size(); ++face)
    {
      if (areas[face] < leastUprightShare * sizes[face])
      {
        found.push_back(static_cast<std::int32_t>(face));
      }
    }
    return found;
  }

  /** In the parameters; negative if clockwise. */
  double AreaBetween(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    return 0.5 *
      ((this->U(b) - this->U(a)) * (this->V(c) - this->V(a)) -
        (this->U(c) - this->U(a)) * (this->V(b) - this->V(a)));
  }

  const sb::DesignedSurface& Surface;
  std::vector<std::int32_t> Spots;
  std::vector<std::int32_t> Places;
  std::vector<Side> Sides;
};

} // namespace

FaceLoops FindFaceLoops(const sb::DesignedSurface& surface) { return LoopFinder(surface).Find(); }

} // namespace sbvtk
