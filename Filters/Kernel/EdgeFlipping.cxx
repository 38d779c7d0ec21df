// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeFlipping.h"

#include "PlaceTable.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace sb
{
namespace
{

constexpr std::int32_t None = -1;
constexpr double LeastSine = 1e-9; ///< beyond a half turn, so that no flip is undone by rounding
constexpr std::size_t MostFlipsEach = 100; ///< as none of this is exact

class Flipping
{
public:
  Flipping(std::vector<FlippableTriangle>& triangles, const std::vector<double>& points)
    : Triangles(triangles)
    , Points(points)
    , Neighbours(triangles.size(), { None, None, None })
  {
  }

  void Run()
  {
    this->FindNeighbours();
    const std::size_t most = MostFlipsEach * this->Triangles.size();
    for (std::size_t flips = 0; !this->Waiting.empty() && flips < most;)
    {
      const Edge edge = this->Waiting.back();
      this->Waiting.pop_back();
      flips += this->Visit(edge) ? 1 : 0;
    }
  }

private:
  struct Edge
  {
    std::int32_t Triangle;
    std::size_t Number;
  };

  void FindNeighbours()
  {
    std::vector<std::tuple<std::uint64_t, std::int32_t, std::size_t>> edges;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (!this->Triangles[t].IsFixed[k])
        {
          edges.emplace_back(
            PairOfPlaces(this->Triangles[t].Corners[k], this->Triangles[t].Corners[(k + 1) % 3]),
            static_cast<std::int32_t>(t), k);
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i)
    {
      if (std::get<0>(edges[i]) == std::get<0>(edges[i - 1]))
      {
        const auto& [first, t, k] = edges[i - 1];
        const auto& [second, u, l] = edges[i];
        this->Neighbours[static_cast<std::size_t>(t)][k] = u;
        this->Neighbours[static_cast<std::size_t>(u)][l] = t;
        this->Waiting.push_back({ t, k });
      }
    }
  }

  Real3 Point(std::int32_t i) const
  {
    const double* x = this->Points.data() + 3 * static_cast<std::size_t>(i);
    return { x[0], x[1], x[2] };
  }

  /** The number of the edge of n towards t, from corner a to corner b or back. */
  std::size_t EdgeTowards(std::int32_t n, std::int32_t t, std::int32_t a, std::int32_t b) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto& corners = this->Triangles[static_cast<std::size_t>(n)].Corners;
      if (this->Neighbours[static_cast<std::size_t>(n)][k] == t &&
        PairOfPlaces(corners[k], corners[(k + 1) % 3]) == PairOfPlaces(a, b))
      {
        return k;
      }
    }
    return 3;
  }

  /** Whether the edge from a to b is to be replaced by that from d to c. */
  bool IsWrong(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const
  {
    const Real3 pa = this->Point(a);
    const Real3 pb = this->Point(b);
    const Real3 pc = this->Point(c);
    const Real3 pd = this->Point(d);
    const auto angle = [&](const Real3& at) {
      const Real3 first = Difference(pa, at);
      const Real3 second = Difference(pb, at);
      const Real3 both{ Dot(first, second), Length(Cross(first, second)), 0.0 };
      return Scaled(both, 1.0 / Length(both)); // its cosine and sine
    };
    const Real3 one = angle(pc);
    const Real3 other = angle(pd);
    if (!(one[1] * other[0] + one[0] * other[1] < -LeastSine))
    {
      return false;
    }
    const Real3 before = PlusScaled(Cross(Difference(pb, pa), Difference(pc, pa)), 1.0,
      Cross(Difference(pa, pb), Difference(pd, pb)));
    const double enough = LeastSine * Dot(before, before);
    return Dot(Cross(Difference(pd, pa), Difference(pc, pa)), before) > enough &&
      Dot(Cross(Difference(pb, pd), Difference(pc, pd)), before) > enough;
  }

  bool Visit(const Edge& edge)
  {
    const std::size_t t = static_cast<std::size_t>(edge.Triangle);
    const std::size_t k = edge.Number;
    const std::int32_t n = this->Neighbours[t][k];
    const std::int32_t a = this->Triangles[t].Corners[k];
    const std::int32_t b = this->Triangles[t].Corners[(k + 1) % 3];
    const std::int32_t c = this->Triangles[t].Corners[(k + 2) % 3];
    const std::size_t l = n == None ? 3 : this->EdgeTowards(n, edge.Triangle, a, b);
    if (l == 3 || this->Triangles[static_cast<std::size_t>(n)].Corners[l] != b)
    {
      return false;
    }
    const std::int32_t d = this->Triangles[static_cast<std::size_t>(n)].Corners[(l + 2) % 3];
    if (c == d || !this->IsWrong(a, b, c, d))
    {
      return false;
    }
    this->Flip(t, k, static_cast<std::size_t>(n), l);
    return true;
  }

  /** The edge k of t, from a to b, which is edge l of n, becomes the one from d to c. */
  void Flip(std::size_t t, std::size_t k, std::size_t n, std::size_t l)
  {
    const FlippableTriangle first = this->Triangles[t];
    const FlippableTriangle second = this->Triangles[n];
    const std::array<std::int32_t, 3> ofFirst = this->Neighbours[t];
    const std::array<std::int32_t, 3> ofSecond = this->Neighbours[n];
    const std::size_t bc = (k + 1) % 3;
    const std::size_t ca = (k + 2) % 3;
    const std::size_t ad = (l + 1) % 3;
    const std::size_t db = (l + 2) % 3;
    const std::int32_t a = first.Corners[k];
    const std::int32_t b = first.Corners[bc];
    const std::int32_t c = first.Corners[ca];
    const std::int32_t d = second.Corners[db];
    this->Triangles[t] = { { a, d, c }, { second.IsFixed[ad], false, first.IsFixed[ca] }, true };
    this->Triangles[n] = { { d, b, c }, { second.IsFixed[db], first.IsFixed[bc], false }, true };
    const std::int32_t idOfFirst = static_cast<std::int32_t>(t);
    const std::int32_t idOfSecond = static_cast<std::int32_t>(n);
    this->Neighbours[t] = { ofSecond[ad], idOfSecond, ofFirst[ca] };
    this->Neighbours[n] = { ofSecond[db], ofFirst[bc], idOfFirst };
    this->Redirect(ofSecond[ad], idOfSecond, idOfFirst, a, d);
    this->Redirect(ofFirst[bc], idOfFirst, idOfSecond, b, c);
    for (const Edge& edge :
      { Edge{ idOfFirst, 0 }, Edge{ idOfFirst, 2 }, Edge{ idOfSecond, 0 }, Edge{ idOfSecond, 1 } })
    {
      if (this->Neighbours[static_cast<std::size_t>(edge.Triangle)][edge.Number] != None)
      {
        this->Waiting.push_back(edge);
      }
    }
  }

  /** The neighbour across the edge from a to b is another one now. */
  void Redirect(
    std::int32_t triangle, std::int32_t from, std::int32_t to, std::int32_t a, std::int32_t b)
  {
    if (triangle != None)
    {
      const std::size_t k = this->EdgeTowards(triangle, from, a, b);
      if (k < 3)
      {
        this->Neighbours[static_cast<std::size_t>(triangle)][k] = to;
      }
    }
  }

  std::vector<FlippableTriangle>& Triangles;
  const std::vector<double>& Points;
  std::vector<std::array<std::int32_t, 3>> Neighbours;
  std::vector<Edge> Waiting;
};

} // namespace

void FlipToDelaunay(std::vector<FlippableTriangle>& triangles, const std::vector<double>& points)
{
  Flipping(triangles, points).Run();
}

} // namespace sb
