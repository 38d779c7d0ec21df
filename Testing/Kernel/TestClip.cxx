// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestClip.cxx
 * @brief Clipped surfaces are closed and manifold by ids, both halves add up, and the exact
 * arrangement agrees, wherever the planes lie.
 */
#include "ClipClaims.h"

#include <map>

namespace
{

using namespace claims;

/** Edges, by ids, that do not have exactly one triangle on either side: what vtkFeatureEdges calls
 * a boundary or a non-manifold edge. */
std::int64_t BadEdges(const Mesh& mesh)
{
  std::map<std::pair<std::int32_t, std::int32_t>, std::array<int, 2>> uses;
  for (const Corners& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t from = t[k];
      const std::int32_t to = t[(k + 1) % 3];
      ++uses[std::minmax(from, to)][from < to ? 0 : 1];
    }
  }
  std::int64_t bad = 0;
  for (const auto& use : uses)
  {
    bad += use.second[0] != 1 || use.second[1] != 1;
  }
  return bad;
}

/** A closed surface of unit squares around cells of a grid that are `full`; cells must not touch at
 * an edge alone. */
template <class Full>
Mesh Voxels(int size, Full&& full)
{
  Mesh mesh;
  std::map<Point, std::int32_t> ids;
  const auto id = [&](const Point& p) {
    const auto [it, isNew] = ids.emplace(p, static_cast<std::int32_t>(mesh.Points.size()));
    if (isNew)
    {
      mesh.Points.push_back(p);
    }
    return it->second;
  };
  const auto isFull = [&](const std::array<int, 3>& c) {
    return std::min(c[0], std::min(c[1], c[2])) >= 0 &&
      std::max(c[0], std::max(c[1], c[2])) < size && full(c[0], c[1], c[2]);
  };
  for (int x = 0; x < size; ++x)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int z = 0; z < size; ++z)
      {
        for (std::size_t axis = 0; axis < 3 && isFull({ x, y, z }); ++axis)
        {
          for (int side = 0; side < 2; ++side)
          {
            std::array<int, 3> cell{ x, y, z };
            cell[axis] += side == 0 ? -1 : 1;
            if (isFull(cell))
            {
              continue;
            }
            Point corner{ double(x), double(y), double(z) };
            corner[axis] += side;
            Point u{};
            Point v{};
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1.0;
            std::array<std::int32_t, 4> square{ id(corner), id(corner + u), id(corner + u + v),
              id(corner + v) };
            if (side == 0)
            {
              std::swap(square[1], square[3]);
            }
            mesh.Triangles.push_back({ square[0], square[1], square[2] });
            mesh.Triangles.push_back({ square[0], square[2], square[3] });
          }
        }
      }
    }
  }
  return mesh;
}

Mesh VoxelRing()
{
  return Voxels(6, [](int x, int y, int z) {
    const bool hole = x >= 2 && x < 4 && y >= 2 && y < 4;
    const bool window = z == 2 && x >= 2 && x < 4;
    return !hole && !window;
  });
}

/** A block with a notch of triangular section along x, whose deepest edge lies at height 1. */
Mesh Notched()
{
  const std::vector<std::array<double, 2>> outline{ { 0, 0 }, { 4, 0 }, { 4, 3 }, { 3, 3 },
    { 2, 1 }, { 1, 3 }, { 0, 3 } };
  Mesh mesh;
  const auto count = static_cast<std::int32_t>(outline.size());
  for (double x : { 0.0, 5.0 })
  {
    for (const auto& p : outline)
    {
      mesh.Points.push_back({ x, p[0], p[1] });
    }
  }
  for (std::int32_t i = 0; i < count; ++i)
  {
    const std::int32_t next = (i + 1) % count;
    mesh.Triangles.push_back({ i, next + count, next });
    mesh.Triangles.push_back({ i, i + count, next + count });
  }
  for (const Corners& t :
    std::vector<Corners>{ { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 0, 4, 6 }, { 4, 5, 6 } })
  {
    mesh.Triangles.push_back(t);
    mesh.Triangles.push_back({ t[0] + count, t[2] + count, t[1] + count });
  }
  if (Volume(mesh) < 0.0)
  {
    for (Corners& t : mesh.Triangles)
    {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

ClipPlane Turned(ClipPlane plane)
{
  for (double& n : plane.Normal)
  {
    n = -n;
  }
  return plane;
}

/** A plane through small integers, often through vertices, along edges or in faces. */
ClipPlane LatticePlane(Random& random, int low, int high)
{
  ClipPlane plane;
  plane.Origin = IntegerPoint(random, low, high);
  do
  {
    plane.Normal = IntegerPoint(random, -1, 1);
    if (Between(random, 0, 3) == 0)
    {
      plane.Normal = IntegerPoint(random, -3, 3);
    }
  } while (Length(plane.Normal) == 0.0);
  return plane;
}

ClipPlane AnyPlane(Random& random, double low, double high)
{
  ClipPlane plane;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    plane.Origin[axis] = Uniform(random, low, high);
    plane.Normal[axis] = Uniform(random, -1.0, 1.0);
  }
  return plane;
}

struct Body
{
  const char* Name;
  Mesh Surface;
  int Low;
  int High;
  bool IsSimple = true; ///< does not run through itself
};

std::vector<Body> Bodies()
{
  Mesh shell = Cube(0, 6);
  Mesh inner = Cube(2, 4);
  for (Corners& t : inner.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  shell.Append(inner);
  Mesh touching = Cube(0, 3);
  touching.Append(Box({ 3, 0, 0 }, { 6, 3, 3 }));
  touching.Append(Box({ 3, 3, 3 }, { 6, 6, 6 }));
  Mesh overlapping = Cube(0, 4);
  overlapping.Append(Cube(1, 6));
  return { { "cube", Cube(0, 6), 0, 6 }, { "ring", VoxelRing(), 0, 6 },
    { "notched", Notched(), 0, 5 }, { "shell", shell, 0, 6 }, { "touching", touching, 0, 6 },
    { "overlapping", overlapping, 0, 6, false }, { "sphere", Sphere({ 3, 3, 3 }, 3.0, 3), 0, 6 } };
}

void HalvesAddUpAndAreManifold()
{
  Random random(7);
  for (const Body& body : Bodies())
  {
    const Mesh& mesh = body.Surface;
    CHECK_EQUAL(BadEdges(mesh), 0);
    const double whole = Volume(mesh);
    for (int i = 0; i < 300; ++i)
    {
      const ClipPlane plane = i % 5 == 4 ? AnyPlane(random, body.Low, body.High)
                                         : LatticePlane(random, body.Low, body.High);
      const Mesh front = Clip(mesh, { plane });
      const Mesh back = Clip(mesh, { Turned(plane) });
      CHECK_EQUAL(BadEdges(front), 0);
      CHECK_EQUAL(BadEdges(back), 0);
      CHECK(std::fabs(Volume(front) + Volume(back) - whole) <= 1e-12 * whole);
    }
  }
}

void ManyPlanesAtOnce()
{
  Random random(11);
  for (const Body& body : Bodies())
  {
    for (int i = 0; i < 200; ++i)
    {
      std::vector<ClipPlane> planes;
      const int count = Between(random, 2, i % 20 == 0 ? 9 : 4);
      for (int k = 0; k < count; ++k)
      {
        planes.push_back(i % 4 == 3 ? AnyPlane(random, body.Low, body.High)
                                    : LatticePlane(random, body.Low, body.High));
      }
      const Mesh result = Clip(body.Surface, planes);
      CHECK_EQUAL(BadEdges(result), 0);
      const Mesh rest = Clip(body.Surface, planes, true);
      if (body.IsSimple)
      {
        CHECK_EQUAL(BadEdges(rest), 0);
      }
      CHECK(std::fabs(Volume(rest) + Volume(result) - Volume(body.Surface)) <=
        1e-12 * Volume(body.Surface));
      // One after the other gives the same solid.
      Mesh step = body.Surface;
      for (const ClipPlane& plane : planes)
      {
        step = Clip(step, { plane });
      }
      CHECK(std::fabs(Volume(step) - Volume(result)) <= 1e-12 * Volume(body.Surface));
    }
  }
}

/** A plane that is there twice, or nearly, changes nothing, whatever further planes cut its cap. */
void RepeatedPlanes()
{
  Random random(13);
  for (const Body& body : Bodies())
  {
    for (int i = 0; i < 60; ++i)
    {
      const auto any = [&] {
        return i % 4 == 3 ? AnyPlane(random, body.Low, body.High)
                          : LatticePlane(random, body.Low, body.High);
      };
      const ClipPlane plane = any();
      const ClipPlane other = any();
      ClipPlane twice = plane;
      twice.Normal = (i % 3 + 1.0) * plane.Normal;
      const double expected = Volume(Clip(body.Surface, { plane, other }));
      for (const auto& planes : { std::vector<ClipPlane>{ plane, twice, other },
             { plane, other, twice }, { other, plane, twice } })
      {
        const Mesh result = Clip(body.Surface, planes);
        CHECK_EQUAL(BadEdges(result), 0);
        CHECK(std::fabs(Volume(result) - expected) <= 1e-12 * Volume(body.Surface));
      }
    }
  }
}

} // namespace

int main()
{
  HalvesAddUpAndAreManifold();
  ManyPlanesAtOnce();
  RepeatedPlanes();
  return check::Verdict("TestClip");
}
