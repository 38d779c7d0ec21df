// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainSheets.h
 * @brief Parts of a surface that certainly do not meet themselves.
 *
 * Runs of triangles that face one view and hang together make a sheet. If its outline encloses
 * every place of the view once (PatchOutline.h), none of its triangles have to be compared with
 * each other. Smooth surfaces consist of few sheets, so that only triangles along their borders are
 * left. A sheet that does not pass is cut along the hierarchy of the runs, and its parts are tried.
 */
#ifndef sb_PlainSheets_h
#define sb_PlainSheets_h

#include "Executor.h"
#include "MeshEdges.h"
#include "PatchOutline.h"
#include "TriangleRuns.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace sb
{

class PlainSheets
{
public:
  PlainSheets(const TriangleRuns& runs, const Scene& scene,
    const std::vector<std::int32_t>& corners, const MeshEdges& edges, Executor& executor);

  /** Whether two runs, by their places, are on one sheet. */
  bool AreTogether(std::int32_t place, std::int32_t other) const
  {
    const std::int32_t sheet = this->Sheets[std::size_t(place)];
    return sheet >= 0 && sheet == this->Sheets[std::size_t(other)];
  }

  /** Whether all runs of a group of level 0 and of a node are on one sheet. */
  bool AreTogether(std::int32_t group, std::int32_t level, std::int32_t index) const
  {
    const std::int32_t sheet = this->OfNodes[0][std::size_t(group)];
    return sheet >= 0 && sheet == this->OfNodes[std::size_t(level)][std::size_t(index)];
  }

private:
  /** An edge on the border of a sheet, and that sheet. */
  struct Border
  {
    std::int32_t Sheet;
    OutlineEdge Edge;
  };

  /** The runs beside some that follow each other; -1 for nothing. */
  struct NeighbourList
  {
    std::vector<std::int32_t> Places; ///< run after run
    std::vector<std::int32_t> Ends; ///< [run]
  };

  void ChooseViews();
  void FindNeighbours();
  void TryParts(std::int32_t level);
  void JoinRuns(std::int32_t level);
  std::vector<Border> ListBorders();
  void Judge(const std::vector<Border>& borders);
  void MarkNodes();
  template <class Visit>
  void ForEachRun(Visit&& visit);
  template <class Test>
  bool AllNeighbours(std::int32_t place, Test&& test) const;
  template <class Visit>
  void ForEachHalfEdge(std::int32_t place, Visit&& visit) const;

  const TriangleRuns& Runs;
  const Scene& World;
  const std::vector<std::int32_t>& Corners;
  const MeshEdges& Edges;
  Executor& Threads;
  std::vector<NeighbourList> Neighbours; ///< [part of the runs]
  std::vector<std::int8_t> Views; ///< [place] the view that a run is seen in, or -1
  std::vector<std::int32_t> Tried; ///< [place] the sheet that a run may be on, or -1
  std::vector<std::int32_t> Sheets; ///< [place] the sheet that it is on, or -1
  std::vector<std::vector<std::int32_t>> OfNodes; ///< [level][node] that of all its runs, or -1
};

} // namespace sb

#endif
