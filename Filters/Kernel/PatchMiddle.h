// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchMiddle.h
 * @brief Where on its patch the middle of a facet's edge belongs.
 *
 * It is the place in the middle of the u and v of the ends. At a pole, where one of these says
 * nothing, that may be anywhere; then it is the place nearest to the middle of the chord.
 */
#ifndef sb_PatchMiddle_h
#define sb_PatchMiddle_h

#include "ClosestOnPatch.h"

#include <vector>

namespace sb
{

/** An edge of a facet: its ends on the patch. */
struct PatchEdge
{
  const NURBSSurface* Patch = nullptr;
  PlaceOnPatch A;
  PlaceOnPatch B;
};

/** Its point is that of the patch, or the middle of the chord where the patch has none near it. */
PlaceOnPatch MiddleOnPatch(const PatchEdge& edge);

/**
 * The middle of an edge that several facets have in common, on the patches of all of them. Across a
 * seam of one patch it is in the middle of u and v; where two patches meet at an angle it is where
 * their tangent planes meet the plane across the middle of the chord, again and again; else, of the
 * middles on the single patches and the places nearest to that of the chord, the one that is
 * nearest to all patches.
 * @param places on each patch, the nearest to the point
 */
Real3 CommonMiddle(const std::vector<PatchEdge>& edges, std::vector<PlaceOnPatch>& places);

} // namespace sb

#endif
