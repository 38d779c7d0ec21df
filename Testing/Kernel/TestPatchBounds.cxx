// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPatchBounds.cxx
 * @brief Bounds of parts of patches: all samples are within, no parameter line is longer, and both
 * close in as the part shrinks; the tree of cells keeps what is near and is closed around.
 */
#include "Check.h"
#include "Clouds.h"
#include "DesignedShapes.h"
#include "PatchBounds.h"
#include "PatchQuadtree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

using sb::NURBSSurface;
using sb::ParameterBox;
using sb::PatchBounds;
using sb::Real3;

constexpr int Samples = 24;

Real3 At(const NURBSSurface& patch, const ParameterBox& box, int i, int j)
{
  return sb::EvaluatePatch(patch, box.FirstU + (box.LastU - box.FirstU) * i / Samples,
    box.FirstV + (box.LastV - box.FirstV) * j / Samples, 0)
    .Point;
}

/** The longest sampled lines, along u and along v. */
std::pair<double, double> LongestLines(const NURBSSurface& patch, const ParameterBox& box)
{
  std::pair<double, double> longest;
  for (int line = 0; line <= Samples; ++line)
  {
    double alongU = 0.0;
    double alongV = 0.0;
    for (int k = 0; k < Samples; ++k)
    {
      alongU += sb::Length(sb::Difference(At(patch, box, k + 1, line), At(patch, box, k, line)));
      alongV += sb::Length(sb::Difference(At(patch, box, line, k + 1), At(patch, box, line, k)));
    }
    longest = { std::max(longest.first, alongU), std::max(longest.second, alongV) };
  }
  return longest;
}

void CheckBounds(const NURBSSurface& patch, const ParameterBox& box, double slack)
{
  const PatchBounds bounds = sb::BoundsOf(patch, box);
  for (int i = 0; i <= Samples; ++i)
  {
    for (int j = 0; j <= Samples; ++j)
    {
      const Real3 x = At(patch, box, i, j);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        CHECK(x[axis] >= bounds.Lower[axis] - 1e-13 && x[axis] <= bounds.Upper[axis] + 1e-13);
      }
    }
  }
  const auto [alongU, alongV] = LongestLines(patch, box);
  CHECK(alongU <= bounds.LengthU * (1.0 + 1e-12));
  CHECK(alongV <= bounds.LengthV * (1.0 + 1e-12));
  if (slack > 0.0)
  {
    const double size = alongU + alongV;
    CHECK(bounds.LengthU <= alongU + slack * size);
    CHECK(bounds.LengthV <= alongV + slack * size);
    CHECK(sb::Length(sb::Difference(bounds.Upper, bounds.Lower)) <= 1.5 * size);
  }
}

void BoundsHold()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform;
  const NURBSSurface shapes[] = { patches::Sphere(1.0), patches::Torus(1.0, 0.4),
    patches::FreeForm(3, 3, 9, 8, 0.8, random), patches::FreeForm(5, 2, 30, 5, 0.8, random, false),
    patches::FreeForm(1, 7, 5, 9, 0.8, random), patches::FreeForm(25, 1, 26, 3, 0.8, random) };
  for (const NURBSSurface& patch : shapes)
  {
    CheckBounds(patch, { 0.0, 1.0, 0.0, 1.0 }, 0.0);
    CheckBounds(patch, { -0.5, 1.5, 0.25, 0.5 }, 0.0); // beyond the domain there is nothing
    for (int k = 0; k < 20; ++k)
    {
      const double u = uniform(random);
      const double v = uniform(random);
      CheckBounds(patch, { u, std::min(1.0, u + 0.2), v, std::min(1.0, v + 0.1) }, 0.0);
      // Of a small part they are almost what it measures.
      CheckBounds(patch, { 0.9 * u, 0.9 * u + 1e-4, 0.9 * v, 0.9 * v + 1e-4 }, 0.02);
    }
  }
}

/** Each edge of a ring is the edge of one other ring, in the other direction, or at a border of
 * what the tree keeps; and every place of the patch that is near is in a cell. */
void TreesAreClosed()
{
  const sb::CloudSurface made = clouds::SurfaceOf(clouds::Sphere(3000));
  std::mt19937 random(2);
  sb::ThreadExecutor executor(2);
  sb::Monitor monitor;
  const double reach = made.Surface->Width();
  // Speeds along a line of the patch differ a lot, so that levels do.
  const NURBSSurface shapes[] = { patches::FreeForm(3, 3, 12, 12, 1.0, random),
    patches::Moved(patches::Sphere(1.0), { 0.5, 0, 0.2 }), patches::Cylinder(0.9, 9.0) };
  for (const NURBSSurface& patch : shapes)
  {
    const sb::DesignedSurface designed = patches::OneFace(patch, 2, 2);
    std::vector<std::int32_t> triangles;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(designed.FaceId.size()); ++i)
    {
      triangles.push_back(i);
    }
    const sb::TrimmedDomain domain(designed, triangles);
    const sb::PatchQuadtree tree(
      patch, domain, made.Surface->Samples(), { reach, 0.5 * reach }, executor, monitor);
    CHECK(tree.NumberOfCells() > 100);
    std::set<std::pair<std::size_t, std::size_t>> edges;
    std::map<std::size_t, int> sizes;
    std::vector<std::size_t> ring;
    for (std::size_t cell = 0; cell < tree.NumberOfCells(); ++cell)
    {
      tree.RingOf(cell, ring);
      ++sizes[ring.size()];
      CHECK(ring.size() >= 4 && ring.size() <= 8);
      for (std::size_t k = 0; k < ring.size(); ++k)
      {
        CHECK(edges.insert({ ring[k], ring[(k + 1) % ring.size()] }).second);
      }
      const PatchBounds bounds = sb::BoundsOf(patch, tree.BoxOf(cell));
      CHECK(bounds.LengthU <= 0.5 * reach && bounds.LengthV <= 0.5 * reach);
    }
    CHECK(sizes.size() > 1 || patch.CountV == 2); // cells with smaller neighbours
    // Where nothing is on the other side, no sample is near.
    std::uniform_real_distribution<double> uniform;
    for (int k = 0; k < 2000; ++k)
    {
      const double u = uniform(random);
      const double v = uniform(random);
      const Real3 x = sb::EvaluatePatch(patch, u, v, 0).Point;
      sb::PointTree::Neighbour nearest{};
      made.Surface->Samples().Nearest(x, 1, &nearest);
      if (nearest.SquaredDistance < reach * reach)
      {
        bool isIn = false;
        for (std::size_t cell = 0; cell < tree.NumberOfCells() && !isIn; ++cell)
        {
          const ParameterBox box = tree.BoxOf(cell);
          isIn = u >= box.FirstU && u <= box.LastU && v >= box.FirstV && v <= box.LastV;
        }
        CHECK(isIn);
      }
    }
  }
}

} // namespace

int main()
{
  BoundsHold();
  TreesAreClosed();
  return check::Verdict("TestPatchBounds");
}
