// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stopwatch.h
 * @brief Seconds since the last look.
 */
#ifndef Stopwatch_h
#define Stopwatch_h

#include <chrono>

namespace sbvtk
{

class Stopwatch
{
public:
  /** Seconds since the last call, or since construction. */
  double Lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - this->Last).count();
    this->Last = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

} // namespace sbvtk

#endif
