// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchTurning.h
 * @brief The same patch with u and v exchanged, which turns its normal Du x Dv round and changes no
 * number.
 */
#ifndef sb_PatchTurning_h
#define sb_PatchTurning_h

#include "NURBSSurface.h"

#include <algorithm>
#include <cstddef>

namespace sb
{

inline NURBSSurface Turned(const NURBSSurface& patch)
{
  NURBSSurface turned;
  turned.DegreeU = patch.DegreeV;
  turned.DegreeV = patch.DegreeU;
  turned.CountU = patch.CountV;
  turned.CountV = patch.CountU;
  turned.KnotsU = patch.KnotsV;
  turned.KnotsV = patch.KnotsU;
  turned.Poles.resize(patch.Poles.size());
  const std::size_t countU = static_cast<std::size_t>(patch.CountU);
  const std::size_t countV = static_cast<std::size_t>(patch.CountV);
  for (std::size_t i = 0; i < countU; ++i)
  {
    for (std::size_t j = 0; j < countV; ++j)
    {
      std::copy_n(
        patch.Poles.data() + 4 * (i * countV + j), 4, turned.Poles.data() + 4 * (j * countU + i));
    }
  }
  return turned;
}

} // namespace sb

#endif
