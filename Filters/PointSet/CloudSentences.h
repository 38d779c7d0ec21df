// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudSentences.h
 * @brief What is wrong with a cloud, in one plain sentence: what, where, and what to do.
 */
#ifndef CloudSentences_h
#define CloudSentences_h

#include "CloudSurface.h"

#include <string>

namespace sbvtk
{

/** The value of vtkPointSetSurfaceFilter::StatusType for it. */
int StatusOf(sb::CloudStatus status);

/** A number with three digits. */
std::string Text(double value);

/** A share as whole per cent, or "less than 1 %". */
std::string PercentOf(double share);

/** How much of it is thinner than its width allows, as the beginning of a sentence. */
std::string ThinPartsOf(const sb::CloudSurface& cloud);

/** Why a cloud has no surface; empty if it has one. */
std::string RefusalOf(const sb::CloudSurface& cloud, std::int64_t numberOfPoints);

} // namespace sbvtk

#endif
