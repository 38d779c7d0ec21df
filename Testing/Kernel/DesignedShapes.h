// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DesignedShapes.h
 * @brief Designed surfaces made of patches: whole ones, trimmed ones, a box.
 */
#ifndef DesignedShapes_h
#define DesignedShapes_h

#include "DesignedSurface.h"
#include "Patches.h"

#include <functional>

namespace patches
{

/** Move, turn or scale the poles of a patch. */
inline sb::NURBSSurface Mapped(
  sb::NURBSSurface surface, const std::function<sb::Real3(const sb::Real3&)>& map)
{
  for (std::size_t i = 0; i < surface.Poles.size(); i += 4)
  {
    const sb::Real3 x = map({ surface.Poles[i], surface.Poles[i + 1], surface.Poles[i + 2] });
    std::copy(x.begin(), x.end(), surface.Poles.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return surface;
}

inline sb::NURBSSurface Moved(const sb::NURBSSurface& surface, const sb::Real3& by)
{
  return Mapped(surface, [&](const sb::Real3& x) { return sb::PlusScaled(x, 1.0, by); });
}

/** Which places of a patch are used; the corners of facets that are not become holes. */
using Mask = std::function<bool(double, double)>;

/**
 * Add a patch as a face with a grid of facets. Corners on closed borders have bitwise equal places
 * (the first of both), as a reader delivers them.
 * @param keep whether a facet with this middle is used
 */
inline void AddFace(
  sb::DesignedSurface& designed, const sb::NURBSSurface& patch, int across, int up,
  const Mask& keep = [](double, double) { return true; }, bool turned = false)
{
  const std::int32_t first = static_cast<std::int32_t>(designed.Points.size() / 3);
  const std::int32_t face = static_cast<std::int32_t>(designed.Patches.size());
  designed.Patches.push_back(patch);
  const auto snap = [](double x) { return std::round(x * 1e12) / 1e12 + 0.0; };
  for (int j = 0; j <= up; ++j)
  {
    for (int i = 0; i <= across; ++i)
    {
      const double u = patch.FirstU() + (patch.LastU() - patch.FirstU()) * i / across;
      const double v = patch.FirstV() + (patch.LastV() - patch.FirstV()) * j / up;
      const sb::Real3 x = sb::EvaluatePatch(patch, u, v, 0).Point;
      designed.Points.insert(designed.Points.end(), { snap(x[0]), snap(x[1]), snap(x[2]) });
      designed.UV.insert(designed.UV.end(), { u, v });
    }
  }
  for (int j = 0; j < up; ++j)
  {
    for (int i = 0; i < across; ++i)
    {
      if (!keep((i + 0.5) / across, (j + 0.5) / up))
      {
        continue;
      }
      const std::int32_t a = first + j * (across + 1) + i;
      const std::int32_t b = a + 1;
      const std::int32_t c = b + across + 1;
      const std::int32_t d = a + across + 1;
      const std::int32_t front[6] = { a, b, c, a, c, d };
      const std::int32_t back[6] = { a, c, b, a, d, c };
      designed.Triangles.insert(
        designed.Triangles.end(), turned ? back : front, (turned ? back : front) + 6);
      designed.FaceId.insert(designed.FaceId.end(), { face, face });
    }
  }
}

inline sb::DesignedSurface OneFace(const sb::NURBSSurface& patch, int across = 8, int up = 8)
{
  sb::DesignedSurface designed;
  AddFace(designed, patch, across, up);
  return designed;
}

} // namespace patches

#endif
