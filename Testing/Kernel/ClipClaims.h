// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClipClaims.h
 * @brief Clips as one mesh, to make claims about.
 */
#ifndef sb_ClipClaims_h
#define sb_ClipClaims_h

#include "Check.h"
#include "Clip.h"
#include "Shapes.h"

#include <vector>

namespace claims
{

using namespace shapes;
using sb::ClipPlane;
using sb::ClipRequest;
using sb::ClipResult;

/** The result as one mesh, by its own point ids. */
inline Mesh Assemble(const Mesh& input, const ClipResult& result)
{
  Mesh mesh;
  for (const std::int32_t point : result.KeptPoints)
  {
    mesh.Points.push_back(input.Points[std::size_t(point)]);
  }
  for (const sb::InterpolatedPoint& point : result.Created)
  {
    mesh.Points.push_back(point.Position);
  }
  for (std::size_t i = 0; i < input.Triangles.size(); ++i)
  {
    if (result.Fates[i] == sb::Fate::Kept)
    {
      Corners triangle;
      for (std::size_t k = 0; k < 3; ++k)
      {
        triangle[k] = result.PointMap[std::size_t(input.Triangles[i][k])];
      }
      mesh.Triangles.push_back(triangle);
    }
  }
  mesh.Triangles.insert(mesh.Triangles.end(), result.Pieces.begin(), result.Pieces.end());
  mesh.Triangles.insert(mesh.Triangles.end(), result.Caps.begin(), result.Caps.end());
  return mesh;
}

/** What is left in front of all planes or, with `insideOut`, what is not. */
inline Mesh Clip(const Mesh& mesh, const std::vector<ClipPlane>& planes, bool insideOut = false)
{
  ClipRequest request;
  request.Mesh = mesh.View();
  request.Planes = planes;
  request.InsideOut = insideOut;
  sb::SerialExecutor executor;
  sb::Monitor monitor;
  const ClipResult result = sb::ClipSurface(request, executor, monitor);
  CHECK_EQUAL(static_cast<int>(result.Condition), 0);
  return Assemble(mesh, result);
}

} // namespace claims

#endif
