// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KernelExecutor.h
 * @brief The kernel's parallel loop on vtkSMPTools, and its ear for progress and abort on a
 * vtkAlgorithm.
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
 * Hands out the ranges [0, grain), [grain, 2 grain), ... to the threads of vtkSMPTools, whatever
 * their number. An exception that the body throws is thrown again by For.
 */
class SBSURFACE_EXPORT KernelExecutor : public sb::Executor
{
public:
  int NumberOfThreads() const override;
  void For(std::int64_t count, std::int64_t grain,
    const std::function<void(std::int64_t, std::int64_t)>& body) override;
};

/**
 * Run `work` with that many threads (0: one a core). The packaged VTK runs vtkSMPTools in one
 * thread unless it is told otherwise, so this asks for standard threads where no other backend has
 * been chosen.
 */
SBSURFACE_EXPORT void RunWithThreads(int numberOfThreads, const std::function<void()>& work);

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
