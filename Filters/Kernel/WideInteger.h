// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WideInteger.h
 * @brief Signed integers of a fixed number of 64-bit words, on the stack, wide enough by type never
 * to overflow.
 *
 * Every exact decision of the kernel is the sign of a polynomial of bounded degree in lattice
 * coordinates of 52 bits (Lattice.h), so the width of each intermediate value is known when the
 * code is written. That spares the kernel an arbitrary precision library and the heap: a product's
 * type is the sum of its factors' widths, and whoever adds states in a comment why the sum still
 * fits.
 *
 * The fixed-width idea is that of Nehring-Wirxel, Trettner, Kobbelt: "Fast exact Booleans for
 * iterated CSG using octree-embedded BSPs" (EMBER is its successor), carried from 26-bit to 52-bit
 * coordinates.
 */
#ifndef sb_WideInteger_h
#define sb_WideInteger_h

#include <cstdint>

#if defined(__SIZEOF_INT128__) && !defined(SB_NO_INT128)
#define SB_HAS_INT128
#endif

namespace sb
{

#ifdef SB_HAS_INT128
__extension__ typedef unsigned __int128 UInt128;
#endif

namespace words
{

/** low word of a * b + c + d, which always fits two words; the high word goes to `high`. */
inline std::uint64_t MultiplyAdd(
  std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d, std::uint64_t& high)
{
#ifdef SB_HAS_INT128
  const UInt128 sum = static_cast<UInt128>(a) * b + c + d;
  high = static_cast<std::uint64_t>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
#else
  const std::uint64_t half = 0xffffffffu;
  const std::uint64_t lowLow = (a & half) * (b & half);
  const std::uint64_t lowHigh = (a & half) * (b >> 32);
  const std::uint64_t highLow = (a >> 32) * (b & half);
  const std::uint64_t middle = (lowLow >> 32) + (lowHigh & half) + (highLow & half);
  std::uint64_t low = (middle << 32) | (lowLow & half);
  high = (a >> 32) * (b >> 32) + (lowHigh >> 32) + (highLow >> 32) + (middle >> 32);
  low += c;
  high += low < c ? 1 : 0;
  low += d;
  high += low < d ? 1 : 0;
  return low;
#endif
}

/** a + b + carry; carry is 0 or 1, in and out. */
inline std::uint64_t AddWithCarry(std::uint64_t a, std::uint64_t b, std::uint64_t& carry)
{
  const std::uint64_t partial = a + b;
  const std::uint64_t sum = partial + carry;
  carry = static_cast<std::uint64_t>(partial < a) | static_cast<std::uint64_t>(sum < partial);
  return sum;
}

/** a - b - borrow; borrow is 0 or 1, in and out. */
inline std::uint64_t SubtractWithBorrow(std::uint64_t a, std::uint64_t b, std::uint64_t& borrow)
{
  const std::uint64_t partial = a - b;
  const std::uint64_t difference = partial - borrow;
  borrow = static_cast<std::uint64_t>(a < b) | static_cast<std::uint64_t>(partial < borrow);
  return difference;
}

/** Number of zero bits above the highest set bit; value must not be 0. */
inline int LeadingZeros(std::uint64_t value)
{
#if defined(__GNUC__) || defined(__clang__)
  return __builtin_clzll(value);
#else
  int zeros = 0;
  for (int step = 32; step > 0; step /= 2)
  {
    if ((value >> (64 - step)) == 0)
    {
      zeros += step;
      value <<= step;
    }
  }
  return zeros;
#endif
}

} // namespace words

/** The leading bits of a positive wide integer: value = (High * 2^64 + Low + tail) * 2^Exponent
 * with 0 <= tail < 1. */
struct LeadingBits
{
  std::uint64_t High; ///< its highest bit is set
  std::uint64_t Low;
  int Exponent; ///< negative where the integer has fewer than 128 bits; tail is then 0
};

/** A two's complement integer of Size words, the least significant first. */
template <int Size>
class WideInteger
{
  static_assert(Size >= 1, "an integer has a word at least");

public:
  /** Zero. */
  WideInteger() = default;

  WideInteger(std::int64_t value)
  {
    this->Word[0] = static_cast<std::uint64_t>(value);
    this->Extend(1);
  }

  /** The same value in more words. */
  template <int Narrower>
  WideInteger(const WideInteger<Narrower>& value)
  {
    static_assert(Narrower <= Size, "use Narrow() where the value is known to fit fewer words");
    for (int i = 0; i < Narrower; ++i)
    {
      this->Word[i] = value.GetWord(i);
    }
    this->Extend(Narrower);
  }

  /** An integral double, |value| < 2^63. */
  static WideInteger FromIntegral(double value)
  {
    return WideInteger(static_cast<std::int64_t>(value));
  }

  /** The low words alone; right only where the caller knows that the value fits them. */
  template <int Fewer>
  WideInteger<Fewer> Narrow() const
  {
    static_assert(Fewer <= Size, "not narrower");
    WideInteger<Fewer> result;
    for (int i = 0; i < Fewer; ++i)
    {
      result.SetWord(i, this->Word[i]);
    }
    return result;
  }

  std::uint64_t GetWord(int i) const { return this->Word[i]; }
  void SetWord(int i, std::uint64_t value) { this->Word[i] = value; }
  const std::uint64_t* Words() const { return this->Word; }

  bool IsNegative() const { return (this->Word[Size - 1] >> 63) != 0; }

  bool IsZero() const
  {
    std::uint64_t any = 0;
    for (int i = 0; i < Size; ++i)
    {
      any |= this->Word[i];
    }
    return any == 0;
  }

  /** -1, 0 or +1. */
  int Sign() const { return this->IsNegative() ? -1 : (this->IsZero() ? 0 : 1); }

  WideInteger operator+(const WideInteger& other) const
  {
    WideInteger result;
    std::uint64_t carry = 0;
    for (int i = 0; i < Size; ++i)
    {
      result.Word[i] = words::AddWithCarry(this->Word[i], other.Word[i], carry);
    }
    return result;
  }

  WideInteger operator-(const WideInteger& other) const
  {
    WideInteger result;
    std::uint64_t borrow = 0;
    for (int i = 0; i < Size; ++i)
    {
      result.Word[i] = words::SubtractWithBorrow(this->Word[i], other.Word[i], borrow);
    }
    return result;
  }

  WideInteger operator-() const { return WideInteger() - *this; }

  WideInteger Magnitude() const { return this->IsNegative() ? -*this : *this; }

  bool operator==(const WideInteger& other) const
  {
    std::uint64_t difference = 0;
    for (int i = 0; i < Size; ++i)
    {
      difference |= this->Word[i] ^ other.Word[i];
    }
    return difference == 0;
  }
  bool operator!=(const WideInteger& other) const { return !(*this == other); }

  bool operator<(const WideInteger& other) const { return this->Compare(other) < 0; }
  bool operator>(const WideInteger& other) const { return this->Compare(other) > 0; }
  bool operator<=(const WideInteger& other) const { return this->Compare(other) <= 0; }
  bool operator>=(const WideInteger& other) const { return this->Compare(other) >= 0; }

  /** Sign of *this - other, also where that difference does not fit. */
  int Compare(const WideInteger& other) const
  {
    if (this->IsNegative() != other.IsNegative())
    {
      return this->IsNegative() ? -1 : 1;
    }
    for (int i = Size - 1; i >= 0; --i)
    {
      if (this->Word[i] != other.Word[i])
      {
        return this->Word[i] < other.Word[i] ? -1 : 1;
      }
    }
    return 0;
  }

  /** this * 2^count, count >= 0; the caller knows that the result fits. */
  WideInteger ShiftLeft(int count) const
  {
    WideInteger result;
    const int whole = count / 64;
    const int part = count % 64;
    for (int i = Size - 1; i >= whole; --i)
    {
      result.Word[i] = this->Word[i - whole] << part;
      if (part > 0 && i > whole)
      {
        result.Word[i] |= this->Word[i - whole - 1] >> (64 - part);
      }
    }
    return result;
  }

  /** The leading 128 bits; the value must be positive. */
  LeadingBits Leading() const
  {
    int top = Size - 1;
    while (top > 0 && this->Word[top] == 0)
    {
      --top;
    }
    const std::uint64_t first = this->Word[top];
    const std::uint64_t second = top >= 1 ? this->Word[top - 1] : 0;
    const std::uint64_t third = top >= 2 ? this->Word[top - 2] : 0;
    const int shift = words::LeadingZeros(first);
    const int exponent = 64 * (top - 1) - shift;
    if (shift == 0)
    {
      return LeadingBits{ first, second, exponent };
    }
    return LeadingBits{ (first << shift) | (second >> (64 - shift)),
      (second << shift) | (third >> (64 - shift)), exponent };
  }

private:
  /** Copy the sign of the words below `from` into the words at and above it. */
  void Extend(int from)
  {
    const std::uint64_t sign = (this->Word[from - 1] >> 63) != 0 ? ~std::uint64_t{ 0 } : 0;
    for (int i = from; i < Size; ++i)
    {
      this->Word[i] = sign;
    }
  }

  std::uint64_t Word[Size] = {};
};

/** The product; it always fits the sum of the widths. */
template <int A, int B>
WideInteger<A + B> Multiply(const WideInteger<A>& a, const WideInteger<B>& b)
{
  std::uint64_t product[A + B] = {};
  for (int i = 0; i < A; ++i)
  {
    std::uint64_t carry = 0;
    for (int j = 0; j < B; ++j)
    {
      product[i + j] = words::MultiplyAdd(a.GetWord(i), b.GetWord(j), product[i + j], carry, carry);
    }
    product[i + B] = carry;
  }
  // That read a negative factor x as x + 2^(64 * width); take the surplus off.
  const std::uint64_t maskA = a.IsNegative() ? ~std::uint64_t{ 0 } : 0;
  const std::uint64_t maskB = b.IsNegative() ? ~std::uint64_t{ 0 } : 0;
  std::uint64_t borrow = 0;
  for (int j = 0; j < B; ++j)
  {
    product[A + j] = words::SubtractWithBorrow(product[A + j], b.GetWord(j) & maskA, borrow);
  }
  borrow = 0;
  for (int i = 0; i < A; ++i)
  {
    product[B + i] = words::SubtractWithBorrow(product[B + i], a.GetWord(i) & maskB, borrow);
  }
  WideInteger<A + B> result;
  for (int i = 0; i < A + B; ++i)
  {
    result.SetWord(i, product[i]);
  }
  return result;
}

} // namespace sb

#endif
