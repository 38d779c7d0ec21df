// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Hash.h
 * @brief Mixing of integers to 64 bits whose sums serve as fingerprints of sets.
 *
 * The mixer is the finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom
 * number generators", OOPSLA 2014).
 */
#ifndef sb_Hash_h
#define sb_Hash_h

#include <cstdint>
#include <cstring>

namespace sb
{

inline std::uint64_t Mix(std::uint64_t x)
{
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9u;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/** A hash of an ordered pair of ids; `seed` chooses one of several independent functions. */
inline std::uint64_t HashPair(std::int32_t a, std::int32_t b, std::uint64_t seed)
{
  const std::uint64_t pair =
    (std::uint64_t(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
  return Mix(Mix(pair + 0x9e3779b97f4a7c15u * (seed + 1)) + seed);
}

/** A hash of a place, by the bits of its three coordinates. */
inline std::uint64_t HashPlace(const double* point)
{
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double coordinate = point[axis] + 0.0; // the two zeros are one place
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    hash = Mix(bits + 0x9e3779b97f4a7c15u * (hash + 1));
  }
  return hash;
}

} // namespace sb

#endif
