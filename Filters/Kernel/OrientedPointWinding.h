// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OrientedPointWinding.h
 * @brief The winding number of a cloud: each sample is a small area across its normal (Barill,
 * Dickson, Schmidt, Levin, Jacobson, Fast Winding Numbers for Soups and Clouds, 2018).
 *
 * Of a closed cloud it is near 1 inside and near 0 outside; where a scan is open it passes gently
 * through one half, which is the best that can be said there. Nearer to the samples than their
 * spacing it means nothing.
 */
#ifndef sb_OrientedPointWinding_h
#define sb_OrientedPointWinding_h

#include "Executor.h"
#include "MovingLeastSquares.h"
#include "WindingDipole.h"

#include <vector>

namespace sb
{

class OrientedPointWinding
{
public:
  /** The samples and normals of a surface, which has to stay alive. A sample's area is that of the
   * circle to its eighth neighbour, divided by eight: scans are uneven. */
  OrientedPointWinding(const MovingLeastSquares& surface, Executor& executor);

  /** Thread-safe. */
  double At(const Real3& place) const;

private:
  WindingDipole SampleDipole(std::int32_t sample) const;
  double NearBy(const Vector3& place, std::int32_t group) const;

  const MovingLeastSquares& Surface;
  Real3 Reference{}; ///< the middle of the cloud; all lengths are relative to it
  std::vector<double> Areas; ///< in the order of the tree
  WindingTree Groups;
};

} // namespace sb

#endif
