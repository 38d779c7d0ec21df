// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CheckVerdict.h
 * @brief What a check found, in one paragraph: whether the surface is fit for a Boolean, what is
 * wrong with it, and what to do about each thing.
 */
#ifndef CheckVerdict_h
#define CheckVerdict_h

#include "SurfaceCheck.h"

#include <cstdint>
#include <string>

namespace sbvtk
{

/** What a check found, in cells where the kernel counts triangles. */
struct CheckFindings
{
  const sb::SurfaceCheckResult& Result;
  std::int64_t Triangles; ///< of the whole surface
  std::int64_t DegenerateCells; ///< some of them made of no triangle at all
  std::int64_t BadCells; ///< that name a point which does not exist
  std::int64_t NotFiniteCells;
  bool LookedForSelfIntersections;
};

/** Whether Surface Boolean takes the surface as a solid without a warning, and every shell of it
 * encloses something. */
bool IsFit(const CheckFindings& findings);

/** Whether nothing at all was found. */
bool IsClean(const CheckFindings& findings);

std::string Verdict(const CheckFindings& findings);

} // namespace sbvtk

#endif
