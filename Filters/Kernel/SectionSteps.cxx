// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SectionSteps.h"

#include <cmath>

namespace sb
{
namespace
{

constexpr double LongestStep = 2.0; ///< in widths
constexpr double ShortestStep = 1e-4; ///< in spacings

} // namespace

double SectionSteps::Walk(const std::vector<Real3>& points, std::vector<Real3>& curve)
{
  std::vector<CurveNode> nodes;
  for (const Real3& point : points)
  {
    nodes.push_back({ point, 0.0, 0.0 });
  }
  // A loop takes three steps at least.
  const std::size_t fewest = points.front() == points.back() ? 3 : 1;
  std::vector<CurveNode> chosen;
  const double error = StepAlong(nodes,
    { this->ChordError, LongestStep * this->Surface.Width(), ShortestStep * this->Spacing }, fewest,
    *this, chosen);
  for (const CurveNode& node : chosen)
  {
    curve.push_back(node.Point);
  }
  return error;
}

double SectionSteps::CurvatureAt(const CurveNode& node)
{
  const SurfaceValue f = this->Surface.EvaluateAt(node.Point, 2, this->Near);
  return std::abs(SectionCurvature(f, this->Normal));
}

CurveNode SectionSteps::Between(const CurveNode& a, const CurveNode& b, double t)
{
  Real3 x = PlusScaled(a.Point, t, Difference(b.Point, a.Point));
  this->OntoCurve(x);
  return { x, 0.0, 0.0 };
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
