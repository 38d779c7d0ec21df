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

/** Fill the Fates, PointMap, KeptPoints, Interpolated and Split of the result. */
void AssembleOutput(const Scene& scene, const Arrangement& cuts, Classification&& classes,
  SeamPoints seams, BooleanResult& result, Executor& executor);

/** The place of a node in the caller's unit; an input vertex keeps its bytes. */
std::array<double, 3> PlaceOfNode(const Scene& scene, const PointTable& nodes, NodeId node);

} // namespace sb

#endif
