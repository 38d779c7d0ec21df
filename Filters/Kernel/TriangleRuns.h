// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleRuns.h
 * @brief A surface's triangles by eights that lie together, with their boxes, and a hierarchy of
 * these runs.
 *
 * Most meshes list neighbours one after the other. Then the runs are as the mesh has them, and an
 * eighth as many boxes are sorted. Triangles of other meshes are sorted along a curve first.
 */
#ifndef sb_TriangleRuns_h
#define sb_TriangleRuns_h

#include "BVH.h"
#include "EightBoxes.h"
#include "Executor.h"
#include "PatchOutline.h"
#include "Scene.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace sb
{

class TriangleRuns
{
public:
  static constexpr std::int32_t Width = EightBoxes::Width;

  /** Of the scene's one operand, but for the faces marked in `leftOut`, which may be empty. */
  TriangleRuns(const Scene& scene, const std::vector<std::uint8_t>& leftOut, Executor& executor);

  /** Of the runs' boxes; a run goes by its place there. */
  const BVH& Tree() const { return this->Hierarchy; }

  const std::int32_t* FacesOf(std::int32_t place) const
  {
    return this->Faces.data() + Width * std::size_t(this->RunAt(place));
  }
  /** Eight but for one run. */
  std::int32_t NumberOfFaces(std::int32_t place) const
  {
    return std::min(
      Width, static_cast<std::int32_t>(this->Faces.size()) - Width * this->RunAt(place));
  }
  const EightBoxes& BoxesOf(std::int32_t place) const
  {
    return this->Boxes[std::size_t(this->RunAt(place))];
  }
  /** The views that all triangles of a run face (PatchOutline.h). */
  std::uint8_t ViewsOf(std::int32_t place) const
  {
    return this->Views[std::size_t(this->RunAt(place))];
  }
  /** About the sum of its triangles' normals. */
  const std::array<float, 3>& NormalOf(std::int32_t place) const
  {
    return this->Normals[std::size_t(this->RunAt(place))];
  }
  /** The place of a face's run; -1 for those left out. */
  std::int32_t PlaceOf(std::int32_t face) const { return this->Places[std::size_t(face)]; }

private:
  /** How far triangles and runs reach, added up. */
  struct Lengths
  {
    double Triangles = 0.0;
    double Runs = 0.0;
  };

  std::int32_t RunAt(std::int32_t place) const
  {
    return this->Hierarchy.Order()[std::size_t(place)];
  }
  std::int32_t NumberOfRuns() const
  {
    return (static_cast<std::int32_t>(this->Faces.size()) + Width - 1) / Width;
  }
  void ListFaces(const std::vector<std::uint8_t>& leftOut);
  void SortFaces();
  Lengths MakeRuns(Box* boxes);
  Lengths MakeRun(std::int32_t run, Box& total);
  Box BoxOf(std::int32_t face) const;
  void AddNormal(std::int32_t face, std::array<float, 3>& sum) const;
  FloatBox ToFrame(const Box& box) const;
  void NotePlaces();

  const Scene& World;
  Executor& Threads;
  std::vector<std::int32_t> Faces; ///< run after run
  std::unique_ptr<EightBoxes[]> Boxes; ///< [run] relative to Middle
  std::unique_ptr<std::uint8_t[]> Views; ///< [run]
  std::unique_ptr<std::array<float, 3>[]> Normals; ///< [run]
  std::vector<std::int32_t> Places; ///< [face]
  double Middle[3];
  BVH Hierarchy;
};

} // namespace sb

#endif
