// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelExecutor.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <string>

namespace sbvtk
{

namespace
{
using Clock = std::chrono::steady_clock;

/** How often somebody who listens to the filter is asked whether to go on. */
constexpr std::chrono::milliseconds Beat(100);

/** The monitor of the kernel that this thread runs, if any. */
thread_local KernelMonitor* Listening = nullptr;
}

int KernelExecutor::NumberOfThreads() const
{
  return std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
}

void KernelExecutor::For(std::int64_t count, std::int64_t grain,
  const std::function<void(std::int64_t, std::int64_t)>& body)
{
  grain = std::max<std::int64_t>(1, grain);
  const std::int64_t numberOfRanges = (count + grain - 1) / grain;
  std::atomic<std::int64_t> nextRange{ 0 };
  std::exception_ptr failure;
  std::mutex failureGuard;

  Clock::time_point pause;
  const auto takeRanges = [&](vtkIdType, vtkIdType) {
    for (std::int64_t range = nextRange++; range < numberOfRanges; range = nextRange++)
    {
      try
      {
        body(range * grain, std::min(count, (range + 1) * grain));
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(failureGuard);
        failure = failure ? failure : std::current_exception();
        nextRange = numberOfRanges;
      }
      if (Clock::now() >= pause)
      {
        return;
      }
    }
  };

  // One task a thread, which takes ranges until none is left: the queue of vtkSMPTools costs more
  // than a small range. Where somebody listens all tasks pause now and then, because only this
  // thread, which waits for them, may ask whether to stop.
  const std::int64_t numberOfTasks =
    std::min<std::int64_t>(this->NumberOfThreads(), numberOfRanges);
  do
  {
    pause = Listening ? Clock::now() + Beat : Clock::time_point::max();
    if (numberOfTasks > 1)
    {
      vtkSMPTools::For(0, numberOfTasks, 1, takeRanges);
    }
    else
    {
      takeRanges(0, 1);
    }
    if (Listening)
    {
      Listening->Aborted();
    }
  } while (nextRange < numberOfRanges);
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

void RunWithThreads(int numberOfThreads, const std::function<void()>& work)
{
  std::string backend = vtkSMPTools::GetBackend();
  if (numberOfThreads == 1)
  {
    backend = "Sequential";
  }
  else if (backend == "Sequential")
  {
    backend = "STDThread";
  }
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ std::max(0, numberOfThreads), backend, false }, [&work]() { work(); });
}

KernelMonitor::KernelMonitor(vtkAlgorithm* filter, double first, double last)
  : Filter(filter)
  , First(first)
  , Last(last)
  , Owner(std::this_thread::get_id())
  , Before(Listening)
  , LastBeat(Clock::now())
{
  Listening = this;
}

KernelMonitor::~KernelMonitor() { Listening = this->Before; }

void KernelMonitor::Progress(double fraction, const char* stage)
{
  this->Filter->SetProgressText(stage);
  this->Filter->UpdateProgress(this->First + fraction * (this->Last - this->First));
}

bool KernelMonitor::Aborted()
{
  // vtkAlgorithm::CheckAbort writes to the whole pipeline above it, so only the thread that runs
  // the filter may call it.
  if (std::this_thread::get_id() == this->Owner)
  {
    const Clock::time_point now = Clock::now();
    if (now - this->LastBeat >= Beat)
    {
      this->LastBeat = now;
      this->Filter->UpdateProgress(this->Filter->GetProgress());
    }
    if (this->Filter->CheckAbort())
    {
      this->Stop = true;
    }
  }
  return this->Stop;
}

} // namespace sbvtk
