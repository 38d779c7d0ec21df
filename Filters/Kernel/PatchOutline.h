// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchOutline.h
 * @brief Whether a patch of triangles meets itself, told from its outline alone.
 *
 * Let all triangles of a patch face the viewer along an axis, and none be seen edge-on. How many of
 * them cover a place of the view is then the winding number of the patch's outline about it, for
 * the edges between its triangles cancel. If that is 0 or 1 everywhere, no two triangles cover the
 * same place, so they have but common corners and edges in common, in space as in the view (P.
 * Volino and N. Magnenat-Thalmann, "Efficient self-collision detection on smoothly discretized
 * surface animations using geometrical shape regularity", 1994). An outline of a few hundred edges
 * thus answers for thousands of triangles.
 */
#ifndef sb_PatchOutline_h
#define sb_PatchOutline_h

#include <cstdint>
#include <vector>

namespace sb
{

/** The axes, and which way to look along them, as bits: 2 * axis for triangles whose normal has a
 * positive component, 2 * axis + 1 for a negative one. */
struct View
{
  int Axis;
  bool IsFromBelow;
};

constexpr int NumberOfViews = 6;

inline View ViewOf(int bit) { return { bit / 2, bit % 2 == 1 }; }

/** The views in which a triangle of lattice points faces the viewer; 0 if and only if its corners
 * lie on one line. */
std::uint8_t ViewsFacing(const double* a, const double* b, const double* c);

/** An edge of one triangle of the patch alone, in the triangle's direction. */
struct OutlineEdge
{
  std::int32_t From;
  std::int32_t To;
};

/**
 * Whether an outline winds around each place of the view once or not at all, and meets itself at
 * most in common vertices.
 *
 * @param positions lattice points, three coordinates each
 * @param outline of a patch that faces the viewer
 */
bool EnclosesOnce(const double* positions, const std::vector<OutlineEdge>& outline, View view);

} // namespace sb

#endif
