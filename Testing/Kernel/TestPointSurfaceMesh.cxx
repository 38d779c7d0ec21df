// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPointSurfaceMesh.cxx
 * @brief The mesh of a closed cloud is a closed manifold of the right genus, with vertices on the
 * surface and volumes that converge; an open cloud's mesh is open and ends where the points end;
 * the order of the points and the number of threads do not matter.
 */
#include "Check.h"
#include "Clouds.h"
#include "PointSurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

sb::PointSurfaceMesh MeshOf(const sb::CloudSurface& made, double cell = 0.0, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  return sb::MeshPointSurface(
    *made.Surface, cell > 0.0 ? cell : 2.0 * made.Spacing, executor, monitor);
}

std::int64_t NumberOfPoints(const sb::PointSurfaceMesh& mesh)
{
  return static_cast<std::int64_t>(mesh.Points.size() / 3);
}

std::int64_t NumberOfTriangles(const sb::PointSurfaceMesh& mesh)
{
  return static_cast<std::int64_t>(mesh.Triangles.size() / 3);
}

sb::Real3 PointOf(const sb::PointSurfaceMesh& mesh, std::int32_t i)
{
  const double* const p = mesh.Points.data() + 3 * std::int64_t(i);
  return { p[0], p[1], p[2] };
}

/** No directed edge twice; returns how many have no opposite. */
std::int64_t OpenEdges(const sb::PointSurfaceMesh& mesh)
{
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    CHECK(edges.insert({ mesh.Triangles[i], mesh.Triangles[next] }).second);
  }
  std::int64_t open = 0;
  for (const auto& edge : edges)
  {
    open += edges.count({ edge.second, edge.first }) == 0 ? 1 : 0;
  }
  return open;
}

double Volume(const sb::PointSurfaceMesh& mesh)
{
  double volume = 0.0;
  for (std::size_t i = 0; i < mesh.Triangles.size(); i += 3)
  {
    const sb::Real3 a = PointOf(mesh, mesh.Triangles[i]);
    volume +=
      sb::Dot(
        a, sb::Cross(PointOf(mesh, mesh.Triangles[i + 1]), PointOf(mesh, mesh.Triangles[i + 2]))) /
      6.0;
  }
  return volume;
}

void SpheresAreClosedAndTheirVolumeConverges()
{
  double last = 0.0;
  for (const int count : { 2000, 8000, 32000 })
  {
    const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(count));
    const sb::PointSurfaceMesh mesh = MeshOf(made);
    CHECK_EQUAL(mesh.NumberOfBorderEdges, 0);
    CHECK_EQUAL(OpenEdges(mesh), 0);
    CHECK_EQUAL(NumberOfPoints(mesh) - NumberOfTriangles(mesh) / 2, 2); // Euler number
    sb::MovingLeastSquares::Neighbourhood near;
    for (std::int32_t i = 0; i < NumberOfPoints(mesh); ++i)
    {
      CHECK(std::abs(sb::Length(PointOf(mesh, i)) - 1.0) < 1e-3 * made.Spacing);
      CHECK(
        std::abs(made.Surface->EvaluateAt(PointOf(mesh, i), 0, near).Value) < 1e-7 * made.Spacing);
    }
    const double error = 4.0 / 3.0 * clouds::Pi - Volume(mesh);
    CHECK(error > 0.0); // chords lie inside
    if (last > 0.0)
    {
      CHECK(std::abs(std::log2(last / error) - 2.0) < 0.15); // second order in the spacing
    }
    last = error;
  }
}

void ANoisyTorusIsATorus()
{
  std::mt19937 random(1);
  clouds::Cloud cloud = clouds::Torus(30000, random);
  clouds::AddNoise(cloud, 0.2 * 0.023, random);
  for (const sb::SurfaceDefinition definition :
    { sb::SurfaceDefinition::Unbiased, sb::SurfaceDefinition::AmentaKil })
  {
    const sb::CloudSurface made = clouds::SurfaceOf(cloud, true, definition);
    const sb::PointSurfaceMesh mesh = MeshOf(made);
    CHECK_EQUAL(OpenEdges(mesh), 0);
    CHECK_EQUAL(NumberOfPoints(mesh) - NumberOfTriangles(mesh) / 2, 0);
    double sum = 0.0;
    double squares = 0.0;
    const double tolerance = definition == sb::SurfaceDefinition::Unbiased ? 1e-7 : 1e-5;
    sb::MovingLeastSquares::Neighbourhood near;
    for (std::int32_t i = 0; i < NumberOfPoints(mesh); ++i)
    {
      const double residual = made.Surface->EvaluateAt(PointOf(mesh, i), 0, near).Value;
      CHECK(std::abs(residual) < tolerance * made.Spacing);
      const double distance = clouds::DistanceToTorus(PointOf(mesh, i));
      sum += distance;
      squares += distance * distance;
    }
    const double number = static_cast<double>(NumberOfPoints(mesh));
    if (definition == sb::SurfaceDefinition::Unbiased)
    {
      CHECK(std::sqrt(squares / number) < 0.05 * made.Spacing);
      CHECK(std::abs(sum / number) < 0.01 * made.Spacing);
    }
    else
    {
      CHECK(sum / number < -0.1 * made.Spacing); // the paper's lies inside
    }
    for (std::size_t i = 0; i < mesh.Triangles.size(); i += 3)
    {
      const sb::Real3 a = PointOf(mesh, mesh.Triangles[i]);
      const sb::Real3 turn = sb::Cross(sb::Difference(PointOf(mesh, mesh.Triangles[i + 1]), a),
        sb::Difference(PointOf(mesh, mesh.Triangles[i + 2]), a));
      const double* const n = mesh.Normals.data() + 3 * std::int64_t(mesh.Triangles[i]);
      // A sliver's plane may be off, but an area counts only on the right side.
      CHECK(sb::Dot(turn, { n[0], n[1], n[2] }) > -1e-3 * made.Spacing * made.Spacing);
    }
  }
}

void AnOpenCloudGivesAnOpenMesh()
{
  clouds::Cloud plane = clouds::Plane(80);
  // A hole in the middle.
  clouds::Cloud cloud;
  for (std::size_t i = 0; i < plane.Points.size(); i += 3)
  {
    if (std::hypot(plane.Points[i] - 0.5, plane.Points[i + 1] - 0.5) > 0.2)
    {
      cloud.Add({ plane.Points[i], plane.Points[i + 1], 0.0 }, { 0, 0, 1 });
    }
  }
  const sb::CloudSurface made = clouds::SurfaceOf(cloud);
  const sb::PointSurfaceMesh mesh = MeshOf(made);
  CHECK(mesh.NumberOfBorderEdges > 0);
  CHECK_EQUAL(OpenEdges(mesh), mesh.NumberOfBorderEdges);
  CHECK_EQUAL(NumberOfPoints(mesh) - NumberOfTriangles(mesh) -
      (3 * NumberOfTriangles(mesh) + mesh.NumberOfBorderEdges) / 2 + 2 * NumberOfTriangles(mesh),
    0); // a ring
  for (std::int32_t i = 0; i < NumberOfPoints(mesh); ++i)
  {
    const sb::Real3 p = PointOf(mesh, i);
    CHECK(std::abs(p[2]) < 1e-12);
    CHECK(std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) < 0.5 + 1.5 * made.Spacing);
    CHECK(std::hypot(p[0] - 0.5, p[1] - 0.5) > 0.2 - 1.5 * made.Spacing);
  }
}

void OrderAndThreadsDoNotMatter()
{
  std::mt19937 random(2);
  clouds::Cloud cloud = clouds::Torus(5000, random);
  clouds::AddNoise(cloud, 0.01, random);
  clouds::Cloud reversed;
  for (std::size_t i = cloud.Points.size(); i > 0; i -= 3)
  {
    reversed.Add({ cloud.Points[i - 3], cloud.Points[i - 2], cloud.Points[i - 1] },
      { cloud.Normals[i - 3], cloud.Normals[i - 2], cloud.Normals[i - 1] });
  }
  const sb::PointSurfaceMesh one = MeshOf(clouds::SurfaceOf(cloud), 0.0, 1);
  const sb::PointSurfaceMesh other = MeshOf(clouds::SurfaceOf(reversed), 0.0, 3);
  CHECK(one.Points == other.Points);
  CHECK(one.Normals == other.Normals);
  CHECK(one.Triangles == other.Triangles);
}

void WhatCannotBeDoneIsSaid()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(500));
  CHECK(MeshOf(made, 1e-30).End == sb::PointSurfaceMesh::Ending::TooFine);
  struct Stop : sb::Monitor
  {
    bool Aborted() override { return true; }
  } stop;
  sb::SerialExecutor executor;
  const sb::PointSurfaceMesh none = sb::MeshPointSurface(*made.Surface, 0.1, executor, stop);
  CHECK(none.End == sb::PointSurfaceMesh::Ending::Aborted);
  CHECK(none.Points.empty() && none.Triangles.empty());
}

} // namespace

int main()
{
  SpheresAreClosedAndTheirVolumeConverges();
  ANoisyTorusIsATorus();
  AnOpenCloudGivesAnOpenMesh();
  OrderAndThreadsDoNotMatter();
  WhatCannotBeDoneIsSaid();
  return check::Verdict("TestPointSurfaceMesh");
}
