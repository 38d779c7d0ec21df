// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeRoot.h
 * @brief Where a cloud's surface crosses an edge whose ends lie on different sides of it.
 */
#ifndef sb_EdgeRoot_h
#define sb_EdgeRoot_h

#include "MovingLeastSquares.h"

namespace sb
{

/** An edge from Start to Start + Along, and the values at its ends. */
struct CrossedEdge
{
  Real3 Start{};
  Real3 Along{};
  double ValueAtStart = 0.0;
  double ValueAtEnd = 0.0;
  bool StartsInside = false;
};

/** For FindEdgeRoot, where roots are wanted to rounding. */
constexpr double RootStep = 1e-12;

struct EdgeRoot
{
  Real3 Point{};
  SurfaceValue Surface; ///< at the point or next to it, with its gradient
  /** Whether the surface is there, and not beyond the border of the scan. */
  bool IsSupported() const
  {
    return this->Surface.Where == Support::Defined || this->Surface.Where == Support::Contradicting;
  }
};

/**
 * By the zero of the cubic that has the values at both ends of the bracket, and value and slope at
 * the last place: where an edge is not much longer than the surface's detail, one evaluation leaves
 * next to nothing to do. By halving where that would leave the bracket.
 * @param step in lengths of the edge: the largest curved part of a step that is not looked at
 * again. The error is smaller by orders.
 */
EdgeRoot FindEdgeRoot(const MovingLeastSquares& surface, const CrossedEdge& edge, double step,
  MovingLeastSquares::Neighbourhood& near);

} // namespace sb

#endif
