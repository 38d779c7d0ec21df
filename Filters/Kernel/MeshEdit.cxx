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
constexpr int MostFlips = 8; ///< for one move

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

/** Of its corners, with `point` at `place`. */
std::array<Real3, 3> MeshEdit::PlacesOf(
  std::int32_t triangle, std::int32_t point, const Real3& place) const
{
  const std::int32_t* const ids = this->Mesh.Corners(triangle);
  std::array<Real3, 3> places;
  std::transform(ids, ids + 3, places.begin(),
    [&](std::int32_t id) { return id == point ? place : this->Mesh.Point(id); });
  return places;
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
    const Front front = this->FrontOfTriangle(triangle);
    const double facing = Facing(this->PlacesOf(triangle, point, place), front.Direction);
    if (facing < front.LeastCosine &&
      facing <= Facing(this->PlacesOf(triangle, point, this->Mesh.Point(point)), front.Direction))
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
  const Front front = this->FrontOfTriangle(triangle);
  return Facing(this->PlacesOf(triangle, point, place), front.Direction) >= front.LeastCosine;
}

void MeshEdit::SetCorners(std::int32_t triangle, const Corners& corners)
{
  std::int32_t* const ids = this->Mesh.Triangles.data() + 3 * static_cast<std::size_t>(triangle);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (this->IsInZone(ids[k]))
    {
      std::vector<std::int32_t>& list =
        this->Incident[static_cast<std::size_t>(this->Zone[static_cast<std::size_t>(ids[k])])];
      list.erase(std::find(list.begin(), list.end(), triangle));
    }
    if (this->IsInZone(corners[k]))
    {
      this->Incident[static_cast<std::size_t>(this->Zone[static_cast<std::size_t>(corners[k])])]
        .push_back(triangle);
    }
  }
  std::copy(corners.begin(), corners.end(), ids);
}

/** The one other triangle at the edge, or -1. */
std::int32_t MeshEdit::Across(std::int32_t triangle, std::int32_t a, std::int32_t b) const
{
  std::int32_t found = -1;
  for (const std::int32_t other : this->TrianglesAt(a))
  {
    const std::int32_t* const ids = this->Mesh.Corners(other);
    if (other != triangle && std::find(ids, ids + 3, b) != ids + 3)
    {
      if (found >= 0)
      {
        return -1;
      }
      found = other;
    }
  }
  return found;
}

/** The edge that is longest with `point` at `place`; a triangle that turns over does so over it. */
bool MeshEdit::FlipLongestEdge(std::int32_t triangle, std::int32_t point, const Real3& place,
  const MayFlip& mayFlip, std::vector<Change>& changes)
{
  const std::array<Real3, 3> places = this->PlacesOf(triangle, point, place);
  const auto lengthOf = [&](std::size_t k) {
    return Length(Difference(places[(k + 1) % 3], places[k]));
  };
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    longest = lengthOf(k) > lengthOf(longest) ? k : longest;
  }
  const std::int32_t* const ids = this->Mesh.Corners(triangle);
  const Corners corners{ ids[0], ids[1], ids[2] };
  const std::int32_t a = corners[longest];
  const std::int32_t b = corners[(longest + 1) % 3];
  const std::int32_t top = corners[(longest + 2) % 3];
  const std::int32_t other =
    this->IsInZone(a) && this->IsInZone(b) ? this->Across(triangle, a, b) : -1;
  if (other < 0 ||
    this->Mesh.Source[static_cast<std::size_t>(other)] !=
      this->Mesh.Source[static_cast<std::size_t>(triangle)])
  {
    return false;
  }
  const std::int32_t* const its = this->Mesh.Corners(other);
  const Corners others{ its[0], its[1], its[2] };
  const std::int32_t bottom = *std::find_if(
    others.begin(), others.end(), [a, b](std::int32_t id) { return id != a && id != b; });
  const std::vector<std::int32_t> around =
    this->IsInZone(top) ? this->Neighbours(top) : std::vector<std::int32_t>{ bottom };
  if (std::binary_search(around.begin(), around.end(), bottom) ||
    !mayFlip({ triangle, other, top, bottom }))
  {
    return false;
  }
  changes.push_back({ triangle, corners });
  changes.push_back({ other, others });
  this->SetCorners(triangle, { top, a, bottom });
  this->SetCorners(other, { top, bottom, b });
  return true;
}

bool MeshEdit::MoveFlipping(std::int32_t point, const Real3& place, const MayFlip& mayFlip)
{
  std::vector<Change> changes;
  bool done = false;
  for (int flip = 0; flip <= MostFlips; ++flip)
  {
    const std::vector<std::int32_t> turning = this->TurningOver(point, place, Dropped);
    if (turning.empty())
    {
      done = std::all_of(changes.begin(), changes.end(),
        [&](const Change& change) { return this->FacesRight(change.Triangle, point, place); });
      break;
    }
    if (!this->FlipLongestEdge(turning.front(), point, place, mayFlip, changes))
    {
      break;
    }
  }
  if (done)
  {
    this->Mesh.SetPoint(point, place);
    return true;
  }
  for (auto change = changes.rbegin(); change != changes.rend(); ++change)
  {
    this->SetCorners(change->Triangle, change->Before);
  }
  return false;
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
