// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BVH.h
 * @brief A bounding volume hierarchy without pointers: boxes sorted along a space-filling curve,
 * eight to a node.
 *
 * Node i of a level holds the boxes of the nodes 8i..8i+7 of the level below, and of the sorted
 * boxes themselves on the lowest level (a packed R-tree: Kamel and Faloutsos, On Packing R-trees,
 * 1993). So building it is a sort and one linear pass, both parallel. Nodes hold floats in a frame
 * of their own, rounded outward: boxes far from the origin or of any scale keep 24 significant bits
 * of the hierarchy's extent, and a node is tested with eight lanes at a time.
 */
#ifndef sb_BVH_h
#define sb_BVH_h

#include "EightBoxes.h"
#include "Executor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

/** A closed axis-aligned box. */
struct Box
{
  std::array<double, 3> Lower;
  std::array<double, 3> Upper;
};

inline double LongestSide(const Box& box)
{
  return std::max(
    { box.Upper[0] - box.Lower[0], box.Upper[1] - box.Lower[1], box.Upper[2] - box.Lower[2] });
}

/** Grow `box` until it holds `other`. */
inline void Enclose(Box& box, const Box& other)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.Lower[axis] = std::min(box.Lower[axis], other.Lower[axis]);
    box.Upper[axis] = std::max(box.Upper[axis], other.Upper[axis]);
  }
}

/** Whether two closed boxes share a point. */
inline bool Overlap(const Box& a, const Box& b)
{
  // Without short cuts: which comparison fails first is a coin toss for the branch predictor.
  return (a.Lower[0] <= b.Upper[0]) & (b.Lower[0] <= a.Upper[0]) & (a.Lower[1] <= b.Upper[1]) &
    (b.Lower[1] <= a.Upper[1]) & (a.Lower[2] <= b.Upper[2]) & (b.Lower[2] <= a.Upper[2]);
}

class BVH
{
public:
  /** Build over boxes[0..count), which are copied. */
  void Build(const Box* boxes, std::int32_t count, Executor& executor);

  std::int32_t Size() const { return static_cast<std::int32_t>(this->Numbers.size()); }

  /** A box that is asked about, and the first of the hierarchy's boxes that it is to meet. */
  struct Query
  {
    Box Extent;
    std::int32_t First;
  };

  /** This many queries may be asked together. */
  static constexpr int Width = EightBoxes::Width;

  /**
   * Call visit(query, i) for each of the queries and each box i >= its First that meets it, in the
   * order of the hierarchy. Queries near each other share most of the work. With First = i + 1 for
   * box i itself as the query, each pair of boxes is found once.
   */
  template <class Visit>
  void ForEachOverlap(const Query* queries, int numberOfQueries, Visit&& visit) const;

  /** Whether any of the hierarchy's boxes meets this one. */
  bool AnyOverlap(const Box& box) const;

  /** The boxes by their numbers, in their order along the curve: box Order()[p] is at *place* p. */
  const std::vector<std::int32_t>& Order() const { return this->Numbers; }

  /** Groups of level 0 have Width places that follow each other, those of the next ones Width
   * groups. */
  std::int32_t NumberOfLevels() const { return static_cast<std::int32_t>(this->Levels.size()); }
  std::int32_t NumberOfGroups(std::int32_t level = 0) const
  {
    return this->Levels.empty()
      ? 0
      : static_cast<std::int32_t>(this->Levels[static_cast<std::size_t>(level)].size());
  }

  /**
   * Call visit(p, q) for the places p < q of each pair of boxes that meet, p in this group of level
   * 0, and of some that are only next to each other; all groups together give each pair once. What
   * lies together is asked together, whatever the order in which the boxes came. Groups with
   * skip(level, index) are passed over.
   */
  template <class Skip, class Visit>
  void ForEachPairOfGroup(std::int32_t group, Skip&& skip, Visit&& visit) const;

private:
  static constexpr int MostLevels = 11; // 8^11 > 2^31

  struct NodeId
  {
    std::int32_t Level;
    std::int32_t Index;
  };

  void ChooseFrame(const Box* boxes, std::int32_t count, Executor& executor);
  void SortAlongCurve(const Box* boxes, std::int32_t count, Executor& executor);
  void FillLowestLevel(Executor& executor);
  void FillNextLevel(Executor& executor);

  FloatBox ToFrame(const Box& box) const;

  /**
   * Call visit(place, box) for each box that meets `bounds`, until that returns false. A node of a
   * level is opened only if enter(level, index) says so.
   */
  template <class Enter, class Visit>
  void Descend(const FloatBox& bounds, Enter&& enter, Visit&& visit) const;

  std::array<double, 3> Origin{};
  double Scale = 1.0; ///< a power of two, so that only the subtraction of the origin rounds
  int UsualMagnitude = 0; ///< mean binary exponent of the boxes' longest sides
  std::vector<std::int32_t> Numbers; ///< of the boxes, in their order along the curve
  std::vector<Box> Boxes; ///< in that order too, for one cache line serves neighbours
  std::vector<std::vector<EightBoxes>> Levels; ///< [0] holds the boxes; the last has one node
};

inline FloatBox BVH::ToFrame(const Box& box) const
{
  // A float in [-1, 1] is 2^-25 off at most, so this slack takes the bound outward. Boxes that meet
  // as doubles meet as floats wherever they are, because every step is monotone.
  constexpr double slack = 1.0 / (1 << 24);
  FloatBox inFrame;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double lower = (box.Lower[axis] - this->Origin[axis]) * this->Scale;
    const double upper = (box.Upper[axis] - this->Origin[axis]) * this->Scale;
    inFrame.Lower[axis] = static_cast<float>(std::min(std::max(lower, -2.0), 2.0) - slack);
    inFrame.Upper[axis] = static_cast<float>(std::min(std::max(upper, -2.0), 2.0) + slack);
  }
  return inFrame;
}

template <class Enter, class Visit>
void BVH::Descend(const FloatBox& bounds, Enter&& enter, Visit&& visit) const
{
  if (this->Numbers.empty())
  {
    return;
  }
  std::array<NodeId, MostLevels * Width> open;
  std::size_t numberOpen = 1;
  open[0] = { static_cast<std::int32_t>(this->Levels.size()) - 1, 0 };
  while (numberOpen > 0)
  {
    const NodeId id = open[--numberOpen];
    const EightBoxes& node =
      this->Levels[static_cast<std::size_t>(id.Level)][static_cast<std::size_t>(id.Index)];
    for (unsigned lanes = node.LanesThatMeet(bounds); lanes != 0; lanes &= lanes - 1)
    {
      const int lane = LowestLane(lanes);
      const std::int32_t child = id.Index * Width + lane;
      if (id.Level == 0)
      {
        if (!visit(child, node.Get(lane)))
        {
          return;
        }
      }
      else if (enter(id.Level - 1, child))
      {
        open[numberOpen++] = { id.Level - 1, child };
      }
    }
  }
}

template <class Visit>
void BVH::ForEachOverlap(const Query* queries, int numberOfQueries, Visit&& visit) const
{
  // The queries make a node of their own. Its bounds find the boxes, each of which then meets all
  // queries at once.
  EightBoxes asking;
  for (int lane = 0; lane < Width; ++lane)
  {
    asking.Set(
      lane, lane < numberOfQueries ? this->ToFrame(queries[lane].Extent) : FloatBox::Nothing());
  }
  const auto always = [](std::int32_t, std::int32_t) { return true; };
  this->Descend(asking.Bounds(), always, [&](std::int32_t place, const FloatBox& box) {
    for (unsigned hits = asking.LanesThatMeet(box); hits != 0; hits &= hits - 1)
    {
      const int query = LowestLane(hits);
      const std::int32_t number = this->Numbers[static_cast<std::size_t>(place)];
      if (number >= queries[query].First &&
        Overlap(this->Boxes[static_cast<std::size_t>(place)], queries[query].Extent))
      {
        visit(query, number);
      }
    }
    return true;
  });
}

template <class Skip, class Visit>
void BVH::ForEachPairOfGroup(std::int32_t group, Skip&& skip, Visit&& visit) const
{
  const EightBoxes& asking = this->Levels[0][static_cast<std::size_t>(group)];
  const auto isToBeAsked = [&](std::int32_t level, std::int32_t index) {
    // Groups before the asking one have asked already.
    const std::int32_t holder = group >> 3 * level;
    return index >= holder && !skip(level, index);
  };
  this->Descend(asking.Bounds(), isToBeAsked, [&](std::int32_t place, const FloatBox& box) {
    unsigned hits = asking.LanesThatMeet(box);
    hits &= place / Width == group ? (1u << place % Width) - 1 : ~0u; // places before this one
    for (; hits != 0; hits &= hits - 1)
    {
      visit(group * Width + LowestLane(hits), place);
    }
    return true;
  });
}

} // namespace sb

#endif
