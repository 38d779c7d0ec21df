// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ToolSurface.h
 * @brief A designed body made ready for a Boolean: closed by point ids, with fast answers to where
 * a place lies.
 */
#ifndef sb_ToolSurface_h
#define sb_ToolSurface_h

#include "Boolean.h"
#include "DesignedSurface.h"
#include "Executor.h"
#include "FastWinding.h"
#include "NearestTriangle.h"
#include "Real3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** Whether two answers to what the u and v of a place are cannot mean the same place of the domain:
 * the patch meets itself there, as a cylinder does at its seam and a sphere at its poles. */
bool AreFarApart(
  const NURBSSurface& patch, const std::array<double, 2>& a, const std::array<double, 2>& b);

class ToolSurface
{
public:
  /** The body has to stay alive and unchanged, and its ids and coordinates have to be valid. */
  ToolSurface(const DesignedSurface& body, Executor& executor);
  ToolSurface(const ToolSurface&) = delete;
  ToolSurface& operator=(const ToolSurface&) = delete;

  const DesignedSurface& Body() const { return *this->Designed; }

  /** Its triangles, in which points at one place are one. */
  Surface Mesh() const;

  std::array<std::int32_t, 3> Corners(std::int32_t triangle) const;
  Real3 Point(std::int32_t i) const;

  /** Of length one; zero for a triangle without area. */
  Real3 Normal(std::int32_t triangle) const;

  /** Whether a place that is not on the surface is inside. */
  bool IsInside(const Real3& place) const { return this->WindingNumber(place) > 0.5; }
  double WindingNumber(const Real3& place) const;

  struct Nearest
  {
    std::int32_t Triangle = -1; ///< -1 if none is nearer than the limit
    Real3 Place{};
    double Distance = 0.0; ///< the limit if none is nearer
  };
  Nearest NearestTo(const Real3& place, double limit) const;

  /** From a place to the surface, or `limit` if it is not nearer. */
  double Distance(const Real3& place, double limit) const
  {
    return this->NearestTo(place, limit).Distance;
  }

  /** The patch of a triangle, which has to have one. */
  const NURBSSurface& PatchOf(std::int32_t triangle) const
  {
    return this->Designed->Patches[static_cast<std::size_t>(
      this->Designed->FaceId[static_cast<std::size_t>(triangle)])];
  }

  /** u and v, in that patch, of a point near a triangle: those of its corners, interpolated. */
  std::array<double, 2> ParametersOf(std::int32_t triangle, const Real3& place) const;

  /** Whether the patch of two triangles meets itself between them: they see a place that both are
   * near in different parts of the domain. Triangles of two patches do not. */
  bool MeetsItselfBetween(std::int32_t s, std::int32_t t, const Real3& place) const;
  bool MeetsItselfAmong(const std::vector<std::int32_t>& triangles, const Real3& place) const;

private:
  const DesignedSurface* Designed;
  std::vector<std::int32_t> Triangles;
  NearestTriangle Tree;
  FastWinding Winding;
};

} // namespace sb

#endif
