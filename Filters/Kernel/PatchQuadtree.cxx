// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchQuadtree.h"

#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace sb
{
namespace
{

constexpr std::uint32_t Levels = 20;
constexpr std::uint32_t RootSteps = 1u << Levels;
constexpr double MostRoots = 64.0;
constexpr std::int64_t Grain = 64;

std::uint64_t KeyOf(std::uint32_t u, std::uint32_t v)
{
  return static_cast<std::uint64_t>(v) << 32 | u;
}

/** Whether a sample may be within the reach of a box. */
bool HasSampleNear(const PointTree& samples, const Real3& lower, const Real3& upper, double reach)
{
  const auto apart = [&](const Real3& l, const Real3& u) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double gap = std::max(std::max(l[k] - upper[k], lower[k] - u[k]), 0.0);
      sum += gap * gap;
    }
    return sum;
  };
  const double limit = reach * reach;
  bool found = false;
  samples.ForRanges([&](const Real3& l, const Real3& u) { return !found && apart(l, u) <= limit; },
    [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t i = begin; !found && i < end; ++i)
      {
        const Real3 x = samples.Point(i);
        found = apart(x, x) <= limit;
      }
    });
  return found;
}

} // namespace

PatchQuadtree::PatchQuadtree(const NURBSSurface& patch, const TrimmedDomain& domain,
  const PointTree& samples, const Request& request, Executor& executor, Monitor& monitor)
  : Patch(patch)
  , Domain(domain)
  , Samples(samples)
  , Wanted(request)
  , Threads(executor)
  , Watch(monitor)
{
  this->ChooseRoots();
  this->Subdivide();
  this->Balance();
  this->ListVertices();
}

/** As many roots side by side as make them about as long as wide in space. */
void PatchQuadtree::ChooseRoots()
{
  constexpr int samples = 8;
  const ParameterBox& box = this->Domain.Box();
  double alongU = 0.0;
  double alongV = 0.0;
  const auto at = [&](int i, int j) {
    return EvaluatePatch(this->Patch, box.FirstU + (box.LastU - box.FirstU) * i / samples,
      box.FirstV + (box.LastV - box.FirstV) * j / samples, 0)
      .Point;
  };
  for (int i = 0; i < samples; ++i)
  {
    for (int j = 0; j <= samples; ++j)
    {
      alongU += Length(Difference(at(i + 1, j), at(i, j)));
      alongV += Length(Difference(at(j, i + 1), at(j, i)));
    }
  }
  const auto roots = [](double ratio) {
    return static_cast<std::uint32_t>(std::round(std::clamp(ratio, 1.0, MostRoots)));
  };
  this->RootsU = alongV > 0.0 ? roots(alongU / alongV) : 1;
  this->RootsV = alongU > 0.0 ? roots(alongV / alongU) : 1;
}

ParameterBox PatchQuadtree::BoxOf(const Cell& cell) const
{
  const ParameterBox& box = this->Domain.Box();
  const double stepU = (box.LastU - box.FirstU) / (double(this->RootsU) * RootSteps);
  const double stepV = (box.LastV - box.FirstV) / (double(this->RootsV) * RootSteps);
  const std::uint32_t size = RootSteps >> cell.Level;
  return { box.FirstU + stepU * cell.U, box.FirstU + stepU * (cell.U + size),
    box.FirstV + stepV * cell.V, box.FirstV + stepV * (cell.V + size) };
}

Parameters PatchQuadtree::ParametersOf(std::size_t vertex) const
{
  const std::uint64_t key = this->Vertices[vertex];
  const ParameterBox lower =
    this->BoxOf({ static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32), 0 });
  return { lower.FirstU, lower.FirstV };
}

PatchQuadtree::Verdict PatchQuadtree::Judge(const Cell& cell) const
{
  const ParameterBox box = this->BoxOf(cell);
  const PatchBounds bounds = BoundsOf(this->Patch, box);
  if (!HasSampleNear(this->Samples, bounds.Lower, bounds.Upper, this->Wanted.Reach))
  {
    return Verdict::Empty;
  }
  const bool isSmall =
    bounds.LengthU <= this->Wanted.Longest && bounds.LengthV <= this->Wanted.Longest;
  if (isSmall || cell.Level == Levels)
  {
    return this->Domain.MayMeet(box) ? Verdict::Small : Verdict::Empty;
  }
  return Verdict::Split;
}

void PatchQuadtree::Subdivide()
{
  std::vector<Cell> level;
  for (std::uint32_t v = 0; v < this->RootsV; ++v)
  {
    for (std::uint32_t u = 0; u < this->RootsU; ++u)
    {
      level.push_back({ u * RootSteps, v * RootSteps, 0 });
    }
  }
  while (!level.empty() && !this->Watch.Aborted())
  {
    std::vector<Verdict> verdicts(level.size(), Verdict::Empty);
    this->Threads.For(
      static_cast<std::int64_t>(level.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin);
             i < static_cast<std::size_t>(end) && !this->Watch.Aborted(); ++i)
        {
          verdicts[i] = this->Judge(level[i]);
        }
      });
    std::vector<Cell> next;
    for (std::size_t i = 0; i < level.size(); ++i)
    {
      const Cell& cell = level[i];
      if (verdicts[i] == Verdict::Small)
      {
        this->Cells.push_back(cell);
      }
      const std::uint32_t half = RootSteps >> (cell.Level + 1);
      for (std::uint32_t child = 0; verdicts[i] == Verdict::Split && child < 4; ++child)
      {
        next.push_back(
          { cell.U + (child % 2) * half, cell.V + (child / 2) * half, cell.Level + 1 });
      }
    }
    level.swap(next);
  }
}

/** Split cells beside much smaller ones. */
void PatchQuadtree::Balance()
{
  const auto keyOf = [](const Cell& cell) {
    return (static_cast<std::uint64_t>(cell.V) << 32 | cell.U) * 32 + cell.Level;
  };
  std::unordered_set<std::uint64_t> keys;
  for (const Cell& cell : this->Cells)
  {
    keys.insert(keyOf(cell));
  }
  std::vector<Cell> cells; // those that nothing more is to be done for
  while (!this->Cells.empty() && !this->Watch.Aborted())
  {
    const Cell cell = this->Cells.back();
    this->Cells.pop_back();
    if (keys.count(keyOf(cell)) == 0)
    {
      continue; // split in the meantime
    }
    cells.push_back(cell);
    const std::uint32_t size = RootSteps >> cell.Level;
    const std::uint32_t besideU[4] = { cell.U - size, cell.U + size, cell.U, cell.U };
    const std::uint32_t besideV[4] = { cell.V, cell.V, cell.V - size, cell.V + size };
    for (int side = 0; side < 4; ++side)
    {
      for (std::uint32_t level = 0; level + 1 < cell.Level; ++level)
      {
        const std::uint32_t mask = ~((RootSteps >> level) - 1);
        const Cell large{ besideU[side] & mask, besideV[side] & mask, level };
        if (keys.erase(keyOf(large)) == 0)
        {
          continue;
        }
        const std::uint32_t half = RootSteps >> (level + 1);
        for (std::uint32_t child = 0; child < 4; ++child)
        {
          const Cell part{ large.U + (child % 2) * half, large.V + (child / 2) * half, level + 1 };
          if (this->Judge(part) != Verdict::Empty)
          {
            keys.insert(keyOf(part));
            this->Cells.push_back(part);
          }
        }
      }
    }
  }
  for (const Cell& cell : cells)
  {
    if (keys.count(keyOf(cell)) != 0)
    {
      this->Cells.push_back(cell);
    }
  }
  std::sort(this->Cells.begin(), this->Cells.end(),
    [&](const Cell& a, const Cell& b) { return keyOf(a) < keyOf(b); });
}

void PatchQuadtree::Halve(const std::vector<std::uint8_t>& isChosen)
{
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < this->Cells.size(); ++i)
  {
    const Cell& cell = this->Cells[i];
    if (!isChosen[i] || cell.Level >= Levels)
    {
      cells.push_back(cell);
      continue;
    }
    const std::uint32_t half = RootSteps >> (cell.Level + 1);
    for (std::uint32_t child = 0; child < 4; ++child)
    {
      const Cell part{ cell.U + (child % 2) * half, cell.V + (child / 2) * half, cell.Level + 1 };
      if (this->Judge(part) != Verdict::Empty)
      {
        cells.push_back(part);
      }
    }
  }
  this->Cells.swap(cells);
  this->Balance();
  this->ListVertices();
}

void PatchQuadtree::ListVertices()
{
  this->Vertices.clear();
  for (const Cell& cell : this->Cells)
  {
    const std::uint32_t size = RootSteps >> cell.Level;
    for (std::uint32_t corner = 0; corner < 4; ++corner)
    {
      this->Vertices.push_back(KeyOf(cell.U + (corner % 2) * size, cell.V + (corner / 2) * size));
    }
  }
  ParallelSortUnique(this->Vertices, this->Threads);
}

void PatchQuadtree::AddSide(
  std::uint64_t from, std::uint64_t to, std::vector<std::size_t>& ring) const
{
  const auto find = [&](std::uint64_t key) {
    return std::lower_bound(this->Vertices.begin(), this->Vertices.end(), key);
  };
  const std::uint64_t middle = from / 2 + to / 2; // u and v are even where cells have a middle
  const auto found = find(middle);
  const bool isLong = std::max(from, to) - std::min(from, to) != 1 &&
    std::max(from, to) - std::min(from, to) != std::uint64_t(1) << 32;
  if (isLong && found != this->Vertices.end() && *found == middle)
  {
    this->AddSide(from, middle, ring);
    this->AddSide(middle, to, ring);
    return;
  }
  ring.push_back(static_cast<std::size_t>(find(from) - this->Vertices.begin()));
}

void PatchQuadtree::RingOf(std::size_t cell, std::vector<std::size_t>& ring) const
{
  const Cell& of = this->Cells[cell];
  const std::uint32_t size = RootSteps >> of.Level;
  const std::uint64_t corners[4] = { KeyOf(of.U, of.V), KeyOf(of.U + size, of.V),
    KeyOf(of.U + size, of.V + size), KeyOf(of.U, of.V + size) };
  ring.clear();
  for (std::size_t k = 0; k < 4; ++k)
  {
    this->AddSide(corners[k], corners[(k + 1) % 4], ring);
  }
}

} // namespace sb
