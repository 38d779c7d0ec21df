// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Lanes.h
 * @brief Two doubles at once, in one register where the compiler has such vectors.
 *
 * Compilers may not reorder sums, and so do not vectorise them by themselves. The sums of two lanes
 * are the same on all machines.
 */
#ifndef sb_Lanes_h
#define sb_Lanes_h

namespace sb
{

#if defined(__GNUC__)

using Lanes = double __attribute__((vector_size(16)));

/** The larger of a and 0 in each lane. */
inline Lanes PositivePart(Lanes a) { return a > Lanes{ 0.0, 0.0 } ? a : Lanes{ 0.0, 0.0 }; }

/** 1 in each lane where a is positive, else 0. */
inline Lanes IsPositive(Lanes a)
{
  return a > Lanes{ 0.0, 0.0 } ? Lanes{ 1.0, 1.0 } : Lanes{ 0.0, 0.0 };
}

#else

struct Lanes
{
  double First;
  double Second;

  double operator[](int lane) const { return lane == 0 ? this->First : this->Second; }
  Lanes& operator+=(const Lanes& b)
  {
    this->First += b.First;
    this->Second += b.Second;
    return *this;
  }
};
inline Lanes operator+(Lanes a, Lanes b) { return { a.First + b.First, a.Second + b.Second }; }
inline Lanes operator-(Lanes a, Lanes b) { return { a.First - b.First, a.Second - b.Second }; }
inline Lanes operator*(Lanes a, Lanes b) { return { a.First * b.First, a.Second * b.Second }; }
inline Lanes PositivePart(Lanes a)
{
  return { a.First > 0.0 ? a.First : 0.0, a.Second > 0.0 ? a.Second : 0.0 };
}
inline Lanes IsPositive(Lanes a)
{
  return { a.First > 0.0 ? 1.0 : 0.0, a.Second > 0.0 ? 1.0 : 0.0 };
}

#endif

inline Lanes Both(double a) { return Lanes{ a, a }; }
inline Lanes Load(const double* a) { return Lanes{ a[0], a[1] }; }
inline double Sum(Lanes a) { return a[0] + a[1]; }

} // namespace sb

#endif
