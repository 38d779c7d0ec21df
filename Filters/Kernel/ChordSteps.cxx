// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChordSteps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sb
{
namespace
{

constexpr double Reserve = 0.85; ///< of the bound, as the distance is measured at some places only

double DistanceToSegment(const Real3& x, const Real3& a, const Real3& b)
{
  const Real3 along = Difference(b, a);
  const double squared = Dot(along, along);
  const double t =
    squared > 0.0 ? std::clamp(Dot(Difference(x, a), along) / squared, 0.0, 1.0) : 0.0;
  return Length(Difference(x, PlusScaled(a, t, along)));
}

double Apart(const CurveNode& a, const CurveNode& b)
{
  return Length(Difference(a.Point, b.Point));
}

class Stepping
{
public:
  Stepping(const std::vector<CurveNode>& nodes, const StepBounds& bounds, SteppedCurve& curve,
    std::vector<CurveNode>& points)
    : Nodes(nodes)
    , Bounds(bounds)
    , Bound(Reserve * bounds.ChordError)
    , Curve(curve)
    , Points(points)
    , Middles(nodes.size())
    , HasMiddle(nodes.size(), 0)
  {
  }

  double Run(std::size_t fewest)
  {
    const std::size_t most = std::max<std::size_t>(1, (this->Nodes.size() - 1) / fewest);
    for (std::size_t at = 0; at + 1 < this->Nodes.size();)
    {
      at = this->Step(at, most);
    }
    return this->Largest;
  }

private:
  /** As far from a node as the bound allows; returns the node where the step ends. */
  std::size_t Step(std::size_t at, std::size_t most)
  {
    const double curvature = this->Curve.CurvatureAt(this->Nodes[at]);
    // The chord of a circle with that sagitta.
    const double squared = 4.0 * (2.0 * this->Bound / curvature - this->Bound * this->Bound);
    const double longest = this->Bounds.Longest;
    const double length = squared < longest * longest ? std::sqrt(std::max(0.0, squared)) : longest;
    std::size_t last = at + 1;
    double arc = Apart(this->Nodes[at], this->Nodes[last]);
    const std::size_t farthest = std::min(this->Nodes.size() - 1, at + most);
    while (last < farthest && arc + Apart(this->Nodes[last], this->Nodes[last + 1]) <= length)
    {
      arc += Apart(this->Nodes[last], this->Nodes[last + 1]);
      ++last;
    }
    for (; last > at + 1; last = at + (last - at + 1) / 2)
    {
      const double error = this->ErrorOf(at, last);
      if (error <= this->Bound)
      {
        this->Largest = std::max(this->Largest, error);
        this->Points.push_back(this->Nodes[last]);
        return last;
      }
    }
    this->Subdivide(this->Nodes[at], this->Nodes[at + 1]);
    return at + 1;
  }

  /** How far the nodes and the middles between them are from the chord of two. */
  double ErrorOf(std::size_t first, std::size_t last)
  {
    double error = 0.0;
    const Real3& a = this->Nodes[first].Point;
    const Real3& b = this->Nodes[last].Point;
    for (std::size_t k = first; k < last; ++k)
    {
      error = std::max(error, DistanceToSegment(this->Nodes[k].Point, a, b));
    }
    for (std::size_t k = first; k < last && error <= this->Bound; ++k)
    {
      error = std::max(error, DistanceToSegment(this->MiddleAfter(k), a, b));
    }
    return error;
  }

  const Real3& MiddleAfter(std::size_t node)
  {
    if (!this->HasMiddle[node])
    {
      this->Middles[node] =
        this->Curve.Between(this->Nodes[node], this->Nodes[node + 1], 0.5).Point;
      this->HasMiddle[node] = 1;
    }
    return this->Middles[node];
  }

  /** Halve a step between neighbours until its distance is kept. */
  void Subdivide(const CurveNode& a, const CurveNode& b)
  {
    double error = 0.0;
    CurveNode middle;
    for (const double t : { 0.25, 0.75, 0.5 })
    {
      middle = this->Curve.Between(a, b, t);
      error = std::max(error, DistanceToSegment(middle.Point, a.Point, b.Point));
    }
    const double length = Apart(a, b);
    // A middle that is not between them would be none of the curve's.
    const bool isBetween = Apart(a, middle) < length && Apart(middle, b) < length;
    if (error > this->Bound && length > this->Bounds.Shortest && isBetween)
    {
      this->Subdivide(a, middle);
      this->Subdivide(middle, b);
      return;
    }
    this->Largest = std::max(this->Largest, error);
    this->Points.push_back(b);
  }

  const std::vector<CurveNode>& Nodes;
  const StepBounds Bounds;
  const double Bound;
  SteppedCurve& Curve;
  std::vector<CurveNode>& Points;
  std::vector<Real3> Middles; ///< of the curve, after each node
  std::vector<std::uint8_t> HasMiddle;
  double Largest = 0.0;
};

} // namespace

double StepAlong(const std::vector<CurveNode>& nodes, const StepBounds& bounds, std::size_t fewest,
  SteppedCurve& curve, std::vector<CurveNode>& points)
{
  return Stepping(nodes, bounds, curve, points).Run(fewest);
}

} // namespace sb
