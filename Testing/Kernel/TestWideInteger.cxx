// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestWideInteger.cxx
 * @brief Wide integers agree with integers of any length.
 */
#include "Check.h"
#include "Reference.h"
#include "WideInteger.h"

#include <limits>

using namespace reference;

namespace
{

/** Words that carry and borrow a lot: all zeros, all ones, the sign bit alone, or anything. */
template <int Size>
sb::WideInteger<Size> AnyInteger(Random& random)
{
  sb::WideInteger<Size> value;
  for (int i = 0; i < Size; ++i)
  {
    const std::uint64_t choice[6] = { 0, ~std::uint64_t{ 0 }, std::uint64_t{ 1 } << 63, 1,
      random.Word(), random.Word() >> random.Between(0, 63) };
    value.SetWord(i, choice[random.Between(0, 5)]);
  }
  return value;
}

/** The value that so many words can hold, as two's complement wraps it. */
Integer Wrap(const Integer& value, int size)
{
  const Integer range = Integer(1) << (64 * size);
  Integer wrapped = value % range;
  if (wrapped < 0)
  {
    wrapped += range;
  }
  return 2 * wrapped >= range ? Integer(wrapped - range) : wrapped;
}

template <int Size>
void TestOneSize(Random& random)
{
  for (int i = 0; i < 20000; ++i)
  {
    const auto a = AnyInteger<Size>(random);
    const auto b = i % 8 == 0 ? a : AnyInteger<Size>(random);
    const Integer ia = ToInteger(a);
    const Integer ib = ToInteger(b);
    CHECK_EQUAL(ToInteger(a + b), Wrap(ia + ib, Size));
    CHECK_EQUAL(ToInteger(a - b), Wrap(ia - ib, Size));
    CHECK_EQUAL(ToInteger(-a), Wrap(-ia, Size));
    CHECK_EQUAL(a.Sign(), Sign(ia));
    CHECK_EQUAL(a.IsZero(), ia == 0);
    CHECK_EQUAL(a.Compare(b), ia.compare(ib) < 0 ? -1 : (ia == ib ? 0 : 1));
    CHECK_EQUAL(a == b, ia == ib);
    CHECK_EQUAL(a != b, ia != ib);
    CHECK_EQUAL(a < b, ia < ib);
    CHECK_EQUAL(a <= b, ia <= ib);
    CHECK_EQUAL(a > b, ia > ib);
    CHECK_EQUAL(a >= b, ia >= ib);
    CHECK_EQUAL(ToInteger(sb::WideInteger<Size + 2>(a)), ia);
    CHECK_EQUAL(ToInteger(sb::WideInteger<Size + 2>(a).template Narrow<Size>()), ia);
    const int shift = static_cast<int>(random.Between(0, 64 * Size - 1));
    CHECK_EQUAL(ToInteger(a.ShiftLeft(shift)), Wrap(ia << shift, Size));
  }
}

template <int A, int B>
void TestProducts(Random& random)
{
  for (int i = 0; i < 20000; ++i)
  {
    const auto a = AnyInteger<A>(random);
    const auto b = AnyInteger<B>(random);
    CHECK_EQUAL(ToInteger(sb::Multiply(a, b)), Integer(ToInteger(a) * ToInteger(b)));
  }
}

template <int Size>
void TestLeadingBits(Random& random)
{
  for (int i = 0; i < 20000; ++i)
  {
    const auto a = AnyInteger<Size>(random);
    if (a.Sign() <= 0)
    {
      continue;
    }
    const sb::LeadingBits bits = a.Leading();
    const Integer found = (Integer(bits.High) << 64) + bits.Low;
    const Integer value = ToInteger(a);
    CHECK_EQUAL(bits.High >> 63, 1u);
    CHECK_EQUAL(found,
      bits.Exponent >= 0 ? Integer(value >> bits.Exponent) : Integer(value << -bits.Exponent));
  }
}

void TestConstruction()
{
  const std::int64_t extremes[] = { 0, 1, -1, std::numeric_limits<std::int64_t>::max(),
    std::numeric_limits<std::int64_t>::min() };
  for (const std::int64_t value : extremes)
  {
    CHECK_EQUAL(ToInteger(sb::WideInteger<1>(value)), Integer(value));
    CHECK_EQUAL(ToInteger(sb::WideInteger<4>(value)), Integer(value));
  }
  CHECK_EQUAL(ToInteger(sb::WideInteger<2>::FromIntegral(-9223372036854774784.0)),
    Integer(-9223372036854774784));
  CHECK_EQUAL(ToInteger(sb::WideInteger<3>()), Integer(0));
  CHECK_EQUAL(ToInteger(sb::WideInteger<2>(-5).Magnitude()), Integer(5));
}

} // namespace

int main()
{
  Random random(1);
  TestConstruction();
  TestOneSize<1>(random);
  TestOneSize<2>(random);
  TestOneSize<3>(random);
  TestOneSize<6>(random);
  TestOneSize<18>(random);
  TestProducts<1, 1>(random);
  TestProducts<2, 1>(random);
  TestProducts<2, 2>(random);
  TestProducts<3, 4>(random);
  TestProducts<6, 6>(random);
  TestProducts<12, 6>(random);
  TestLeadingBits<1>(random);
  TestLeadingBits<2>(random);
  TestLeadingBits<6>(random);
  return check::Verdict("TestWideInteger");
}
