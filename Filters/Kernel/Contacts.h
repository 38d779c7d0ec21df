// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Contacts.h
 * @brief The narrow phase: where exactly two triangles touch, cross or overlap.
 *
 * Two triangles in different planes meet in a segment (or a point) of the line common to both
 * planes. Each triangle cuts a chord from that line; the contact is the overlap of the two chords,
 * and the order of two chord ends along the line is the sign of one orientation determinant of four
 * input vertices (Guigue and Devillers, "Fast and robust triangle-triangle overlap test using
 * orientation predicates", Journal of Graphics Tools 8(1), 2003, section 3.2). Two coplanar
 * triangles meet in segments of their edges, found by the same chord argument one dimension down.
 * No perturbation is used: every zero sign is a vertex or an edge that really lies on the other
 * triangle.
 */
#ifndef sb_Contacts_h
#define sb_Contacts_h

#include "BroadPhase.h"
#include "ExactPoint.h"
#include "Scene.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** Where a point lies on a triangle: 0..2 its corner, 3..5 inside its edge from corner i-3 to the
 * next, 6 its interior. */
using Location = std::int8_t;
constexpr Location Interior = 6;
constexpr bool IsCorner(Location location) { return location < 3; }
constexpr bool IsEdge(Location location) { return location >= 3 && location < 6; }

/** A point of contact: an input vertex, or a new point. */
struct ContactPoint
{
  ExactPoint Point;
  std::int32_t Vertex = -1; ///< the input vertex it is, or -1
};

/** What one face sees of its contact with another: a segment, or a point where both ends are the
 * same. */
struct Contact
{
  std::int32_t Face;
  std::int32_t Other;
  /** What draws the segment's line in the plane of Face: -1 the plane of Other, else that edge
   * (0..2) of the coplanar Other. */
  std::int8_t OtherEdge;
  Location Ends[2]; ///< on Face
  std::int32_t Points[2]; ///< into the contact points
};

struct ContactSet
{
  std::vector<Contact> Contacts; ///< sorted by Face, then Other
  std::vector<ContactPoint> Points; ///< not yet unique
  std::int64_t NumberOfPairs = 0; ///< pairs of faces that meet
};

/**
 * The contacts of all pairs. Faces marked in `collapsed` (those without a plane) are skipped. Of
 * two faces of the same operand, a common corner or a common edge is no contact.
 */
ContactSet FindContacts(const Scene& scene, const std::vector<TrianglePair>& pairs,
  const std::vector<std::uint8_t>& collapsed, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
