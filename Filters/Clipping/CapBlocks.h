// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CapBlocks.h
 * @brief Caps and outlines have no cell of the input, but where all their corners come from one
 * block, they close that block, and are of it.
 */
#ifndef CapBlocks_h
#define CapBlocks_h

#include "AttributeUnion.h"
#include "BlockNames.h"

class vtkPolyData;

namespace sbvtk
{

/**
 * Complete the output's cell array BlockId (BlockNames.h), or make it, and add the names.
 * @param input whose cells have blocks if there are names
 * @param points where the output's points come from; source 0 is the input
 */
void MarkBlocks(vtkPolyData* input, const BlockNames& names, const TupleSources& points,
  vtkPolyData* output, sb::Executor& executor);

} // namespace sbvtk

#endif
