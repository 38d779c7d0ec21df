// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FacePoints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>

namespace sb
{
namespace
{

constexpr double Rounding = 1e-9; ///< of the domain: what is nearer is one place
constexpr double None = std::numeric_limits<double>::quiet_NaN();

class FaceSeparation
{
public:
  FaceSeparation(const CombinedMesh& mesh, const ToolSurface& tool)
    : Mesh(mesh)
    , Tool(tool)
    , IsUsed(static_cast<std::size_t>(mesh.NumberOfPoints()), 0)
  {
    this->Found.Triangles = mesh.Triangles;
    this->Found.TriangleOnFace.assign(this->IsUsed.size(), -1);
    this->Found.UV.assign(this->IsUsed.size(), { None, None });
    this->Found.IsExact.assign(this->IsUsed.size(), 1);
  }

  /** First the corners whose parameters are known, then those to which triangles were extended. */
  FacePoints Run()
  {
    std::vector<std::size_t> others;
    for (std::size_t corner = 0; corner < this->Mesh.Triangles.size(); ++corner)
    {
      std::array<double, 2> uv{ None, None };
      if (this->TriangleOf(corner) < 0 || this->KnownParameters(corner, uv))
      {
        this->Place(corner, uv, true);
      }
      else
      {
        others.push_back(corner);
      }
    }
    for (const std::size_t corner : others)
    {
      const Real3 place = this->Mesh.Point(this->Mesh.Triangles[corner]);
      this->Place(
        corner, this->Tool.ParametersOf(this->Parent(this->TriangleOf(corner)), place), false);
    }
    return std::move(this->Found);
  }

private:
  std::int32_t Parent(std::int32_t triangle) const
  {
    return this->Mesh.Parent[static_cast<std::size_t>(triangle)];
  }

  /** Of a triangle of the mesh, or of -1. */
  std::int32_t FaceOf(std::int32_t triangle) const
  {
    return triangle < 0 || this->Mesh.Source[static_cast<std::size_t>(triangle)] == 0
      ? -1
      : this->Tool.Body().FaceId[static_cast<std::size_t>(this->Parent(triangle))];
  }

  /** The triangle that a corner is of, or -1 if that is on no face. */
  std::int32_t TriangleOf(std::size_t corner) const
  {
    const std::int32_t t = static_cast<std::int32_t>(corner / 3);
    return this->FaceOf(t) >= 0 ? t : -1;
  }

  /** Those of the corner of the tool's triangle in this place, if it has one. */
  bool KnownParameters(std::size_t corner, std::array<double, 2>& uv) const
  {
    const DesignedSurface& body = this->Tool.Body();
    const std::int32_t* const ids =
      body.Triangles.data() + 3 * static_cast<std::size_t>(this->Parent(this->TriangleOf(corner)));
    const Real3 place = this->Mesh.Point(this->Mesh.Triangles[corner]);
    const std::int32_t* const found =
      std::find_if(ids, ids + 3, [&](std::int32_t id) { return this->Tool.Point(id) == place; });
    if (found == ids + 3)
    {
      return false;
    }
    std::copy_n(body.UV.data() + 2 * static_cast<std::size_t>(*found), 2, uv.begin());
    return true;
  }

  /** How far two places of the domain are apart, in domains. */
  double Distance(
    std::int32_t triangle, const std::array<double, 2>& a, const std::array<double, 2>& b) const
  {
    const NURBSSurface& patch = this->Tool.PatchOf(this->Parent(triangle));
    return std::max(std::abs(a[0] - b[0]) / (patch.LastU() - patch.FirstU()),
      std::abs(a[1] - b[1]) / (patch.LastV() - patch.FirstV()));
  }

  bool Fits(
    std::int32_t point, std::int32_t triangle, const std::array<double, 2>& uv, bool known) const
  {
    const std::size_t i = static_cast<std::size_t>(point);
    if (this->FaceOf(this->Found.TriangleOnFace[i]) != this->FaceOf(triangle) || triangle < 0)
    {
      return this->Found.TriangleOnFace[i] < 0 && triangle < 0;
    }
    return known ? this->Distance(triangle, this->Found.UV[i], uv) < Rounding
                 : !AreFarApart(this->Tool.PatchOf(this->Parent(triangle)), this->Found.UV[i], uv);
  }

  /** Give the corner the nearest of the points at its place that fit, or a new one. */
  void Place(std::size_t corner, const std::array<double, 2>& uv, bool known)
  {
    const std::int32_t first = this->Mesh.Triangles[corner];
    const std::int32_t triangle = this->TriangleOf(corner);
    if (!this->IsUsed[static_cast<std::size_t>(first)])
    {
      this->IsUsed[static_cast<std::size_t>(first)] = 1;
      this->Found.TriangleOnFace[static_cast<std::size_t>(first)] = triangle;
      this->Found.UV[static_cast<std::size_t>(first)] = uv;
      this->Found.IsExact[static_cast<std::size_t>(first)] = known ? 1 : 0;
      return;
    }
    const auto distance = [&](std::int32_t point) {
      return this->Distance(triangle, this->Found.UV[static_cast<std::size_t>(point)], uv);
    };
    std::int32_t best = this->Fits(first, triangle, uv, known) ? first : -1;
    if (const auto copies = this->Copies.find(first); copies != this->Copies.end())
    {
      for (const std::int32_t copy : copies->second)
      {
        if (this->Fits(copy, triangle, uv, known) &&
          (best < 0 || (triangle >= 0 && distance(copy) < distance(best))))
        {
          best = copy;
        }
      }
    }
    this->Found.Triangles[corner] = best >= 0 ? best : this->Repeat(first, triangle, uv, known);
  }

  std::int32_t Repeat(
    std::int32_t first, std::int32_t triangle, const std::array<double, 2>& uv, bool known)
  {
    const std::int32_t copy = static_cast<std::int32_t>(this->Found.UV.size());
    this->Found.Repeated.push_back(first);
    this->Found.TriangleOnFace.push_back(triangle);
    this->Found.UV.push_back(uv);
    this->Found.IsExact.push_back(known ? 1 : 0);
    this->Copies[first].push_back(copy);
    return copy;
  }

  const CombinedMesh& Mesh;
  const ToolSurface& Tool;
  std::vector<std::uint8_t> IsUsed;
  std::map<std::int32_t, std::vector<std::int32_t>> Copies; ///< of a point
  FacePoints Found;
};

} // namespace

FacePoints FindFacePoints(const CombinedMesh& mesh, const ToolSurface& tool)
{
  return FaceSeparation(mesh, tool).Run();
}

} // namespace sb
