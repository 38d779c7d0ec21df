// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThreadExecutor.h
 * @brief An Executor over a fixed pool of standard threads.
 */
#ifndef sb_ThreadExecutor_h
#define sb_ThreadExecutor_h

#include "Executor.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace sb
{

/**
 * The ranges handed out are [0, grain), [grain, 2 grain), ... whatever the number of threads; only
 * who runs which differs. A For inside a For runs in the thread that asked for it. An exception
 * thrown by the body is thrown again by For, after all threads have stopped. Where the system gives
 * fewer threads than asked for, there are fewer.
 */
class ThreadExecutor : public Executor
{
public:
  explicit ThreadExecutor(int numberOfThreads)
  {
    try
    {
      for (int thread = 1; thread < numberOfThreads; ++thread)
      {
        this->Workers.emplace_back([this] { this->Work(); });
      }
    }
    catch (const std::system_error&)
    {
      // No more threads, or no memory for their stacks: those that there are do the work.
    }
  }

  ~ThreadExecutor() override
  {
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      this->Closing = true;
    }
    this->Wake.notify_all();
    for (std::thread& worker : this->Workers)
    {
      worker.join();
    }
  }

  ThreadExecutor(const ThreadExecutor&) = delete;
  ThreadExecutor& operator=(const ThreadExecutor&) = delete;

  int NumberOfThreads() const override { return static_cast<int>(this->Workers.size()) + 1; }

  void For(std::int64_t count, std::int64_t grain,
    const std::function<void(std::int64_t, std::int64_t)>& body) override
  {
    grain = std::max<std::int64_t>(grain, 1);
    if (this->Workers.empty() || Inside() || count <= grain)
    {
      for (std::int64_t begin = 0; begin < count; begin += grain)
      {
        body(begin, std::min(begin + grain, count));
      }
      return;
    }
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      this->Body = &body;
      this->Count = count;
      this->Grain = grain;
      this->Next = 0;
      this->Failure = nullptr;
      this->Busy = static_cast<int>(this->Workers.size());
      ++this->Round;
    }
    this->Wake.notify_all();
    this->RunRanges();
    std::unique_lock<std::mutex> lock(this->Guard);
    this->Done.wait(lock, [this] { return this->Busy == 0; });
    if (this->Failure)
    {
      std::rethrow_exception(this->Failure);
    }
  }

private:
  static bool& Inside()
  {
    static thread_local bool inside = false;
    return inside;
  }

  void RunRanges()
  {
    Inside() = true;
    try
    {
      for (std::int64_t begin = this->Next.fetch_add(this->Grain); begin < this->Count;
           begin = this->Next.fetch_add(this->Grain))
      {
        (*this->Body)(begin, std::min(begin + this->Grain, this->Count));
      }
    }
    catch (...)
    {
      this->Next = this->Count;
      const std::lock_guard<std::mutex> lock(this->Guard);
      this->Failure = std::current_exception();
    }
    Inside() = false;
  }

  void Work()
  {
    std::uint64_t seen = 0;
    std::unique_lock<std::mutex> lock(this->Guard);
    for (;;)
    {
      this->Wake.wait(lock, [&] { return this->Closing || this->Round != seen; });
      if (this->Closing)
      {
        return;
      }
      seen = this->Round;
      lock.unlock();
      this->RunRanges();
      lock.lock();
      if (--this->Busy == 0)
      {
        this->Done.notify_one();
      }
    }
  }

  std::vector<std::thread> Workers;
  std::mutex Guard;
  std::condition_variable Wake;
  std::condition_variable Done;
  bool Closing = false;
  std::uint64_t Round = 0;
  int Busy = 0;
  std::exception_ptr Failure;
  const std::function<void(std::int64_t, std::int64_t)>* Body = nullptr;
  std::int64_t Count = 0;
  std::int64_t Grain = 1;
  std::atomic<std::int64_t> Next{ 0 };
};

} // namespace sb

#endif
