// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSection.h"

#include "CommonPoint.h"
#include "FaceBranches.h"
#include "PatchQuadtree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sb
{
namespace
{

constexpr double LargestCell = 1.4; ///< in spacings: its diagonal is shorter than two
constexpr double LargestInWidths = 2.0 / 3.0; ///< so that the surface is known at all its corners
constexpr double ReachInWidths = 1.0; ///< the surface is not farther from all samples
constexpr double Rounding = 1e-12; ///< in widths: nodes that are not farther apart are one
constexpr double ShortestInWidths = 0.02; ///< from a cut to the next point of a branch

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

  void Cut(const FaceBranch& branch, std::vector<SectionPiece>& pieces)
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
    bool wasLast = false;
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
      if (wasLast)
      {
        return { p.Point, now[0], now[1] };
      }
      wasLast = std::abs(f.Value) <= NegligibleValue(p.Point, this->Surface.Width());
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
  const std::vector<std::int32_t>& triangles, int halvings, Executor& executor, Monitor& monitor)
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
  const double cell =
    std::min(LargestCell * request.Spacing, LargestInWidths * surface.NarrowWidth());
  PatchQuadtree tree(patch, domain, surface.Samples(),
    { ReachInWidths * surface.LargestWidth(), cell }, executor, monitor);
  if (tree.NumberOfCells() == 0 || monitor.Aborted())
  {
    return section;
  }
  const BranchRequest wanted{ surface, patch, domain, tree, request.Tolerance,
    request.NearestTouch };
  FaceBranches found = FindBranches(wanted, executor, monitor);
  section.Touches = std::move(found.Touches);
  for (int halving = 0; halving < halvings && !monitor.Aborted(); ++halving)
  {
    tree.Halve(found.IsCrossed);
    found = FindBranches(wanted, executor, monitor);
  }
  section.CoincidentArea = found.CoincidentArea;
  Trimming trimming(surface, patch, domain, face, cell);
  for (const FaceBranch& branch : found.Branches)
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
