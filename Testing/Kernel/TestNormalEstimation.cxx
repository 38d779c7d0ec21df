// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNormalEstimation.cxx
 * @brief Estimated normals are right and all on one side: on smooth shapes, several at once, with
 * noise, on a thin wall; lines are told apart; the order of the points does not matter.
 */
#include "Check.h"
#include "Clouds.h"
#include "SymmetricEigen.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace
{

struct Agreement
{
  double Turned = 0.0; ///< share of normals on the other side
  double WorstAngle = 0.0; ///< cosine
};

Agreement Compare(const clouds::Cloud& cloud, const std::vector<double>& found)
{
  Agreement agreement;
  agreement.WorstAngle = 1.0;
  for (std::size_t i = 0; i < cloud.Normals.size(); i += 3)
  {
    const double cosine = cloud.Normals[i] * found[i] + cloud.Normals[i + 1] * found[i + 1] +
      cloud.Normals[i + 2] * found[i + 2];
    agreement.Turned += cosine < 0.0 ? 3.0 / static_cast<double>(cloud.Normals.size()) : 0.0;
    agreement.WorstAngle = std::min(agreement.WorstAngle, std::abs(cosine));
  }
  return agreement;
}

void Append(clouds::Cloud& to, const clouds::Cloud& from, double scale, double shift)
{
  for (std::size_t i = 0; i < from.Points.size(); i += 3)
  {
    to.Add(
      { scale * from.Points[i] + shift, scale * from.Points[i + 1], scale * from.Points[i + 2] },
      { from.Normals[i], from.Normals[i + 1], from.Normals[i + 2] });
  }
}

void EigenvectorsAreEigenvectors()
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 200; ++k)
  {
    sb::Real3x3 m{};
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (std::size_t b = 0; b <= a; ++b)
      {
        m[a][b] = m[b][a] = k % 10 == 0 ? std::round(normal(random)) : normal(random);
      }
    }
    const sb::SymmetricEigen eigen(m);
    CHECK(eigen.Values[0] <= eigen.Values[1] && eigen.Values[1] <= eigen.Values[2]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const sb::Real3 rest =
        sb::PlusScaled(sb::Times(m, eigen.Vectors[a]), -eigen.Values[a], eigen.Vectors[a]);
      CHECK(sb::Length(rest) < 1e-12);
      CHECK(std::abs(sb::Length(eigen.Vectors[a]) - 1.0) < 1e-13);
    }
  }
}

void SmoothShapesAreRight()
{
  const clouds::Cloud sphere = clouds::Sphere(5000);
  const sb::CloudSurface ofSphere = clouds::SurfaceOf(sphere, false);
  const Agreement onSphere = Compare(sphere, ofSphere.Normals);
  CHECK_EQUAL(onSphere.Turned, 0.0);
  CHECK(onSphere.WorstAngle > std::cos(0.03));
  CHECK_EQUAL(ofSphere.NumberOfParts, 1);
  CHECK_EQUAL(std::accumulate(ofSphere.Doubtful.begin(), ofSphere.Doubtful.end(), 0), 0);

  std::mt19937 random(2);
  clouds::Cloud torus = clouds::Torus(20000, random);
  CHECK_EQUAL(Compare(torus, clouds::SurfaceOf(torus, false).Normals).Turned, 0.0);
  clouds::AddNoise(torus, 0.3 * 0.028, random);
  const sb::CloudSurface noisy = clouds::SurfaceOf(torus, false);
  CHECK(Compare(torus, noisy.Normals).Turned < 1e-3);
}

/** 40 points on a sphere: neighbours are far apart, but lie on common circles. */
void CoarseSpheresAreRight()
{
  const clouds::Cloud sphere = clouds::Sphere(40);
  CHECK_EQUAL(Compare(sphere, clouds::SurfaceOf(sphere, false).Normals).Turned, 0.0);
}

void EachPartEnclosesAPositiveVolume()
{
  clouds::Cloud several;
  Append(several, clouds::Sphere(3000), 1.0, 0.0);
  Append(several, clouds::Sphere(2000), 0.5, 4.0);
  Append(several, clouds::Sphere(1000), 0.2, -3.0);
  const sb::CloudSurface made = clouds::SurfaceOf(several, false);
  CHECK_EQUAL(made.NumberOfParts, 3);
  CHECK_EQUAL(Compare(several, made.Normals).Turned, 0.0);
}

/** A plate two spacings thick with round edges: its faces have opposite normals. */
void AThinWallHasTwoSides()
{
  clouds::Cloud plate;
  const double s = 0.02;
  for (int i = -40; i <= 40; ++i)
  {
    for (int j = -40; j <= 40; ++j)
    {
      plate.Add({ i * s, j * s, s }, { 0, 0, 1 });
      plate.Add({ i * s, j * s, -s }, { 0, 0, -1 });
    }
    for (const double side : { -1.0, 1.0 })
    {
      for (const double angle : { -0.7, 0.0, 0.7 })
      {
        const sb::Real3 bulge{ side * std::cos(angle), 0.0, std::sin(angle) };
        plate.Add({ side * 40.3 * s + s * bulge[0], i * s, s * bulge[2] }, bulge);
        plate.Add(
          { i * s, side * 40.3 * s + s * bulge[0], s * bulge[2] }, { 0.0, bulge[0], bulge[2] });
      }
    }
  }
  const sb::CloudSurface made = clouds::SurfaceOf(plate, false);
  CHECK(Compare(plate, made.Normals).Turned < 0.02);
}

void LinesHaveNoNormal()
{
  clouds::Cloud line;
  for (int i = 0; i < 100; ++i)
  {
    line.Add({ 0.1 * i, 0.2 * i, -0.3 * i }, { 0, 0, 0 });
  }
  CHECK(clouds::SurfaceOf(line, false).Status == sb::CloudStatus::NoPlane);
  // Given normals of length zero are none, so they are estimated, too.
  CHECK(clouds::SurfaceOf(line, true).Status == sb::CloudStatus::NoPlane);
  clouds::Cloud few;
  CHECK(clouds::SurfaceOf(few, false).Status == sb::CloudStatus::TooFewPoints);
  for (int i = 0; i < 50; ++i)
  {
    few.Add({ double(i % 5), double(i % 5 == 2), 0.0 }, { 0, 0, 1 });
  }
  const sb::CloudSurface refused = clouds::SurfaceOf(few, true);
  CHECK(refused.Status == sb::CloudStatus::TooFewPoints);
  CHECK_EQUAL(refused.NumberOfDuplicates, 45);
}

void OrderAndThreadsDoNotMatter()
{
  std::mt19937 random(3);
  clouds::Cloud cloud = clouds::Torus(6000, random);
  clouds::AddNoise(cloud, 0.01, random);
  std::vector<std::size_t> order(6000);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  clouds::Cloud permuted;
  for (const std::size_t i : order)
  {
    permuted.Add(
      { cloud.Points[3 * i], cloud.Points[3 * i + 1], cloud.Points[3 * i + 2] }, { 0, 0, 0 });
  }
  const sb::CloudSurface one =
    clouds::SurfaceOf(cloud, false, sb::SurfaceDefinition::Unbiased, 0.0, 1);
  const sb::CloudSurface other =
    clouds::SurfaceOf(permuted, false, sb::SurfaceDefinition::Unbiased, 0.0, 3);
  CHECK(one.Spacing == other.Spacing);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      CHECK(one.Normals[3 * order[i] + k] == other.Normals[3 * i + k]);
    }
    CHECK_EQUAL(one.Doubtful[order[i]], other.Doubtful[i]);
  }
}

void GivenNormalsAreMadeUnit()
{
  clouds::Cloud sphere = clouds::Sphere(500);
  for (std::size_t i = 0; i < sphere.Normals.size(); ++i)
  {
    sphere.Normals[i] *= 1.0 + static_cast<double>(i / 3);
  }
  sphere.Normals[0] = sphere.Normals[1] = sphere.Normals[2] = 0.0;
  sphere.Normals[4] = std::nan("");
  const sb::CloudSurface made = clouds::SurfaceOf(sphere);
  CHECK_EQUAL(made.NumberWithoutNormal, 2);
  CHECK_EQUAL(made.Surface->Samples().Size(), 498);
  for (std::int32_t i = 0; i < 498; ++i)
  {
    CHECK(std::abs(sb::Length(made.Surface->SampleNormal(i)) - 1.0) < 1e-14);
  }
}

} // namespace

int main()
{
  EigenvectorsAreEigenvectors();
  SmoothShapesAreRight();
  CoarseSpheresAreRight();
  EachPartEnclosesAPositiveVolume();
  AThinWallHasTwoSides();
  LinesHaveNoNormal();
  OrderAndThreadsDoNotMatter();
  GivenNormalsAreMadeUnit();
  return check::Verdict("TestNormalEstimation");
}
