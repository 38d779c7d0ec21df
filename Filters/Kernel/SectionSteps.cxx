// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SectionSteps.h"

#include "CommonPoint.h"

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
  const Real3 wanted = PlusScaled(a.Point, t, Difference(b.Point, a.Point));
  const CommonPoint on =
    OntoCloudAndPlane(this->Surface, a.Point, this->Normal, wanted, this->Near);
  // Where Newton's method does not lead to the curve nearby, the chord stands for it.
  const bool isNear = on.Found && Length(Difference(on.Point, wanted)) <= this->Spacing;
  return { isNear ? on.Point : wanted, 0.0, 0.0 };
}

} // namespace sb
