// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapsedFaces.h
 * @brief Faces without area near other surfaces are taken out, without opening the surface.
 *
 * A face whose corners are collinear has no plane, so it cannot be cut. It only stitches edges
 * together: its longest edge to the two shorter ones. So it is left out, and its middle corner
 * becomes a point on the edge of the neighbour beyond the longest edge, which is thereby split in
 * step with the neighbours beyond the shorter ones.
 */
#ifndef sb_CollapsedFaces_h
#define sb_CollapsedFaces_h

#include "BroadPhase.h"
#include "Contacts.h"
#include "Scene.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** [face] whether it takes no part; empty if there is no such face among the pairs. */
std::vector<std::uint8_t> FindCollapsedFaces(
  const Scene& scene, const std::vector<TrianglePair>& pairs);

/** Give the neighbours of collapsed faces their points, as contacts. Keeps the contacts sorted. */
void StitchCollapsedFaces(
  const Scene& scene, const std::vector<std::uint8_t>& collapsed, ContactSet& contacts);

} // namespace sb

#endif
