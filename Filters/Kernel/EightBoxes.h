// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EightBoxes.h
 * @brief Eight boxes of floats side by side, compared with one box at once.
 */
#ifndef sb_EightBoxes_h
#define sb_EightBoxes_h

#include <algorithm>
#include <cstddef>
#include <limits>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace sb
{

struct FloatBox
{
  float Lower[3];
  float Upper[3];

  /** A box that meets no other one. */
  static FloatBox Nothing()
  {
    constexpr float most = std::numeric_limits<float>::max();
    return { { most, most, most }, { -most, -most, -most } };
  }
};

/** Coordinate by coordinate; a lane without a box holds Nothing(). */
struct alignas(64) EightBoxes
{
  static constexpr int Width = 8;

  float Lower[3][Width];
  float Upper[3][Width];

  void Set(int lane, const FloatBox& box)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Lower[axis][lane] = box.Lower[axis];
      this->Upper[axis][lane] = box.Upper[axis];
    }
  }

  FloatBox Get(int lane) const
  {
    return { { this->Lower[0][lane], this->Lower[1][lane], this->Lower[2][lane] },
      { this->Upper[0][lane], this->Upper[1][lane], this->Upper[2][lane] } };
  }

  FloatBox Bounds() const
  {
    FloatBox bounds;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bounds.Lower[axis] = *std::min_element(this->Lower[axis], this->Lower[axis] + Width);
      bounds.Upper[axis] = *std::max_element(this->Upper[axis], this->Upper[axis] + Width);
    }
    return bounds;
  }

  /** Bit i for box i. */
  unsigned LanesThatMeet(const FloatBox& query) const;
};

inline unsigned EightBoxes::LanesThatMeet(const FloatBox& query) const
{
#if defined(__SSE2__) || defined(_M_X64)
  // Compilers do not find this by themselves, and it is most of what a query does.
  unsigned lanes = 0;
  for (int half = 0; half < Width; half += 4)
  {
    __m128 meets = _mm_castsi128_ps(_mm_set1_epi32(-1));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const __m128 lower = _mm_load_ps(this->Lower[axis] + half);
      const __m128 upper = _mm_load_ps(this->Upper[axis] + half);
      meets = _mm_and_ps(meets, _mm_cmple_ps(lower, _mm_set1_ps(query.Upper[axis])));
      meets = _mm_and_ps(meets, _mm_cmple_ps(_mm_set1_ps(query.Lower[axis]), upper));
    }
    lanes |= static_cast<unsigned>(_mm_movemask_ps(meets)) << half;
  }
  return lanes;
#else
  unsigned lanes = 0;
  for (unsigned lane = 0; lane < Width; ++lane)
  {
    const bool meets = (this->Lower[0][lane] <= query.Upper[0]) &
      (query.Lower[0] <= this->Upper[0][lane]) & (this->Lower[1][lane] <= query.Upper[1]) &
      (query.Lower[1] <= this->Upper[1][lane]) & (this->Lower[2][lane] <= query.Upper[2]) &
      (query.Lower[2] <= this->Upper[2][lane]);
    lanes |= static_cast<unsigned>(meets) << lane;
  }
  return lanes;
#endif
}

/** The number of the lowest bit that is set; there has to be one. */
inline int LowestLane(unsigned lanes)
{
#if defined(__GNUC__)
  return __builtin_ctz(lanes);
#else
  int lane = 0;
  for (; (lanes & 1u) == 0; lanes >>= 1)
  {
    ++lane;
  }
  return lane;
#endif
}

} // namespace sb

#endif
