// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleBlocks.h"

#include <algorithm>
#include <limits>

namespace sb
{

namespace
{

std::int64_t NumberOfBlocks(std::int64_t triangles)
{
  return (triangles + TriangleBlock::Size - 1) / TriangleBlock::Size;
}

} // namespace

TriangleBlock BlockOf(
  const double* points, const std::int32_t* triangles, std::int64_t begin, std::int64_t end)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  TriangleBlock block{ { { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } },
    triangles[3 * begin], triangles[3 * begin] };
  for (std::int64_t corner = 3 * begin; corner < 3 * end; ++corner)
  {
    const std::int32_t id = triangles[corner];
    block.LowestPoint = std::min(block.LowestPoint, id);
    block.HighestPoint = std::max(block.HighestPoint, id);
    const double* point = points + 3 * static_cast<std::int64_t>(id);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block.Bounds.Lower[axis] = std::min(block.Bounds.Lower[axis], point[axis]);
      block.Bounds.Upper[axis] = std::max(block.Bounds.Upper[axis], point[axis]);
    }
  }
  return block;
}

std::vector<TriangleBlock> BlocksOf(
  const double* points, const std::int32_t* triangles, std::int64_t count, Executor& executor)
{
  std::vector<TriangleBlock> blocks(static_cast<std::size_t>(NumberOfBlocks(count)));
  executor.For(
    static_cast<std::int64_t>(blocks.size()), 64, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        blocks[static_cast<std::size_t>(i)] = BlockOf(points, triangles, i * TriangleBlock::Size,
          std::min(count, (i + 1) * TriangleBlock::Size));
      }
    });
  return blocks;
}

NearBlocks::NearBlocks(
  const std::vector<const std::vector<TriangleBlock>*>& blocks, Executor& executor)
  : Blocks(blocks)
  , Host(executor)
  , Hierarchies(blocks.size())
{
  for (const std::vector<TriangleBlock>* surface : blocks)
  {
    this->Marks.emplace_back(surface->size(), std::uint8_t(0));
  }
}

void NearBlocks::MarkAll(std::size_t surface)
{
  std::fill(this->Marks[surface].begin(), this->Marks[surface].end(), std::uint8_t(1));
}

void NearBlocks::MarkMeeting(std::size_t a, std::size_t b, const Box& common)
{
  this->MarkThoseThatMeet(a, b, common);
  this->MarkThoseThatMeet(b, a, common);
}

void NearBlocks::MarkThoseThatMeet(std::size_t surface, std::size_t other, const Box& common)
{
  const BVH& others = this->HierarchyOf(other);
  const std::vector<TriangleBlock>& blocks = *this->Blocks[surface];
  std::vector<std::uint8_t>& marks = this->Marks[surface];
  this->Host.For(
    static_cast<std::int64_t>(blocks.size()), 64, [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        if (marks[i] == 0 && Overlap(blocks[i].Bounds, common))
        {
          marks[i] = others.AnyOverlap(blocks[i].Bounds);
        }
      }
    });
}

const BVH& NearBlocks::HierarchyOf(std::size_t surface)
{
  BVH& hierarchy = this->Hierarchies[surface];
  if (hierarchy.Size() == 0)
  {
    std::vector<Box> boxes;
    for (const TriangleBlock& block : *this->Blocks[surface])
    {
      boxes.push_back(block.Bounds);
    }
    hierarchy.Build(boxes.data(), static_cast<std::int32_t>(boxes.size()), this->Host);
  }
  return hierarchy;
}

std::vector<std::pair<std::int64_t, std::int64_t>> NearBlocks::Runs(std::size_t surface) const
{
  const std::vector<std::uint8_t>& marks = this->Marks[surface];
  std::vector<std::pair<std::int64_t, std::int64_t>> runs;
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(marks.size()); ++i)
  {
    if (marks[static_cast<std::size_t>(i)] == 0)
    {
      continue;
    }
    if (runs.empty() || runs.back().second != i)
    {
      runs.emplace_back(i, i);
    }
    runs.back().second = i + 1;
  }
  return runs;
}

} // namespace sb
