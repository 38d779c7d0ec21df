// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WindingQuery.h
 * @brief Exact winding numbers just above a point of a face, by counting what lies above it.
 *
 * A vertical line (along the face's dominant axis) goes through a point inside the face; each face
 * of the operand that it meets higher up adds one if its front is up, and takes one off if its
 * front is down. All queries to one operand are answered in one pass over its faces.
 */
#ifndef sb_WindingQuery_h
#define sb_WindingQuery_h

#include "Scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** A vertical line through a face. */
struct Probe
{
  std::int32_t Face = -1;
  int Axis = 2;
  /** Where, in the projection that drops Axis: 256 times the lattice coordinates (Axis + 1) % 3 and
   * (Axis + 2) % 3. */
  std::array<std::int64_t, 2> Place{};
};

struct WindingQuery
{
  Probe Line;
  std::int32_t Operand = -1; ///< whose winding number is asked for
  int Winding = 0; ///< the answer
  bool Degenerate = false; ///< the line meets an edge, or a crossing of faces: ask again elsewhere
};

/** A face above the probed point, by which the winding number changes. */
struct FaceAbove
{
  std::int32_t Query;
  std::int32_t Face;
  std::int32_t Turn; ///< +1 if its front is up, else -1
};

/**
 * Answer all queries. Faces of the operand in the plane of the probed face itself count by the
 * layer they have in RadialOrder.h. Faces marked in `collapsed` are passed over.
 * @param above where to list all that was counted, sorted by query and face; may be null
 */
void AnswerQueries(const Scene& scene, const std::vector<std::uint8_t>& collapsed,
  std::vector<WindingQuery>& queries, Executor& executor, std::vector<FaceAbove>* above = nullptr);

} // namespace sb

#endif
