// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stages.h
 * @brief What all computations of the kernel have in common: the stages up to the contacts, the
 * time of each stage, and the remarks.
 */
#ifndef sb_Stages_h
#define sb_Stages_h

#include "Boolean.h"
#include "BroadPhase.h"
#include "Contacts.h"
#include "Scene.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace sb
{

/** Runs stages, announces each, and adds up its time. */
class StageClock
{
public:
  StageClock(std::vector<StageTime>& times, Monitor& monitor)
    : Times(times)
    , Watch(monitor)
  {
  }

  template <class Stage>
  auto Timed(const char* name, double progress, Stage&& stage)
  {
    this->Watch.Progress(progress, name);
    const auto start = std::chrono::steady_clock::now();
    auto result = stage();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const auto known = std::find_if(this->Times.begin(), this->Times.end(),
      [&](const StageTime& time) { return std::string(time.Name) == name; });
    if (known != this->Times.end())
    {
      known->Seconds += elapsed.count();
    }
    else
    {
      this->Times.push_back({ name, elapsed.count() });
    }
    return result;
  }

private:
  std::vector<StageTime>& Times;
  Monitor& Watch;
};

/** Notes the time of stages each of which begins where the one before ended. */
class StageLaps
{
public:
  StageLaps(std::vector<StageTime>& times, std::vector<Remark>& remarks, Monitor& monitor)
    : Times(times)
    , Remarks(remarks)
    , Watch(monitor)
  {
  }

  /** End a stage. @return false if the caller wants to stop, which is then remarked. */
  bool End(const char* name, double progress)
  {
    const auto now = std::chrono::steady_clock::now();
    this->Times.push_back({ name, std::chrono::duration<double>(now - this->Start).count() });
    this->Start = now;
    this->Watch.Progress(progress, name);
    if (this->Watch.Aborted())
    {
      this->Remarks.emplace_back();
      this->Remarks.back().Condition = Status::Aborted;
      return false;
    }
    return true;
  }

private:
  std::vector<StageTime>& Times;
  std::vector<Remark>& Remarks;
  Monitor& Watch;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/** The pairs of faces whose boxes meet; `self` says which operands are paired with themselves, too.
 */
std::vector<TrianglePair> FindNearPairs(
  const Scene& scene, const std::vector<std::uint8_t>& self, Executor& executor, Monitor& monitor);

/** The contacts of faces that have a plane; those without are marked in `collapsed`, and their
 * neighbours stitched. */
ContactSet FindStitchedContacts(const Scene& scene, const std::vector<TrianglePair>& pairs,
  std::vector<std::uint8_t>& collapsed, Executor& executor, Monitor& monitor);

bool HasError(const std::vector<Remark>& remarks);

/** The condition that a result with these remarks has. */
Status GravestCondition(const std::vector<Remark>& remarks);

} // namespace sb

#endif
