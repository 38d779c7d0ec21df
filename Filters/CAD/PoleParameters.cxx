// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PoleParameters.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sbvtk
{
namespace
{

constexpr int None = -1;

/** 0 or 1 if the patch stays in one place along the border of the domain where u or v runs; only
 * borders can be poles. */
int FreeParameter(const sb::NURBSSurface& patch, const double* uv, double size)
{
  const double first[2] = { patch.FirstU(), patch.FirstV() };
  const double last[2] = { patch.LastU(), patch.LastV() };
  for (int across = 0; across < 2; ++across)
  {
    const int along = 1 - across;
    const double width = last[across] - first[across];
    const bool onBorder =
      uv[across] <= first[across] + 1e-9 * width || uv[across] >= last[across] - 1e-9 * width;
    if (onBorder)
    {
      const sb::PatchPoint at = sb::EvaluatePatch(patch, uv[0], uv[1], 1);
      const double speed = sb::Length(along == 0 ? at.Du : at.Dv);
      if (speed * (last[along] - first[along]) < 1e-9 * size)
      {
        return along;
      }
    }
  }
  return None;
}

} // namespace

void SetPoleParameters(sb::DesignedSurface& surface, double size)
{
  const std::size_t count = surface.Points.size() / 3;
  std::vector<std::int8_t> isUsed(count, 0);
  for (std::size_t i = 0; i < surface.FaceId.size(); ++i)
  {
    const sb::NURBSSurface& patch = surface.Patches[static_cast<std::size_t>(surface.FaceId[i])];
    std::array<int, 3> free{ None, None, None };
    int numberOfPoles = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      free[k] = FreeParameter(patch,
        surface.UV.data() + 2 * static_cast<std::size_t>(surface.Triangles[3 * i + k]), size);
      numberOfPoles += free[k] == None ? 0 : 1;
    }
    for (std::size_t k = 0; k < 3 && numberOfPoles == 1; ++k)
    {
      if (free[k] == None)
      {
        continue;
      }
      const auto parameter = [&](std::size_t corner) -> double& {
        return surface.UV[2 * static_cast<std::size_t>(surface.Triangles[3 * i + corner % 3]) +
          static_cast<std::size_t>(free[k])];
      };
      const double middle = 0.5 * (parameter(k + 1) + parameter(k + 2));
      std::int32_t& point = surface.Triangles[3 * i + k];
      if (isUsed[static_cast<std::size_t>(point)])
      {
        const std::size_t old = static_cast<std::size_t>(point);
        point = static_cast<std::int32_t>(surface.Points.size() / 3);
        for (std::size_t c = 0; c < 3; ++c)
        {
          surface.Points.push_back(double{ surface.Points[3 * old + c] });
        }
        surface.UV.push_back(double{ surface.UV[2 * old] });
        surface.UV.push_back(double{ surface.UV[2 * old + 1] });
        isUsed.push_back(0);
      }
      isUsed[static_cast<std::size_t>(point)] = 1;
      parameter(k) = middle;
    }
  }
}

} // namespace sbvtk
