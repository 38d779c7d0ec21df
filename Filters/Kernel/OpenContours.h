// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpenContours.h
 * @brief Joins or removes contours that are not closed, because the surface is not.
 *
 * After D. Gobbi's vtkClipClosedSurface ("VTK/Closed Surface Clipping", 2010, "Handling non-closed
 * inputs"): a new segment must lie on the hull of all points of all contours in the plane, run
 * counter-clockwise around it, and be the shortest of those; a contour whose ends find none is
 * removed. Loose ends are thus taken to come from contours that run into the bounds of the data.
 */
#ifndef sb_OpenContours_h
#define sb_OpenContours_h

#include "CapContours.h"

namespace sb
{

/** Close what can be closed of a contour in a plane, and take the rest out. Closed contours cost
 * one pass. */
OpenContourCount CloseContour(const ClipPoints& points, std::int32_t plane, Contour& contour);

/** Where a joining segment of a plane's contour crosses another plane: the common line's point next
 * to it. */
std::int32_t CrossingOfJoin(
  ClipPoints& points, const Segment& segment, std::int32_t plane, std::int32_t other);

} // namespace sb

#endif
