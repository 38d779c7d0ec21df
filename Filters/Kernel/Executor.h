// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Executor.h
 * @brief What the kernel asks of its host: a parallel loop, and an ear for progress and abort.
 *
 * A front end hands in its own thread pool (`ThreadExecutor.h` is one). Results never depend
 * on the number of threads or on the order in which they run.
 */
#ifndef sb_Executor_h
#define sb_Executor_h

#include <cstdint>
#include <functional>

namespace sb
{

/** A parallel loop. */
class Executor
{
public:
  virtual ~Executor() = default;

  /** At least one. */
  virtual int NumberOfThreads() const = 0;

  /** Call body(begin, end) over disjoint ranges that cover [0, count), each about `grain` long;
   * returns when all are done. */
  virtual void For(std::int64_t count, std::int64_t grain,
    const std::function<void(std::int64_t, std::int64_t)>& body) = 0;
};

/** Runs everything in the calling thread. */
class SerialExecutor : public Executor
{
public:
  int NumberOfThreads() const override { return 1; }
  void For(std::int64_t count, std::int64_t,
    const std::function<void(std::int64_t, std::int64_t)>& body) override
  {
    if (count > 0)
    {
      body(0, count);
    }
  }
};

/** Hears of progress and says whether to stop. Called from the thread that called the kernel only.
 */
class Monitor
{
public:
  virtual ~Monitor() = default;

  /** @param fraction done, in [0, 1]. @param stage a word for the user. */
  virtual void Progress(double /*fraction*/, const char* /*stage*/) {}

  /** Whether the caller wants to stop; may be called from any thread, often. */
  virtual bool Aborted() { return false; }
};

} // namespace sb

#endif
