// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BVH.h
 * @brief A bounding volume hierarchy without pointers: boxes sorted along a space-filling curve, eight to a node.
 *
 * Node i of a level holds the boxes of the nodes 8i..8i+7 of the level below, and of the sorted boxes themselves on the
 * lowest level (a packed R-tree: Kamel and Faloutsos, On Packing R-trees, 1993). So building it is a sort and one linear
 * pass, both parallel. Nodes hold floats in a frame of their own, rounded outward: boxes far from the origin or of any
 * scale keep 24 significant bits of the hierarchy's extent, and a node is tested with eight lanes at a time.
 */
#ifndef sb_BVH_h
#define sb_BVH_h

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
  /** Build over boxes[0..count), which stay the caller's and have to stay unchanged while the hierarchy is used. */
  void Build(const Box* boxes, std::int32_t count, Executor& executor);

  std::int32_t Size() const { return static_cast<std::int32_t>(this->Order.size()); }

  /** Call visit(i) for each box i that meets the closed box `query`; the order is that of the hierarchy. */
  template <class Visit>
  void ForEachOverlap(const Box& query, Visit&& visit) const;

private:
  static constexpr int Width = 8;
  static constexpr int MostLevels = 11; // 8^11 > 2^31

  struct FloatBox
  {
    float Lower[3];
    float Upper[3];
  };

  /** Eight boxes, coordinate by coordinate; a lane without a box holds Nothing(). */
  struct alignas(64) Node
  {
    float Lower[3][Width];
    float Upper[3][Width];

    void Set(std::size_t lane, const FloatBox& box);
    FloatBox Bounds() const;
    unsigned LanesThatMeet(const FloatBox& query) const;
  };

  struct NodeId
  {
    std::int32_t Level;
    std::int32_t Index;
  };

  void ChooseFrame(Executor& executor, std::int32_t count);
  void SortAlongCurve(Executor& executor, std::int32_t count);
  void FillLowestLevel(Executor& executor);
  void FillNextLevel(Executor& executor);

  FloatBox ToFrame(const Box& box) const;
  static FloatBox Nothing();

  const Box* Boxes = nullptr;
  std::array<double, 3> Origin{};
  double Scale = 1.0; ///< a power of two, so that only the subtraction of the origin rounds
  int UsualMagnitude = 0; ///< mean binary exponent of the boxes' longest sides
  std::vector<std::int32_t> Order;
  std::vector<std::vector<Node>> Levels; ///< [0] holds the boxes; the last has one node
};

inline void BVH::Node::Set(std::size_t lane, const FloatBox& box)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Lower[axis][lane] = box.Lower[axis];
    this->Upper[axis][lane] = box.Upper[axis];
  }
}

inline BVH::FloatBox BVH::Node::Bounds() const
{
  FloatBox bounds;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    bounds.Lower[axis] = *std::min_element(this->Lower[axis], this->Lower[axis] + Width);
    bounds.Upper[axis] = *std::max_element(this->Upper[axis], this->Upper[axis] + Width);
  }
  return bounds;
}

inline unsigned BVH::Node::LanesThatMeet(const FloatBox& query) const
{
  // Written for the compiler's vectoriser: no branch, no shift by the lane.
  static constexpr std::int32_t bit[Width] = { 1, 2, 4, 8, 16, 32, 64, 128 };
  std::int32_t lanes = 0;
  for (std::size_t lane = 0; lane < Width; ++lane)
  {
    const bool meets = (this->Lower[0][lane] <= query.Upper[0]) &
      (query.Lower[0] <= this->Upper[0][lane]) & (this->Lower[1][lane] <= query.Upper[1]) &
      (query.Lower[1] <= this->Upper[1][lane]) & (this->Lower[2][lane] <= query.Upper[2]) &
      (query.Lower[2] <= this->Upper[2][lane]);
    lanes |= meets ? bit[lane] : 0;
  }
  return static_cast<unsigned>(lanes);
}

inline BVH::FloatBox BVH::Nothing()
{
  return { { 3.0f, 3.0f, 3.0f }, { -3.0f, -3.0f, -3.0f } };
}

inline BVH::FloatBox BVH::ToFrame(const Box& box) const
{
  // A float in [-1, 1] is 2^-25 off at most, so this slack takes the bound outward. Boxes that meet as doubles meet as
  // floats wherever they are, because every step is monotone.
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

template <class Visit>
void BVH::ForEachOverlap(const Box& query, Visit&& visit) const
{
  if (this->Order.empty())
  {
    return;
  }
  const FloatBox inFrame = this->ToFrame(query);
  std::array<NodeId, MostLevels * Width> open;
  int numberOpen = 0;
  open[0] = { static_cast<std::int32_t>(this->Levels.size()) - 1, 0 };
  ++numberOpen;
  while (numberOpen > 0)
  {
    const NodeId id = open[static_cast<std::size_t>(--numberOpen)];
    const Node& node =
      this->Levels[static_cast<std::size_t>(id.Level)][static_cast<std::size_t>(id.Index)];
    unsigned lanes = node.LanesThatMeet(inFrame);
    for (int lane = 0; lanes != 0; ++lane, lanes >>= 1)
    {
      if ((lanes & 1u) == 0)
      {
        continue;
      }
      const std::int32_t child = id.Index * Width + lane;
      if (id.Level > 0)
      {
        open[static_cast<std::size_t>(numberOpen++)] = { id.Level - 1, child };
        continue;
      }
      const std::int32_t box = this->Order[static_cast<std::size_t>(child)];
      if (Overlap(this->Boxes[box], query))
      {
        visit(box);
      }
    }
  }
}

} // namespace sb

#endif
