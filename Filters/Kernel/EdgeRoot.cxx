// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeRoot.h"

#include <algorithm>
#include <cmath>

namespace sb
{

EdgeRoot FindEdgeRoot(const MovingLeastSquares& surface, const CrossedEdge& edge,
  MovingLeastSquares::Neighbourhood& near)
{
  double low = 0.0;
  double high = 1.0;
  double t = std::clamp(edge.ValueAtStart / (edge.ValueAtStart - edge.ValueAtEnd), 0.0, 1.0);
  EdgeRoot root;
  for (int iteration = 0; iteration < 60; ++iteration)
  {
    root.Surface = surface.EvaluateAt(PlusScaled(edge.Start, t, edge.Along), 1, near);
    ((root.Surface.Value < 0.0) == edge.StartsInside ? low : high) = t;
    const double newton = t - root.Surface.Value / Dot(root.Surface.Gradient, edge.Along);
    const double next = newton >= low && newton <= high ? newton : 0.5 * (low + high);
    const double step = std::abs(next - t);
    t = next;
    if (step < 1e-12)
    {
      break;
    }
  }
  root.Point = PlusScaled(edge.Start, t, edge.Along);
  return root;
}

} // namespace sb
