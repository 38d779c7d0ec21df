// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudSampling.h
 * @brief Many points onto the surface of a cloud at once, and what the surface is like there.
 */
#ifndef sb_CloudSampling_h
#define sb_CloudSampling_h

#include "MovingLeastSquares.h"

#include <cstdint>

namespace sb
{

/** What to fill in for each point; null leaves it out. */
struct CloudArrays
{
  double* Projected = nullptr; ///< three a point: the place on the surface
  double* Normal = nullptr; ///< three a point: the unit normal there
  double* Residual = nullptr; ///< the distance from there to the point, negative behind the surface
  double* MaximumCurvature = nullptr;
  double* MinimumCurvature = nullptr;
  std::uint8_t* Validity = nullptr; ///< a Support
};

/**
 * Project `count` points. Where one cannot be projected, Validity says why, Projected is the point
 * itself, Normal is left as it is, and the numbers are NaN.
 * @return false if it was stopped.
 */
bool SampleCloudSurface(const MovingLeastSquares& surface, const double* points, std::int64_t count,
  const CloudArrays& arrays, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
