// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointTree.h
 * @brief A balanced k-d tree over points (Friedman, Bentley and Finkel 1977): neighbours within a
 * distance, and the k nearest.
 *
 * The tree has no pointers: a node is split at the middle of its range of points, so that the range
 * of each node follows from its number. The points are stored in the order of the leaves, axis by
 * axis; neighbours in space are neighbours in memory. That order depends on the coordinates only,
 * so a permuted cloud gives the same tree, and sums over neighbours the same bits. Ranges start at
 * multiples of GroupSize, so that points can be worked on in groups, as registers hold them.
 */
#ifndef sb_PointTree_h
#define sb_PointTree_h

#include "Executor.h"
#include "Real3.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

class PointTree
{
public:
  /** A leaf holds one or two groups of so many points; the last group of all may not be full. */
  static constexpr std::int64_t GroupSize = 8;

  PointTree() = default;

  /**
   * @param points x, y, z of `count` points.
   * @param preference which of several points in one place is kept: the one whose triple comes
   * first in lexicographic order (a cloud's normals), or null. Points that are not finite are left
   * out, too.
   */
  PointTree(const double* points, std::int64_t count, const double* preference, Executor& executor);

  /** Points that the tree holds. */
  std::int32_t Size() const { return static_cast<std::int32_t>(this->Ids.size()); }

  /** The number in the input of the i-th point of the tree. */
  std::int32_t Id(std::int32_t i) const { return this->Ids[static_cast<std::size_t>(i)]; }

  Real3 Point(std::int32_t i) const
  {
    const std::size_t place = static_cast<std::size_t>(i);
    return { this->Axes[0][place], this->Axes[1][place], this->Axes[2][place] };
  }

  /** One coordinate of all points, in the order of the tree. */
  const double* Axis(int axis) const { return this->Axes[static_cast<std::size_t>(axis)].data(); }

  std::int64_t NumberOfNotFinite() const { return this->NotFinite; }
  std::int64_t NumberOfDuplicates() const { return this->Duplicates; }

  /** Smallest and largest coordinates; of an empty tree, zeros. */
  Real3 Lower() const { return this->Boxes.empty() ? Real3{} : this->Boxes[1].Lower; }
  Real3 Upper() const { return this->Boxes.empty() ? Real3{} : this->Boxes[1].Upper; }

  /**
   * Call visit(leaf, begin, end) for the leaves, in the order of their points, for which, as for
   * all nodes above them, near(node, lower, upper) is true.
   */
  template <class Near, class Visit>
  void ForLeaves(const Near& near, const Visit& visit) const
  {
    if (this->Boxes.empty())
    {
      return;
    }
    std::size_t stack[64];
    int depth = 0;
    stack[depth++] = 1;
    while (depth > 0)
    {
      const std::size_t node = stack[--depth];
      if (!near(node, this->Boxes[node].Lower, this->Boxes[node].Upper))
      {
        continue;
      }
      if (node >= this->FirstLeaf)
      {
        const std::int64_t leaf = static_cast<std::int64_t>(node - this->FirstLeaf);
        visit(node, this->StartOf(leaf), this->StartOf(leaf + 1));
        continue;
      }
      stack[depth++] = 2 * node + 1;
      stack[depth++] = 2 * node;
    }
  }

  /**
   * Call visit(begin, end) for the ranges of points, in their order, that may hold a point for
   * which near(lower, upper) is true of every box around it.
   */
  template <class Near, class Visit>
  void ForRanges(const Near& near, const Visit& visit) const
  {
    this->ForLeaves(
      [&near](std::size_t, const Real3& lower, const Real3& upper) { return near(lower, upper); },
      [&visit](std::size_t, std::int32_t begin, std::int32_t end) { visit(begin, end); });
  }

  /** For each node, by its number, the largest of its points' values, which are in the order of the
   * tree. */
  std::vector<double> LargestOfNodes(const double* values) const;

  /** Call visit(begin, end) for the ranges of points that may be nearer to x than the radius. */
  template <class Visit>
  void ForRangesWithin(const Real3& x, double radius, const Visit& visit) const
  {
    const double limit = radius * radius;
    this->ForRanges([&x, limit](const Real3& lower,
                      const Real3& upper) { return SquaredDistance(x, lower, upper) < limit; },
      visit);
  }

  struct Neighbour
  {
    double SquaredDistance;
    std::int32_t Index; ///< in the order of the tree
  };

  /**
   * The k points nearest to x, nearest first, equally near ones in the order of the tree.
   * @param found room for k; less are filled in if the tree has less points.
   * @return how many are filled in.
   */
  int Nearest(const Real3& x, int k, Neighbour* found) const;

  /** From x to a box; 0 inside. */
  static double SquaredDistance(const Real3& x, const Real3& lower, const Real3& upper)
  {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double below = lower[axis] - x[axis];
      const double above = x[axis] - upper[axis];
      const double away = below > above ? below : above;
      sum += away > 0.0 ? away * away : 0.0;
    }
    return sum;
  }

private:
  struct Box
  {
    Real3 Lower;
    Real3 Upper;
  };
  struct Record
  {
    Real3 Position;
    std::int32_t Id;
  };

  void DropDuplicates(std::vector<Record>& records, const double* preference, Executor& executor);
  void Split(std::vector<Record>& records, int level, Executor& executor);

  /** First point of a leaf, which is also one past the last of the leaf before. */
  std::int32_t StartOf(std::int64_t leaf) const
  {
    return static_cast<std::int32_t>(
      StartOf(leaf, this->Levels, static_cast<std::int64_t>(this->Ids.size())));
  }

  /** First of `count` points in a node, of those of its level. */
  static std::int64_t StartOf(std::int64_t node, int level, std::int64_t count)
  {
    const std::int64_t groups = (count + GroupSize - 1) / GroupSize;
    return std::min(count, GroupSize * (groups * node >> level));
  }

  std::array<std::vector<double>, 3> Axes;
  std::vector<std::int32_t> Ids;
  std::vector<Box> Boxes; ///< of node 1, the root, and of 2 n and 2 n + 1, the halves of node n
  std::size_t FirstLeaf = 1;
  int Levels = 0;
  std::int64_t NotFinite = 0;
  std::int64_t Duplicates = 0;
};

/**
 * The spacing of a cloud: the median over the points of the side of the square that a point has for
 * itself, from the distance of its eighth neighbour. No other point, no spacing: 0.
 */
double SpacingOf(const PointTree& tree, Executor& executor);

} // namespace sb

#endif
