// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CADSession.h
 * @brief Open CASCADE as a guest: it says nothing, its exceptions and signals become sentences, it
 * hears of progress and abort, and it leaves the process as it found it.
 *
 * Its settings are global and its parts are not made for two threads, so one session runs at a
 * time.
 */
#ifndef CADSession_h
#define CADSession_h

#include "Executor.h"

#include <Message_ProgressRange.hxx>

#include <functional>
#include <string>

namespace sbvtk
{

enum class CADStatus
{
  Ok,
  Aborted,
  OutOfMemory,
  Failed
};

struct CADOutcome
{
  CADStatus Status = CADStatus::Ok;
  std::string Reason; ///< in Open CASCADE's words, if it failed
};

/**
 * Run `work`, which is given its share of the progress. It ends early, with Aborted, soon after
 * monitor.Aborted() says so.
 * @param stage what is told with the progress
 */
CADOutcome RunCAD(sb::Monitor& monitor, double first, double last, const char* stage,
  const std::function<void(const Message_ProgressRange&)>& work);

} // namespace sbvtk

#endif
