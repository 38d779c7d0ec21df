// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Boolean.h
 * @brief The kernel's one entry: Boolean operations on k triangle surfaces by their exact
 * arrangement.
 *
 * The kernel knows neither VTK nor ParaView. It takes spans of doubles and ints and gives back
 * plain arrays.
 *
 * Words used throughout the kernel:
 * - An *operand* is one input surface. Operands of the group Input are united, so are those of the
 * group Tool; the operation then combines the two unions.
 * - The *winding number* of an operand at a point is the signed number of times that its surface
 * encloses the point. A point is inside an operand where that number is at least one.
 * - *In front* of a triangle is the side its normal (right-hand rule over its corners) points to;
 * *behind* it is the other. Behind a triangle of a closed, outward oriented surface lies its
 * inside.
 * - A *piece* is a triangle of the arrangement: a part of exactly one input triangle, its *parent*.
 */
#ifndef sb_Boolean_h
#define sb_Boolean_h

#include "Executor.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sb
{

/** A triangle surface owned by the caller; it has to stay alive and unchanged during the call. */
struct Surface
{
  const double* Points = nullptr; ///< x0 y0 z0 x1 y1 z1 ...; shape (NumberOfPoints, 3), any unit.
  std::int64_t NumberOfPoints = 0;
  const std::int32_t* Triangles = nullptr; ///< point ids; shape (NumberOfTriangles, 3).
  std::int64_t NumberOfTriangles = 0;
};

enum class Group : std::uint8_t
{
  Input,
  Tool
};

/** What a pass over one surface finds: whether it is good and closed, its volume, area, box and rim
 * (Ingest.h). */
struct Examination;

/** Whether it has to be found out where a surface is open, which takes longer than all the rest. */
enum class OpenSurfaces : std::uint8_t
{
  Diagnose,
  Accept ///< enough where no surface needs an inside
};

/** Examine a surface; worth keeping, as Operand::Known, for as long as the surface does not change.
 */
std::shared_ptr<const Examination> Examine(
  const Surface& surface, Executor& executor, OpenSurfaces open = OpenSurfaces::Diagnose);

struct Operand
{
  Surface Mesh;
  Group Side = Group::Input;
  std::shared_ptr<const Examination> Known; ///< of this very surface; may be null, and is then made
};

enum class Operation : std::uint8_t
{
  Union, ///< inside any operand
  Intersection, ///< inside an Input and inside a Tool; without Tools, inside every Input
  Difference, ///< inside an Input and inside no Tool
  SymmetricDifference, ///< inside an Input or inside a Tool, not both
  Resolve ///< inside any operand, with every operand's own overlaps and self-intersections resolved
};

struct BooleanRequest
{
  std::vector<Operand> Operands;
  Operation Op = Operation::Union;
};

/** What became of an input triangle. */
enum class Fate : std::uint8_t
{
  Dropped,
  Kept, ///< in the result as it is
  KeptReversed, ///< in the result, to be turned over (a Tool's triangle in a difference)
  Split ///< replaced by pieces (none, one or many of them in the result)
};

/** Conditions a script can branch on; the numbers are the filter's field data `Status` and never
 * change meaning. */
enum class Status : std::int32_t
{
  Ok = 0,
  EmptyOperand = 1, ///< warning: an operand has no triangle; it counts as the empty set
  OpenOperand = 2, ///< warning: an operand is not closed; it separates as a sheet
  NonSeparatingSheet =
    3, ///< warning: an open operand does not cut the others through; it has no inside
  InsideOut = 4, ///< warning: a closed operand has negative volume; it was turned over
  InconsistentOrientation = 5, ///< error: neighbouring triangles are oriented against each other
  BadCoordinate = 6, ///< error: NaN or infinite coordinate
  BadIndex = 7, ///< error: a triangle names a point that does not exist
  TooLarge = 8, ///< error: more points or triangles than 32-bit ids can count
  Aborted = 9, ///< the caller asked to stop; the result is empty
  BadRequest = 10 ///< error: no operand, or a setting of the filter that cannot be used
};

/** True for the conditions under which the result is empty. */
constexpr bool IsError(Status status)
{
  return static_cast<std::int32_t>(status) >=
    static_cast<std::int32_t>(Status::InconsistentOrientation);
}

/** One remark on the inputs or the run. */
struct Remark
{
  Status Condition = Status::Ok;
  std::int32_t Operand = -1; ///< index into BooleanRequest::Operands, or -1
  std::int64_t Triangle = -1; ///< triangle of that operand where it was seen, or -1
  std::int64_t Point = -1; ///< point of that operand where it was seen, or -1
  std::int64_t Count = 0; ///< how many such places, where that was counted
};

/** An output point that is not a copy of one input point: its attributes are a weighted sum of
 * three input points. */
struct InterpolatedPoint
{
  std::array<double, 3> Position;
  std::int32_t Operand; ///< the side of the seam it belongs to
  std::array<std::int32_t, 3> PointIds; ///< the parent triangle's corners (ids of that operand)
  std::array<double, 3> Weights; ///< barycentric, they add up to one
};

/** Pieces in the result; each array has one entry a piece. */
struct Pieces
{
  std::vector<std::array<std::int32_t, 3>>
    Corners; ///< output point ids, in the parent's orientation
  std::vector<std::int32_t> Operand;
  std::vector<std::int32_t> Parent; ///< triangle of that operand
  std::vector<std::uint8_t> Reversed; ///< 1: to be turned over, as Fate::KeptReversed
};

/** The intersection curves, joined end to end. */
struct Curves
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::int32_t>
    Connectivity; ///< point ids of all polylines; a closed one ends where it starts
  std::vector<std::int32_t> Offsets; ///< size = number of polylines + 1
  /** For each segment (in the order of Connectivity) the two triangles that make it. */
  struct Makers
  {
    std::array<std::int32_t, 2> Operand;
    std::array<std::int32_t, 2> Triangle;
  };
  std::vector<Makers> Segments;
};

struct OperandReport
{
  bool Closed = false;
  double Volume = 0.0; ///< signed, unit cubed; of an open operand the value has no meaning
  double Area = 0.0; ///< unit squared
  std::array<double, 6> Bounds{}; ///< xmin xmax ymin ymax zmin zmax
};

struct StageTime
{
  const char* Name;
  double Seconds;
};

/** What became of the operands: what is left of them as it is, and what is cut to pieces. */
struct CutSurfaces
{
  std::vector<std::vector<Fate>>
    Fates; ///< [operand][triangle]; an operand wholly dropped may have an empty vector

  /** [operand][point] -> output point id, or -1 if the result does not use it. */
  std::vector<std::vector<std::int32_t>> PointMap;
  /** [operand] -> the input points copied to the output, ascending; they come first in the output,
   * operand by operand. */
  std::vector<std::vector<std::int32_t>> KeptPoints;
  /** The remaining output points, after all kept ones. */
  std::vector<InterpolatedPoint> Interpolated;

  Pieces Split;
};

struct BooleanResult : CutSurfaces
{
  Status Condition = Status::Ok; ///< the gravest of Remarks
  std::vector<Remark> Remarks;

  Curves Intersection;

  std::vector<OperandReport> Operands;
  std::int64_t NumberOfContacts =
    0; ///< pairs of triangles of different operands that touch or cross
  std::vector<StageTime> Times;
};

/**
 * How points on a seam are given out. PerSide: one point a side, with that side's attributes.
 * Shared: one point for all sides, closed by id; right where no point attributes are carried.
 */
enum class SeamPoints : std::uint8_t
{
  PerSide,
  Shared
};

/**
 * Compute the operation. Deterministic: the same bytes whatever the executor's number of threads.
 * Never throws on bad input: the condition is in the result, which is then empty. May throw
 * std::bad_alloc.
 */
BooleanResult ComputeBoolean(
  const BooleanRequest& request, SeamPoints seams, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
