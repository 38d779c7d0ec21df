// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceSummary.h
 * @brief Many distances in a few numbers.
 */
#ifndef sb_DistanceSummary_h
#define sb_DistanceSummary_h

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct DistanceSummary
{
  /** Shares of the values, in percent, for which Quantiles are given. */
  static constexpr std::array<int, 5> Percent{ 5, 25, 50, 75, 95 };

  std::int64_t Count = 0; ///< of the values that are numbers; all below are NaN if there is none
  double Minimum;
  double Maximum;
  double Mean;
  double RootMeanSquare;
  double LargestMagnitude; ///< of distances: the Hausdorff distance one way, as far as sampled
  std::array<double, 5> Quantiles; ///< linear between the values around
};

/** Values that are NaN are left out; they are reordered. */
DistanceSummary Summarize(std::vector<double> values);

} // namespace sb

#endif
