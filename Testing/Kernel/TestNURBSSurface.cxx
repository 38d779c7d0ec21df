// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNURBSSurface.cxx
 * @brief Patches: exact quadrics, the basis sums to 1, derivatives against differences for every
 * degree, knots repeated or not clamped, the border of the domain, and faults.
 */
#include "Check.h"
#include "NURBSSurface.h"
#include "Patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using sb::EvaluatePatch;
using sb::NURBSSurface;
using sb::PatchPoint;
using sb::Real3;

double Gap(const Real3& a, const Real3& b) { return sb::Length(sb::Difference(a, b)); }

void QuadricsAreExact()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  const NURBSSurface sphere = patches::Sphere(1.0);
  const NURBSSurface cylinder = patches::Cylinder(1.0, 2.0);
  const NURBSSurface torus = patches::Torus(1.0, 0.4);
  for (int k = 0; k < 20000; ++k)
  {
    const double u = uniform(random);
    const double v = uniform(random);
    const PatchPoint onSphere = EvaluatePatch(sphere, u, v, 1);
    CHECK(std::abs(sb::Length(onSphere.Point) - 1.0) < 1e-15);
    CHECK(std::abs(sb::Dot(onSphere.Point, onSphere.Du)) < 1e-14);
    CHECK(std::abs(sb::Dot(onSphere.Point, onSphere.Dv)) < 1e-14);
    CHECK(sb::Dot(onSphere.Point, sb::Cross(onSphere.Du, onSphere.Dv)) > 0.0);
    const PatchPoint onCylinder = EvaluatePatch(cylinder, u, v, 0);
    CHECK(std::abs(std::hypot(onCylinder.Point[0], onCylinder.Point[1]) - 1.0) < 1e-15);
    const Real3 x = EvaluatePatch(torus, u, v, 0).Point;
    CHECK(std::abs(std::hypot(std::hypot(x[0], x[1]) - 1.0, x[2]) - 0.4) < 1e-15);
  }
}

/** With all poles in one place the patch is that place, whatever the weights: the basis sums to 1
 * and its derivatives to 0. */
void TheBasisSumsToOne()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform;
  for (int degree = 1; degree <= NURBSSurface::LargestDegree; ++degree)
  {
    NURBSSurface surface =
      patches::FreeForm(degree, std::max(1, 26 - degree), 27, 30, 1.0, random, degree % 2 == 0);
    for (std::size_t i = 0; i < surface.Poles.size(); i += 4)
    {
      surface.Poles[i] = 1.0;
      surface.Poles[i + 1] = -2.0;
      surface.Poles[i + 2] = 3.0;
    }
    for (int k = 0; k < 50; ++k)
    {
      const PatchPoint p = EvaluatePatch(surface, uniform(random), uniform(random), 2);
      CHECK(Gap(p.Point, { 1.0, -2.0, 3.0 }) < 1e-14);
      for (const Real3& derivative : { p.Du, p.Dv, p.Duu, p.Duv, p.Dvv })
      {
        CHECK(sb::Length(derivative) < 2e-9);
      }
    }
  }
}

/** Derivatives against central differences of those of one order less. */
void CheckDerivatives(const NURBSSurface& surface, double u, double v, double tolerance)
{
  const double h = 1e-5;
  const PatchPoint at = EvaluatePatch(surface, u, v, 2);
  const PatchPoint right = EvaluatePatch(surface, u + h, v, 1);
  const PatchPoint left = EvaluatePatch(surface, u - h, v, 1);
  const PatchPoint above = EvaluatePatch(surface, u, v + h, 1);
  const PatchPoint below = EvaluatePatch(surface, u, v - h, 1);
  const auto agree = [&](const Real3& derivative, const Real3& ahead, const Real3& behind) {
    const Real3 quotient = sb::Scaled(sb::Difference(ahead, behind), 0.5 / h);
    return Gap(derivative, quotient) < tolerance * std::max(1.0, sb::Length(derivative));
  };
  CHECK(agree(at.Du, right.Point, left.Point));
  CHECK(agree(at.Dv, above.Point, below.Point));
  CHECK(agree(at.Duu, right.Du, left.Du));
  CHECK(agree(at.Duv, right.Dv, left.Dv));
  CHECK(agree(at.Duv, above.Du, below.Du));
  CHECK(agree(at.Dvv, above.Dv, below.Dv));
}

void DerivativesOfEveryDegree()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.02, 0.98);
  for (int degree = 1; degree <= NURBSSurface::LargestDegree; ++degree)
  {
    for (const bool clamped : { true, false })
    {
      const int other = 1 + (degree * 7) % 6;
      // Without inner knots, so that no difference reaches over a kink of degree 1 or 2.
      const NURBSSurface surface =
        patches::FreeForm(degree, other, degree + 1, other + 1, 0.5, random, clamped);
      for (int k = 0; k < 20; ++k)
      {
        CheckDerivatives(surface, uniform(random), uniform(random), 1e-5);
      }
    }
  }
}

/** A knot as often as the degree is a corner: each side's derivative is that of its own piece. */
void RepeatedKnots()
{
  NURBSSurface surface;
  surface.DegreeU = 2;
  surface.DegreeV = 1;
  surface.CountU = 5;
  surface.CountV = 2;
  surface.KnotsU = { 0, 0, 0, 0.5, 0.5, 1, 1, 1 };
  surface.KnotsV = { 0, 0, 1, 1 };
  const double xs[5] = { 0, 1, 2, 2, 2 };
  const double ys[5] = { 0, 0, 0, 1, 2 };
  for (int i = 0; i < 5; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      surface.Poles.insert(surface.Poles.end(), { xs[i], ys[i], double(j), 1.0 });
    }
  }
  CHECK(sb::FaultOf(surface) == nullptr);
  CHECK(Gap(EvaluatePatch(surface, 0.5, 0.25, 0).Point, { 2.0, 0.0, 0.25 }) < 1e-15);
  CHECK(Gap(EvaluatePatch(surface, 0.5, 0.0, 1).Du, { 0.0, 4.0, 0.0 }) < 1e-14);
  CHECK(
    Gap(EvaluatePatch(surface, std::nextafter(0.5, 0.0), 0.0, 1).Du, { 4.0, 0.0, 0.0 }) < 1e-14);
  CHECK(EvaluatePatch(surface, 0.3, 0.7, 2).Dvv == Real3{}); // of degree 1
}

void TheBorderOfTheDomain()
{
  std::mt19937 random(4);
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const bool clamped : { true, false })
  {
    const NURBSSurface surface = patches::FreeForm(3, 4, 7, 6, 0.5, random, clamped);
    const PatchPoint last = EvaluatePatch(surface, 1.0, 1.0, 2);
    const PatchPoint almost =
      EvaluatePatch(surface, std::nextafter(1.0, 0.0), std::nextafter(1.0, 0.0), 2);
    CHECK(Gap(last.Point, almost.Point) < 1e-14);
    CHECK(Gap(last.Du, almost.Du) < 1e-12);
    CHECK(Gap(last.Dvv, almost.Dvv) < 1e-11);
    CHECK(EvaluatePatch(surface, 7.0, 1e300, 2).Point == last.Point);
    const Real3 first = EvaluatePatch(surface, 0.0, 0.0, 0).Point;
    CHECK(EvaluatePatch(surface, -1.0, -1e300, 0).Point == first);
    CHECK(EvaluatePatch(surface, none, none, 0).Point == first);
    if (clamped) // the corners are the corner poles
    {
      CHECK(Gap(first, { surface.Poles[0], surface.Poles[1], surface.Poles[2] }) < 1e-15);
    }
    CHECK(surface.FirstU() == 0.0 && surface.LastU() == 1.0);
    CHECK(surface.FirstV() == 0.0 && surface.LastV() == 1.0);
  }
}

void FaultsAreNamed()
{
  const NURBSSurface good = patches::Sphere(1.0);
  CHECK(sb::FaultOf(good) == nullptr);
  const auto fault = [&](auto&& spoil) {
    NURBSSurface surface = good;
    spoil(surface);
    const char* found = sb::FaultOf(surface);
    return std::string(found ? found : "");
  };
  using Patch = NURBSSurface;
  CHECK(fault([](Patch& s) { s.DegreeU = 26; }) == "has a degree that is not from 1 to 25");
  CHECK(fault([](Patch& s) { s.DegreeV = 0; }) == "has a degree that is not from 1 to 25");
  CHECK(fault([](Patch& s) { s.CountV = 2; }) == "has too few poles for its degree");
  CHECK(fault([](Patch& s) { s.KnotsU.pop_back(); }) ==
    "has a number of knots that does not fit its poles and degree");
  CHECK(fault([](Patch& s) { s.KnotsU[4] = 2.0; }) == "has knots that do not rise");
  CHECK(fault([](Patch& s) { s.KnotsV.assign(8, 0.0); }) == "has knots that do not rise");
  CHECK(fault([](Patch& s) { s.KnotsV[7] = std::nan(""); }) == "has knots that do not rise");
  CHECK(fault([](Patch& s) { s.Poles.pop_back(); }) ==
    "has a number of poles that does not fit its counts");
  CHECK(fault([](Patch& s) { s.Poles[5] = std::nan(""); }) == "has a pole that is not finite");
  CHECK(fault([](Patch& s) { s.Poles[7] = 0.0; }) == "has a weight that is not positive");
}

} // namespace

int main()
{
  QuadricsAreExact();
  TheBasisSumsToOne();
  DerivativesOfEveryDegree();
  RepeatedKnots();
  TheBorderOfTheDomain();
  FaultsAreNamed();
  return check::Verdict("TestNURBSSurface");
}
