// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshParts.h
 * @brief The connected parts of a triangle mesh, and what each is like.
 */
#ifndef sb_MeshParts_h
#define sb_MeshParts_h

#include "Real3.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct MeshPart
{
  Real3 Lower{};
  Real3 Upper{};
  double Volume = 0.0; ///< signed; without meaning for a part that is open
  std::int32_t FirstPoint = 0; ///< the first corner of its first triangle

  double Diagonal() const { return Length(Difference(this->Upper, this->Lower)); }
};

struct MeshParts
{
  std::vector<std::int32_t> PartOfTriangle;
  std::vector<MeshPart> Parts; ///< in the order of their first triangles
};

/** Triangles with a common point number are connected. */
MeshParts FindParts(const std::vector<double>& points, const std::vector<std::int32_t>& triangles);

} // namespace sb

#endif
