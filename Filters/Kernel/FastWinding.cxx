// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FastWinding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sb
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr std::int64_t Grain = 512;
constexpr std::size_t Width = NearestTriangle::Width;

/** Solid angle of a triangle seen from the origin (van Oosterom and Strackee, 1983). */
double SolidAngle(const std::array<Vector3, 3>& corners)
{
  const Vector3& a = corners[0];
  const Vector3& b = corners[1];
  const Vector3& c = corners[2];
  const double u = Length(a);
  const double v = Length(b);
  const double w = Length(c);
  const double determinant = Dot(a, Cross(b - a, c - a));
  const double denominator = u * v * w + Dot(a, b) * w + Dot(b, c) * u + Dot(c, a) * v;
  return 2.0 * std::atan2(determinant, denominator);
}

} // namespace

void FastWinding::FillLowestLevel(Executor& executor)
{
  const std::vector<std::int32_t>& order = this->Tree->TriangleOrder();
  std::vector<WindingDipole>& groups = this->Groups.Lowest();
  groups.resize((order.size() + Width - 1) / Width);
  executor.For(
    static_cast<std::int64_t>(groups.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
      std::vector<WindingDipole> triangles;
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        triangles.clear();
        const std::size_t last = std::min(order.size(), (i + 1) * Width);
        for (std::size_t place = i * Width; place < last; ++place)
        {
          const std::array<Vector3, 3> p = this->Tree->CornersFrom(this->Reference, order[place]);
          WindingDipole one;
          one.Center = (1.0 / 3.0) * (p[0] + p[1] + p[2]);
          one.Normal = 0.5 * Cross(p[1] - p[0], p[2] - p[0]);
          one.Area = Length(one.Normal);
          for (const Vector3& corner : p)
          {
            one.Radius = std::max(one.Radius, Length(corner - one.Center));
          }
          triangles.push_back(one);
        }
        groups[i] = WindingDipole::Of(triangles, 0, triangles.size());
      }
    });
}

void FastWinding::Build(const NearestTriangle& tree, Executor& executor)
{
  this->Tree = &tree;
  this->Groups = WindingTree();
  if (tree.IsEmpty())
  {
    return;
  }
  this->Reference = PointAt(tree.Mesh().Points, tree.Mesh().Triangles[0]);
  this->FillLowestLevel(executor);
  this->Groups.Build(
    [&executor](std::int64_t count, const auto& body) { executor.For(count, Grain, body); });
}

double FastWinding::NearBy(const Vector3& query, std::int32_t node) const
{
  const std::vector<std::int32_t>& order = this->Tree->TriangleOrder();
  const std::size_t begin = static_cast<std::size_t>(node) * Width;
  const std::size_t end = std::min(order.size(), begin + Width);
  double sum = 0.0;
  for (std::size_t place = begin; place < end; ++place)
  {
    sum += SolidAngle(this->Tree->CornersFrom(query, order[place]));
  }
  return sum;
}

double FastWinding::At(const Vector3& query) const
{
  if (this->Groups.IsEmpty())
  {
    return 0.0;
  }
  const Vector3 place = this->Tree->Scale() * (query - this->Reference);
  return this->Groups.SolidAngleAt(
           place, [&](std::int32_t node) { return this->NearBy(query, node); }) /
    (4.0 * Pi);
}

} // namespace sb
