// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KernelExecutor.h
 * @brief The kernel's parallel loop on threads that live for one update, and its ear for progress
 * and abort on a vtkAlgorithm.
 */
#ifndef KernelExecutor_h
#define KernelExecutor_h

#include "Executor.h"
#include "sbSurfaceModule.h" // for the export macro

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

class vtkAlgorithm;

namespace sbvtk
{

/**
 * Hands out the ranges [0, grain), [grain, 2 grain), ... to the threads of RunWithThreads, whatever
 * their number; outside of that there is only the caller. An exception that the body throws is
 * thrown again by For.
 */
class SBSURFACE_EXPORT KernelExecutor : public sb::Executor
{
public:
  int NumberOfThreads() const override;
  void For(std::int64_t count, std::int64_t grain,
    const std::function<void(std::int64_t, std::int64_t)>& body) override;
};

/**
 * Run `work` with that many threads (0: one a core, or as many as VTK_SMP_MAX_THREADS says), or
 * fewer if the system does not give them. They are threads of our own: vtkSMPTools must not be
 * called by two filters at once, as its settings are the process's, and it ends the program where
 * no thread can be started.
 */
SBSURFACE_EXPORT void RunWithThreads(int numberOfThreads, const std::function<void()>& work);

/** Thrown by StopIfAsked. */
struct Stopped
{
};

/** End an update that somebody asked to stop after the kernel was done.
 * @throw Stopped */
SBSURFACE_EXPORT void StopIfAsked(vtkAlgorithm* filter);

/**
 * Passes the kernel's progress on as a share of the filter's, and the filter's abort flag to the
 * kernel. During long stages the last progress is told again every tenth of a second, so that
 * whoever listens can set that flag. While it lives, KernelExecutor::For pauses for that in the
 * thread that made it.
 */
class SBSURFACE_EXPORT KernelMonitor : public sb::Monitor
{
public:
  /** @param first, last the part of the filter's progress, in [0, 1], that the kernel takes. */
  KernelMonitor(vtkAlgorithm* filter, double first, double last);
  ~KernelMonitor() override;
  KernelMonitor(const KernelMonitor&) = delete;
  void operator=(const KernelMonitor&) = delete;

  void Progress(double fraction, const char* stage) override;
  bool Aborted() override;

private:
  vtkAlgorithm* Filter;
  double First;
  double Last;
  std::thread::id Owner;
  KernelMonitor* Before; ///< the one that listened in this thread when this one was made
  std::chrono::steady_clock::time_point LastBeat;
  std::atomic<bool> Stop{ false };
};

} // namespace sbvtk

#endif
