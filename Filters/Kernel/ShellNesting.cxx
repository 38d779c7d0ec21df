// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShellNesting.h"

#include "Arrangement.h"
#include "ProbePlacement.h"
#include "WindingQuery.h"

#include <algorithm>
#include <cmath>

namespace sb
{

namespace
{

/** Lines that meet an edge are placed anew; nothing regular meets one that often. */
constexpr int MostAttempts = 64;

bool MayHold(const Box& outer, const Box& inner)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (inner.Lower[axis] < outer.Lower[axis] || inner.Upper[axis] > outer.Upper[axis])
    {
      return false;
    }
  }
  return true;
}

class NestingSearch
{
public:
  NestingSearch(const Scene& scene, const std::vector<std::uint8_t>& collapsed, ShellSet& shells,
    Executor& executor, Monitor& monitor)
    : World(scene)
    , Collapsed(collapsed)
    , Set(shells)
    , Threads(executor)
    , Watch(monitor)
  {
  }

  void Run()
  {
    for (Shell& shell : this->Set.Shells)
    {
      // What it is by itself; the sign of the volume is what a Boolean goes by, too.
      shell.WindingInFront = shell.IsClosed && shell.Volume < 0.0 ? -1 : 0;
    }
    std::vector<std::int32_t> open = this->ShellsThatMayBeInside();
    const Arrangement noCuts{};
    const ProbePlacement placement(this->World, noCuts);
    for (int attempt = 0; attempt < MostAttempts && !open.empty() && !this->Watch.Aborted();
         ++attempt)
    {
      open = this->Ask(open, placement, attempt);
    }
  }

private:
  std::vector<std::int32_t> ShellsThatMayBeInside()
  {
    std::vector<Box> boxes;
    for (const Shell& shell : this->Set.Shells)
    {
      boxes.push_back(shell.Bounds);
    }
    this->FindProbedFaces();
    BVH tree;
    tree.Build(boxes.data(), static_cast<std::int32_t>(boxes.size()), this->Threads);
    std::vector<std::uint8_t> may(boxes.size(), 0);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      const BVH::Query query{ boxes[i], 0 };
      tree.ForEachOverlap(&query, 1, [&](int, std::int32_t other) {
        const auto j = static_cast<std::size_t>(other);
        may[i] = may[i] || (j != i && this->Set.Shells[j].IsClosed && MayHold(boxes[j], boxes[i]));
      });
    }
    std::vector<std::int32_t> list;
    for (std::size_t i = 0; i < may.size(); ++i)
    {
      if (may[i] && this->Probed[i] >= 0)
      {
        list.push_back(static_cast<std::int32_t>(i));
      }
    }
    return list;
  }

  /** The first triangle of each shell that has an area. */
  void FindProbedFaces()
  {
    this->Probed.assign(this->Set.Shells.size(), -1);
    for (std::size_t face = 0; face < this->Set.OfTriangle.size(); ++face)
    {
      const std::int32_t shell = this->Set.OfTriangle[face];
      if (shell >= 0 && this->Probed[std::size_t(shell)] < 0 &&
        (this->Collapsed.empty() || !this->Collapsed[face]))
      {
        this->Probed[std::size_t(shell)] = static_cast<std::int32_t>(face);
      }
    }
  }

  /** @return the shells that have to be asked for again, with another line. */
  std::vector<std::int32_t> Ask(
    const std::vector<std::int32_t>& shells, const ProbePlacement& placement, int attempt)
  {
    std::vector<WindingQuery> queries;
    for (const std::int32_t shell : shells)
    {
      const auto line = placement.Place(this->Probed[std::size_t(shell)], -1, attempt);
      queries.push_back({ *line, 0, 0, false }); // a whole face always has a place
    }
    std::vector<FaceAbove> above;
    AnswerQueries(this->World, this->Collapsed, queries, this->Threads, &above);
    std::vector<std::int32_t> again;
    auto begin = above.begin();
    for (std::size_t i = 0; i < shells.size(); ++i)
    {
      const auto end = std::find_if(begin, above.end(),
        [i](const FaceAbove& face) { return face.Query != static_cast<std::int32_t>(i); });
      if (queries[i].Degenerate)
      {
        again.push_back(shells[i]);
      }
      else
      {
        this->Place(shells[i], std::vector<FaceAbove>(begin, end));
      }
      begin = end;
    }
    return again;
  }

  /** From what is above one of its triangles. */
  void Place(std::int32_t number, std::vector<FaceAbove> above)
  {
    const auto shellOf = [this](const FaceAbove& face) {
      return this->Set.OfTriangle[std::size_t(face.Face)];
    };
    std::sort(above.begin(), above.end(), [&](const FaceAbove& l, const FaceAbove& r) {
      return shellOf(l) != shellOf(r) ? shellOf(l) < shellOf(r) : l.Face < r.Face;
    });
    Shell& shell = this->Set.Shells[std::size_t(number)];
    for (std::size_t begin = 0; begin < above.size();)
    {
      const std::int32_t other = shellOf(above[begin]);
      int winding = 0;
      std::size_t end = begin;
      for (; end < above.size() && shellOf(above[end]) == other; ++end)
      {
        winding += above[end].Turn;
      }
      begin = end;
      if (other != number && other >= 0 && winding != 0 &&
        this->Set.Shells[std::size_t(other)].IsClosed)
      {
        ++shell.Depth;
        shell.WindingInFront += winding;
        shell.Parent = this->Smaller(shell.Parent, other);
      }
    }
  }

  /** The one of two shells around a third that is inside of the other, if they do not cross. */
  std::int32_t Smaller(std::int32_t a, std::int32_t b) const
  {
    if (a < 0)
    {
      return b;
    }
    const Shell& first = this->Set.Shells[std::size_t(a)];
    const Shell& second = this->Set.Shells[std::size_t(b)];
    return std::abs(second.Volume) < std::abs(first.Volume) ? b : a;
  }

  const Scene& World;
  const std::vector<std::uint8_t>& Collapsed;
  ShellSet& Set;
  Executor& Threads;
  Monitor& Watch;
  std::vector<std::int32_t> Probed; ///< [shell] a face of it, or -1
};

} // namespace

void FindNesting(const Scene& scene, const std::vector<std::uint8_t>& collapsed, ShellSet& shells,
  Executor& executor, Monitor& monitor)
{
  NestingSearch(scene, collapsed, shells, executor, monitor).Run();
}

} // namespace sb
