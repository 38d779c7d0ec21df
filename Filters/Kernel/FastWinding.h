// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FastWinding.h
 * @brief The generalized winding number of a surface at a point: what share of all directions sees
 * its back.
 *
 * Of a closed surface it is a whole number, as in Boolean.h; of an open or dirty one it falls off
 * gently across holes (Jacobson, Kavan, Sorkine-Hornung, Robust Inside-Outside Segmentation using
 * Generalized Winding Numbers, 2013). Near triangles count by their solid angle, groups of far ones
 * by a dipole and its first derivative (Barill, Dickson, Schmidt, Levin, Jacobson, Fast Winding
 * Numbers for Soups and Clouds, 2018), so that it is not exact: off by less than 0.05.
 */
#ifndef sb_FastWinding_h
#define sb_FastWinding_h

#include "Executor.h"
#include "NearestTriangle.h"
#include "Vector3.h"
#include "WindingDipole.h"

#include <cstdint>

namespace sb
{

class FastWinding
{
public:
  /** The groups are those of the tree, which has to stay alive. */
  void Build(const NearestTriangle& tree, Executor& executor);

  /** The winding number at a point that is not on the surface. Thread-safe. */
  double At(const Vector3& query) const;

private:
  void FillLowestLevel(Executor& executor);
  double NearBy(const Vector3& query, std::int32_t node) const;

  const NearestTriangle* Tree = nullptr;
  Vector3 Reference;
  /** Lengths are in the unit of the points times the tree's scale, relative to the first point of
   * the surface. Lowest: groups of eight triangles. */
  WindingTree Groups;
};

} // namespace sb

#endif
