// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointTable.h
 * @brief One *node* for each geometric point of the arrangement, however many constructions lead to it.
 *
 * Points are equal where their exact rational coordinates are: nodes are found by sorting the residues of the coordinates
 * modulo large primes (ExactPoint::Fingerprint), never by a tolerance.
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
   * Give each point its node: points that are equal, among themselves or to a node that exists, get the same one.
   * @return the node of each point, in their order.
   */
  std::vector<NodeId> Insert(const std::vector<ContactPoint>& points, Executor& executor);

  NodeId Size() const { return static_cast<NodeId>(this->Points.size()); }
  const ExactPoint& Point(NodeId node) const { return this->Points[std::size_t(node)].Point; }
  /** The lowest input vertex at this node, or -1 for a new point. */
  std::int32_t Vertex(NodeId node) const { return this->Points[std::size_t(node)].Vertex; }

private:
  struct Key
  {
    std::array<std::uint64_t, 2> Print;
    std::int32_t Vertex; ///< new points last
    std::int32_t Index;
  };
  static bool Before(const Key& l, const Key& r)
  {
    return l.Print != r.Print ? l.Print < r.Print : l.Index < r.Index;
  }

  std::vector<ContactPoint> Points;
  std::vector<Key> Known; ///< sorted; Index is the node
};

} // namespace sb

#endif
