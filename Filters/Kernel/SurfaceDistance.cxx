// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDistance.h"

#include <cmath>

namespace sb
{

SurfaceDistance::SurfaceDistance(
  const Surface& surface, bool closed, bool insideOut, Executor& executor)
  : Closed(closed)
  , SignOutside(closed && insideOut ? -1.0 : 1.0)
  , Sides(Tree.Mesh(), Fans)
{
  this->Tree.Build(surface, executor);
  this->Fans.Build(surface, executor);
}

double SurfaceDistance::WindingNumber(const Vector3& query) const
{
  std::call_once(this->WindingMade, [this] {
    SerialExecutor executor;
    this->Winding.Build(this->Tree, executor);
  });
  return this->Winding.At(query);
}

double SurfaceDistance::SignOfWinding(const Vector3& query) const
{
  return std::fabs(this->WindingNumber(query)) > 0.5 ? -this->SignOutside : this->SignOutside;
}

double SurfaceDistance::Sign(
  const Vector3& query, SignRule rule, const NearestTriangle::Answer& nearest) const
{
  if (rule == SignRule::Unsigned)
  {
    return 1.0;
  }
  if (this->Closed && this->Tree.IsOutsideBounds(query))
  {
    return this->SignOutside;
  }
  if (rule == SignRule::WindingNumber)
  {
    return this->SignOfWinding(query);
  }
  if (nearest.Triangle < 0) // beyond the limit there is a side all the same
  {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    return this->Sign(query, rule, this->Tree.Find(query, everywhere, -1));
  }
  const Side side = this->Sides.Find(query, nearest);
  if (side != Side::Undecided)
  {
    return static_cast<double>(static_cast<int>(side));
  }
  return this->Closed ? this->SignOfWinding(query)
                      : static_cast<double>(static_cast<int>(this->Sides.OfPseudonormal(nearest)));
}

SurfaceDistance::Answer SurfaceDistance::At(
  const Vector3& query, SignRule rule, std::int32_t guess, double limit) const
{
  Answer answer;
  answer.Distance = std::numeric_limits<double>::quiet_NaN();
  if (this->IsEmpty() || !std::isfinite(query.X + query.Y + query.Z))
  {
    return answer;
  }
  const NearestTriangle::Answer nearest = this->Tree.Find(query, limit, guess);
  double length = limit;
  if (nearest.Triangle >= 0)
  {
    const Vector3 offset = (1.0 / this->Tree.Scale()) * nearest.Place;
    answer.Triangle = nearest.Triangle;
    answer.Where = nearest.Where;
    answer.Nearest = query + offset;
    length = std::isfinite(nearest.SquaredDistance)
      ? std::sqrt(nearest.SquaredDistance) / this->Tree.Scale()
      : std::hypot(offset.X, offset.Y, offset.Z);
  }
  answer.Distance = length == 0.0 ? 0.0 : this->Sign(query, rule, nearest) * length;
  return answer;
}

} // namespace sb
