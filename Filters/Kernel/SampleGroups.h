// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampleGroups.h
 * @brief The samples of a cloud in groups of eight neighbours, packed as registers want them, and
 * the groups that lie near a place.
 *
 * A sum over the samples near a place takes whole groups: what is out of reach weighs nothing. So
 * nothing is copied together for it, and a sum has the same bits whatever else was looked at.
 * Groups are found in two steps. Around many places that are to follow each other the tree is
 * looked up once; for each place what it found is filtered by the distance of boxes, eight at once.
 */
#ifndef sb_SampleGroups_h
#define sb_SampleGroups_h

#include "PointTree.h"
#include "Real3.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

class SampleGroups
{
  struct Box ///< around a group
  {
    Real3 Lower, Upper;
    double Reach; ///< of the sample in there that reaches farthest
  };

public:
  static constexpr std::size_t Size = PointTree::GroupSize; ///< samples in a group
  /** Of a group: coordinates, normals, 1 / reach^2; Size numbers each. */
  static constexpr std::size_t NumberOfRows = 7;

  /**
   * @param normals three doubles for each point of the tree's input
   * @param reaches of the points in the order of the tree, or empty if all reach equally far
   * @param reach of the point that reaches farthest
   */
  SampleGroups(
    const PointTree& tree, const double* normals, const std::vector<double>& reaches, double reach);

  bool IsUneven() const { return !this->NodeReaches.empty(); }

  /** One number of the i-th point of the tree. */
  double Of(std::int32_t i, std::size_t row) const
  {
    return this->Group(
      static_cast<std::size_t>(i) / Size)[row * Size + static_cast<std::size_t>(i) % Size];
  }

  /** Memory of one thread, to use again and again. */
  class Nearby
  {
  public:
    /** Groups that may hold samples that reach the places asked for. */
    std::size_t Count() const { return this->NumberOfNear; }
    const double* const* Groups() const { return this->Near.data(); }

  private:
    friend class SampleGroups;
    std::vector<const double*> Around;
    std::vector<const Box*> Found;
    std::vector<double> Boxes; ///< of those around, by rows of Capacity
    std::vector<double> Room; ///< squared distances
    std::size_t Capacity = 0;
    std::vector<const double*> Near;
    std::size_t NumberOfNear = 0;
  };

  /** Look up what may reach places up to `radius` from the centre. */
  void Surround(const PointTree& tree, const Real3& centre, double radius, Nearby& nearby) const;

  /** Of that, what may reach places up to `margin` from x. */
  void Filter(const Real3& x, double margin, Nearby& nearby) const;

private:
  const double* Group(std::size_t i) const { return this->Packed.data() + i * NumberOfRows * Size; }

  std::vector<double> Packed;
  std::vector<Box> Boxes; ///< of groups
  std::vector<double> NodeReaches; ///< of the tree's nodes; empty if all are the same
  double Reach;
};

} // namespace sb

#endif
