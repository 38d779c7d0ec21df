// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NURBSArrays.h
 * @brief How exact surfaces travel with the facets that stand for them.
 *
 * As plain arrays of a vtkPolyData, so that every filter, file format and connection that passes
 * arrays on passes them on:
 * - cell data `FaceId`: which patch a facet is of (-1: of none);
 * - point data `UV`: the point's parameters in the patch of its facets;
 * - field data `NURBSDegrees` and `NURBSCounts`, a tuple a patch: degrees and numbers of poles
 * along u and v; `NURBSKnots`: patch after patch, first the knots along u, then those along v;
 *   `NURBSPoles`, a tuple a pole: x, y, z (not multiplied by the weight) and weight; those of a
 *   patch are next to each other, v runs faster.
 */
#ifndef NURBSArrays_h
#define NURBSArrays_h

#include "NURBSSurface.h"
#include "sbPointSetModule.h" // for the export macro

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace sbvtk
{

constexpr const char* ParametersArray = "UV";
constexpr const char* FaceArray = "FaceId";

/** Add the field data; replaces those of other patches. */
SBPOINTSET_EXPORT void AttachPatches(
  vtkDataObject* data, const std::vector<sb::NURBSSurface>& patches);

/** Whether the data set has any of the field data of patches. */
SBPOINTSET_EXPORT bool HasPatchArrays(vtkDataObject* data);

/**
 * Read the field data.
 * @param[out] patches empty if there are none, or if they cannot be used
 * @return empty, or the end of a sentence that begins with "Input" and says what is wrong with
 * them.
 */
SBPOINTSET_EXPORT std::string ReadPatches(
  vtkDataObject* data, std::vector<sb::NURBSSurface>& patches);

} // namespace sbvtk

#endif
