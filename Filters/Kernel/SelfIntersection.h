// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelfIntersection.h
 * @brief All pairs of triangles of one surface that meet elsewhere than in common corners and
 * edges, and where.
 *
 * Nearly all triangles whose boxes meet are neighbours that do no wrong. Parts of the surface that
 * are known not to meet themselves (PlainSheets.h) are not compared with themselves at all. Other
 * pairs are not listed: each is looked at where the hierarchy comes upon it, and dropped if it is
 * certainly apart (TriangleSeparation.h). What is left goes to the exact contacts (Contacts.h).
 */
#ifndef sb_SelfIntersection_h
#define sb_SelfIntersection_h

#include "CellRuns.h"
#include "Executor.h"
#include "MeshEdges.h"
#include "Scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** A segment (or a point) that two triangles have in common, in the caller's coordinates. */
struct SelfContact
{
  std::array<std::int32_t, 2> Triangles;
  std::array<std::array<double, 3>, 2> Ends;
};

struct SelfIntersections
{
  std::vector<std::array<std::int32_t, 2>> Pairs; ///< of triangles, sorted
  std::vector<SelfContact> Contacts; ///< by pair
};

/** [face] whether its corners lie on one line of the lattice; empty if that is so of none. */
std::vector<std::uint8_t> FindFacesWithoutArea(const Scene& scene, Executor& executor);

/** What is known of the surface. */
struct SelfIntersectionInput
{
  const Scene& World; ///< with the surface as its one operand
  const std::vector<std::int32_t>& Corners; ///< three vertices a triangle
  const MeshEdges& Edges;
  const std::vector<std::uint8_t>& Collapsed; ///< faces without area, which are left out
  const CellRuns& Cells;
  /** [cell] the first one with the same corners; empty if all are different. Copies of one cell
   * are no intersection. */
  const std::vector<std::int32_t>& FirstCopies;
};

SelfIntersections FindSelfIntersections(
  const SelfIntersectionInput& input, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
