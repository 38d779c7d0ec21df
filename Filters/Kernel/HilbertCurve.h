// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HilbertCurve.h
 * @brief The order of points along D. Hilbert's curve, in which neighbours mostly follow each
 * other.
 *
 * Points put into a triangulation in this order are each found a few cells from the one before.
 */
#ifndef sb_HilbertCurve_h
#define sb_HilbertCurve_h

#include <cstdint>
#include <utility>

namespace sb
{

/** The place along the curve of a cell of a grid with 2^16 cells a side. */
inline std::uint64_t HilbertIndex(std::uint32_t x, std::uint32_t y)
{
  std::uint64_t index = 0;
  for (std::uint32_t side = 1u << 15; side > 0; side >>= 1)
  {
    const std::uint32_t right = (x & side) ? 1 : 0;
    const std::uint32_t upper = (y & side) ? 1 : 0;
    index += std::uint64_t(side) * side * ((3 * right) ^ upper);
    if (!upper)
    {
      if (right)
      {
        x = 65535u - x;
        y = 65535u - y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

} // namespace sb

#endif
