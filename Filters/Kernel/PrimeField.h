// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrimeField.h
 * @brief Arithmetic modulo primes just below 2^61, with which rationals are fingerprinted.
 *
 * A fraction X/W has one residue X * W^-1 modulo a prime, whichever of its equal forms it is
 * written in, so that residues can stand for exact values in a hash table.
 */
#ifndef sb_PrimeField_h
#define sb_PrimeField_h

#include "WideInteger.h"

#include <cstdint>

namespace sb
{

/** Integers modulo the prime 2^61 - Gap; 1 (a Mersenne prime) and 31 are the two smallest gaps. */
template <std::uint64_t Gap>
struct PrimeField
{
  static_assert(Gap == 1 || Gap == 31, "2^61 - Gap has to be a prime");
  static constexpr std::uint64_t Mask = (std::uint64_t{ 1 } << 61) - 1;
  static constexpr std::uint64_t Modulus = Mask - (Gap - 1);

  /** Residue of high * 2^64 + low, high < 2^58: 2^61 is as good as Gap. */
  static std::uint64_t Reduce(std::uint64_t high, std::uint64_t low)
  {
    std::uint64_t foldedHigh = 0;
    const std::uint64_t folded =
      words::MultiplyAdd((high << 3) | (low >> 61), Gap, low & Mask, 0, foldedHigh);
    // Now below 2^67, so that the second fold leaves less than 2^61 + 2^11.
    const std::uint64_t result = ((foldedHigh << 3) | (folded >> 61)) * Gap + (folded & Mask);
    return result >= Modulus ? result - Modulus : result;
  }

  static std::uint64_t Multiply(std::uint64_t a, std::uint64_t b)
  {
    std::uint64_t high = 0;
    const std::uint64_t low = words::MultiplyAdd(a, b, 0, 0, high);
    return Reduce(high, low);
  }

  static std::uint64_t Negate(std::uint64_t a) { return a == 0 ? 0 : Modulus - a; }

  template <int Size>
  static std::uint64_t Residue(const WideInteger<Size>& value)
  {
    // 2^64 is as good as 8 * Gap, below 2^8: word i weighs less than 2^(8 i), and up to seven words
    // add up without a reduction in between.
    static_assert(Size <= 7, "the sum would not fit");
    const WideInteger<Size> magnitude = value.Magnitude();
    std::uint64_t weight = 1;
    std::uint64_t low = 0;
    std::uint64_t high = 0;
    for (int i = 0; i < Size; ++i)
    {
      std::uint64_t carry = 0;
      low = words::MultiplyAdd(magnitude.GetWord(i), weight, low, 0, carry);
      high += carry;
      weight *= 8 * Gap;
    }
    const std::uint64_t residue = Reduce(high, low);
    return value.IsNegative() ? Negate(residue) : residue;
  }

  /** The b with a * b = 1, for 0 < a < Modulus, by Euclid's algorithm. */
  static std::uint64_t Inverse(std::uint64_t a)
  {
    // Throughout, factor * a and rest differ by a multiple of the modulus, and the factors stay
    // below it.
    std::uint64_t rest = a;
    std::uint64_t previousRest = Modulus;
    std::int64_t factor = 1;
    std::int64_t previousFactor = 0;
    while (rest > 1)
    {
      const std::uint64_t quotient = previousRest / rest;
      const std::uint64_t nextRest = previousRest - quotient * rest;
      const std::int64_t nextFactor = previousFactor - static_cast<std::int64_t>(quotient) * factor;
      previousRest = rest;
      rest = nextRest;
      previousFactor = factor;
      factor = nextFactor;
    }
    return factor < 0 ? Modulus - static_cast<std::uint64_t>(-factor)
                      : static_cast<std::uint64_t>(factor);
  }

  /** value / Modulus for a multiple of it. */
  template <int Size>
  static WideInteger<Size> DivideExactly(const WideInteger<Size>& value)
  {
    // From the low end, as in Jebelean's exact division: the quotient's next word is the one that
    // cancels the lowest word left. Multiplication modulo 2^64 by an odd number can be undone;
    // Newton doubles the right bits of its inverse a step, from the three that the number itself
    // has.
    std::uint64_t inverse = Modulus;
    for (int step = 0; step < 5; ++step)
    {
      inverse *= 2 - Modulus * inverse;
    }
    const WideInteger<Size> magnitude = value.Magnitude();
    WideInteger<Size> quotient;
    std::uint64_t carry = 0;
    for (int i = 0; i < Size; ++i)
    {
      const std::uint64_t word = magnitude.GetWord(i);
      const std::uint64_t digit = (word - carry) * inverse;
      const std::uint64_t borrow = word < carry ? 1 : 0;
      quotient.SetWord(i, digit);
      words::MultiplyAdd(digit, Modulus, 0, 0, carry);
      carry += borrow;
    }
    return value.IsNegative() ? -quotient : quotient;
  }
};

} // namespace sb

#endif
