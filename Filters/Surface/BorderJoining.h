// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BorderJoining.h
 * @brief Joins the pieces of a surface where they meet.
 *
 * A point at a border is in the pieces of both sides, and not always with the same bytes: a source
 * that makes a sphere in pieces reaches the last meridian by another sum of angles than the first.
 * So points of different pieces are the same if they are as close as rounding brings them, and lie
 * at a border or on no polygon at all; a point inside of a piece has all of its polygons already.
 */
#ifndef BorderJoining_h
#define BorderJoining_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace sbvtk
{

/**
 * Join points of different pieces: if all their arrays agree, too, one of them stands for both;
 * else the later one only takes the place of the other, so that the surface is closed there.
 * @param surface the pieces after one another, its points floats or doubles
 * @param ends the last point plus one of each piece
 */
vtkSmartPointer<vtkPolyData> JoinBorders(vtkPolyData* surface, const std::vector<vtkIdType>& ends);

} // namespace sbvtk

#endif
