// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudMeshRefinement.h"

#include "ParallelSort.h"
#include "PlaceTable.h"
#include "TriangleCutting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 256;
constexpr int Halvings = 2;
constexpr double NearInCells = 0.25;
constexpr std::size_t LargeMesh = 200000; ///< triangles; a smaller mesh may grow to as many
constexpr double LongestMove = 0.25; ///< of a middle, in lengths of its edge
constexpr double LeastFacing = 0.5; ///< cosine between a triangle and its parts
constexpr std::int32_t None = -1;

using Corners = std::array<std::int32_t, 3>;

/** One halving of all edges near the tool. */
class Halving
{
public:
  Halving(PointSurfaceMesh& mesh, const MovingLeastSquares& surface, const ToolSurface& tool,
    double cell, Executor& executor, Monitor& monitor)
    : Mesh(mesh)
    , Surface(surface)
    , Tool(tool)
    , Near(NearInCells * cell)
    , Threads(executor)
    , Watch(monitor)
    , FirstNew(static_cast<std::int32_t>(mesh.Points.size() / 3))
  {
  }

  /** @param most triangles that may be added; returns whether edges were halved */
  bool Run(std::size_t most)
  {
    this->ListEdges();
    // Each edge that is cut adds a triangle on both of its sides.
    if (this->Edges.empty() || 2 * this->Edges.size() > most || this->Watch.Aborted())
    {
      return false;
    }
    this->PlaceMiddles();
    this->ListTouched();
    while (!this->Watch.Aborted() && this->GiveUpEdges())
    {
    }
    this->Cut();
    return true;
  }

private:
  Real3 Point(std::int32_t i) const
  {
    const std::size_t known = this->Mesh.Points.size() / 3;
    const std::size_t at = static_cast<std::size_t>(i);
    if (at >= known)
    {
      return this->Middles[at - known];
    }
    const double* const p = this->Mesh.Points.data() + 3 * at;
    return { p[0], p[1], p[2] };
  }

  Corners CornersOf(std::size_t triangle) const
  {
    const std::int32_t* const ids = this->Mesh.Triangles.data() + 3 * triangle;
    return { ids[0], ids[1], ids[2] };
  }

  bool IsNear(const Corners& ids) const
  {
    Real3 middle{};
    for (const std::int32_t id : ids)
    {
      middle = PlusScaled(middle, 1.0 / 3.0, this->Point(id));
    }
    double radius = 0.0;
    for (const std::int32_t id : ids)
    {
      radius = std::max(radius, Length(Difference(this->Point(id), middle)));
    }
    return this->Tool.NearestTo(middle, radius + this->Near).Triangle >= 0;
  }

  /** The edges of all triangles near the tool, once each. */
  void ListEdges()
  {
    const std::size_t count = this->Mesh.Triangles.size() / 3;
    std::vector<std::uint8_t> isNear(count, 0);
    this->Threads.For(
      static_cast<std::int64_t>(count), Grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t t = static_cast<std::size_t>(begin);
             t < static_cast<std::size_t>(end) && !this->Watch.Aborted(); ++t)
        {
          isNear[t] = this->IsNear(this->CornersOf(t)) ? 1 : 0;
        }
      });
    this->IsEnd.assign(this->Mesh.Points.size() / 3, 0);
    for (std::size_t t = 0; t < count; ++t)
    {
      for (std::size_t k = 0; isNear[t] && k < 3; ++k)
      {
        const Corners ids = this->CornersOf(t);
        this->Edges.push_back(PairOfPlaces(ids[k], ids[(k + 1) % 3]));
        this->IsEnd[static_cast<std::size_t>(ids[k])] = 1;
      }
    }
    ParallelSortUnique(this->Edges, this->Threads);
  }

  /** The middle of each edge, on the surface; edges whose middle is not near it are given up. */
  void PlaceMiddles()
  {
    this->Middles.resize(this->Edges.size());
    this->Normals.resize(this->Edges.size());
    this->IsCut.assign(this->Edges.size(), 0);
    this->Threads.For(static_cast<std::int64_t>(this->Edges.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t e = static_cast<std::size_t>(begin);
             e < static_cast<std::size_t>(end) && !this->Watch.Aborted(); ++e)
        {
          const Real3 a = this->Point(LowerPlace(this->Edges[e]));
          const Real3 along = Difference(this->Point(UpperPlace(this->Edges[e])), a);
          const Real3 middle = PlusScaled(a, 0.5, along);
          this->Middles[e] = middle;
          const SurfaceValue there = this->Surface.Project(this->Middles[e], near);
          const double steepness = Length(there.Gradient);
          const double moved = Length(Difference(this->Middles[e], middle));
          if (there.IsNear && steepness > 0.0 && moved < LongestMove * Length(along))
          {
            this->Normals[e] = Scaled(there.Gradient, 1.0 / steepness);
            this->IsCut[e] = 1;
          }
        }
      });
  }

  /** Triangles that have one of the edges. */
  void ListTouched()
  {
    for (std::size_t t = 0; t < this->Mesh.Triangles.size() / 3; ++t)
    {
      const Corners edges = this->EdgesOf(t);
      if (edges[0] != None || edges[1] != None || edges[2] != None)
      {
        this->Touched.push_back(t);
        this->EdgesOfTouched.push_back(edges);
      }
    }
  }

  Corners EdgesOf(std::size_t triangle) const
  {
    const Corners ids = this->CornersOf(triangle);
    Corners edges{ None, None, None };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t next = ids[(k + 1) % 3];
      if (this->IsEnd[static_cast<std::size_t>(ids[k])] &&
        this->IsEnd[static_cast<std::size_t>(next)])
      {
        const std::uint64_t edge = PairOfPlaces(ids[k], next);
        const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), edge);
        edges[k] = found != this->Edges.end() && *found == edge
          ? static_cast<std::int32_t>(found - this->Edges.begin())
          : None;
      }
    }
    return edges;
  }

  /** The points in the middle of a triangle's edges, or None. */
  Corners MiddlesOf(std::size_t touched) const
  {
    Corners middles{ None, None, None };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int32_t edge = this->EdgesOfTouched[touched][k];
      if (edge != None && this->IsCut[static_cast<std::size_t>(edge)])
      {
        middles[k] = this->FirstNew + edge;
      }
    }
    return middles;
  }

  template <class Add>
  void CutTouched(std::size_t touched, const Corners& middles, const Add& add) const
  {
    const Corners ids = this->CornersOf(this->Touched[touched]);
    std::array<double, 3> lengths{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      lengths[k] = Length(Difference(this->Point(ids[(k + 1) % 3]), this->Point(ids[k])));
    }
    CutTriangle(ids, middles, lengths, add);
  }

  Real3 Turn(const Corners& ids) const
  {
    const Real3 a = this->Point(ids[0]);
    return Cross(Difference(this->Point(ids[1]), a), Difference(this->Point(ids[2]), a));
  }

  /** Give up the edges of triangles whose parts would face elsewhere; returns whether there were
   * any. */
  bool GiveUpEdges()
  {
    std::vector<std::uint8_t> isBad(this->Touched.size(), 0);
    this->Threads.For(static_cast<std::int64_t>(this->Touched.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          isBad[i] = this->IsTurnedAside(i) ? 1 : 0;
        }
      });
    bool any = false;
    for (std::size_t i = 0; i < isBad.size(); ++i)
    {
      for (std::size_t k = 0; isBad[i] && k < 3; ++k)
      {
        const std::int32_t edge = this->EdgesOfTouched[i][k];
        if (edge != None)
        {
          this->IsCut[static_cast<std::size_t>(edge)] = 0;
          any = true;
        }
      }
    }
    return any;
  }

  bool IsTurnedAside(std::size_t touched) const
  {
    const Corners middles = this->MiddlesOf(touched);
    if (middles == Corners{ None, None, None })
    {
      return false;
    }
    const Real3 whole = this->Turn(this->CornersOf(this->Touched[touched]));
    bool aside = false;
    this->CutTouched(touched, middles, [&](const Corners& part) {
      const Real3 turn = this->Turn(part);
      aside = aside || !(Dot(turn, whole) > LeastFacing * Length(turn) * Length(whole));
    });
    return aside;
  }

  void Cut()
  {
    std::vector<Corners> added;
    for (std::size_t i = 0; i < this->Touched.size(); ++i)
    {
      const Corners middles = this->MiddlesOf(i);
      if (middles == Corners{ None, None, None })
      {
        continue;
      }
      bool isFirst = true;
      Corners first{};
      this->CutTouched(i, middles, [&](const Corners& part) {
        if (isFirst)
        {
          first = part;
          isFirst = false;
          return;
        }
        added.push_back(part);
      });
      std::copy(first.begin(), first.end(),
        this->Mesh.Triangles.begin() + static_cast<std::ptrdiff_t>(3 * this->Touched[i]));
    }
    for (const Corners& part : added)
    {
      this->Mesh.Triangles.insert(this->Mesh.Triangles.end(), part.begin(), part.end());
    }
    this->AddMiddles();
  }

  /** The points of the edges that are cut, numbered one after another. */
  void AddMiddles()
  {
    std::vector<std::int32_t> number(this->Edges.size(), None);
    std::int32_t next = this->FirstNew;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (this->IsCut[e])
      {
        number[e] = next++;
        this->Mesh.Points.insert(
          this->Mesh.Points.end(), this->Middles[e].begin(), this->Middles[e].end());
        this->Mesh.Normals.insert(
          this->Mesh.Normals.end(), this->Normals[e].begin(), this->Normals[e].end());
      }
    }
    for (std::int32_t& corner : this->Mesh.Triangles)
    {
      corner = corner < this->FirstNew ? corner
                                       : number[static_cast<std::size_t>(corner - this->FirstNew)];
    }
  }

  PointSurfaceMesh& Mesh;
  const MovingLeastSquares& Surface;
  const ToolSurface& Tool;
  const double Near;
  Executor& Threads;
  Monitor& Watch;
  const std::int32_t FirstNew;
  std::vector<std::uint64_t> Edges; ///< pairs of points, sorted
  std::vector<std::uint8_t> IsEnd; ///< [point], of one of them
  std::vector<Real3> Middles; ///< as Edges, and so are the next two
  std::vector<Real3> Normals;
  std::vector<std::uint8_t> IsCut;
  std::vector<std::size_t> Touched; ///< triangles
  std::vector<Corners> EdgesOfTouched; ///< as Touched; None where an edge is not listed
};

} // namespace

void RefineNearTool(PointSurfaceMesh& mesh, const MovingLeastSquares& surface,
  const ToolSurface& tool, double cell, Executor& executor, Monitor& monitor)
{
  const std::size_t most = std::max(LargeMesh, 2 * mesh.Triangles.size() / 3);
  for (int halving = 0; halving < Halvings; ++halving)
  {
    const std::size_t count = mesh.Triangles.size() / 3;
    if (!Halving(mesh, surface, tool, cell, executor, monitor).Run(most - std::min(most, count)))
    {
      return;
    }
  }
}

} // namespace sb
