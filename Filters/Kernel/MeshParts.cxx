// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshParts.h"

#include "DisjointSets.h"

#include <algorithm>
#include <cstddef>

namespace sb
{

MeshParts FindParts(const std::vector<double>& points, const std::vector<std::int32_t>& triangles)
{
  DisjointSets sets(static_cast<std::int32_t>(points.size() / 3));
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    sets.Unite(triangles[corner], triangles[corner + 1]);
    sets.Unite(triangles[corner], triangles[corner + 2]);
  }
  const auto place = [&points](std::int32_t i) {
    const double* const p = points.data() + 3 * static_cast<std::size_t>(i);
    return Real3{ p[0], p[1], p[2] };
  };
  MeshParts found;
  found.PartOfTriangle.resize(triangles.size() / 3);
  std::vector<std::int32_t> partOfSet(points.size() / 3, -1);
  for (std::size_t t = 0; t < found.PartOfTriangle.size(); ++t)
  {
    const Real3 corners[3] = { place(triangles[3 * t]), place(triangles[3 * t + 1]),
      place(triangles[3 * t + 2]) };
    std::int32_t& part = partOfSet[static_cast<std::size_t>(sets.Find(triangles[3 * t]))];
    if (part < 0)
    {
      part = static_cast<std::int32_t>(found.Parts.size());
      found.Parts.push_back({ corners[0], corners[0], 0.0, triangles[3 * t] });
    }
    found.PartOfTriangle[t] = part;
    MeshPart& of = found.Parts[static_cast<std::size_t>(part)];
    for (const Real3& corner : corners)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        of.Lower[axis] = std::min(of.Lower[axis], corner[axis]);
        of.Upper[axis] = std::max(of.Upper[axis], corner[axis]);
      }
    }
    // Relative to a point of the part, so that far coordinates cost no digits.
    const Real3 apex = place(of.FirstPoint);
    of.Volume += Dot(Difference(corners[0], apex),
                   Cross(Difference(corners[1], apex), Difference(corners[2], apex))) /
      6.0;
  }
  return found;
}

} // namespace sb
