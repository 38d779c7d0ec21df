// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scene.h
 * @brief All operands on one integer lattice, under one numbering.
 *
 * Vertices and triangles of all operands are numbered through, operand by operand: a *vertex id* is
 * the operand's first vertex id plus the point id in its mesh, a *face id* likewise. Coordinates
 * are integral doubles.
 */
#ifndef sb_Scene_h
#define sb_Scene_h

#include "Boolean.h"
#include "Ingest.h"
#include "Lattice.h"
#include "Predicates.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace sb
{

class Scene
{
public:
  /**
   * Put the operands on the lattice. Operands that are inside out are read with their corners
   * swapped. The request has to outlive the scene, and to have been found good by Ingest.
   */
  Scene(const BooleanRequest& request, const Ingested& ingested, Executor& executor);

  std::int32_t NumberOfOperands() const { return static_cast<std::int32_t>(this->Meshes.size()); }
  std::int32_t NumberOfVertices() const { return this->FirstVertices.back(); }
  std::int32_t NumberOfFaces() const { return this->FirstFaces.back(); }
  std::int32_t FirstVertex(std::int32_t operand) const { return this->FirstVertices[operand]; }
  std::int32_t FirstFace(std::int32_t operand) const { return this->FirstFaces[operand]; }
  const Surface& Mesh(std::int32_t operand) const { return this->Meshes[operand]; }
  Group Side(std::int32_t operand) const { return this->Sides[operand]; }
  const std::array<double, 6>& Bounds(std::int32_t operand) const
  {
    return this->LatticeBounds[operand];
  }
  /** The blocks of an operand's triangles, on the lattice. */
  const std::vector<TriangleBlock>& Blocks(std::int32_t operand) const
  {
    return this->LatticeBlocks[operand];
  }
  const Lattice& Grid() const { return this->Units; }

  std::int32_t OperandOfFace(std::int32_t face) const { return Find(this->FirstFaces, face); }
  std::int32_t OperandOfVertex(std::int32_t vertex) const
  {
    return Find(this->FirstVertices, vertex);
  }

  /** Lattice coordinates of a vertex. */
  const double* Position(std::int32_t vertex) const
  {
    return &this->Coordinates[3 * std::size_t(vertex)];
  }

  /** Vertex ids of a face, in the orientation in which the operand is read. */
  std::array<std::int32_t, 3> Corners(std::int32_t operand, std::int32_t face) const
  {
    const std::int32_t* ids =
      this->Meshes[operand].Triangles + 3 * std::size_t(face - this->FirstFaces[operand]);
    const std::int32_t first = this->FirstVertices[operand];
    return this->Swapped[operand]
      ? std::array<std::int32_t, 3>{ first + ids[0], first + ids[2], first + ids[1] }
      : std::array<std::int32_t, 3>{ first + ids[0], first + ids[1], first + ids[2] };
  }
  std::array<std::int32_t, 3> Corners(std::int32_t face) const
  {
    return this->Corners(this->OperandOfFace(face), face);
  }

  /** The coordinates as the caller gave them. */
  std::array<double, 3> OriginalPosition(std::int32_t vertex) const
  {
    const std::int32_t operand = this->OperandOfVertex(vertex);
    const double* p =
      this->Meshes[operand].Points + 3 * std::size_t(vertex - this->FirstVertices[operand]);
    return { p[0], p[1], p[2] };
  }

  bool IsSwapped(std::int32_t operand) const { return this->Swapped[operand] != 0; }

private:
  static std::int32_t Find(const std::vector<std::int32_t>& firsts, std::int32_t id)
  {
    return static_cast<std::int32_t>(
      std::upper_bound(firsts.begin(), firsts.end(), id) - firsts.begin() - 1);
  }

  void PlacePoints(std::int32_t operand, Executor& executor);
  void PlaceBoxes(const OperandReport& report, std::vector<TriangleBlock> blocks);

  Lattice Units;
  std::vector<Surface> Meshes;
  std::vector<Group> Sides;
  std::vector<std::uint8_t> Swapped;
  std::vector<std::int32_t> FirstVertices; ///< one more than operands
  std::vector<std::int32_t> FirstFaces; ///< one more than operands
  std::unique_ptr<double[]> Coordinates; ///< three a vertex
  std::vector<std::array<double, 6>> LatticeBounds;
  std::vector<std::vector<TriangleBlock>> LatticeBlocks;
};

} // namespace sb

#endif
