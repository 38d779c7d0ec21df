// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveJoining.h
 * @brief The intersection curves of an arrangement, joined end to end.
 *
 * A curve is where surfaces of different operands (or sheets of one operand cut against itself)
 * meet and part again: the inside of an area where they coincide has none, its outline has. Where
 * just two faces of one operand meet, it goes on, and there is no curve. Curves end where more or
 * fewer than two segments meet; closed ones end where they start.
 */
#ifndef sb_CurveJoining_h
#define sb_CurveJoining_h

#include "Arrangement.h"
#include "Boolean.h"

namespace sb
{

/** An edge of the arrangement at which surfaces meet. */
struct CurveSegment
{
  std::array<NodeId, 2> Ends; ///< ascending
  Curves::Makers Makers;
};

enum class CurveKind : std::uint8_t
{
  All,
  Mutual ///< of different operands only
};

/** The segments, sorted by their ends. */
std::vector<CurveSegment> FindCurveSegments(
  const Scene& scene, const Arrangement& cuts, CurveKind kind);

/** Join segments that differ in their ends. */
Curves JoinSegments(
  const Scene& scene, const PointTable& nodes, const std::vector<CurveSegment>& segments);

inline Curves JoinCurves(const Scene& scene, const Arrangement& cuts)
{
  return JoinSegments(scene, cuts.Nodes, FindCurveSegments(scene, cuts, CurveKind::All));
}

} // namespace sb

#endif
