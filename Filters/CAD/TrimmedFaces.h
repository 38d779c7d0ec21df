// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TrimmedFaces.h
 * @brief Patches, each trimmed to where facets are left of it, as a shape of Open CASCADE.
 *
 * The boundary of a face's facets becomes its trimming curves: cubic splines through the corners,
 * which lie on the true edge, so that the curve is much closer to it than the facets are. Faces
 * that meet share the edge. What is closed becomes a solid. A sphere with holes becomes two faces
 * (HalvedFaces.h).
 */
#ifndef TrimmedFaces_h
#define TrimmedFaces_h

#include "DesignedSurface.h"

#include <TopoDS_Shape.hxx>

#include <cstdint>

namespace sbvtk
{

struct TrimmedFaces
{
  TopoDS_Shape Shape; ///< null if there are no faces
  std::int64_t NumberOfFaces = 0;
  std::int64_t NumberOfSolids = 0;
  std::int64_t NumberOfOpenShells = 0;
  /** Patches that are left out, as their facets do not fit together in the parameters. */
  std::int64_t NumberOfUnfitPatches = 0;
};

/** To be called in a session (CADSession.h). Facets whose FaceId is negative are left out. */
TrimmedFaces MakeTrimmedFaces(const sb::DesignedSurface& surface);

} // namespace sbvtk

#endif
