// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBroadPhase.cxx
 * @brief The broad phase and its hierarchy find what comparing every box with every other finds, in
 * the same order.
 */
#include "BVH.h"
#include "BroadPhase.h"
#include "Check.h"
#include "ThreadExecutor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace sb
{

static bool operator==(const TrianglePair& a, const TrianglePair& b)
{
  return a.SurfaceA == b.SurfaceA && a.TriangleA == b.TriangleA && a.SurfaceB == b.SurfaceB &&
    a.TriangleB == b.TriangleB;
}

} // namespace sb

namespace
{

using sb::Box;
using sb::TrianglePair;
using Random = std::mt19937_64;

double Uniform(Random& random, double lower, double upper)
{
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

struct Mesh
{
  std::vector<double> Points;
  std::vector<std::int32_t> Triangles;
  bool Self = false;

  std::int64_t NumberOfTriangles() const
  {
    return static_cast<std::int64_t>(this->Triangles.size() / 3);
  }

  void Add(const std::array<std::array<double, 3>, 3>& corners)
  {
    for (const auto& corner : corners)
    {
      this->Triangles.push_back(static_cast<std::int32_t>(this->Points.size() / 3));
      this->Points.insert(this->Points.end(), corner.begin(), corner.end());
    }
  }

  Box BoxOf(std::int64_t triangle) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{ { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
    for (std::int64_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double x = this->Points[static_cast<std::size_t>(
                                        3 * this->Triangles[static_cast<std::size_t>(corner)]) +
          axis];
        box.Lower[axis] = std::min(box.Lower[axis], x);
        box.Upper[axis] = std::max(box.Upper[axis], x);
      }
    }
    return box;
  }

  sb::BroadPhaseSurface Surface() const
  {
    // An empty surface has bounds that say nothing.
    Box all{ { 1.0, 1.0, 1.0 }, { -1.0, -1.0, -1.0 } };
    for (std::int64_t i = 0; i < this->NumberOfTriangles(); ++i)
    {
      i == 0 ? void(all = this->BoxOf(i)) : sb::Enclose(all, this->BoxOf(i));
    }
    return { this->Points.data(), this->Triangles.data(), this->NumberOfTriangles(),
      { all.Lower[0], all.Upper[0], all.Lower[1], all.Upper[1], all.Lower[2], all.Upper[2] },
      this->Self };
  }
};

using Meshes = std::vector<Mesh>;

std::vector<TrianglePair> PairsByBruteForce(const Meshes& meshes)
{
  struct Entry
  {
    std::int32_t Surface;
    std::int32_t Triangle;
    Box Bounds;
  };
  std::vector<Entry> all;
  for (std::size_t surface = 0; surface < meshes.size(); ++surface)
  {
    for (std::int64_t i = 0; i < meshes[surface].NumberOfTriangles(); ++i)
    {
      all.push_back({ static_cast<std::int32_t>(surface), static_cast<std::int32_t>(i),
        meshes[surface].BoxOf(i) });
    }
  }
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t j = i + 1; j < all.size(); ++j)
    {
      const Entry& a = all[i];
      const Entry& b = all[j];
      bool meet = a.Surface != b.Surface || meshes[static_cast<std::size_t>(a.Surface)].Self;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        meet = meet && a.Bounds.Lower[axis] <= b.Bounds.Upper[axis] &&
          b.Bounds.Lower[axis] <= a.Bounds.Upper[axis];
      }
      if (meet)
      {
        pairs.push_back({ a.Surface, a.Triangle, b.Surface, b.Triangle });
      }
    }
  }
  return pairs;
}

std::vector<TrianglePair> Find(const Meshes& meshes, int threads)
{
  std::vector<sb::BroadPhaseSurface> surfaces;
  for (const Mesh& mesh : meshes)
  {
    surfaces.push_back(mesh.Surface());
  }
  sb::ThreadExecutor executor(threads);
  sb::Monitor monitor;
  return sb::FindOverlappingPairs(surfaces, executor, monitor);
}

std::int64_t TotalOfPairs = 0;

void CheckAgainstBruteForce(const Meshes& meshes)
{
  const std::vector<TrianglePair> expected = PairsByBruteForce(meshes);
  TotalOfPairs += static_cast<std::int64_t>(expected.size());
  CHECK(Find(meshes, 1) == expected);
  CHECK(Find(meshes, 3) == expected);
}

/** A triangle about `middle`, its corners at most `reach` away on each axis. */
std::array<std::array<double, 3>, 3> TriangleAbout(
  const std::array<double, 3>& middle, const std::array<double, 3>& reach, Random& random)
{
  std::array<std::array<double, 3>, 3> corners;
  for (auto& corner : corners)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      corner[axis] = middle[axis] + Uniform(random, -1.0, 1.0) * reach[axis];
    }
  }
  return corners;
}

/** How a soup's triangles are made. */
enum class Kind
{
  Uniform,
  AllSizes, // six orders of magnitude, mixed
  Needles, // long along a random axis
  Coplanar, // all in one plane
  Lattice, // corners on a coarse lattice: boxes touch, coincide, degenerate to points and segments
  FewHuge, // two triangles across everything, the others tiny
  Clustered, // nearly all in one small corner
  Duplicates, // all the same
  Count
};

Mesh RandomSoup(Kind kind, int triangles, Random& random)
{
  Mesh mesh;
  for (int i = 0; i < triangles; ++i)
  {
    std::array<double, 3> middle = { Uniform(random, -1.0, 1.0), Uniform(random, -1.0, 1.0),
      Uniform(random, -1.0, 1.0) };
    double size = 0.05;
    if (kind == Kind::AllSizes)
    {
      size = std::pow(10.0, Uniform(random, -6.0, 0.0));
    }
    else if (kind == Kind::FewHuge)
    {
      size = i % 997 < 2 ? 2.0 : 0.01;
    }
    else if (kind == Kind::Clustered && i % 50 != 0)
    {
      middle = { 0.9 + 1e-9 * middle[0], 0.9 + 1e-9 * middle[1], 0.9 + 1e-9 * middle[2] };
      size = 1e-10;
    }
    std::array<double, 3> reach = { size, size, size };
    if (kind == Kind::Needles)
    {
      reach[random() % 3] *= 20.0;
      reach[random() % 3] *= 0.01;
    }
    else if (kind == Kind::Coplanar)
    {
      middle[2] = 0.25;
      reach[2] = 0.0;
    }
    else if (kind == Kind::Duplicates)
    {
      middle = { 0.5, 0.25, 0.125 };
      reach = { 0.0, 0.0, 0.0 };
    }
    auto corners = TriangleAbout(middle, reach, random);
    if (kind == Kind::Lattice)
    {
      for (auto& corner : corners)
      {
        for (double& x : corner)
        {
          x = std::round(x * 10.0);
        }
      }
    }
    mesh.Add(corners);
  }
  return mesh;
}

void SoupsOfEveryKind()
{
  Random random(1);
  for (int kind = 0; kind < static_cast<int>(Kind::Count); ++kind)
  {
    for (int round = 0; round < 12; ++round)
    {
      const int surfaces = 1 + round % 6;
      Meshes meshes;
      for (int i = 0; i < surfaces; ++i)
      {
        const int triangles = kind == static_cast<int>(Kind::Duplicates) ? 30
          : round == 7                                                   ? 3
                                                                         : 200;
        meshes.push_back(RandomSoup(static_cast<Kind>(kind), triangles * (1 + i % 3), random));
        meshes.back().Self = round % 3 == 1 || (round % 3 == 2 && i == 1);
      }
      CheckAgainstBruteForce(meshes);
    }
  }
}

void SoupsOfTwoKinds()
{
  Random random(2);
  for (int a = 0; a < static_cast<int>(Kind::Count); ++a)
  {
    for (int b = 0; b < static_cast<int>(Kind::Count); ++b)
    {
      CheckAgainstBruteForce({ RandomSoup(static_cast<Kind>(a), 900, random),
        RandomSoup(static_cast<Kind>(b), 100, random) });
    }
  }
}

/** Moving and scaling all coordinates must not lose a pair, down to where they are no longer told
 * apart. */
void FarFromTheOriginAndOfAnyScale()
{
  Random random(3);
  for (const double shift : { 0.0, 1e6, -1e15 })
  {
    for (const double scale : { 1e-300, 1e-30, 1e-6, 1.0, 1e6, 1e290 })
    {
      Meshes meshes = { RandomSoup(Kind::Uniform, 300, random),
        RandomSoup(Kind::AllSizes, 300, random) };
      for (Mesh& mesh : meshes)
      {
        for (double& x : mesh.Points)
        {
          x = (x + shift) * scale;
        }
      }
      CheckAgainstBruteForce(meshes);
    }
  }
}

/** Boxes one step of a double apart do not meet; boxes that share one coordinate do. */
void TouchingIsMeetingAndNextToItIsNot()
{
  const auto wall = [](double x) {
    Mesh mesh;
    mesh.Add({ { { x, 0.0, 0.0 }, { x, 1.0, 0.0 }, { x, 0.0, 1.0 } } });
    return mesh;
  };
  for (const double x : { 0.0, 1.0 / 3.0, 1e10 + 1.0 / 3.0, -7e-200 })
  {
    const double beside = std::nextafter(x, 2e10);
    CHECK_EQUAL(Find({ wall(x), wall(x) }, 1).size(), std::size_t(1));
    CHECK_EQUAL(Find({ wall(x), wall(beside) }, 1).size(), std::size_t(0));
    Mesh both = wall(x);
    both.Add({ { { beside, 0.0, 0.0 }, { beside, 1.0, 0.0 }, { beside, 0.0, 1.0 } } });
    both.Self = true;
    CHECK_EQUAL(Find({ both }, 1).size(), std::size_t(0));
    CHECK_EQUAL(Find({ both, wall(beside) }, 1).size(), std::size_t(1));
  }
}

Mesh Sphere(int meridians, int parallels, double radius, const std::array<double, 3>& middle)
{
  Mesh mesh;
  const double pi = std::acos(-1.0);
  for (int j = 0; j <= parallels; ++j)
  {
    for (int i = 0; i < meridians; ++i)
    {
      const double theta = 2.0 * pi * i / meridians;
      const double phi = pi * j / parallels;
      mesh.Points.insert(mesh.Points.end(),
        { middle[0] + radius * std::sin(phi) * std::cos(theta),
          middle[1] + radius * std::sin(phi) * std::sin(theta),
          middle[2] + radius * std::cos(phi) });
    }
  }
  for (int j = 0; j < parallels; ++j)
  {
    for (int i = 0; i < meridians; ++i)
    {
      const int a = j * meridians + i;
      const int b = j * meridians + (i + 1) % meridians;
      mesh.Triangles.insert(
        mesh.Triangles.end(), { a, a + meridians, b + meridians, a, b + meridians, b });
    }
  }
  return mesh;
}

/** Sweep along x over the boxes of both spheres: an independent count where brute force is too
 * slow. */
std::size_t CountBySweep(const Mesh& a, const Mesh& b)
{
  std::vector<std::pair<Box, bool>> boxes;
  for (const Mesh* mesh : { &a, &b })
  {
    for (std::int64_t i = 0; i < mesh->NumberOfTriangles(); ++i)
    {
      boxes.emplace_back(mesh->BoxOf(i), mesh == &a);
    }
  }
  std::sort(boxes.begin(), boxes.end(),
    [](const auto& p, const auto& q) { return p.first.Lower[0] < q.first.Lower[0]; });
  std::size_t count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (std::size_t j = i + 1;
         j < boxes.size() && boxes[j].first.Lower[0] <= boxes[i].first.Upper[0]; ++j)
    {
      count +=
        boxes[i].second != boxes[j].second && sb::Overlap(boxes[i].first, boxes[j].first) ? 1 : 0;
    }
  }
  return count;
}

void LargeSpheresAgreeWithASweep()
{
  const Mesh a = Sphere(400, 200, 1.0, { 0.0, 0.0, 0.0 });
  const Mesh b = Sphere(500, 200, 1.0, { 0.5, 0.01, 0.02 });
  const std::vector<TrianglePair> pairs = Find({ a, b }, 1);
  CHECK_EQUAL(pairs.size(), CountBySweep(a, b));
  CHECK(pairs.size() > 10000);
  CHECK(Find({ a, b }, 2) == pairs);
}

/** The numbers of pairs are proportional to the number of spheres, and those of disjoint spheres
 * are none. */
void ThousandSpheresOnAPlate()
{
  Mesh plate;
  plate.Add({ { { -2.0, -2.0, 0.0 }, { 98.0, -2.0, 0.0 }, { 98.0, 98.0, 0.0 } } });
  plate.Add({ { { -2.0, -2.0, 0.0 }, { 98.0, 98.0, 0.0 }, { -2.0, 98.0, 0.0 } } });
  Meshes meshes = { plate };
  for (int i = 0; i < 1000; ++i)
  {
    meshes.push_back(Sphere(16, 9, 1.0, { 3.0 * (i % 32), 3.0 * (i / 32), 0.0 }));
  }
  // The box of either plate triangle is the whole plate; it meets the 32 triangles of each sphere's
  // middle belt.
  CHECK_EQUAL(Find(meshes, 2).size(), std::size_t(2 * 1000 * 32));
  meshes.front() = Mesh();
  CHECK_EQUAL(Find(meshes, 2).size(), std::size_t(0));
}

/** More surfaces than the occupancy grid has owners for, each a point, on top of each other two by
 * two. */
void SeventyThousandSurfaces()
{
  Meshes meshes(70000);
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    const double x = static_cast<double>(i / 2);
    meshes[i].Add({ { { x, 0.0, 0.0 }, { x, 0.0, 0.0 }, { x, 0.0, 0.0 } } });
  }
  const std::vector<TrianglePair> pairs = Find(meshes, 2);
  CHECK_EQUAL(pairs.size(), meshes.size() / 2);
  CHECK(std::all_of(pairs.begin(), pairs.end(), [](const TrianglePair& pair) {
    return pair.SurfaceA % 2 == 0 && pair.SurfaceB == pair.SurfaceA + 1;
  }));
}

void NothingComesOfNothing()
{
  CHECK(Find({}, 1).empty());
  CHECK(Find({ Mesh(), Mesh() }, 1).empty());
  Mesh empty;
  empty.Self = true;
  CHECK(Find({ empty }, 1).empty());
  CHECK(Find({ Sphere(8, 4, 1.0, { 0.0, 0.0, 0.0 }) }, 1).empty());
  CHECK(Find({ Sphere(8, 4, 1.0, { 0.0, 0.0, 0.0 }), Sphere(8, 4, 1.0, { 5.0, 0.0, 0.0 }) }, 1)
          .empty());
}

/** Says stop after being asked some number of times. */
class StoppingMonitor : public sb::Monitor
{
public:
  explicit StoppingMonitor(int patience)
    : Patience(patience)
  {
  }
  bool Aborted() override { return --this->Patience < 0; }

private:
  std::atomic<int> Patience;
};

void StopsWhenAsked()
{
  const Mesh a = Sphere(200, 100, 1.0, { 0.0, 0.0, 0.0 });
  const Mesh b = Sphere(200, 100, 1.0, { 0.5, 0.01, 0.02 });
  sb::ThreadExecutor executor(2);
  bool completed = false;
  int patience = 0;
  for (; patience < 1000 && !completed; ++patience)
  {
    StoppingMonitor monitor(patience);
    completed = !sb::FindOverlappingPairs({ a.Surface(), b.Surface() }, executor, monitor).empty();
  }
  CHECK(completed);
  CHECK(patience > 10);
}

/** The hierarchy by itself: every query meets exactly the boxes that comparing them all finds. */
void HierarchyAnswersLikeAList()
{
  Random random(4);
  sb::ThreadExecutor executor(2);
  for (int kind = 0; kind < static_cast<int>(Kind::Count); ++kind)
  {
    for (const int count : { 0, 1, 7, 8, 9, 64, 65, 1000, 5000 })
    {
      const Mesh soup = RandomSoup(static_cast<Kind>(kind), count, random);
      std::vector<Box> boxes;
      for (int i = 0; i < count; ++i)
      {
        boxes.push_back(soup.BoxOf(i));
      }
      sb::BVH tree;
      tree.Build(boxes.data(), count, executor);
      CHECK_EQUAL(tree.Size(), count);
      const Mesh questions = RandomSoup(Kind::AllSizes, 64, random);
      for (int i = 0; i < 64;)
      {
        // One query alone, then two together, and so on; some of them are boxes of the hierarchy
        // itself.
        const int together = std::min(1 + i % sb::BVH::Width, 64 - i);
        std::vector<sb::BVH::Query> queries;
        for (const int last = i + together; i < last; ++i)
        {
          queries.push_back(
            { i % 2 == 0 || count == 0 ? questions.BoxOf(i)
                                       : boxes[static_cast<std::size_t>(i * 7 % count)],
              i % 3 == 0 ? 0 : i * count / 64 });
        }
        std::vector<std::pair<int, std::int32_t>> found;
        tree.ForEachOverlap(queries.data(), together,
          [&](int query, std::int32_t box) { found.emplace_back(query, box); });
        std::sort(found.begin(), found.end());
        std::vector<std::pair<int, std::int32_t>> expected;
        for (int query = 0; query < together; ++query)
        {
          for (int j = queries[static_cast<std::size_t>(query)].First; j < count; ++j)
          {
            if (sb::Overlap(queries[static_cast<std::size_t>(query)].Extent,
                  boxes[static_cast<std::size_t>(j)]))
            {
              expected.emplace_back(query, j);
            }
          }
        }
        CHECK(found == expected);
      }
    }
  }
}

} // namespace

int main()
{
  HierarchyAnswersLikeAList();
  SoupsOfEveryKind();
  SoupsOfTwoKinds();
  FarFromTheOriginAndOfAnyScale();
  TouchingIsMeetingAndNextToItIsNot();
  LargeSpheresAgreeWithASweep();
  ThousandSpheresOnAPlate();
  SeventyThousandSurfaces();
  NothingComesOfNothing();
  StopsWhenAsked();
  CHECK(TotalOfPairs > 100000);
  return check::Verdict("TestBroadPhase");
}
