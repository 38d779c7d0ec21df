// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellLists.h
 * @brief Whether the cells of a surface lie within their lists of points. VTK's readers do not
 * look, and whoever goes through the cells of a damaged file reads memory that is not theirs.
 */
#ifndef CellLists_h
#define CellLists_h

#include "Executor.h"
#include "sbSurfaceModule.h" // for the export macro

#include <string>

class vtkPolyData;

namespace sbvtk
{

/** @return empty if each cell begins where the one before it ends, within the list; else the end of
 * the sentence "Input ..." that says what is wrong. Ids in the list may be any. */
SBSURFACE_EXPORT std::string DamageOfCells(vtkPolyData* surface, sb::Executor& executor);

} // namespace sbvtk

#endif
