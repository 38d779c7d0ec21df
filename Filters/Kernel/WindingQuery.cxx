// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "WindingQuery.h"

#include "ExactPoint.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>

namespace sb
{

namespace
{

constexpr double Refinement = 256.0;

/** Queries to one operand along one axis, by their first coordinate. */
struct QueryGroup
{
  std::int32_t Operand;
  int Axis;
  std::vector<std::size_t> Queries;
  std::vector<double>
    FirstCoordinates; ///< in lattice units, a double each: only to narrow the search
};

struct Answer
{
  std::atomic<int> Winding{ 0 };
  std::atomic<bool> Degenerate{ false };
};

std::vector<QueryGroup> GroupQueries(const std::vector<WindingQuery>& queries)
{
  std::vector<std::size_t> order(queries.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto key = [&](std::size_t i) {
    const WindingQuery& query = queries[i];
    return std::make_tuple(query.Operand, query.Line.Axis, query.Line.Place[0], i);
  };
  std::sort(
    order.begin(), order.end(), [&](std::size_t l, std::size_t r) { return key(l) < key(r); });
  std::vector<QueryGroup> groups;
  for (const std::size_t i : order)
  {
    const WindingQuery& query = queries[i];
    if (groups.empty() || groups.back().Operand != query.Operand ||
      groups.back().Axis != query.Line.Axis)
    {
      groups.push_back({ query.Operand, query.Line.Axis, {}, {} });
    }
    groups.back().Queries.push_back(i);
    groups.back().FirstCoordinates.push_back(static_cast<double>(query.Line.Place[0]) / Refinement);
  }
  return groups;
}

class Counter
{
public:
  Counter(const Scene& scene, const std::vector<WindingQuery>& queries, Answer* answers)
    : World(scene)
    , Queries(queries)
    , Answers(answers)
  {
  }

  /** Whether a query's line goes through the box. */
  bool MayMeet(const QueryGroup& group, const Box& box) const
  {
    const std::size_t u = std::size_t(group.Axis + 1) % 3;
    const std::size_t v = std::size_t(group.Axis + 2) % 3;
    auto it =
      std::lower_bound(group.FirstCoordinates.begin(), group.FirstCoordinates.end(), box.Lower[u]);
    for (; it != group.FirstCoordinates.end() && *it <= box.Upper[u]; ++it)
    {
      const double second = this->SecondCoordinate(group, it);
      if (second >= box.Lower[v] && second <= box.Upper[v])
      {
        return true;
      }
    }
    return false;
  }

  /** @param above where to list what is counted, or null */
  void Count(const QueryGroup& group, std::int32_t face, std::vector<FaceAbove>* above) const
  {
    const std::array<std::int32_t, 3> corners = this->World.Corners(group.Operand, face);
    const double* const p[3] = { this->World.Position(corners[0]), this->World.Position(corners[1]),
      this->World.Position(corners[2]) };
    const int u = (group.Axis + 1) % 3;
    const int v = (group.Axis + 2) % 3;
    const double uLow = std::min({ p[0][u], p[1][u], p[2][u] });
    const double uHigh = std::max({ p[0][u], p[1][u], p[2][u] });
    const auto first =
      std::lower_bound(group.FirstCoordinates.begin(), group.FirstCoordinates.end(), uLow);
    if (first == group.FirstCoordinates.end() || *first > uHigh)
    {
      return;
    }
    const double vLow = std::min({ p[0][v], p[1][v], p[2][v] });
    const double vHigh = std::max({ p[0][v], p[1][v], p[2][v] });
    for (auto it = first; it != group.FirstCoordinates.end() && *it <= uHigh; ++it)
    {
      const std::size_t i = group.Queries[std::size_t(it - group.FirstCoordinates.begin())];
      const double second = this->SecondCoordinate(group, it);
      if (second >= vLow && second <= vHigh && this->Queries[i].Line.Face != face)
      {
        this->CountFor(i, face, p, above);
      }
    }
  }

private:
  double SecondCoordinate(
    const QueryGroup& group, std::vector<double>::const_iterator firstCoordinate) const
  {
    const std::size_t i =
      group.Queries[std::size_t(firstCoordinate - group.FirstCoordinates.begin())];
    return static_cast<double>(this->Queries[i].Line.Place[1]) / Refinement;
  }

  void CountFor(
    std::size_t i, std::int32_t face, const double* const p[3], std::vector<FaceAbove>* list) const
  {
    const Probe& line = this->Queries[i].Line;
    const int turn = Orient2D(p[0], p[1], p[2], line.Axis);
    if (turn == 0)
    {
      return; // vertical: the line runs past it, or meets its edge, which the faces beside it
              // notice
    }
    bool onEdge = false;
    for (int edge = 0; edge < 3; ++edge)
    {
      const int side =
        Orient2DRefined(p[edge], p[(edge + 1) % 3], line.Place.data(), line.Axis) * turn;
      if (side < 0)
      {
        return;
      }
      onEdge = onEdge || side == 0;
    }
    const std::array<std::int32_t, 3> corners = this->World.Corners(line.Face);
    const double* const probed[3] = { this->World.Position(corners[0]),
      this->World.Position(corners[1]), this->World.Position(corners[2]) };
    int above = CompareHeights(p, probed, line.Place.data(), line.Axis);
    if (above == 0)
    {
      const bool coplanar = Orient3D(probed[0], probed[1], probed[2], p[0]) == 0 &&
        Orient3D(probed[0], probed[1], probed[2], p[1]) == 0 &&
        Orient3D(probed[0], probed[1], probed[2], p[2]) == 0;
      if (!coplanar)
      {
        this->Answers[i].Degenerate = true;
        return;
      }
      above = face > line.Face ? 1 : -1;
    }
    if (above > 0)
    {
      if (onEdge)
      {
        this->Answers[i].Degenerate = true;
      }
      this->Answers[i].Winding += turn;
      if (list)
      {
        list->push_back({ static_cast<std::int32_t>(i), face, turn });
      }
    }
  }

  const Scene& World;
  const std::vector<WindingQuery>& Queries;
  Answer* Answers;
};

} // namespace

void AnswerQueries(const Scene& scene, const std::vector<std::uint8_t>& collapsed,
  std::vector<WindingQuery>& queries, Executor& executor, std::vector<FaceAbove>* above)
{
  const std::unique_ptr<Answer[]> answers(new Answer[queries.size()]);
  const Counter counter(scene, queries, answers.get());
  for (const QueryGroup& group : GroupQueries(queries))
  {
    const std::vector<TriangleBlock>& blocks = scene.Blocks(group.Operand);
    const std::int32_t endOfFaces = scene.FirstFace(group.Operand + 1);
    std::vector<std::vector<FaceAbove>> lists(above ? blocks.size() : 0);
    executor.For(
      static_cast<std::int64_t>(blocks.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end; ++block)
        {
          if (!counter.MayMeet(group, blocks[std::size_t(block)].Bounds))
          {
            continue;
          }
          constexpr auto size = static_cast<std::int32_t>(TriangleBlock::Size);
          const std::int32_t first =
            scene.FirstFace(group.Operand) + static_cast<std::int32_t>(block) * size;
          for (std::int32_t face = first; face < std::min(first + size, endOfFaces); ++face)
          {
            if (collapsed.empty() || !collapsed[std::size_t(face)])
            {
              counter.Count(group, face, above ? &lists[std::size_t(block)] : nullptr);
            }
          }
        }
      });
    for (const std::vector<FaceAbove>& list : lists)
    {
      above->insert(above->end(), list.begin(), list.end());
    }
  }
  if (above)
  {
    std::sort(above->begin(), above->end(), [](const FaceAbove& l, const FaceAbove& r) {
      return l.Query != r.Query ? l.Query < r.Query : l.Face < r.Face;
    });
  }
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    queries[i].Winding = answers[i].Winding;
    queries[i].Degenerate = answers[i].Degenerate;
  }
}

} // namespace sb
