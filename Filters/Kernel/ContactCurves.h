// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ContactCurves.h
 * @brief The segments of the curves straight from the contacts, where no face has to be cut to find
 * them.
 *
 * A contact is an edge of the arrangement as it is, unless another contact of one of its two faces
 * crosses it, overlaps it or ends inside of it. That happens where areas coincide and where an
 * operand crosses itself, and hardly anywhere else; so it is refuted for each face in floating
 * point with an error bound, and where it cannot be refuted nothing is returned.
 */
#ifndef sb_ContactCurves_h
#define sb_ContactCurves_h

#include "CurveJoining.h"

#include <optional>
#include <vector>

namespace sb
{

/**
 * The segments between different operands, the same as FindCurveSegments with CurveKind::Mutual
 * gives; or nothing, if faces have to be cut for an answer.
 * @param nodes gets the contact points; to be empty
 */
std::optional<std::vector<CurveSegment>> FindSegmentsOfContacts(
  const Scene& scene, const ContactSet& contacts, PointTable& nodes, Executor& executor);

} // namespace sb

#endif
