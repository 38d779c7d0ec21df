// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Lanes.h
 * @brief Four doubles at once, in one register or two where the compiler has such vectors, and
 * eight at once for machines whose registers hold them.
 *
 * Compilers may not reorder sums, and so do not vectorise them by themselves. What is to be the
 * same on all machines is summed in eight lanes: in WideLanes, or in Lanes once for the lower and
 * once for the upper half. Both add up to the same bits.
 */
#ifndef sb_Lanes_h
#define sb_Lanes_h

#include <cstddef>

#if defined(__GNUC__) && defined(__x86_64__)
#define SB_WITH_AVX ///< functions can be compiled for registers that not every machine has
#endif

namespace sb
{

#if defined(__GNUC__)

using Lanes = double __attribute__((vector_size(32)));
using WideLanes = double __attribute__((vector_size(64)));

/** The same anywhere in memory. */
template <class L>
struct InMemory;
template <>
struct InMemory<Lanes>
{
  using Type = double __attribute__((vector_size(32), aligned(8), may_alias));
};
template <>
struct InMemory<WideLanes>
{
  using Type = double __attribute__((vector_size(64), aligned(8), may_alias));
};

template <class L>
inline void Fill(L& lanes, double a)
{
  lanes = L{} + a;
}
template <class L>
inline void Load(L& lanes, const double* from)
{
  lanes = *reinterpret_cast<const typename InMemory<L>::Type*>(from);
}
template <class L>
inline void Store(double* to, const L& lanes)
{
  *reinterpret_cast<typename InMemory<L>::Type*>(to) = lanes;
}

/** Keep a in the lanes where it is positive, and 0 elsewhere. */
template <class L>
inline void KeepPositive(L& a)
{
  const L zero{};
  a = a > zero ? a : zero;
}

/** Count the lanes in which a is positive, each in itself. */
template <class L>
inline void CountPositive(L& counts, const L& a)
{
  const L zero{};
  const L one = zero + 1.0;
  counts += a > zero ? one : zero;
}

#else

struct Lanes
{
  static constexpr std::size_t Size = 4;
  double Each[Size];

  double operator[](int lane) const { return this->Each[lane]; }
  Lanes& operator+=(const Lanes& b)
  {
    for (std::size_t lane = 0; lane < Lanes::Size; ++lane)
    {
      this->Each[lane] += b.Each[lane];
    }
    return *this;
  }
};
inline Lanes operator+(Lanes a, const Lanes& b) { return a += b; }
inline Lanes operator-(Lanes a, const Lanes& b)
{
  for (std::size_t lane = 0; lane < Lanes::Size; ++lane)
  {
    a.Each[lane] -= b.Each[lane];
  }
  return a;
}
inline Lanes operator*(Lanes a, const Lanes& b)
{
  for (std::size_t lane = 0; lane < Lanes::Size; ++lane)
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
  for (std::size_t lane = 0; lane < Lanes::Size; ++lane)
  {
    counts.Each[lane] += a.Each[lane] > 0.0 ? 1.0 : 0.0;
  }
}

#endif

// By reference throughout: how vectors of this size are passed by value depends on the machine.

#ifdef SB_WITH_AVX
/** The most lanes that the machine has registers for, if more than two. */
inline int LanesOfMachine()
{
  return __builtin_cpu_supports("avx512f") ? 8 : __builtin_cpu_supports("avx") ? 4 : 2;
}
#endif

template <class L>
constexpr std::size_t NumberOfLanes = sizeof(L) / sizeof(double);

template <class L>
inline double Sum(const L& a)
{
  if constexpr (NumberOfLanes<L> == 4)
  {
    return (a[0] + a[1]) + (a[2] + a[3]);
  }
  else
  {
    return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]));
  }
}

} // namespace sb

#endif
