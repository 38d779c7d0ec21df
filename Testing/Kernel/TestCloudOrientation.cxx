// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCloudOrientation.cxx
 * @brief Closed clouds are known to face outwards or inwards; sheets and bowls are neither.
 */
#include "Check.h"
#include "CloudOrientation.h"
#include "Clouds.h"

#include <cmath>
#include <random>

namespace
{

double WindingOf(const clouds::Cloud& cloud, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  return sb::WindingOnSurface(*clouds::SurfaceOf(cloud).Surface, executor);
}

clouds::Cloud TurnedOver(clouds::Cloud cloud)
{
  for (double& coordinate : cloud.Normals)
  {
    coordinate = -coordinate;
  }
  return cloud;
}

/** The points below a height. */
clouds::Cloud Below(const clouds::Cloud& whole, double height)
{
  clouds::Cloud cloud;
  for (std::size_t i = 0; i < whole.Points.size(); i += 3)
  {
    const sb::Real3 point{ whole.Points[i], whole.Points[i + 1], whole.Points[i + 2] };
    if (point[2] < height)
    {
      cloud.Add(point, { whole.Normals[i], whole.Normals[i + 1], whole.Normals[i + 2] });
    }
  }
  return cloud;
}

void ClosedCloudsAreOneHalf()
{
  std::mt19937 random(1);
  clouds::Cloud noisy = clouds::Torus(30000, random);
  clouds::AddNoise(noisy, 0.01, random);
  for (const clouds::Cloud& cloud : { clouds::Sphere(300), clouds::Sphere(50000), noisy })
  {
    const double winding = WindingOf(cloud);
    CHECK(winding > 0.4 && winding <= 0.5);
    CHECK(WindingOf(TurnedOver(cloud)) == -winding);
    CHECK(WindingOf(TurnedOver(cloud)) < sb::WindingOfInsideOut);
    CHECK(WindingOf(cloud, 1) == winding);
  }
}

void SheetsAndBowlsAreNotInsideOut()
{
  CHECK(std::abs(WindingOf(clouds::Plane(80))) < 1e-9);
  const double bowl = WindingOf(TurnedOver(Below(clouds::Sphere(20000), 0.0)));
  CHECK(bowl < -0.2 && bowl > sb::WindingOfInsideOut);
}

} // namespace

int main()
{
  ClosedCloudsAreOneHalf();
  SheetsAndBowlsAreNotInsideOut();
  return check::Verdict("TestCloudOrientation");
}
