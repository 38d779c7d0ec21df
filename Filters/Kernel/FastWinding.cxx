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
/** A group counts as a dipole from this many of its radii on; the paper's beta. */
constexpr double Beta = 2.5;
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

double& Coordinate(Vector3& a, int k) { return k == 0 ? a.X : k == 1 ? a.Y : a.Z; }

} // namespace

/** The dipole of several: moments move with the centre. */
FastWinding::Dipole FastWinding::Gather(
  const std::vector<Dipole>& parts, std::size_t begin, std::size_t end) const
{
  Dipole sum;
  Vector3 plain;
  for (std::size_t i = begin; i < end; ++i)
  {
    sum.Area += parts[i].Area;
    sum.Center = sum.Center + parts[i].Area * parts[i].Center;
    plain = plain + parts[i].Center;
    sum.Normal = sum.Normal + parts[i].Normal;
  }
  sum.Center = sum.Area > 0.0 ? (1.0 / sum.Area) * sum.Center
                              : (1.0 / static_cast<double>(end - begin)) * plain;
  for (std::size_t i = begin; i < end; ++i)
  {
    Vector3 offset = parts[i].Center - sum.Center;
    for (int k = 0; k < 3; ++k)
    {
      sum.Moment[k] = sum.Moment[k] + parts[i].Moment[k] + Coordinate(offset, k) * parts[i].Normal;
    }
    sum.Radius = std::max(sum.Radius, Length(offset) + parts[i].Radius);
  }
  return sum;
}

void FastWinding::FillLowestLevel(Executor& executor)
{
  const std::vector<std::int32_t>& order = this->Tree->TriangleOrder();
  std::vector<Dipole>& groups = this->Levels.emplace_back((order.size() + Width - 1) / Width);
  executor.For(
    static_cast<std::int64_t>(groups.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
      std::vector<Dipole> triangles;
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        triangles.clear();
        const std::size_t last = std::min(order.size(), (i + 1) * Width);
        for (std::size_t place = i * Width; place < last; ++place)
        {
          const std::array<Vector3, 3> p = this->Tree->CornersFrom(this->Reference, order[place]);
          Dipole one;
          one.Center = (1.0 / 3.0) * (p[0] + p[1] + p[2]);
          one.Normal = 0.5 * Cross(p[1] - p[0], p[2] - p[0]);
          one.Area = Length(one.Normal);
          for (const Vector3& corner : p)
          {
            one.Radius = std::max(one.Radius, Length(corner - one.Center));
          }
          triangles.push_back(one);
        }
        groups[i] = this->Gather(triangles, 0, triangles.size());
      }
    });
}

void FastWinding::Build(const NearestTriangle& tree, Executor& executor)
{
  this->Tree = &tree;
  this->Levels.clear();
  if (tree.IsEmpty())
  {
    return;
  }
  this->Reference = PointAt(tree.Mesh().Points, tree.Mesh().Triangles[0]);
  this->Levels.reserve(16);
  this->FillLowestLevel(executor);
  while (this->Levels.back().size() > 1)
  {
    const std::vector<Dipole>& below = this->Levels.back();
    std::vector<Dipole> level((below.size() + Width - 1) / Width);
    executor.For(
      static_cast<std::int64_t>(level.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          level[i] = this->Gather(below, i * Width, std::min(below.size(), (i + 1) * Width));
        }
      });
    this->Levels.push_back(std::move(level));
  }
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
  struct Open
  {
    int Level;
    std::int32_t Index;
  };
  std::array<Open, 16 * Width> stack;
  std::size_t numberOpen = 0;
  if (this->Levels.empty())
  {
    return 0.0;
  }
  const Vector3 place = this->Tree->Scale() * (query - this->Reference);
  double sum = 0.0; // solid angle
  stack[numberOpen++] = { static_cast<int>(this->Levels.size()) - 1, 0 };
  while (numberOpen > 0)
  {
    const Open open = stack[--numberOpen];
    const Dipole& group =
      this->Levels[static_cast<std::size_t>(open.Level)][static_cast<std::size_t>(open.Index)];
    const Vector3 r = group.Center - place;
    const double squared = SquaredLength(r);
    if (squared > Beta * Beta * group.Radius * group.Radius)
    {
      const double inverse = 1.0 / std::sqrt(squared);
      const double cube = inverse * inverse * inverse;
      const Vector3 unit = inverse * r;
      const double trace = group.Moment[0].X + group.Moment[1].Y + group.Moment[2].Z;
      const double along = unit.X * Dot(group.Moment[0], unit) +
        unit.Y * Dot(group.Moment[1], unit) + unit.Z * Dot(group.Moment[2], unit);
      sum += cube * (Dot(r, group.Normal) + trace - 3.0 * along);
    }
    else if (open.Level == 0)
    {
      sum += this->NearBy(query, open.Index);
    }
    else
    {
      const std::size_t below = this->Levels[static_cast<std::size_t>(open.Level - 1)].size();
      const std::size_t first = static_cast<std::size_t>(open.Index) * Width;
      for (std::size_t child = first; child < std::min(below, first + Width); ++child)
      {
        stack[numberOpen++] = { open.Level - 1, static_cast<std::int32_t>(child) };
      }
    }
  }
  return sum / (4.0 * Pi);
}

} // namespace sb
