// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages.h"

#include "CollapsedFaces.h"

namespace sb
{

std::vector<TrianglePair> FindNearPairs(
  const Scene& scene, const std::vector<std::uint8_t>& self, Executor& executor, Monitor& monitor)
{
  std::vector<BroadPhaseSurface> surfaces;
  for (std::int32_t i = 0; i < scene.NumberOfOperands(); ++i)
  {
    surfaces.push_back(
      { scene.NumberOfVertices() > 0 ? scene.Position(0) + 3 * std::ptrdiff_t(scene.FirstVertex(i))
                                     : nullptr,
        scene.Mesh(i).Triangles, scene.Mesh(i).NumberOfTriangles, scene.Bounds(i),
        self[std::size_t(i)] != 0, &scene.Blocks(i) });
  }
  return FindOverlappingPairs(surfaces, executor, monitor);
}

ContactSet FindStitchedContacts(const Scene& scene, const std::vector<TrianglePair>& pairs,
  std::vector<std::uint8_t>& collapsed, Executor& executor, Monitor& monitor)
{
  collapsed = FindCollapsedFaces(scene, pairs);
  ContactSet contacts = FindContacts(scene, pairs, collapsed, executor, monitor);
  StitchCollapsedFaces(scene, collapsed, contacts);
  return contacts;
}

bool HasError(const std::vector<Remark>& remarks)
{
  return std::any_of(
    remarks.begin(), remarks.end(), [](const Remark& remark) { return IsError(remark.Condition); });
}

Status GravestCondition(const std::vector<Remark>& remarks)
{
  Status gravest = Status::Ok;
  for (const Remark& remark : remarks)
  {
    gravest = std::max(gravest, remark.Condition);
  }
  return gravest;
}

} // namespace sb
