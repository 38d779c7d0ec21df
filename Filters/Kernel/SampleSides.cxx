// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleSides.h"

#include <algorithm>
#include <cstddef>

namespace sb
{
namespace
{

constexpr std::int64_t BlockSize = 128;

void AskOneByOne(const PointTree& samples, const ToolSurface& tool, std::int64_t begin,
  std::int64_t end, std::vector<std::uint8_t>& inside)
{
  for (std::int64_t i = begin; i < end; ++i)
  {
    inside[static_cast<std::size_t>(i)] =
      tool.IsInside(samples.Point(static_cast<std::int32_t>(i))) ? 1 : 0;
  }
}

/** Halves a block until all of it is on one side, or little is left of it. */
void AskBlock(const PointTree& samples, const ToolSurface& tool, std::int64_t begin,
  std::int64_t end, std::vector<std::uint8_t>& inside)
{
  constexpr std::int64_t few = 4;
  if (end - begin <= few)
  {
    AskOneByOne(samples, tool, begin, end, inside);
    return;
  }
  Real3 lower = samples.Point(static_cast<std::int32_t>(begin));
  Real3 upper = lower;
  for (std::int64_t i = begin + 1; i < end; ++i)
  {
    const Real3 p = samples.Point(static_cast<std::int32_t>(i));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      lower[axis] = std::min(lower[axis], p[axis]);
      upper[axis] = std::max(upper[axis], p[axis]);
    }
  }
  const Real3 middle = Scaled(PlusScaled(lower, 1.0, upper), 0.5);
  const double radius = 0.5000001 * Length(Difference(upper, lower));
  if (tool.Distance(middle, radius) < radius)
  {
    const std::int64_t half = (begin + end) / 2;
    AskBlock(samples, tool, begin, half, inside);
    AskBlock(samples, tool, half, end, inside);
    return;
  }
  std::fill(inside.begin() + begin, inside.begin() + end,
    static_cast<std::uint8_t>(tool.IsInside(middle) ? 1 : 0));
}

} // namespace

std::vector<std::uint8_t> FindInside(
  const PointTree& samples, const ToolSurface& tool, Executor& executor, Monitor& monitor)
{
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(samples.Size()), 0);
  const std::int64_t blocks = (samples.Size() + BlockSize - 1) / BlockSize;
  executor.For(blocks, 4, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t block = begin; block < end && !monitor.Aborted(); ++block)
    {
      AskBlock(samples, tool, block * BlockSize,
        std::min<std::int64_t>(samples.Size(), (block + 1) * BlockSize), inside);
    }
  });
  return inside;
}

} // namespace sb
