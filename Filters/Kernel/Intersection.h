// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Intersection.h
 * @brief The kernel's entry for surface intersections: the curves in which surfaces meet, and the
 * surfaces cut along them.
 *
 * The arrangement is that of a Boolean (Boolean.h, whose words are used here), but nothing is
 * classified: no surface needs an inside, so open surfaces and surfaces whose triangles are
 * oriented against each other are as good as closed ones.
 */
#ifndef sb_Intersection_h
#define sb_Intersection_h

#include "Boolean.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct IntersectionRequest
{
  /** One operand: the curves in which it meets itself. Several: those in which different ones meet.
   */
  std::vector<Operand> Operands;
  std::vector<std::uint8_t> Split; ///< [operand] whether to give out that operand cut along them
};

/**
 * One operand cut along the curves. All of it is Kept or Split; only triangles without area that
 * lie near others are Dropped. A *patch* is a maximal part that no curve divides; parts that touch
 * in a point that is not on a curve are one.
 */
struct SplitSurface : CutSurfaces
{
  std::int32_t NumberOfPatches = 0;
  std::vector<std::int32_t> PatchOfTriangle; ///< [triangle]; -1 where it is split or dropped
  std::vector<std::int32_t> PatchOfPiece; ///< [piece]
  std::vector<std::uint8_t> IsOnCurve; ///< [output point]
  std::vector<std::uint8_t> HasCurveEdge; ///< [triangle] 1 for a triangle that is Kept, but has a
                                          ///< curve along an edge
};

struct IntersectionResult
{
  Status Condition = Status::Ok; ///< the gravest of Remarks
  std::vector<Remark> Remarks;
  Curves Intersection;
  std::vector<SplitSurface> Surfaces; ///< [operand]; one that was not asked for is empty
  std::vector<OperandReport> Operands;
  std::int64_t NumberOfContacts = 0; ///< pairs of triangles that touch or cross
  std::vector<StageTime> Times;
};

/**
 * Compute the curves, and the surfaces cut along them. Points are doubled along creases as by
 * SeamPoints::PerSide. Deterministic: the same bytes whatever the executor's number of threads.
 * Never throws on bad input: the condition is in the result, which is then empty. May throw
 * std::bad_alloc.
 */
IntersectionResult ComputeIntersection(
  const IntersectionRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
