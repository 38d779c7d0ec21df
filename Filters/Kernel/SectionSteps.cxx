// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SectionSteps.h"

#include <algorithm>
#include <cmath>

namespace sb
{
namespace
{

double DistanceToSegment(const Real3& x, const Real3& a, const Real3& b)
{
  const Real3 along = Difference(b, a);
  const double t = std::clamp(Dot(Difference(x, a), along) / Dot(along, along), 0.0, 1.0);
  return Length(Difference(x, PlusScaled(a, t, along)));
}

} // namespace

double SectionSteps::Walk(const std::vector<Real3>& points, std::vector<Real3>& curve)
{
  this->LargestError = 0.0;
  for (std::size_t at = 0; at + 1 < points.size();)
  {
    at = this->Step(points, at, curve);
  }
  return this->LargestError;
}

/** One step from points[at] as far as the bound allows; returns where it ends. */
std::size_t SectionSteps::Step(
  const std::vector<Real3>& points, std::size_t at, std::vector<Real3>& curve)
{
  const SurfaceValue f = this->Surface.EvaluateAt(points[at], 2, this->Near);
  const double curvature = std::abs(SectionCurvature(f, this->Normal));
  // The chord of a circle with that sagitta, but never more than two widths.
  const double most = 2.0 * this->Surface.Width();
  const double squared = 4.0 * (2.0 * this->Bound / curvature - this->Bound * this->Bound);
  const double length = squared < most * most ? std::sqrt(std::max(0.0, squared)) : most;
  std::size_t last = at + 1;
  double arc = Length(Difference(points[last], points[at]));
  // A loop takes three steps at least.
  const std::size_t steps = points.front() == points.back() ? 3 : 1;
  const std::size_t farthest =
    std::min(points.size() - 1, at + std::max<std::size_t>(1, (points.size() - 1) / steps));
  while (last < farthest && arc + Length(Difference(points[last + 1], points[last])) <= length)
  {
    arc += Length(Difference(points[last + 1], points[last]));
    ++last;
  }
  for (; last > at + 1; last = at + (last - at + 1) / 2)
  {
    const double error = this->ErrorOf(points, at, last);
    if (error <= this->Bound)
    {
      this->LargestError = std::max(this->LargestError, error);
      curve.push_back(points[last]);
      return last;
    }
  }
  this->Subdivide(points[at], points[at + 1], 0, curve);
  return at + 1;
}

/** The measured chord error of the step between two of the points. */
double SectionSteps::ErrorOf(const std::vector<Real3>& points, std::size_t first, std::size_t last)
{
  double error = 0.0;
  for (std::size_t k = first; k < last; ++k)
  {
    const Real3 middle = PlusScaled(points[k], 0.5, Difference(points[k + 1], points[k]));
    Real3 onCurve = middle;
    this->OntoCurve(onCurve);
    for (const Real3& x : { points[k], onCurve })
    {
      error = std::max(error, DistanceToSegment(x, points[first], points[last]));
    }
  }
  return error;
}

/** Halve a step between neighbours on the grid until its chord error is kept. */
void SectionSteps::Subdivide(const Real3& a, const Real3& b, int depth, std::vector<Real3>& curve)
{
  constexpr int deepest = 16;
  double error = 0.0;
  Real3 middle{};
  for (const double t : { 0.25, 0.75, 0.5 })
  {
    middle = PlusScaled(a, t, Difference(b, a));
    this->OntoCurve(middle);
    error = std::max(error, DistanceToSegment(middle, a, b));
  }
  if (error > this->Bound && depth < deepest)
  {
    this->Subdivide(a, middle, depth + 1, curve);
    this->Subdivide(middle, b, depth + 1, curve);
    return;
  }
  this->LargestError = std::max(this->LargestError, error);
  curve.push_back(b);
}

/** Newton's method in the plane; where it does not lead to the curve, x stays. */
void SectionSteps::OntoCurve(Real3& x)
{
  const Real3 start = x;
  for (int iteration = 0; iteration < 20; ++iteration)
  {
    const SurfaceValue f = this->Surface.EvaluateAt(x, 1, this->Near);
    const Real3 inPlane = WithoutPartAlong(f.Gradient, this->Normal);
    const double steepness = Dot(inPlane, inPlane);
    const double step = std::abs(f.Value) / std::sqrt(steepness);
    if (!f.IsNear || !(step < this->Spacing) || Length(Difference(x, start)) > this->Spacing)
    {
      x = start;
      return;
    }
    x = PlusScaled(x, -f.Value / steepness, inPlane);
    if (step < 1e-7 * this->Spacing)
    {
      return;
    }
  }
}

} // namespace sb
