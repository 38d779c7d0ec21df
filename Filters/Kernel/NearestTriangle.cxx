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
#include <emmintrin.h>
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

} // namespace

template <class Real>
struct NearestTriangle::Search
{
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

  void SetReach(double squaredDistance)
  {
    const double relative = std::is_same<Real, float>::value ? 1e-6 : 1e-14;
    const double length = std::sqrt(squaredDistance) * (1.0 + relative) + this->Slack;
    this->Reach = static_cast<Real>(
      std::min<double>(length * length * (1.0 + relative), std::numeric_limits<Real>::max()));
  }
};

/**
 * Rounding: the query, the differences and the products are off by less than eight units of the
 * last place of 1 + |query| altogether, which FloatSlack covers four times; the axes' lengths are
 * off by less than Search::SetReach allows.
 */
void NearestTriangle::MeasureBoxes(
  const Node& node, const std::array<float, 3>& query, float* squared)
{
#if defined(__SSE2__) || defined(_M_X64)
  const __m128 noSign = _mm_castsi128_ps(_mm_set1_epi32(0x7fffffff));
  const __m128 zero = _mm_setzero_ps();
  const __m128 qx = _mm_set1_ps(query[0]);
  const __m128 qy = _mm_set1_ps(query[1]);
  const __m128 qz = _mm_set1_ps(query[2]);
  for (int half = 0; half < Width; half += 4)
  {
    const __m128 x = _mm_sub_ps(qx, _mm_load_ps(node.Center[0] + half));
    const __m128 y = _mm_sub_ps(qy, _mm_load_ps(node.Center[1] + half));
    const __m128 z = _mm_sub_ps(qz, _mm_load_ps(node.Center[2] + half));
    __m128 sum = zero;
    for (int k = 0; k < 3; ++k)
    {
      const __m128 along = _mm_add_ps(_mm_add_ps(_mm_mul_ps(x, _mm_load_ps(node.Axis[k][0] + half)),
                                        _mm_mul_ps(y, _mm_load_ps(node.Axis[k][1] + half))),
        _mm_mul_ps(z, _mm_load_ps(node.Axis[k][2] + half)));
      const __m128 outside =
        _mm_max_ps(_mm_sub_ps(_mm_and_ps(along, noSign), _mm_load_ps(node.Extent[k] + half)), zero);
      sum = _mm_add_ps(sum, _mm_mul_ps(outside, outside));
    }
    _mm_storeu_ps(squared + half, sum);
  }
#else
  for (int lane = 0; lane < Width; ++lane)
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
  }
#endif
}

/** The axes as doubles again at right angles and of length one; the builder made the boxes large
 * enough for that. */
void NearestTriangle::MeasureBoxes(
  const Node& node, const std::array<double, 3>& query, double* squared)
{
  for (int lane = 0; lane < Width; ++lane)
  {
    const auto axis = [&](int k) {
      return Vector3{ node.Axis[k][0][lane], node.Axis[k][1][lane], node.Axis[k][2][lane] };
    };
    const Vector3 first = (1.0 / Length(axis(0))) * axis(0);
    Vector3 second = axis(1) - Dot(axis(1), first) * first;
    second = (1.0 / Length(second)) * second;
    const Vector3 offset{ query[0] - node.Center[0][lane], query[1] - node.Center[1][lane],
      query[2] - node.Center[2][lane] };
    const Vector3 along{ Dot(offset, first), Dot(offset, second),
      Dot(offset, Cross(first, second)) };
    const double x = std::max(std::fabs(along.X) - node.Extent[0][lane], 0.0);
    const double y = std::max(std::fabs(along.Y) - node.Extent[1][lane], 0.0);
    const double z = std::max(std::fabs(along.Z) - node.Extent[2][lane], 0.0);
    squared[lane] = x * x + y * y + z * z;
  }
}

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

/** Measure what is near enough in a lowest node, or open its nodes; nearest first in both cases. */
template <class Real>
void NearestTriangle::OpenNode(
  Search<Real>& search, int level, std::int32_t index, Answer& best) const
{
  const Node& node = this->Levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(index)];
  alignas(32) Real squared[Width];
  MeasureBoxes(node, search.InFrame, squared);
  int lanes[Width];
  int count = 0;
  for (int lane = 0; lane < Width; ++lane)
  {
    if (squared[lane] <= search.Reach)
    {
      int place = count++;
      for (; place > 0 && squared[lanes[place - 1]] > squared[lane]; --place)
      {
        lanes[place] = lanes[place - 1];
      }
      lanes[place] = lane;
    }
  }
  if (level > 0)
  {
    while (count-- > 0)
    {
      search.Stack[static_cast<std::size_t>(search.NumberOpen++)] = { squared[lanes[count]],
        level - 1, index * Width + lanes[count] };
    }
    return;
  }
  for (int i = 0; i < count && squared[lanes[i]] <= search.Reach; ++i)
  {
    const double before = best.SquaredDistance;
    this->Measure(
      search.Query, this->Order[static_cast<std::size_t>(index * Width + lanes[i])], best);
    if (best.SquaredDistance < before)
    {
      search.SetReach(best.SquaredDistance);
    }
  }
}

template <class Real>
void NearestTriangle::Descend(const Vector3& query, double slack, Answer& best) const
{
  Search<Real> search;
  search.Query = query;
  search.InFrame = { static_cast<Real>((query.X - this->Origin[0]) * this->FrameScale),
    static_cast<Real>((query.Y - this->Origin[1]) * this->FrameScale),
    static_cast<Real>((query.Z - this->Origin[2]) * this->FrameScale) };
  search.Slack = slack;
  search.SetReach(best.SquaredDistance);
  this->OpenNode(search, static_cast<int>(this->Levels.size()) - 1, 0, best);
  while (search.NumberOpen > 0)
  {
    const auto open = search.Stack[static_cast<std::size_t>(--search.NumberOpen)];
    if (open.Bound <= search.Reach)
    {
      this->OpenNode(search, open.Level, open.Index, best);
    }
  }
}

NearestTriangle::Answer NearestTriangle::Find(
  const Vector3& query, double limit, std::int32_t guess) const
{
  Answer best;
  const double reach = limit * this->FrameScale;
  best.SquaredDistance = reach * reach;
  if (this->IsEmpty())
  {
    return best;
  }
  if (guess >= 0)
  {
    this->Measure(query, guess, best);
  }
  const double size = this->FrameScale *
    std::max({ std::fabs(query.X - this->Origin[0]), std::fabs(query.Y - this->Origin[1]),
      std::fabs(query.Z - this->Origin[2]) });
  if (size <= FarAway)
  {
    this->Descend<float>(query, FloatSlack * (1.0 + size), best);
  }
  else if (size <= VeryFarAway)
  {
    this->Descend<double>(query, DoubleSlack * (1.0 + size), best);
  }
  else if (size <= std::numeric_limits<double>::max())
  {
    const Vector3 origin{ this->Origin[0], this->Origin[1], this->Origin[2] };
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
