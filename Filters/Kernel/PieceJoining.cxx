// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceJoining.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace sb
{
namespace
{

constexpr double GapFactor = 8.0; ///< ends are not farther apart than so often the facets' error
constexpr double LeastGap = 1e-4; ///< in widths: closer ends belong together in any case
constexpr double LargestGap = 1.0; ///< in widths
constexpr double ShortestInWidths = 0.02; ///< from a joint to the next node
constexpr double SameInWidths = 1e-10;

class Joining
{
public:
  Joining(const MovingLeastSquares& surface, const DesignedSurface& designed,
    std::vector<SectionPiece>& pieces)
    : Surface(surface)
    , Designed(designed)
    , Pieces(pieces)
    , Partner(2 * pieces.size(), -1)
  {
  }

  std::vector<PieceEnd> Run()
  {
    this->ListEnds();
    this->ListPairs();
    for (const Pair& pair : this->Pairs)
    {
      PieceEnd& first = this->Partner[static_cast<std::size_t>(pair.First)];
      PieceEnd& second = this->Partner[static_cast<std::size_t>(pair.Second)];
      if (first < 0 && second < 0)
      {
        first = pair.Second;
        second = pair.First;
        this->Meet(pair.First, pair.Second);
      }
    }
    return std::move(this->Partner);
  }

private:
  struct End
  {
    PieceEnd Number;
    double Gap; ///< to the facets' edge
  };
  struct Pair
  {
    bool Turns; ///< both pieces begin there, or end
    double Apart;
    PieceEnd First;
    PieceEnd Second;
  };

  SectionPiece& PieceOf(PieceEnd end) const
  {
    return this->Pieces[static_cast<std::size_t>(end / 2)];
  }
  CurveNode& NodeOf(PieceEnd end) const
  {
    std::vector<CurveNode>& nodes = this->PieceOf(end).Nodes;
    return end % 2 == 0 ? nodes.front() : nodes.back();
  }
  const TrimmedDomain::Edge& EdgeOf(PieceEnd end) const
  {
    const SectionPiece& piece = this->PieceOf(end);
    return end % 2 == 0 ? piece.BeginEdge : piece.EndEdge;
  }
  const NURBSSurface& PatchOf(PieceEnd end) const
  {
    return this->Designed.Patches[static_cast<std::size_t>(this->PieceOf(end).Face)];
  }
  Real3 PointOf(std::int32_t point) const
  {
    const double* x = this->Designed.Points.data() + 3 * static_cast<std::size_t>(point);
    return { x[0], x[1], x[2] };
  }

  /** Ends at borders, sorted by their first coordinate. */
  void ListEnds()
  {
    for (PieceEnd end = 0; end < static_cast<PieceEnd>(this->Partner.size()); ++end)
    {
      const SectionPiece& piece = this->PieceOf(end);
      if ((end % 2 == 0 ? piece.Begin : piece.End) != CurveEnd::MeshBorder)
      {
        continue;
      }
      const Real3 from = this->PointOf(this->EdgeOf(end).FromPoint);
      const Real3 along = Difference(this->PointOf(this->EdgeOf(end).ToPoint), from);
      const Real3 away = Difference(this->NodeOf(end).Point, from);
      const double squared = Dot(along, along);
      const double t = squared > 0.0 ? std::clamp(Dot(away, along) / squared, 0.0, 1.0) : 0.0;
      this->Ends.push_back({ end, Length(PlusScaled(away, -t, along)) });
    }
    std::sort(this->Ends.begin(), this->Ends.end(), [this](const End& a, const End& b) {
      return std::make_pair(this->NodeOf(a.Number).Point, a.Number) <
        std::make_pair(this->NodeOf(b.Number).Point, b.Number);
    });
  }

  bool EdgesTouch(PieceEnd a, PieceEnd b) const
  {
    const Real3 corners[2] = { this->PointOf(this->EdgeOf(a).FromPoint),
      this->PointOf(this->EdgeOf(a).ToPoint) };
    const Real3 others[2] = { this->PointOf(this->EdgeOf(b).FromPoint),
      this->PointOf(this->EdgeOf(b).ToPoint) };
    return corners[0] == others[0] || corners[0] == others[1] || corners[1] == others[0] ||
      corners[1] == others[1];
  }

  /** All that may belong together, the best first. */
  void ListPairs()
  {
    const double width = this->Surface.Width();
    for (std::size_t i = 0; i < this->Ends.size(); ++i)
    {
      const Real3& a = this->NodeOf(this->Ends[i].Number).Point;
      for (std::size_t j = i + 1; j < this->Ends.size(); ++j)
      {
        const Real3& b = this->NodeOf(this->Ends[j].Number).Point;
        if (b[0] - a[0] > LargestGap * width)
        {
          break;
        }
        const double apart = Length(Difference(a, b));
        const double most = std::clamp(GapFactor * (this->Ends[i].Gap + this->Ends[j].Gap),
          LeastGap * width, LargestGap * width);
        const bool isSame = apart <= LeastGap * width;
        if (apart <= most &&
          (isSame || this->EdgesTouch(this->Ends[i].Number, this->Ends[j].Number)))
        {
          const auto [first, second] = std::minmax(this->Ends[i].Number, this->Ends[j].Number);
          this->Pairs.push_back({ first % 2 == second % 2, apart, first, second });
        }
      }
    }
    std::sort(this->Pairs.begin(), this->Pairs.end(), [](const Pair& a, const Pair& b) {
      return std::tie(a.Turns, a.Apart, a.First, a.Second) <
        std::tie(b.Turns, b.Apart, b.First, b.Second);
    });
  }

  /** Let both end in one point, if there is one. */
  void Meet(PieceEnd a, PieceEnd b)
  {
    CurveNode first = this->NodeOf(a);
    CurveNode second = this->NodeOf(b);
    const double apart = Length(Difference(first.Point, second.Point));
    if (&this->PatchOf(a) != &this->PatchOf(b) && this->ToCorner(a, b, first, second))
    {
      this->MoveEnd(a, first);
      this->MoveEnd(b, second);
    }
    else if (apart <= SameInWidths * this->Surface.Width())
    {
      this->NodeOf(b).Point = this->NodeOf(a).Point;
    }
  }

  /** Newton's method for S_a = S_b and f(S_a) = 0. */
  bool ToCorner(PieceEnd a, PieceEnd b, CurveNode& first, CurveNode& second)
  {
    const double width = this->Surface.Width();
    const Real3 start = first.Point;
    const double farthest = 4.0 * Length(Difference(first.Point, second.Point)) + 1e-6 * width;
    MovingLeastSquares::Neighbourhood near;
    for (int iteration = 0; iteration < 20; ++iteration)
    {
      const PatchPoint p = EvaluatePatch(this->PatchOf(a), first.U, first.V, 1);
      const PatchPoint q = EvaluatePatch(this->PatchOf(b), second.U, second.V, 1);
      const SurfaceValue f = this->Surface.EvaluateAt(p.Point, 1, near);
      const Real3 apart = Difference(q.Point, p.Point);
      if (!f.IsNear || Length(Difference(p.Point, start)) > farthest)
      {
        return false;
      }
      first.Point = second.Point = p.Point;
      const double rounding = 4e-16 * Length(p.Point);
      if (std::max(std::abs(f.Value), Length(apart)) <= 1e-14 * width + rounding)
      {
        return true;
      }
      if (!Step(p, q, f, apart, first, second))
      {
        return false;
      }
    }
    return false;
  }

  /** The point moves in the tangent plane of a so that it comes to that of b and to f = 0. */
  static bool Step(const PatchPoint& p, const PatchPoint& q, const SurfaceValue& f,
    const Real3& apart, CurveNode& first, CurveNode& second)
  {
    const Real3 n = Cross(p.Du, p.Dv);
    const Real3 m = Cross(q.Du, q.Dv);
    const double nn = Dot(n, n);
    const double mm = Dot(m, m);
    // The three planes n.x = 0, m.x = m.apart, gradient.x = -f have one point in common.
    const Real3 mg = Cross(m, f.Gradient);
    const double volume = Dot(n, mg);
    if (!(std::abs(volume) > 1e-3 * std::sqrt(nn * mm * Dot(f.Gradient, f.Gradient))))
    {
      return false;
    }
    const Real3 move = Scaled(
      PlusScaled(Scaled(Cross(f.Gradient, n), Dot(m, apart)), -f.Value, Cross(n, m)), 1.0 / volume);
    first.U += Dot(Cross(move, p.Dv), n) / nn;
    first.V += Dot(Cross(p.Du, move), n) / nn;
    const Real3 other = Difference(move, apart);
    second.U += Dot(Cross(other, q.Dv), m) / mm;
    second.V += Dot(Cross(q.Du, other), m) / mm;
    return true;
  }

  /** Give a piece another end; nodes that it has left behind go. */
  void MoveEnd(PieceEnd end, const CurveNode& node)
  {
    std::vector<CurveNode>& nodes = this->PieceOf(end).Nodes;
    const bool isFront = end % 2 == 0;
    if (isFront)
    {
      std::reverse(nodes.begin(), nodes.end());
    }
    nodes.pop_back();
    while (nodes.size() > 1)
    {
      const Real3 rest = Difference(node.Point, nodes.back().Point);
      const Real3 before = Difference(nodes.back().Point, nodes[nodes.size() - 2].Point);
      if (Length(rest) > ShortestInWidths * this->Surface.Width() && Dot(rest, before) > 0.0)
      {
        break;
      }
      nodes.pop_back();
    }
    nodes.push_back(node);
    if (isFront)
    {
      std::reverse(nodes.begin(), nodes.end());
    }
  }

  const MovingLeastSquares& Surface;
  const DesignedSurface& Designed;
  std::vector<SectionPiece>& Pieces;
  std::vector<PieceEnd> Partner;
  std::vector<End> Ends;
  std::vector<Pair> Pairs;
};

} // namespace

std::vector<PieceEnd> JoinPieces(const MovingLeastSquares& surface, const DesignedSurface& designed,
  std::vector<SectionPiece>& pieces)
{
  return Joining(surface, designed, pieces).Run();
}

} // namespace sb
