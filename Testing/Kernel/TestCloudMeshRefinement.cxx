// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCloudMeshRefinement.cxx
 * @brief The mesh of a cloud near a tool: still closed, on the sphere to the last digits, with
 * chords less than a fifth as high, and as it was elsewhere; where the tool lies along all of a
 * cloud that is large, nothing is done; threads do not matter.
 */
#include "Check.h"
#include "CloudMeshRefinement.h"
#include "Clouds.h"
#include "Designed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace
{

sb::PointSurfaceMesh MeshOf(const sb::CloudSurface& cloud, double cell)
{
  sb::ThreadExecutor executor(2);
  sb::Monitor monitor;
  return sb::MeshPointSurface(*cloud.Surface, cell, executor, monitor);
}

sb::PointSurfaceMesh Refined(const sb::CloudSurface& cloud, const sb::PointSurfaceMesh& mesh,
  const sb::DesignedSurface& body, double cell, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  const sb::ToolSurface tool(body, executor);
  sb::PointSurfaceMesh refined = mesh;
  sb::RefineNearTool(refined, *cloud.Surface, tool, cell, executor, monitor);
  return refined;
}

sb::Real3 Point(const sb::PointSurfaceMesh& mesh, std::int32_t id)
{
  const double* const p = mesh.Points.data() + 3 * static_cast<std::size_t>(id);
  return { p[0], p[1], p[2] };
}

std::int64_t OpenEdges(const sb::PointSurfaceMesh& mesh)
{
  std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
  for (std::size_t t = 0; t < mesh.Triangles.size(); t += 3)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t a = mesh.Triangles[t + k];
      const std::int32_t b = mesh.Triangles[t + (k + 1) % 3];
      ++uses[{ a, b }];
      --uses[{ b, a }];
    }
  }
  return std::count_if(uses.begin(), uses.end(), [](const auto& edge) { return edge.second != 0; });
}

/** How far the middles of triangles with a corner that close to x = 0.3 are below the sphere. */
double DeepestChord(const sb::PointSurfaceMesh& mesh, double close)
{
  double deepest = 0.0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); t += 3)
  {
    sb::Real3 middle{};
    bool near = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const sb::Real3 corner = Point(mesh, mesh.Triangles[t + k]);
      middle = sb::PlusScaled(middle, 1.0 / 3.0, corner);
      near = near || std::abs(corner[0] - 0.3) < close;
    }
    deepest = near ? std::max(deepest, 1.0 - sb::Length(middle)) : deepest;
  }
  return deepest;
}

void TrianglesNearTheToolAreSmall()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(6000));
  const double cell = sb::CellSizeFor(*cloud.Surface, cloud.Spacing);
  const sb::PointSurfaceMesh coarse = MeshOf(cloud, cell);
  const sb::DesignedSurface box = designed::FromMesh(shapes::Box({ 0.3, -2, -2 }, { 2, 2, 2 }));
  const sb::PointSurfaceMesh fine = Refined(cloud, coarse, box, cell);
  CHECK_EQUAL(OpenEdges(fine), 0);
  CHECK(fine.Triangles.size() > coarse.Triangles.size() + 3000);
  CHECK(fine.Points.size() == fine.Normals.size());
  // Points of the mesh before keep their numbers and places.
  CHECK(std::equal(coarse.Points.begin(), coarse.Points.end(), fine.Points.begin()));
  for (std::size_t i = 0; i < fine.Points.size() / 3; ++i)
  {
    const sb::Real3 x = Point(fine, static_cast<std::int32_t>(i));
    const double* const n = fine.Normals.data() + 3 * i;
    CHECK(std::abs(sb::Length(x) - 1.0) < 1e-6);
    CHECK(sb::Dot(x, { n[0], n[1], n[2] }) > 0.999);
    CHECK(3 * i < coarse.Points.size() || std::abs(x[0] - 0.3) < 2.0 * cell);
  }
  CHECK(DeepestChord(fine, 0.1 * cell) < 0.2 * DeepestChord(coarse, 0.1 * cell));
  for (std::size_t t = 0; t < fine.Triangles.size(); t += 3)
  {
    const sb::Real3 a = Point(fine, fine.Triangles[t]);
    const sb::Real3 turn = sb::Cross(sb::Difference(Point(fine, fine.Triangles[t + 1]), a),
      sb::Difference(Point(fine, fine.Triangles[t + 2]), a));
    CHECK(sb::Dot(turn, a) > 0.0);
  }
  const sb::PointSurfaceMesh serial = Refined(cloud, coarse, box, cell, 1);
  CHECK(serial.Points == fine.Points && serial.Triangles == fine.Triangles);
}

void NothingIsDoneAwayFromTheTool()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(2000));
  const double cell = sb::CellSizeFor(*cloud.Surface, cloud.Spacing);
  const sb::PointSurfaceMesh coarse = MeshOf(cloud, cell);
  const sb::PointSurfaceMesh same =
    Refined(cloud, coarse, designed::FromMesh(shapes::Box({ 1.5, -2, -2 }, { 2, 2, 2 })), cell);
  CHECK(same.Points == coarse.Points && same.Triangles == coarse.Triangles);
}

/** A tool that lies along all of the cloud. */
void ALargeMeshDoesNotGrowManyTimes()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(2000));
  const double cell = 0.2 * cloud.Spacing;
  const sb::PointSurfaceMesh mesh = MeshOf(cloud, cell);
  CHECK(mesh.Triangles.size() > 3 * 100000);
  sb::DesignedSurface tool;
  tool.Points = mesh.Points;
  tool.Triangles = mesh.Triangles;
  CHECK(Refined(cloud, mesh, tool, cell).Triangles.size() <= 2 * mesh.Triangles.size());
}

} // namespace

int main()
{
  TrianglesNearTheToolAreSmall();
  NothingIsDoneAwayFromTheTool();
  ALargeMeshDoesNotGrowManyTimes();
  return check::Verdict("TestCloudMeshRefinement");
}
