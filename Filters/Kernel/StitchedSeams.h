// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StitchedSeams.h
 * @brief Where triangles without area sew a long edge to shorter ones: what meets along such a seam
 * are neighbours, not an intersection.
 */
#ifndef sb_StitchedSeams_h
#define sb_StitchedSeams_h

#include "Contacts.h"
#include "DisjointSets.h"
#include "MeshEdges.h"

#include <cstdint>
#include <vector>

namespace sb
{

class StitchedSeams
{
public:
  /** @param collapsed [face] whether it has no area; may be empty. Both have to outlive this. */
  StitchedSeams(const std::vector<std::uint8_t>& collapsed, const MeshEdges& edges);

  /** Whether a contact, as both of its faces see it, lies in edges that one seam joins. */
  bool IsAlongSeam(const Contact& contact, const Contact& asOtherSeesIt) const;

private:
  /** The seam that an edge of a face belongs to, or -1. */
  std::int32_t SeamOf(std::int32_t face, int edge) const;

  const std::vector<std::uint8_t>& Collapsed;
  const MeshEdges& Edges;
  DisjointSets Sets; ///< of faces: collapsed ones that are neighbours make one seam
};

} // namespace sb

#endif
