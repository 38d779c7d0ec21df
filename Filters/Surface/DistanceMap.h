// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceMap.h
 * @brief The arrays that a data set gets from its distances to a surface, and their summary.
 */
#ifndef DistanceMap_h
#define DistanceMap_h

#include "DistanceSummary.h"
#include "DistanceSurface.h"

#include <utility>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkDataSetAttributes;

namespace sbvtk
{

class SamplePlaces;

/** What to compute. */
struct DistanceOptions
{
  sb::SignRule Rule = sb::SignRule::Pseudonormal;
  bool Negate = false;
  bool CellCenters = false;
  bool NearestPoint = false;
  bool NearestCellId = false;
  bool Direction = false;
  double Limit = 0.0; ///< infinity for none
};

/** Puts arrays on data sets, and remembers the distances of their points. */
class DistanceMap
{
public:
  DistanceMap(const DistanceSurface& surface, const DistanceOptions& options)
    : Surface(surface)
    , Options(options)
  {
  }

  /** @return false if it was stopped; the data set is then unfinished. */
  bool AddTo(vtkDataSet* data, sb::Executor& executor, sb::Monitor& monitor);

  /** How many of the points so far were not finite, so that their distance is NaN. */
  std::int64_t NumberOfBadPoints() const { return this->BadPoints; }

  /** Of the points of all data sets so far, one after another. */
  std::vector<double> TakeDistances() { return std::move(this->All); }

private:
  bool AddArrays(vtkDataSetAttributes* attributes, const SamplePlaces& places, double*& distances,
    sb::Executor& executor, sb::Monitor& monitor);

  const DistanceSurface& Surface;
  DistanceOptions Options;
  std::vector<double> All;
  std::int64_t BadPoints = 0;
};

/** The summary as field arrays: DistanceMinimum, ...Maximum, ...Mean, ...RMS, ...Quantile5, 25, 50,
 * 75, 95. */
void AddSummaryFields(vtkDataObject* output, const sb::DistanceSummary& summary);

} // namespace sbvtk

#endif
