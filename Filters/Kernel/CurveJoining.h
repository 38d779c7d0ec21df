// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveJoining.h
 * @brief The intersection curves of an arrangement, joined end to end.
 *
 * A curve is where surfaces of different operands (or sheets of one operand cut against itself)
 * meet and part again: the inside of an area where they coincide has none, its outline has. Curves
 * end where more or fewer than two segments meet; closed ones end where they start.
 */
#ifndef sb_CurveJoining_h
#define sb_CurveJoining_h

#include "Arrangement.h"
#include "Boolean.h"

namespace sb
{

Curves JoinCurves(const Scene& scene, const Arrangement& cuts);

} // namespace sb

#endif
