// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Lanes.h
 * @brief Four doubles at once, in one register or two where the compiler has such vectors.
 *
 * Compilers may not reorder sums, and so do not vectorise them by themselves. The sums of four
 * lanes are the same on all machines, whatever width of registers they have.
 */
#ifndef sb_Lanes_h
#define sb_Lanes_h

#include <cstddef>

namespace sb
{

constexpr std::size_t NumberOfLanes = 4;

#if defined(__GNUC__)

using Lanes = double __attribute__((vector_size(32)));

/** The same anywhere in memory. */
using LanesInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));

inline void Fill(Lanes& lanes, double a) { lanes = Lanes{ a, a, a, a }; }
inline void Load(Lanes& lanes, const double* from)
{
  lanes = *reinterpret_cast<const LanesInMemory*>(from);
}
inline void Store(double* to, const Lanes& lanes) { *reinterpret_cast<LanesInMemory*>(to) = lanes; }

/** Keep a in the lanes where it is positive, and 0 elsewhere. */
inline void KeepPositive(Lanes& a)
{
  const Lanes zero{};
  a = a > zero ? a : zero;
}

/** Count the lanes in which a is positive, each in itself. */
inline void CountPositive(Lanes& counts, const Lanes& a)
{
  const Lanes zero{};
  const Lanes one{ 1.0, 1.0, 1.0, 1.0 };
  counts += a > zero ? one : zero;
}

#else

struct Lanes
{
  double Each[NumberOfLanes];

  double operator[](int lane) const { return this->Each[lane]; }
  Lanes& operator+=(const Lanes& b)
  {
    for (std::size_t lane = 0; lane < NumberOfLanes; ++lane)
    {
      this->Each[lane] += b.Each[lane];
    }
    return *this;
  }
};
inline Lanes operator+(Lanes a, const Lanes& b) { return a += b; }
inline Lanes operator-(Lanes a, const Lanes& b)
{
  for (std::size_t lane = 0; lane < NumberOfLanes; ++lane)
  {
    a.Each[lane] -= b.Each[lane];
  }
  return a;
}
inline Lanes operator*(Lanes a, const Lanes& b)
{
  for (std::size_t lane = 0; lane < NumberOfLanes; ++lane)
  {
    a.Each[lane] *= b.Each[lane];
  }
  return a;
}
inline void Fill(Lanes& lanes, double a)
{
  for (double& each : lanes.Each)
  {
    each = a;
  }
}
inline void Load(Lanes& lanes, const double* from)
{
  for (double& each : lanes.Each)
  {
    each = *from++;
  }
}
inline void Store(double* to, const Lanes& lanes)
{
  for (const double each : lanes.Each)
  {
    *to++ = each;
  }
}
inline void KeepPositive(Lanes& a)
{
  for (double& each : a.Each)
  {
    each = each > 0.0 ? each : 0.0;
  }
}
inline void CountPositive(Lanes& counts, const Lanes& a)
{
  for (std::size_t lane = 0; lane < NumberOfLanes; ++lane)
  {
    counts.Each[lane] += a.Each[lane] > 0.0 ? 1.0 : 0.0;
  }
}

#endif

// By reference throughout: how vectors of this size are passed by value depends on the machine.

inline double Sum(const Lanes& a) { return (a[0] + a[1]) + (a[2] + a[3]); }

} // namespace sb

#endif
