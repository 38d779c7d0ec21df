// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Designed.h
 * @brief Designed surfaces: meshes as such, and patches with a grid of facets each.
 */
#ifndef Designed_h
#define Designed_h

#include "DesignedSurface.h"
#include "Shapes.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace designed
{

inline sb::DesignedSurface FromMesh(const shapes::Mesh& mesh)
{
  sb::DesignedSurface surface;
  for (const shapes::Point& p : mesh.Points)
  {
    surface.Points.insert(surface.Points.end(), p.begin(), p.end());
  }
  for (const shapes::Corners& t : mesh.Triangles)
  {
    surface.Triangles.insert(surface.Triangles.end(), t.begin(), t.end());
  }
  return surface;
}

inline shapes::Mesh ToMesh(const sb::DesignedSurface& surface)
{
  shapes::Mesh mesh;
  for (std::size_t i = 0; i < surface.Points.size(); i += 3)
  {
    mesh.Points.push_back({ surface.Points[i], surface.Points[i + 1], surface.Points[i + 2] });
  }
  for (std::size_t i = 0; i < surface.Triangles.size(); i += 3)
  {
    mesh.Triangles.push_back(
      { surface.Triangles[i], surface.Triangles[i + 1], surface.Triangles[i + 2] });
  }
  return mesh;
}

inline sb::Real3 PointOf(const sb::DesignedSurface& surface, std::int32_t i)
{
  const double* x = surface.Points.data() + 3 * static_cast<std::size_t>(i);
  return { x[0], x[1], x[2] };
}

/** To a multiple of 2^-40, so that both sides of a seam and of an edge between faces are equal. */
inline double Rounded(double x) { return std::ldexp(std::round(std::ldexp(x, 40)), -40) + 0.0; }

/** Append a patch with a grid of facets whose points are rounded. */
inline void AddPatch(
  sb::DesignedSurface& surface, const sb::NURBSSurface& patch, int acrossU, int acrossV)
{
  const std::int32_t first = static_cast<std::int32_t>(surface.Points.size() / 3);
  const std::int32_t face = static_cast<std::int32_t>(surface.Patches.size());
  for (int i = 0; i <= acrossU; ++i)
  {
    for (int j = 0; j <= acrossV; ++j)
    {
      const double u = patch.FirstU() + (patch.LastU() - patch.FirstU()) * i / acrossU;
      const double v = patch.FirstV() + (patch.LastV() - patch.FirstV()) * j / acrossV;
      for (const double x : sb::EvaluatePatch(patch, u, v, 0).Point)
      {
        surface.Points.push_back(Rounded(x));
      }
      surface.UV.insert(surface.UV.end(), { u, v });
    }
  }
  const auto at = [&](int i, int j) { return first + i * (acrossV + 1) + j; };
  for (int i = 0; i < acrossU; ++i)
  {
    for (int j = 0; j < acrossV; ++j)
    {
      for (const shapes::Corners& t : { shapes::Corners{ at(i, j), at(i + 1, j), at(i + 1, j + 1) },
             shapes::Corners{ at(i, j), at(i + 1, j + 1), at(i, j + 1) } })
      {
        // Cells at a pole have one triangle only.
        if (PointOf(surface, t[0]) != PointOf(surface, t[1]) &&
          PointOf(surface, t[1]) != PointOf(surface, t[2]) &&
          PointOf(surface, t[2]) != PointOf(surface, t[0]))
        {
          surface.Triangles.insert(surface.Triangles.end(), t.begin(), t.end());
          surface.FaceId.push_back(face);
        }
      }
    }
  }
  surface.Patches.push_back(patch);
}

} // namespace designed

#endif
