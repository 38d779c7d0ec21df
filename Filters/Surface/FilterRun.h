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

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace sbvtk
{

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
  void Fail(const Failure& failure);

  std::vector<vtkDataObject*> Outputs;
  int Status = 0;
  std::string Message;
};

} // namespace sbvtk

#endif
