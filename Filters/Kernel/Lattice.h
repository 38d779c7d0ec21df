// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Lattice.h
 * @brief The integer lattice on which all exact decisions are made: one power of two a call.
 *
 * A coordinate x becomes q = round(x * 2^k), ties to even, with |q| < 2^52. Being a power of two,
 * the scale never adds an error of its own, and a translation is not needed. A lattice coordinate
 * is kept as an integral double. 52 bits and not 53, because then the difference of two coordinates
 * is exact in a double, too, which the predicates' filters (Predicates.h) rely on. The lattice step
 * is between 2^-52 and 2^-51 of the largest coordinate.
 */
#ifndef sb_Lattice_h
#define sb_Lattice_h

#include <cmath>

namespace sb
{

struct Lattice
{
  static constexpr double Limit = 4503599627370496.0; ///< 2^52: every |q| is below it

  int Exponent = 0; ///< k
  double Scale = 1.0; ///< 2^k, or the first of two factors of it where that is beyond a double
  double ScaleRest = 1.0; ///< the other factor; 1 but for coordinates below 1e-292 throughout
  double Inverse = 1.0; ///< 2^-k, in the same two factors
  double InverseRest = 1.0;

  /** The finest lattice that holds all coordinates up to a magnitude, finite and not negative; 0 is
   * allowed. */
  static Lattice ForMagnitude(double maxAbsCoordinate)
  {
    if (!(maxAbsCoordinate > 0.0))
    {
      return Lattice();
    }
    int binade = 0;
    const double mantissa = std::frexp(maxAbsCoordinate, &binade);
    // The largest double of a binade would be rounded up to 2^52 itself.
    const int bits = mantissa * Limit > Limit - 1.0 ? 51 : 52;
    return Lattice::WithExponent(bits - binade);
  }

  static Lattice WithExponent(int exponent)
  {
    Lattice lattice;
    const int first = exponent > 1000 ? exponent / 2 : exponent;
    lattice.Exponent = exponent;
    lattice.Scale = std::ldexp(1.0, first);
    lattice.ScaleRest = std::ldexp(1.0, exponent - first);
    lattice.Inverse = std::ldexp(1.0, -first);
    lattice.InverseRest = std::ldexp(1.0, first - exponent);
    return lattice;
  }

  /** The lattice coordinate of x: integral, never a negative zero. */
  double ToLattice(double x) const
  {
    // Doubles in [2^52, 2^53) are the integers: adding 2^52 rounds as the processor does, to
    // nearest, ties to even.
    const double scaled = x * this->Scale * this->ScaleRest;
    const double shift = std::copysign(Limit, scaled);
    return (scaled + shift) - shift;
  }

  void Quantise(const double in[3], double out[3]) const
  {
    out[0] = this->ToLattice(in[0]);
    out[1] = this->ToLattice(in[1]);
    out[2] = this->ToLattice(in[2]);
  }

  /** The coordinate in the caller's unit of a lattice coordinate (of a created point, not
   * necessarily integral). */
  double ToWorld(double q) const { return q * this->Inverse * this->InverseRest; }
};

} // namespace sb

#endif
