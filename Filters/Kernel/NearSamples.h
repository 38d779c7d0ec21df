// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearSamples.h
 * @brief Whether a triangle comes near to any sample of a cloud.
 */
#ifndef sb_NearSamples_h
#define sb_NearSamples_h

#include "PointTree.h"

namespace sb
{

/** Whether a sample is closer than `distance` to the triangle a b c. */
bool IsNearSamples(
  const PointTree& samples, const Real3& a, const Real3& b, const Real3& c, double distance);

} // namespace sb

#endif
