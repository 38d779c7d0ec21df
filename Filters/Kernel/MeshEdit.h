// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshEdit.h
 * @brief Moving points, and collapsing and flipping edges, in a part of a mesh, as long as no
 * triangle turns over and the topology stays.
 */
#ifndef sb_MeshEdit_h
#define sb_MeshEdit_h

#include "CombinedMesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace sb
{

class MeshEdit
{
public:
  /** How a triangle has to face. */
  struct Front
  {
    Real3 Direction{}; ///< of length one or zero
    double LeastCosine = 0.0; ///< between it and the triangle's normal
  };
  using FrontOf = std::function<Front(std::int32_t triangle)>;

  /** @param zone 1 for the points that can be moved or collapsed; only there edits are possible */
  MeshEdit(CombinedMesh& mesh, const std::vector<std::uint8_t>& zone, FrontOf front);

  const std::vector<std::int32_t>& TrianglesAt(std::int32_t point) const
  {
    return this->Incident[static_cast<std::size_t>(this->Zone[static_cast<std::size_t>(point)])];
  }

  /** The points that share an edge with it, ascending. */
  std::vector<std::int32_t> Neighbours(std::int32_t point) const;

  bool IsInZone(std::int32_t point) const
  {
    return this->Zone[static_cast<std::size_t>(point)] >= 0;
  }

  /** Whether it has been collapsed into another one. */
  bool IsGone(std::int32_t point) const
  {
    return this->Into[static_cast<std::size_t>(point)] != point;
  }

  /** Move a point, unless a triangle would turn over or lie across the surface. */
  bool Move(std::int32_t point, const Real3& place);

  /** An edge that may be replaced by one between `top`, of the triangle, and `bottom`, of the other
   * one. */
  struct EdgeToFlip
  {
    std::int32_t Triangle;
    std::int32_t Other;
    std::int32_t Top;
    std::int32_t Bottom;
  };
  using MayFlip = std::function<bool(const EdgeToFlip& edge)>;

  /** The triangles of a point that would turn over, or lie across the surface, if it were moved. */
  std::vector<std::int32_t> InTheWay(std::int32_t point, const Real3& place) const
  {
    return this->TurningOver(point, place, -1);
  }

  /**
   * Move a point although triangles would turn over by that: over and over the longest edge of one
   * of them is replaced by the other diagonal of its two triangles, until none does. If that cannot
   * be, nothing is changed.
   * @param mayFlip is asked about edges between triangles of one operand
   */
  bool MoveFlipping(std::int32_t point, const Real3& place, const MayFlip& mayFlip);

  /** Move `gone` into `kept`, unless a triangle would turn over or the surface would be pinched. */
  bool Collapse(std::int32_t gone, std::int32_t kept);

  /** Drop what was collapsed from the mesh. @return for each point before, its number now */
  std::vector<std::int32_t> Finish();

private:
  bool MayMove(std::int32_t point, const Real3& place, std::int32_t exceptWith) const;
  /** The triangles of the point that would get worse than they may be. */
  std::vector<std::int32_t> TurningOver(
    std::int32_t point, const Real3& place, std::int32_t exceptWith) const;
  using Corners = std::array<std::int32_t, 3>;
  /** A triangle and what its corners were. */
  struct Change
  {
    std::int32_t Triangle;
    Corners Before;
  };
  bool FlipLongestEdge(std::int32_t triangle, std::int32_t point, const Real3& place,
    const MayFlip& mayFlip, std::vector<Change>& changes);
  std::int32_t Across(std::int32_t triangle, std::int32_t a, std::int32_t b) const;
  bool FacesRight(std::int32_t triangle, std::int32_t point, const Real3& place) const;
  void SetCorners(std::int32_t triangle, const Corners& corners);
  std::array<Real3, 3> PlacesOf(
    std::int32_t triangle, std::int32_t point, const Real3& place) const;

  CombinedMesh& Mesh;
  FrontOf FrontOfTriangle;
  std::vector<std::int32_t> Zone; ///< [point] its place in Incident, or -1
  std::vector<std::vector<std::int32_t>> Incident;
  std::vector<std::int32_t> Into; ///< [point] itself, or what it was collapsed into
};

} // namespace sb

#endif
