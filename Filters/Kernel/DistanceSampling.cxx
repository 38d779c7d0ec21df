// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceSampling.h"

#include "ParallelSort.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 8192;
constexpr int BitsAnAxis = 10;
/** So many neighbours along the curve share guesses; the next ones start anew. */
constexpr std::int64_t RunLength = 512;
constexpr std::int64_t RunsBetweenReports = 64;

/** Spread the 10 lowest bits so that two zeros follow each. */
std::uint32_t Spread(std::uint32_t bits)
{
  bits = (bits | bits << 16) & 0x030000ffu;
  bits = (bits | bits << 8) & 0x0300f00fu;
  bits = (bits | bits << 4) & 0x030c30c3u;
  return (bits | bits << 2) & 0x09249249u;
}

struct Bounds
{
  std::array<double, 3> Lower;
  std::array<double, 3> Upper;
};

Bounds BoundsOf(const DistanceRequest& request, Executor& executor)
{
  std::vector<Bounds> blocks(static_cast<std::size_t>((request.Count - 1) / Grain + 1));
  executor.For(request.Count, Grain, [&](std::int64_t begin, std::int64_t end) {
    Bounds bounds;
    bounds.Lower.fill(std::numeric_limits<double>::max());
    bounds.Upper.fill(std::numeric_limits<double>::lowest());
    for (std::int64_t i = begin; i < end; ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double value = request.Points[3 * i + static_cast<std::int64_t>(axis)];
        if (std::isfinite(value))
        {
          bounds.Lower[axis] = std::min(bounds.Lower[axis], value);
          bounds.Upper[axis] = std::max(bounds.Upper[axis], value);
        }
      }
    }
    blocks[static_cast<std::size_t>(begin / Grain)] = bounds;
  });
  Bounds all = blocks.front();
  for (const Bounds& block : blocks)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      all.Lower[axis] = std::min(all.Lower[axis], block.Lower[axis]);
      all.Upper[axis] = std::max(all.Upper[axis], block.Upper[axis]);
    }
  }
  return all;
}

/** The points' numbers along the Morton curve through their box. */
std::vector<KeyedIndex> OrderAlongCurve(const DistanceRequest& request, Executor& executor)
{
  const Bounds bounds = BoundsOf(request, executor);
  double side = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    side = std::max(side, bounds.Upper[axis] - bounds.Lower[axis]);
  }
  constexpr double last = (1 << BitsAnAxis) - 1;
  const double scale = side > 0.0 && std::isfinite(side) ? last / side : 0.0;
  std::vector<KeyedIndex> order(static_cast<std::size_t>(request.Count));
  executor.For(request.Count, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      std::uint64_t key = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double place =
          (request.Points[3 * i + static_cast<std::int64_t>(axis)] - bounds.Lower[axis]) * scale;
        const double cell = place > 0.0 ? std::min(place, last) : 0.0;
        key |= std::uint64_t(Spread(static_cast<std::uint32_t>(cell))) << axis;
      }
      order[static_cast<std::size_t>(i)] = { key, static_cast<std::int32_t>(i) };
    }
  });
  RadixSort(
    order, [](const KeyedIndex& keyed) { return keyed.Key; }, 3 * BitsAnAxis, executor);
  return order;
}

void StoreVector(double* array, std::int64_t i, const Vector3& value)
{
  array[3 * i] = value.X;
  array[3 * i + 1] = value.Y;
  array[3 * i + 2] = value.Z;
}

void Store(const DistanceArrays& arrays, std::int64_t i, const Vector3& query,
  const SurfaceDistance::Answer& answer)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const bool found = answer.Triangle >= 0;
  arrays.Distance[i] = answer.Distance;
  if (arrays.Triangle)
  {
    arrays.Triangle[i] = answer.Triangle;
  }
  if (arrays.Nearest)
  {
    StoreVector(arrays.Nearest, i, found ? answer.Nearest : Vector3{ none, none, none });
  }
  if (arrays.Direction)
  {
    const Vector3 offset = found ? answer.Nearest - query : Vector3{};
    const double length = std::hypot(offset.X, offset.Y, offset.Z);
    StoreVector(arrays.Direction, i, length > 0.0 ? (1.0 / length) * offset : Vector3{});
  }
}

} // namespace

bool SampleDistances(const SurfaceDistance& surface, const DistanceRequest& request,
  const DistanceArrays& arrays, Executor& executor, Monitor& monitor)
{
  if (request.Count <= 0)
  {
    return true;
  }
  const std::vector<KeyedIndex> order = OrderAlongCurve(request, executor);
  const std::int64_t runs = (request.Count + RunLength - 1) / RunLength;
  std::atomic<bool> stopped{ false };
  for (std::int64_t first = 0; first < runs && !stopped; first += RunsBetweenReports)
  {
    monitor.Progress(static_cast<double>(first) / static_cast<double>(runs), "Distances");
    // Some hosts hear of a stop in this thread only, which need not take part in the loop.
    stopped = monitor.Aborted();
    if (stopped)
    {
      break;
    }
    executor.For(std::min(RunsBetweenReports, runs - first), 1,
      [&](std::int64_t firstRun, std::int64_t lastRun) {
        for (std::int64_t run = first + firstRun; run < first + lastRun && !stopped; ++run)
        {
          if (monitor.Aborted())
          {
            stopped = true;
          }
          std::int32_t guess = -1;
          const std::int64_t end = std::min(request.Count, (run + 1) * RunLength);
          for (std::int64_t place = run * RunLength; place < end; ++place)
          {
            const std::int64_t i = order[static_cast<std::size_t>(place)].Index;
            const Vector3 query = PointAt(request.Points, i);
            const SurfaceDistance::Answer answer =
              surface.At(query, request.Rule, guess, request.Limit);
            Store(arrays, i, query, answer);
            guess = answer.Triangle;
          }
        }
      });
  }
  return !stopped;
}

} // namespace sb
