// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Patches.h
 * @brief Patches with known shapes: exact surfaces of revolution, planes, and free forms.
 */
#ifndef Patches_h
#define Patches_h

#include "NURBSSurface.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace patches
{

/** A pole of a curve in the half-plane of r and z, with its weight. */
struct ProfilePole
{
  double R;
  double Z;
  double Weight;
};

/** The knots of a clamped spline of degree 2 made of `arcs` pieces with double knots between. */
inline std::vector<double> ArcKnots(int arcs)
{
  std::vector<double> knots{ 0, 0, 0 };
  for (int k = 1; k < arcs; ++k)
  {
    knots.insert(knots.end(), { k / double(arcs), k / double(arcs) });
  }
  knots.insert(knots.end(), { 1, 1, 1 });
  return knots;
}

/** The unit circle as nine poles: at angles of k * 45 degrees, with weights 1 and sqrt(1/2). */
inline void CirclePole(int k, double& x, double& y, double& weight)
{
  const double xs[8] = { 1, 1, 0, -1, -1, -1, 0, 1 };
  const double ys[8] = { 0, 1, 1, 1, 0, -1, -1, -1 };
  x = xs[k % 8];
  y = ys[k % 8];
  weight = k % 2 == 0 ? 1.0 : std::sqrt(0.5);
}

/** The profile turned about the z axis: u around, v along the profile. Its normal Du x Dv points
 * outwards if the profile goes up. */
inline sb::NURBSSurface Revolution(
  const std::vector<ProfilePole>& profile, int degree, const std::vector<double>& knots)
{
  sb::NURBSSurface surface;
  surface.DegreeU = 2;
  surface.DegreeV = degree;
  surface.CountU = 9;
  surface.CountV = static_cast<int>(profile.size());
  surface.KnotsU = ArcKnots(4);
  surface.KnotsV = knots;
  for (int i = 0; i < 9; ++i)
  {
    double x = 0.0;
    double y = 0.0;
    double weight = 0.0;
    CirclePole(i, x, y, weight);
    for (const ProfilePole& pole : profile)
    {
      surface.Poles.insert(
        surface.Poles.end(), { x * pole.R, y * pole.R, pole.Z, weight * pole.Weight });
    }
  }
  return surface;
}

/** About the origin, from the south pole at v = 0 to the north pole at v = 1. */
inline sb::NURBSSurface Sphere(double radius)
{
  const double r = radius;
  const double w = std::sqrt(0.5);
  return Revolution(
    { { 0, -r, 1 }, { r, -r, w }, { r, 0, 1 }, { r, r, w }, { 0, r, 1 } }, 2, ArcKnots(2));
}

inline sb::NURBSSurface Cylinder(double radius, double halfHeight)
{
  return Revolution({ { radius, -halfHeight, 1 }, { radius, halfHeight, 1 } }, 1, { 0, 0, 1, 1 });
}

inline sb::NURBSSurface Torus(double large, double small)
{
  std::vector<ProfilePole> profile;
  for (int k = 0; k < 9; ++k)
  {
    double r = 0.0;
    double z = 0.0;
    double weight = 0.0;
    CirclePole(k, r, z, weight);
    profile.push_back({ large + small * r, small * z, weight });
  }
  return Revolution(profile, 2, ArcKnots(4));
}

/** From a corner along two sides; the domain is the unit square. */
inline sb::NURBSSurface Parallelogram(
  const sb::Real3& corner, const sb::Real3& sideU, const sb::Real3& sideV)
{
  sb::NURBSSurface surface;
  surface.DegreeU = surface.DegreeV = 1;
  surface.CountU = surface.CountV = 2;
  surface.KnotsU = surface.KnotsV = { 0, 0, 1, 1 };
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      const sb::Real3 pole = sb::PlusScaled(sb::PlusScaled(corner, i, sideU), j, sideV);
      surface.Poles.insert(surface.Poles.end(), { pole[0], pole[1], pole[2], 1.0 });
    }
  }
  return surface;
}

/** A knot vector: clamped with even inner knots, or (unclamped) even throughout. */
inline std::vector<double> EvenKnots(int degree, int count, bool clamped)
{
  std::vector<double> knots;
  for (int k = 0; k < count + degree + 1; ++k)
  {
    const int inner = k - degree;
    const int spans = count - degree;
    const int place = clamped ? (inner < 0 ? 0 : inner > spans ? spans : inner) : inner;
    knots.push_back(place / double(spans));
  }
  return knots;
}

/** A height field over [-1, 1]^2 with random heights and weights. */
inline sb::NURBSSurface FreeForm(int degreeU, int degreeV, int countU, int countV, double height,
  std::mt19937& random, bool clamped = true)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  sb::NURBSSurface surface;
  surface.DegreeU = degreeU;
  surface.DegreeV = degreeV;
  surface.CountU = countU;
  surface.CountV = countV;
  surface.KnotsU = EvenKnots(degreeU, countU, clamped);
  surface.KnotsV = EvenKnots(degreeV, countV, clamped);
  for (int i = 0; i < countU; ++i)
  {
    for (int j = 0; j < countV; ++j)
    {
      const double z = height * uniform(random);
      const double weight = std::exp(0.5 * uniform(random));
      surface.Poles.insert(surface.Poles.end(),
        { 2.0 * i / (countU - 1) - 1.0, 2.0 * j / (countV - 1) - 1.0, z, weight });
    }
  }
  return surface;
}

} // namespace patches

#endif
