// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceSampling.h
 * @brief The distance at many points at once.
 *
 * Points are visited along a space-filling curve, so that the answer at one is a good guess for the
 * next one. The guess decides the time only: the arrays are the same in any order and with any
 * number of threads.
 */
#ifndef sb_DistanceSampling_h
#define sb_DistanceSampling_h

#include "Executor.h"
#include "SurfaceDistance.h"

#include <cstdint>
#include <limits>

namespace sb
{

struct DistanceRequest
{
  const double* Points = nullptr; ///< shape (Count, 3)
  std::int64_t Count = 0; ///< below 2^31
  SignRule Rule = SignRule::Pseudonormal;
  double Limit = std::numeric_limits<double>::infinity(); ///< as in SurfaceDistance::At
};

/** Where to put the answers; what is null is not asked for. */
struct DistanceArrays
{
  double* Distance = nullptr; ///< shape (Count); NaN at points that are not finite
  std::int32_t* Triangle = nullptr; ///< shape (Count); -1 where there is none
  double* Nearest = nullptr; ///< shape (Count, 3); NaN where there is none
  double* Direction = nullptr; ///< shape (Count, 3); from the point to the nearest one, of length
                               ///< one, or zero where there is none and on the surface
};

/** @return false if the caller has stopped it; the arrays are then incomplete. */
bool SampleDistances(const SurfaceDistance& surface, const DistanceRequest& request,
  const DistanceArrays& arrays, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
