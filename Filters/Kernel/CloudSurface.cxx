// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudSurface.h"

#include "NormalEstimation.h"
#include "SampleWidths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace sb
{
namespace
{

constexpr std::int32_t FewestPoints = 6;
constexpr double LeastSpacing = 1e-60; ///< curvatures need the fourth power of lengths
constexpr double LargestSpacing = 1e60;
constexpr double MostThin = 0.2; ///< share of points on thin walls
constexpr double NeighboursAtThat = 16.0; ///< that planes are fitted to; a larger width takes more
constexpr std::int64_t Grain = 1 << 14;

/** All steps and what they share. */
class Preparation
{
public:
  Preparation(const CloudRequest& request, Executor& executor, Monitor& monitor)
    : Request(request)
    , Threads(executor)
    , Watch(monitor)
  {
  }

  CloudSurface Run()
  {
    if (this->Request.Count > std::numeric_limits<std::int32_t>::max())
    {
      return this->End(CloudStatus::TooLarge);
    }
    const bool given = this->Request.Normals && this->CopyNormals();
    this->BuildTree(given);
    this->Cloud.NumberOfNotFinite =
      this->Tree->NumberOfNotFinite() - this->Cloud.NumberWithoutNormal;
    this->Cloud.NumberOfDuplicates = this->Tree->NumberOfDuplicates();
    this->Cloud.Spacing = SpacingOf(*this->Tree, this->Threads);
    if (this->Tree->Size() < FewestPoints)
    {
      return this->End(CloudStatus::TooFewPoints);
    }
    // Points of the tree differ, so none at all and infinity are squares that were no numbers.
    if (!(this->Cloud.Spacing >= LeastSpacing && this->Cloud.Spacing <= LargestSpacing))
    {
      return this->End(CloudStatus::OutOfScale);
    }
    if (!given)
    {
      const CloudStatus status = this->Estimate();
      if (status != CloudStatus::Ok)
      {
        return this->End(status);
      }
    }
    if (this->Watch.Aborted())
    {
      return this->End(CloudStatus::Aborted);
    }
    for (double& coordinate : this->Cloud.Normals)
    {
      coordinate = this->Request.Flip ? -coordinate : coordinate;
    }
    this->MakeSurface();
    return std::move(this->Cloud);
  }

private:
  CloudSurface End(CloudStatus status)
  {
    this->Cloud.Status = status;
    return std::move(this->Cloud);
  }

  void MakeSurface()
  {
    const SampleWidths widths = WidthsOfSamples(*this->Tree, this->Cloud.Normals.data(),
      this->Cloud.Spacing, this->Request.Width,
      this->Request.Definition == SurfaceDefinition::Unbiased, this->Threads);
    this->Cloud.ThinShare = widths.ThinShare;
    this->Cloud.ThinWall = widths.ThinWall;
    this->Cloud.Status = widths.ThinShare > MostThin ? CloudStatus::ThinWall : CloudStatus::Ok;
    this->Cloud.Surface = std::make_shared<MovingLeastSquares>(this->Tree,
      this->Cloud.Normals.data(), this->Request.Definition, widths.Typical, widths.Widths);
  }

  void ForEachPoint(const std::function<void(std::size_t)>& body)
  {
    this->Threads.For(this->Request.Count, Grain, [&body](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        body(static_cast<std::size_t>(i));
      }
    });
  }

  /** The given normals with length one, or zero where they have no direction; returns whether any
   * has one. */
  bool CopyNormals()
  {
    this->Cloud.Normals.assign(3 * static_cast<std::size_t>(this->Request.Count), 0.0);
    std::vector<std::uint8_t> usable(static_cast<std::size_t>(this->Request.Count), 0);
    this->ForEachPoint([&](std::size_t i) {
      const double* const given = this->Request.Normals + 3 * i;
      const double length = std::hypot(given[0], given[1], given[2]);
      if (length > 0.0 && std::isfinite(length))
      {
        usable[i] = 1;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          this->Cloud.Normals[3 * i + axis] = given[axis] / length;
        }
      }
    });
    std::int64_t without = 0;
    for (std::size_t i = 0; i < usable.size(); ++i)
    {
      const double* const p = this->Request.Points + 3 * i;
      without += usable[i] || !IsFinite({ p[0], p[1], p[2] }) ? 0 : 1;
    }
    this->Cloud.NumberWithoutNormal = without < this->Request.Count ? without : 0;
    return without < this->Request.Count;
  }

  bool HasNormal(std::size_t i) const
  {
    const double* const n = this->Cloud.Normals.data() + 3 * i;
    return n[0] != 0.0 || n[1] != 0.0 || n[2] != 0.0;
  }

  /** @param withNormals leave points without one out, as if they were not finite. */
  void BuildTree(bool withNormals)
  {
    const std::int64_t count = this->Request.Count;
    if (!withNormals)
    {
      this->Tree = std::make_shared<PointTree>(this->Request.Points, count, nullptr, this->Threads);
      return;
    }
    std::vector<double> points(this->Request.Points, this->Request.Points + 3 * count);
    this->ForEachPoint([&](std::size_t i) {
      if (!this->HasNormal(i))
      {
        points[3 * i] = std::numeric_limits<double>::quiet_NaN();
      }
    });
    this->Tree =
      std::make_shared<PointTree>(points.data(), count, this->Cloud.Normals.data(), this->Threads);
  }

  CloudStatus Estimate()
  {
    const double widths = this->Request.Width > 0.0
      ? this->Request.Width / (WidthInSpacings * this->Cloud.Spacing)
      : 1.0;
    const int neighbours =
      static_cast<int>(std::clamp(NeighboursAtThat * widths * widths, NeighboursAtThat, 64.0));
    const EstimatedNormals estimated =
      EstimateNormals(*this->Tree, neighbours, this->Threads, this->Watch);
    if (estimated.Aborted)
    {
      return CloudStatus::Aborted;
    }
    this->Cloud.Estimated = true;
    this->Cloud.NumberOfParts = estimated.NumberOfParts;
    this->Cloud.Normals.assign(3 * static_cast<std::size_t>(this->Request.Count), 0.0);
    this->Cloud.Doubtful.assign(static_cast<std::size_t>(this->Request.Count), 0);
    for (std::int32_t i = 0; i < this->Tree->Size(); ++i)
    {
      const std::size_t id = static_cast<std::size_t>(this->Tree->Id(i));
      std::copy_n(estimated.Normals.begin() + 3 * std::int64_t(i), 3,
        this->Cloud.Normals.begin() + 3 * static_cast<std::int64_t>(id));
      this->Cloud.Doubtful[id] = estimated.Doubtful[static_cast<std::size_t>(i)];
      this->Cloud.NumberWithoutNormal += this->HasNormal(id) ? 0 : 1;
    }
    if (this->Tree->Size() - this->Cloud.NumberWithoutNormal < FewestPoints)
    {
      return CloudStatus::NoPlane;
    }
    if (this->Cloud.NumberWithoutNormal > 0)
    {
      this->BuildTree(true);
    }
    return CloudStatus::Ok;
  }

  const CloudRequest& Request;
  Executor& Threads;
  Monitor& Watch;
  std::shared_ptr<const PointTree> Tree;
  CloudSurface Cloud;
};

} // namespace

CloudSurface MakeCloudSurface(const CloudRequest& request, Executor& executor, Monitor& monitor)
{
  return Preparation(request, executor, monitor).Run();
}

} // namespace sb
