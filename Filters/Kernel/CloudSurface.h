// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudSurface.h
 * @brief From a cloud as it comes (duplicates, points that are not finite, no normals or bad ones)
 * to its surface, and what was found on the way.
 */
#ifndef sb_CloudSurface_h
#define sb_CloudSurface_h

#include "MovingLeastSquares.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace sb
{

struct CloudRequest
{
  const double* Points = nullptr; ///< x, y, z of Count points
  const double* Normals = nullptr; ///< of any length, or null to estimate them
  std::int64_t Count = 0;
  SurfaceDefinition Definition = SurfaceDefinition::Unbiased;
  double Width = 0.0; ///< h; 0: 3.15 spacings, as SampleWidths.h has it
  bool Flip = false; ///< turn all normals over
};

enum class CloudStatus
{
  Ok,
  TooFewPoints, ///< less than six places
  NoPlane, ///< all points lie on lines, and have no normals
  ThinWall, ///< more than a fifth of the points lie on walls thinner than the width
  TooLarge, ///< more points than 32-bit numbers can name
  OutOfScale, ///< coordinates so small or large that products of them are no numbers
  Aborted
};

struct CloudSurface
{
  CloudStatus Status = CloudStatus::Ok;
  std::shared_ptr<const MovingLeastSquares> Surface; ///< null unless Ok or ThinWall
  /** Of all points of the input, three doubles of length one each; zero where there is none. */
  std::vector<double> Normals;
  /** 1 where an estimated normal may be wrong; empty if they were given. */
  std::vector<std::uint8_t> Doubtful;
  bool Estimated = false;
  double Spacing = 0.0;
  double ThinShare = 0.0; ///< of the points, on walls or gaps thinner than their width
  double ThinWall = 0.0; ///< the median thickness of those
  std::int64_t NumberOfNotFinite = 0;
  std::int64_t NumberOfDuplicates = 0;
  std::int64_t NumberWithoutNormal = 0; ///< left out, as others have one
  std::int64_t NumberOfParts = 0; ///< that signs could not be spread between; 0 if given
};

CloudSurface MakeCloudSurface(const CloudRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
