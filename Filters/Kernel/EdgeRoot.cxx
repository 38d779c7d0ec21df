// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeRoot.h"

#include <cmath>

namespace sb
{

namespace
{

constexpr double LongestLastStep = 0.02; ///< in lengths of the edge
constexpr double Rounding = 1e-15;

struct Known
{
  double At;
  double Value;
};

/** From t to the zero of the cubic that has value and slope there, and the values at two others. */
double StepOfCubic(const Known& t, double slope, const Known& low, const Known& high)
{
  const double newton = -t.Value / slope;
  // Newton's divided differences, in which t is taken twice.
  const auto bend = [&](const Known& other) {
    const double away = other.At - t.At;
    return ((other.Value - t.Value) / away - slope) / away;
  };
  const double second = bend(low);
  const double third = (bend(high) - second) / (high.At - low.At);
  double step = newton;
  for (int i = 0; i < 3; ++i)
  {
    step = newton - step * step * (second + third * (step + t.At - low.At)) / slope;
  }
  return step;
}

} // namespace

EdgeRoot FindEdgeRoot(const MovingLeastSquares& surface, const CrossedEdge& edge, double step,
  MovingLeastSquares::Neighbourhood& near)
{
  Known low{ 0.0, edge.ValueAtStart };
  Known high{ 1.0, edge.ValueAtEnd };
  const double secant = low.Value / (low.Value - high.Value);
  double t = secant >= 0.0 && secant <= 1.0 ? secant : 0.5;
  EdgeRoot root;
  for (int iteration = 0; iteration < 60; ++iteration)
  {
    root.Surface = surface.EvaluateAt(PlusScaled(edge.Start, t, edge.Along), 1, near);
    const Known last{ t, root.Surface.Value };
    if (last.Value == 0.0)
    {
      break;
    }
    const double slope = Dot(root.Surface.Gradient, edge.Along);
    const double newton = t - last.Value / slope;
    const double cubic = t + StepOfCubic(last, slope, low, high);
    ((last.Value < 0.0) == edge.StartsInside ? low : high) = last;
    const auto isBracketed = [&](double place) { return place >= low.At && place <= high.At; };
    t = isBracketed(cubic) ? cubic : isBracketed(newton) ? newton : 0.5 * (low.At + high.At);
    const bool isSure =
      isBracketed(cubic) && std::abs(t - newton) < step && std::abs(t - last.At) < LongestLastStep;
    if (isSure || high.At - low.At < Rounding)
    {
      break;
    }
  }
  root.Point = PlusScaled(edge.Start, t, edge.Along);
  return root;
}

} // namespace sb
