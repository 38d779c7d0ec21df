// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TrimmedDomain.h
 * @brief The part of a patch's domain that its face uses: what the face's facets cover.
 *
 * Its border are the edges that one facet alone uses. Questions about it are answered on a lattice
 * of 2^28 steps, exactly, with the border shifted by less than any step (Edelsbrunner and Muecke
 * 1990), so that a curve through a corner of the border crosses it once, as every other curve does.
 */
#ifndef sb_TrimmedDomain_h
#define sb_TrimmedDomain_h

#include "DesignedSurface.h"
#include "PatchBounds.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

using Parameters = std::array<double, 2>; ///< u and v

class TrimmedDomain
{
public:
  /** A piece of the border, with the domain on its left if that is where facets' fronts are. */
  struct Edge
  {
    Parameters From;
    Parameters To;
    std::int32_t FromPoint; ///< of the designed surface
    std::int32_t ToPoint;
  };

  /** @param triangles of one face, their numbers in the designed surface */
  TrimmedDomain(const DesignedSurface& designed, const std::vector<std::int32_t>& triangles);

  /** Around the domain, a little larger, and not by the same amount on all sides. */
  const ParameterBox& Box() const { return this->Around; }

  /** Whether facets are turned over against the normal S_u x S_v. */
  bool IsReversed() const { return this->Area < 0.0; }

  const std::vector<Edge>& Border() const { return this->Edges; }

  bool Contains(const Parameters& at) const;

  /** Whether a rectangle may meet the domain. */
  bool MayMeet(const ParameterBox& box) const;

  struct Crossing
  {
    std::size_t Edge; ///< number in Border()
    double Along; ///< where on the segment, from 0 to 1
    double AlongEdge; ///< where on the edge
  };

  /** The edges that the segment crosses, in their order along it. */
  std::vector<Crossing> CrossingsOf(const Parameters& from, const Parameters& to) const;

private:
  struct LatticePoint
  {
    std::int64_t U;
    std::int64_t V;
  };

  void FindBorder(const DesignedSurface& designed, const std::vector<std::int32_t>& triangles);
  void OpenPoles(const NURBSSurface& patch);
  void MakeBox(const DesignedSurface& designed, const std::vector<std::int32_t>& triangles);
  void SortIntoRows();
  LatticePoint Snap(const Parameters& at) const;
  std::size_t RowOf(std::int64_t v) const;
  static int SideOf(const LatticePoint& a, const LatticePoint& b, const LatticePoint& border);
  bool Crosses(const LatticePoint& a, const LatticePoint& b, std::size_t edge) const;

  /** Call visit(edge) once for each edge whose box meets the one between two points. */
  template <class Visit>
  void ForEdges(const LatticePoint& lower, const LatticePoint& upper, const Visit& visit) const;

  std::vector<Edge> Edges;
  std::vector<std::array<LatticePoint, 2>> Snapped; ///< of edges
  std::vector<std::vector<std::int32_t>> Rows; ///< edges that reach into a row
  ParameterBox Around;
  double Area = 0.0; ///< of the facets in u and v, with sign
};

} // namespace sb

#endif
