// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleRuns.h
 * @brief A surface's triangles in runs of up to eight that lie together, and a hierarchy of these.
 *
 * Most meshes list neighbours one after the other. Then the runs are as the mesh has them, and
 * little is left to sort. Triangles of other meshes are sorted along a curve first.
 */
#ifndef sb_TriangleRuns_h
#define sb_TriangleRuns_h

#include "BVH.h"
#include "EightBoxes.h"
#include "Executor.h"
#include "Scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** What is known of a run. */
struct TriangleRun
{
  EightBoxes Boxes; ///< of its triangles, in a frame that all runs share
  Box Bounds; ///< on the lattice
  std::array<float, 3> Normal; ///< about the sum of its triangles'
  std::int32_t First; ///< its first face's place in the list of faces
  std::int32_t Size;
  std::uint8_t Views; ///< that all its triangles face (PatchOutline.h)
};

class TriangleRuns
{
public:
  static constexpr std::int32_t MostFaces = EightBoxes::Width;

  /** Of the scene's one operand, but for the faces marked in `leftOut`, which may be empty. */
  TriangleRuns(const Scene& scene, const std::vector<std::uint8_t>& leftOut, Executor& executor);

  /** Of the runs' boxes; a run goes by its place there. */
  const BVH& Tree() const { return this->Hierarchy; }

  std::int32_t Count() const { return this->Hierarchy.Size(); }
  const TriangleRun& operator[](std::int32_t place) const
  {
    return *this->ByPlace[std::size_t(place)];
  }
  /** As many faces as the run's size. */
  const std::int32_t* FacesOf(std::int32_t place) const
  {
    return this->Faces.data() + (*this)[place].First;
  }
  /** The place of a face's run; -1 for those left out. */
  std::int32_t PlaceOf(std::int32_t face) const { return this->Places[std::size_t(face)]; }

private:
  void ListFaces(const std::vector<std::uint8_t>& leftOut);
  void SortFaces();
  std::size_t MakeRuns();
  void MakeRunsOfPart(std::int32_t begin, std::int32_t end, std::vector<TriangleRun>& runs) const;
  void Add(std::int32_t face, const Box& box, TriangleRun& run) const;
  FloatBox ToFrame(const Box& box) const;
  Box BoxOf(std::int32_t face) const;
  void BuildTree();
  void NotePlaces();

  const Scene& World;
  Executor& Threads;
  std::vector<std::int32_t> Faces; ///< run after run
  std::vector<std::vector<TriangleRun>> Parts;
  std::vector<const TriangleRun*> ByPlace;
  std::vector<std::int32_t> Places; ///< [face]
  double Middle[3]; ///< of the frame of the runs' boxes
  BVH Hierarchy;
};

} // namespace sb

#endif
