// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DuplicateCells.h
 * @brief Cells that have the same corners as an earlier one, whatever their orientation and the
 * corner at which they start.
 *
 * Copies share all their edges. So the one neighbour of a cell at a single edge tells that most
 * cells have none; only the others are compared with each other.
 */
#ifndef sb_DuplicateCells_h
#define sb_DuplicateCells_h

#include "CellRuns.h"
#include "Executor.h"
#include "MeshEdges.h"

#include <cstdint>
#include <vector>

namespace sb
{

/**
 * @param corners three vertices a triangle; points at one place have to be one vertex
 * @return for each cell the first one with the same corners, mostly itself; empty if no two have
 * the same
 */
std::vector<std::int32_t> FindDuplicateCells(const std::vector<std::int32_t>& corners,
  const CellRuns& cells, const MeshEdges& edges, Executor& executor);

} // namespace sb

#endif
