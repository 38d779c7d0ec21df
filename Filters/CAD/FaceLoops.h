// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceLoops.h
 * @brief Where the facets of each face end: loops of chains, each chain between two faces.
 *
 * Two names are given to a point. Its *spot* is its parameters in its face: facets of a face are
 * neighbours if they share two spots, so a cylinder ends at its seam. Its *place* is its
 * coordinates: what ends in the same places, the other way round, is the same edge seen from the
 * other face, or from the other side of the seam.
 */
#ifndef FaceLoops_h
#define FaceLoops_h

#include "DesignedSurface.h"

#include <cstdint>
#include <vector>

namespace sbvtk
{

/** A run of boundary edges of one face, with the face on its left, which has one and the same face,
 * or nothing, on its other side, and no corner. */
struct FaceChain
{
  std::int32_t Face = -1;
  std::vector<std::int32_t> Points; ///< at least two; first and last may be in one place
  std::vector<std::int32_t> Places; ///< of the points; equal coordinates, equal number
  /** The chain that runs through the same places in the other direction; may be of the same face,
   * or -1: the surface ends here. */
  std::int32_t Twin = -1;
  bool IsPole = false; ///< all of it is in one place, such as the pole of a sphere
};

struct FaceLoop
{
  std::int32_t Face = -1;
  std::vector<std::int32_t> Chains; ///< in order, closed
  double Area = 0.0; ///< in the parameters; negative around a hole
};

struct FaceLoops
{
  std::vector<FaceChain> Chains;
  std::vector<FaceLoop> Loops; ///< in the order of the faces
  /** Faces whose facets do not fit together in their parameters, as they cover each other there or
   * a loop is not closed; they have no loops. */
  std::vector<std::int32_t> Unfit;
};

/** Facets whose FaceId is negative are left out. */
FaceLoops FindFaceLoops(const sb::DesignedSurface& surface);

} // namespace sbvtk

#endif
