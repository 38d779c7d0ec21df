// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceRefinement.cxx
 * @brief Refinement near a cloud: closed and conforming, short edges wherever a sample is near and
 * nothing else touched, no worse angles, new points on the patches, the same for all threads.
 */
#include "Check.h"
#include "Clouds.h"
#include "Designed.h"
#include "Patches.h"
#include "SurfaceRefinement.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{

using sb::Real3;

sb::PointTree TreeOf(const clouds::Cloud& cloud)
{
  sb::SerialExecutor executor;
  return sb::PointTree(cloud.Points.data(), cloud.Count(), nullptr, executor);
}

sb::RefinedSurface Refined(const sb::DesignedSurface& surface, const sb::PointTree& tree,
  double near, double edge, double error = 0.0, int threads = 2)
{
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  return sb::RefineNearCloud(surface, tree, { near, edge, error }, executor, monitor);
}

double Gap(const Real3& a, const Real3& b) { return sb::Length(sb::Difference(a, b)); }

std::array<Real3, 3> CornersOf(const sb::DesignedSurface& surface, std::size_t t)
{
  return { designed::PointOf(surface, surface.Triangles[3 * t]),
    designed::PointOf(surface, surface.Triangles[3 * t + 1]),
    designed::PointOf(surface, surface.Triangles[3 * t + 2]) };
}

double LongestEdge(const std::array<Real3, 3>& p)
{
  return std::max({ Gap(p[0], p[1]), Gap(p[1], p[2]), Gap(p[2], p[0]) });
}

double SmallestAngle(const std::array<Real3, 3>& p)
{
  double smallest = clouds::Pi;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Real3 a = sb::Difference(p[(k + 1) % 3], p[k]);
    const Real3 b = sb::Difference(p[(k + 2) % 3], p[k]);
    smallest = std::min(smallest, std::atan2(sb::Length(sb::Cross(a, b)), sb::Dot(a, b)));
  }
  return smallest;
}

/** Near triangles have short edges, by a look at places on each triangle and all samples. */
void CheckEdges(
  const sb::RefinedSurface& refined, const sb::PointTree& tree, double near, double edge)
{
  for (std::size_t t = 0; t < refined.Original.size(); ++t)
  {
    const std::array<Real3, 3> p = CornersOf(refined.Surface, t);
    if (LongestEdge(p) <= edge)
    {
      continue;
    }
    CHECK(!refined.IsNear[t]);
    for (int i = 0; i <= 12; ++i)
    {
      for (int j = 0; i + j <= 12; ++j)
      {
        const Real3 x = sb::PlusScaled(sb::PlusScaled(p[0], i / 12.0, sb::Difference(p[1], p[0])),
          j / 12.0, sb::Difference(p[2], p[0]));
        sb::PointTree::Neighbour nearest;
        CHECK(tree.Nearest(x, 1, &nearest) == 1 &&
          nearest.SquaredDistance >= near * near * (1 - 1e-12));
      }
    }
  }
}

/** A box of points of its own for each triangle, a small sphere through its face, edge, corner. */
void ABoxIsRefinedWhereTheCloudIs()
{
  for (const Real3& centre : { Real3{ 3.1, 2.7, 10.0 }, Real3{ 10, 10, 1 }, Real3{ 10, 10, 10 } })
  {
    clouds::Cloud cloud = clouds::Sphere(2000);
    for (std::size_t i = 0; i < cloud.Points.size(); ++i)
    {
      cloud.Points[i] += centre[i % 3];
    }
    const sb::PointTree tree = TreeOf(cloud);
    shapes::Mesh soup;
    const shapes::Mesh box = shapes::Cube(-10, 10);
    for (const shapes::Corners& t : box.Triangles)
    {
      soup.AddTriangle(box.At(t, 0), box.At(t, 1), box.At(t, 2));
    }
    for (const shapes::Mesh& mesh : { box, soup })
    {
      const sb::RefinedSurface refined = Refined(designed::FromMesh(mesh), tree, 0.2, 0.08);
      const shapes::Mesh made = designed::ToMesh(refined.Surface);
      CHECK_EQUAL(shapes::NumberOfOpenEdges(made), 0);
      CHECK(std::abs(shapes::Volume(made) - 8000.0) < 1e-9);
      CHECK(std::abs(shapes::Area(made) - 2400.0) < 1e-9);
      CheckEdges(refined, tree, 0.2, 0.08);
      // The ring has an area of 2 pi 0.4, and a triangle at least an eighth of edge^2; the rest is
      // what leads from large triangles to small ones.
      CHECK(refined.Original.size() < 12000);
      CHECK(std::count(refined.IsNear.begin(), refined.IsNear.end(), 1) > 400);
      CHECK(std::is_sorted(refined.Original.begin(), refined.Original.end()));
      for (std::size_t t = 0; t < refined.Original.size(); ++t)
      {
        const std::array<Real3, 3> p = CornersOf(refined.Surface, t);
        CHECK(!refined.IsNear[t] || SmallestAngle(p) > 0.5 * clouds::Pi / 4.0 - 1e-9);
      }
    }
  }
}

/** What is far is passed on as it is, and costs no triangle. */
void TheRestStaysAsItWas()
{
  const sb::PointTree tree = TreeOf(clouds::Sphere(2000));
  shapes::Mesh mesh = shapes::Box({ -3, -3, 0.2 }, { 3, 3, 4 });
  const sb::RefinedSurface alone = Refined(designed::FromMesh(mesh), tree, 0.2, 0.08);
  mesh.Append(shapes::Sphere({ 100, 0, 0 }, 50.0, 100));
  const sb::DesignedSurface both = designed::FromMesh(mesh);
  const sb::RefinedSurface refined = Refined(both, tree, 0.2, 0.08);
  CHECK_EQUAL(refined.Original.size(), alone.Original.size() + 80000);
  CHECK(std::equal(both.Points.begin(), both.Points.end(), refined.Surface.Points.begin()));
  CHECK(std::equal(
    both.Triangles.begin() + 36, both.Triangles.end(), refined.Surface.Triangles.end() - 240000));
  // Triangles that are short enough stay, near or not; so does all if nothing is near.
  const sb::DesignedSurface ball = designed::FromMesh(shapes::Sphere({ 0, 0, 0 }, 1.0, 30));
  CHECK(Refined(ball, tree, 0.2, 0.1).Surface.Triangles == ball.Triangles);
  const sb::DesignedSurface far = designed::FromMesh(shapes::Cube(5, 9));
  CHECK(Refined(far, tree, 0.2, 0.1).Surface.Points == far.Points);
  CHECK(Refined(sb::DesignedSurface(), tree, 0.2, 0.1).Original.empty());
}

void ThreadsAndTheOrderOfSamplesDoNotMatter()
{
  std::mt19937 random(1);
  clouds::Cloud cloud = clouds::Torus(3000, random);
  const sb::DesignedSurface surface = designed::FromMesh(shapes::Box({ 0, 0, 0 }, { 3, 3, 3 }));
  const sb::RefinedSurface one = Refined(surface, TreeOf(cloud), 0.2, 0.06, 0.0, 1);
  std::vector<std::size_t> order(static_cast<std::size_t>(cloud.Count()));
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), random);
  clouds::Cloud shuffled;
  for (const std::size_t i : order)
  {
    shuffled.Add({ cloud.Points[3 * i], cloud.Points[3 * i + 1], cloud.Points[3 * i + 2] }, {});
  }
  const sb::RefinedSurface other = Refined(surface, TreeOf(shuffled), 0.2, 0.06, 0.0, 3);
  CHECK(one.Original.size() > 1000);
  CHECK(one.Surface.Points == other.Surface.Points);
  CHECK(one.Surface.Triangles == other.Surface.Triangles);
  CHECK(one.Original == other.Original && one.IsNear == other.IsNear);
}

/** Points on their patch, within the chord error, closed where they were. */
void CheckPatches(const sb::DesignedSurface& surface, const sb::RefinedSurface& refined,
  double error, double onBoth)
{
  const sb::DesignedSurface& made = refined.Surface;
  CHECK_EQUAL(shapes::NumberOfOpenEdges(designed::ToMesh(made)), 0);
  CHECK(made.Triangles.size() > 2 * surface.Triangles.size());
  CHECK_EQUAL(made.FaceId.size(), refined.Original.size());
  for (std::size_t t = 0; t < refined.Original.size(); ++t)
  {
    CHECK_EQUAL(made.FaceId[t], surface.FaceId[static_cast<std::size_t>(refined.Original[t])]);
    const sb::NURBSSurface& patch = made.Patches[static_cast<std::size_t>(made.FaceId[t])];
    Real3 middle{};
    double u = 0.0;
    double v = 0.0;
    bool atPole = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = static_cast<std::size_t>(made.Triangles[3 * t + k]);
      const Real3 x = designed::PointOf(made, made.Triangles[3 * t + k]);
      CHECK(Gap(sb::EvaluatePatch(patch, made.UV[2 * i], made.UV[2 * i + 1], 0).Point, x) < onBoth);
      atPole = atPole || std::hypot(x[0], x[1]) < 1e-9;
      middle = sb::PlusScaled(middle, 1.0 / 3.0, x);
      u += made.UV[2 * i] / 3.0;
      v += made.UV[2 * i + 1] / 3.0;
    }
    if (refined.IsNear[t] && !atPole)
    {
      CHECK(Gap(sb::EvaluatePatch(patch, u, v, 0).Point, middle) <= error);
    }
  }
}

void PatchesAreFollowed()
{
  // A closed sphere of one patch: a seam, and two poles.
  sb::DesignedSurface ball;
  designed::AddPatch(ball, patches::Sphere(1.0), 8, 4);
  std::mt19937 random(2);
  const sb::PointTree tree = TreeOf(clouds::Torus(20000, random));
  for (const double error : { 1.0, 1e-3, 1e-4 })
  {
    const sb::RefinedSurface refined = Refined(ball, tree, 0.1, 0.1, error);
    CheckPatches(ball, refined, error, 1e-9);
    // All that a sample is near to is fine, although the facets were far from it at first.
    for (std::int32_t i = 0; i < tree.Size(); ++i)
    {
      const Real3 x = tree.Point(i);
      if (std::abs(sb::Length(x) - 1.0) > 0.05)
      {
        continue;
      }
      const Real3 foot = sb::Scaled(x, 1.0 / sb::Length(x));
      double nearest = 2.0;
      for (std::size_t p = 0; p < refined.Surface.Points.size() && nearest > 0.1; p += 3)
      {
        nearest = std::min(
          nearest, Gap(foot, designed::PointOf(refined.Surface, static_cast<std::int32_t>(p / 3))));
      }
      CHECK(nearest <= 0.1);
      i += 50;
    }
  }
}

/** A drum: its wall meets a flat patch below and a dome above, with other parameters and points.
 */
void EdgesOfTwoFacesLieOnBoth()
{
  sb::DesignedSurface drum;
  designed::AddPatch(drum, patches::Cylinder(1.0, 0.5), 12, 2);
  designed::AddPatch(drum,
    patches::Revolution({ { 1, 0.5, 1 }, { 1, 1, 1 }, { 0, 1, 1 } }, 2, { 0, 0, 0, 1, 1, 1 }), 12,
    3);
  designed::AddPatch(drum,
    patches::Revolution(
      { { 0, -0.5, 1 }, { 0.5, -0.5, 1 }, { 1, -0.5, 1 } }, 2, { 0, 0, 0, 1, 1, 1 }),
    12, 3);
  const sb::PointTree tree = TreeOf(clouds::Sphere(5000)); // meets the dome and the wall's low end
  const sb::RefinedSurface refined = Refined(drum, tree, 0.2, 0.05, 1e-4);
  CheckPatches(drum, refined, 1e-4, 1e-9);
  long onRim = 0;
  for (std::size_t i = drum.Points.size(); i < refined.Surface.Points.size(); i += 3)
  {
    const Real3 x = designed::PointOf(refined.Surface, static_cast<std::int32_t>(i / 3));
    if (std::abs(x[2] + 0.5) < 1e-6 && std::hypot(x[0], x[1]) > 1.0 - 1e-6)
    {
      ++onRim;
      CHECK(std::abs(x[2] + 0.5) < 1e-12 && std::abs(std::hypot(x[0], x[1]) - 1.0) < 1e-12);
    }
  }
  CHECK(onRim > 100);
}

} // namespace

int main()
{
  ABoxIsRefinedWhereTheCloudIs();
  TheRestStaysAsItWas();
  ThreadsAndTheOrderOfSamplesDoNotMatter();
  PatchesAreFollowed();
  EdgesOfTwoFacesLieOnBoth();
  return check::Verdict("TestSurfaceRefinement");
}
