// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterRun.h
 * @brief How an update of a filter ends: with a result, with a result and warnings, or with one
 * sentence and empty outputs.
 */
#ifndef FilterRun_h
#define FilterRun_h

#include "Boolean.h"
#include "FilterFailure.h"
#include "KernelExecutor.h"
#include "Stopwatch.h"
#include "sbSurfaceModule.h" // for the export macro

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace sbvtk
{

/** What is left to say of an update that has no result. */
struct UpdateEndings
{
  std::function<void(const FilterFailure&)> Report; ///< empties the outputs, adds the field data
  FilterFailure IfStopped;
  FilterFailure IfOutOfMemory;
};

/** Take the steps of an update. Where one of them fails, memory runs out or the user stops the
 * filter, that is reported; of all but the last the user hears the sentence. */
SBSURFACE_EXPORT void RunSteps(
  vtkAlgorithm* filter, const std::function<void()>& steps, const UpdateEndings& endings);

/** One update of a filter: derived classes have its steps. */
class SBSURFACE_EXPORT FilterRun
{
public:
  FilterRun(vtkAlgorithm* filter, const std::vector<vtkDataObject*>& outputs);
  virtual ~FilterRun();
  FilterRun(const FilterRun&) = delete;
  void operator=(const FilterRun&) = delete;

  /** Take the steps, and say how they ended. */
  void Execute();

protected:
  using Failure = FilterFailure;

  /** Fill the outputs. @throw FilterFailure */
  virtual void TakeSteps() = 0;

  /** Add field data to the outputs, which are empty if `status` is that of an error. */
  virtual void AddFields(int status, const std::string& message) = 0;

  /** What makes the result smaller, as the end of a sentence. */
  virtual std::string AdviceOnMemory() const = 0;

  /** Warn the user; the first warning is what AddFields gets. */
  void Warn(int status, const std::string& sentence);

  vtkAlgorithm* const Owner;
  KernelExecutor Executor;
  Stopwatch Watch;
  std::vector<sb::StageTime> Times;

private:
  std::vector<vtkDataObject*> Outputs;
  int Status = 0;
  std::string Message;
};

} // namespace sbvtk

#endif
