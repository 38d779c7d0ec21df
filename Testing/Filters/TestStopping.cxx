// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestStopping.cxx
 * @brief A filter that another thread stops at any time, not only where it tells of progress, ends
 * soon and leaves nothing, and the next update is as ever.
 */
#include "AllFilters.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>

namespace
{

using Clock = std::chrono::steady_clock;

constexpr int times = 6; ///< that each filter is stopped
constexpr int aborted = 9; ///< the status of all filters that were stopped
constexpr double secondsToStop = 2.0; ///< a tenth where the machine has nothing else to do
constexpr std::uint_fast32_t seed = 1968; ///< of the random times

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double UpdateSeconds(vtkAlgorithm* filter)
{
  const Clock::time_point start = Clock::now();
  filter->Update();
  return SecondsSince(start);
}

bool SaysStopped(vtkAlgorithm* filter)
{
  vtkFieldData* fields = filter->GetOutputDataObject(0)->GetFieldData();
  return fields->GetArray("Status") && fields->GetArray("Status")->GetTuple1(0) == aborted;
}

/** No point, cell or array of theirs in any output. */
bool IsEmpty(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataSet* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    if (data->GetNumberOfPoints() > 0 || data->GetNumberOfCells() > 0 ||
      data->GetPointData()->GetNumberOfArrays() > 0 || data->GetCellData()->GetNumberOfArrays() > 0)
    {
      return false;
    }
  }
  return true;
}

/** How the updates of one filter ended. */
struct Outcome
{
  int Stopped = 0;
  int Wrong = 0; ///< neither nothing nor the result, or another result afterwards
  double LongestWait = 0.0;
};

/** One update, stopped after so many seconds; the next one is not. */
void StopOnce(
  vtkAlgorithm* filter, double after, const std::vector<double>& expected, Outcome& outcome)
{
  filter->Modified();
  Clock::time_point asked;
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::duration<double>(after));
    asked = Clock::now();
    filter->SetAbortExecuteAndUpdateTime();
  });
  filter->Update();
  const Clock::time_point ended = Clock::now();
  stopper.join();
  if (SaysStopped(filter))
  {
    ++outcome.Stopped;
    outcome.Wrong += IsEmpty(filter) ? 0 : 1;
    outcome.LongestWait =
      std::max(outcome.LongestWait, std::chrono::duration<double>(ended - asked).count());
  }
  else
  {
    outcome.Wrong += Content(filter) == expected ? 0 : 1;
  }
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  outcome.Wrong += Content(filter) == expected ? 0 : 1;
}

Outcome StoppedAtRandom(const Maker& make)
{
  vtkSmartPointer<vtkAlgorithm> filter = make();
  const double first = UpdateSeconds(filter); // and of later ones, which have less to prepare:
  const std::vector<double> expected = Content(filter);
  filter->Modified();
  const double later = UpdateSeconds(filter);
  std::mt19937 random(seed);
  Outcome outcome;
  for (int i = 0; i < times; ++i)
  {
    const bool fresh = i % 2 == 0;
    filter = fresh ? make() : filter;
    std::uniform_real_distribution<double> moments(0.0, fresh ? first : later);
    StopOnce(filter, moments(random), expected, outcome);
  }
  return outcome;
}

} // namespace

int main()
{
  int failures = 0;
  int stopped = 0;
  for (const auto& [name, make] : AllFilters(50))
  {
    const Outcome outcome = StoppedAtRandom(make);
    const bool good = outcome.Wrong == 0 && outcome.LongestWait < secondsToStop;
    std::printf("%s %s: stopped %d of %d times, %d wrong, longest wait %.2f s\n",
      good ? "ok  " : "FAIL", name.c_str(), outcome.Stopped, times, outcome.Wrong,
      outcome.LongestWait);
    failures += good ? 0 : 1;
    stopped += outcome.Stopped;
  }
  return stopped > 0 ? failures : 1;
}
