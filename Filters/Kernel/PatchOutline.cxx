// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchOutline.h"

#include "Predicates.h"

#include <algorithm>
#include <cstddef>

namespace sb
{

namespace
{

/**
 * A line sweeps over the view, and the edges that it meets are kept in their order along it (M. I.
 * Shamos and D. Hoey, "Geometric intersection problems", 1976). Two edges that cross are out of
 * order from there on. They stay beside each other until one of them ends or something comes
 * between them, and the point at which that happens cannot be on the right side of both. So it is
 * enough to compare each point with the edges right below and above it.
 */
class OutlineSweep
{
public:
  OutlineSweep(const double* positions, const std::vector<OutlineEdge>& outline, View view)
    : Positions(positions)
    , Axis(view.Axis)
    , U((view.Axis + 1) % 3)
    , V((view.Axis + 2) % 3)
  {
    this->Edges.reserve(outline.size());
    this->Ends.reserve(2 * outline.size());
    for (const OutlineEdge& edge : outline)
    {
      view.IsFromBelow ? this->AddEdge(edge.To, edge.From) : this->AddEdge(edge.From, edge.To);
    }
  }

  bool Run()
  {
    std::sort(this->Ends.begin(), this->Ends.end());
    for (std::size_t begin = 0; begin < this->Ends.size();)
    {
      std::size_t end = begin + 1;
      while (end < this->Ends.size() && this->Ends[end].Vertex == this->Ends[begin].Vertex)
      {
        ++end;
      }
      // Of two vertices at one place neither knows the other one's edges.
      if ((end < this->Ends.size() && this->Ends[end].IsAtPlaceOf(this->Ends[begin])) ||
        !this->Pass(begin, end))
      {
        return false;
      }
      begin = end;
    }
    return true;
  }

private:
  /** From its end that the line comes to first to the other one. */
  struct Edge
  {
    std::int32_t First;
    std::int32_t Last;
    bool RunsAlong; ///< whether the outline does, too: the patch is then above it
  };

  struct End
  {
    double U;
    double V;
    std::int32_t Vertex;
    std::int32_t Edge;
    bool IsFirst;

    friend bool operator<(const End& l, const End& r)
    {
      return l.U != r.U        ? l.U < r.U
        : l.V != r.V           ? l.V < r.V
        : l.Vertex != r.Vertex ? l.Vertex < r.Vertex
                               : l.Edge < r.Edge;
    }
    bool IsAtPlaceOf(const End& other) const { return this->U == other.U && this->V == other.V; }
  };

  const double* At(std::int32_t vertex) const
  {
    return this->Positions + 3 * static_cast<std::ptrdiff_t>(vertex);
  }

  void AddEdge(std::int32_t from, std::int32_t to)
  {
    const auto number = static_cast<std::int32_t>(this->Edges.size());
    const double* p = this->At(from);
    const double* q = this->At(to);
    const bool along = p[this->U] != q[this->U] ? p[this->U] < q[this->U] : p[this->V] < q[this->V];
    this->Edges.push_back({ along ? from : to, along ? to : from, along });
    this->Ends.push_back({ p[this->U], p[this->V], from, number, along });
    this->Ends.push_back({ q[this->U], q[this->V], to, number, !along });
  }

  /** +1 if a point is above an edge. */
  int SideOf(std::int32_t edge, const double* point) const
  {
    const Edge& e = this->Edges[std::size_t(edge)];
    return Orient2D(this->At(e.First), this->At(e.Last), point, this->Axis);
  }

  /** Take the line over the vertex that has these ends. */
  bool Pass(std::size_t begin, std::size_t end)
  {
    const std::int32_t vertex = this->Ends[begin].Vertex;
    const double* point = this->At(vertex);
    this->Starting.clear();
    for (std::size_t i = begin; i < end; ++i)
    {
      if (this->Ends[i].IsFirst)
      {
        this->Starting.push_back(this->Ends[i].Edge);
      }
    }
    const auto ending = static_cast<std::ptrdiff_t>(end - begin - this->Starting.size());
    const auto place = std::partition_point(this->Status.begin(), this->Status.end(),
      [&](std::int32_t edge) { return this->SideOf(edge, point) > 0; });
    if (this->Status.end() - place < ending)
    {
      return false;
    }
    const auto above = place + ending;
    const bool endHere = std::all_of(place, above,
      [&](std::int32_t edge) { return this->Edges[std::size_t(edge)].Last == vertex; });
    const bool isBelowNext = above == this->Status.end() || this->SideOf(*above, point) < 0;
    if (!endHere || !isBelowNext || !this->OrderStarting(point) ||
      !this->TakeTurns(place != this->Status.begin() && this->RunsAlong(*(place - 1)),
        above != this->Status.end() && !this->RunsAlong(*above)))
    {
      return false;
    }
    const auto common =
      std::min<std::ptrdiff_t>(ending, static_cast<std::ptrdiff_t>(this->Starting.size()));
    std::copy_n(this->Starting.begin(), common, place);
    this->Status.insert(this->Status.erase(place + common, above), this->Starting.begin() + common,
      this->Starting.end());
    return true;
  }

  bool RunsAlong(std::int32_t edge) const { return this->Edges[std::size_t(edge)].RunsAlong; }

  /** Upwards. @return whether no two of them leave the point in one direction. */
  bool OrderStarting(const double* point)
  {
    const auto turn = [&](std::int32_t a, std::int32_t b) {
      return Orient2D(point, this->At(this->Edges[std::size_t(a)].Last),
        this->At(this->Edges[std::size_t(b)].Last), this->Axis);
    };
    std::sort(this->Starting.begin(), this->Starting.end(),
      [&](std::int32_t a, std::int32_t b) { return turn(a, b) > 0; });
    return std::adjacent_find(this->Starting.begin(), this->Starting.end(),
             [&](std::int32_t a, std::int32_t b) { return turn(a, b) == 0; }) ==
      this->Starting.end();
  }

  /** Whether the winding number is 0 and 1 in turns between the edges that start, if it is
   * `below` below them and `above` above them. */
  bool TakeTurns(bool below, bool above) const
  {
    bool isInside = below;
    for (const std::int32_t edge : this->Starting)
    {
      if (this->RunsAlong(edge) == isInside)
      {
        return false;
      }
      isInside = !isInside;
    }
    return isInside == above;
  }

  const double* Positions;
  int Axis;
  int U;
  int V;
  std::vector<Edge> Edges;
  std::vector<End> Ends;
  std::vector<std::int32_t> Status; ///< edges that the line meets, upwards
  std::vector<std::int32_t> Starting; ///< at the vertex that it passes
};

} // namespace

std::uint8_t ViewsFacing(const double* a, const double* b, const double* c)
{
  unsigned views = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int turn = Orient2D(a, b, c, axis);
    views |= (turn > 0 ? 1u : turn < 0 ? 2u : 0u) << (2 * axis);
  }
  return static_cast<std::uint8_t>(views);
}

bool EnclosesOnce(const double* positions, const std::vector<OutlineEdge>& outline, View view)
{
  return OutlineSweep(positions, outline, view).Run();
}

} // namespace sb
