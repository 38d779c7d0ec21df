// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestLattice.cxx
 * @brief Any coordinates from 1e-308 to 1e308 find a lattice of 52 bits and come back from it.
 */
#include "Check.h"
#include "Lattice.h"
#include "Reference.h"

#include <limits>

using namespace reference;

namespace
{

void TestMagnitude(double magnitude, Random& random)
{
  const sb::Lattice lattice = sb::Lattice::ForMagnitude(magnitude);
  for (int i = 0; i < 200; ++i)
  {
    const double fraction = static_cast<double>(random.Between(-LatticeLimit, LatticeLimit)) /
      static_cast<double>(LatticeLimit);
    const double x = i == 0 ? magnitude : (i == 1 ? -magnitude : magnitude * fraction);
    const double q = lattice.ToLattice(x);
    CHECK(std::fabs(q) < sb::Lattice::Limit);
    CHECK_EQUAL(q, std::nearbyint(q));
    CHECK(!(q == 0.0 && std::signbit(q)));
    // Half a step off at most; every product here is exact.
    const double back = lattice.ToWorld(q);
    CHECK(std::fabs(std::ldexp(back, lattice.Exponent / 2) - std::ldexp(x, lattice.Exponent / 2)) <=
      std::ldexp(0.5, lattice.Exponent / 2 - lattice.Exponent));
    CHECK_EQUAL(lattice.ToLattice(back), q);
  }
  // No finer lattice would do.
  CHECK(std::fabs(lattice.ToLattice(magnitude)) >= sb::Lattice::Limit / 2.0);
}

void TestTiesToEven()
{
  const sb::Lattice lattice = sb::Lattice::WithExponent(0);
  const double cases[][2] = { { 0.5, 0.0 }, { 1.5, 2.0 }, { 2.5, 2.0 }, { -0.5, 0.0 },
    { -1.5, -2.0 }, { 4503599627370494.5, 4503599627370494.0 }, { 0.49999999999999994, 0.0 },
    { 2251799813685247.75, 2251799813685248.0 } };
  for (const auto& one : cases)
  {
    CHECK_EQUAL(lattice.ToLattice(one[0]), one[1]);
  }
}

void TestQuantise()
{
  const sb::Lattice lattice = sb::Lattice::ForMagnitude(1.0);
  CHECK_EQUAL(lattice.Exponent, 51);
  const double in[3] = { 1.0, -0.25, 0.0 };
  double out[3] = {};
  lattice.Quantise(in, out);
  CHECK_EQUAL(out[0], 2251799813685248.0);
  CHECK_EQUAL(out[1], -562949953421312.0);
  CHECK_EQUAL(out[2], 0.0);
  CHECK_EQUAL(lattice.ToWorld(out[1]), -0.25);
}

void TestZero()
{
  const sb::Lattice lattice = sb::Lattice::ForMagnitude(0.0);
  CHECK_EQUAL(lattice.ToLattice(0.0), 0.0);
  CHECK_EQUAL(lattice.ToWorld(0.0), 0.0);
}

} // namespace

int main()
{
  Random random(2);
  const double magnitudes[] = { 1.0, 0.75, 1e-300, 1e-308, 1e-320, 1e-292, 1e-285, 1e-6, 1e6,
    5613583.0, 1e18, 1e150, 1e300, 1e308, 4503599627370495.0, 4503599627370495.5,
    std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0), std::nextafter(1e300, 0.0),
    std::numeric_limits<double>::min(), std::numeric_limits<double>::denorm_min() };
  for (const double magnitude : magnitudes)
  {
    TestMagnitude(magnitude, random);
  }
  TestTiesToEven();
  TestQuantise();
  TestZero();
  return check::Verdict("TestLattice");
}
