// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneOnLattice.h
 * @brief A lattice that holds a mesh and the planes that cut it.
 */
#ifndef sb_PlaneOnLattice_h
#define sb_PlaneOnLattice_h

#include "Boolean.h"
#include "HalfSpace.h"
#include "Lattice.h"

#include <array>
#include <vector>

namespace sb
{

/** Whether a plane's numbers are finite and its normal is not zero. */
bool IsPlane(const ClipPlane& plane);

/** The box of all finite points of a mesh. */
struct MeshBounds
{
  std::array<double, 3> Low;
  std::array<double, 3> High;
};

MeshBounds FindBounds(const Surface& mesh, Executor& executor);

/**
 * The lattice for a mesh within the bounds. A plane's origin that is far from them is moved along
 * its plane, and towards them if the plane misses them altogether.
 */
Lattice PlaceOnLattice(const MeshBounds& bounds, std::vector<ClipPlane>& planes);

} // namespace sb

#endif
