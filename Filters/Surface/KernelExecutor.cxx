// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "KernelExecutor.h"

#include "ThreadExecutor.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace sbvtk
{

namespace
{
using Clock = std::chrono::steady_clock;

/** How often somebody who listens to the filter is asked whether to go on. */
constexpr std::chrono::milliseconds Beat(100);

/** The monitor of the kernel that this thread runs, if any. */
thread_local KernelMonitor* Listening = nullptr;

/** The threads that work for this one, if any. */
thread_local sb::ThreadExecutor* Workers = nullptr;

/** As many as were asked for, but not more than there are cores; 0 asks for all that VTK may use.
 */
int ThreadsToStart(int asked)
{
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const char* most = std::getenv("VTK_SMP_MAX_THREADS");
  const int wanted = asked > 0 ? asked : most ? std::atoi(most) : cores;
  return wanted > 0 ? std::min(wanted, cores) : cores;
}

/** Lets threads work for this one while it lives. */
class Employment
{
public:
  explicit Employment(sb::ThreadExecutor& threads)
    : Before(Workers)
  {
    Workers = &threads;
  }
  ~Employment() { Workers = this->Before; }
  Employment(const Employment&) = delete;
  void operator=(const Employment&) = delete;

private:
  sb::ThreadExecutor* Before;
};
}

int KernelExecutor::NumberOfThreads() const { return Workers ? Workers->NumberOfThreads() : 1; }

void KernelExecutor::For(std::int64_t count, std::int64_t grain,
  const std::function<void(std::int64_t, std::int64_t)>& body)
{
  grain = std::max<std::int64_t>(1, grain);
  const std::int64_t numberOfRanges = (count + grain - 1) / grain;
  std::atomic<std::int64_t> nextRange{ 0 };

  Clock::time_point pause;
  const auto takeRanges = [&](std::int64_t, std::int64_t) {
    for (std::int64_t range = nextRange++; range < numberOfRanges; range = nextRange++)
    {
      try
      {
        body(range * grain, std::min(count, (range + 1) * grain));
      }
      catch (...)
      {
        nextRange = numberOfRanges; // so that all stop
        throw;
      }
      if (Clock::now() >= pause)
      {
        return;
      }
    }
  };

  // One task a thread, which takes ranges until none is left. Where somebody listens all tasks
  // pause now and then, because only this thread, which waits for them, may ask whether to stop.
  sb::SerialExecutor alone;
  sb::Executor& threads = Workers ? static_cast<sb::Executor&>(*Workers) : alone;
  const std::int64_t numberOfTasks =
    std::min<std::int64_t>(threads.NumberOfThreads(), numberOfRanges);
  do
  {
    pause = Listening ? Clock::now() + Beat : Clock::time_point::max();
    threads.For(numberOfTasks, 1, takeRanges);
    if (Listening)
    {
      Listening->Aborted();
    }
  } while (nextRange < numberOfRanges);
}

void RunWithThreads(int numberOfThreads, const std::function<void()>& work)
{
  sb::ThreadExecutor threads(ThreadsToStart(numberOfThreads));
  const Employment employment(threads);
  work();
}

void StopIfAsked(vtkAlgorithm* filter)
{
  if (filter->CheckAbort())
  {
    throw Stopped();
  }
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
