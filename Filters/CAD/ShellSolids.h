// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShellSolids.h
 * @brief Closed shells as solids: one that is inside out bounds a void of the solid around it.
 */
#ifndef ShellSolids_h
#define ShellSolids_h

#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <vector>

namespace sbvtk
{

std::vector<TopoDS_Solid> MakeSolids(const std::vector<TopoDS_Shell>& shells);

} // namespace sbvtk

#endif
