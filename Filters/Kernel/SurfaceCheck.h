// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceCheck.h
 * @brief The kernel's entry for the check of one surface: what is wrong with it, where, and what it
 * encloses.
 *
 * Points at one place are one *vertex*, as for a Boolean (Boolean.h). A *rim* is a loop of edges
 * that one triangle has; a *shell* is a part that hangs together by edges. Nothing is repaired.
 */
#ifndef sb_SurfaceCheck_h
#define sb_SurfaceCheck_h

#include "Boolean.h"
#include "CellRuns.h"
#include "SelfIntersection.h"
#include "Shells.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** What may be wrong at a place; the numbers are those of the filter's arrays `Defect` and never
 * change meaning. */
enum class Defect : std::uint8_t
{
  None = 0,
  RimEdge = 1, ///< an edge of one triangle
  ManyFoldEdge = 2, ///< an edge of more than two
  ContradictoryEdge = 3, ///< an edge of two that are oriented against each other
  TouchingVertex = 4, ///< a vertex in which fans of triangles meet that share no edge there
  SelfIntersection = 5, ///< triangles that meet elsewhere than in common corners and edges
  NoArea = 6, ///< a triangle whose corners lie on one line
  Duplicate = 7, ///< a cell with the corners of an earlier one
  WrongWay = 8, ///< a triangle against most of its shell, or of a shell that is inside out
  NotFinite = 9, ///< a point that has no place, or a triangle of it
  BadIndex = 10 ///< a triangle of a point that does not exist
};

constexpr std::uint16_t BitOf(Defect defect)
{
  return static_cast<std::uint16_t>(1u << static_cast<unsigned>(defect));
}

struct SurfaceCheckRequest
{
  Surface Mesh;
  CellRuns Cells; ///< of its triangles
  bool SelfIntersections = true; ///< whether to look for them, which takes longest
};

/** An edge with a defect, of RimEdge to ContradictoryEdge. */
struct DefectEdge
{
  Defect Kind;
  std::array<std::int32_t, 2> Points; ///< as its first triangle has them
  std::array<std::int32_t, 2> Triangles; ///< the first two of its triangles; the second may be -1
  std::int32_t NumberOfTriangles;
  std::int32_t Rim; ///< the number of its loop, or -1
};

struct SurfaceCheckCounts
{
  std::int64_t Vertices = 0; ///< different places that triangles use
  std::int64_t Edges = 0;
  std::int64_t RimEdges = 0;
  std::int64_t Rims = 0;
  std::int64_t ManyFoldEdges = 0;
  std::int64_t ContradictoryEdges = 0;
  std::int64_t TouchingVertices = 0;
  std::int64_t SelfIntersections = 0; ///< pairs of triangles
  std::int64_t WithoutArea = 0; ///< triangles
  std::int64_t DuplicateCells = 0;
  std::int64_t DuplicatePoints = 0;
  std::int64_t WrongWayTriangles = 0;
  std::int64_t NotFinitePoints = 0; ///< whether triangles use them or not
  std::int64_t NotFiniteTriangles = 0;
  std::int64_t BadIndexTriangles = 0;
  std::int64_t ClosedShells = 0;
  std::int64_t OneSidedShells = 0;
  std::int64_t InvertedShells = 0; ///< closed, with less than nothing enclosed (see Shell)
  std::int64_t CoveredShells = 0; ///< closed, inside of what another one encloses already
};

struct SurfaceCheckResult
{
  Status Condition = Status::Ok; ///< TooLarge or Aborted: all else is empty then
  OperandReport Report; ///< of the triangles that are good, as a Boolean reports it
  bool IsInsideOut = false; ///< closed, and its volume is negative
  bool IsContradictory = false; ///< closed but for the orientation of some triangles
  SurfaceCheckCounts Counts;
  std::vector<Shell> Shells;
  std::vector<std::int32_t> ShellOfTriangle; ///< [triangle] -1 where that has no edges
  std::vector<std::uint16_t> TriangleMarks; ///< [triangle] of BitOf
  std::vector<std::uint16_t> PointMarks; ///< [point] of BitOf; Duplicate: an earlier one is there
  std::vector<std::int32_t> RimOfPoint; ///< [point] a loop that it is on, or -1; may be empty
  std::vector<std::int32_t>
    MeetingsOfTriangle; ///< [triangle] how many others it meets; may be empty
  std::vector<DefectEdge> Edges;
  std::vector<std::int32_t> TouchingVertices; ///< one point of each
  std::vector<SelfContact> SelfContacts;
  std::vector<StageTime> Times;

  /** Sum over all shells; -1 if one of them has none. */
  std::int64_t Genus() const;
};

/**
 * Check a surface. Deterministic: the same bytes whatever the executor's number of threads. Never
 * throws on bad input. May throw std::bad_alloc.
 */
SurfaceCheckResult CheckSurface(
  const SurfaceCheckRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
