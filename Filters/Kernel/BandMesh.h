// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BandMesh.h
 * @brief The triangles of a refined mesh that are near a cloud, joined by the places of their
 * corners, with the cloud's function at these.
 *
 * Its signs there tell where the cloud's surface goes through. Between two corners on one side it
 * may still dip below zero and come up again, as its slopes along the edge tell: then a corner is
 * put into the dip. After that each edge is crossed once or not at all, and each triangle by one
 * piece of curve or none; what is left out is smaller than the triangles.
 */
#ifndef sb_BandMesh_h
#define sb_BandMesh_h

#include "MovingLeastSquares.h"
#include "SurfaceRefinement.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

struct BandMesh
{
  struct Triangle
  {
    std::array<std::int32_t, 3> Places;
    std::int32_t Original; ///< before refinement
  };

  std::vector<Triangle> Triangles;
  std::vector<Real3> Places;
  std::vector<SurfaceValue> Values; ///< [place], with gradients
  double Rounding = 0.0; ///< values below it have no sign

  bool IsKnown(std::int32_t place) const
  {
    return this->Values[static_cast<std::size_t>(place)].IsNear;
  }
  /** Zero, and what cannot be told from it, counts as outside, everywhere. */
  bool IsInside(std::int32_t place) const
  {
    return this->Values[static_cast<std::size_t>(place)].Value < -this->Rounding;
  }
  const Real3& Place(std::int32_t place) const
  {
    return this->Places[static_cast<std::size_t>(place)];
  }
};

BandMesh MakeBandMesh(const RefinedSurface& refined, const MovingLeastSquares& surface,
  Executor& executor, Monitor& monitor);

} // namespace sb

#endif
