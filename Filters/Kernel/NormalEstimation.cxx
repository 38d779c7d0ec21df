// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NormalEstimation.h"

#include "ParallelSort.h"
#include "SymmetricEigen.h"

#include <algorithm>

namespace sb
{
namespace
{

constexpr int MostNeighbours = 64; ///< that a plane is fitted to, beside the point itself
constexpr int TreeNeighbours = 8; ///< that signs may come from
constexpr double FlattestDoubt = 0.2; ///< of the smallest to the middle eigenvalue
constexpr double ThinnestPlane = 1e-4; ///< of the middle to the largest eigenvalue: a line
constexpr std::int64_t Grain = 1024;

/** A pair of neighbours, and how little it says: 0 is sure. */
struct Pair
{
  std::uint32_t Cost;
  std::int32_t First;
  std::int32_t Second;
  std::int32_t Opposite; ///< 1 if the normals as they are have different sides
};

/** All steps of the estimation and what they share. */
class Estimation
{
public:
  Estimation(const PointTree& tree, int neighbours, Executor& executor, Monitor& monitor)
    : Tree(tree)
    , PlaneNeighbours(std::clamp(neighbours, TreeNeighbours, MostNeighbours))
    , Threads(executor)
    , Watch(monitor)
    , Count(tree.Size())
  {
  }

  EstimatedNormals Run()
  {
    this->FitPlanes();
    if (!this->Stop(0.5))
    {
      this->CollectPairs();
    }
    if (!this->Stop(0.7))
    {
      this->SpreadSigns();
    }
    if (!this->Stop(0.9))
    {
      this->TurnParts();
      this->FindDoubtful();
    }
    return std::move(this->Result);
  }

private:
  bool Stop(double fraction)
  {
    this->Watch.Progress(fraction, "Normals");
    this->Result.Aborted = this->Result.Aborted || this->Watch.Aborted();
    return this->Result.Aborted;
  }

  Real3 Normal(std::int32_t i) const
  {
    const double* const n = this->Result.Normals.data() + 3 * static_cast<std::int64_t>(i);
    return { n[0], n[1], n[2] };
  }

  const std::int32_t* Neighbours(std::int32_t i) const
  {
    return this->Near.data() + TreeNeighbours * static_cast<std::int64_t>(i);
  }

  void FitPlanes()
  {
    this->Result.Normals.assign(3 * static_cast<std::size_t>(this->Count), 0.0);
    this->Result.Doubtful.assign(static_cast<std::size_t>(this->Count), 0);
    this->Near.assign(TreeNeighbours * static_cast<std::size_t>(this->Count), -1);
    this->Areas.assign(static_cast<std::size_t>(this->Count), 0.0);
    this->Threads.For(this->Count, Grain, [this](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end && !this->Watch.Aborted(); ++i)
      {
        this->FitPlane(static_cast<std::int32_t>(i));
      }
    });
  }

  void FitPlane(std::int32_t i)
  {
    const Real3 x = this->Tree.Point(i);
    PointTree::Neighbour found[MostNeighbours + 1];
    const int count = this->Tree.Nearest(x, this->PlaneNeighbours + 1, found);
    Real3 mean{};
    for (int k = 0; k < count; ++k)
    {
      mean = PlusScaled(mean, 1.0 / count, Difference(this->Tree.Point(found[k].Index), x));
    }
    Real3x3 spread{};
    for (int k = 0; k < count; ++k)
    {
      const Real3 d = Difference(Difference(this->Tree.Point(found[k].Index), x), mean);
      for (std::size_t a = 0; a < 3; ++a)
      {
        spread[a] = PlusScaled(spread[a], d[a], d);
      }
    }
    std::int32_t* const near = this->Near.data() + TreeNeighbours * static_cast<std::int64_t>(i);
    for (int k = 1; k < std::min(count, TreeNeighbours + 1); ++k)
    {
      near[k - 1] = found[k].Index;
    }
    const SymmetricEigen eigen(spread);
    const std::size_t place = static_cast<std::size_t>(i);
    this->Areas[place] = found[count - 1].SquaredDistance;
    if (!(eigen.Values[1] > ThinnestPlane * eigen.Values[2]))
    {
      this->Result.Doubtful[place] = 1; // on a line, no plane
      return;
    }
    this->Result.Doubtful[place] = eigen.Values[0] > FlattestDoubt * eigen.Values[1] ? 1 : 0;
    std::copy_n(eigen.Vectors[0].begin(), 3, this->Result.Normals.begin() + 3 * i);
  }

  bool IsNeighbour(std::int32_t of, std::int32_t i) const
  {
    const std::int32_t* const near = this->Neighbours(of);
    return std::find(near, near + TreeNeighbours, i) != near + TreeNeighbours;
  }

  void CollectPairs()
  {
    std::vector<std::int64_t> starts(static_cast<std::size_t>(this->Count), 0);
    const auto forEachPair = [this](std::int32_t i, auto&& visit) {
      for (int k = 0; k < TreeNeighbours; ++k)
      {
        const std::int32_t j = this->Neighbours(i)[k];
        if (j >= 0 && (i < j || !this->IsNeighbour(j, i)))
        {
          visit(j);
        }
      }
    };
    const auto forEachPoint = [this](auto&& visit) {
      this->Threads.For(this->Count, Grain, [&visit](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          visit(static_cast<std::int32_t>(i));
        }
      });
    };
    forEachPoint([&](std::int32_t i) {
      forEachPair(i, [&](std::int32_t) { ++starts[static_cast<std::size_t>(i)]; });
    });
    this->Pairs.resize(static_cast<std::size_t>(ExclusivePrefixSum(starts, this->Threads)));
    forEachPoint([&](std::int32_t i) {
      std::size_t place = static_cast<std::size_t>(starts[static_cast<std::size_t>(i)]);
      forEachPair(i, [&](std::int32_t j) { this->Pairs[place++] = this->Judge(i, j); });
    });
    RadixSort(
      this->Pairs, [](const Pair& pair) { return static_cast<std::uint64_t>(pair.Cost); }, 22,
      this->Threads);
  }

  Pair Judge(std::int32_t i, std::int32_t j) const
  {
    const Real3 a = this->Normal(i);
    const Real3 b = this->Normal(j);
    Real3 along = Difference(this->Tree.Point(j), this->Tree.Point(i));
    along = Scaled(along, 1.0 / Length(along));
    const double mirrored = Dot(a, b) - 2.0 * Dot(along, a) * Dot(along, b);
    const double above = std::max(std::abs(Dot(along, a)), std::abs(Dot(along, b)));
    const double cost = (1.0 - std::min(1.0, std::abs(mirrored)) + above * above) / 2.0;
    const double finest = (1 << 22) - 1;
    return { static_cast<std::uint32_t>(std::clamp(cost, 0.0, 1.0) * finest), i, j,
      mirrored < 0.0 ? 1 : 0 };
  }

  /** Kruskal's spanning tree. A set is kept as a tree of parents, and with each point whether it
   * has the other side than its parent. */
  void SpreadSigns()
  {
    std::vector<std::int32_t> parent(static_cast<std::size_t>(this->Count));
    std::vector<std::uint8_t> turned(static_cast<std::size_t>(this->Count), 0);
    for (std::int32_t i = 0; i < this->Count; ++i)
    {
      parent[static_cast<std::size_t>(i)] = i;
    }
    const auto rootOf = [&](std::int32_t i, std::uint8_t& side) {
      side = 0;
      std::size_t at = static_cast<std::size_t>(i);
      while (parent[at] != static_cast<std::int32_t>(at))
      {
        const std::size_t above = static_cast<std::size_t>(parent[at]);
        turned[at] = static_cast<std::uint8_t>(parent[above] == static_cast<std::int32_t>(above)
            ? turned[at]
            : turned[at] ^ turned[above]);
        parent[at] = parent[above];
        side ^= turned[at];
        at = static_cast<std::size_t>(parent[at]);
      }
      return static_cast<std::int32_t>(at);
    };
    for (const Pair& pair : this->Pairs)
    {
      std::uint8_t first = 0;
      std::uint8_t second = 0;
      const std::int32_t a = rootOf(pair.First, first);
      const std::int32_t b = rootOf(pair.Second, second);
      if (a != b)
      {
        const std::int32_t below = std::max(a, b);
        parent[static_cast<std::size_t>(below)] = std::min(a, b);
        turned[static_cast<std::size_t>(below)] =
          static_cast<std::uint8_t>(first ^ second ^ static_cast<std::uint8_t>(pair.Opposite));
      }
    }
    this->Parts.resize(static_cast<std::size_t>(this->Count));
    for (std::int32_t i = 0; i < this->Count; ++i)
    {
      std::uint8_t side = 0;
      this->Parts[static_cast<std::size_t>(i)] = rootOf(i, side);
      for (std::int64_t k = 3 * std::int64_t(i); side && k < 3 * std::int64_t(i) + 3; ++k)
      {
        this->Result.Normals[static_cast<std::size_t>(k)] *= -1.0;
      }
    }
  }

  /** Turn parts over whose volume, the flux of x - mean through them, is negative. */
  void TurnParts()
  {
    struct Part
    {
      Real3 Mean{};
      double Points = 0.0;
      double Volume = 0.0;
    };
    std::vector<Part> parts(static_cast<std::size_t>(this->Count));
    const auto partOf = [&](std::int32_t i) -> Part& {
      return parts[static_cast<std::size_t>(this->Parts[static_cast<std::size_t>(i)])];
    };
    for (std::int32_t i = 0; i < this->Count; ++i)
    {
      Part& part = partOf(i);
      part.Points += 1.0;
      part.Mean =
        PlusScaled(part.Mean, 1.0 / part.Points, Difference(this->Tree.Point(i), part.Mean));
    }
    for (std::int32_t i = 0; i < this->Count; ++i)
    {
      Part& part = partOf(i);
      part.Volume += this->Areas[static_cast<std::size_t>(i)] *
        Dot(Difference(this->Tree.Point(i), part.Mean), this->Normal(i));
    }
    for (std::int32_t i = 0; i < this->Count; ++i)
    {
      this->Result.NumberOfParts += this->Parts[static_cast<std::size_t>(i)] == i ? 1 : 0;
      for (std::int64_t k = 3 * std::int64_t(i);
           partOf(i).Volume < 0.0 && k < 3 * std::int64_t(i) + 3; ++k)
      {
        this->Result.Normals[static_cast<std::size_t>(k)] *= -1.0;
      }
    }
  }

  void FindDoubtful()
  {
    this->Threads.For(this->Count, Grain, [this](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        int neighbours = 0;
        int disagreeing = 0;
        const std::int32_t point = static_cast<std::int32_t>(i);
        for (int k = 0; k < TreeNeighbours && this->Neighbours(point)[k] >= 0; ++k)
        {
          ++neighbours;
          disagreeing += this->Judge(point, this->Neighbours(point)[k]).Opposite;
        }
        if (4 * disagreeing > neighbours)
        {
          this->Result.Doubtful[static_cast<std::size_t>(i)] = 1;
        }
      }
    });
    for (const std::uint8_t doubtful : this->Result.Doubtful)
    {
      this->Result.NumberOfDoubtful += doubtful;
    }
  }

  const PointTree& Tree;
  const int PlaneNeighbours;
  Executor& Threads;
  Monitor& Watch;
  const std::int32_t Count;
  std::vector<std::int32_t> Near; ///< nearest points, TreeNeighbours each, -1 where there are less
  std::vector<double> Areas; ///< up to a factor, what a point stands for
  std::vector<Pair> Pairs;
  std::vector<std::int32_t> Parts; ///< smallest point of the part that a point belongs to
  EstimatedNormals Result;
};

} // namespace

EstimatedNormals EstimateNormals(
  const PointTree& tree, int neighbours, Executor& executor, Monitor& monitor)
{
  return Estimation(tree, neighbours, executor, monitor).Run();
}

} // namespace sb
