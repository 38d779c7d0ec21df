// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CapContours.h
 * @brief The contours of all caps, each cut by the planes that come after its own.
 *
 * A cap is kept as its boundary, a closed chain of segments, and so may be concave and have holes
 * however many planes cut it; it becomes triangles at the very end. To cut a cap by a plane, its
 * segments are cut; the line in which the two planes meet is then filled in between: walking along
 * it from infinity, the cap begins and ends where its segments cross the line. The same pieces,
 * turned round, bound the cap of the other plane, so that the two caps meet in the same segments.
 */
#ifndef sb_CapContours_h
#define sb_CapContours_h

#include "ClipPoints.h"
#include "Contour.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace sb
{

/** Nodes that lie inside a segment, by its two nodes (the lower first, in order from it). */
using SplitSegments = std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>>;

/** The nodes of the parts of a segment: its ends, and those of `splits` between them. */
void AppendSplit(const SplitSegments& splits, std::int32_t from, std::int32_t to,
  std::vector<std::int32_t>& nodes);

/** What became of contours that were not closed. */
struct OpenContourCount
{
  std::int64_t Joined = 0; ///< segments added to close contours
  std::int64_t Removed = 0; ///< contours that stayed open, and were left out
};

/**
 * Complete the contours that the faces left (FaceClip.h).
 * @param contours one a plane, in and out; out: equal and opposite segments cancelled
 * @param splits where points of one cap lie on segments of another cap or of a face
 */
OpenContourCount CompleteContours(
  ClipPoints& points, std::vector<Contour>& contours, SplitSegments& splits);

/** Take out segments against equal and opposite ones. Their order is then that of their nodes. */
void CancelSegments(const ClipPoints& points, Contour& contour);

} // namespace sb

#endif
