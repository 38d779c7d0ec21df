// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LineIntersection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sb
{
namespace
{

constexpr double StepInWidths = 0.125;

/** The function and its derivative at a place of the segment. */
struct Place
{
  double T = 0.0;
  bool Known = false;
  double Value = 0.0;
  double Slope = 0.0;

  bool IsInside() const { return this->Value < 0.0; }
};

class Segment
{
public:
  Segment(const MovingLeastSquares& surface, const Real3& a, const Real3& b,
    MovingLeastSquares::Neighbourhood& near)
    : Surface(surface)
    , Start(a)
    , Along(Difference(b, a))
    , Size(sb::Length(this->Along))
    , Near(near)
  {
  }

  std::vector<double> Roots()
  {
    if (!(this->Size > 0.0) || !std::isfinite(this->Size))
    {
      return {};
    }
    for (const std::pair<double, double>& part : this->PartsNearSamples())
    {
      this->Walk(part.first, part.second);
    }
    return std::move(this->Found);
  }

private:
  /** Where the segment may be within reach of a sample: disjoint intervals, ascending. */
  std::vector<std::pair<double, double>> PartsNearSamples() const
  {
    const double reach = this->Surface.Reach();
    const PointTree& samples = this->Surface.Samples();
    std::vector<std::pair<double, double>> spans;
    const auto mayMeet = [&](const Real3& lower, const Real3& upper) {
      double first = 0.0;
      double last = 1.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double before = lower[axis] - reach - this->Start[axis];
        const double after = upper[axis] + reach - this->Start[axis];
        if (this->Along[axis] == 0.0)
        {
          if (before > 0.0 || after < 0.0)
          {
            return false;
          }
          continue;
        }
        const auto ends = std::minmax({ before / this->Along[axis], after / this->Along[axis] });
        first = std::max(first, ends.first);
        last = std::min(last, ends.second);
      }
      return first <= last;
    };
    samples.ForRanges(mayMeet, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t i = begin; i < end; ++i)
      {
        const Real3 from = Difference(samples.Point(i), this->Start);
        const double t = Dot(from, this->Along) / (this->Size * this->Size);
        const double away = Length(PlusScaled(from, -t, this->Along));
        if (away < reach)
        {
          const double half = std::sqrt(reach * reach - away * away) / this->Size;
          if (t + half >= 0.0 && t - half <= 1.0)
          {
            spans.emplace_back(std::max(0.0, t - half), std::min(1.0, t + half));
          }
        }
      }
    });
    std::sort(spans.begin(), spans.end());
    std::vector<std::pair<double, double>> parts;
    for (const std::pair<double, double>& span : spans)
    {
      if (parts.empty() || span.first > parts.back().second)
      {
        parts.push_back(span);
      }
      parts.back().second = std::max(parts.back().second, span.second);
    }
    return parts;
  }

  Place At(double t)
  {
    const SurfaceValue f =
      this->Surface.EvaluateAt(PlusScaled(this->Start, t, this->Along), 1, this->Near);
    return { t, f.IsNear, f.Value, Dot(f.Gradient, this->Along) };
  }

  void Walk(double begin, double end)
  {
    const double step = StepInWidths * this->Surface.NarrowWidth() / this->Size;
    const std::int64_t steps =
      std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil((end - begin) / step)));
    Place last = this->At(begin);
    for (std::int64_t k = 1; k <= steps; ++k)
    {
      const Place next = this->At(k == steps
          ? end
          : begin + (end - begin) * static_cast<double>(k) / static_cast<double>(steps));
      if (last.Known && next.Known)
      {
        this->Look(last, next);
      }
      last = next;
    }
  }

  void Look(const Place& last, const Place& next)
  {
    if (last.IsInside() != next.IsInside())
    {
      this->Add(last, next);
      return;
    }
    // Towards zero at the one end and away from it at the other: the least distance is between.
    const double side = last.IsInside() ? -1.0 : 1.0;
    if (side * last.Slope < 0.0 && side * next.Slope > 0.0)
    {
      Place lower = last;
      Place upper = next;
      for (int iteration = 0; iteration < 60; ++iteration)
      {
        const Place middle = this->At(0.5 * (lower.T + upper.T));
        if (!middle.Known)
        {
          return;
        }
        if (middle.IsInside() != last.IsInside())
        {
          this->Add(last, middle);
          this->Add(middle, next);
          return;
        }
        (side * middle.Slope < 0.0 ? lower : upper) = middle;
      }
    }
  }

  /** Newton's method in a bracket, halved where it would leave that. */
  void Add(Place lower, Place upper)
  {
    Place at = this->At(lower.T + (upper.T - lower.T) * lower.Value / (lower.Value - upper.Value));
    for (int iteration = 0; iteration < 100 && at.Known && at.Value != 0.0; ++iteration)
    {
      (at.IsInside() == lower.IsInside() ? lower : upper) = at;
      const double newton = at.T - at.Value / at.Slope;
      const double next =
        newton >= lower.T && newton <= upper.T ? newton : 0.5 * (lower.T + upper.T);
      const double moved = std::abs(next - at.T) * this->Size;
      at = this->At(next);
      if (moved < 1e-12 * this->Surface.NarrowWidth() || !(lower.T < upper.T))
      {
        break;
      }
    }
    const SurfaceValue f =
      this->Surface.EvaluateAt(PlusScaled(this->Start, at.T, this->Along), 0, this->Near);
    if (f.Where == Support::Defined && std::abs(f.Value) < 1e-6 * this->Surface.NarrowWidth())
    {
      this->Found.push_back(at.T);
    }
  }

  const MovingLeastSquares& Surface;
  const Real3 Start;
  const Real3 Along;
  const double Size;
  MovingLeastSquares::Neighbourhood& Near;
  std::vector<double> Found;
};

} // namespace

std::vector<double> IntersectSegment(const MovingLeastSquares& surface, const Real3& a,
  const Real3& b, MovingLeastSquares::Neighbourhood& near)
{
  return Segment(surface, a, b, near).Roots();
}

} // namespace sb
