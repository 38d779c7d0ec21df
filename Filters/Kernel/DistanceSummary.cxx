// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceSummary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sb
{
namespace
{

/** As numpy's: between the values of rank floor and ceiling of share * (count - 1). Ranks before
 * `from` have been put in their place already. */
double Quantile(std::vector<double>& values, std::size_t from, double share, std::size_t& rank)
{
  const double place = share * static_cast<double>(values.size() - 1);
  rank = static_cast<std::size_t>(place);
  const auto at = [&values](
                    std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(from), at(rank), values.end());
  if (rank + 1 == values.size())
  {
    return values[rank];
  }
  const double next = *std::min_element(at(rank + 1), values.end());
  return values[rank] + (place - static_cast<double>(rank)) * (next - values[rank]);
}

} // namespace

DistanceSummary Summarize(std::vector<double> values)
{
  values.erase(
    std::remove_if(values.begin(), values.end(), [](double value) { return std::isnan(value); }),
    values.end());
  DistanceSummary summary;
  summary.Count = static_cast<std::int64_t>(values.size());
  if (values.empty())
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    summary.Minimum = summary.Maximum = summary.Mean = none;
    summary.RootMeanSquare = summary.LargestMagnitude = none;
    summary.Quantiles.fill(none);
    return summary;
  }
  const auto ends = std::minmax_element(values.begin(), values.end());
  summary.Minimum = *ends.first;
  summary.Maximum = *ends.second;
  summary.LargestMagnitude = std::max(std::fabs(summary.Minimum), std::fabs(summary.Maximum));
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values)
  {
    sum += value;
    squares += value * value;
  }
  summary.Mean = sum / static_cast<double>(summary.Count);
  summary.RootMeanSquare = std::sqrt(squares / static_cast<double>(summary.Count));
  std::size_t rank = 0;
  for (std::size_t i = 0; i < summary.Quantiles.size(); ++i)
  {
    summary.Quantiles[i] = Quantile(values, rank, 0.01 * DistanceSummary::Percent[i], rank);
  }
  return summary;
}

} // namespace sb
