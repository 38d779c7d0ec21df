// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConditionSentences.h
 * @brief What the kernel remarks, in one plain sentence: what was wrong, where, and what to do.
 */
#ifndef ConditionSentences_h
#define ConditionSentences_h

#include "Boolean.h"
#include "sbSurfaceModule.h" // for the export macro

#include <string>

namespace sbvtk
{

/**
 * @param operandName such as "Input" or "Tool 2"
 * @param cell the cell of the operand's data set at the place, or -1
 */
SBSURFACE_EXPORT std::string ConditionSentence(
  const sb::Remark& remark, const std::string& operandName, std::int64_t cell);

} // namespace sbvtk

#endif
