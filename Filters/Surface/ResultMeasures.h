// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ResultMeasures.h
 * @brief The volume and the area of the result, from the kernel's answer in double precision.
 */
#ifndef ResultMeasures_h
#define ResultMeasures_h

#include "OperandSurface.h"

#include <memory>
#include <vector>

namespace sbvtk
{

struct ResultMeasures
{
  double Volume = 0.0; ///< unit cubed; without meaning where the result is open
  double Area = 0.0; ///< unit squared
};

/** The same to the last bit for every number of threads: sums of fixed blocks, added in their
 * order. */
ResultMeasures MeasureResult(const std::vector<std::shared_ptr<OperandSurface>>& operands,
  const sb::BooleanResult& result, sb::Executor& executor);

} // namespace sbvtk

#endif
