// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudSampling.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 512;

void SampleOne(const MovingLeastSquares& surface, const double* point, std::int64_t i,
  const CloudArrays& arrays, MovingLeastSquares::Neighbourhood& near)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Real3 start{ point[0], point[1], point[2] };
  Real3 x = start;
  const SurfaceValue f = IsFinite(start) ? surface.Project(x, near) : SurfaceValue();
  const double steepness = Length(f.Gradient);
  const bool reached = f.IsNear && steepness > 0.0;
  if (arrays.Validity)
  {
    arrays.Validity[i] = static_cast<std::uint8_t>(reached ? f.Where : Support::Far);
  }
  if (arrays.Projected)
  {
    std::copy_n(x.begin(), 3, arrays.Projected + 3 * i);
  }
  const Real3 normal = reached ? Scaled(f.Gradient, 1.0 / steepness) : Real3{};
  if (arrays.Normal && reached)
  {
    std::copy_n(normal.begin(), 3, arrays.Normal + 3 * i);
  }
  if (arrays.Residual)
  {
    const Real3 away = Difference(start, x);
    arrays.Residual[i] = reached ? std::copysign(Length(away), Dot(away, normal)) : none;
  }
  if (arrays.MaximumCurvature && arrays.MinimumCurvature)
  {
    const SurfaceCurvature curvature =
      reached ? CurvatureOf(surface.EvaluateNear(x, 2, near)) : SurfaceCurvature{ none, none };
    arrays.MaximumCurvature[i] = curvature.Maximum;
    arrays.MinimumCurvature[i] = curvature.Minimum;
  }
}

} // namespace

bool SampleCloudSurface(const MovingLeastSquares& surface, const double* points, std::int64_t count,
  const CloudArrays& arrays, Executor& executor, Monitor& monitor)
{
  // The cloud's own points in the order of its tree, where neighbours follow one another; any
  // others after them.
  const PointTree& samples = surface.Samples();
  std::vector<std::int64_t> order;
  order.reserve(static_cast<std::size_t>(count));
  std::vector<std::uint8_t> listed(static_cast<std::size_t>(count), 0);
  for (std::int32_t i = 0; i < samples.Size(); ++i)
  {
    if (samples.Id(i) < count)
    {
      order.push_back(samples.Id(i));
      listed[static_cast<std::size_t>(samples.Id(i))] = 1;
    }
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (!listed[static_cast<std::size_t>(i)])
    {
      order.push_back(i);
    }
  }
  std::atomic<bool> stopped{ false };
  // In ten parts, between which the calling thread tells of the progress.
  for (std::int64_t part = 0; part < 10 && !stopped; ++part)
  {
    monitor.Progress(static_cast<double>(part) / 10.0, "Project points");
    const std::int64_t first = count * part / 10;
    executor.For(count * (part + 1) / 10 - first, Grain, [&](std::int64_t begin, std::int64_t end) {
      MovingLeastSquares::Neighbourhood near;
      for (std::int64_t k = first + begin; k < first + end && !stopped; ++k)
      {
        const std::int64_t i = order[static_cast<std::size_t>(k)];
        SampleOne(surface, points + 3 * i, i, arrays, near);
      }
      if (monitor.Aborted())
      {
        stopped = true;
      }
    });
  }
  return !stopped;
}

} // namespace sb
