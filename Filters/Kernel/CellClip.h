// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellClip.h
 * @brief Clips a flat polygon by way of its triangles, and puts what is left together again.
 *
 * A polygon of the input comes as triangles. If they lie exactly in one plane, the edges between
 * them mean nothing: what is left of the triangles is united, along those edges, to the outline of
 * what is left of the polygon, and points that planes make on them are taken out of outline and
 * contours. So the polygon may be concave, stays one through all planes, and becomes triangles at
 * the end, as few as can be.
 */
#ifndef sb_CellClip_h
#define sb_CellClip_h

#include "FaceClip.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

/** A side of an outline, in the polygon's orientation. */
struct CellSide
{
  FaceClip::Corner From;
  FaceClip::Corner To;
};

class CellClip
{
public:
  CellClip(ClipPoints& points, FaceClip& clip)
    : Points(points)
    , Clip(clip)
  {
  }

  /** Whether the triangles [first, last) lie exactly in one plane, all of one orientation. */
  bool IsFlat(std::int32_t first, std::int32_t last) const;

  /**
   * Clip a flat polygon.
   * @param faces those of its triangles that are not dropped
   * @param first, last all of its triangles
   * @param contours as in FaceClip::Clip
   * @return the sides of what is left, in no order. Valid until the next call.
   */
  const std::vector<CellSide>& Run(const std::vector<std::int32_t>& faces, std::int32_t first,
    std::int32_t last, std::vector<Contour>& contours);

private:
  using Edge = std::array<std::int32_t, 2>;

  void FindDiagonals(std::int32_t first, std::int32_t last);
  bool IsOnDiagonal(std::int32_t instance) const;
  bool IsStraight(const CellSide& side, const CellSide& next) const;
  void CancelSides();
  void JoinSides();
  void JoinSegments(Contour& contour) const;

  ClipPoints& Points;
  FaceClip& Clip;
  std::vector<Edge> Diagonals; ///< sorted; the lower vertex first
  std::vector<Contour> Segments; ///< by plane
  std::vector<CellSide> Sides;
};

} // namespace sb

#endif
