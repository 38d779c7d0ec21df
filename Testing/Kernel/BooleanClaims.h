// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BooleanClaims.h
 * @brief What every result of a Boolean operation on closed surfaces has to be: its arrays agree,
 * it is closed, and a point lies inside of it exactly where the inputs' winding numbers say.
 */
#ifndef sb_BooleanClaims_h
#define sb_BooleanClaims_h

#include "Boolean.h"
#include "Check.h"
#include "Shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace claims
{

using namespace shapes;
using sb::BooleanResult;
using sb::Fate;
using sb::Operation;
using sb::Status;

inline constexpr Operation AllOperations[] = { Operation::Union, Operation::Intersection,
  Operation::Difference, Operation::SymmetricDifference, Operation::Resolve };

inline int RoundedWinding(const Mesh& mesh, const Point& p)
{
  const double winding = Winding(mesh, p);
  CHECK(std::abs(winding - std::round(winding)) < 1e-6);
  return static_cast<int>(std::round(winding));
}

inline bool IsInside(const Case& given, const Point& p)
{
  int inputs = 0;
  int tools = 0;
  for (const Mesh& mesh : given.Inputs)
  {
    inputs += RoundedWinding(mesh, p) >= 1;
  }
  for (const Mesh& mesh : given.Tools)
  {
    tools += RoundedWinding(mesh, p) >= 1;
  }
  switch (given.Op)
  {
    case Operation::Union:
    case Operation::Resolve:
      return inputs + tools > 0;
    case Operation::Intersection:
      return given.Tools.empty() ? inputs == static_cast<int>(given.Inputs.size())
                                 : inputs > 0 && tools > 0;
    case Operation::Difference:
      return inputs > 0 && tools == 0;
    case Operation::SymmetricDifference:
      return (inputs > 0) != (tools > 0);
  }
  return false;
}

inline std::pair<Point, Point> Bounds(const Case& given)
{
  Point low{ 1e300, 1e300, 1e300 };
  Point high{ -1e300, -1e300, -1e300 };
  for (std::size_t i = 0; i < given.NumberOfOperands(); ++i)
  {
    for (const Point& p : given.Operand(i).Points)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
  }
  return { low, high };
}

/** Whether the operands' inside is enclosed once only, and so has to be the result's. */
enum class Overlaps
{
  None,
  MayRemain
};

/** Random points are inside the result exactly where the operation says. */
inline void CheckMembership(
  const Case& given, const Mesh& result, Random& random, int count, Overlaps overlaps)
{
  const auto [low, high] = Bounds(given);
  const double margin = 0.05 * Length(high - low); // flat operands have points beside them, too
  for (int i = 0; i < count; ++i)
  {
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      p[axis] = Uniform(random, low[axis] - margin, high[axis] + margin);
    }
    const int winding = RoundedWinding(result, p);
    const bool inside = IsInside(given, p);
    if (overlaps == Overlaps::None)
    {
      CHECK_EQUAL(winding, inside ? 1 : 0);
    }
    else
    {
      CHECK_EQUAL(winding >= 1, inside);
    }
  }
}

/** Every triangle of the result has the inside behind it and the outside in front: none is doubled,
 * left over or reversed. */
inline void CheckSides(const Mesh& result, Random& random, int count, double size)
{
  for (int i = 0; i < count && !result.Triangles.empty(); ++i)
  {
    const Corners& t = result.Triangles[random() % result.Triangles.size()];
    const Point normal =
      Cross(result.At(t, 1) - result.At(t, 0), result.At(t, 2) - result.At(t, 0));
    if (Length(normal) < 1e-3 * size * size)
    {
      continue;
    }
    const double u = Uniform(random, 0.2, 0.4);
    const double v = Uniform(random, 0.2, 0.4);
    const Point p = (1 - u - v) * result.At(t, 0) + u * result.At(t, 1) + v * result.At(t, 2);
    const Point step = (1e-8 * size / Length(normal)) * normal;
    CHECK_EQUAL(RoundedWinding(result, p + step), 0);
    CHECK_EQUAL(RoundedWinding(result, p - step), 1);
  }
}

/** The arrays of a result agree with each other and with the inputs. */
inline void CheckForm(const Case& given, const BooleanResult& result)
{
  CHECK_EQUAL(result.Fates.size(), given.NumberOfOperands());
  CHECK_EQUAL(result.PointMap.size(), given.NumberOfOperands());
  CHECK_EQUAL(result.KeptPoints.size(), given.NumberOfOperands());
  std::int32_t next = 0;
  for (std::size_t operand = 0; operand < result.KeptPoints.size(); ++operand)
  {
    const std::vector<std::int32_t>& kept = result.KeptPoints[operand];
    CHECK(std::is_sorted(kept.begin(), kept.end()));
    CHECK_EQUAL(result.PointMap[operand].size(), given.Operand(operand).Points.size());
    for (const std::int32_t point : kept)
    {
      CHECK_EQUAL(result.PointMap[operand][static_cast<std::size_t>(point)], next);
      ++next;
    }
  }
  const std::int32_t points = next + static_cast<std::int32_t>(result.Interpolated.size());
  std::vector<std::uint8_t> used(static_cast<std::size_t>(points), 0);
  const auto use = [&](std::int32_t id) {
    CHECK(id >= 0 && id < points);
    if (id >= 0 && id < points)
    {
      used[static_cast<std::size_t>(id)] = 1;
    }
  };
  for (std::size_t operand = 0; operand < result.Fates.size(); ++operand)
  {
    for (std::size_t i = 0; i < result.Fates[operand].size(); ++i)
    {
      if (result.Fates[operand][i] == Fate::Kept || result.Fates[operand][i] == Fate::KeptReversed)
      {
        for (const std::int32_t corner : given.Operand(operand).Triangles[i])
        {
          use(result.PointMap[operand][static_cast<std::size_t>(corner)]);
        }
      }
    }
  }
  const std::size_t pieces = result.Split.Corners.size();
  CHECK_EQUAL(result.Split.Operand.size(), pieces);
  CHECK_EQUAL(result.Split.Parent.size(), pieces);
  CHECK_EQUAL(result.Split.Reversed.size(), pieces);
  for (std::size_t i = 0; i < pieces; ++i)
  {
    for (const std::int32_t corner : result.Split.Corners[i])
    {
      use(corner);
    }
    const auto operand = static_cast<std::size_t>(result.Split.Operand[i]);
    CHECK(result.Fates[operand][static_cast<std::size_t>(result.Split.Parent[i])] == Fate::Split);
  }
  CHECK_EQUAL(std::count(used.begin(), used.end(), 0), 0);
}

/** Compute, and check what holds for every closed operand. */
inline Mesh ComputeAndCheck(const Case& given, Random& random, Overlaps overlaps = Overlaps::None)
{
  const BooleanResult result = Compute(given);
  CHECK(!sb::IsError(result.Condition));
  CHECK(result.Condition != Status::NonSeparatingSheet && result.Condition != Status::OpenOperand);
  CheckForm(given, result);
  const Mesh mesh = ResultMesh(given, result);
  const std::int64_t openEdges = NumberOfOpenEdges(mesh);
  CHECK_EQUAL(openEdges, 0);
  if (openEdges != 0)
  {
    return mesh; // without an inside
  }
  const auto [low, high] = Bounds(given);
  const double size = Length(high - low);
  CheckMembership(given, mesh, random, 6, overlaps);
  if (overlaps == Overlaps::None)
  {
    CheckSides(mesh, random, 4, size);
  }
  return mesh;
}

/** Nearly equal, as measured by what the terms could be. */
inline void CheckNear(double found, double expected, double scale)
{
  if (!(std::abs(found - expected) <= 1e-9 * scale))
  {
    CHECK_EQUAL(found, expected);
  }
  else
  {
    CHECK(true);
  }
}

} // namespace claims

#endif
