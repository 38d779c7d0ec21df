// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalvedFaces.h
 * @brief Faces that close around, as a sphere does, divided in two along a line of their patch.
 *
 * Where all of such a patch is left but for holes, Open CASCADE writes a point for the outer border
 * into a STEP file, and reads that as none: the face would come back as its holes. Its halves have
 * borders.
 */
#ifndef HalvedFaces_h
#define HalvedFaces_h

#include "DesignedSurface.h"

#include <cstdint>
#include <vector>

namespace sbvtk
{

struct FaceToHalve
{
  std::int32_t Face = -1;
  bool AtU = true; ///< along a line of constant u, in the middle of the domain; else of v
};

/**
 * The facets are cut along that line, but for sides that another face has, too: there it goes to a
 * corner. The second half is on a copy of the patch, which is the last one.
 */
sb::DesignedSurface HalveFaces(
  const sb::DesignedSurface& surface, const std::vector<FaceToHalve>& faces);

} // namespace sbvtk

#endif
