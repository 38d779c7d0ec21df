// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HalvedFaces.h"

#include "TriangleCutting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace sbvtk
{
namespace
{

// Of the domain: the line goes through corners that are nearer, so that no edge of it is too short.
constexpr double nearShare = 1e-4;

using Place = std::array<double, 2>; // u and v
using Corners = std::array<std::int32_t, 3>;

class Halving
{
public:
  Halving(sb::DesignedSurface& surface, const FaceToHalve& which)
    : Surface(surface)
    , Face(which.Face)
    , Across(which.AtU ? 0 : 1)
  {
    const sb::NURBSSurface& patch = surface.Patches[static_cast<std::size_t>(which.Face)];
    const double first = which.AtU ? patch.FirstU() : patch.FirstV();
    const double last = which.AtU ? patch.LastU() : patch.LastV();
    this->Middle = 0.5 * (first + last);
    this->Near = nearShare * (last - first);
  }

  void Run()
  {
    const std::size_t count = this->Surface.FaceId.size();
    for (std::size_t t = 0; t < count; ++t)
    {
      for (std::size_t k = 0; this->Surface.FaceId[t] == this->Face && k < 3; ++k)
      {
        this->Sides.insert(this->SideOf(this->CornersOf(t), k));
      }
    }
    this->Surface.Patches.push_back(this->Surface.Patches[static_cast<std::size_t>(this->Face)]);
    for (std::size_t t = 0; t < count; ++t)
    {
      if (this->Surface.FaceId[t] == this->Face)
      {
        this->Cut(t);
      }
    }
  }

private:
  using Side = std::pair<Place, Place>;

  Corners CornersOf(std::size_t triangle) const
  {
    const std::int32_t* const ids = this->Surface.Triangles.data() + 3 * triangle;
    return { ids[0], ids[1], ids[2] };
  }
  Place At(std::int32_t point) const
  {
    const double* const uv = this->Surface.UV.data() + 2 * static_cast<std::size_t>(point);
    return { uv[0], uv[1] };
  }
  Side SideOf(const Corners& corners, std::size_t k) const
  {
    return { this->At(corners[k]), this->At(corners[(k + 1) % 3]) };
  }
  /** From the line, in the direction across. */
  double Beyond(const Place& place) const
  {
    const double beyond = place[this->Across] - this->Middle;
    return std::abs(beyond) > this->Near ? beyond : 0.0;
  }

  void Cut(std::size_t t)
  {
    const Corners corners = this->CornersOf(t);
    Corners onSides{ -1, -1, -1 };
    std::array<double, 3> lengths{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Side side = this->SideOf(corners, k);
      const bool isShared = this->Sides.count({ side.second, side.first }) > 0;
      const bool crosses = this->Beyond(side.first) * this->Beyond(side.second) < 0.0;
      onSides[k] = isShared && crosses ? this->PointOn(side) : -1;
      lengths[k] = sb::Length(
        sb::Difference(this->Coordinates(corners[k]), this->Coordinates(corners[(k + 1) % 3])));
    }
    if (onSides == Corners{ -1, -1, -1 })
    {
      this->SetTriangle(t, corners);
      return;
    }
    bool isFirst = true;
    sb::CutTriangle(corners, onSides, lengths, [&](const Corners& part) {
      const std::size_t place = isFirst ? t : this->Surface.FaceId.size();
      if (!isFirst)
      {
        this->Surface.FaceId.push_back(this->Face);
        this->Surface.Triangles.resize(3 * this->Surface.FaceId.size());
      }
      isFirst = false;
      this->SetTriangle(place, part);
    });
  }

  sb::Real3 Coordinates(std::int32_t point) const
  {
    const double* const x = this->Surface.Points.data() + 3 * static_cast<std::size_t>(point);
    return { x[0], x[1], x[2] };
  }

  /** On the patch, where the line crosses a side; the same from both of its facets. */
  std::int32_t PointOn(Side side)
  {
    if (side.second < side.first)
    {
      std::swap(side.first, side.second);
    }
    const auto known = this->NewPoints.find(side);
    if (known != this->NewPoints.end())
    {
      return known->second;
    }
    const double first = this->Beyond(side.first);
    const double share = first / (first - this->Beyond(side.second));
    Place uv;
    uv[this->Across] = this->Middle;
    const std::size_t along = 1 - this->Across;
    uv[along] = side.first[along] + share * (side.second[along] - side.first[along]);
    const sb::NURBSSurface& patch = this->Surface.Patches[static_cast<std::size_t>(this->Face)];
    return this->NewPoints[side] =
             this->AddPoint(sb::EvaluatePatch(patch, uv[0], uv[1], 0).Point, uv);
  }

  std::int32_t AddPoint(const sb::Real3& x, const Place& uv)
  {
    this->Surface.Points.insert(this->Surface.Points.end(), x.begin(), x.end());
    this->Surface.UV.insert(this->Surface.UV.end(), uv.begin(), uv.end());
    return static_cast<std::int32_t>(this->Surface.UV.size() / 2) - 1;
  }

  /** What is beyond the middle is on the copy of the patch, and has points of its own. */
  void SetTriangle(std::size_t t, Corners corners)
  {
    const double beyond = this->Beyond(this->At(corners[0])) + this->Beyond(this->At(corners[1])) +
      this->Beyond(this->At(corners[2]));
    if (beyond > 0.0)
    {
      this->Surface.FaceId[t] = static_cast<std::int32_t>(this->Surface.Patches.size()) - 1;
      std::transform(corners.begin(), corners.end(), corners.begin(),
        [this](std::int32_t point) { return this->CopyOf(point); });
    }
    std::copy(corners.begin(), corners.end(),
      this->Surface.Triangles.begin() + static_cast<std::ptrdiff_t>(3 * t));
  }

  std::int32_t CopyOf(std::int32_t point)
  {
    const auto known = this->Copies.find(point);
    return known != this->Copies.end()
      ? known->second
      : this->Copies[point] = this->AddPoint(this->Coordinates(point), this->At(point));
  }

  sb::DesignedSurface& Surface;
  const std::int32_t Face;
  const std::size_t Across; ///< 0: the line is one of constant u
  double Middle = 0.0;
  double Near = 0.0;
  std::set<Side> Sides; ///< of all facets of the face
  std::map<Side, std::int32_t> NewPoints;
  std::map<std::int32_t, std::int32_t> Copies;
};

} // namespace

sb::DesignedSurface HalveFaces(
  const sb::DesignedSurface& surface, const std::vector<FaceToHalve>& faces)
{
  sb::DesignedSurface halved = surface;
  for (const FaceToHalve& face : faces)
  {
    Halving(halved, face).Run();
  }
  return halved;
}

} // namespace sbvtk
