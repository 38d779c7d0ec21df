// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SamplePlaces.h
 * @brief The points of any data set, and the middles of its cells, as plain doubles.
 */
#ifndef SamplePlaces_h
#define SamplePlaces_h

#include "Executor.h"

#include <cstdint>
#include <vector>

class vtkDataSet;

namespace sbvtk
{

/** Coordinates in an array of the data set, if it has them as doubles, else in one of its own. */
class SamplePlaces
{
public:
  static SamplePlaces Points(vtkDataSet* data, sb::Executor& executor);

  /** The mean of each cell's points; NaN for a cell without points. */
  static SamplePlaces CellCenters(vtkDataSet* data, sb::Executor& executor);

  const double* Coordinates() const { return this->Own.empty() ? this->Foreign : this->Own.data(); }
  std::int64_t Count() const { return this->Number; }
  std::vector<double> Copy() const
  {
    return { this->Coordinates(), this->Coordinates() + 3 * this->Number };
  }

private:
  const double* Foreign = nullptr;
  std::vector<double> Own;
  std::int64_t Number = 0;
};

} // namespace sbvtk

#endif
