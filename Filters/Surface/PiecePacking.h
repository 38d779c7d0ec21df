// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PiecePacking.h
 * @brief Pieces of data as bytes for another process, and back, to the last bit.
 *
 * VTK's own way goes through the format of its legacy files, which cuts ids to 32 bits and renames
 * arrays.
 */
#ifndef PiecePacking_h
#define PiecePacking_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

namespace sbvtk
{

/** What a process has at one place of a data object. */
struct Piece
{
  std::int64_t Place = 0; ///< the same for the pieces of one block in all processes
  int Type = VTK_POLY_DATA; ///< of the data object. Of sets of points that are no surfaces
  vtkSmartPointer<vtkPolyData> Data; ///< has points and point data only; of all others nothing
};

enum class PieceContents
{
  All,
  OnlyArrays ///< names, types and components; no points, no cells, but field data
};

/** Append the pieces to bytes. Arrays of variants are left out. */
void PackPieces(const std::vector<Piece>& pieces, PieceContents contents, std::vector<char>& bytes);

/** The pieces that bytes were made of. */
std::vector<Piece> UnpackPieces(const std::vector<char>& bytes);

} // namespace sbvtk

#endif
