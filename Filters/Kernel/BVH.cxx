// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BVH.cxx
 * @brief Building the hierarchy: a frame, a sort along the curve, and the levels from the lowest
 * up.
 */
#include "BVH.h"

#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 4096;
constexpr int BitsAnAxis = 20;
constexpr int ClassBits = 3;

/** Spread the 20 lowest bits so that two zeros follow each. */
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffffu;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffu;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fu;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3u;
  return (bits | bits << 2) & 0x1249249249249249u;
}

/** The binary order of magnitude of a box, points and huge boxes clamped. */
int Magnitude(const Box& box) { return std::ilogb(std::clamp(LongestSide(box), 1e-300, 1e300)); }

} // namespace

void BVH::Build(const Box* boxes, std::int32_t count, Executor& executor)
{
  this->Numbers.clear();
  this->Boxes.clear();
  this->Levels.clear();
  if (count <= 0)
  {
    return;
  }
  this->ChooseFrame(boxes, count, executor);
  this->SortAlongCurve(boxes, count, executor);
  this->FillLowestLevel(executor);
  while (this->Levels.back().size() > 1)
  {
    this->FillNextLevel(executor);
  }
}

/** The frame has its origin in the middle of all boxes, which it scales into [-1, 1] by a power of
 * two. */
void BVH::ChooseFrame(const Box* boxes, std::int32_t count, Executor& executor)
{
  struct Part
  {
    Box Bounds;
    std::int64_t Magnitudes = 0;
  };
  std::vector<Part> parts(static_cast<std::size_t>((count - 1) / Grain + 1));
  executor.For(
    static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t part = begin; part < end; ++part)
      {
        Part sum{ boxes[part * Grain], 0 };
        const std::int64_t last = std::min<std::int64_t>(count, (part + 1) * Grain);
        for (std::int64_t i = part * Grain; i < last; ++i)
        {
          Enclose(sum.Bounds, boxes[i]);
          sum.Magnitudes += Magnitude(boxes[i]);
        }
        parts[static_cast<std::size_t>(part)] = sum;
      }
    });
  Part all = parts.front();
  for (std::size_t part = 1; part < parts.size(); ++part)
  {
    Enclose(all.Bounds, parts[part].Bounds);
    all.Magnitudes += parts[part].Magnitudes;
  }
  double halfSide = 1e-300;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double lower = all.Bounds.Lower[axis];
    const double upper = all.Bounds.Upper[axis];
    this->Origin[axis] = 0.5 * lower + 0.5 * upper;
    halfSide = std::max({ halfSide, this->Origin[axis] - lower, upper - this->Origin[axis] });
  }
  int exponent = 0;
  std::frexp(halfSide, &exponent);
  this->Scale = std::ldexp(1.0, -exponent);
  this->UsualMagnitude = static_cast<int>(all.Magnitudes / count);
}

/**
 * Along the Morton curve through the boxes' middles, boxes much larger than usual apart from the
 * others: one huge box among small ones would make all the nodes above it huge.
 */
void BVH::SortAlongCurve(const Box* boxes, std::int32_t count, Executor& executor)
{
  std::vector<KeyedIndex> keys(static_cast<std::size_t>(count));
  executor.For(count, Grain, [&](std::int64_t begin, std::int64_t end) {
    constexpr double cells = 1 << BitsAnAxis;
    for (std::int64_t i = begin; i < end; ++i)
    {
      const Box& box = boxes[i];
      std::uint64_t key = static_cast<std::uint64_t>(
        std::clamp((Magnitude(box) - this->UsualMagnitude) / 3, 0, (1 << ClassBits) - 1));
      key <<= 3 * BitsAnAxis;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double middle =
          (0.5 * box.Lower[axis] + 0.5 * box.Upper[axis] - this->Origin[axis]) * this->Scale;
        const double cell = std::min(std::max(0.0, (0.5 * middle + 0.5) * cells), cells - 1.0);
        key |= Spread(static_cast<std::uint64_t>(cell)) << axis;
      }
      keys[static_cast<std::size_t>(i)] = { key, static_cast<std::int32_t>(i) };
    }
  });
  RadixSort(
    keys, [](const KeyedIndex& keyed) { return keyed.Key; }, 3 * BitsAnAxis + ClassBits, executor);
  this->Numbers.resize(keys.size());
  this->Boxes.resize(keys.size());
  executor.For(count, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      this->Numbers[i] = keys[i].Index;
      this->Boxes[i] = boxes[keys[i].Index];
    }
  });
}

void BVH::FillLowestLevel(Executor& executor)
{
  const std::size_t count = this->Numbers.size();
  std::vector<EightBoxes>& nodes = this->Levels.emplace_back((count + Width - 1) / Width);
  executor.For(static_cast<std::int64_t>(nodes.size()), Grain / Width,
    [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        for (int lane = 0; lane < Width; ++lane)
        {
          const std::size_t place = i * Width + static_cast<std::size_t>(lane);
          nodes[i].Set(
            lane, place < count ? this->ToFrame(this->Boxes[place]) : FloatBox::Nothing());
        }
      }
    });
}

void BVH::FillNextLevel(Executor& executor)
{
  std::vector<EightBoxes>& nodes =
    this->Levels.emplace_back((this->Levels.back().size() + Width - 1) / Width);
  const std::vector<EightBoxes>& below = this->Levels[this->Levels.size() - 2];
  executor.For(static_cast<std::int64_t>(nodes.size()), Grain / Width,
    [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        for (int lane = 0; lane < Width; ++lane)
        {
          const std::size_t child = i * Width + static_cast<std::size_t>(lane);
          nodes[i].Set(lane, child < below.size() ? below[child].Bounds() : FloatBox::Nothing());
        }
      }
    });
}

bool BVH::AnyOverlap(const Box& box) const
{
  bool isAny = false;
  const auto always = [](std::int32_t, std::int32_t) { return true; };
  this->Descend(this->ToFrame(box), always, [&](std::int32_t place, const FloatBox&) {
    isAny = Overlap(this->Boxes[static_cast<std::size_t>(place)], box);
    return !isAny;
  });
  return isAny;
}

} // namespace sb
