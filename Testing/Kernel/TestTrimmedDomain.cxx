// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTrimmedDomain.cxx
 * @brief What facets cover of a patch's domain: inside and outside against the facets themselves,
 * crossings that change sides each time, also through corners and along borders; poles.
 */
#include "Check.h"
#include "DesignedShapes.h"
#include "TrimmedDomain.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using sb::DesignedSurface;
using sb::Parameters;
using sb::TrimmedDomain;

TrimmedDomain DomainOf(const DesignedSurface& designed)
{
  std::vector<std::int32_t> triangles;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(designed.FaceId.size()); ++i)
  {
    triangles.push_back(i);
  }
  return TrimmedDomain(designed, triangles);
}

bool IsChecked(double u, double v)
{
  return (static_cast<int>(u * 16.0) + static_cast<int>(v * 16.0)) % 2 == 0;
}

DesignedSurface Checkered(bool turned)
{
  DesignedSurface designed;
  patches::AddFace(designed, patches::Parallelogram({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }), 16, 16,
    IsChecked, turned);
  return designed;
}

void InsideIsWhatFacetsCover()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const bool turned : { false, true })
  {
    const TrimmedDomain domain = DomainOf(Checkered(turned));
    CHECK(domain.IsReversed() == turned);
    CHECK_EQUAL(domain.Border().size(), 128u * 4u);
    for (int k = 0; k < 20000; ++k)
    {
      const Parameters at{ uniform(random), uniform(random) };
      CHECK(domain.Contains(at) == IsChecked(at[0], at[1]));
    }
    for (const Parameters& off : { Parameters{ -0.1, 0.5 }, Parameters{ 1.1, 0.5 },
           Parameters{ 0.5, -0.1 }, Parameters{ 0.5, 1.1 }, Parameters{ 40.0, 40.0 } })
    {
      CHECK(!domain.Contains(off));
    }
    CHECK(domain.MayMeet({ 0.01, 0.02, 0.01, 0.02 }));
    CHECK(!domain.MayMeet({ 0.07, 0.12, 0.01, 0.06 })); // within a field that is not used
    CHECK(domain.MayMeet({ 0.05, 0.07, 0.01, 0.06 }));
  }
}

/** Whatever a line goes through, it is on the side at its end that the crossings say. */
void CrossingsChangeSides()
{
  const TrimmedDomain domain = DomainOf(Checkered(false));
  std::mt19937 random(2);
  std::uniform_int_distribution<int> corner(-2, 18);
  std::uniform_real_distribution<double> uniform(-0.1, 1.1);
  long total = 0;
  for (int k = 0; k < 20000; ++k)
  {
    // From corner to corner (through many more), or from anywhere to anywhere.
    const bool special = k % 2 == 0;
    const Parameters from{ special ? corner(random) / 16.0 : uniform(random),
      special ? corner(random) / 16.0 : uniform(random) };
    const Parameters to{ special ? corner(random) / 16.0 : uniform(random),
      special ? corner(random) / 16.0 : uniform(random) };
    const std::vector<TrimmedDomain::Crossing> crossings = domain.CrossingsOf(from, to);
    total += static_cast<long>(crossings.size());
    CHECK((domain.Contains(from) != domain.Contains(to)) == (crossings.size() % 2 == 1));
    for (const TrimmedDomain::Crossing& crossing : crossings)
    {
      const TrimmedDomain::Edge& edge = domain.Border()[crossing.Edge];
      for (std::size_t axis = 0; axis < 2; ++axis)
      {
        const double onLine = from[axis] + crossing.Along * (to[axis] - from[axis]);
        const double onEdge =
          edge.From[axis] + crossing.AlongEdge * (edge.To[axis] - edge.From[axis]);
        CHECK(special || std::abs(onLine - onEdge) < 1e-6);
      }
    }
    CHECK(std::is_sorted(crossings.begin(), crossings.end(),
      [](const auto& a, const auto& b) { return a.Along < b.Along; }));
  }
  CHECK(total > 20000);
}

/** Of a sphere with one vertex at each pole, the whole domain is used. */
void PolesAreOpened()
{
  const sb::NURBSSurface sphere = patches::Sphere(1.0);
  const int around = 12;
  DesignedSurface designed;
  designed.Patches.push_back(sphere);
  const auto add = [&](double u, double v) {
    const sb::Real3 x = sb::EvaluatePatch(sphere, u, v, 0).Point;
    designed.Points.insert(designed.Points.end(), x.begin(), x.end());
    designed.UV.insert(designed.UV.end(), { u, v });
  };
  add(0.0, 0.0);
  add(0.3, 1.0); // any u does
  for (const double v : { 0.25, 0.75 })
  {
    for (int i = 0; i <= around; ++i)
    {
      add(double(i) / around, v);
    }
  }
  const auto triangle = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    designed.Triangles.insert(designed.Triangles.end(), { a, b, c });
    designed.FaceId.push_back(0);
  };
  for (std::int32_t i = 0; i < around; ++i)
  {
    const std::int32_t low = 2 + i;
    const std::int32_t high = low + around + 1;
    triangle(0, low + 1, low);
    triangle(low, low + 1, high + 1);
    triangle(low, high + 1, high);
    triangle(high, high + 1, 1);
  }
  const TrimmedDomain domain = DomainOf(designed);
  CHECK(!domain.IsReversed());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int k = 0; k < 5000; ++k)
  {
    CHECK(domain.Contains({ uniform(random), uniform(random) }));
    CHECK(!domain.Contains({ uniform(random), 1.0 + 0.1 * uniform(random) + 1e-6 }));
  }
}

} // namespace

int main()
{
  InsideIsWhatFacetsCover();
  CrossingsChangeSides();
  PolesAreOpened();
  return check::Verdict("TestTrimmedDomain");
}
