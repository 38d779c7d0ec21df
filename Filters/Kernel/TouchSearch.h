// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TouchSearch.h
 * @brief Where two surfaces come close to each other without crossing: places of one of them,
 * linked to a net, at which the other one's function is small and has one sign all around.
 */
#ifndef sb_TouchSearch_h
#define sb_TouchSearch_h

#include "DisjointSets.h"
#include "MovingLeastSquares.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace sb
{

struct SurfaceTouch
{
  Real3 Place{};
  double Distance = 0.0; ///< there, between the surfaces
};

class TouchSearch
{
public:
  /**
   * @param values of the function at the places, NaN where it has none
   * @param limit of a small value
   * @param rounding values below it have no sign; zero counts as outside
   */
  TouchSearch(std::vector<double> values, double limit, double rounding);

  /** Two places next to each other. */
  void Link(std::int32_t a, std::int32_t b);

  /** What is near this place is something else. */
  void LeaveOut(std::int32_t place) { this->IsCrossed[static_cast<std::size_t>(place)] = 1; }

  /** After all links: one place, that with the smallest value, for each touch that is not beyond
   * the border of the scan. */
  std::vector<SurfaceTouch> Find(const MovingLeastSquares& surface,
    const std::function<Real3(std::int32_t)>& placeOf, MovingLeastSquares::Neighbourhood& near);

private:
  bool IsSmall(std::int32_t place) const;

  std::vector<double> Values;
  double Limit;
  double Rounding;
  DisjointSets Sets; ///< of places with small values
  std::vector<std::uint8_t> IsCrossed;
};

} // namespace sb

#endif
