// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceMerging.h
 * @brief Makes one surface of the pieces that several processes have of it.
 *
 * A point at a border is in the pieces of both sides. If the coordinates and all arrays agree it
 * becomes one point again; that of another piece with other normals was not one before either.
 * Points that coincide within one piece stay as they are.
 */
#ifndef PieceMerging_h
#define PieceMerging_h

#include "Executor.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace sbvtk
{

/** A piece without the cells and points that another process has, too, and without the marks on
 * them; the piece itself if nothing is marked. */
vtkSmartPointer<vtkPolyData> WithoutGhosts(vtkPolyData* piece);

/** One surface; if only one piece has points, that piece. Each field array is that of the first
 * piece in which it has values. */
vtkSmartPointer<vtkPolyData> MergePieces(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, sb::Executor& executor);

} // namespace sbvtk

#endif
