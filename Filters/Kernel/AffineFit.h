// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AffineFit.h
 * @brief The affine map that takes one list of points to another, found although some of the points
 * are a little off.
 *
 * A designed surface whose facets have been moved, turned, scaled or mirrored is still known
 * exactly, if the map is found again: from where its patches have the facets' corners to where
 * these are now. Corners inside of a face are exact, those on its edges as good as the CAD system's
 * tolerance. So the sum of the distances is made smallest, not that of their squares: while at
 * least half of the points are exact, the others do not count (iteratively reweighted least
 * squares; Weiszfeld 1937).
 */
#ifndef sb_AffineFit_h
#define sb_AffineFit_h

#include "Real3.h"

#include <cstdint>

namespace sb
{

/** x to Matrix x + Offset. */
struct AffineMap
{
  Real3x3 Matrix{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  Real3 Offset{};

  Real3 Apply(const Real3& x) const
  {
    return PlusScaled(Times(this->Matrix, x), 1.0, this->Offset);
  }
};

struct AffineFit
{
  AffineMap Map;
  bool IsIdentity = true; ///< exactly: no map fits better
  double MeanError = 0.0; ///< of all points, in their unit
  double LargestError = 0.0;
};

/**
 * @param from, to x, y, z of each point; finite.
 * Where all points of `from` lie in a plane, the map's effect across it is of no account, and made
 * a rotation and a scaling.
 */
AffineFit FitAffineMap(const double* from, const double* to, std::int64_t count);

} // namespace sb

#endif
