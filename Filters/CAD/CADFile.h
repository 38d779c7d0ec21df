// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CADFile.h
 * @brief STEP and IGES files as shapes of Open CASCADE, in millimetres.
 *
 * To be called in a session (CADSession.h).
 */
#ifndef CADFile_h
#define CADFile_h

#include "PartNames.h"

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>

#include <string>

namespace sbvtk
{

/**
 * All that the file shows, assemblies with their parts in place. Faces that the file does not join
 * are sewn, as far as they meet.
 * @param[out] shape null if the file has none
 * @param[out] parts of a STEP file; nothing of faces that had to be sewn
 * @return empty, or the end of the sentence "The file ..." that says why it cannot be read.
 */
std::string ReadCADFile(const std::string& name, TopoDS_Shape& shape, PartNames& parts,
  const Message_ProgressRange& progress);

/** Write a STEP file. @return as above. */
std::string WriteSTEPFile(
  const std::string& name, const TopoDS_Shape& shape, const Message_ProgressRange& progress);

} // namespace sbvtk

#endif
