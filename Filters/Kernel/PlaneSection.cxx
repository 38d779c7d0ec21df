// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneSection.h"

#include "EdgeRoot.h"
#include "ParallelSort.h"
#include "SectionSteps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 128;
constexpr double SquareInWidths = 1.0 / 3.0;
constexpr double Rounding = 1e-12; ///< in widths: values below it have no sign
constexpr double TouchInSquares = 0.1; ///< how near a plane has to come to touch
constexpr int MostHalvings = 5; ///< of the squares, where two branches are in one of them

/** A square of the plane's grid, or the node at its lower corner. */
struct Square
{
  std::int32_t U;
  std::int32_t V;

  bool operator<(const Square& other) const
  {
    return this->V != other.V ? this->V < other.V : this->U < other.U;
  }
  bool operator==(const Square& other) const { return this->U == other.U && this->V == other.V; }
};

/** The square of a sample, and how many around it are within the sample's width. */
struct Seed
{
  Square Place;
  std::int32_t Around;
};

/** Corners in a ring, counter-clockwise. */
constexpr std::int32_t CornerU[4] = { 0, 1, 1, 0 };
constexpr std::int32_t CornerV[4] = { 0, 0, 1, 1 };

/** All steps and what they share. */
class Sectioning
{
public:
  Sectioning(const MovingLeastSquares& surface, const Real3& origin, const Real3& normal,
    double chordError, Executor& executor, Monitor& monitor)
    : Surface(surface)
    , Normal(normal)
    , ChordError(chordError)
    , Edge(SquareInWidths * surface.NarrowWidth())
    , Threads(executor)
    , Watch(monitor)
  {
    const std::size_t least =
      static_cast<std::size_t>(std::min_element(normal.begin(), normal.end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        normal.begin());
    Real3 axis{};
    axis[least] = 1.0;
    this->AxisU = Cross(axis, normal);
    this->AxisU = Scaled(this->AxisU, 1.0 / Length(this->AxisU));
    this->AxisV = Cross(normal, this->AxisU);
    // Near the cloud, so that squares have small numbers; at an odd place, so that a cloud aligned
    // with the plane does not have whole rows of zeros.
    const Real3 lower = surface.Samples().Lower();
    const Real3 upper = surface.Samples().Upper();
    const Real3 middle = PlusScaled(lower, 0.5, Difference(upper, lower));
    const Real3 foot = PlusScaled(middle, -Dot(Difference(middle, origin), normal), normal);
    this->Origin = PlusScaled(
      PlusScaled(foot, 0.371 * this->Edge, this->AxisU), 0.433 * this->Edge, this->AxisV);
  }

  PlaneSection Run()
  {
    PlaneSection section;
    this->ListSquares();
    section.Curves = this->FindCurves();
    section.Touches = this->FindTouches();
    for (int halving = 0; halving < MostHalvings && !this->AreWithinBound(section.Curves);
         ++halving)
    {
      this->HalveSquares();
      section.Curves = this->FindCurves();
    }
    section.Aborted = this->Watch.Aborted();
    if (section.Aborted)
    {
      section.Curves.clear();
      section.Touches.clear();
    }
    return section;
  }

private:
  std::vector<SectionCurve> FindCurves()
  {
    std::vector<SectionCurve> curves;
    this->EvaluateNodes();
    this->FindSegments();
    for (const std::vector<std::int32_t>& branch : this->Branches())
    {
      if (this->Watch.Aborted())
      {
        break;
      }
      this->AddCurve(branch, curves);
    }
    return curves;
  }

  std::vector<SurfaceTouch> FindTouches()
  {
    TouchSearch search(this->Values, std::max(this->ChordError, TouchInSquares * this->Edge),
      Rounding * this->Surface.NarrowWidth());
    for (const Square& square : this->Squares)
    {
      std::int32_t corners[4];
      for (int k = 0; k < 4; ++k)
      {
        corners[k] = static_cast<std::int32_t>(
          this->NumberOf({ square.U + CornerU[k], square.V + CornerV[k] }));
      }
      for (int k = 0; k < 4; ++k)
      {
        for (int other = k + 1; other < 4; ++other)
        {
          search.Link(corners[k], corners[other]);
        }
      }
    }
    return search.Find(
      this->Surface,
      [this](
        std::int32_t node) { return this->Place(this->Nodes[static_cast<std::size_t>(node)]); },
      this->Near);
  }

  bool AreWithinBound(const std::vector<SectionCurve>& curves) const
  {
    return std::all_of(curves.begin(), curves.end(),
      [this](const SectionCurve& curve) { return curve.LargestChordError <= this->ChordError; });
  }

  /**
   * Where two branches run through one square (the plane is nearly tangential at a saddle), its
   * corners do not tell which ends belong together, and a wrong chord would be off by up to the
   * size of the square. So the squares at curves, and those beside them, are cut into four.
   */
  void HalveSquares()
  {
    std::vector<Square> halves;
    for (const Square& square : this->Squares)
    {
      if (this->IsCrossed(square))
      {
        for (std::int32_t v = -2; v < 4; ++v)
        {
          for (std::int32_t u = -2; u < 4; ++u)
          {
            halves.push_back({ 2 * square.U + u, 2 * square.V + v });
          }
        }
      }
    }
    ParallelSortUnique(halves, this->Threads);
    this->Squares.swap(halves);
    this->Nodes.clear();
    this->Edge *= 0.5;
  }

  bool IsCrossed(const Square& square) const
  {
    int inside = 0;
    for (int k = 0; k < 4; ++k)
    {
      inside += this->IsInside(this->NumberOf({ square.U + CornerU[k], square.V + CornerV[k] }));
    }
    return inside > 0 && inside < 4;
  }

  Real3 Place(const Square& node) const
  {
    return PlusScaled(
      PlusScaled(this->Origin, this->Edge * node.U, this->AxisU), this->Edge * node.V, this->AxisV);
  }

  /** Squares within a width of a sample that is within a width of the plane. */
  void ListSquares()
  {
    const PointTree& samples = this->Surface.Samples();
    const double width = this->Surface.LargestWidth();
    std::vector<Seed> seeds;
    const auto isNear = [&](const Real3& lower, const Real3& upper) {
      double least = 0.0;
      double most = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double a = (lower[axis] - this->Origin[axis]) * this->Normal[axis];
        const double b = (upper[axis] - this->Origin[axis]) * this->Normal[axis];
        least += std::min(a, b);
        most += std::max(a, b);
      }
      return least <= width && most >= -width;
    };
    samples.ForRanges(isNear, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t i = begin; i < end; ++i)
      {
        const Real3 from = Difference(samples.Point(i), this->Origin);
        const double u = std::floor(Dot(from, this->AxisU) / this->Edge);
        const double v = std::floor(Dot(from, this->AxisV) / this->Edge);
        constexpr double most = 1 << 30;
        const double own = this->Surface.WidthOf(i);
        if (std::abs(Dot(from, this->Normal)) <= own && std::abs(u) < most && std::abs(v) < most)
        {
          seeds.push_back({ { static_cast<std::int32_t>(u), static_cast<std::int32_t>(v) },
            static_cast<std::int32_t>(std::ceil(own / this->Edge - Rounding)) });
        }
      }
    });
    ParallelSort(
      seeds,
      [](const Seed& a, const Seed& b) {
        return a.Place == b.Place ? a.Around > b.Around : a.Place < b.Place;
      },
      this->Threads);
    seeds.erase(std::unique(seeds.begin(), seeds.end(),
                  [](const Seed& a, const Seed& b) { return a.Place == b.Place; }),
      seeds.end());
    for (const Seed& seed : seeds)
    {
      for (std::int32_t v = -seed.Around; v <= seed.Around; ++v)
      {
        for (std::int32_t u = -seed.Around; u <= seed.Around; ++u)
        {
          this->Squares.push_back({ seed.Place.U + u, seed.Place.V + v });
        }
      }
    }
    ParallelSortUnique(this->Squares, this->Threads);
  }

  std::size_t NumberOf(const Square& node) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(this->Nodes.begin(), this->Nodes.end(), node) - this->Nodes.begin());
  }

  void EvaluateNodes()
  {
    for (const Square& square : this->Squares)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        this->Nodes.push_back({ square.U + CornerU[corner], square.V + CornerV[corner] });
      }
    }
    ParallelSortUnique(this->Nodes, this->Threads);
    this->Values.resize(this->Nodes.size());
    const double none = std::numeric_limits<double>::quiet_NaN();
    this->Threads.For(static_cast<std::int64_t>(this->Nodes.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          const SurfaceValue f = this->Surface.EvaluateAt(this->Place(this->Nodes[i]), 0, near);
          this->Values[i] = f.IsNear ? f.Value : none;
        }
      });
  }

  bool IsInside(std::size_t node) const
  {
    return this->Values[node] < -Rounding * this->Surface.NarrowWidth();
  }

  /** In each square, from where the curve comes in to where it goes out, inside on the left. */
  void FindSegments()
  {
    this->Next.assign(2 * this->Nodes.size(), -1);
    this->Points.resize(2 * this->Nodes.size());
    this->Supported.assign(2 * this->Nodes.size(), Unknown);
    for (const Square& square : this->Squares)
    {
      std::size_t corners[4];
      bool known = true;
      for (int k = 0; k < 4; ++k)
      {
        corners[k] = this->NumberOf({ square.U + CornerU[k], square.V + CornerV[k] });
        known = known && !std::isnan(this->Values[corners[k]]);
      }
      for (int leaves = 0; known && leaves < 4; ++leaves)
      {
        // A run of inside corners that ends here is cut off by one segment.
        if (this->IsInside(corners[leaves]) && !this->IsInside(corners[(leaves + 1) % 4]))
        {
          int enters = leaves + 3;
          while (this->IsInside(corners[enters % 4]))
          {
            --enters;
          }
          this->AddSegment(EdgeOf(corners, leaves), EdgeOf(corners, enters % 4));
        }
      }
    }
  }

  /** The edge from corner k to the next one: twice the node at its lower end, and 1 if along v. */
  static std::int32_t EdgeOf(const std::size_t (&corners)[4], int k)
  {
    const std::size_t lower = std::min(corners[k], corners[(k + 1) % 4]);
    return static_cast<std::int32_t>(2 * lower + static_cast<std::size_t>(k % 2));
  }

  void AddSegment(std::int32_t from, std::int32_t to)
  {
    if (this->FindRoot(from) && this->FindRoot(to))
    {
      this->Next[static_cast<std::size_t>(from)] = to;
    }
  }

  /** The point of the curve on an edge; returns whether the surface is defined there. */
  bool FindRoot(std::int32_t edge)
  {
    const std::size_t place = static_cast<std::size_t>(edge);
    if (this->Supported[place] != Unknown)
    {
      return this->Supported[place] == Yes;
    }
    const Square lower = this->Nodes[place / 2];
    const Real3 start = this->Place(lower);
    const Real3 along = Scaled(edge % 2 == 0 ? this->AxisU : this->AxisV, this->Edge);
    const std::size_t other = this->NumberOf(
      edge % 2 == 0 ? Square{ lower.U + 1, lower.V } : Square{ lower.U, lower.V + 1 });
    const EdgeRoot root = FindEdgeRoot(this->Surface,
      { start, along, this->Values[place / 2], this->Values[other], this->IsInside(place / 2) },
      RootStep, this->Near);
    this->Points[place] = root.Point;
    this->Supported[place] = root.IsSupported() ? Yes : No;
    return root.IsSupported();
  }

  /** Edges in their order along each branch, open ones first; a loop has its first edge again at
   * its end. */
  std::vector<std::vector<std::int32_t>> Branches()
  {
    std::vector<std::uint8_t> hasPrevious(this->Next.size(), 0);
    for (const std::int32_t next : this->Next)
    {
      if (next >= 0)
      {
        hasPrevious[static_cast<std::size_t>(next)] = 1;
      }
    }
    std::vector<std::vector<std::int32_t>> branches;
    for (const std::uint8_t loops : { std::uint8_t(0), std::uint8_t(1) })
    {
      for (std::size_t first = 0; first < this->Next.size(); ++first)
      {
        if (this->Next[first] < 0 || hasPrevious[first] != loops)
        {
          continue;
        }
        std::vector<std::int32_t> branch{ static_cast<std::int32_t>(first) };
        for (std::size_t at = first; this->Next[at] >= 0;)
        {
          const std::int32_t next = this->Next[at];
          this->Next[at] = -1;
          branch.push_back(next);
          at = static_cast<std::size_t>(next);
        }
        branches.push_back(branch);
      }
    }
    return branches;
  }

  void AddCurve(const std::vector<std::int32_t>& branch, std::vector<SectionCurve>& curves)
  {
    std::vector<Real3> points;
    for (const std::int32_t edge : branch)
    {
      const Real3& point = this->Points[static_cast<std::size_t>(edge)];
      if (points.empty() || Length(Difference(point, points.back())) > Rounding * this->Edge)
      {
        points.push_back(point);
      }
    }
    if (points.size() < 2)
    {
      return;
    }
    SectionCurve curve;
    curve.Closed = branch.front() == branch.back();
    curve.Points.push_back(points.front());
    curve.LargestChordError =
      SectionSteps(this->Surface, this->Normal, this->ChordError, this->Edge)
        .Walk(points, curve.Points);
    curves.push_back(std::move(curve));
  }

  enum : std::uint8_t
  {
    Unknown,
    Yes,
    No
  };

  const MovingLeastSquares& Surface;
  const Real3 Normal;
  const double ChordError;
  double Edge; ///< of the squares
  Executor& Threads;
  Monitor& Watch;
  Real3 Origin{};
  Real3 AxisU{};
  Real3 AxisV{};
  std::vector<Square> Squares;
  std::vector<Square> Nodes;
  std::vector<double> Values; ///< NaN where there is none
  std::vector<std::int32_t> Next; ///< of an edge, the one that its curve goes to
  std::vector<Real3> Points; ///< of edges
  std::vector<std::uint8_t> Supported; ///< of edges
  MovingLeastSquares::Neighbourhood Near;
};

} // namespace

PlaneSection IntersectPlane(const MovingLeastSquares& surface, const Real3& origin,
  const Real3& normal, double chordError, Executor& executor, Monitor& monitor)
{
  return Sectioning(surface, origin, normal, chordError, executor, monitor).Run();
}

} // namespace sb
