// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutputAssembly.h
 * @brief Numbers the points of the result, and rounds the new ones to doubles: the only rounding
 * there is.
 *
 * An input point that a kept triangle or a piece of its own operand uses is copied. Every other
 * corner of a piece is interpolated on the piece's face. Two pieces share an interpolated point if
 * it is the same node and lies on the same edge (the same two input points) or in the same face: so
 * points that the input has twice, to carry two normals along a crease, are made twice along a cut
 * of that crease (Quammen, Weigle and Taylor 2011, section 5.1).
 */
#ifndef sb_OutputAssembly_h
#define sb_OutputAssembly_h

#include "Arrangement.h"
#include "Boolean.h"
#include "Classification.h"

namespace sb
{

/** Fill the result. An operand whose Fates are empty has no part in it. */
void AssembleOutput(const Scene& scene, const Arrangement& cuts, Classification&& classes,
  SeamPoints seams, CutSurfaces& result, Executor& executor);

/** Whether the assembly gives out a face of the arrangement as pieces: one that is a single piece
 * stays a whole triangle. */
inline bool IsGivenAsPieces(const Arrangement& cuts, std::size_t cutFace)
{
  return cuts.EndOfPieces(cutFace) - cuts.Faces[cutFace].FirstPiece > 1;
}

/** The place of a node in the caller's unit; an input vertex keeps its bytes. */
std::array<double, 3> PlaceOfNode(const Scene& scene, const PointTable& nodes, NodeId node);

} // namespace sb

#endif
