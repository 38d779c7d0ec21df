// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SeamCurves.h
 * @brief The seam of a Boolean as polylines, after it was moved onto both surfaces, and how far the
 * true curve is from its chords.
 */
#ifndef sb_SeamCurves_h
#define sb_SeamCurves_h

#include "SeamSnap.h"

#include <cstdint>
#include <vector>

namespace sb
{

struct SeamCurve
{
  std::vector<std::int32_t> Points; ///< of SeamCurves; a closed one ends where it starts
  bool Closed = false;
  double ChordError = 0.0; ///< the largest that was measured
};

struct SeamCurves
{
  std::vector<Real3> Points;
  std::vector<Real3> Normals; ///< of the cloud's surface
  std::vector<double> Residuals; ///< distance from the cloud's surface
  std::vector<std::int32_t> Triangle; ///< one of the tool's that the point is on
  std::vector<SeamCurve> Curves;
  double LargestChordError = 0.0;
  std::int64_t NumberOfEnds = 0; ///< of open curves, where no other curve goes on
};

/**
 * @param curves as the Boolean found them
 * @param before the mesh before it was snapped
 */
SeamCurves TraceSeam(const Curves& curves, const CombinedMesh& before, const SeamSnap& snap,
  const SeamSnapRequest& request, Executor& executor);

} // namespace sb

#endif
