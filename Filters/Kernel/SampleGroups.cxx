// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleGroups.h"

#include "Lanes.h"

#include <algorithm>

namespace sb
{
namespace
{

constexpr std::size_t BoxRows = 7; ///< lower and upper corner, and the reach

/** How much farther x is from each box, squared, than what is in there reaches. */
struct BoxDistances
{
  const double* Rows;
  std::size_t Capacity;
  std::size_t Count;

  inline void Compute(const Real3& x, double margin, double* excess) const
  {
    const double* const lower[3] = { this->Rows, this->Rows + this->Capacity,
      this->Rows + 2 * this->Capacity };
    const double* const upper[3] = { this->Rows + 3 * this->Capacity,
      this->Rows + 4 * this->Capacity, this->Rows + 5 * this->Capacity };
    const double* const reach = this->Rows + 6 * this->Capacity;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      double squared = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double below = lower[axis][i] - x[axis];
        const double above = x[axis] - upper[axis][i];
        const double away = below > above ? below : above;
        const double outside = away > 0.0 ? away : 0.0;
        squared += outside * outside;
      }
      const double limit = reach[i] + margin;
      excess[i] = squared - limit * limit;
    }
  }
};

#ifdef SB_WITH_AVX
__attribute__((target("avx512f,prefer-vector-width=512"), flatten)) void ComputeByEight(
  const BoxDistances& boxes, const Real3& x, double margin, double* excess)
{
  boxes.Compute(x, margin, excess);
}
__attribute__((target("avx"), flatten)) void ComputeByFour(
  const BoxDistances& boxes, const Real3& x, double margin, double* excess)
{
  boxes.Compute(x, margin, excess);
}
#endif

void Compute(const BoxDistances& boxes, const Real3& x, double margin, double* excess)
{
#ifdef SB_WITH_AVX
  static const int lanes = LanesOfMachine();
  if (lanes == 8)
  {
    ComputeByEight(boxes, x, margin, excess);
    return;
  }
  if (lanes == 4)
  {
    ComputeByFour(boxes, x, margin, excess);
    return;
  }
#endif
  boxes.Compute(x, margin, excess);
}

} // namespace

SampleGroups::SampleGroups(
  const PointTree& tree, const double* normals, const std::vector<double>& reaches, double reach)
  : Reach(reach)
{
  const std::size_t count = static_cast<std::size_t>(tree.Size());
  const std::size_t groups = (count + Size - 1) / Size;
  this->Packed.resize(groups * NumberOfRows * Size);
  this->Boxes.resize(groups);
  for (std::size_t i = 0; i < groups * Size; ++i)
  {
    // The last group is filled up with copies of its last sample that are out of reach.
    const std::size_t sample = std::min(i, count - 1);
    const Real3 place = tree.Point(static_cast<std::int32_t>(sample));
    const double* const normal =
      normals + 3 * static_cast<std::ptrdiff_t>(tree.Id(static_cast<std::int32_t>(sample)));
    const double own = reaches.empty() ? reach : reaches[sample];
    double* const numbers = this->Packed.data() + i / Size * NumberOfRows * Size + i % Size;
    Box& box = this->Boxes[i / Size];
    if (i % Size == 0)
    {
      box = { place, place, own };
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      numbers[axis * Size] = place[axis];
      numbers[(3 + axis) * Size] = normal[axis];
      box.Lower[axis] = std::min(box.Lower[axis], place[axis]);
      box.Upper[axis] = std::max(box.Upper[axis], place[axis]);
    }
    numbers[6 * Size] = 1.0 / (own * own);
    box.Reach = std::max(box.Reach, own);
    if (i >= count)
    {
      numbers[0] = place[0] + 1e3 * reach; // far from all places that the box is near
    }
  }
  if (!reaches.empty())
  {
    this->NodeReaches = tree.LargestOfNodes(reaches.data());
  }
}

void SampleGroups::Surround(
  const PointTree& tree, const Real3& centre, double radius, Nearby& nearby) const
{
  nearby.Around.clear();
  const auto meets = [&](const Real3& lower, const Real3& upper, double reach) {
    return PointTree::SquaredDistance(centre, lower, upper) < (reach + radius) * (reach + radius);
  };
  std::vector<const Box*>& boxes = nearby.Found;
  boxes.clear();
  tree.ForLeaves(
    [&](std::size_t node, const Real3& lower, const Real3& upper) {
      return meets(lower, upper, this->IsUneven() ? this->NodeReaches[node] : this->Reach);
    },
    [&](std::size_t, std::int32_t begin, std::int32_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin) / Size;
           i * Size < static_cast<std::size_t>(end); ++i)
      {
        const Box& box = this->Boxes[i];
        if (meets(box.Lower, box.Upper, box.Reach))
        {
          nearby.Around.push_back(this->Group(i));
          boxes.push_back(&box);
        }
      }
    });
  const std::size_t count = boxes.size();
  if (count > nearby.Capacity)
  {
    nearby.Capacity = 2 * count;
    nearby.Boxes.resize(BoxRows * nearby.Capacity);
    nearby.Room.resize(nearby.Capacity);
    nearby.Near.resize(nearby.Capacity);
  }
  double* const rows = nearby.Boxes.data();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      rows[axis * nearby.Capacity + i] = boxes[i]->Lower[axis];
      rows[(3 + axis) * nearby.Capacity + i] = boxes[i]->Upper[axis];
    }
    rows[6 * nearby.Capacity + i] = boxes[i]->Reach;
  }
}

void SampleGroups::Filter(const Real3& x, double margin, Nearby& nearby) const
{
  const std::size_t count = nearby.Around.size();
  Compute({ nearby.Boxes.data(), nearby.Capacity, count }, x, margin, nearby.Room.data());
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    // Written always and counted only if near: no branch to guess wrong.
    nearby.Near[found] = nearby.Around[i];
    found += nearby.Room[i] < 0.0 ? 1 : 0;
  }
  nearby.NumberOfNear = found;
}

} // namespace sb
