// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshEdit.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace sb
{
namespace
{

constexpr std::int32_t Dropped = -1;

/** The cosine between a triangle and a direction; -1 for one without area. */
double Facing(const std::array<Real3, 3>& corners, const Real3& direction)
{
  const Real3 turn = Cross(Difference(corners[1], corners[0]), Difference(corners[2], corners[0]));
  const double length = Length(turn);
  return length > 0.0 ? Dot(turn, direction) / length : -1.0;
}

} // namespace

MeshEdit::MeshEdit(CombinedMesh& mesh, const std::vector<std::uint8_t>& zone, FrontOf front)
  : Mesh(mesh)
  , FrontOfTriangle(std::move(front))
  , Zone(zone.size(), -1)
  , Into(zone.size())
{
  std::int32_t count = 0;
  for (std::size_t i = 0; i < zone.size(); ++i)
  {
    this->Zone[i] = zone[i] ? count++ : -1;
    this->Into[i] = static_cast<std::int32_t>(i);
  }
  this->Incident.resize(static_cast<std::size_t>(count));
  for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
  {
    const std::int32_t place = this->Zone[static_cast<std::size_t>(mesh.Triangles[corner])];
    if (place >= 0)
    {
      this->Incident[static_cast<std::size_t>(place)].push_back(
        static_cast<std::int32_t>(corner / 3));
    }
  }
}

std::vector<std::int32_t> MeshEdit::Neighbours(std::int32_t point) const
{
  std::vector<std::int32_t> found;
  for (const std::int32_t triangle : this->TrianglesAt(point))
  {
    const std::int32_t* const ids = this->Mesh.Corners(triangle);
    std::copy_if(
      ids, ids + 3, std::back_inserter(found), [point](std::int32_t id) { return id != point; });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::array<Real3, 3> MeshEdit::CornersOf(std::int32_t triangle) const
{
  const std::int32_t* const ids = this->Mesh.Corners(triangle);
  return { this->Mesh.Point(ids[0]), this->Mesh.Point(ids[1]), this->Mesh.Point(ids[2]) };
}

/** @param exceptWith those with this corner vanish, and do not count */
std::vector<std::int32_t> MeshEdit::TurningOver(
  std::int32_t point, const Real3& place, std::int32_t exceptWith) const
{
  std::vector<std::int32_t> worse;
  for (const std::int32_t triangle : this->TrianglesAt(point))
  {
    const std::int32_t* const ids = this->Mesh.Corners(triangle);
    if (std::find(ids, ids + 3, exceptWith) != ids + 3)
    {
      continue;
    }
    const std::array<Real3, 3> before = this->CornersOf(triangle);
    std::array<Real3, 3> after = before;
    after[static_cast<std::size_t>(std::find(ids, ids + 3, point) - ids)] = place;
    const Front front = this->FrontOfTriangle(triangle);
    const double facing = Facing(after, front.Direction);
    if (facing < front.LeastCosine && facing <= Facing(before, front.Direction))
    {
      worse.push_back(triangle);
    }
  }
  return worse;
}

bool MeshEdit::MayMove(std::int32_t point, const Real3& place, std::int32_t exceptWith) const
{
  return this->TurningOver(point, place, exceptWith).empty();
}

bool MeshEdit::Move(std::int32_t point, const Real3& place)
{
  if (!this->MayMove(point, place, Dropped))
  {
    return false;
  }
  this->Mesh.SetPoint(point, place);
  return true;
}

bool MeshEdit::FacesRight(std::int32_t triangle, std::int32_t point, const Real3& place) const
{
  const std::int32_t* const ids = this->Mesh.Corners(triangle);
  std::array<Real3, 3> corners = this->CornersOf(triangle);
  corners[static_cast<std::size_t>(std::find(ids, ids + 3, point) - ids)] = place;
  const Front front = this->FrontOfTriangle(triangle);
  return Facing(corners, front.Direction) >= front.LeastCosine;
}

void MeshEdit::Forget(std::int32_t triangle, std::int32_t point)
{
  std::vector<std::int32_t>& list =
    this->Incident[static_cast<std::size_t>(this->Zone[static_cast<std::size_t>(point)])];
  list.erase(std::find(list.begin(), list.end(), triangle));
}

void MeshEdit::Remember(std::int32_t triangle, std::int32_t point)
{
  if (this->IsInZone(point))
  {
    this->Incident[static_cast<std::size_t>(this->Zone[static_cast<std::size_t>(point)])].push_back(
      triangle);
  }
}

bool MeshEdit::MoveAcross(std::int32_t point, const Real3& place, const MayFlip& mayFlip)
{
  const std::vector<std::int32_t> turning = this->TurningOver(point, place, Dropped);
  if (turning.size() != 1)
  {
    return false;
  }
  const std::int32_t t = turning.front();
  std::int32_t* const ids = this->Mesh.Triangles.data() + 3 * static_cast<std::size_t>(t);
  const std::ptrdiff_t at = std::find(ids, ids + 3, point) - ids;
  const std::int32_t a = ids[(at + 1) % 3];
  const std::int32_t b = ids[(at + 2) % 3];
  if (!this->IsInZone(a) || !this->IsInZone(b))
  {
    return false;
  }
  std::vector<std::int32_t> across;
  for (const std::int32_t other : this->TrianglesAt(a))
  {
    const std::int32_t* const its = this->Mesh.Corners(other);
    if (other != t && std::find(its, its + 3, b) != its + 3)
    {
      across.push_back(other);
    }
  }
  if (across.size() != 1 ||
    this->Mesh.Source[static_cast<std::size_t>(across[0])] !=
      this->Mesh.Source[static_cast<std::size_t>(t)] ||
    !mayFlip(t, across[0]))
  {
    return false;
  }
  const std::int32_t u = across[0];
  std::int32_t* const others = this->Mesh.Triangles.data() + 3 * static_cast<std::size_t>(u);
  const std::int32_t c =
    *std::find_if(others, others + 3, [a, b](std::int32_t id) { return id != a && id != b; });
  const std::vector<std::int32_t> around = this->Neighbours(point);
  if (std::binary_search(around.begin(), around.end(), c))
  {
    return false;
  }
  const std::array<std::int32_t, 3> before{ ids[0], ids[1], ids[2] };
  const std::array<std::int32_t, 3> othersBefore{ others[0], others[1], others[2] };
  const std::array<std::int32_t, 3> first{ point, a, c };
  const std::array<std::int32_t, 3> second{ point, c, b };
  std::copy(first.begin(), first.end(), ids);
  std::copy(second.begin(), second.end(), others);
  if (!this->FacesRight(t, point, place) || !this->FacesRight(u, point, place))
  {
    std::copy(before.begin(), before.end(), ids);
    std::copy(othersBefore.begin(), othersBefore.end(), others);
    return false;
  }
  this->Forget(t, b);
  this->Forget(u, a);
  this->Remember(t, c);
  this->Remember(u, point);
  this->Mesh.SetPoint(point, place);
  return true;
}

bool MeshEdit::Collapse(std::int32_t gone, std::int32_t kept)
{
  const std::vector<std::int32_t> around = this->Neighbours(gone);
  const std::vector<std::int32_t> aroundKept = this->Neighbours(kept);
  std::vector<std::int32_t> common;
  std::set_intersection(
    around.begin(), around.end(), aroundKept.begin(), aroundKept.end(), std::back_inserter(common));
  std::vector<std::int32_t>& triangles =
    this->Incident[static_cast<std::size_t>(this->Zone[static_cast<std::size_t>(gone)])];
  const auto hasKept = [&](std::int32_t triangle) {
    const std::int32_t* const ids = this->Mesh.Corners(triangle);
    return std::find(ids, ids + 3, kept) != ids + 3;
  };
  // The link condition of a point inside of a surface: around a closed fan, and two triangles
  // vanish.
  const bool inside = triangles.size() == around.size();
  if (!inside || common.size() != 2 ||
    std::count_if(triangles.begin(), triangles.end(), hasKept) != 2 ||
    !this->MayMove(gone, this->Mesh.Point(kept), kept))
  {
    return false;
  }
  for (const std::int32_t triangle : triangles)
  {
    std::int32_t* const ids = this->Mesh.Triangles.data() + 3 * static_cast<std::size_t>(triangle);
    if (!hasKept(triangle))
    {
      std::replace(ids, ids + 3, gone, kept);
      this->Incident[static_cast<std::size_t>(this->Zone[static_cast<std::size_t>(kept)])]
        .push_back(triangle);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t place = this->Zone[static_cast<std::size_t>(ids[k])];
      if (ids[k] != gone && place >= 0)
      {
        std::vector<std::int32_t>& list = this->Incident[static_cast<std::size_t>(place)];
        list.erase(std::find(list.begin(), list.end(), triangle));
      }
    }
    std::fill(ids, ids + 3, Dropped);
  }
  triangles.clear();
  this->Into[static_cast<std::size_t>(gone)] = kept;
  return true;
}

std::vector<std::int32_t> MeshEdit::Finish()
{
  std::size_t triangles = 0;
  for (std::size_t t = 0; t < this->Mesh.Source.size(); ++t)
  {
    if (this->Mesh.Triangles[3 * t] != Dropped)
    {
      std::copy_n(this->Mesh.Triangles.begin() + static_cast<std::ptrdiff_t>(3 * t), 3,
        this->Mesh.Triangles.begin() + static_cast<std::ptrdiff_t>(3 * triangles));
      this->Mesh.Source[triangles] = this->Mesh.Source[t];
      this->Mesh.Parent[triangles] = this->Mesh.Parent[t];
      this->Mesh.Reversed[triangles] = this->Mesh.Reversed[t];
      this->Mesh.Confidence[triangles++] = this->Mesh.Confidence[t];
    }
  }
  this->Mesh.Triangles.resize(3 * triangles);
  this->Mesh.Source.resize(triangles);
  this->Mesh.Parent.resize(triangles);
  this->Mesh.Reversed.resize(triangles);
  this->Mesh.Confidence.resize(triangles);
  std::vector<std::int32_t> number(this->Into.size(), -1);
  std::int32_t points = 0;
  for (std::size_t i = 0; i < this->Into.size(); ++i)
  {
    if (this->Into[i] == static_cast<std::int32_t>(i))
    {
      this->Mesh.SetPoint(points, this->Mesh.Point(static_cast<std::int32_t>(i)));
      this->Mesh.OriginalPoint[static_cast<std::size_t>(points)] = this->Mesh.OriginalPoint[i];
      this->Mesh.PointSource[static_cast<std::size_t>(points)] = this->Mesh.PointSource[i];
      number[i] = points++;
    }
  }
  this->Mesh.Points.resize(3 * static_cast<std::size_t>(points));
  this->Mesh.OriginalPoint.resize(static_cast<std::size_t>(points));
  this->Mesh.PointSource.resize(static_cast<std::size_t>(points));
  for (std::size_t i = 0; i < this->Into.size(); ++i)
  {
    std::int32_t last = static_cast<std::int32_t>(i);
    while (this->IsGone(last))
    {
      last = this->Into[static_cast<std::size_t>(last)];
    }
    number[i] = number[static_cast<std::size_t>(last)];
  }
  for (std::int32_t& corner : this->Mesh.Triangles)
  {
    corner = number[static_cast<std::size_t>(corner)];
  }
  return number;
}

} // namespace sb
