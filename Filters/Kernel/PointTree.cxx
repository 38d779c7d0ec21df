// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointTree.h"

#include "ParallelSort.h"

#include <algorithm>

namespace sb
{
namespace
{

bool Precedes(const Real3& a, const Real3& b, std::size_t firstAxis)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t axis = (firstAxis + k) % 3;
    if (a[axis] != b[axis])
    {
      return a[axis] < b[axis];
    }
  }
  return false;
}

} // namespace

PointTree::PointTree(
  const double* points, std::int64_t count, const double* preference, Executor& executor)
{
  std::vector<Record> records;
  records.reserve(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i)
  {
    const Real3 position{ points[3 * i], points[3 * i + 1], points[3 * i + 2] };
    if (IsFinite(position))
    {
      records.push_back({ position, static_cast<std::int32_t>(i) });
    }
  }
  this->NotFinite = count - static_cast<std::int64_t>(records.size());
  this->DropDuplicates(records, preference, executor);
  if (records.empty())
  {
    return;
  }
  const std::int64_t kept = static_cast<std::int64_t>(records.size());
  this->Ids.resize(records.size());
  while (((kept + GroupSize - 1) / GroupSize >> this->Levels) > 1)
  {
    ++this->Levels;
  }
  this->FirstLeaf = std::size_t(1) << this->Levels;
  this->Boxes.resize(2 * this->FirstLeaf);
  for (int level = 0; level <= this->Levels; ++level)
  {
    this->Split(records, level, executor);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Axes[axis].resize(records.size());
  }
  executor.For(kept, 1 << 14, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      this->Ids[i] = records[i].Id;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->Axes[axis][i] = records[i].Position[axis];
      }
    }
  });
}

void PointTree::DropDuplicates(
  std::vector<Record>& records, const double* preference, Executor& executor)
{
  const auto preferenceOf = [preference](const Record& record) {
    const double* const triple = preference + 3 * static_cast<std::int64_t>(record.Id);
    return Real3{ triple[0], triple[1], triple[2] };
  };
  ParallelSort(
    records,
    [&](const Record& a, const Record& b) {
      if (a.Position != b.Position)
      {
        return Precedes(a.Position, b.Position, 0);
      }
      if (preference && preferenceOf(a) != preferenceOf(b))
      {
        return Precedes(preferenceOf(a), preferenceOf(b), 0);
      }
      return a.Id < b.Id;
    },
    executor);
  const auto last = std::unique(records.begin(), records.end(),
    [](const Record& a, const Record& b) { return a.Position == b.Position; });
  this->Duplicates = records.end() - last;
  records.erase(last, records.end());
}

/** Find the boxes of the nodes of one level, and put the points of each into halves; those of a
 * leaf into an order of their own. */
void PointTree::Split(std::vector<Record>& records, int level, Executor& executor)
{
  const std::int64_t count = static_cast<std::int64_t>(records.size());
  executor.For(std::int64_t(1) << level, 1, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t node = begin; node < end; ++node)
    {
      const auto first = records.begin() + StartOf(node, level, count);
      const auto last = records.begin() + StartOf(node + 1, level, count);
      Box box{ first->Position, first->Position };
      for (auto record = first; record != last; ++record)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          box.Lower[axis] = std::min(box.Lower[axis], record->Position[axis]);
          box.Upper[axis] = std::max(box.Upper[axis], record->Position[axis]);
        }
      }
      this->Boxes[static_cast<std::size_t>((std::int64_t(1) << level) + node)] = box;
      const Real3 extent = Difference(box.Upper, box.Lower);
      const std::size_t widest =
        static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
      const auto less = [widest](const Record& a, const Record& b) {
        return Precedes(a.Position, b.Position, widest);
      };
      if (level == this->Levels)
      {
        std::sort(first, last, less);
      }
      else
      {
        const auto middle = records.begin() + StartOf(2 * node + 1, level + 1, count);
        std::nth_element(first, middle, last, less);
      }
    }
  });
}

int PointTree::Nearest(const Real3& x, int k, Neighbour* found) const
{
  int count = 0;
  if (this->Boxes.empty() || k <= 0)
  {
    return 0;
  }
  struct Entry
  {
    double SquaredDistance;
    std::size_t Node;
  };
  Entry stack[64];
  int depth = 0;
  stack[depth++] = { 0.0, 1 };
  const auto insert = [&](double squared, std::int32_t index) {
    const Neighbour candidate{ squared, index };
    const auto nearer = [](const Neighbour& a, const Neighbour& b) {
      return a.SquaredDistance != b.SquaredDistance ? a.SquaredDistance < b.SquaredDistance
                                                    : a.Index < b.Index;
    };
    if (count == k && !nearer(candidate, found[count - 1]))
    {
      return;
    }
    int place = count < k ? count++ : k - 1;
    for (; place > 0 && nearer(candidate, found[place - 1]); --place)
    {
      found[place] = found[place - 1];
    }
    found[place] = candidate;
  };
  while (depth > 0)
  {
    const Entry entry = stack[--depth];
    if (count == k && entry.SquaredDistance > found[k - 1].SquaredDistance)
    {
      continue;
    }
    if (entry.Node >= this->FirstLeaf)
    {
      const std::int64_t leaf = static_cast<std::int64_t>(entry.Node - this->FirstLeaf);
      for (std::int32_t i = this->StartOf(leaf); i < this->StartOf(leaf + 1); ++i)
      {
        const Real3 away = Difference(x, this->Point(i));
        insert(Dot(away, away), i);
      }
      continue;
    }
    Entry halves[2];
    for (std::size_t half = 0; half < 2; ++half)
    {
      const Box& box = this->Boxes[2 * entry.Node + half];
      halves[half] = { SquaredDistance(x, box.Lower, box.Upper), 2 * entry.Node + half };
    }
    const std::size_t near = halves[0].SquaredDistance <= halves[1].SquaredDistance ? 0 : 1;
    stack[depth++] = halves[1 - near];
    stack[depth++] = halves[near];
  }
  return count;
}

std::vector<double> PointTree::LargestOfNodes(const double* values) const
{
  std::vector<double> largest(this->Boxes.size(), 0.0);
  for (std::size_t node = this->Boxes.size(); node-- > 1;)
  {
    if (node < this->FirstLeaf)
    {
      largest[node] = std::max(largest[2 * node], largest[2 * node + 1]);
      continue;
    }
    const std::int64_t leaf = static_cast<std::int64_t>(node - this->FirstLeaf);
    largest[node] =
      *std::max_element(values + this->StartOf(leaf), values + this->StartOf(leaf + 1));
  }
  return largest;
}

double SpacingOf(const PointTree& tree, Executor& executor)
{
  constexpr int neighbours = 8;
  constexpr std::int32_t mostSamples = 20000;
  constexpr double pi = 3.14159265358979323846;
  const std::int32_t stride = std::max(1, tree.Size() / mostSamples);
  std::vector<double> sides(static_cast<std::size_t>(tree.Size() / stride));
  executor.For(
    static_cast<std::int64_t>(sides.size()), 256, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        PointTree::Neighbour found[neighbours + 1]; // the point itself is the first
        const int count =
          tree.Nearest(tree.Point(static_cast<std::int32_t>(i) * stride), neighbours + 1, found);
        sides[static_cast<std::size_t>(i)] = count < 2
          ? 0.0
          : std::sqrt(found[count - 1].SquaredDistance * pi / static_cast<double>(count - 1));
      }
    });
  if (sides.empty())
  {
    return 0.0;
  }
  const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
  std::nth_element(sides.begin(), middle, sides.end());
  return *middle;
}

} // namespace sb
