// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneOnLattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{

namespace
{

double Largest(const std::array<double, 3>& p)
{
  return std::max(std::fabs(p[0]), std::max(std::fabs(p[1]), std::fabs(p[2])));
}

/** The point of a plane that is nearest to `center`, or one at `reach` from it towards the plane.
 */
std::array<double, 3> OriginNear(
  const ClipPlane& plane, const std::array<double, 3>& center, double reach)
{
  const double size = Largest(plane.Normal);
  double normal[3];
  double square = 0.0;
  double height = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    normal[i] = plane.Normal[i] / size;
    square += normal[i] * normal[i];
    height += normal[i] * (plane.Origin[i] - center[i]);
  }
  const double most = reach * std::sqrt(square);
  height = std::max(-most, std::min(most, height));
  std::array<double, 3> origin;
  for (std::size_t i = 0; i < 3; ++i)
  {
    // A coordinate across which the plane does not run is the plane's position: keep its bytes.
    const bool isPosition = std::fabs(normal[i]) == 1.0 && square == 1.0 &&
      std::fabs(plane.Origin[i] - center[i]) <= reach;
    origin[i] = isPosition ? plane.Origin[i] : center[i] + normal[i] * (height / square);
  }
  return origin;
}

} // namespace

bool IsPlane(const ClipPlane& plane)
{
  bool finite = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    finite = finite && std::isfinite(plane.Origin[i]) && std::isfinite(plane.Normal[i]);
  }
  return finite && Largest(plane.Normal) > 0.0;
}

MeshBounds FindBounds(const Surface& mesh, Executor& executor)
{
  constexpr std::int64_t block = 1 << 15;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const MeshBounds nothing{ { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
  const std::int64_t blocks = (mesh.NumberOfPoints + block - 1) / block;
  std::vector<MeshBounds> parts(std::size_t(blocks), nothing);
  executor.For(blocks, 1, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t part = begin; part < end; ++part)
    {
      MeshBounds bounds = nothing;
      const std::int64_t last = std::min(mesh.NumberOfPoints, (part + 1) * block);
      for (const double* p = mesh.Points + 3 * part * block; p < mesh.Points + 3 * last; p += 3)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          // Not finite: left out by either comparison, or by the magnitude.
          const double x =
            std::fabs(p[axis]) <= std::numeric_limits<double>::max() ? p[axis] : bounds.Low[axis];
          bounds.Low[axis] = x < bounds.Low[axis] ? x : bounds.Low[axis];
          bounds.High[axis] = x > bounds.High[axis] && x < infinity ? x : bounds.High[axis];
        }
      }
      parts[std::size_t(part)] = bounds;
    }
  });
  MeshBounds all = nothing;
  for (const MeshBounds& part : parts)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      all.Low[axis] = std::min(all.Low[axis], part.Low[axis]);
      all.High[axis] = std::max(all.High[axis], part.High[axis]);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (!(all.Low[axis] <= all.High[axis]))
    {
      all.Low[axis] = all.High[axis] = 0.0;
    }
  }
  return all;
}

Lattice PlaceOnLattice(const MeshBounds& bounds, std::vector<ClipPlane>& planes)
{
  const double magnitude = std::max(Largest(bounds.Low), Largest(bounds.High));
  std::array<double, 3> center;
  double reach = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    center[i] = bounds.Low[i] / 2.0 + bounds.High[i] / 2.0;
    reach += bounds.High[i] - bounds.Low[i];
  }
  reach = reach > 0.0 ? reach : 1.0;
  double largest = magnitude;
  for (ClipPlane& plane : planes)
  {
    if (Largest(plane.Origin) > magnitude)
    {
      plane.Origin = OriginNear(plane, center, reach);
      largest = std::max(largest, Largest(plane.Origin));
    }
  }
  return Lattice::ForMagnitude(largest);
}

} // namespace sb
