// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NURBSSection.h"

#include "ChordSteps.h"
#include "ClosestOnPatch.h"
#include "CommonPoint.h"
#include "PieceJoining.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace sb
{
namespace
{

constexpr std::size_t NodesInPart = 96; ///< that one thread steps along at a time
constexpr double LongestStep = 2.0; ///< in widths
constexpr double PointInWidths = 1e-4; ///< a curve that is not longer is none
constexpr double SameInWidths = 1e-6; ///< ends of pieces that are one point of a curve
constexpr double ShortestStep = 1e-3; ///< in widths
constexpr double TouchInSpacings = 0.1; ///< how near a face has to come to touch
constexpr double NextToInSpacings = 2.0; ///< what is nearer to a touch is not something else
constexpr int MostHalvings = 4; ///< of the cells of a face, where two branches are in one of them

/** A piece with as few nodes as the bound allows. */
struct SteppedPiece
{
  std::vector<CurveNode> Nodes;
  double ChordError = 0.0;
  double Residual = 0.0;
  bool IsTangential = false;
};

/** The curve that a patch and the surface have in common. */
class CommonCurve : public SteppedCurve
{
public:
  CommonCurve(const MovingLeastSquares& surface, const NURBSSurface& patch)
    : Surface(surface)
    , Patch(patch)
  {
  }

  double CurvatureAt(const CurveNode& node) override
  {
    const PatchPoint p = EvaluatePatch(this->Patch, node.U, node.V, 2);
    return Length(CurvatureOfCommonCurve(this->Surface.EvaluateAt(p.Point, 2, this->Near), p));
  }

  CurveNode Between(const CurveNode& a, const CurveNode& b, double t) override
  {
    const Real3 chord = Difference(b.Point, a.Point);
    const Real3 wanted = PlusScaled(a.Point, t, chord);
    double u = a.U + t * (b.U - a.U);
    double v = a.V + t * (b.V - a.V);
    const Real3 guess = EvaluatePatch(this->Patch, u, v, 0).Point;
    if (Length(Difference(guess, wanted)) > 0.25 * Length(chord))
    {
      // Around a pole, a straight line in u and v is none in space.
      const PlaceOnPatch place = ClosestOnPatchFrom(this->Patch, wanted, u, v);
      u = place.U;
      v = place.V;
    }
    const CommonPoint common = OntoCloudAndPatch(this->Surface, this->Patch, u, v, this->Near);
    return common.Found ? CurveNode{ common.Point, common.U, common.V } : a;
  }

  /** Take in how far a node is from either surface, and whether they touch there. */
  void Measure(const CurveNode& node, SteppedPiece& piece)
  {
    const PatchPoint p = EvaluatePatch(this->Patch, node.U, node.V, 1);
    const SurfaceValue f = this->Surface.EvaluateAt(node.Point, 1, this->Near);
    piece.Residual =
      std::max({ piece.Residual, std::abs(f.Value), Length(Difference(p.Point, node.Point)) });
    const Real3 normal = Cross(p.Du, p.Dv);
    const double size = Length(normal);
    piece.IsTangential = piece.IsTangential ||
      (size > 0.0 && SineBetween(f.Gradient, Scaled(normal, 1.0 / size)) < TangentialSine);
  }

private:
  const MovingLeastSquares& Surface;
  const NURBSSurface& Patch;
  MovingLeastSquares::Neighbourhood Near;
};

class PatchSectioning
{
public:
  PatchSectioning(const MovingLeastSquares& surface, const DesignedSurface& designed,
    const SectionRequest& request, Executor& executor, Monitor& monitor)
    : Surface(surface)
    , Designed(designed)
    , Request(request)
    , Threads(executor)
    , Watch(monitor)
    , Tolerance(surface, request.Spacing)
  {
  }

  NURBSSection Run()
  {
    this->ListTriangles();
    std::vector<std::size_t> faces(this->Triangles.size());
    std::iota(faces.begin(), faces.end(), std::size_t(0));
    for (int halvings = 0; halvings <= MostHalvings && !faces.empty(); ++halvings)
    {
      this->FindSections(faces, halvings);
      this->CollectPieces();
      this->Partner = JoinPieces(this->Surface, this->Designed, this->Pieces);
      this->StepAlongPieces();
      faces = this->FacesBeyondBound();
    }
    if (this->Watch.Aborted())
    {
      NURBSSection none;
      none.Aborted = true;
      return none;
    }
    this->AssembleCurves();
    this->CollectTouches();
    return std::move(this->Result);
  }

private:
  void ListTriangles()
  {
    this->Triangles.resize(this->Designed.Patches.size());
    this->Sections.resize(this->Designed.Patches.size());
    for (std::size_t i = 0; i < this->Designed.FaceId.size(); ++i)
    {
      const std::int32_t face = this->Designed.FaceId[i];
      if (face >= 0)
      {
        this->Triangles[static_cast<std::size_t>(face)].push_back(static_cast<std::int32_t>(i));
      }
    }
  }

  void FindSections(const std::vector<std::size_t>& faces, int halvings)
  {
    const FaceSectionRequest request{ this->Surface, this->Designed, this->Request.Spacing,
      this->Tolerance,
      std::max(this->Request.ChordError, TouchInSpacings * this->Request.Spacing) };
    for (std::size_t i = 0; i < faces.size() && !this->Watch.Aborted(); ++i)
    {
      this->Watch.Progress(0.7 * double(i) / double(faces.size()), "Faces");
      this->Sections[faces[i]] =
        SectionOfFace(request, this->Triangles[faces[i]], halvings, this->Threads, this->Watch);
    }
  }

  void CollectPieces()
  {
    this->Pieces.clear();
    this->Result.CoincidentArea = 0.0;
    for (const FaceSection& section : this->Sections)
    {
      this->Result.CoincidentArea += section.CoincidentArea;
      this->Pieces.insert(this->Pieces.end(), section.Pieces.begin(), section.Pieces.end());
    }
  }

  /** The faces of pieces that do not keep the bound on the chord error. */
  std::vector<std::size_t> FacesBeyondBound() const
  {
    std::vector<std::size_t> faces;
    for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      const std::size_t face = static_cast<std::size_t>(this->Pieces[piece].Face);
      const bool isBeyond = this->Stepped[piece].ChordError > this->Request.ChordError;
      if (isBeyond && (faces.empty() || faces.back() != face))
      {
        faces.push_back(face); // pieces are in the order of their faces
      }
    }
    return faces;
  }

  /** One touch at each place, the nearest, and none where a curve is: each face knows its own only.
   */
  void CollectTouches()
  {
    std::vector<SurfaceTouch> touches;
    for (const FaceSection& section : this->Sections)
    {
      touches.insert(touches.end(), section.Touches.begin(), section.Touches.end());
    }
    std::stable_sort(touches.begin(), touches.end(),
      [](const SurfaceTouch& a, const SurfaceTouch& b) { return a.Distance < b.Distance; });
    const double limit = NextToInSpacings * this->Request.Spacing;
    for (const SurfaceTouch& touch : touches)
    {
      const auto isNextTo = [&](const Real3& place) {
        return Length(Difference(place, touch.Place)) <= limit;
      };
      const bool isKnown = std::any_of(this->Result.Touches.begin(), this->Result.Touches.end(),
        [&](const SurfaceTouch& other) { return isNextTo(other.Place); });
      const bool isCurve =
        std::any_of(this->Pieces.begin(), this->Pieces.end(), [&](const SectionPiece& piece) {
          return std::any_of(piece.Nodes.begin(), piece.Nodes.end(),
            [&](const CurveNode& node) { return isNextTo(node.Point); });
        });
      if (!isKnown && !isCurve)
      {
        this->Result.Touches.push_back(touch);
      }
    }
  }

  /** A part of a piece: nodes, with the last one of the part before it first. */
  struct Part
  {
    std::size_t Piece;
    std::size_t Begin;
    std::size_t End;
    SteppedPiece Stepped;
  };

  void StepAlongPieces()
  {
    std::vector<Part> parts;
    for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      const std::size_t count = this->Pieces[piece].Nodes.size();
      for (std::size_t begin = 0; begin + 1 < count; begin += NodesInPart)
      {
        parts.push_back({ piece, begin, std::min(count, begin + NodesInPart + 1), {} });
      }
    }
    this->Watch.Progress(0.7, "Curves");
    this->Threads.For(
      static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end && !this->Watch.Aborted(); ++i)
        {
          this->StepAlongPart(parts[static_cast<std::size_t>(i)]);
        }
      });
    this->Stepped.assign(this->Pieces.size(), SteppedPiece());
    for (const Part& part : parts)
    {
      SteppedPiece& whole = this->Stepped[part.Piece];
      if (whole.Nodes.empty())
      {
        whole.Nodes.push_back(this->Pieces[part.Piece].Nodes.front());
      }
      whole.Nodes.insert(whole.Nodes.end(), part.Stepped.Nodes.begin(), part.Stepped.Nodes.end());
      whole.ChordError = std::max(whole.ChordError, part.Stepped.ChordError);
      whole.Residual = std::max(whole.Residual, part.Stepped.Residual);
      whole.IsTangential = whole.IsTangential || part.Stepped.IsTangential;
    }
  }

  void StepAlongPart(Part& part) const
  {
    const SectionPiece& piece = this->Pieces[part.Piece];
    CommonCurve curve(this->Surface, this->Designed.Patches[static_cast<std::size_t>(piece.Face)]);
    const std::vector<CurveNode> nodes(
      piece.Nodes.begin() + static_cast<std::ptrdiff_t>(part.Begin),
      piece.Nodes.begin() + static_cast<std::ptrdiff_t>(part.End));
    const double width = this->Surface.Width();
    // A loop takes three steps at least.
    const std::size_t fewest = piece.Begin == CurveEnd::None ? 3 : 1;
    part.Stepped.ChordError =
      StepAlong(nodes, { this->Request.ChordError, LongestStep * width, ShortestStep * width },
        fewest, curve, part.Stepped.Nodes);
    curve.Measure(nodes.front(), part.Stepped);
    for (const CurveNode& node : part.Stepped.Nodes)
    {
      curve.Measure(node, part.Stepped);
    }
  }

  /** Open curves first, then loops; each begins with the first of its pieces. */
  void AssembleCurves()
  {
    std::vector<std::uint8_t> done(this->Pieces.size(), 0);
    for (const bool loops : { false, true })
    {
      for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
      {
        const PieceEnd begin = static_cast<PieceEnd>(2 * piece);
        const bool isOpen = this->Pieces[piece].Begin != CurveEnd::None;
        const bool startsHere = this->Partner[2 * piece] < 0 && isOpen;
        const bool endsHere = this->Partner[2 * piece + 1] < 0 && isOpen;
        if (!done[piece] && (loops || startsHere || endsHere))
        {
          this->AddCurve(loops || startsHere ? begin : begin + 1, done);
        }
      }
    }
  }

  /** Follow the pieces from an end of one. */
  void AddCurve(PieceEnd from, std::vector<std::uint8_t>& done)
  {
    NURBSCurve curve;
    const SectionPiece& first = this->Pieces[static_cast<std::size_t>(from / 2)];
    curve.Ends[0] = from % 2 == 0 ? first.Begin : first.End;
    PieceEnd at = from;
    while (at >= 0 && !done[static_cast<std::size_t>(at / 2)])
    {
      const std::size_t piece = static_cast<std::size_t>(at / 2);
      done[piece] = 1;
      this->AddPiece(piece, at % 2 == 1, curve);
      curve.Ends[1] = at % 2 == 0 ? this->Pieces[piece].End : this->Pieces[piece].Begin;
      at = this->Partner[static_cast<std::size_t>(at ^ 1)];
    }
    curve.Closed = at == from || first.Begin == CurveEnd::None;
    if (curve.Closed)
    {
      curve.Ends.fill(CurveEnd::None);
      this->CloseUp(curve);
    }
    if (this->IsCurve(curve))
    {
      this->Result.Curves.push_back(std::move(curve));
    }
  }

  bool AreOne(const Real3& a, const Real3& b) const
  {
    return Length(Difference(a, b)) <= SameInWidths * this->Surface.Width();
  }

  /** Let a loop end in its first point. */
  void CloseUp(NURBSCurve& curve) const
  {
    if (curve.Points.size() > 1 && curve.Points.back() != curve.Points.front() &&
      this->AreOne(curve.Points.back(), curve.Points.front()))
    {
      curve.Points.pop_back();
      curve.UV.pop_back();
      curve.FaceId.pop_back();
    }
    if (curve.Points.back() != curve.Points.front())
    {
      curve.Points.push_back(curve.Points.front());
      curve.UV.push_back(curve.UV.front());
      curve.FaceId.push_back(curve.FaceId.front());
    }
  }

  /** Where a curve passes a pole of a patch, pieces are left over that are points. */
  bool IsCurve(const NURBSCurve& curve) const
  {
    const double least = PointInWidths * this->Surface.Width();
    return std::any_of(curve.Points.begin(), curve.Points.end(),
      [&](const Real3& x) { return Length(Difference(x, curve.Points.front())) > least; });
  }

  void AddPiece(std::size_t piece, bool backwards, NURBSCurve& curve) const
  {
    const SteppedPiece& stepped = this->Stepped[piece];
    const std::size_t count = stepped.Nodes.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      const CurveNode& node = stepped.Nodes[backwards ? count - 1 - k : k];
      const bool isSame = !curve.Points.empty() &&
        (k == 0 ? this->AreOne(curve.Points.back(), node.Point)
                : curve.Points.back() == node.Point);
      if (isSame)
      {
        continue; // where the piece before it ended, or all of a piece that is a point
      }
      curve.Points.push_back(node.Point);
      curve.UV.push_back({ node.U, node.V });
      curve.FaceId.push_back(this->Pieces[piece].Face);
    }
    curve.LargestChordError = std::max(curve.LargestChordError, stepped.ChordError);
    curve.LargestResidual = std::max(curve.LargestResidual, stepped.Residual);
    curve.IsTangential = curve.IsTangential || stepped.IsTangential;
  }

  const MovingLeastSquares& Surface;
  const DesignedSurface& Designed;
  const SectionRequest Request;
  Executor& Threads;
  Monitor& Watch;
  CoincidenceTolerance Tolerance;
  std::vector<std::vector<std::int32_t>> Triangles; ///< of each face
  std::vector<FaceSection> Sections; ///< of each face
  std::vector<SectionPiece> Pieces;
  std::vector<PieceEnd> Partner;
  std::vector<SteppedPiece> Stepped;
  NURBSSection Result;
};

} // namespace

NURBSSection IntersectPatches(const MovingLeastSquares& surface, const DesignedSurface& designed,
  const SectionRequest& request, Executor& executor, Monitor& monitor)
{
  return PatchSectioning(surface, designed, request, executor, monitor).Run();
}

} // namespace sb
