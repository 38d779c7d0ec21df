// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudSentences.h"

#include "vtkPointSetSurfaceFilter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

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
    case sb::CloudStatus::Aborted:
      return vtkPointSetSurfaceFilter::ABORTED;
  }
  return vtkPointSetSurfaceFilter::OK;
}

std::string ThinPartsOf(const sb::CloudSurface& cloud)
{
  std::ostringstream text;
  text << std::setprecision(3) << std::max(0.1, std::round(1000.0 * cloud.ThinShare) / 10.0)
       << " % of the points lie on walls or beside gaps of about " << cloud.ThinWall
       << ", thinner than the width that is used there (Width is " << cloud.Surface->Width()
       << "), so that the two sides run into each other";
  return text.str();
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
    case sb::CloudStatus::Aborted:
      return "The filter was stopped.";
  }
  return "";
}

} // namespace sbvtk
