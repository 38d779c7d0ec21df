// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UnbiasedSurface.h
 * @brief The value of the unbiased moving-least-squares surface, its gradient and its Hessian, from
 * the samples near a place.
 *
 * With d = x - q, the weight th of a sample and its normal v, five sums are enough:
 *   W = sum th,  K = sum th v . d,  D = sum th |d|^2,  B = sum th d,  N = sum th v.
 * The function is F = n . B + K divided by 2 W, where n is the direction of N + k B and
 *   k = (N . B / W - K) / (D - B . B / W)
 * the curvature of the sphere that fits the normals best, as Guennebaud and Gross (2007) have it:
 * the slope of v over q. The mean normal N belongs to the mean of the samples, which need not lie
 * below x; k B takes it there. For samples of a sphere N + k B is k W (x - centre), and so n is its
 * normal and F = sum th (n + v) . d = 0 on it: exactly, however the samples lie and whatever their
 * weights are. On a plane k is 0.
 *
 * The derivatives take F as a function of the sums: those of F by the sums weight those of the sums
 * by x, sample by sample, so that the gradient needs three more sums and not thirty.
 */
#ifndef sb_UnbiasedSurface_h
#define sb_UnbiasedSurface_h

#include "Real3.h"
#include "SampleGroups.h"

#include <cstddef>

namespace sb
{

/** What lies near a place; samples out of reach do no harm. */
struct NearGroups
{
  const double* const* Groups = nullptr; ///< as SampleGroups packs them
  std::size_t Count = 0;
  bool Uneven = false; ///< each sample has its own reach; else it is the same for all
  double CommonInverseSquaredReach = 0.0;
  double* Room = nullptr; ///< to note what the derivatives need: RoomOfGroup numbers for each group
};
constexpr std::size_t RoomOfGroup = 3 * SampleGroups::Size;

/** F / (2 W) with its derivatives up to the wanted order, and what is known of the place. */
struct UnbiasedValue
{
  double Neighbours = 0.0; ///< samples within reach; without any, the rest means nothing
  double Value = 0.0;
  Real3 Gradient{};
  Real3x3 Hessian{};
  double Agreement = 0.0; ///< of the normals: |N| / W
  Real3 Mean{}; ///< of the samples, as seen from them: B / W
  Real3 Normal{}; ///< n
  double MeanInverseSquaredReach = 0.0;
};

UnbiasedValue EvaluateUnbiased(const Real3& x, int order, const NearGroups& near);

} // namespace sb

#endif
