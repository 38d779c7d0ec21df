// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceRefinement.h"

#include "EdgeFlipping.h"
#include "NearSamples.h"
#include "ParallelSort.h"
#include "PatchMiddle.h"
#include "PlaceTable.h"
#include "TriangleCutting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 256;
constexpr int MostRounds = 120; ///< two for half the length
constexpr std::int32_t None = PlaceTable::None;

constexpr double FinestCut = 0x1p-46; ///< in largest coordinates: where middles still are such

/** Far away from the origin doubles are too sparse to cut edges finely; then they stay longer. */
RefinementRequest Feasible(RefinementRequest request, const std::vector<double>& points)
{
  double largest = 0.0;
  for (const double coordinate : points)
  {
    largest = std::max(largest, std::abs(coordinate));
  }
  request.LongestEdge = std::max(request.LongestEdge, FinestCut * largest);
  request.ChordError = std::max(request.ChordError, FinestCut * largest);
  return request;
}

/** A triangle that is, or may have to be, cut. */
struct Piece
{
  std::array<std::int32_t, 3> Points;
  std::int32_t Original;
  bool IsNear;
  std::array<bool, 3> IsOriginal{ true, true, true }; ///< edges that are part of one of the input
};

/** All rounds and what they share. */
class Refining
{
public:
  Refining(const DesignedSurface& surface, const PointTree& samples,
    const RefinementRequest& request, Executor& executor, Monitor& monitor)
    : Input(surface)
    , Samples(samples)
    , Request(Feasible(request, surface.Points))
    , Threads(executor)
    , Watch(monitor)
    , Points(surface.Points)
    , UV(surface.UV)
  {
  }

  RefinedSurface Run()
  {
    this->FindNear();
    this->NumberPlaces();
    this->ListPieces();
    for (int round = 0; round < MostRounds && !this->Watch.Aborted(); ++round)
    {
      if (!this->MarkEdges() || !this->MakePoints())
      {
        break;
      }
      this->CutPieces();
    }
    RefinedSurface refined;
    refined.Status = this->IsTooLarge ? RefinementStatus::TooLarge
      : this->Watch.Aborted()         ? RefinementStatus::Aborted
                                      : RefinementStatus::Ok;
    if (refined.Status == RefinementStatus::Ok)
    {
      this->Assemble(refined);
    }
    return refined;
  }

private:
  Real3 Point(std::int32_t i) const
  {
    const double* x = this->Points.data() + 3 * static_cast<std::size_t>(i);
    return { x[0], x[1], x[2] };
  }

  std::array<std::int32_t, 3> Corners(std::size_t triangle) const
  {
    const std::int32_t* p = this->Input.Triangles.data() + 3 * triangle;
    return { p[0], p[1], p[2] };
  }

  std::size_t NumberOfTriangles() const { return this->Input.Triangles.size() / 3; }

  PlaceOnPatch Place(std::int32_t i) const
  {
    const double* uv = this->UV.data() + 2 * static_cast<std::size_t>(i);
    return { uv[0], uv[1], this->Point(i), 0.0 };
  }

  const NURBSSurface& PatchOf(std::int32_t original) const
  {
    return this->Input
      .Patches[static_cast<std::size_t>(this->Input.FaceId[static_cast<std::size_t>(original)])];
  }

  /** An edge on its patch, from the lower point to the higher, so that it is the same from both
   * sides. */
  PatchEdge EdgeOnPatch(std::int32_t original, std::int32_t a, std::int32_t b) const
  {
    const auto ends = std::minmax(a, b);
    return { &this->PatchOf(original), this->Place(ends.first), this->Place(ends.second) };
  }

  double EdgeLength(std::int32_t a, std::int32_t b) const
  {
    return Length(Difference(this->Point(a), this->Point(b)));
  }

  double LongestEdge(const std::array<std::int32_t, 3>& p) const
  {
    return std::max(
      { this->EdgeLength(p[0], p[1]), this->EdgeLength(p[1], p[2]), this->EdgeLength(p[2], p[0]) });
  }

  /** How far the middle of an edge is from the patch. */
  double ErrorOfEdge(std::int32_t original, std::int32_t a, std::int32_t b) const
  {
    const Real3 chord = PlusScaled(this->Point(a), 0.5, Difference(this->Point(b), this->Point(a)));
    return Length(Difference(MiddleOnPatch(this->EdgeOnPatch(original, a, b)).Point, chord));
  }

  /** How far the middle of a triangle is from the patch; nothing is known of it at a pole. */
  double ErrorOfMiddle(std::int32_t original, const std::array<std::int32_t, 3>& p) const
  {
    Real3 middle{};
    double u = 0.0;
    double v = 0.0;
    for (const std::int32_t point : p)
    {
      const PlaceOnPatch place = this->Place(point);
      middle = PlusScaled(middle, 1.0 / 3.0, place.Point);
      u += place.U / 3.0;
      v += place.V / 3.0;
    }
    const Real3 onPatch = EvaluatePatch(this->PatchOf(original), u, v, 0).Point;
    const double error = Length(Difference(onPatch, middle));
    return error < 0.5 * this->LongestEdge(p) ? error : 0.0;
  }

  bool IsNear(std::int32_t original, const std::array<std::int32_t, 3>& p) const
  {
    double distance = this->Request.Near;
    if (this->Input.HasPatches())
    {
      // The part of the patch that the triangle stands for, twice as far off as at its middles.
      const double most = distance + 2.0 * this->LongestEdge(p);
      if (!IsNearSamples(
            this->Samples, this->Point(p[0]), this->Point(p[1]), this->Point(p[2]), most))
      {
        return false;
      }
      distance += 2.0 *
        std::max({ this->ErrorOfMiddle(original, p), this->ErrorOfEdge(original, p[0], p[1]),
          this->ErrorOfEdge(original, p[1], p[2]), this->ErrorOfEdge(original, p[2], p[0]) });
    }
    return IsNearSamples(
      this->Samples, this->Point(p[0]), this->Point(p[1]), this->Point(p[2]), distance);
  }

  void FindNear()
  {
    this->Near.assign(this->NumberOfTriangles(), 0);
    this->Threads.For(static_cast<std::int64_t>(this->NumberOfTriangles()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin, last = this->Watch.Aborted() ? begin : end; t < last; ++t)
        {
          this->Near[static_cast<std::size_t>(t)] =
            this->IsNear(static_cast<std::int32_t>(t), this->Corners(static_cast<std::size_t>(t)))
            ? 1
            : 0;
        }
      });
  }

  /** Whether a triangle of the input is cut for its own sake. */
  bool IsSeed(std::size_t triangle) const
  {
    return this->Near[triangle] != 0 &&
      (this->Input.HasPatches() ||
        this->LongestEdge(this->Corners(triangle)) > this->Request.LongestEdge);
  }

  /** Number the places of all triangles that are cut for their own sake, and find their points. */
  void NumberPlaces()
  {
    const std::size_t count = this->Points.size() / 3;
    std::vector<std::int32_t> needed;
    std::vector<std::uint8_t> isNeeded(count, 0);
    for (std::size_t t = 0; t < this->NumberOfTriangles(); ++t)
    {
      for (const std::int32_t point : this->IsSeed(t) ? this->Corners(t) : NoCorners)
      {
        if (point != None && !isNeeded[static_cast<std::size_t>(point)])
        {
          isNeeded[static_cast<std::size_t>(point)] = 1;
          needed.push_back(point);
        }
      }
    }
    PlaceTable table(needed.size());
    for (const std::int32_t point : needed)
    {
      table.Add(this->Input.Points.data() + 3 * static_cast<std::size_t>(point));
    }
    this->NumberOfPlaces = table.Size();
    this->PlaceIds.assign(count, None);
    if (this->NumberOfPlaces > 0)
    {
      this->Threads.For(
        static_cast<std::int64_t>(count), 64 * Grain, [&](std::int64_t begin, std::int64_t end) {
          for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
               ++i)
          {
            this->PlaceIds[i] = table.Find(this->Input.Points.data() + 3 * i);
          }
        });
    }
  }

  std::int32_t PlaceId(std::int32_t point) const
  {
    return this->PlaceIds[static_cast<std::size_t>(point)];
  }

  /** What is cut, and what has an edge in common with it. */
  void ListPieces()
  {
    this->IsPiece.assign(this->NumberOfTriangles(), 0);
    for (std::size_t t = 0; t < this->NumberOfTriangles(); ++t)
    {
      const std::array<std::int32_t, 3> p = this->Corners(t);
      const int known = (this->PlaceId(p[0]) != None) + (this->PlaceId(p[1]) != None) +
        (this->PlaceId(p[2]) != None);
      if (known > 1)
      {
        this->IsPiece[t] = 1;
        this->Pieces.push_back({ p, static_cast<std::int32_t>(t), this->Near[t] != 0 });
      }
    }
  }

  /** Which edges of a piece it wants halved, as bits: the longest, and those that are too far from
   * the patch. */
  unsigned WantedEdges(const Piece& piece) const
  {
    if (!piece.IsNear)
    {
      return 0;
    }
    const auto& p = piece.Points;
    const unsigned longest = this->LongestEdgeToCut(piece);
    if (longest != 0 || !this->Input.HasPatches())
    {
      return longest;
    }
    unsigned wanted = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const bool isOff =
        this->ErrorOfEdge(piece.Original, p[k], p[(k + 1) % 3]) > this->Request.ChordError;
      wanted |= isOff ? 1u << k : 0u;
    }
    return wanted == 0 && this->ErrorOfMiddle(piece.Original, p) > this->Request.ChordError
      ? 7u
      : wanted;
  }

  /** The longest edge of those that are too long, as a bit. Of edges of about one length it is one
   * of the input's: a slender triangle is cut across, and its diagonals are flipped to that. */
  unsigned LongestEdgeToCut(const Piece& piece) const
  {
    constexpr double preference = 1.2;
    unsigned found = 0;
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double length = this->EdgeLength(piece.Points[k], piece.Points[(k + 1) % 3]);
      const double rank = piece.IsOriginal[k] ? preference * length : length;
      if (length > this->Request.LongestEdge && rank > longest)
      {
        found = 1u << k;
        longest = rank;
      }
    }
    return found;
  }

  /** List the edges to be halved, by the numbers of their places; returns whether there are any. */
  bool MarkEdges()
  {
    std::vector<std::uint8_t> wanted(this->Pieces.size(), 0);
    this->ForPieces([&](std::size_t i) {
      wanted[i] = static_cast<std::uint8_t>(this->WantedEdges(this->Pieces[i]));
    });
    this->Marked.clear();
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::int32_t a = this->PlaceId(this->Pieces[i].Points[k]);
        const std::int32_t b = this->PlaceId(this->Pieces[i].Points[(k + 1) % 3]);
        if ((wanted[i] >> k & 1) != 0 && a != b)
        {
          this->Marked.push_back(PairOfPlaces(a, b));
        }
      }
    }
    ParallelSortUnique(this->Marked, this->Threads);
    return !this->Marked.empty();
  }

  template <class Body>
  void ForPieces(const Body& body)
  {
    this->Threads.For(static_cast<std::int64_t>(this->Pieces.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          body(static_cast<std::size_t>(i));
        }
      });
  }

  /** One use of a marked edge by points of one face. */
  struct Use
  {
    std::uint64_t Points; ///< the pair
    std::int32_t Mark;
    std::int32_t Face; ///< of patches; else 0
    std::int32_t Original;

    bool operator<(const Use& other) const
    {
      return this->Mark != other.Mark ? this->Mark < other.Mark
        : this->Face != other.Face    ? this->Face < other.Face
                                      : this->Points < other.Points;
    }
    bool IsSame(const Use& other) const
    {
      return this->Mark == other.Mark && this->Points == other.Points;
    }
  };

  std::int32_t MarkOf(std::int32_t a, std::int32_t b) const
  {
    const std::int32_t first = this->PlaceId(a);
    const std::int32_t second = this->PlaceId(b);
    if (first == None || second == None || !this->IsEnd[static_cast<std::size_t>(first)] ||
      !this->IsEnd[static_cast<std::size_t>(second)])
    {
      return None;
    }
    const std::uint64_t pair = PairOfPlaces(first, second);
    const auto found = std::lower_bound(this->Marked.begin(), this->Marked.end(), pair);
    return found != this->Marked.end() && *found == pair
      ? static_cast<std::int32_t>(found - this->Marked.begin())
      : None;
  }

  /** A point for each use of each marked edge, all of an edge at one place. */
  bool MakePoints()
  {
    this->IsEnd.assign(static_cast<std::size_t>(this->NumberOfPlaces), 0);
    for (const std::uint64_t pair : this->Marked)
    {
      this->IsEnd[static_cast<std::size_t>(LowerPlace(pair))] = 1;
      this->IsEnd[static_cast<std::size_t>(UpperPlace(pair))] = 1;
    }
    this->MarksOfPieces.resize(this->Pieces.size());
    this->ForPieces([&](std::size_t i) {
      const auto& p = this->Pieces[i].Points;
      this->MarksOfPieces[i] = { this->MarkOf(p[0], p[1]), this->MarkOf(p[1], p[2]),
        this->MarkOf(p[2], p[0]) };
    });
    this->ListUses();
    const std::size_t count = this->Points.size() / 3;
    constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
    if (count + this->Uses.size() > most || 4 * this->Pieces.size() > most)
    {
      this->IsTooLarge = true;
      return false;
    }
    this->FirstNewPoint = static_cast<std::int32_t>(count);
    this->Points.resize(3 * (count + this->Uses.size()));
    this->UV.resize(this->Input.HasPatches() ? 2 * (count + this->Uses.size()) : 0);
    this->PlaceIds.resize(count + this->Uses.size());
    this->PlacePoints();
    this->NumberOfPlaces += static_cast<std::int32_t>(this->Marked.size());
    return true;
  }

  void ListUses()
  {
    this->Uses.clear();
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      const Piece& piece = this->Pieces[i];
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (this->MarksOfPieces[i][k] != None)
        {
          this->Uses.push_back({ PairOfPlaces(piece.Points[k], piece.Points[(k + 1) % 3]),
            this->MarksOfPieces[i][k], this->FaceOf(piece.Original), piece.Original });
        }
      }
    }
    std::stable_sort(this->Uses.begin(), this->Uses.end());
    this->Uses.erase(std::unique(this->Uses.begin(), this->Uses.end(),
                       [](const Use& a, const Use& b) { return a.IsSame(b); }),
      this->Uses.end());
    this->FirstUses.assign(this->Marked.size() + 1, 0);
    for (const Use& use : this->Uses)
    {
      ++this->FirstUses[static_cast<std::size_t>(use.Mark) + 1];
    }
    for (std::size_t mark = 0; mark < this->Marked.size(); ++mark)
    {
      this->FirstUses[mark + 1] += this->FirstUses[mark];
    }
  }

  std::int32_t FaceOf(std::int32_t original) const
  {
    return this->Input.HasPatches() ? this->Input.FaceId[static_cast<std::size_t>(original)] : 0;
  }

  void PlacePoints()
  {
    this->Threads.For(static_cast<std::int64_t>(this->Marked.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t mark = static_cast<std::size_t>(begin);
             mark < static_cast<std::size_t>(end); ++mark)
        {
          this->PlaceMark(mark);
        }
      });
  }

  void PlaceMark(std::size_t mark)
  {
    const std::size_t first = static_cast<std::size_t>(this->FirstUses[mark]);
    const std::size_t last = static_cast<std::size_t>(this->FirstUses[mark + 1]);
    Real3 point{};
    if (this->Input.HasPatches())
    {
      point = this->PlaceOnPatches(first, last);
    }
    else
    {
      const Real3 a = this->Point(LowerPlace(this->Uses[first].Points));
      const Real3 b = this->Point(UpperPlace(this->Uses[first].Points));
      point = { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) };
    }
    for (std::size_t use = first; use < last; ++use)
    {
      const std::size_t id = static_cast<std::size_t>(this->FirstNewPoint) + use;
      std::copy_n(point.data(), 3, this->Points.data() + 3 * id);
      this->PlaceIds[id] = this->NumberOfPlaces + static_cast<std::int32_t>(mark);
    }
  }

  /** The common point of all uses of an edge; their u and v are stored. */
  Real3 PlaceOnPatches(std::size_t first, std::size_t last)
  {
    const auto edgeOf = [&](std::size_t use) {
      return this->EdgeOnPatch(this->Uses[use].Original, LowerPlace(this->Uses[use].Points),
        UpperPlace(this->Uses[use].Points));
    };
    const auto store = [&](std::size_t use, const PlaceOnPatch& place) {
      double* uv = this->UV.data() + 2 * (static_cast<std::size_t>(this->FirstNewPoint) + use);
      uv[0] = place.U;
      uv[1] = place.V;
    };
    if (last - first == 1)
    {
      const PlaceOnPatch place = MiddleOnPatch(edgeOf(first));
      store(first, place);
      return place.Point;
    }
    std::vector<PatchEdge> edges;
    std::vector<PlaceOnPatch> places;
    for (std::size_t use = first; use < last; ++use)
    {
      edges.push_back(edgeOf(use));
    }
    const Real3 point = CommonMiddle(edges, places);
    for (std::size_t use = first; use < last; ++use)
    {
      store(use, places[use - first]);
    }
    return point;
  }

  /** The point that a piece has in the middle of an edge, or None. */
  std::int32_t MiddleOf(std::size_t piece, std::size_t k) const
  {
    const std::int32_t mark = this->MarksOfPieces[piece][k];
    if (mark == None)
    {
      return None;
    }
    const auto& p = this->Pieces[piece].Points;
    const Use wanted{ PairOfPlaces(p[k], p[(k + 1) % 3]), mark,
      this->FaceOf(this->Pieces[piece].Original), None };
    const auto found = std::lower_bound(this->Uses.begin() + this->FirstUses[std::size_t(mark)],
      this->Uses.begin() + this->FirstUses[std::size_t(mark) + 1], wanted);
    return this->FirstNewPoint + static_cast<std::int32_t>(found - this->Uses.begin());
  }

  void CutPieces()
  {
    const std::size_t before = this->Pieces.size();
    std::vector<std::uint8_t> isNew(before, 0);
    for (std::size_t i = 0; i < before; ++i)
    {
      const std::array<std::int32_t, 3> middles{ this->MiddleOf(i, 0), this->MiddleOf(i, 1),
        this->MiddleOf(i, 2) };
      if (middles != NoCorners)
      {
        isNew[i] = 1;
        this->Cut(i, middles);
      }
    }
    isNew.resize(this->Pieces.size(), 1);
    this->FlipNewEdges(isNew);
    this->ForPieces([&](std::size_t i) {
      Piece& piece = this->Pieces[i];
      piece.IsNear = piece.IsNear && (!isNew[i] || this->IsNear(piece.Original, piece.Points));
    });
  }

  void Cut(std::size_t i, const std::array<std::int32_t, 3>& middles)
  {
    const Piece piece = this->Pieces[i];
    const auto& p = piece.Points;
    const std::array<double, 3> lengths{ this->EdgeLength(p[0], p[1]), this->EdgeLength(p[1], p[2]),
      this->EdgeLength(p[2], p[0]) };
    const auto isOriginal = [&](std::int32_t a, std::int32_t b) {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto isOn = [&](std::int32_t x) {
          return x == p[k] || x == p[(k + 1) % 3] || x == middles[k];
        };
        if (isOn(a) && isOn(b))
        {
          return piece.IsOriginal[k];
        }
      }
      return false;
    };
    bool isFirst = true;
    CutTriangle(p, middles, lengths, [&](const std::array<std::int32_t, 3>& corners) {
      const Piece part{ corners, piece.Original, piece.IsNear,
        { isOriginal(corners[0], corners[1]), isOriginal(corners[1], corners[2]),
          isOriginal(corners[2], corners[0]) } };
      if (isFirst)
      {
        this->Pieces[i] = part;
        isFirst = false;
        return;
      }
      this->Pieces.push_back(part);
    });
  }

  /** Of the pieces made in a round, those of one triangle of the input get better diagonals. */
  void FlipNewEdges(const std::vector<std::uint8_t>& isNew)
  {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < isNew.size(); ++i)
    {
      if (isNew[i])
      {
        order.push_back(i);
      }
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return this->Pieces[a].Original < this->Pieces[b].Original;
    });
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      if (k == 0 || this->Pieces[order[k]].Original != this->Pieces[order[k - 1]].Original)
      {
        starts.push_back(k);
      }
    }
    starts.push_back(order.size());
    this->Threads.For(
      static_cast<std::int64_t>(starts.size()) - 1, 16, [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t group = static_cast<std::size_t>(begin);
             group < static_cast<std::size_t>(end); ++group)
        {
          this->FlipGroup(order.data() + starts[group], order.data() + starts[group + 1]);
        }
      });
  }

  void FlipGroup(const std::size_t* first, const std::size_t* last)
  {
    std::vector<FlippableTriangle> triangles;
    for (const std::size_t* i = first; i < last; ++i)
    {
      triangles.push_back({ this->Pieces[*i].Points, this->Pieces[*i].IsOriginal });
    }
    FlipToDelaunay(triangles, this->Points);
    for (const FlippableTriangle& triangle : triangles)
    {
      Piece& piece = this->Pieces[*first++];
      piece.Points = triangle.Corners;
      piece.IsOriginal = triangle.IsFixed;
      piece.IsNear = piece.IsNear || triangle.IsFlipped;
    }
  }

  void Assemble(RefinedSurface& refined)
  {
    std::stable_sort(this->Pieces.begin(), this->Pieces.end(),
      [](const Piece& a, const Piece& b) { return a.Original < b.Original; });
    DesignedSurface& surface = refined.Surface;
    const auto add = [&](const std::array<std::int32_t, 3>& p, std::int32_t original, bool isNear) {
      surface.Triangles.insert(surface.Triangles.end(), p.begin(), p.end());
      refined.Original.push_back(original);
      refined.IsNear.push_back(isNear ? 1 : 0);
      if (this->Input.HasPatches())
      {
        surface.FaceId.push_back(this->Input.FaceId[static_cast<std::size_t>(original)]);
      }
    };
    auto next = this->Pieces.begin();
    for (std::size_t t = 0; t < this->NumberOfTriangles(); ++t)
    {
      if (!this->IsPiece[t])
      {
        add(this->Corners(t), static_cast<std::int32_t>(t), this->Near[t] != 0);
      }
      for (; next != this->Pieces.end() && next->Original == static_cast<std::int32_t>(t); ++next)
      {
        add(next->Points, next->Original, next->IsNear);
      }
    }
    surface.Points = std::move(this->Points);
    surface.UV = std::move(this->UV);
    surface.Patches = this->Input.Patches;
  }

  static constexpr std::array<std::int32_t, 3> NoCorners{ None, None, None };

  const DesignedSurface& Input;
  const PointTree& Samples;
  const RefinementRequest Request;
  Executor& Threads;
  Monitor& Watch;
  std::vector<double> Points;
  std::vector<double> UV;
  std::vector<std::uint8_t> Near; ///< [triangle of the input]
  std::vector<std::uint8_t> IsPiece; ///< [triangle of the input]
  std::vector<std::int32_t> PlaceIds; ///< [point], None away from all that is cut
  std::int32_t NumberOfPlaces = 0;
  std::vector<Piece> Pieces;
  std::vector<std::uint64_t> Marked; ///< pairs of places, sorted; the middle of each is a new place
  std::vector<std::uint8_t> IsEnd; ///< [place], of a marked edge
  std::vector<std::array<std::int32_t, 3>> MarksOfPieces;
  std::vector<Use> Uses; ///< sorted by mark; each is a new point
  std::vector<std::int32_t> FirstUses; ///< [mark]
  std::int32_t FirstNewPoint = 0;
  bool IsTooLarge = false;
};

} // namespace

RefinedSurface RefineNearCloud(const DesignedSurface& surface, const PointTree& samples,
  const RefinementRequest& request, Executor& executor, Monitor& monitor)
{
  return Refining(surface, samples, request, executor, monitor).Run();
}

} // namespace sb
