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

  using MayFlip = std::function<bool(std::int32_t triangle, std::int32_t other)>;

  /**
   * Move a point over the opposite edge of the one triangle that would turn over by that: the edge
   * is replaced by the other diagonal of its two triangles, if these are of one operand.
   * @param mayFlip whether two triangles lie in one surface
   */
  bool MoveAcross(std::int32_t point, const Real3& place, const MayFlip& mayFlip);

  /** Move `gone` into `kept`, unless a triangle would turn over or the surface would be pinched. */
  bool Collapse(std::int32_t gone, std::int32_t kept);

  /** Drop what was collapsed from the mesh. @return for each point before, its number now */
  std::vector<std::int32_t> Finish();

private:
  bool MayMove(std::int32_t point, const Real3& place, std::int32_t exceptWith) const;
  /** The triangles of the point that would get worse than they may be. */
  std::vector<std::int32_t> TurningOver(
    std::int32_t point, const Real3& place, std::int32_t exceptWith) const;
  bool FacesRight(std::int32_t triangle, std::int32_t point, const Real3& place) const;
  void Forget(std::int32_t triangle, std::int32_t point);
  void Remember(std::int32_t triangle, std::int32_t point);
  std::array<Real3, 3> CornersOf(std::int32_t triangle) const;

  CombinedMesh& Mesh;
  FrontOf FrontOfTriangle;
  std::vector<std::int32_t> Zone; ///< [point] its place in Incident, or -1
  std::vector<std::vector<std::int32_t>> Incident;
  std::vector<std::int32_t> Into; ///< [point] itself, or what it was collapsed into
};

} // namespace sb

#endif
