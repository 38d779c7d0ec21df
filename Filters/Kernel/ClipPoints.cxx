// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClipPoints.h"

#include "Hash.h"

#include <algorithm>
#include <cmath>

namespace sb
{

namespace
{

// The second entry of a name tells the kinds apart; that of an edge is a vertex.
constexpr std::int32_t ofVertex = -1;
constexpr std::int32_t ofFace = -2;
constexpr std::int32_t ofPlanes = -3;
constexpr std::int32_t unnamed = -4;

double Distance(const double* a, const double* b)
{
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

} // namespace

std::size_t ClipPoints::HashOfName::operator()(const Name& name) const
{
  return static_cast<std::size_t>(HashPair(name[0], name[1], HashPair(name[2], name[3], 0)));
}

ClipPoints::ClipPoints(
  const Surface& mesh, const Lattice& lattice, const std::vector<HalfSpace>& planes)
  : Mesh(mesh)
  , Grid(lattice)
  , Planes(planes)
{
}

template <class Make>
std::int32_t ClipPoints::Find(const Name& name, Make&& make)
{
  const auto known = this->Known.find(name);
  if (known != this->Known.end())
  {
    return known->second;
  }
  const std::int32_t instance = this->AddInstance(name, make());
  this->Known.emplace(name, instance);
  return instance;
}

std::int32_t ClipPoints::AtVertex(std::int32_t vertex)
{
  return this->Find(
    { vertex, ofVertex, 0, 0 }, [&] { return ExactPoint::Vertex(this->Position(vertex).data()); });
}

std::int32_t ClipPoints::OnEdge(std::int32_t from, std::int32_t to, std::int32_t plane)
{
  return this->Find({ std::min(from, to), std::max(from, to), plane, 0 }, [&] {
    return ExactPoint::LinePlane(
      this->Position(from).data(), this->Position(to).data(), this->Plane(plane).Plane());
  });
}

std::int32_t ClipPoints::InFace(std::int32_t face, std::int32_t plane, std::int32_t other)
{
  return this->Find({ face, ofFace, std::min(plane, other), std::max(plane, other) }, [&] {
    return ExactPoint::ThreePlanes(
      this->PlaneOfFace(face), this->Plane(plane).Plane(), this->Plane(other).Plane());
  });
}

std::int32_t ClipPoints::AtCorner(std::int32_t plane, std::int32_t other, std::int32_t third)
{
  std::array<std::int32_t, 3> sorted{ plane, other, third };
  std::sort(sorted.begin(), sorted.end());
  return this->Find({ sorted[0], ofPlanes, sorted[1], sorted[2] }, [&] {
    return ExactPoint::ThreePlanes(
      this->Plane(plane).Plane(), this->Plane(other).Plane(), this->Plane(third).Plane());
  });
}

std::int32_t ClipPoints::Add(const ExactPoint& point)
{
  return this->AddInstance({ 0, unnamed, 0, 0 }, point);
}

std::int32_t ClipPoints::AddInstance(const Name& name, const ExactPoint& point)
{
  const std::int32_t instance = this->NumberOfInstances();
  this->Names.push_back(name);
  const std::int32_t node = this->FindNode(point);
  this->Nodes.push_back(node);
  if (node == static_cast<std::int32_t>(this->Firsts.size()))
  {
    this->Firsts.push_back(instance);
  }
  else if (name[1] == ofVertex && this->Names[std::size_t(this->Instance(node))][1] != ofVertex)
  {
    this->Firsts[std::size_t(node)] = instance; // a vertex has bytes of its own
  }
  return instance;
}

std::int32_t ClipPoints::FindNode(const ExactPoint& point)
{
  const std::uint64_t place = HashPlace(point.Approximation());
  const auto range = this->NodesByPlace.equal_range(place);
  for (auto known = range.first; known != range.second; ++known)
  {
    if (SamePoint(this->Point(known->second), point))
    {
      return known->second;
    }
  }
  const std::int32_t node = this->NumberOfNodes();
  this->Points.push_back(point);
  this->NodesByPlace.emplace(place, node);
  return node;
}

ExactPlane ClipPoints::PlaneOfFace(std::int32_t face) const
{
  const std::array<std::int32_t, 3> corners = this->Corners(face);
  return ExactPlane::Through(this->Position(corners[0]).data(), this->Position(corners[1]).data(),
    this->Position(corners[2]).data());
}

bool ClipPoints::IsOnEdge(std::int32_t instance, std::array<std::int32_t, 2>& edge) const
{
  const Name& name = this->Names[std::size_t(instance)];
  edge = { name[0], name[1] };
  return name[1] >= 0;
}

InterpolatedPoint ClipPoints::Output(std::int32_t instance) const
{
  const Name& name = this->Names[std::size_t(instance)];
  const double* p = this->Point(this->Node(instance)).Approximation();
  InterpolatedPoint point{ { this->Grid.ToWorld(p[0]), this->Grid.ToWorld(p[1]),
                             this->Grid.ToWorld(p[2]) },
    0, { 0, 0, 0 }, { 1.0, 0.0, 0.0 } };
  const std::int32_t first = this->Instance(this->Node(instance));
  if (this->Names[std::size_t(first)][1] == ofVertex)
  {
    const double* own = this->Mesh.Points + 3 * std::int64_t(this->Names[std::size_t(first)][0]);
    point.Position = { own[0], own[1], own[2] };
  }
  if (name[1] == ofVertex)
  {
    point.PointIds = { name[0], name[0], name[0] };
  }
  else if (name[1] >= 0)
  {
    point.PointIds = { name[0], name[1], name[0] };
    const std::array<double, 3> u = this->Position(name[0]);
    const std::array<double, 3> v = this->Position(name[1]);
    const double fromU = Distance(u.data(), p);
    const double fromV = Distance(v.data(), p);
    const double weight = fromU + fromV > 0.0 ? fromV / (fromU + fromV) : 1.0;
    point.Weights = { weight, 1.0 - weight, 0.0 };
  }
  else if (name[1] == ofFace)
  {
    point.PointIds = this->Corners(name[0]);
    const std::array<double, 3> q[3] = { this->Position(point.PointIds[0]),
      this->Position(point.PointIds[1]), this->Position(point.PointIds[2]) };
    const DominantNormal normal = ComputeDominantNormal(q[0].data(), q[1].data(), q[2].data());
    const int u = (normal.Axis + 1) % 3;
    const int v = (normal.Axis + 2) % 3;
    const auto area = [&](const double* a, const double* b, const double* c) {
      return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
    };
    const double whole = area(q[0].data(), q[1].data(), q[2].data());
    const double first0 = std::min(1.0, std::max(0.0, area(p, q[1].data(), q[2].data()) / whole));
    const double second =
      std::min(1.0 - first0, std::max(0.0, area(q[0].data(), p, q[2].data()) / whole));
    point.Weights = { first0, second, 1.0 - first0 - second };
  }
  else
  {
    point.Operand = 1; // inside the solid, where no surface carries data
  }
  return point;
}

} // namespace sb
