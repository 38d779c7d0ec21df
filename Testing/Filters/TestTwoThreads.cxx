// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTwoThreads.cxx
 * @brief Two filters of a class may run at once, on the same inputs: each gives what it gives
 * alone.
 *
 * Build it with -fsanitize=thread to see that nothing is shared that one of them writes to
 * (ARCHITECTURE.md, Tests).
 */
#include "AllFilters.h"

#include <cstdio>
#include <thread>

namespace
{

std::vector<double> Updated(const Maker& make)
{
  const vtkSmartPointer<vtkAlgorithm> filter = make();
  filter->Update();
  return Content(filter);
}

/** @return whether two at once give what one alone does, every time. */
bool AgreesWithItself(const Maker& make)
{
  const std::vector<double> alone = Updated(make);
  bool agrees = !alone.empty();
  for (int round = 0; round < 3; ++round)
  {
    std::vector<double> answers[2];
    std::thread first([&] { answers[0] = Updated(make); });
    std::thread second([&] { answers[1] = Updated(make); });
    first.join();
    second.join();
    agrees = agrees && answers[0] == alone && answers[1] == alone;
  }
  return agrees;
}

} // namespace

int main()
{
  int failures = 0;
  for (const auto& [name, make] : AllFilters(20))
  {
    const bool agrees = AgreesWithItself(make);
    std::printf("%s %s\n", agrees ? "ok  " : "FAIL", name.c_str());
    failures += agrees ? 0 : 1;
  }
  return failures;
}
