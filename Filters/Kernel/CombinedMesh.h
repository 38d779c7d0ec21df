// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CombinedMesh.h
 * @brief The result of a Boolean of two operands as one triangle mesh that is closed by point ids,
 * with the triangle that each of its triangles comes from.
 */
#ifndef sb_CombinedMesh_h
#define sb_CombinedMesh_h

#include "Boolean.h"
#include "Real3.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

struct CombinedMesh
{
  std::vector<double> Points; ///< one a place
  std::vector<std::int32_t> Triangles;
  std::vector<std::uint8_t> Source; ///< of each triangle: the operand, 0 or 1
  std::vector<std::int32_t> Parent; ///< of each triangle: the triangle of that operand
  std::vector<std::uint8_t> Reversed; ///< of each triangle: 1 if it is turned over
  std::vector<double>
    Confidence; ///< of each triangle, in [0, 1]: how sure it is that it belongs here
  /** Of each point: the point of an operand that it is a copy of, or -1; and that operand. */
  std::vector<std::int32_t> OriginalPoint;
  std::vector<std::uint8_t> PointSource;

  std::int32_t NumberOfPoints() const
  {
    return static_cast<std::int32_t>(this->OriginalPoint.size());
  }
  std::int32_t NumberOfTriangles() const { return static_cast<std::int32_t>(this->Source.size()); }

  Real3 Point(std::int32_t i) const
  {
    const double* const p = this->Points.data() + 3 * static_cast<std::size_t>(i);
    return { p[0], p[1], p[2] };
  }
  void SetPoint(std::int32_t i, const Real3& place)
  {
    std::copy_n(place.begin(), 3, this->Points.begin() + 3 * static_cast<std::int64_t>(i));
  }
  const std::int32_t* Corners(std::int32_t triangle) const
  {
    return this->Triangles.data() + 3 * static_cast<std::size_t>(triangle);
  }
};

/** What of one operand is in the result. */
struct CombinedPart
{
  const CutSurfaces* Cut = nullptr; ///< of several parts in a row it may be the same
  std::uint8_t Source = 0; ///< the operand's number there and in Meshes
  /** How sure it is that each of its triangles and pieces is in the result, in [0, 1]; negative if
   * it is not. Null: all that are not dropped are, surely. */
  const std::vector<double>* TriangleConfidence = nullptr;
  const std::vector<double>* PieceConfidence = nullptr;
  bool TurnOver = false; ///< all of them, beside those that the cut names reversed
};

/**
 * Put the parts together; points at one place become one.
 * @param meshes the operands
 */
CombinedMesh Combine(
  const std::vector<CombinedPart>& parts, const std::vector<Surface>& meshes, Executor& executor);

/**
 * For each point the smallest number of a point at the same place.
 * @param points x, y, z of each
 */
std::vector<std::int32_t> FirstAtPlace(const double* points, std::size_t count, Executor& executor);

} // namespace sb

#endif
