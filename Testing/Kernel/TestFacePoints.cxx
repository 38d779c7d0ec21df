// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFacePoints.cxx
 * @brief A body closed by point ids gets its points back as the body had them: apart between faces,
 * at the seam of a cylinder and at the poles of a sphere, with the same u and v.
 */
#include "Check.h"
#include "CloudBoolean.h"
#include "Clouds.h"
#include "Designed.h"
#include "DesignedShapes.h"
#include "FacePoints.h"
#include "Patches.h"
#include "ThreadExecutor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace
{

/** All triangles of a tool, as the only operand that is left. */
sb::CombinedMesh WholeOf(const sb::ToolSurface& tool)
{
  sb::CombinedMesh mesh;
  mesh.Points = tool.Body().Points;
  mesh.OriginalPoint.assign(mesh.Points.size() / 3, 0);
  mesh.PointSource.assign(mesh.OriginalPoint.size(), 1);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(tool.Body().Triangles.size() / 3); ++t)
  {
    const std::array<std::int32_t, 3> corners = tool.Corners(t);
    mesh.Triangles.insert(mesh.Triangles.end(), corners.begin(), corners.end());
    mesh.Source.push_back(1);
    mesh.Parent.push_back(t);
    mesh.Reversed.push_back(0);
    mesh.Confidence.push_back(1.0);
  }
  return mesh;
}

std::array<double, 2> ParametersAt(const sb::DesignedSurface& body, std::size_t corner)
{
  const std::size_t id = static_cast<std::size_t>(body.Triangles[corner]);
  return { body.UV[2 * id], body.UV[2 * id + 1] };
}

void PointsComeApartAsTheBodyHadThem(const sb::DesignedSurface& body)
{
  sb::ThreadExecutor executor(2);
  const sb::ToolSurface tool(body, executor);
  const sb::CombinedMesh mesh = WholeOf(tool);
  const sb::FacePoints found = sb::FindFacePoints(mesh, tool);
  std::set<std::pair<std::int32_t, std::array<double, 2>>> places;
  std::set<std::int32_t> points;
  bool same = true;
  for (std::size_t corner = 0; corner < body.Triangles.size(); ++corner)
  {
    const std::array<double, 2> wanted = ParametersAt(body, corner);
    const std::size_t point = static_cast<std::size_t>(found.Triangles[corner]);
    same = same && found.UV[point] == wanted && found.IsExact[point];
    places.insert({ body.FaceId[corner / 3], wanted });
    points.insert(found.Triangles[corner]);
  }
  CHECK(same);
  CHECK_EQUAL(points.size(), places.size());
  CHECK(!found.Repeated.empty());
}

/** A ball's cloud, and a body whose patch meets itself where the two surfaces cross. */
void ResultsAreOnTheirPatches(const sb::DesignedSurface& body)
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(6000));
  sb::ThreadExecutor executor(2);
  sb::Monitor monitor;
  for (int operation = 0; operation < 4; ++operation)
  {
    sb::CloudBooleanRequest request;
    request.Cloud = &cloud;
    request.Tool = &body;
    request.Op = static_cast<sb::CloudOperation>(operation);
    const sb::CloudBooleanResult result = sb::ComputeCloudBoolean(request, executor, monitor);
    CHECK(result.Status == sb::CloudBooleanStatus::Ok);
    CHECK_EQUAL(result.NumberOfFlipped, 0);
    CHECK_EQUAL(result.NumberOfBackedOff, 0);
    double widest = 0.0;
    double farthest = 0.0;
    for (std::size_t corner = 0; corner < result.Mesh.Triangles.size(); ++corner)
    {
      if (result.FaceId[corner / 3] < 0)
      {
        continue;
      }
      const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
      const double* const a =
        &result.UV[2 * static_cast<std::size_t>(result.Mesh.Triangles[corner])];
      const double* const b = &result.UV[2 * static_cast<std::size_t>(result.Mesh.Triangles[next])];
      widest = std::max(widest, std::abs(a[0] - b[0]));
      const sb::Real3 there = sb::EvaluatePatch(
        body.Patches[static_cast<std::size_t>(result.FaceId[corner / 3])], a[0], a[1], 0)
                                .Point;
      farthest = std::max(farthest,
        sb::Length(sb::Difference(there, result.Mesh.Point(result.Mesh.Triangles[corner]))));
    }
    CHECK(widest < 0.2); // of the domain: no triangle lies across it
    CHECK(farthest < 1e-9);
  }
}

} // namespace

int main()
{
  sb::DesignedSurface ball;
  designed::AddPatch(ball, patches::Moved(patches::Sphere(0.6), { -0.8, 0.1, 0.05 }), 48, 24);
  PointsComeApartAsTheBodyHadThem(ball);
  ResultsAreOnTheirPatches(ball);
  sb::DesignedSurface ring;
  designed::AddPatch(ring, patches::Moved(patches::Torus(0.6, 0.25), { -0.5, 0.12, 0.6 }), 48, 24);
  PointsComeApartAsTheBodyHadThem(ring);
  ResultsAreOnTheirPatches(ring);
  // Points on its seams are in the way of the cut.
  sb::DesignedSurface fine;
  designed::AddPatch(
    fine, patches::Moved(patches::Torus(0.6, 0.25), { -0.280851, 0.576002, 0.764362 }), 160, 80);
  ResultsAreOnTheirPatches(fine);
  return check::Verdict("TestFacePoints");
}
