// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersection.h"

#include "Contacts.h"
#include "ParallelSort.h"
#include "PlainSheets.h"
#include "StitchedSeams.h"
#include "TriangleRuns.h"
#include "TriangleSeparation.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 4096;
constexpr std::int64_t GroupGrain = 64;

/** Compares the runs of one group with those around it. */
class RunComparison
{
public:
  RunComparison(
    const SelfIntersectionInput& input, const TriangleRuns& runs, std::vector<std::uint64_t>& found)
    : In(input)
    , Runs(runs)
    , Found(found)
  {
  }

  void Compare(std::int32_t asking, std::int32_t other)
  {
    this->Prepare(this->Asking[std::size_t(asking % BVH::Width)], asking);
    if (asking != other)
    {
      this->Prepare(this->Other, other);
    }
    Run& a = this->Asking[std::size_t(asking % BVH::Width)];
    Run& b = asking == other ? a : this->Other;
    for (unsigned lanes = b.Boxes->LanesThatMeet(a.Bounds); lanes != 0; lanes &= lanes - 1)
    {
      const int lane = LowestLane(lanes);
      unsigned hits = a.Boxes->LanesThatMeet(b.Boxes->Get(lane));
      hits &= asking == other ? (1u << lane) - 1 : ~0u; // each pair once
      for (; hits != 0; hits &= hits - 1)
      {
        this->CompareTriangles(this->TriangleOf(a, LowestLane(hits)), this->TriangleOf(b, lane));
      }
    }
  }

private:
  /** Its triangles are read when they are first asked for. */
  struct Run
  {
    std::int32_t Place = -1;
    unsigned Known = 0; ///< bit i: triangle i has been read
    const EightBoxes* Boxes = nullptr;
    FloatBox Bounds{};
    std::array<FlatTriangle, EightBoxes::Width> Triangles;
  };

  void Prepare(Run& run, std::int32_t place) const
  {
    if (run.Place != place)
    {
      run.Place = place;
      run.Known = 0;
      run.Boxes = &this->Runs[place].Boxes;
      run.Bounds = run.Boxes->Bounds();
    }
  }

  const FlatTriangle& TriangleOf(Run& run, int lane) const
  {
    FlatTriangle& triangle = run.Triangles[std::size_t(lane)];
    if ((run.Known >> lane & 1u) == 0)
    {
      run.Known |= 1u << lane;
      triangle.Face = this->Runs.FacesOf(run.Place)[lane];
      const std::size_t first = 3 * std::size_t(triangle.Face);
      for (std::size_t i = 0; i < 3; ++i)
      {
        std::copy_n(
          this->In.World.Position(this->In.World.Mesh(0).Triangles[first + i]), 3, triangle.P[i]);
        triangle.Vertices[i] = this->In.Corners[first + i];
      }
      SetPlane(triangle);
    }
    return triangle;
  }

  void CompareTriangles(const FlatTriangle& a, const FlatTriangle& b)
  {
    if (!AreApart(a, b))
    {
      const std::uint64_t lower = static_cast<std::uint32_t>(std::min(a.Face, b.Face));
      this->Found.push_back(lower << 32 | static_cast<std::uint32_t>(std::max(a.Face, b.Face)));
    }
  }

  const SelfIntersectionInput& In;
  const TriangleRuns& Runs;
  std::vector<std::uint64_t>& Found; ///< pairs of faces, the lower one in the higher bits
  std::array<Run, BVH::Width> Asking;
  Run Other;
};

class SelfSearch
{
public:
  SelfSearch(const SelfIntersectionInput& input, Executor& executor, Monitor& monitor)
    : In(input)
    , Threads(executor)
    , Watch(monitor)
  {
  }

  SelfIntersections Run()
  {
    const std::vector<TrianglePair> pairs = this->FindCandidates();
    if (this->Watch.Aborted())
    {
      return {};
    }
    return this->Gather(
      FindContacts(this->In.World, pairs, this->In.Collapsed, this->Threads, this->Watch));
  }

private:
  std::vector<TrianglePair> FindCandidates()
  {
    const TriangleRuns runs(this->In.World, this->In.Collapsed, this->Threads);
    const PlainSheets sheets(runs, this->In.World, this->In.Corners, this->In.Edges, this->Threads);
    const std::int64_t groups = runs.Tree().NumberOfGroups();
    std::vector<std::vector<std::uint64_t>> parts(
      std::size_t((groups + GroupGrain - 1) / GroupGrain));
    this->Threads.For(
      static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t part = begin; part < end && !this->Watch.Aborted(); ++part)
        {
          RunComparison comparison(this->In, runs, parts[std::size_t(part)]);
          const std::int64_t last = std::min(groups, (part + 1) * GroupGrain);
          for (std::int64_t group = part * GroupGrain; group < last; ++group)
          {
            AskGroup(static_cast<std::int32_t>(group), runs.Tree(), sheets, comparison);
          }
        }
      });
    return this->Sorted(parts);
  }

  static void AskGroup(
    std::int32_t group, const BVH& tree, const PlainSheets& sheets, RunComparison& comparison)
  {
    const auto isOnSameSheet = [&](std::int32_t level, std::int32_t index) {
      return sheets.AreTogether(group, level, index);
    };
    const auto compare = [&](std::int32_t p, std::int32_t q) {
      if (!sheets.AreTogether(p, q))
      {
        comparison.Compare(p, q);
      }
    };
    tree.ForEachPairOfGroup(group, isOnSameSheet, compare);
    for (std::int32_t p = BVH::Width * group; p < std::min(tree.Size(), BVH::Width * (group + 1));
         ++p)
    {
      compare(p, p);
    }
  }

  bool AreCopies(std::int32_t a, std::int32_t b) const
  {
    return !this->In.FirstCopies.empty() &&
      this->In.FirstCopies[std::size_t(this->In.Cells.CellOf(a))] ==
      this->In.FirstCopies[std::size_t(this->In.Cells.CellOf(b))] &&
      this->In.Cells.CellOf(a) != this->In.Cells.CellOf(b);
  }

  std::vector<TrianglePair> Sorted(const std::vector<std::vector<std::uint64_t>>& parts)
  {
    std::vector<std::uint64_t> keys;
    for (const std::vector<std::uint64_t>& part : parts)
    {
      keys.insert(keys.end(), part.begin(), part.end());
    }
    RadixSort(
      keys, [](std::uint64_t key) { return key; }, 64, this->Threads);
    std::vector<TrianglePair> pairs;
    for (const std::uint64_t key : keys)
    {
      const auto a = static_cast<std::int32_t>(key >> 32);
      const auto b = static_cast<std::int32_t>(key & 0xffffffffu);
      if (!this->AreCopies(a, b))
      {
        pairs.push_back({ 0, a, 0, b });
      }
    }
    return pairs;
  }

  /** Contacts come twice, once for either face, and sorted. */
  SelfIntersections Gather(const ContactSet& set) const
  {
    SelfIntersections result;
    const StitchedSeams seams(this->In.Collapsed, this->In.Edges);
    for (const Contact& contact : set.Contacts)
    {
      if (contact.Face > contact.Other ||
        (!this->In.Collapsed.empty() && seams.IsAlongSeam(contact, AsOtherSeesIt(set, contact))))
      {
        continue;
      }
      SelfContact found;
      found.Triangles = { contact.Face, contact.Other };
      for (std::size_t end = 0; end < 2; ++end)
      {
        found.Ends[end] = this->PositionOf(set.Points[std::size_t(contact.Points[end])]);
      }
      if (result.Pairs.empty() || result.Pairs.back() != found.Triangles)
      {
        result.Pairs.push_back(found.Triangles);
      }
      result.Contacts.push_back(found);
    }
    return result;
  }

  static const Contact& AsOtherSeesIt(const ContactSet& set, const Contact& contact)
  {
    auto it = std::lower_bound(
      set.Contacts.begin(), set.Contacts.end(), contact, [](const Contact& l, const Contact& r) {
        return l.Face != r.Other ? l.Face < r.Other : l.Other < r.Face;
      });
    while (it->Points[0] != contact.Points[0] || it->Points[1] != contact.Points[1])
    {
      ++it;
    }
    return *it;
  }

  std::array<double, 3> PositionOf(const ContactPoint& point) const
  {
    if (point.Vertex >= 0)
    {
      return this->In.World.OriginalPosition(point.Vertex);
    }
    const double* q = point.Point.Approximation();
    const Lattice& grid = this->In.World.Grid();
    return { grid.ToWorld(q[0]), grid.ToWorld(q[1]), grid.ToWorld(q[2]) };
  }

  const SelfIntersectionInput& In;
  Executor& Threads;
  Monitor& Watch;
};

} // namespace

std::vector<std::uint8_t> FindFacesWithoutArea(const Scene& scene, Executor& executor)
{
  const std::int64_t count = scene.NumberOfFaces();
  std::vector<std::uint8_t> collapsed(static_cast<std::size_t>(count), 0);
  std::atomic<bool> isAny{ false };
  executor.For(count, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t face = begin; face < end; ++face)
    {
      const std::int32_t* ids = scene.Mesh(0).Triangles + 3 * face;
      if (ComputeDominantNormal(
            scene.Position(ids[0]), scene.Position(ids[1]), scene.Position(ids[2]))
            .Sign == 0)
      {
        collapsed[std::size_t(face)] = 1;
        isAny = true;
      }
    }
  });
  return isAny ? collapsed : std::vector<std::uint8_t>();
}

SelfIntersections FindSelfIntersections(
  const SelfIntersectionInput& input, Executor& executor, Monitor& monitor)
{
  return SelfSearch(input, executor, monitor).Run();
}

} // namespace sb
