// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudSentences.h"

#include "vtkPointSetSurfaceFilter.h"

#include <cmath>
#include <cstdio>

namespace sbvtk
{

int StatusOf(sb::CloudStatus status)
{
  switch (status)
  {
    case sb::CloudStatus::Ok:
      return vtkPointSetSurfaceFilter::OK;
    case sb::CloudStatus::TooFewPoints:
      return vtkPointSetSurfaceFilter::TOO_FEW_POINTS;
    case sb::CloudStatus::NoPlane:
      return vtkPointSetSurfaceFilter::NO_PLANE;
    case sb::CloudStatus::ThinWall:
      return vtkPointSetSurfaceFilter::THIN_WALL;
    case sb::CloudStatus::TooLarge:
      return vtkPointSetSurfaceFilter::TOO_LARGE;
    case sb::CloudStatus::OutOfScale:
      return vtkPointSetSurfaceFilter::OUT_OF_SCALE;
    case sb::CloudStatus::Aborted:
      return vtkPointSetSurfaceFilter::ABORTED;
  }
  return vtkPointSetSurfaceFilter::OK;
}

std::string Text(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string PercentOf(double share)
{
  const long percent = std::lround(100.0 * share);
  return percent == 0 && share > 0.0 ? "less than 1 %" : std::to_string(percent) + " %";
}

std::string ThinPartsOf(const sb::CloudSurface& cloud)
{
  return "Of the points, " + PercentOf(cloud.ThinShare) + " lie on walls or beside gaps of about " +
    Text(cloud.ThinWall) + ", thinner than the width that is used there (Width is " +
    Text(cloud.Surface->Width()) + "), so that the two sides run into each other";
}

std::string RefusalOf(const sb::CloudSurface& cloud, std::int64_t numberOfPoints)
{
  switch (cloud.Status)
  {
    case sb::CloudStatus::Ok:
      return "";
    case sb::CloudStatus::TooFewPoints:
      return "Input has " + std::to_string(numberOfPoints) + " points (" +
        std::to_string(cloud.NumberOfNotFinite) + " not finite, " +
        std::to_string(cloud.NumberOfDuplicates) + " duplicates, " +
        std::to_string(cloud.NumberWithoutNormal) +
        " without a normal), and a surface needs at least six different ones; choose another "
        "Input.";
    case sb::CloudStatus::NoPlane:
      return "The points of Input lie on lines, so that no plane and no normal can be fitted to "
             "them; give Input point normals, or choose points of a surface.";
    case sb::CloudStatus::ThinWall:
      return ThinPartsOf(cloud) +
        "; choose a Width of less than that, or give Input points that lie closer to each other "
        "than "
        "half of it.";
    case sb::CloudStatus::TooLarge:
      return "Input has more than 2147483647 points; divide it.";
    case sb::CloudStatus::OutOfScale:
      return "The points of Input are less than 1e-60 or more than 1e60 apart, and what is "
             "computed "
             "from their distances is no number there; scale Input, for instance by Transform.";
    case sb::CloudStatus::Aborted:
      return "The filter was stopped.";
  }
  return "";
}

} // namespace sbvtk
