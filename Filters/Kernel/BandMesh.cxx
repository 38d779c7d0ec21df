// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BandMesh.h"

#include "ParallelSort.h"
#include "PlaceTable.h"
#include "TriangleCutting.h"

#include <algorithm>
#include <cmath>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 64;
constexpr int MostRounds = 4; ///< of corners put into dips
constexpr int MostHalvings = 10; ///< on the way down into a dip
constexpr double RoundingInWidths = 1e-12;
constexpr double SteepestSlope = 2.0; ///< of the function, which is close to a distance

void Evaluate(BandMesh& band, std::size_t first, const MovingLeastSquares& surface,
  Executor& executor, Monitor& monitor)
{
  band.Values.resize(band.Places.size());
  executor.For(static_cast<std::int64_t>(band.Places.size() - first), Grain,
    [&](std::int64_t begin, std::int64_t end) {
      MovingLeastSquares::Neighbourhood near;
      const std::size_t last = monitor.Aborted() ? 0 : first + static_cast<std::size_t>(end);
      for (std::size_t i = first + static_cast<std::size_t>(begin); i < last; ++i)
      {
        band.Values[i] = surface.EvaluateAt(band.Places[i], 1, near);
      }
    });
}

void ListTriangles(const RefinedSurface& refined, BandMesh& band)
{
  const std::size_t count = static_cast<std::size_t>(
    std::count(refined.IsNear.begin(), refined.IsNear.end(), std::uint8_t(1)));
  PlaceTable table(3 * count);
  for (std::size_t t = 0; t < refined.IsNear.size(); ++t)
  {
    if (!refined.IsNear[t])
    {
      continue;
    }
    BandMesh::Triangle triangle{ {}, refined.Original[t] };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t point = static_cast<std::size_t>(refined.Surface.Triangles[3 * t + k]);
      triangle.Places[k] = table.Add(refined.Surface.Points.data() + 3 * point);
    }
    const auto& p = triangle.Places;
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0])
    {
      band.Triangles.push_back(triangle);
    }
  }
  band.Places.reserve(static_cast<std::size_t>(table.Size()));
  for (std::int32_t place = 0; place < table.Size(); ++place)
  {
    const double* x = table.Point(place);
    band.Places.push_back({ x[0], x[1], x[2] });
  }
}

/** Whether the function may cross zero twice between two places. */
bool MayDip(const BandMesh& band, std::int32_t a, std::int32_t b)
{
  if (!band.IsKnown(a) || !band.IsKnown(b) || band.IsInside(a) != band.IsInside(b))
  {
    return false;
  }
  const SurfaceValue& first = band.Values[static_cast<std::size_t>(a)];
  const SurfaceValue& last = band.Values[static_cast<std::size_t>(b)];
  const Real3 along = Difference(band.Place(b), band.Place(a));
  const double side = band.IsInside(a) ? -1.0 : 1.0;
  return side * Dot(first.Gradient, along) < 0.0 && side * Dot(last.Gradient, along) > 0.0 &&
    std::abs(first.Value) + std::abs(last.Value) < SteepestSlope * Length(along);
}

struct Dip
{
  std::uint64_t Edge; ///< a pair of places
  bool IsCrossed = false;
  Real3 Place{}; ///< on the other side
};

/** Downhill from both ends, by halving. */
void LookForCrossing(const BandMesh& band, const MovingLeastSquares& surface, Dip& dip,
  MovingLeastSquares::Neighbourhood& near)
{
  Real3 low = band.Place(LowerPlace(dip.Edge));
  Real3 high = band.Place(UpperPlace(dip.Edge));
  const bool isInside = band.IsInside(LowerPlace(dip.Edge));
  for (int halving = 0; halving < MostHalvings; ++halving)
  {
    const Real3 along = Difference(high, low);
    const Real3 middle = PlusScaled(low, 0.5, along);
    const SurfaceValue f = surface.EvaluateAt(middle, 1, near);
    if (!f.IsNear || std::abs(f.Value) > SteepestSlope * Length(along))
    {
      return;
    }
    if ((f.Value < -band.Rounding) != isInside)
    {
      dip.IsCrossed = true;
      dip.Place = middle;
      return;
    }
    const double side = isInside ? -1.0 : 1.0;
    (side * Dot(f.Gradient, along) < 0.0 ? low : high) = middle;
  }
}

std::vector<Dip> CrossedDips(
  const BandMesh& band, const MovingLeastSquares& surface, Executor& executor)
{
  std::vector<Dip> dips;
  for (const BandMesh::Triangle& triangle : band.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t a = triangle.Places[k];
      const std::int32_t b = triangle.Places[(k + 1) % 3];
      if (MayDip(band, a, b))
      {
        dips.push_back({ PairOfPlaces(a, b) });
      }
    }
  }
  ParallelSort(
    dips, [](const Dip& a, const Dip& b) { return a.Edge < b.Edge; }, executor);
  dips.erase(std::unique(dips.begin(), dips.end(),
               [](const Dip& a, const Dip& b) { return a.Edge == b.Edge; }),
    dips.end());
  executor.For(
    static_cast<std::int64_t>(dips.size()), 8, [&](std::int64_t begin, std::int64_t end) {
      MovingLeastSquares::Neighbourhood near;
      for (std::int64_t i = begin; i < end; ++i)
      {
        LookForCrossing(band, surface, dips[static_cast<std::size_t>(i)], near);
      }
    });
  dips.erase(
    std::remove_if(dips.begin(), dips.end(), [](const Dip& dip) { return !dip.IsCrossed; }),
    dips.end());
  return dips;
}

/** Put a corner into each dip. */
void Cut(BandMesh& band, const std::vector<Dip>& dips)
{
  const std::int32_t first = static_cast<std::int32_t>(band.Places.size());
  for (const Dip& dip : dips)
  {
    band.Places.push_back(dip.Place);
  }
  const std::size_t count = band.Triangles.size();
  for (std::size_t t = 0; t < count; ++t)
  {
    const BandMesh::Triangle triangle = band.Triangles[t];
    std::array<std::int32_t, 3> onEdges{ -1, -1, -1 };
    std::array<double, 3> lengths{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t a = triangle.Places[k];
      const std::int32_t b = triangle.Places[(k + 1) % 3];
      lengths[k] = Length(Difference(band.Place(a), band.Place(b)));
      const auto found = std::lower_bound(dips.begin(), dips.end(), PairOfPlaces(a, b),
        [](const Dip& dip, std::uint64_t edge) { return dip.Edge < edge; });
      if (found != dips.end() && found->Edge == PairOfPlaces(a, b))
      {
        onEdges[k] = first + static_cast<std::int32_t>(found - dips.begin());
      }
    }
    if (onEdges != std::array<std::int32_t, 3>{ -1, -1, -1 })
    {
      bool isFirst = true;
      CutTriangle(
        triangle.Places, onEdges, lengths, [&](const std::array<std::int32_t, 3>& corners) {
          if (isFirst)
          {
            band.Triangles[t].Places = corners;
            isFirst = false;
            return;
          }
          band.Triangles.push_back({ corners, triangle.Original });
        });
    }
  }
}

} // namespace

BandMesh MakeBandMesh(const RefinedSurface& refined, const MovingLeastSquares& surface,
  Executor& executor, Monitor& monitor)
{
  BandMesh band;
  band.Rounding = RoundingInWidths * surface.Width();
  ListTriangles(refined, band);
  Evaluate(band, 0, surface, executor, monitor);
  for (int round = 0; round < MostRounds && !monitor.Aborted(); ++round)
  {
    const std::vector<Dip> dips = CrossedDips(band, surface, executor);
    if (dips.empty())
    {
      break;
    }
    const std::size_t first = band.Places.size();
    Cut(band, dips);
    Evaluate(band, first, surface, executor, monitor);
  }
  return band;
}

} // namespace sb
