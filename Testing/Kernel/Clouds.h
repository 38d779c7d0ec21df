// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Clouds.h
 * @brief Clouds of points on shapes whose distance is a formula, with exact normals.
 */
#ifndef Clouds_h
#define Clouds_h

#include "CloudSurface.h"
#include "ThreadExecutor.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace clouds
{

constexpr double Pi = 3.14159265358979323846;

struct Cloud
{
  std::vector<double> Points;
  std::vector<double> Normals;

  std::int64_t Count() const { return static_cast<std::int64_t>(this->Points.size() / 3); }

  void Add(const sb::Real3& point, const sb::Real3& normal)
  {
    this->Points.insert(this->Points.end(), point.begin(), point.end());
    this->Normals.insert(this->Normals.end(), normal.begin(), normal.end());
  }
};

/** Evenly spread over the unit sphere, in a spiral. */
inline Cloud Sphere(int count)
{
  Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    const double turn = i * Pi * (3.0 - std::sqrt(5.0));
    const sb::Real3 place{ r * std::cos(turn), r * std::sin(turn), z };
    cloud.Add(place, place);
  }
  return cloud;
}

/** Randomly and evenly over a torus of radii 1 and 0.4 about z. */
inline Cloud Torus(int count, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform;
  Cloud cloud;
  while (cloud.Count() < count)
  {
    const double a = 2.0 * Pi * uniform(random);
    const double b = 2.0 * Pi * uniform(random);
    const double reach = 1.0 + 0.4 * std::cos(b);
    if (uniform(random) < reach / 1.4)
    {
      cloud.Add({ reach * std::cos(a), reach * std::sin(a), 0.4 * std::sin(b) },
        { std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b) });
    }
  }
  return cloud;
}

/** A regular grid on that torus: random samples have an error of their own. */
inline Cloud TorusGrid(int around, int across)
{
  Cloud cloud;
  for (int i = 0; i < around * across; ++i)
  {
    const double a = 2.0 * Pi * (i % around) / around;
    const double b = 2.0 * Pi * (i / around) / across;
    const double reach = 1.0 + 0.4 * std::cos(b);
    cloud.Add({ reach * std::cos(a), reach * std::sin(a), 0.4 * std::sin(b) },
      { std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b) });
  }
  return cloud;
}

inline double DistanceToTorus(const sb::Real3& x)
{
  return std::hypot(std::hypot(x[0], x[1]) - 1.0, x[2]) - 0.4;
}

/** A grid of `across` by `across` points of the plane z = 0 over the unit square. */
inline Cloud Plane(int across)
{
  Cloud cloud;
  for (int i = 0; i < across * across; ++i)
  {
    cloud.Add(
      { (i % across) / (across - 1.0), (i / across) / (across - 1.0), 0.0 }, { 0.0, 0.0, 1.0 });
  }
  return cloud;
}

/** Move each point along its normal, by a normal distribution. */
inline void AddNoise(Cloud& cloud, double deviation, std::mt19937& random)
{
  std::normal_distribution<double> normal(0.0, deviation);
  for (std::size_t i = 0; i < cloud.Points.size(); i += 3)
  {
    const double by = normal(random);
    for (std::size_t k = 0; k < 3; ++k)
    {
      cloud.Points[i + k] += by * cloud.Normals[i + k];
    }
  }
}

inline sb::CloudSurface SurfaceOf(const Cloud& cloud, bool withNormals = true,
  sb::SurfaceDefinition definition = sb::SurfaceDefinition::Unbiased, double width = 0.0,
  int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  sb::CloudRequest request;
  request.Points = cloud.Points.data();
  request.Normals = withNormals ? cloud.Normals.data() : nullptr;
  request.Count = cloud.Count();
  request.Definition = definition;
  request.Width = width;
  return sb::MakeCloudSurface(request, executor, monitor);
}

} // namespace clouds

#endif
