// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceTable.h
 * @brief Numbers for places: points with equal coordinates have the same one.
 *
 * A surface that is closed by coordinates need not be so by point ids; its edges are found by the
 * places of their ends.
 */
#ifndef sb_PlaceTable_h
#define sb_PlaceTable_h

#include "Hash.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace sb
{

class PlaceTable
{
public:
  static constexpr std::int32_t None = -1;

  /** @param capacity the most places that will be added */
  explicit PlaceTable(std::size_t capacity)
  {
    std::size_t size = 16;
    while (size < 2 * capacity)
    {
      size *= 2;
    }
    this->Slots.assign(size, None);
  }

  /**
   * The number of the place of a point, the next one if it has none.
   * @param x three doubles, which must stay where they are
   */
  std::int32_t Add(const double* x)
  {
    const std::size_t slot = this->SlotOf(x);
    if (this->Slots[slot] == None)
    {
      this->Slots[slot] = static_cast<std::int32_t>(this->Points.size());
      this->Points.push_back(x);
    }
    return this->Slots[slot];
  }

  /** The number of the place, or None. */
  std::int32_t Find(const double* x) const { return this->Slots[this->SlotOf(x)]; }

  std::int32_t Size() const { return static_cast<std::int32_t>(this->Points.size()); }

  /** The first point that was added at a place. */
  const double* Point(std::int32_t place) const
  {
    return this->Points[static_cast<std::size_t>(place)];
  }

private:
  std::size_t SlotOf(const double* x) const
  {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double coordinate = x[axis] + 0.0; // one zero
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof bits);
      hash = Mix(hash + bits + 0x9e3779b97f4a7c15u);
    }
    std::size_t slot = hash & (this->Slots.size() - 1);
    while (this->Slots[slot] != None)
    {
      const double* const other = this->Point(this->Slots[slot]);
      if (other[0] == x[0] && other[1] == x[1] && other[2] == x[2])
      {
        break;
      }
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    return slot;
  }

  std::vector<std::int32_t> Slots;
  std::vector<const double*> Points;
};

/** Two places in either order, as one number. */
inline std::uint64_t PairOfPlaces(std::int32_t a, std::int32_t b)
{
  const auto ends = std::minmax(a, b);
  return std::uint64_t(static_cast<std::uint32_t>(ends.first)) << 32 |
    static_cast<std::uint32_t>(ends.second);
}

inline std::int32_t LowerPlace(std::uint64_t pair) { return static_cast<std::int32_t>(pair >> 32); }
inline std::int32_t UpperPlace(std::uint64_t pair)
{
  return static_cast<std::int32_t>(pair & 0xffffffffu);
}

} // namespace sb

#endif
