// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TrimmedDomain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sb
{
namespace
{

constexpr double LatticeSteps = 268435456.0; // 2^28: products of differences fit into 64 bits
constexpr double Margin = 1e-6; ///< around the domain, in its size
constexpr double Degenerate = 1e-7; ///< ratio of the lengths of the domain along u and v
constexpr std::size_t MostRows = 4096;

Parameters ParametersOf(const DesignedSurface& designed, std::int32_t point)
{
  const std::size_t place = 2 * static_cast<std::size_t>(point);
  return { designed.UV[place], designed.UV[place + 1] };
}

/** Which parameter does not matter at a place, as all its values give the same point: 0 u, 1 v, -1
 * none. */
int PoleAt(const NURBSSurface& patch, const Parameters& at)
{
  const PatchPoint p = EvaluatePatch(patch, at[0], at[1], 1);
  const double alongU = Length(p.Du) * (patch.LastU() - patch.FirstU());
  const double alongV = Length(p.Dv) * (patch.LastV() - patch.FirstV());
  return alongU <= Degenerate * alongV ? (alongV > 0.0 ? 0 : -1)
                                       : (alongV <= Degenerate * alongU ? 1 : -1);
}

} // namespace

TrimmedDomain::TrimmedDomain(
  const DesignedSurface& designed, const std::vector<std::int32_t>& triangles)
{
  this->MakeBox(designed, triangles);
  this->FindBorder(designed, triangles);
  if (!triangles.empty())
  {
    const std::size_t face =
      static_cast<std::size_t>(designed.FaceId[static_cast<std::size_t>(triangles.front())]);
    this->OpenPoles(designed.Patches[face]);
  }
  this->SortIntoRows();
}

void TrimmedDomain::MakeBox(
  const DesignedSurface& designed, const std::vector<std::int32_t>& triangles)
{
  const double most = std::numeric_limits<double>::max();
  ParameterBox box{ most, -most, most, -most };
  for (const std::int32_t triangle : triangles)
  {
    Parameters corners[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] =
        ParametersOf(designed, designed.Triangles[3 * static_cast<std::size_t>(triangle) + k]);
      box.FirstU = std::min(box.FirstU, corners[k][0]);
      box.LastU = std::max(box.LastU, corners[k][0]);
      box.FirstV = std::min(box.FirstV, corners[k][1]);
      box.LastV = std::max(box.LastV, corners[k][1]);
    }
    this->Area += (corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
      (corners[1][1] - corners[0][1]) * (corners[2][0] - corners[0][0]);
  }
  if (!(box.FirstU <= box.LastU))
  {
    return;
  }
  // At odd places, so that halving the box does not meet the border of a symmetric face.
  const double marginU = Margin * (box.LastU - box.FirstU);
  const double marginV = Margin * (box.LastV - box.FirstV);
  this->Around = { box.FirstU - 1.3 * marginU, box.LastU + 1.9 * marginU,
    box.FirstV - 1.7 * marginV, box.LastV + 1.1 * marginV };
}

void TrimmedDomain::FindBorder(
  const DesignedSurface& designed, const std::vector<std::int32_t>& triangles)
{
  struct Half
  {
    std::int32_t Least;
    std::int32_t Most;
    bool Turned;
  };
  std::vector<Half> halves;
  halves.reserve(3 * triangles.size());
  for (const std::int32_t triangle : triangles)
  {
    const std::int32_t* corners =
      designed.Triangles.data() + 3 * static_cast<std::size_t>(triangle);
    for (int k = 0; k < 3; ++k)
    {
      const std::int32_t from = corners[k];
      const std::int32_t to = corners[(k + 1) % 3];
      halves.push_back({ std::min(from, to), std::max(from, to), from > to });
    }
  }
  const auto key = [](const Half& half) { return std::make_pair(half.Least, half.Most); };
  std::sort(
    halves.begin(), halves.end(), [&](const Half& a, const Half& b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < halves.size();)
  {
    std::size_t end = i + 1;
    while (end < halves.size() && key(halves[end]) == key(halves[i]))
    {
      ++end;
    }
    if ((end - i) % 2 == 1)
    {
      const std::int32_t from = halves[i].Turned ? halves[i].Most : halves[i].Least;
      const std::int32_t to = halves[i].Turned ? halves[i].Least : halves[i].Most;
      this->Edges.push_back({ ParametersOf(designed, from), ParametersOf(designed, to), from, to });
    }
    i = end;
  }
}

/** A facet mesh has one vertex, or few, where the patch has a pole; its u there is any. The border
 * goes straight up to the pole's line, and along it. */
void TrimmedDomain::OpenPoles(const NURBSSurface& patch)
{
  struct Opened
  {
    std::int32_t Point;
    bool Leaves;
    Parameters At;
  };
  std::vector<Opened> opened;
  for (Edge& edge : this->Edges)
  {
    const int from = PoleAt(patch, edge.From);
    const int to = PoleAt(patch, edge.To);
    if (from >= 0 && from != to)
    {
      edge.From[static_cast<std::size_t>(from)] = edge.To[static_cast<std::size_t>(from)];
    }
    if (to >= 0 && from != to)
    {
      edge.To[static_cast<std::size_t>(to)] = edge.From[static_cast<std::size_t>(to)];
    }
    if (from >= 0)
    {
      opened.push_back({ edge.FromPoint, true, edge.From });
    }
    if (to >= 0)
    {
      opened.push_back({ edge.ToPoint, false, edge.To });
    }
  }
  std::stable_sort(opened.begin(), opened.end(), [](const Opened& a, const Opened& b) {
    return std::make_pair(a.Point, a.Leaves) < std::make_pair(b.Point, b.Leaves);
  });
  for (std::size_t i = 0; i + 1 < opened.size(); ++i)
  {
    const Opened& arrives = opened[i];
    const Opened& leaves = opened[i + 1];
    if (arrives.Point == leaves.Point && !arrives.Leaves && leaves.Leaves &&
      arrives.At != leaves.At)
    {
      this->Edges.push_back({ arrives.At, leaves.At, arrives.Point, arrives.Point });
    }
  }
}

TrimmedDomain::LatticePoint TrimmedDomain::Snap(const Parameters& at) const
{
  const auto step = [](double x, double first, double last) {
    const double place = (x - first) / (last - first) * LatticeSteps;
    return static_cast<std::int64_t>(std::clamp(place, -LatticeSteps, 2.0 * LatticeSteps));
  };
  return { step(at[0], this->Around.FirstU, this->Around.LastU),
    step(at[1], this->Around.FirstV, this->Around.LastV) };
}

std::size_t TrimmedDomain::RowOf(std::int64_t v) const
{
  const std::int64_t steps = static_cast<std::int64_t>(LatticeSteps);
  const std::int64_t inside = std::clamp<std::int64_t>(v, 0, steps - 1);
  return static_cast<std::size_t>(inside * static_cast<std::int64_t>(this->Rows.size()) / steps);
}

void TrimmedDomain::SortIntoRows()
{
  this->Rows.resize(std::clamp<std::size_t>(this->Edges.size() / 4, 1, MostRows));
  for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
  {
    const LatticePoint from = this->Snap(this->Edges[edge].From);
    const LatticePoint to = this->Snap(this->Edges[edge].To);
    this->Snapped.push_back({ from, to });
    for (std::size_t row = this->RowOf(std::min(from.V, to.V));
         row <= this->RowOf(std::max(from.V, to.V)); ++row)
    {
      this->Rows[row].push_back(static_cast<std::int32_t>(edge));
    }
  }
}

template <class Visit>
void TrimmedDomain::ForEdges(
  const LatticePoint& lower, const LatticePoint& upper, const Visit& visit) const
{
  const std::size_t first = this->RowOf(lower.V);
  for (std::size_t row = first; row <= this->RowOf(upper.V); ++row)
  {
    for (const std::int32_t number : this->Rows[row])
    {
      const std::size_t edge = static_cast<std::size_t>(number);
      const auto& [from, to] = this->Snapped[edge];
      const bool meets = std::min(from.U, to.U) <= upper.U && std::max(from.U, to.U) >= lower.U &&
        std::min(from.V, to.V) <= upper.V && std::max(from.V, to.V) >= lower.V;
      // In the first of the rows that both reach into.
      if (meets && row == std::max(first, this->RowOf(std::min(from.V, to.V))))
      {
        visit(edge);
      }
    }
  }
}

/** The side of the line from a to b that a point of the border, shifted by e in u and e^2 in v, is
 * on: 1 left, -1 right. */
int TrimmedDomain::SideOf(const LatticePoint& a, const LatticePoint& b, const LatticePoint& border)
{
  const std::int64_t u = b.U - a.U;
  const std::int64_t v = b.V - a.V;
  const std::int64_t turn = u * (border.V - a.V) - v * (border.U - a.U);
  if (turn != 0)
  {
    return turn > 0 ? 1 : -1;
  }
  return v != 0 ? (v < 0 ? 1 : -1) : (u >= 0 ? 1 : -1);
}

bool TrimmedDomain::Crosses(const LatticePoint& a, const LatticePoint& b, std::size_t edge) const
{
  const auto& [from, to] = this->Snapped[edge];
  if (SideOf(a, b, from) == SideOf(a, b, to))
  {
    return false;
  }
  // The points a and b against the shifted edge: the same turn, seen from the edge.
  const auto sideOfEdge = [&from = from, &to = to](const LatticePoint& at) {
    const std::int64_t u = to.U - from.U;
    const std::int64_t v = to.V - from.V;
    const std::int64_t turn = u * (at.V - from.V) - v * (at.U - from.U);
    return turn != 0 ? turn > 0 : (v != 0 ? v > 0 : u < 0);
  };
  return sideOfEdge(a) != sideOfEdge(b);
}

bool TrimmedDomain::Contains(const Parameters& at) const
{
  const LatticePoint a = this->Snap(at);
  const LatticePoint b{ -2 * static_cast<std::int64_t>(LatticeSteps), a.V };
  bool inside = false;
  this->ForEdges(
    { b.U, a.V }, a, [&](std::size_t edge) { inside = inside != this->Crosses(a, b, edge); });
  return inside;
}

bool TrimmedDomain::MayMeet(const ParameterBox& box) const
{
  bool meets = false;
  this->ForEdges(this->Snap({ box.FirstU, box.FirstV }), this->Snap({ box.LastU, box.LastV }),
    [&](std::size_t) { meets = true; });
  return meets ||
    this->Contains({ 0.5 * (box.FirstU + box.LastU), 0.5 * (box.FirstV + box.LastV) });
}

std::vector<TrimmedDomain::Crossing> TrimmedDomain::CrossingsOf(
  const Parameters& from, const Parameters& to) const
{
  const LatticePoint a = this->Snap(from);
  const LatticePoint b = this->Snap(to);
  std::vector<Crossing> crossings;
  const auto visit = [&](std::size_t edge) {
    if (!this->Crosses(a, b, edge))
    {
      return;
    }
    const Edge& border = this->Edges[edge];
    const double u = to[0] - from[0];
    const double v = to[1] - from[1];
    const double edgeU = border.To[0] - border.From[0];
    const double edgeV = border.To[1] - border.From[1];
    const double apartU = border.From[0] - from[0];
    const double apartV = border.From[1] - from[1];
    const double turn = u * edgeV - v * edgeU;
    const double along = turn != 0.0 ? (apartU * edgeV - apartV * edgeU) / turn : 0.5;
    const double alongEdge = turn != 0.0 ? (apartU * v - apartV * u) / turn : 0.5;
    crossings.push_back({ edge, std::clamp(along, 0.0, 1.0), std::clamp(alongEdge, 0.0, 1.0) });
  };
  this->ForEdges(
    { std::min(a.U, b.U), std::min(a.V, b.V) }, { std::max(a.U, b.U), std::max(a.V, b.V) }, visit);
  std::stable_sort(crossings.begin(), crossings.end(),
    [](const Crossing& x, const Crossing& y) { return x.Along < y.Along; });
  return crossings;
}

} // namespace sb
