// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SectionRequest.h
 * @brief What sections of a cloud's surface with a mesh or with patches are asked for with.
 */
#ifndef sb_SectionRequest_h
#define sb_SectionRequest_h

namespace sb
{

struct SectionRequest
{
  double Spacing = 0.0; ///< of the cloud, positive
  double ChordError = 0.0; ///< how far the curve may be from a segment, positive
};

} // namespace sb

#endif
