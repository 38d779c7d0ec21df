// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceDistance.h
 * @brief The signed distance to a triangle surface: the tree, the fans and the winding number
 * together.
 *
 * The distance is positive in front of the surface, negative behind it, zero on it. Two rules tell
 * the side:
 *
 * - Pseudonormal: the side of the nearest face, exact on a closed surface (SurfaceSide.h). Beyond
 *   the rim of an open one it is that of the rim's own faces.
 * - WindingNumber: on a closed surface exact away from the surface's own overlaps, and right inside
 *   of them, too. On an open one, behind is where the winding number is above a half, so that holes
 *   are closed softly.
 *
 * *Closed* is what it is for a Boolean: every directed edge has its opposite, whatever number of
 * triangles share it. Features at which the first rule cannot decide (SurfaceSide.h) are decided by
 * the winding number if the surface is closed, else by the pseudonormal as far as it goes. Of a
 * closed surface all that is beyond its box is outside. A closed surface that is inside out has its
 * signs inside out with both rules.
 */
#ifndef sb_SurfaceDistance_h
#define sb_SurfaceDistance_h

#include "Boolean.h"
#include "Executor.h"
#include "FastWinding.h"
#include "NearestTriangle.h"
#include "SurfaceSide.h"
#include "VertexFans.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>

namespace sb
{

enum class SignRule : std::uint8_t
{
  Unsigned,
  Pseudonormal,
  WindingNumber
};

class SurfaceDistance
{
public:
  struct Answer
  {
    double Distance = 0.0; ///< in the unit of the points
    std::int32_t Triangle = -1; ///< the nearest one; -1 if none is within the limit
    Feature Where = Feature::Face; ///< what of it is nearest
    Vector3 Nearest; ///< its nearest point
  };

  /**
   * Make ready for questions with all rules. The surface has to stay alive and unchanged, and its
   * coordinates and ids have to be valid (Examine tells).
   * @param closed, insideOut what Examine found
   */
  SurfaceDistance(const Surface& surface, bool closed, bool insideOut, Executor& executor);

  bool IsEmpty() const { return this->Tree.IsEmpty(); }

  /** The box of all triangles: xmin xmax ymin ymax zmin zmax. */
  std::array<double, 6> Bounds() const { return this->Tree.Bounds(); }

  /**
   * The distance at one point. `guess` is a triangle that is probably near, or -1. Beyond `limit`
   * there is no nearest triangle; the distance is then the limit, with the sign that it has without
   * one (so that a limit saves time only where no sign is asked for, and outside of the box of a
   * closed surface). Thread-safe.
   */
  Answer At(const Vector3& query, SignRule rule, std::int32_t guess = -1,
    double limit = std::numeric_limits<double>::infinity()) const;

  /** The angle-weighted pseudonormal of a triangle's feature, of length one or zero. */
  Vector3 Pseudonormal(std::int32_t triangle, Feature feature) const
  {
    return this->Sides.Pseudonormal(triangle, feature);
  }

  double WindingNumber(const Vector3& query) const;

private:
  double Sign(const Vector3& query, SignRule rule, const NearestTriangle::Answer& nearest) const;
  double SignOfWinding(const Vector3& query) const;

  bool Closed;
  double SignOutside; ///< of a closed surface
  NearestTriangle Tree;
  VertexFans Fans;
  SurfaceSide Sides;
  mutable std::once_flag WindingMade; ///< when it is first asked for
  mutable FastWinding Winding;
};

} // namespace sb

#endif
