// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSeamSnap.cxx
 * @brief A ball's cloud with a box: the result is closed, its seam lies on the sphere and on the
 * box, nothing is turned over, threads do not matter; collapses keep the topology; samples are
 * sorted as the box says; the winding number of a cloud's oriented points is near a whole number.
 */
#include "Check.h"
#include "CloudBoolean.h"
#include "Clouds.h"
#include "MeshEdit.h"
#include "OrientedPointWinding.h"
#include "SampleSides.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace
{

/** Each face with points of its own, as designed bodies have them. */
sb::DesignedSurface Box(const sb::Real3& lower, const sb::Real3& upper)
{
  sb::DesignedSurface box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const std::int32_t first = static_cast<std::int32_t>(box.Points.size() / 3);
      for (int corner = 0; corner < 4; ++corner)
      {
        sb::Real3 p;
        p[axis] = side ? upper[axis] : lower[axis];
        const std::size_t b = (axis + 1) % 3;
        const std::size_t c = (axis + 2) % 3;
        p[b] = (corner == 1 || corner == 2) ? upper[b] : lower[b];
        p[c] = corner >= 2 ? upper[c] : lower[c];
        box.Points.insert(box.Points.end(), p.begin(), p.end());
      }
      const std::int32_t out[6] = { 0, 1, 2, 0, 2, 3 };
      const std::int32_t in[6] = { 0, 2, 1, 0, 3, 2 };
      for (int k = 0; k < 6; ++k)
      {
        box.Triangles.push_back(first + (side ? out[k] : in[k]));
      }
    }
  }
  return box;
}

sb::CloudBooleanResult Combine(const sb::CloudSurface& cloud, const sb::DesignedSurface& tool,
  sb::CloudOperation operation, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  sb::CloudBooleanRequest request;
  request.Cloud = &cloud;
  request.Tool = &tool;
  request.Op = operation;
  return sb::ComputeCloudBoolean(request, executor, monitor);
}

std::int64_t OpenEdges(const sb::CombinedMesh& mesh)
{
  std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
  for (std::int32_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const std::int32_t* const ids = mesh.Corners(t);
    for (int k = 0; k < 3; ++k)
    {
      ++uses[{ ids[k], ids[(k + 1) % 3] }];
      --uses[{ ids[(k + 1) % 3], ids[k] }];
    }
  }
  std::int64_t open = 0;
  for (const auto& edge : uses)
  {
    open += edge.second != 0 ? 1 : 0;
  }
  return open;
}

void TheSeamLiesOnBoth()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(6000));
  const sb::DesignedSurface box = Box({ 0.3, -2, -2 }, { 2, 2, 2 });
  const double cap = clouds::Pi * 0.49 * 2.3 / 3.0;
  const double ball = 4.0 / 3.0 * clouds::Pi;
  const double expected[] = { ball + 27.2 - cap, cap, ball - cap, 27.2 - cap };
  for (int operation = 0; operation < 4; ++operation)
  {
    const sb::CloudBooleanResult one =
      Combine(cloud, box, static_cast<sb::CloudOperation>(operation));
    CHECK(one.Status == sb::CloudBooleanStatus::Ok);
    CHECK_EQUAL(OpenEdges(one.Mesh), 0);
    CHECK_EQUAL(one.NumberOfBorderEdges, 0);
    CHECK_EQUAL(one.NumberOfFlipped, 0);
    CHECK_EQUAL(one.NumberOfCrossings, 0);
    CHECK_EQUAL(one.NumberOfBackedOff, 0);
    CHECK(one.NumberOfSnapped > 100);
    CHECK(std::abs(one.Volume - expected[operation]) < one.Errors.Sum() * 4.0 * clouds::Pi);
    CHECK_EQUAL(one.Seam.Curves.size(), std::size_t(1));
    CHECK(one.Seam.Curves[0].Closed);
    for (const sb::Real3& place : one.Seam.Points)
    {
      CHECK(std::abs(place[0] - 0.3) < 1e-13);
      CHECK(std::abs(sb::Length(place) - 1.0) < 1e-6);
    }
    const sb::CloudBooleanResult other =
      Combine(cloud, box, static_cast<sb::CloudOperation>(operation), 1);
    CHECK(one.Mesh.Points == other.Mesh.Points && one.Mesh.Triangles == other.Mesh.Triangles);
  }
}

void OpenToolsAreRefused()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(1000));
  sb::DesignedSurface box = Box({ 0.3, -2, -2 }, { 2, 2, 2 });
  box.Triangles.resize(33);
  CHECK(Combine(cloud, box, sb::CloudOperation::Union).Status == sb::CloudBooleanStatus::OpenTool);
  box.Triangles[0] = 1000;
  CHECK(Combine(cloud, box, sb::CloudOperation::Union).Status == sb::CloudBooleanStatus::BadTool);
}

/** A point that moves over the diagonal of the square around it. */
void AnEdgeInTheWayIsFlipped()
{
  const auto square = [] {
    sb::CombinedMesh mesh;
    mesh.Points = { 0, -0.1, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0 };
    mesh.Triangles = { 0, 1, 2, 2, 1, 3, 0, 4, 1, 0, 2, 4 };
    mesh.OriginalPoint = { 0, 1, 2, 3, 4 };
    mesh.PointSource.assign(5, 0);
    mesh.Source.assign(4, 0);
    mesh.Parent.assign(4, 0);
    mesh.Reversed.assign(4, 0);
    mesh.Confidence.assign(4, 1.0);
    return mesh;
  };
  const auto upwards = [](std::int32_t) { return sb::MeshEdit::Front{ { 0, 0, 1 }, 0.5 }; };
  const auto any = [](const sb::MeshEdit::EdgeToFlip&) { return true; };
  const auto none = [](const sb::MeshEdit::EdgeToFlip&) { return false; };
  const sb::Real3 place{ 0.0, 0.1, 0.0 };
  const std::vector<std::uint8_t> zone(5, 1);
  sb::CombinedMesh mesh = square();
  sb::MeshEdit edit(mesh, zone, upwards);
  CHECK(!edit.Move(0, place));
  CHECK(!edit.MoveFlipping(0, place, none));
  CHECK(!edit.MoveFlipping(0, { 0.0, 1.1, 0.0 }, any)); // beyond both triangles
  CHECK(mesh.Triangles == square().Triangles && mesh.Points == square().Points);
  CHECK(edit.MoveFlipping(0, place, any));
  CHECK(mesh.Point(0) == place);
  CHECK_EQUAL(edit.TrianglesAt(0).size(), std::size_t(4));
  CHECK_EQUAL(edit.TrianglesAt(1).size(), std::size_t(2));
  CHECK_EQUAL(edit.TrianglesAt(3).size(), std::size_t(2));
  CHECK_EQUAL(OpenEdges(mesh), OpenEdges(square()));
  for (std::int32_t t = 0; t < 4; ++t)
  {
    const std::int32_t* const ids = mesh.Corners(t);
    const sb::Real3 a = mesh.Point(ids[0]);
    CHECK(sb::Cross(
            sb::Difference(mesh.Point(ids[1]), a), sb::Difference(mesh.Point(ids[2]), a))[2] > 0.0);
  }
  sb::CombinedMesh ofTwo = square();
  ofTwo.Source[1] = 1; // the edge is the seam
  sb::MeshEdit seam(ofTwo, zone, upwards);
  CHECK(!seam.MoveFlipping(0, place, any));
}

/** A point that moves behind its neighbour, away from the edge to the one behind that. */
void AnEdgeOfThePointIsFlippedToo()
{
  sb::CombinedMesh mesh;
  mesh.Points = { 0, 0, 0, 1, -0.1, 0, 2, 0, 0, 1, 1, 0 };
  mesh.Triangles = { 0, 1, 2, 0, 2, 3 };
  mesh.OriginalPoint = { 0, 1, 2, 3 };
  mesh.PointSource.assign(4, 0);
  mesh.Source.assign(2, 0);
  mesh.Parent.assign(2, 0);
  mesh.Reversed.assign(2, 0);
  mesh.Confidence.assign(2, 1.0);
  sb::MeshEdit edit(mesh, std::vector<std::uint8_t>(4, 1), [](std::int32_t) {
    return sb::MeshEdit::Front{ { 0, 0, 1 }, 0.5 };
  });
  const sb::Real3 place{ 0.0, -0.3, 0.0 };
  CHECK_EQUAL(edit.InTheWay(0, place).size(), std::size_t(1));
  CHECK(!edit.Move(0, place));
  CHECK(edit.MoveFlipping(0, place,
    [](const sb::MeshEdit::EdgeToFlip& edge) { return edge.Top == 1 && edge.Bottom == 3; }));
  CHECK_EQUAL(edit.TrianglesAt(0).size(), std::size_t(1));
  CHECK_EQUAL(edit.TrianglesAt(1).size(), std::size_t(2));
  for (std::int32_t t = 0; t < 2; ++t)
  {
    const std::int32_t* const ids = mesh.Corners(t);
    const sb::Real3 a = mesh.Point(ids[0]);
    CHECK(sb::Cross(
            sb::Difference(mesh.Point(ids[1]), a), sb::Difference(mesh.Point(ids[2]), a))[2] > 0.0);
  }
}

/** Two pyramids on one square, whose middle edge can be collapsed, and whose rim cannot. */
void CollapsesKeepTheTopology()
{
  const auto octahedron = [] {
    sb::CombinedMesh mesh;
    mesh.Points = { 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1 };
    mesh.Triangles = { 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5 };
    mesh.OriginalPoint = { 0, 1, 2, 3, 4, 5 };
    mesh.PointSource.assign(6, 0);
    mesh.Source.assign(8, 0);
    mesh.Parent.assign(8, 0);
    mesh.Reversed.assign(8, 0);
    mesh.Confidence.assign(8, 1.0);
    return mesh;
  };
  const auto anyFront = [](std::int32_t) { return sb::MeshEdit::Front{ {}, -2.0 }; };
  sb::CombinedMesh mesh = octahedron();
  sb::MeshEdit edit(mesh, std::vector<std::uint8_t>(6, 1), anyFront);
  CHECK(edit.Collapse(0, 1));
  CHECK(edit.IsGone(0) && !edit.IsGone(1));
  // What is left has only triangles around 4 and 5: no edge can go without a fold.
  CHECK(!edit.Collapse(4, 5));
  const std::vector<std::int32_t> number = edit.Finish();
  CHECK_EQUAL(mesh.NumberOfTriangles(), 6);
  CHECK_EQUAL(mesh.NumberOfPoints(), 5);
  CHECK_EQUAL(number[0], number[1]);
  CHECK_EQUAL(OpenEdges(mesh), 0);

  sb::CombinedMesh strict = octahedron();
  sb::MeshEdit guarded(strict, std::vector<std::uint8_t>(6, 1), [&](std::int32_t t) {
    const std::int32_t* const ids = strict.Corners(t);
    const double away = ids[2] == 4 ? 1.0 : -1.0;
    return sb::MeshEdit::Front{ { 0.0, 0.0, away }, 0.1 };
  });
  CHECK(guarded.Move(4, { 0, 0, 0.5 }));
  CHECK(!guarded.Move(4, { 3, 0, 0.5 })); // over the rim
}

void SamplesAreSortedAsTheBoxSays()
{
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Sphere(5000));
  const sb::DesignedSurface box = Box({ 0.3, -0.2, -2 }, { 2, 0.4, 2 });
  sb::ThreadExecutor executor(2);
  sb::Monitor monitor;
  const sb::ToolSurface tool(box, executor);
  const sb::PointTree& samples = cloud.Surface->Samples();
  const std::vector<std::uint8_t> inside = sb::FindInside(samples, tool, executor, monitor);
  for (std::int32_t i = 0; i < samples.Size(); ++i)
  {
    const sb::Real3 p = samples.Point(i);
    const bool expected = p[0] > 0.3 && p[1] > -0.2 && p[1] < 0.4;
    CHECK_EQUAL(inside[static_cast<std::size_t>(i)] != 0, expected);
  }
}

void OrientedPointsHaveAWindingNumber()
{
  std::mt19937 random(7);
  const sb::CloudSurface cloud = clouds::SurfaceOf(clouds::Torus(20000, random));
  sb::ThreadExecutor executor(2);
  const sb::OrientedPointWinding winding(*cloud.Surface, executor);
  std::uniform_real_distribution<double> place(-1.6, 1.6);
  for (int i = 0; i < 2000; ++i)
  {
    const sb::Real3 x{ place(random), place(random), 0.5 * place(random) };
    const double distance = clouds::DistanceToTorus(x);
    if (std::abs(distance) > 4.0 * cloud.Spacing)
    {
      CHECK(std::abs(winding.At(x) - (distance < 0.0 ? 1.0 : 0.0)) < 0.1);
    }
  }
}

} // namespace

int main()
{
  TheSeamLiesOnBoth();
  OpenToolsAreRefused();
  AnEdgeInTheWayIsFlipped();
  AnEdgeOfThePointIsFlippedToo();
  CollapsesKeepTheTopology();
  SamplesAreSortedAsTheBoxSays();
  OrientedPointsHaveAWindingNumber();
  return check::Verdict("TestSeamSnap");
}
