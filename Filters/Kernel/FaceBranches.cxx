// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceBranches.h"

#include "CommonPoint.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 64;
constexpr double Rounding = 1e-12; ///< in widths: values below it have no sign
constexpr double OnBorder = 1e-5; ///< in lengths of the domain; the tree ends a little beyond it

/** Branches of a face, before they are trimmed. */
class BranchFinding
{
public:
  BranchFinding(const BranchRequest& request, Executor& executor, Monitor& monitor)
    : Surface(request.Surface)
    , Domain(request.Domain)
    , Tolerance(request.Tolerance)
    , Patch(request.Patch)
    , Tree(request.Tree)
    , NearestTouch(request.NearestTouch)
    , Threads(executor)
    , Watch(monitor)
  {
    this->EvaluateVertices();
    this->ListRings();
    this->FindCoincidentCells();
    this->ListSegments();
    this->FindRoots();
  }

  /** Open branches first; a loop has its first node again at its end. */
  std::vector<FaceBranch> Branches()
  {
    std::vector<std::uint8_t> hasPrevious(this->Next.size(), 0);
    for (const std::int32_t next : this->Next)
    {
      if (next >= 0)
      {
        hasPrevious[static_cast<std::size_t>(next)] = 1;
      }
    }
    std::vector<FaceBranch> branches;
    for (const std::uint8_t loops : { std::uint8_t(0), std::uint8_t(1) })
    {
      for (std::size_t first = 0; first < this->Next.size(); ++first)
      {
        if (this->Next[first] >= 0 && hasPrevious[first] == loops)
        {
          branches.push_back(this->Follow(first));
        }
      }
    }
    return branches;
  }

  double CoincidentArea() const { return this->Area; }

  std::vector<std::uint8_t> CrossedCells() { return std::move(this->IsCrossed); }

  std::vector<SurfaceTouch> Touches() const
  {
    std::vector<double> values = this->Values;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (std::abs(values[i]) <= this->NearestTouch &&
        !this->IsInDomain(this->Tree.ParametersOf(i)))
      {
        values[i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
    TouchSearch search(std::move(values), this->NearestTouch, Rounding * this->Surface.Width());
    for (std::size_t cell = 0; cell < this->Tree.NumberOfCells(); ++cell)
    {
      const std::size_t end = this->RingStarts[cell + 1];
      for (std::size_t k = this->RingStarts[cell]; k < end; ++k)
      {
        const std::int32_t vertex = static_cast<std::int32_t>(this->Rings[k]);
        if (this->IsCoincident[cell])
        {
          search.LeaveOut(vertex);
        }
        for (std::size_t other = k + 1; other < end; ++other)
        {
          search.Link(vertex, static_cast<std::int32_t>(this->Rings[other]));
        }
      }
    }
    MovingLeastSquares::Neighbourhood near;
    const auto placeOf = [this](std::int32_t vertex) {
      return this->Evaluate(this->Tree.ParametersOf(static_cast<std::size_t>(vertex)), 1).Point;
    };
    return search.Find(this->Surface, placeOf, near);
  }

private:
  /** Within the domain or on its border, where a face may touch with its edge. */
  bool IsInDomain(const Parameters& at) const
  {
    const ParameterBox& all = this->Domain.Box();
    const double u = OnBorder * (all.LastU - all.FirstU);
    const double v = OnBorder * (all.LastV - all.FirstV);
    return this->Domain.Contains(at) ||
      this->Domain.MayMeet({ at[0] - u, at[0] + u, at[1] - v, at[1] + v });
  }

  /** Two neighbours on a ring, the smaller number first. */
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void EvaluateVertices()
  {
    const std::size_t count = this->Tree.NumberOfVertices();
    this->Values.resize(count);
    this->IsParallel.assign(count, 0);
    const double none = std::numeric_limits<double>::quiet_NaN();
    this->Threads.For(
      static_cast<std::int64_t>(count), Grain, [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = static_cast<std::size_t>(begin);
             i < static_cast<std::size_t>(end) && !this->Watch.Aborted(); ++i)
        {
          const Parameters at = this->Tree.ParametersOf(i);
          const PatchPoint p = this->Evaluate(at, 1);
          SurfaceValue f = this->Surface.EvaluateAt(p.Point, 0, near);
          this->Values[i] = f.IsNear ? f.Value : none;
          if (f.IsNear && std::abs(f.Value) <= this->Tolerance.Most())
          {
            f = this->Surface.Evaluate(p.Point, 1, near);
            const Real3 normal = Cross(p.Du, p.Dv);
            this->IsParallel[i] = Length(Cross(normal, f.Gradient)) <=
              TangentialSine * Length(normal) * Length(f.Gradient);
          }
        }
      });
  }

  /** Beyond the domain, where a cell's corner may be by a millionth, the tangent plane. */
  PatchPoint Evaluate(const Parameters& at, int order) const
  {
    PatchPoint p = EvaluatePatch(this->Patch, at[0], at[1], std::max(order, 1));
    const double overU = at[0] - std::clamp(at[0], this->Patch.FirstU(), this->Patch.LastU());
    const double overV = at[1] - std::clamp(at[1], this->Patch.FirstV(), this->Patch.LastV());
    if (overU != 0.0 || overV != 0.0)
    {
      p.Point = PlusScaled(PlusScaled(p.Point, overU, p.Du), overV, p.Dv);
    }
    return p;
  }

  void ListRings()
  {
    std::vector<std::size_t> ring;
    this->RingStarts.push_back(0);
    for (std::size_t cell = 0; cell < this->Tree.NumberOfCells(); ++cell)
    {
      this->Tree.RingOf(cell, ring);
      for (const std::size_t vertex : ring)
      {
        this->Rings.push_back(static_cast<std::uint32_t>(vertex));
      }
      this->RingStarts.push_back(this->Rings.size());
    }
  }

  void FindCoincidentCells()
  {
    this->IsCoincident = this->CellsWithin(this->Tolerance.Most());
    if (!this->IsCoincident.empty())
    {
      this->IsCoincident = this->CellsWithin(this->Tolerance.Value());
    }
    this->IsCoincident.resize(this->Tree.NumberOfCells(), 0);
    for (std::size_t cell = 0; cell < this->IsCoincident.size(); ++cell)
    {
      if (this->IsCoincident[cell])
      {
        const ParameterBox box = this->Tree.BoxOf(cell);
        const PatchPoint middle = this->MiddleOf(cell);
        this->Area +=
          Length(Cross(middle.Du, middle.Dv)) * (box.LastU - box.FirstU) * (box.LastV - box.FirstV);
      }
    }
  }

  std::vector<std::uint8_t> CellsWithin(double tolerance) const
  {
    std::vector<std::uint8_t> coincides;
    bool isAny = false;
    for (std::size_t cell = 0; cell < this->Tree.NumberOfCells(); ++cell)
    {
      coincides.push_back(this->IsClose(cell, tolerance) ? 1 : 0);
      isAny = isAny || coincides.back() == 1;
    }
    if (!isAny)
    {
      return {};
    }
    std::vector<Real3> middles;
    for (std::size_t cell = 0; cell < this->Tree.NumberOfCells(); ++cell)
    {
      middles.push_back(this->MiddleOf(cell).Point);
    }
    return AreaOf(middles, coincides, this->Surface.Width(), this->Threads);
  }

  PatchPoint MiddleOf(std::size_t cell) const
  {
    const ParameterBox box = this->Tree.BoxOf(cell);
    return EvaluatePatch(
      this->Patch, 0.5 * (box.FirstU + box.LastU), 0.5 * (box.FirstV + box.LastV), 1);
  }

  bool IsClose(std::size_t cell, double tolerance) const
  {
    return std::all_of(this->Rings.begin() + this->Offset(cell),
      this->Rings.begin() + this->Offset(cell + 1), [&](std::uint32_t vertex) {
        return this->IsParallel[vertex] && std::abs(this->Values[vertex]) <= tolerance;
      });
  }

  std::ptrdiff_t Offset(std::size_t cell) const
  {
    return static_cast<std::ptrdiff_t>(this->RingStarts[cell]);
  }

  bool IsInside(std::uint32_t vertex) const
  {
    return this->Values[vertex] < -Rounding * this->Surface.Width();
  }

  /** In each cell, from the edges where the curve comes in to those where it goes out, the inside
   * on its left. */
  void ListSegments()
  {
    std::vector<std::pair<Edge, Edge>> segments;
    this->IsCrossed.assign(this->Tree.NumberOfCells(), 0);
    for (std::size_t cell = 0; cell < this->Tree.NumberOfCells(); ++cell)
    {
      const std::uint32_t* ring = this->Rings.data() + this->RingStarts[cell];
      const std::size_t count = this->RingStarts[cell + 1] - this->RingStarts[cell];
      const bool known = std::none_of(
        ring, ring + count, [&](std::uint32_t vertex) { return std::isnan(this->Values[vertex]); });
      const auto edge = [&](std::size_t k) {
        return Edge(std::minmax(ring[k % count], ring[(k + 1) % count]));
      };
      for (std::size_t leaves = 0; known && leaves < count; ++leaves)
      {
        if (this->IsInside(ring[leaves]) && !this->IsInside(ring[(leaves + 1) % count]))
        {
          this->IsCrossed[cell] = 1;
          // The run of inside corners that ends here is cut off by one segment.
          std::size_t enters = leaves + count - 1;
          while (this->IsInside(ring[enters % count]))
          {
            --enters;
          }
          (this->IsCoincident[cell] ? this->Suppressed : segments)
            .push_back({ edge(leaves), edge(enters) });
        }
      }
    }
    for (const auto& [from, to] : segments)
    {
      this->Edges.push_back(from);
      this->Edges.push_back(to);
    }
    ParallelSortUnique(this->Edges, this->Threads);
    this->Next.assign(this->Edges.size(), -1);
    for (const auto& [from, to] : segments)
    {
      this->Next[this->NumberOf(from)] = static_cast<std::int32_t>(this->NumberOf(to));
    }
  }

  std::size_t NumberOf(const Edge& edge) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(this->Edges.begin(), this->Edges.end(), edge) - this->Edges.begin());
  }

  void FindRoots()
  {
    this->Roots.resize(this->Edges.size());
    this->Supported.assign(this->Edges.size(), 0);
    this->Threads.For(static_cast<std::int64_t>(this->Edges.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = static_cast<std::size_t>(begin);
             i < static_cast<std::size_t>(end) && !this->Watch.Aborted(); ++i)
        {
          this->FindRoot(i, near);
        }
      });
    for (std::size_t i = 0; i < this->Next.size(); ++i)
    {
      const std::int32_t next = this->Next[i];
      if (next >= 0 && !(this->Supported[i] && this->Supported[static_cast<std::size_t>(next)]))
      {
        this->Next[i] = -1;
      }
    }
  }

  /** Newton's method on an edge, held between the ends with different signs. */
  void FindRoot(std::size_t edge, MovingLeastSquares::Neighbourhood& near)
  {
    const auto [first, second] = this->Edges[edge];
    const Parameters a = this->Tree.ParametersOf(first);
    const Parameters b = this->Tree.ParametersOf(second);
    const bool startsInside = this->IsInside(first);
    const double least = this->Values[first];
    double low = 0.0;
    double high = 1.0;
    double t = std::clamp(least / (least - this->Values[second]), 0.0, 1.0);
    SurfaceValue f;
    bool wasLast = false;
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      const Parameters at{ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) };
      const PatchPoint p = this->Evaluate(at, 1);
      f = this->Surface.EvaluateAt(p.Point, 1, near);
      this->Roots[edge] = { p.Point, at[0], at[1] };
      ((f.Value < 0.0) == startsInside ? low : high) = t;
      const double slope =
        Dot(f.Gradient, p.Du) * (b[0] - a[0]) + Dot(f.Gradient, p.Dv) * (b[1] - a[1]);
      const double newton = t - f.Value / slope;
      const double next = newton >= low && newton <= high ? newton : 0.5 * (low + high);
      const double step = std::abs(next - t);
      t = next;
      // One step more than to what is negligible: it brings all that there are digits for.
      const bool isLast = std::abs(f.Value) <= NegligibleValue(p.Point, this->Surface.Width());
      if (step < 1e-14 || wasLast)
      {
        break;
      }
      wasLast = isLast;
    }
    this->Supported[edge] =
      f.Where == Support::Defined || f.Where == Support::Contradicting ? 1 : 0;
  }

  FaceBranch Follow(std::size_t first)
  {
    FaceBranch branch;
    branch.Begin = this->EndAt(first);
    branch.Nodes.push_back(this->Roots[first]);
    std::size_t at = first;
    while (this->Next[at] >= 0)
    {
      const std::size_t next = static_cast<std::size_t>(this->Next[at]);
      this->Next[at] = -1;
      branch.Nodes.push_back(this->Roots[next]);
      at = next;
    }
    branch.Closed = at == first;
    branch.End = this->EndAt(at);
    return branch;
  }

  CurveEnd EndAt(std::size_t edge) const
  {
    const bool meetsCoincident = std::any_of(
      this->Suppressed.begin(), this->Suppressed.end(), [&](const std::pair<Edge, Edge>& segment) {
        return segment.first == this->Edges[edge] || segment.second == this->Edges[edge];
      });
    return meetsCoincident ? CurveEnd::CoincidentArea : CurveEnd::ScanBorder;
  }

  const MovingLeastSquares& Surface;
  const TrimmedDomain& Domain;
  CoincidenceTolerance& Tolerance;
  const NURBSSurface& Patch;
  const PatchQuadtree& Tree;
  const double NearestTouch;
  Executor& Threads;
  Monitor& Watch;
  std::vector<double> Values; ///< of vertices; NaN where there is none
  std::vector<std::uint8_t> IsParallel; ///< vertices that are near the surface and its tangents
  std::vector<std::uint32_t> Rings; ///< of all cells, one after another
  std::vector<std::size_t> RingStarts;
  std::vector<std::uint8_t> IsCoincident; ///< of cells, and so is the next
  std::vector<std::uint8_t> IsCrossed;
  std::vector<std::pair<Edge, Edge>> Suppressed; ///< segments in coincident cells
  std::vector<Edge> Edges; ///< that branches cross
  std::vector<std::int32_t> Next; ///< of an edge, the one that its branch goes to
  std::vector<CurveNode> Roots; ///< of edges
  std::vector<std::uint8_t> Supported; ///< of edges
  double Area = 0.0;
};

} // namespace

FaceBranches FindBranches(const BranchRequest& request, Executor& executor, Monitor& monitor)
{
  BranchFinding finding(request, executor, monitor);
  if (monitor.Aborted())
  {
    return {};
  }
  std::vector<SurfaceTouch> touches = finding.Touches();
  return { finding.Branches(), finding.CoincidentArea(), finding.CrossedCells(),
    std::move(touches) };
}

} // namespace sb
