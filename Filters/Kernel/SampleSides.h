// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampleSides.h
 * @brief Which samples of a cloud lie inside of a tool.
 *
 * Samples that are neighbours in the cloud's tree are asked about together: where the tool's
 * surface is farther from their middle than they are, one winding number tells for all of them.
 */
#ifndef sb_SampleSides_h
#define sb_SampleSides_h

#include "PointTree.h"
#include "ToolSurface.h"

#include <cstdint>
#include <vector>

namespace sb
{

/** For each sample, in the order of the tree, 1 if it is inside. */
std::vector<std::uint8_t> FindInside(
  const PointTree& samples, const ToolSurface& tool, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
