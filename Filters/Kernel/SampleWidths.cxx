// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleWidths.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 256;
constexpr double LeastInSpacings = 2.0;
constexpr std::int32_t MostProbes = 20000;
constexpr int Neighbours = 16; ///< that a sample's spacing is measured with
constexpr double Unevenness = 2.2; ///< largest ratio of spacings that is taken for chance: in
                                   ///< random samples, 90 % lie within a ratio of 1.5
constexpr double FewestThin = 0.001; ///< share of probes, below which thin walls are not looked for
constexpr double Opposite = -0.5; ///< cosine of normals that face each other
constexpr double Rounded = 0.999;
constexpr double Across = 0.7; ///< cosine to the normal of what lies opposite
constexpr std::size_t Witnesses = 3; ///< samples that make a wall
constexpr double Pi = 3.14159265358979323846;

class Widening
{
public:
  Widening(const PointTree& tree, const double* normals, double spacing, Executor& executor)
    : Tree(tree)
    , Normals(normals)
    , Spacing(spacing)
    , Threads(executor)
    , Stride(std::max(1, tree.Size() / MostProbes))
  {
  }

  SampleWidths Run(double width, bool each)
  {
    SampleWidths result;
    result.Typical = width > 0.0 ? width : WidthInSpacings * this->Spacing;
    const auto typical = [&result](std::int32_t) { return result.Typical; };
    std::vector<double> walls = this->Walls(this->Stride, typical);
    this->Report(walls, this->Stride, typical, result);
    const bool isThin = result.ThinShare > FewestThin;
    const bool isUneven = width <= 0.0 && each && this->IsUneven();
    if (width > 0.0 || !each || (!isThin && !isUneven))
    {
      return result;
    }
    if (isUneven)
    {
      this->TakeSpacings(result);
    }
    else
    {
      const std::size_t count = static_cast<std::size_t>(this->Tree.Size());
      result.Widths.assign(count, result.Typical);
    }
    const auto own = [&result](
                       std::int32_t i) { return result.Widths[static_cast<std::size_t>(i)]; };
    walls = this->Walls(1, own);
    for (std::size_t i = 0; i < walls.size(); ++i)
    {
      const double least = LeastInSpacings / WidthInSpacings * result.Widths[i];
      result.Widths[i] = std::clamp(walls[i], least, result.Widths[i]);
    }
    this->Report(walls, 1, own, result);
    return result;
  }

private:
  double SpacingAt(std::int32_t i) const
  {
    PointTree::Neighbour found[Neighbours + 1]; // the point itself is the first
    const int count = this->Tree.Nearest(this->Tree.Point(i), Neighbours + 1, found);
    return std::sqrt(found[count - 1].SquaredDistance * Pi / static_cast<double>(count - 1));
  }

  /** Body(i, k) for the k-th of every `stride` samples. */
  template <class Body>
  std::size_t ForProbes(std::int32_t stride, const Body& body) const
  {
    const std::int64_t count = (this->Tree.Size() + stride - 1) / stride;
    this->Threads.For(count, Grain, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t k = begin; k < end; ++k)
      {
        body(static_cast<std::int32_t>(k) * stride, static_cast<std::size_t>(k));
      }
    });
    return static_cast<std::size_t>(count);
  }

  bool IsUneven() const
  {
    std::vector<double> spacings(static_cast<std::size_t>(this->Tree.Size()));
    spacings.resize(this->ForProbes(
      this->Stride, [&](std::int32_t i, std::size_t k) { spacings[k] = this->SpacingAt(i); }));
    std::sort(spacings.begin(), spacings.end());
    const double lower = spacings[spacings.size() / 20];
    const double upper = spacings[spacings.size() - 1 - spacings.size() / 20];
    return upper > Unevenness * lower;
  }

  /** The spacing of a sample is the median of those around it: an outlier is far from its
   * neighbours, but they are not from theirs. */
  void TakeSpacings(SampleWidths& result) const
  {
    const std::size_t count = static_cast<std::size_t>(this->Tree.Size());
    std::vector<double> spacings(count);
    this->ForProbes(1, [&](std::int32_t i, std::size_t k) { spacings[k] = this->SpacingAt(i); });
    result.Widths.resize(count);
    this->ForProbes(1, [&](std::int32_t i, std::size_t k) {
      PointTree::Neighbour found[Neighbours + 1];
      const int number = this->Tree.Nearest(this->Tree.Point(i), Neighbours + 1, found);
      double around[Neighbours + 1];
      for (int j = 0; j < number; ++j)
      {
        around[j] = spacings[static_cast<std::size_t>(found[j].Index)];
      }
      std::nth_element(around, around + number / 2, around + number);
      const double ratio = std::max(1.0, around[number / 2] / this->Spacing);
      result.Widths[k] = WidthInSpacings * ratio * this->Spacing;
    });
  }

  Real3 Normal(std::int32_t i) const
  {
    const double* const n = this->Normals + 3 * std::int64_t(this->Tree.Id(i));
    return { n[0], n[1], n[2] };
  }

  /** The thickness of the wall or gap at every so many samples, if less than the width;
   * otherwise infinity. */
  template <class WidthOf>
  std::vector<double> Walls(std::int32_t stride, const WidthOf& widthOf) const
  {
    std::vector<double> walls(static_cast<std::size_t>(this->Tree.Size()));
    walls.resize(this->ForProbes(
      stride, [&](std::int32_t i, std::size_t k) { walls[k] = this->WallAt(i, widthOf(i)); }));
    return walls;
  }

  double WallAt(std::int32_t i, double farthest) const
  {
    const double none = std::numeric_limits<double>::infinity();
    const Real3 x = this->Tree.Point(i);
    const Real3 n = this->Normal(i);
    double nearest[Witnesses] = { none, none, none };
    this->Tree.ForRangesWithin(x, farthest, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t j = begin; j < end; ++j)
      {
        const Real3 away = Difference(this->Tree.Point(j), x);
        const double along = std::abs(Dot(away, n));
        if (along < farthest && along < nearest[Witnesses - 1] && along > Across * Length(away) &&
          Dot(n, this->Normal(j)) < Opposite)
        {
          nearest[Witnesses - 1] = along;
          std::sort(nearest, nearest + Witnesses);
        }
      }
    });
    return nearest[Witnesses - 1];
  }

  template <class WidthOf>
  void Report(const std::vector<double>& walls, std::int32_t stride, const WidthOf& widthOf,
    SampleWidths& result) const
  {
    std::vector<double> thin;
    for (std::size_t k = 0; k < walls.size(); ++k)
    {
      if (walls[k] < Rounded * widthOf(static_cast<std::int32_t>(k) * stride))
      {
        thin.push_back(walls[k]);
      }
    }
    result.ThinShare = static_cast<double>(thin.size()) / static_cast<double>(walls.size());
    std::sort(thin.begin(), thin.end());
    result.ThinWall = thin.empty() ? 0.0 : thin[thin.size() / 2];
  }

  const PointTree& Tree;
  const double* Normals;
  const double Spacing;
  Executor& Threads;
  const std::int32_t Stride;
};

} // namespace

SampleWidths WidthsOfSamples(const PointTree& tree, const double* normals, double spacing,
  double width, bool each, Executor& executor)
{
  return Widening(tree, normals, spacing, executor).Run(width, each);
}

} // namespace sb
