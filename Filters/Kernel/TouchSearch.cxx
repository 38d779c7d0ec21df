// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchSearch.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace sb
{

TouchSearch::TouchSearch(std::vector<double> values, double limit, double rounding)
  : Values(std::move(values))
  , Limit(limit)
  , Rounding(rounding)
  , Sets(static_cast<std::int32_t>(this->Values.size()))
  , IsCrossed(this->Values.size(), 0)
{
}

bool TouchSearch::IsSmall(std::int32_t place) const
{
  return std::abs(this->Values[static_cast<std::size_t>(place)]) <= this->Limit;
}

void TouchSearch::Link(std::int32_t a, std::int32_t b)
{
  const double first = this->Values[static_cast<std::size_t>(a)];
  const double last = this->Values[static_cast<std::size_t>(b)];
  if (std::isnan(first) || std::isnan(last))
  {
    return;
  }
  if ((first < -this->Rounding) != (last < -this->Rounding))
  {
    this->LeaveOut(a);
    this->LeaveOut(b);
  }
  else if (this->IsSmall(a) && this->IsSmall(b))
  {
    this->Sets.Unite(a, b);
  }
}

std::vector<SurfaceTouch> TouchSearch::Find(const MovingLeastSquares& surface,
  const std::function<Real3(std::int32_t)>& placeOf, MovingLeastSquares::Neighbourhood& near)
{
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> best(this->Values.size(), none); ///< of the first place of each set
  for (std::int32_t i = 0; i < this->Sets.Size(); ++i)
  {
    if (this->IsCrossed[static_cast<std::size_t>(i)])
    {
      this->IsCrossed[static_cast<std::size_t>(this->Sets.Find(i))] = 1;
    }
  }
  for (std::int32_t i = 0; i < this->Sets.Size(); ++i)
  {
    std::int32_t& nearest = best[static_cast<std::size_t>(this->Sets.Find(i))];
    if (this->IsSmall(i) &&
      (nearest == none ||
        std::abs(this->Values[static_cast<std::size_t>(i)]) <
          std::abs(this->Values[static_cast<std::size_t>(nearest)])))
    {
      nearest = i;
    }
  }
  std::vector<SurfaceTouch> touches;
  for (std::size_t first = 0; first < best.size(); ++first)
  {
    if (best[first] == none || this->IsCrossed[first])
    {
      continue;
    }
    const Real3 place = placeOf(best[first]);
    if (surface.EvaluateAt(place, 1, near).Where == Support::Defined)
    {
      touches.push_back({ place, std::abs(this->Values[static_cast<std::size_t>(best[first])]) });
    }
  }
  return touches;
}

} // namespace sb
