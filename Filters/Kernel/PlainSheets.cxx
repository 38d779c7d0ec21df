// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PlainSheets.h"

#include "DisjointSets.h"

#include <algorithm>
#include <array>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 512; // runs

} // namespace

PlainSheets::PlainSheets(const TriangleRuns& runs, const Scene& scene,
  const std::vector<std::int32_t>& corners, const MeshEdges& edges, Executor& executor)
  : Runs(runs)
  , World(scene)
  , Corners(corners)
  , Edges(edges)
  , Threads(executor)
  , Views(std::size_t(runs.Count()))
  , Tried(std::size_t(runs.Count()))
  , Sheets(std::size_t(runs.Count()), -1)
{
  this->ChooseViews();
  this->FindNeighbours();
  for (std::int32_t level = runs.Tree().NumberOfLevels() - 1; level >= 0; --level)
  {
    this->TryParts(level);
  }
  this->MarkNodes();
}

template <class Visit>
void PlainSheets::ForEachRun(Visit&& visit)
{
  this->Threads.For(this->Runs.Count(), Grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto place = static_cast<std::int32_t>(begin); place < end; ++place)
    {
      visit(place);
    }
  });
}

/** visit(half-edge, the place of the run beyond it or -1) for the triangles of a run. */
template <class Visit>
void PlainSheets::ForEachHalfEdge(std::int32_t place, Visit&& visit) const
{
  const std::int32_t* faces = this->Runs.FacesOf(place);
  const std::int32_t count = this->Runs[place].Size;
  for (std::int32_t i = 0; i < count; ++i)
  {
    for (HalfEdge half = 3 * faces[i]; half < 3 * faces[i] + 3; ++half)
    {
      const HalfEdge mate = this->Edges.Mates[std::size_t(half)];
      visit(half, mate < 0 ? -1 : this->Runs.PlaceOf(mate / 3));
    }
  }
}

/** Whether a test holds for all runs beside a run. */
template <class Test>
bool PlainSheets::AllNeighbours(std::int32_t place, Test&& test) const
{
  const NeighbourList& list = this->Neighbours[std::size_t(place / Grain)];
  const std::int64_t i = place % Grain;
  const auto begin = list.Places.begin() + (i == 0 ? 0 : list.Ends[std::size_t(i - 1)]);
  return std::all_of(begin, list.Places.begin() + list.Ends[std::size_t(i)], test);
}

void PlainSheets::FindNeighbours()
{
  const std::int64_t count = this->Runs.Count();
  this->Neighbours.resize(std::size_t((count + Grain - 1) / Grain));
  this->Threads.For(static_cast<std::int64_t>(this->Neighbours.size()), 1,
    [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t part = begin; part < end; ++part)
      {
        NeighbourList& list = this->Neighbours[std::size_t(part)];
        const std::int64_t last = std::min(count, (part + 1) * Grain);
        for (auto place = static_cast<std::int32_t>(part * Grain); place < last; ++place)
        {
          const auto first = static_cast<std::ptrdiff_t>(list.Places.size());
          this->ForEachHalfEdge(place, [&](HalfEdge, std::int32_t other) {
            if (other != place &&
              std::find(list.Places.begin() + first, list.Places.end(), other) == list.Places.end())
            {
              list.Places.push_back(other);
            }
          });
          list.Ends.push_back(static_cast<std::int32_t>(list.Places.size()));
        }
      }
    });
}

/** Of the views that a whole group faces the one that it faces most, so that neighbours mostly
 * agree; else each run of the group for itself. */
void PlainSheets::ChooseViews()
{
  const std::int32_t count = this->Runs.Count();
  const auto best = [this](std::int32_t begin, std::int32_t end) {
    unsigned views = (1u << NumberOfViews) - 1;
    std::array<double, NumberOfViews> sums{};
    for (std::int32_t place = begin; place < end; ++place)
    {
      views &= this->Runs[place].Views;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        sums[2 * axis] += this->Runs[place].Normal[axis];
        sums[2 * axis + 1] -= this->Runs[place].Normal[axis];
      }
    }
    int view = -1;
    for (int bit = 0; bit < NumberOfViews; ++bit)
    {
      if ((views >> bit & 1u) != 0 &&
        (view < 0 || sums[std::size_t(bit)] > sums[std::size_t(view)]))
      {
        view = bit;
      }
    }
    return static_cast<std::int8_t>(view);
  };
  this->Threads.For(this->Runs.Tree().NumberOfGroups(), Grain / BVH::Width,
    [&](std::int64_t first, std::int64_t last) {
      for (auto group = static_cast<std::int32_t>(first); group < last; ++group)
      {
        const std::int32_t begin = BVH::Width * group;
        const std::int32_t end = std::min(count, begin + BVH::Width);
        const std::int8_t ofAll = best(begin, end);
        for (std::int32_t place = begin; place < end; ++place)
        {
          this->Views[std::size_t(place)] = ofAll >= 0 ? ofAll : best(place, place + 1);
        }
      }
    });
}

/** Make sheets of what is not yet on one, none of them larger than a node of the tree. */
void PlainSheets::TryParts(std::int32_t level)
{
  this->JoinRuns(level);
  this->Judge(this->ListBorders());
}

/** Runs that hang together get the same sheet to try, named by its first run. */
void PlainSheets::JoinRuns(std::int32_t level)
{
  const auto isOpen = [this](std::int32_t place) {
    return this->Sheets[std::size_t(place)] < 0 && this->Views[std::size_t(place)] >= 0;
  };
  const int shift = 3 * (level + 1); // from runs to nodes
  DisjointSets sets(this->Runs.Count());
  for (std::int32_t place = 0; place < sets.Size(); ++place)
  {
    if (!isOpen(place))
    {
      continue;
    }
    this->AllNeighbours(place, [&](std::int32_t other) {
      if (other > place && isOpen(other) && other >> shift == place >> shift &&
        this->Views[std::size_t(other)] == this->Views[std::size_t(place)])
      {
        sets.Unite(place, other);
      }
      return true;
    });
  }
  this->ForEachRun([&](std::int32_t place) {
    this->Tried[std::size_t(place)] = isOpen(place) ? sets.Root(place) : -1;
  });
}

/** By sheet. */
std::vector<PlainSheets::Border> PlainSheets::ListBorders()
{
  const std::int64_t count = this->Runs.Count();
  std::vector<std::vector<Border>> parts(std::size_t((count + Grain - 1) / Grain));
  this->Threads.For(
    static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t part = begin; part < end; ++part)
      {
        for (std::int64_t i = part * Grain; i < std::min(count, (part + 1) * Grain); ++i)
        {
          const auto place = static_cast<std::int32_t>(i);
          const std::int32_t sheet = this->Tried[std::size_t(place)];
          const auto isOnSheet = [&](std::int32_t other) {
            return other >= 0 && this->Tried[std::size_t(other)] == sheet;
          };
          if (sheet < 0 || this->AllNeighbours(place, isOnSheet))
          {
            continue;
          }
          this->ForEachHalfEdge(place, [&](HalfEdge half, std::int32_t other) {
            if (!isOnSheet(other))
            {
              const HalfEdge next = half % 3 == 2 ? half - 2 : half + 1;
              parts[std::size_t(part)].push_back(
                { sheet, { this->Corners[std::size_t(half)], this->Corners[std::size_t(next)] } });
            }
          });
        }
      }
    });
  std::vector<Border> borders;
  for (const std::vector<Border>& part : parts)
  {
    borders.insert(borders.end(), part.begin(), part.end());
  }
  std::stable_sort(borders.begin(), borders.end(),
    [](const Border& l, const Border& r) { return l.Sheet < r.Sheet; });
  return borders;
}

/** Runs of sheets that pass are on them from now on. */
void PlainSheets::Judge(const std::vector<Border>& borders)
{
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    if (i == 0 || borders[i].Sheet != borders[i - 1].Sheet)
    {
      firsts.push_back(i);
    }
  }
  firsts.push_back(borders.size());
  std::vector<std::uint8_t> passes(this->Sheets.size(), 0);
  this->Threads.For(
    static_cast<std::int64_t>(firsts.size()) - 1, 1, [&](std::int64_t begin, std::int64_t end) {
      std::vector<OutlineEdge> outline;
      for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i)
      {
        outline.clear();
        for (std::size_t k = firsts[i]; k < firsts[i + 1]; ++k)
        {
          outline.push_back(borders[k].Edge);
        }
        const auto sheet = std::size_t(borders[firsts[i]].Sheet);
        passes[sheet] = EnclosesOnce(this->World.Position(0), outline, ViewOf(this->Views[sheet]));
      }
    });
  this->ForEachRun([&](std::int32_t place) {
    const std::int32_t sheet = this->Tried[std::size_t(place)];
    if (sheet >= 0 && passes[std::size_t(sheet)])
    {
      this->Sheets[std::size_t(place)] = sheet;
    }
  });
}

void PlainSheets::MarkNodes()
{
  for (std::int32_t level = 0; level < this->Runs.Tree().NumberOfLevels(); ++level)
  {
    const std::vector<std::int32_t>& below = level == 0 ? this->Sheets : this->OfNodes.back();
    std::vector<std::int32_t> nodes(std::size_t(this->Runs.Tree().NumberOfGroups(level)));
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const auto first = below.begin() + static_cast<std::ptrdiff_t>(BVH::Width * i);
      const auto last =
        below.begin() + static_cast<std::ptrdiff_t>(std::min(below.size(), BVH::Width * (i + 1)));
      nodes[i] =
        std::all_of(first, last, [&](std::int32_t sheet) { return sheet == *first; }) ? *first : -1;
    }
    this->OfNodes.push_back(std::move(nodes));
  }
}

} // namespace sb
