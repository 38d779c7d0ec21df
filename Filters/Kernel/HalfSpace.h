// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalfSpace.h
 * @brief A clipping plane on the lattice: integer normal, integer offset, exact sides.
 *
 * The normal is scaled by a power of two and rounded to integers of 52 bits, so that directions
 * such as (1, 0, 0) or (1, 2, 3) are exact. The origin is rounded to the lattice as a vertex would
 * be, so that a plane placed on a vertex goes through it. With lattice coordinates of B = 52 bits:
 *
 * | value                                  | bits                |
 * | -------------------------------------- | ------------------- |
 * | offset, normal . origin                | 2 B + 2 = 106       |
 * | height of a vertex                     | 2 B + 4 = 108       |
 * | height of an ExactPoint, times its W   | 378 + B + 3 = 433   |
 */
#ifndef sb_HalfSpace_h
#define sb_HalfSpace_h

#include "ExactPoint.h"
#include "Lattice.h"

#include <array>
#include <cmath>

namespace sb
{

/** A plane as a user gives it; kept is what lies where the normal points. */
struct ClipPlane
{
  std::array<double, 3> Origin{}; ///< any point of it
  std::array<double, 3> Normal{ 0.0, 0.0, 1.0 }; ///< of any length but zero
};

class HalfSpace
{
public:
  /** @param plane with finite numbers, a normal that is not zero, and an origin in the lattice's
   * range. */
  HalfSpace(const ClipPlane& plane, const Lattice& lattice);

  /** +1 for a lattice point where the normal points, -1 behind the plane, 0 on it. */
  int Side(const double* q) const
  {
    const double dx = q[0] - this->Origin[0];
    const double dy = q[1] - this->Origin[1];
    const double dz = q[2] - this->Origin[2];
    const double px = this->Normal[0] * dx;
    const double py = this->Normal[1] * dy;
    const double pz = this->Normal[2] * dz;
    const double height = (px + py) + pz;
    // Differences are exact; each product passes three roundings at most.
    constexpr double fourRoundings = 4.0 / 9007199254740992.0;
    const double bound = fourRoundings * (std::fabs(px) + std::fabs(py) + std::fabs(pz));
    if (std::fabs(height) > bound || bound == 0.0)
    {
      return SignOf(height);
    }
    return this->ExactSide(q);
  }

  /** The same for a created point. */
  int Side(const ExactPoint& point) const;

  const ExactPlane& Plane() const { return this->Exact; }

  /** The axis of the largest component of the normal, and that component's sign. */
  DominantNormal Dominant() const { return this->Largest; }

  /** The normal's components: integral. */
  const double* Direction() const { return this->Normal; }

private:
  int ExactSide(const double* q) const;
  template <int Size>
  int ExactSide(const ExactPoint& point) const;

  double Normal[3]; ///< integral, below 2^52
  double Origin[3]; ///< on the lattice
  ExactPlane Exact;
  DominantNormal Largest;
};

} // namespace sb

#endif
