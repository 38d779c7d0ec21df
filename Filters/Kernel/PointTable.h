// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointTable.h
 * @brief One *node* for each geometric point of the arrangement, however many constructions lead to
 * it.
 *
 * Points are equal where their exact rational coordinates are, never by a tolerance. A point's
 * approximation is its exact value correctly rounded, so equal points have equal approximations,
 * whatever made them: sorting by approximation brings them together, and an exact comparison
 * decides among the few that have the same one.
 */
#ifndef sb_PointTable_h
#define sb_PointTable_h

#include "Contacts.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** A node of the arrangement. */
using NodeId = std::int32_t;

class PointTable
{
public:
  /**
   * Give each point its node: points that are equal, among themselves or to a node that exists, get
   * the same one.
   * @return the node of each point, in their order.
   */
  std::vector<NodeId> Insert(const std::vector<ContactPoint>& points, Executor& executor);

  NodeId Size() const { return static_cast<NodeId>(this->Points.size()); }
  const ExactPoint& Point(NodeId node) const { return this->Points[std::size_t(node)].Point; }
  /** The lowest input vertex at this node, or -1 for a new point. */
  std::int32_t Vertex(NodeId node) const { return this->Points[std::size_t(node)].Vertex; }

private:
  /** A point and where it is, as near as doubles can say. */
  struct Key
  {
    std::array<double, 3> Place;
    std::int32_t Index;
  };
  static bool Before(const Key& l, const Key& r)
  {
    return l.Place != r.Place ? l.Place < r.Place : l.Index < r.Index;
  }

  std::vector<ContactPoint> Points;
  std::vector<Key> Known; ///< sorted; Index is the node
};

} // namespace sb

#endif
