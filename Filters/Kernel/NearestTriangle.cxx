// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestTriangle.cxx
 * @brief Searching the tree; NearestTriangleBuild.cxx makes it.
 */
#include "NearestTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#if defined(__SSE2__) || defined(_M_X64)
#define SB_HAS_SSE2 1
#include <emmintrin.h>
#else
#define SB_HAS_SSE2 0
#endif
// Compiled for machines that have it, and used on those only.
#if SB_HAS_SSE2 && defined(__GNUC__)
#define SB_HAS_AVX 1
#include <immintrin.h>
#else
#define SB_HAS_AVX 0
#endif

namespace sb
{
namespace
{

/** Beyond this (in half-sizes of the surface) floats are too coarse. */
constexpr double FarAway = 16.0;
/** Beyond this the nearest triangle is that of a nearer query in the same direction, by less than
 * the rounding of its distance. */
constexpr double VeryFarAway = 0x1p27;
/** How far lengths in the frame may be off, for a query at distance one: see MeasureBoxes. */
constexpr double FloatSlack = 0x1p-19;
constexpr double DoubleSlack = 0x1p-46;

inline int LowestBit(unsigned bits)
{
#if defined(__GNUC__)
  return __builtin_ctz(bits);
#else
  int bit = 0;
  for (; (bits & 1u) == 0; bits >>= 1)
  {
    ++bit;
  }
  return bit;
#endif
}

} // namespace

template <class RealNumber>
struct NearestTriangle::Search
{
  using Real = RealNumber;

  struct Open
  {
    Real Bound;
    std::int32_t Level;
    std::int32_t Index;
  };

  Vector3 Query;
  std::array<Real, 3> InFrame;
  double Slack;
  Real Reach; ///< boxes whose squared distance is greater hold nothing nearer
  int NumberOpen = 0;
  std::array<Open, MostLevels * Width> Stack;

  Search(const Vector3& query, const Vector3& inFrame, double slack, double squaredDistance)
    : Query(query)
    , InFrame{ static_cast<Real>(inFrame.X), static_cast<Real>(inFrame.Y),
      static_cast<Real>(inFrame.Z) }
    , Slack(slack)
  {
    this->SetReach(squaredDistance);
  }

  void SetReach(double squaredDistance)
  {
    const double relative = std::is_same<Real, float>::value ? 1e-6 : 1e-14;
    const double length = std::sqrt(squaredDistance) * (1.0 + relative) + this->Slack;
    this->Reach = static_cast<Real>(
      std::min<double>(length * length * (1.0 + relative), std::numeric_limits<Real>::max()));
  }
};

/**
 * Squared distances from the query to the boxes of a node, and a bit for each lane within reach.
 * Rounding: the query, the differences and the products are off by less than eight units of the
 * last place of 1 + |query| altogether, which FloatSlack covers four times; the axes' lengths are
 * off by less than Search::SetReach allows.
 */
struct NearestTriangle::PlainBoxes
{
  using Real = float;

  static unsigned Measure(
    const Node& node, const std::array<float, 3>& query, float reach, float* squared)
  {
    unsigned within = 0;
    for (unsigned lane = 0; lane < Width; ++lane)
    {
      const float x = query[0] - node.Center[0][lane];
      const float y = query[1] - node.Center[1][lane];
      const float z = query[2] - node.Center[2][lane];
      float sum = 0.0f;
      for (int k = 0; k < 3; ++k)
      {
        const float along =
          x * node.Axis[k][0][lane] + y * node.Axis[k][1][lane] + z * node.Axis[k][2][lane];
        const float outside = std::max(std::fabs(along) - node.Extent[k][lane], 0.0f);
        sum += outside * outside;
      }
      squared[lane] = sum;
      within |= unsigned(sum <= reach) << lane;
    }
    return within;
  }
};

#if SB_HAS_SSE2
struct NearestTriangle::FourBoxes
{
  using Real = float;

  static unsigned Measure(
    const Node& node, const std::array<float, 3>& query, float reach, float* squared)
  {
    const __m128 noSign = _mm_castsi128_ps(_mm_set1_epi32(0x7fffffff));
    unsigned within = 0;
    for (int half = 0; half < Width; half += 4)
    {
      const __m128 x = _mm_sub_ps(_mm_set1_ps(query[0]), _mm_load_ps(node.Center[0] + half));
      const __m128 y = _mm_sub_ps(_mm_set1_ps(query[1]), _mm_load_ps(node.Center[1] + half));
      const __m128 z = _mm_sub_ps(_mm_set1_ps(query[2]), _mm_load_ps(node.Center[2] + half));
      __m128 sum = _mm_setzero_ps();
      for (int k = 0; k < 3; ++k)
      {
        const __m128 along =
          _mm_add_ps(_mm_add_ps(_mm_mul_ps(x, _mm_load_ps(node.Axis[k][0] + half)),
                       _mm_mul_ps(y, _mm_load_ps(node.Axis[k][1] + half))),
            _mm_mul_ps(z, _mm_load_ps(node.Axis[k][2] + half)));
        const __m128 outside =
          _mm_max_ps(_mm_sub_ps(_mm_and_ps(along, noSign), _mm_load_ps(node.Extent[k] + half)),
            _mm_setzero_ps());
        sum = _mm_add_ps(sum, _mm_mul_ps(outside, outside));
      }
      _mm_store_ps(squared + half, sum);
      within |= static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(sum, _mm_set1_ps(reach))))
        << half;
    }
    return within;
  }
};
#endif

#if SB_HAS_AVX
struct NearestTriangle::EightBoxes
{
  using Real = float;

  __attribute__((target("avx"))) static unsigned Measure(
    const Node& node, const std::array<float, 3>& query, float reach, float* squared)
  {
    const __m256 noSign = _mm256_castsi256_ps(_mm256_set1_epi32(0x7fffffff));
    const __m256 x = _mm256_sub_ps(_mm256_set1_ps(query[0]), _mm256_load_ps(node.Center[0]));
    const __m256 y = _mm256_sub_ps(_mm256_set1_ps(query[1]), _mm256_load_ps(node.Center[1]));
    const __m256 z = _mm256_sub_ps(_mm256_set1_ps(query[2]), _mm256_load_ps(node.Center[2]));
    __m256 sum = _mm256_setzero_ps();
    for (int k = 0; k < 3; ++k)
    {
      const __m256 along =
        _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(x, _mm256_load_ps(node.Axis[k][0])),
                        _mm256_mul_ps(y, _mm256_load_ps(node.Axis[k][1]))),
          _mm256_mul_ps(z, _mm256_load_ps(node.Axis[k][2])));
      const __m256 outside =
        _mm256_max_ps(_mm256_sub_ps(_mm256_and_ps(along, noSign), _mm256_load_ps(node.Extent[k])),
          _mm256_setzero_ps());
      sum = _mm256_add_ps(sum, _mm256_mul_ps(outside, outside));
    }
    _mm256_store_ps(squared, sum);
    return static_cast<unsigned>(
      _mm256_movemask_ps(_mm256_cmp_ps(sum, _mm256_set1_ps(reach), _CMP_LE_OQ)));
  }
};
#endif

/** Far away floats could not tell the boxes apart. The axes are doubles again, at right angles and
 * of length one; the builder made the boxes large enough for that. */
struct NearestTriangle::FarBoxes
{
  using Real = double;

  static unsigned Measure(
    const Node& node, const std::array<double, 3>& query, double reach, double* squared)
  {
    unsigned within = 0;
    for (unsigned lane = 0; lane < Width; ++lane)
    {
      const auto axis = [&](int k) {
        return Vector3{ node.Axis[k][0][lane], node.Axis[k][1][lane], node.Axis[k][2][lane] };
      };
      const Vector3 first = (1.0 / Length(axis(0))) * axis(0);
      Vector3 second = axis(1) - Dot(axis(1), first) * first;
      second = (1.0 / Length(second)) * second;
      const Vector3 offset{ query[0] - node.Center[0][lane], query[1] - node.Center[1][lane],
        query[2] - node.Center[2][lane] };
      const double x = std::max(std::fabs(Dot(offset, first)) - node.Extent[0][lane], 0.0);
      const double y = std::max(std::fabs(Dot(offset, second)) - node.Extent[1][lane], 0.0);
      const double z =
        std::max(std::fabs(Dot(offset, Cross(first, second))) - node.Extent[2][lane], 0.0);
      squared[lane] = x * x + y * y + z * z;
      within |= unsigned(squared[lane] <= reach) << lane;
    }
    return within;
  }
};

std::array<Vector3, 3> NearestTriangle::CornersFrom(
  const Vector3& query, std::int32_t triangle) const
{
  const std::int32_t* ids = this->Triangles.Triangles + 3 * static_cast<std::int64_t>(triangle);
  const double* points = this->Triangles.Points;
  return { this->FrameScale * (PointAt(points, ids[0]) - query),
    this->FrameScale * (PointAt(points, ids[1]) - query),
    this->FrameScale * (PointAt(points, ids[2]) - query) };
}

inline void NearestTriangle::Measure(
  const Vector3& query, std::int32_t triangle, Answer& best) const
{
  const std::array<Vector3, 3> corners = this->CornersFrom(query, triangle);
  const NearestOnTriangle found = FindNearestOnTriangle(corners[0], corners[1], corners[2]);
  if (found.SquaredDistance < best.SquaredDistance ||
    (found.SquaredDistance == best.SquaredDistance &&
      (best.Triangle < 0 || triangle < best.Triangle)))
  {
    best = { triangle, found.Where, found.Place, found.SquaredDistance };
  }
}

/** Depth first; of a node's boxes within reach the nearest comes first, which soon brings the reach
 * down to what it will be. */
template <class Boxes>
inline void NearestTriangle::Descend(Search<typename Boxes::Real>& search, Answer& best) const
{
  using Real = typename Boxes::Real;
  alignas(32) Real squared[Width];
  search.Stack[0] = { Real(0), static_cast<std::int32_t>(this->Levels.size()) - 1, 0 };
  search.NumberOpen = 1;
  while (search.NumberOpen > 0)
  {
    const auto open = search.Stack[static_cast<std::size_t>(--search.NumberOpen)];
    if (open.Bound > search.Reach)
    {
      continue;
    }
    const Node& node =
      this->Levels[static_cast<std::size_t>(open.Level)][static_cast<std::size_t>(open.Index)];
    unsigned within = Boxes::Measure(node, search.InFrame, search.Reach, squared);
    if (within == 0)
    {
      continue;
    }
    int nearest = LowestBit(within);
    for (unsigned rest = within & (within - 1); rest != 0; rest &= rest - 1)
    {
      const int lane = LowestBit(rest);
      nearest = squared[lane] < squared[nearest] ? lane : nearest;
    }
    within ^= 1u << nearest;
    if (open.Level == 0)
    {
      const std::int32_t* const triangles = this->Order.data() + open.Index * Width;
      this->MeasureWithin(search, triangles[nearest], best);
      for (; within != 0; within &= within - 1)
      {
        const int lane = LowestBit(within);
        if (squared[lane] <= search.Reach)
        {
          this->MeasureWithin(search, triangles[lane], best);
        }
      }
      continue;
    }
    for (; within != 0; within &= within - 1)
    {
      const int lane = LowestBit(within);
      search.Stack[static_cast<std::size_t>(search.NumberOpen++)] = { squared[lane], open.Level - 1,
        open.Index * Width + lane };
    }
    search.Stack[static_cast<std::size_t>(search.NumberOpen++)] = { squared[nearest],
      open.Level - 1, open.Index * Width + nearest };
  }
}

template <class Searching>
inline void NearestTriangle::MeasureWithin(
  Searching& search, std::int32_t triangle, Answer& best) const
{
  const double before = best.SquaredDistance;
  this->Measure(search.Query, triangle, best);
  if (best.SquaredDistance < before)
  {
    search.SetReach(best.SquaredDistance);
  }
}

#if SB_HAS_AVX
__attribute__((target("avx"), flatten)) void NearestTriangle::DescendByEight(
  Search<float>& search, Answer& best) const
{
  this->Descend<EightBoxes>(search, best);
}
#endif

void NearestTriangle::DescendFast(Search<float>& search, Answer& best) const
{
#if SB_HAS_AVX
  static const bool hasAVX = __builtin_cpu_supports("avx") != 0;
  if (hasAVX)
  {
    this->DescendByEight(search, best);
    return;
  }
#endif
#if SB_HAS_SSE2
  this->Descend<FourBoxes>(search, best);
#else
  this->Descend<PlainBoxes>(search, best);
#endif
}

NearestTriangle::Answer NearestTriangle::Find(
  const Vector3& query, double limit, std::int32_t guess) const
{
  Answer best;
  const double reach = limit * this->FrameScale;
  best.SquaredDistance = reach * reach;
  if (this->IsEmpty() || !std::isfinite(query.X + query.Y + query.Z))
  {
    return best;
  }
  if (guess >= 0)
  {
    this->Measure(query, guess, best);
  }
  const Vector3 origin{ this->Origin[0], this->Origin[1], this->Origin[2] };
  const Vector3 inFrame = this->FrameScale * (query - origin);
  const double size =
    std::max({ std::fabs(inFrame.X), std::fabs(inFrame.Y), std::fabs(inFrame.Z) });
  if (size <= FarAway)
  {
    Search<float> search(query, inFrame, FloatSlack * (1.0 + size), best.SquaredDistance);
    this->DescendFast(search, best);
  }
  else if (size <= VeryFarAway)
  {
    Search<double> search(query, inFrame, DoubleSlack * (1.0 + size), best.SquaredDistance);
    this->Descend<FarBoxes>(search, best);
  }
  else
  {
    const double nearer = 0.5 * VeryFarAway / size;
    const Answer along =
      this->Find(origin + nearer * (query - origin), std::numeric_limits<double>::infinity(), -1);
    this->Measure(query, along.Triangle, best);
  }
  return best;
}

bool NearestTriangle::IsOutsideBounds(const Vector3& point) const
{
  return point.X < this->LowerBounds[0] || point.X > this->UpperBounds[0] ||
    point.Y < this->LowerBounds[1] || point.Y > this->UpperBounds[1] ||
    point.Z < this->LowerBounds[2] || point.Z > this->UpperBounds[2];
}

double NearestTriangle::BytesATriangle() const
{
  double bytes = 4.0 * static_cast<double>(this->Order.size());
  for (const std::vector<Node>& level : this->Levels)
  {
    bytes += static_cast<double>(level.size() * sizeof(Node));
  }
  return this->Order.empty() ? 0.0 : bytes / static_cast<double>(this->Order.size());
}

} // namespace sb
