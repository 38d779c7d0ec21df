// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSection.h"

#include "CommonPoint.h"
#include "ParallelSort.h"
#include "PatchQuadtree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 64;
constexpr double LargestCell = 1.4; ///< in spacings: its diagonal is shorter than two
constexpr double ReachInWidths = 1.0; ///< the surface is not farther from all samples
constexpr double Rounding = 1e-12; ///< in widths: values below it have no sign
constexpr double ShortestInWidths = 0.02; ///< from a cut to the next point of a branch

/** Branches of a face, before they are trimmed. */
class FaceBranches
{
public:
  FaceBranches(const FaceSectionRequest& request, const NURBSSurface& patch,
    const PatchQuadtree& tree, Executor& executor)
    : Surface(request.Surface)
    , Tolerance(request.Tolerance)
    , Patch(patch)
    , Tree(tree)
    , Threads(executor)
  {
    this->EvaluateVertices();
    this->ListRings();
    this->FindCoincidentCells();
    this->ListSegments();
    this->FindRoots();
  }

  struct Branch
  {
    std::vector<CurveNode> Nodes;
    bool Closed = false;
    CurveEnd Begin = CurveEnd::ScanBorder;
    CurveEnd End = CurveEnd::ScanBorder;
  };

  /** Open branches first; a loop has its first node again at its end. */
  std::vector<Branch> Branches()
  {
    std::vector<std::uint8_t> hasPrevious(this->Next.size(), 0);
    for (const std::int32_t next : this->Next)
    {
      if (next >= 0)
      {
        hasPrevious[static_cast<std::size_t>(next)] = 1;
      }
    }
    std::vector<Branch> branches;
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

private:
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
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
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
    ParallelSort(
      this->Edges, [](const Edge& a, const Edge& b) { return a < b; }, this->Threads);
    this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
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
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
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
      if (step < 1e-14 || std::abs(f.Value) < 1e-15 * this->Surface.Width())
      {
        break;
      }
    }
    this->Supported[edge] =
      f.Where == Support::Defined || f.Where == Support::Contradicting ? 1 : 0;
  }

  Branch Follow(std::size_t first)
  {
    Branch branch;
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
  CoincidenceTolerance& Tolerance;
  const NURBSSurface& Patch;
  const PatchQuadtree& Tree;
  Executor& Threads;
  std::vector<double> Values; ///< of vertices; NaN where there is none
  std::vector<std::uint8_t> IsParallel; ///< vertices that are near the surface and its tangents
  std::vector<std::uint32_t> Rings; ///< of all cells, one after another
  std::vector<std::size_t> RingStarts;
  std::vector<std::uint8_t> IsCoincident; ///< of cells
  std::vector<std::pair<Edge, Edge>> Suppressed; ///< segments in coincident cells
  std::vector<Edge> Edges; ///< that branches cross
  std::vector<std::int32_t> Next; ///< of an edge, the one that its branch goes to
  std::vector<CurveNode> Roots; ///< of edges
  std::vector<std::uint8_t> Supported; ///< of edges
  double Area = 0.0;
};

/** Cuts branches at the border of the trimmed domain. */
class Trimming
{
public:
  Trimming(const MovingLeastSquares& surface, const NURBSSurface& patch,
    const TrimmedDomain& domain, std::int32_t face, double farthest)
    : Surface(surface)
    , Patch(patch)
    , Domain(domain)
    , Face(face)
    , Farthest(farthest)
  {
  }

  void Cut(const FaceBranches::Branch& branch, std::vector<SectionPiece>& pieces)
  {
    const std::vector<CurveNode>& nodes = branch.Nodes;
    const std::size_t firstPiece = pieces.size();
    bool inside = this->Domain.Contains({ nodes.front().U, nodes.front().V });
    SectionPiece piece;
    piece.Face = this->Face;
    piece.Begin = branch.Begin;
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      if (inside)
      {
        this->Append(piece, nodes[k]);
      }
      if (k + 1 == nodes.size())
      {
        break;
      }
      for (const TrimmedDomain::Crossing& crossing :
        this->Domain.CrossingsOf({ nodes[k].U, nodes[k].V }, { nodes[k + 1].U, nodes[k + 1].V }))
      {
        const CurveNode cut = this->OnBorder(crossing);
        const TrimmedDomain::Edge& edge = this->Domain.Border()[crossing.Edge];
        if (inside)
        {
          this->Finish(piece, cut, edge, pieces);
        }
        else
        {
          piece.Nodes.push_back(cut);
          piece.Begin = CurveEnd::MeshBorder;
          piece.BeginEdge = edge;
        }
        inside = !inside;
      }
    }
    if (inside && branch.Closed && pieces.size() > firstPiece)
    {
      this->Prepend(piece, pieces[firstPiece]);
    }
    else if (inside)
    {
      piece.End = branch.End;
      if (branch.Closed)
      {
        piece.Begin = piece.End = CurveEnd::None;
        piece.Nodes.back() = piece.Nodes.front();
      }
      this->Keep(piece, pieces);
    }
  }

private:
  /** Unless it is so close to where the branch was cut that the order of both may be wrong. */
  void Append(SectionPiece& piece, const CurveNode& node)
  {
    const bool isFirst = piece.Nodes.size() == 1 && piece.Begin == CurveEnd::MeshBorder;
    const double least = isFirst ? ShortestInWidths : Rounding;
    if (piece.Nodes.empty() || this->Apart(piece.Nodes.back(), node) > least)
    {
      piece.Nodes.push_back(this->IsInDomain(node) ? node : this->Nearest(node.U, node.V));
    }
  }

  /** On its border, steps of the lattice may make it seem so. */
  bool IsInDomain(const CurveNode& node) const
  {
    return node.U >= this->Patch.FirstU() && node.U <= this->Patch.LastU() &&
      node.V >= this->Patch.FirstV() && node.V <= this->Patch.LastV();
  }

  CurveNode Nearest(double u, double v)
  {
    const CommonPoint common = OntoCloudAndPatch(this->Surface, this->Patch, u, v, this->Near);
    return { common.Point, common.U, common.V };
  }

  void Finish(SectionPiece& piece, const CurveNode& cut, const TrimmedDomain::Edge& edge,
    std::vector<SectionPiece>& pieces) const
  {
    while (piece.Nodes.size() > 1 && this->Apart(piece.Nodes.back(), cut) <= ShortestInWidths)
    {
      piece.Nodes.pop_back();
    }
    piece.Nodes.push_back(cut);
    piece.End = CurveEnd::MeshBorder;
    piece.EndEdge = edge;
    this->Keep(piece, pieces);
    piece = SectionPiece();
    piece.Face = this->Face;
  }

  void Keep(SectionPiece& piece, std::vector<SectionPiece>& pieces) const
  {
    pieces.push_back(std::move(piece));
  }

  /** The part of a loop before where it was followed from goes in front of the part after it. */
  void Prepend(const SectionPiece& before, SectionPiece& after) const
  {
    std::vector<CurveNode> nodes = before.Nodes;
    nodes.insert(nodes.end(), after.Nodes.begin() + 1, after.Nodes.end());
    after.Nodes = std::move(nodes);
    after.Begin = before.Begin;
    after.BeginEdge = before.BeginEdge;
  }

  double Apart(const CurveNode& a, const CurveNode& b) const
  {
    return Length(Difference(a.Point, b.Point)) / this->Surface.Width();
  }

  /** The point of the surface on an edge of the border, near to where a chord crosses it. */
  CurveNode OnBorder(const TrimmedDomain::Crossing& crossing)
  {
    const TrimmedDomain::Edge& edge = this->Domain.Border()[crossing.Edge];
    const double alongU = edge.To[0] - edge.From[0];
    const double alongV = edge.To[1] - edge.From[1];
    const auto at = [&](double t) {
      return Parameters{ edge.From[0] + t * alongU, edge.From[1] + t * alongV };
    };
    double t = crossing.AlongEdge;
    const Parameters start = at(t);
    const Real3 first = EvaluatePatch(this->Patch, start[0], start[1], 0).Point;
    for (int iteration = 0; iteration < 30; ++iteration)
    {
      const Parameters now = at(t);
      const PatchPoint p = EvaluatePatch(this->Patch, now[0], now[1], 1);
      const SurfaceValue f = this->Surface.EvaluateAt(p.Point, 1, this->Near);
      const Real3 tangent = PlusScaled(Scaled(p.Du, alongU), alongV, p.Dv);
      const double step = -f.Value / Dot(f.Gradient, tangent);
      const bool isLost =
        !f.IsNear || !std::isfinite(step) || Length(Difference(p.Point, first)) > this->Farthest;
      if (isLost)
      {
        break;
      }
      if (std::abs(f.Value) < 1e-15 * this->Surface.Width() ||
        std::abs(step) * Length(tangent) < 1e-14 * this->Surface.Width())
      {
        return { p.Point, now[0], now[1] };
      }
      t += step;
    }
    // The border runs along the curve, or is a pole: the nearest point of the curve.
    return this->Nearest(start[0], start[1]);
  }

  const MovingLeastSquares& Surface;
  const NURBSSurface& Patch;
  const TrimmedDomain& Domain;
  const std::int32_t Face;
  const double Farthest; ///< of a cut from where the chord was
  MovingLeastSquares::Neighbourhood Near;
};

/** Turn a piece to the other direction. */
void Reverse(SectionPiece& piece)
{
  std::reverse(piece.Nodes.begin(), piece.Nodes.end());
  std::swap(piece.Begin, piece.End);
  std::swap(piece.BeginEdge, piece.EndEdge);
}

} // namespace

FaceSection SectionOfFace(const FaceSectionRequest& request,
  const std::vector<std::int32_t>& triangles, Executor& executor, Monitor& monitor)
{
  FaceSection section;
  if (triangles.empty())
  {
    return section;
  }
  const DesignedSurface& designed = request.Designed;
  const MovingLeastSquares& surface = request.Surface;
  const std::int32_t face = designed.FaceId[static_cast<std::size_t>(triangles.front())];
  const NURBSSurface& patch = designed.Patches[static_cast<std::size_t>(face)];
  const TrimmedDomain domain(designed, triangles);
  const double cell = LargestCell * request.Spacing;
  const PatchQuadtree tree(
    patch, domain, surface.Samples(), { ReachInWidths * surface.Width(), cell }, executor, monitor);
  if (tree.NumberOfCells() == 0 || monitor.Aborted())
  {
    return section;
  }
  FaceBranches branches(request, patch, tree, executor);
  section.CoincidentArea = branches.CoincidentArea();
  Trimming trimming(surface, patch, domain, face, cell);
  for (const FaceBranches::Branch& branch : branches.Branches())
  {
    trimming.Cut(branch, section.Pieces);
  }
  if (domain.IsReversed())
  {
    for (SectionPiece& piece : section.Pieces)
    {
      Reverse(piece);
    }
  }
  return section;
}

} // namespace sb
