// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ToolSurface.h"

#include "CombinedMesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sb
{

bool AreFarApart(
  const NURBSSurface& patch, const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  // Where a place is a little off both triangles their answers differ by much less, and at a seam
  // by all of the domain.
  constexpr double share = 0.25;
  return std::abs(a[0] - b[0]) > share * (patch.LastU() - patch.FirstU()) ||
    std::abs(a[1] - b[1]) > share * (patch.LastV() - patch.FirstV());
}

ToolSurface::ToolSurface(const DesignedSurface& body, Executor& executor)
  : Designed(&body)
  , Triangles(body.Triangles)
{
  const std::vector<std::int32_t> first =
    FirstAtPlace(body.Points.data(), body.Points.size() / 3, executor);
  for (std::int32_t& corner : this->Triangles)
  {
    corner = first[static_cast<std::size_t>(corner)];
  }
  this->Tree.Build(this->Mesh(), executor);
  this->Winding.Build(this->Tree, executor);
}

Surface ToolSurface::Mesh() const
{
  return { this->Designed->Points.data(),
    static_cast<std::int64_t>(this->Designed->Points.size() / 3), this->Triangles.data(),
    static_cast<std::int64_t>(this->Triangles.size() / 3) };
}

std::array<std::int32_t, 3> ToolSurface::Corners(std::int32_t triangle) const
{
  const std::int32_t* const ids = this->Triangles.data() + 3 * static_cast<std::size_t>(triangle);
  return { ids[0], ids[1], ids[2] };
}

Real3 ToolSurface::Point(std::int32_t i) const
{
  const double* const p = this->Designed->Points.data() + 3 * static_cast<std::size_t>(i);
  return { p[0], p[1], p[2] };
}

Real3 ToolSurface::Normal(std::int32_t triangle) const
{
  const std::array<std::int32_t, 3> ids = this->Corners(triangle);
  const Real3 a = this->Point(ids[0]);
  const Real3 turn = Cross(Difference(this->Point(ids[1]), a), Difference(this->Point(ids[2]), a));
  const double length = Length(turn);
  return length > 0.0 ? Scaled(turn, 1.0 / length) : Real3{};
}

double ToolSurface::WindingNumber(const Real3& place) const
{
  const Vector3 query{ place[0], place[1], place[2] };
  return this->Tree.IsOutsideBounds(query) ? 0.0 : this->Winding.At(query);
}

ToolSurface::Nearest ToolSurface::NearestTo(const Real3& place, double limit) const
{
  const NearestTriangle::Answer answer =
    this->Tree.Find({ place[0], place[1], place[2] }, limit, -1);
  if (answer.Triangle < 0)
  {
    return { -1, place, limit };
  }
  const double unit = 1.0 / this->Tree.Scale();
  return { answer.Triangle,
    PlusScaled(place, unit, { answer.Place.X, answer.Place.Y, answer.Place.Z }),
    unit * std::sqrt(answer.SquaredDistance) };
}

std::array<double, 2> ToolSurface::ParametersOf(std::int32_t triangle, const Real3& place) const
{
  const std::int32_t* const ids =
    this->Designed->Triangles.data() + 3 * static_cast<std::size_t>(triangle);
  const Real3 a = this->Point(ids[0]);
  const Real3 ab = Difference(this->Point(ids[1]), a);
  const Real3 ac = Difference(this->Point(ids[2]), a);
  const Real3 ap = Difference(place, a);
  const Real3 turn = Cross(ab, ac);
  const double squared = Dot(turn, turn);
  const double toB = squared > 0.0 ? Dot(Cross(ap, ac), turn) / squared : 0.0;
  const double toC = squared > 0.0 ? Dot(Cross(ab, ap), turn) / squared : 0.0;
  std::array<double, 2> uv{};
  for (std::size_t k = 0; k < 2; ++k)
  {
    const auto of = [&](std::int32_t id) {
      return this->Designed->UV[2 * static_cast<std::size_t>(id) + k];
    };
    uv[k] = (1.0 - toB - toC) * of(ids[0]) + toB * of(ids[1]) + toC * of(ids[2]);
  }
  return uv;
}

bool ToolSurface::MeetsItselfBetween(std::int32_t s, std::int32_t t, const Real3& place) const
{
  const std::vector<std::int32_t>& faces = this->Designed->FaceId;
  if (!this->Designed->HasPatches() || s == t ||
    faces[static_cast<std::size_t>(s)] != faces[static_cast<std::size_t>(t)] ||
    faces[static_cast<std::size_t>(s)] < 0)
  {
    return false;
  }
  return AreFarApart(this->PatchOf(s), this->ParametersOf(s, place), this->ParametersOf(t, place));
}

bool ToolSurface::MeetsItselfAmong(
  const std::vector<std::int32_t>& triangles, const Real3& place) const
{
  for (std::size_t i = 1; i < triangles.size(); ++i)
  {
    const bool found =
      std::any_of(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(i),
        [&](std::int32_t other) { return this->MeetsItselfBetween(triangles[i], other, place); });
    if (found)
    {
      return true;
    }
  }
  return false;
}

} // namespace sb
