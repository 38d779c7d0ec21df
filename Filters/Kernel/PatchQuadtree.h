// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchQuadtree.h
 * @brief The cells of a patch's domain, small in space, where a cloud is near: a quadtree whose
 * nodes are dropped where no sample is near, and split until they are small (Yang and Qian 2009).
 *
 * A node is dropped or kept by bounds that hold (PatchBounds.h), so nothing of the patch is missed.
 * Neighbours differ by one level at most, and the ring around a cell goes through the corners of
 * its smaller neighbours, so that no curve ends between a large cell and two small ones.
 */
#ifndef sb_PatchQuadtree_h
#define sb_PatchQuadtree_h

#include "Executor.h"
#include "PointTree.h"
#include "TrimmedDomain.h"

#include <cstdint>
#include <vector>

namespace sb
{

class PatchQuadtree
{
public:
  struct Request
  {
    double Reach; ///< how far from a sample a cell can be and still matter
    double Longest; ///< parameter lines of a cell are not longer
  };

  PatchQuadtree(const NURBSSurface& patch, const TrimmedDomain& domain, const PointTree& samples,
    const Request& request, Executor& executor, Monitor& monitor);

  /** Cut these cells into four, and those beside them that are much larger. */
  void Halve(const std::vector<std::uint8_t>& isChosen);

  std::size_t NumberOfCells() const { return this->Cells.size(); }
  std::size_t NumberOfVertices() const { return this->Vertices.size(); }
  Parameters ParametersOf(std::size_t vertex) const;
  ParameterBox BoxOf(std::size_t cell) const { return this->BoxOf(this->Cells[cell]); }

  /** The vertices around a cell, counter-clockwise from its lower corner; four, and those of
   * smaller neighbours between them. */
  void RingOf(std::size_t cell, std::vector<std::size_t>& ring) const;

private:
  /** Its lower corner, in steps of the finest level. */
  struct Cell
  {
    std::uint32_t U;
    std::uint32_t V;
    std::uint32_t Level;
  };
  enum class Verdict : std::uint8_t
  {
    Empty,
    Small,
    Split
  };

  void ChooseRoots();
  void Subdivide();
  void Balance();
  void ListVertices();
  ParameterBox BoxOf(const Cell& cell) const;
  Verdict Judge(const Cell& cell) const;
  void AddSide(std::uint64_t from, std::uint64_t to, std::vector<std::size_t>& ring) const;

  const NURBSSurface& Patch;
  const TrimmedDomain& Domain;
  const PointTree& Samples;
  const Request Wanted;
  Executor& Threads;
  Monitor& Watch;
  std::uint32_t RootsU = 1;
  std::uint32_t RootsV = 1;
  std::vector<Cell> Cells;
  std::vector<std::uint64_t> Vertices; ///< v and u in steps, sorted
};

} // namespace sb

#endif
