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

#include <cstdint>
#include <vector>

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
  /** A group of triangles seen from afar; in the unit of the points times the tree's scale, and
   * relative to the first point of the surface. */
  struct Dipole
  {
    Vector3 Center;
    Vector3 Normal; ///< sum of the triangles' normals, as long as their areas
    Vector3 Moment[3]; ///< [k] sum of (triangle's centre - Center)_k times its normal
    double Area = 0.0;
    double Radius = 0.0;
  };

  Dipole Gather(const std::vector<Dipole>& parts, std::size_t begin, std::size_t end) const;
  void FillLowestLevel(Executor& executor);
  double NearBy(const Vector3& query, std::int32_t node) const;

  const NearestTriangle* Tree = nullptr;
  Vector3 Reference;
  std::vector<std::vector<Dipole>> Levels; ///< [0]: groups of eight triangles
};

} // namespace sb

#endif
