// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshSection.h"

#include "BandMesh.h"
#include "CoincidentArea.h"
#include "EdgeRoot.h"
#include "ParallelSort.h"
#include "PlaceTable.h"
#include "SectionSteps.h"
#include "SurfaceRefinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sb
{
namespace
{

constexpr double RoundingInWidths = 1e-12; ///< points nearer than it are one
constexpr double TouchInSpacings = 0.1; ///< how near a mesh has to come to touch
constexpr std::int32_t None = -1;

/** A piece of curve across a small triangle. */
struct Segment
{
  std::int32_t From; ///< edge
  std::int32_t To; ///< edge
  std::int32_t Triangle; ///< small
};

/** Segments in their order, and the edges between them: one more, or as many and the first again.
 */
struct Branch
{
  std::vector<std::int32_t> Edges;
  std::vector<std::int32_t> Segments;
};

/** The part of a branch within one triangle of the mesh. */
struct Stretch
{
  std::size_t Curve;
  std::int32_t Triangle;
  std::vector<Real3> Points;
  std::vector<Real3> Chosen; ///< of them and between them, after the first
  double ChordError = 0.0;
};

/** All steps and what they share. */
class Sectioning
{
public:
  Sectioning(const MovingLeastSquares& surface, const DesignedSurface& mesh,
    const SectionRequest& request, Executor& executor, Monitor& monitor)
    : Surface(surface)
    , Mesh(mesh)
    , Request(request)
    , SmallEdge(std::min(request.Spacing, surface.NarrowWidth() / 3.0))
    , Threads(executor)
    , Watch(monitor)
  {
  }

  MeshSection Run()
  {
    MeshSection section;
    this->Refined = RefineNearCloud(this->Mesh, this->Surface.Samples(),
      { this->Surface.LargestWidth(), this->SmallEdge, 0.0 }, this->Threads, this->Watch);
    if (this->Refined.Status == RefinementStatus::Ok)
    {
      this->Watch.Progress(0.2, "Intersect");
      this->Band = MakeBandMesh(this->Refined, this->Surface, this->Threads, this->Watch);
      this->Watch.Progress(0.7, "Intersect");
      this->FindArea(section);
      this->FindTouches(section);
      this->ListEdges();
      this->FindRoots();
      this->ListSegments();
      this->Watch.Progress(0.8, "Intersect");
      this->MakeCurves(section);
    }
    if (this->Refined.Status == RefinementStatus::TooLarge)
    {
      section.Status = MeshSectionStatus::TooLarge;
    }
    if (this->Watch.Aborted())
    {
      section = MeshSection();
      section.Status = MeshSectionStatus::Aborted;
    }
    return section;
  }

private:
  Real3 CornerOf(std::int32_t triangle, std::size_t k) const
  {
    const std::size_t point =
      static_cast<std::size_t>(this->Mesh.Triangles[3 * static_cast<std::size_t>(triangle) + k]);
    const double* x = this->Mesh.Points.data() + 3 * point;
    return { x[0], x[1], x[2] };
  }

  Real3 NormalOf(std::int32_t triangle) const
  {
    return UnitNormalOf(
      this->CornerOf(triangle, 0), this->CornerOf(triangle, 1), this->CornerOf(triangle, 2));
  }

  void FindArea(MeshSection& section)
  {
    this->IsArea =
      FindCoincidentArea(this->Band, this->Surface, this->Request.Spacing, this->Threads);
    for (std::size_t t = 0; t < this->IsArea.size(); ++t)
    {
      if (this->IsArea[t])
      {
        const auto& p = this->Band.Triangles[t].Places;
        const Real3& a = this->Band.Place(p[0]);
        section.CoincidentArea += 0.5 *
          Length(
            Cross(Difference(this->Band.Place(p[1]), a), Difference(this->Band.Place(p[2]), a)));
      }
    }
  }

  void FindTouches(MeshSection& section) const
  {
    std::vector<double> values;
    for (const SurfaceValue& f : this->Band.Values)
    {
      values.push_back(f.IsNear ? f.Value : std::numeric_limits<double>::quiet_NaN());
    }
    TouchSearch search(std::move(values),
      std::max(this->Request.ChordError, TouchInSpacings * this->Request.Spacing),
      this->Band.Rounding);
    std::vector<std::uint8_t> isOfSurface(this->Band.Values.size(), 0);
    for (std::size_t t = 0; t < this->Band.Triangles.size(); ++t)
    {
      const auto& p = this->Band.Triangles[t].Places;
      const bool isSurface =
        !this->IsInArea(t) && this->NormalOf(this->Band.Triangles[t].Original) != Real3{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        search.Link(p[k], p[(k + 1) % 3]);
        isOfSurface[static_cast<std::size_t>(p[k])] |= isSurface ? 1 : 2;
      }
    }
    for (std::size_t place = 0; place < isOfSurface.size(); ++place)
    {
      if (isOfSurface[place] != 1) // triangles without area may have left places that no other has
      {
        search.LeaveOut(static_cast<std::int32_t>(place));
      }
    }
    MovingLeastSquares::Neighbourhood near;
    section.Touches = search.Find(
      this->Surface, [this](std::int32_t place) { return this->Band.Place(place); }, near);
  }

  bool IsInArea(std::size_t triangle) const
  {
    return !this->IsArea.empty() && this->IsArea[triangle] != 0;
  }

  /** Whether the curve crosses between two places; they are told apart even where unknown. */
  bool IsCrossed(std::int32_t a, std::int32_t b) const
  {
    return this->Band.IsKnown(a) && this->Band.IsKnown(b) &&
      this->Band.IsInside(a) != this->Band.IsInside(b);
  }

  /** The crossed edges, by the places of their ends. */
  void ListEdges()
  {
    for (const BandMesh::Triangle& triangle : this->Band.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::int32_t a = triangle.Places[k];
        const std::int32_t b = triangle.Places[(k + 1) % 3];
        if (this->IsCrossed(a, b))
        {
          this->Edges.push_back(PairOfPlaces(a, b));
        }
      }
    }
    ParallelSortUnique(this->Edges, this->Threads);
  }

  std::int32_t EdgeOf(std::int32_t a, std::int32_t b) const
  {
    return static_cast<std::int32_t>(
      std::lower_bound(this->Edges.begin(), this->Edges.end(), PairOfPlaces(a, b)) -
      this->Edges.begin());
  }

  void FindRoots()
  {
    this->Roots.resize(this->Edges.size());
    this->Threads.For(
      static_cast<std::int64_t>(this->Edges.size()), 16, [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::int64_t i = begin, last = this->Watch.Aborted() ? begin : end; i < last; ++i)
        {
          const std::uint64_t edge = this->Edges[static_cast<std::size_t>(i)];
          const std::int32_t a = LowerPlace(edge);
          const std::int32_t b = UpperPlace(edge);
          this->Roots[static_cast<std::size_t>(i)] = FindEdgeRoot(this->Surface,
            { this->Band.Place(a), Difference(this->Band.Place(b), this->Band.Place(a)),
              this->Band.Values[static_cast<std::size_t>(a)].Value,
              this->Band.Values[static_cast<std::size_t>(b)].Value, this->Band.IsInside(a) },
            RootStep, near);
        }
      });
  }

  const EdgeRoot& Root(std::int32_t edge) const
  {
    return this->Roots[static_cast<std::size_t>(edge)];
  }

  /** One for each triangle with a corner on the other side, inside on the left; and which edges
   * have a triangle on which the curve would go on. */
  void ListSegments()
  {
    this->Beyond.assign(this->Edges.size(), CurveEnd::None);
    for (std::size_t t = 0; t < this->Band.Triangles.size(); ++t)
    {
      const auto& p = this->Band.Triangles[t].Places;
      std::int32_t from = None;
      std::int32_t to = None;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::int32_t a = p[k];
        const std::int32_t b = p[(k + 1) % 3];
        if (this->IsCrossed(a, b))
        {
          (this->Band.IsInside(a) ? from : to) = this->EdgeOf(a, b);
        }
      }
      const bool isWhole = from != None && to != None;
      const bool isSupported =
        isWhole && this->Root(from).IsSupported() && this->Root(to).IsSupported();
      if (isSupported && !this->IsInArea(t))
      {
        this->Segments.push_back({ from, to, static_cast<std::int32_t>(t) });
        continue;
      }
      for (const std::int32_t edge : { from, to })
      {
        if (edge != None)
        {
          this->Beyond[static_cast<std::size_t>(edge)] =
            isSupported ? CurveEnd::CoincidentArea : CurveEnd::ScanBorder;
        }
      }
    }
  }

  /** The segments at each edge. */
  void ListSegmentsOfEdges()
  {
    this->FirstOfEdge.assign(this->Edges.size() + 1, 0);
    for (const Segment& segment : this->Segments)
    {
      ++this->FirstOfEdge[static_cast<std::size_t>(segment.From) + 1];
      ++this->FirstOfEdge[static_cast<std::size_t>(segment.To) + 1];
    }
    for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
    {
      this->FirstOfEdge[edge + 1] += this->FirstOfEdge[edge];
    }
    this->OfEdge.resize(2 * this->Segments.size());
    std::vector<std::int32_t> next(this->FirstOfEdge.begin(), this->FirstOfEdge.end());
    for (std::size_t s = 0; s < this->Segments.size(); ++s)
    {
      for (const std::int32_t edge : { this->Segments[s].From, this->Segments[s].To })
      {
        this->OfEdge[static_cast<std::size_t>(next[static_cast<std::size_t>(edge)]++)] =
          static_cast<std::int32_t>(s);
      }
    }
  }

  std::int32_t Degree(std::int32_t edge) const
  {
    return this->FirstOfEdge[static_cast<std::size_t>(edge) + 1] -
      this->FirstOfEdge[static_cast<std::size_t>(edge)];
  }

  /** A segment at the edge that is not in a branch yet, one that starts there if there is one. */
  std::int32_t UnusedAt(std::int32_t edge) const
  {
    std::int32_t found = None;
    for (std::int32_t i = this->FirstOfEdge[static_cast<std::size_t>(edge)];
         i < this->FirstOfEdge[static_cast<std::size_t>(edge) + 1]; ++i)
    {
      const std::int32_t segment = this->OfEdge[static_cast<std::size_t>(i)];
      if (!this->IsUsed[static_cast<std::size_t>(segment)] &&
        (found == None || this->Segments[static_cast<std::size_t>(segment)].From == edge))
      {
        found = segment;
      }
    }
    return found;
  }

  Branch Follow(std::int32_t edge, std::int32_t segment)
  {
    Branch branch;
    branch.Edges.push_back(edge);
    while (segment != None)
    {
      this->IsUsed[static_cast<std::size_t>(segment)] = 1;
      const Segment& s = this->Segments[static_cast<std::size_t>(segment)];
      edge = s.From == edge ? s.To : s.From;
      branch.Edges.push_back(edge);
      branch.Segments.push_back(segment);
      segment = this->Degree(edge) == 2 ? this->UnusedAt(edge) : None;
    }
    return branch;
  }

  /** Open ones first: those that leave an end in their direction, then the others (a mesh that is
   * not oriented alike throughout has them), and then loops. */
  std::vector<Branch> Branches()
  {
    this->ListSegmentsOfEdges();
    this->IsUsed.assign(this->Segments.size(), 0);
    std::vector<Branch> branches;
    for (const bool anyDirection : { false, true })
    {
      for (std::int32_t edge = 0; edge < static_cast<std::int32_t>(this->Edges.size()); ++edge)
      {
        while (this->Degree(edge) != 2)
        {
          const std::int32_t segment = this->UnusedAt(edge);
          if (segment == None ||
            (!anyDirection && this->Segments[static_cast<std::size_t>(segment)].From != edge))
          {
            break;
          }
          branches.push_back(this->Follow(edge, segment));
        }
      }
    }
    for (std::size_t s = 0; s < this->Segments.size(); ++s)
    {
      if (!this->IsUsed[s])
      {
        branches.push_back(this->Follow(this->Segments[s].From, static_cast<std::int32_t>(s)));
        this->StartAtEdgeOfMesh(branches.back());
      }
    }
    return branches;
  }

  std::int32_t TriangleOf(std::int32_t segment) const
  {
    const Segment& s = this->Segments[static_cast<std::size_t>(segment)];
    return this->Band.Triangles[static_cast<std::size_t>(s.Triangle)].Original;
  }

  /** Turn a loop so that it starts where it enters a triangle of the mesh, if it enters any. */
  void StartAtEdgeOfMesh(Branch& loop) const
  {
    const std::size_t count = loop.Segments.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      if (this->TriangleOf(loop.Segments[k]) !=
        this->TriangleOf(loop.Segments[(k + count - 1) % count]))
      {
        const auto by = static_cast<std::ptrdiff_t>(k);
        loop.Edges.pop_back();
        std::rotate(loop.Edges.begin(), loop.Edges.begin() + by, loop.Edges.end());
        loop.Edges.push_back(loop.Edges.front());
        std::rotate(loop.Segments.begin(), loop.Segments.begin() + by, loop.Segments.end());
        return;
      }
    }
  }

  void MakeCurves(MeshSection& section)
  {
    std::vector<Stretch> runs;
    std::vector<std::int32_t> ends;
    for (const Branch& branch : this->Branches())
    {
      MeshSectionCurve curve;
      curve.Closed = branch.Edges.front() == branch.Edges.back();
      curve.IsTangential = this->IsTangential(branch);
      curve.Points.push_back(this->Root(branch.Edges.front()).Point);
      this->ListRuns(branch, section.Curves.size(), runs);
      section.Curves.push_back(std::move(curve));
      ends.push_back(branch.Edges.front());
      ends.push_back(branch.Edges.back());
    }
    this->ChoosePoints(runs);
    for (const Stretch& run : runs)
    {
      MeshSectionCurve& curve = section.Curves[run.Curve];
      curve.Points.insert(curve.Points.end(), run.Chosen.begin(), run.Chosen.end());
      curve.Triangles.insert(curve.Triangles.end(), run.Chosen.size(), run.Triangle);
      curve.LargestChordError = std::max(curve.LargestChordError, run.ChordError);
    }
    for (MeshSectionCurve& curve : section.Curves)
    {
      if (curve.Closed) // the last run may have been no longer than rounding
      {
        curve.Points.back() = curve.Points.front();
      }
    }
    this->TellEnds(ends, section.Curves);
    section.Curves.erase(std::remove_if(section.Curves.begin(), section.Curves.end(),
                           [](const MeshSectionCurve& curve) { return curve.Points.size() < 2; }),
      section.Curves.end());
  }

  bool IsTangential(const Branch& branch) const
  {
    for (std::size_t k = 0; k < branch.Segments.size(); ++k)
    {
      const Real3 normal = this->NormalOf(this->TriangleOf(branch.Segments[k]));
      for (const std::size_t edge : { k, k + 1 })
      {
        if (normal != Real3{} &&
          SineBetween(this->Root(branch.Edges[edge]).Surface.Gradient, normal) < TangentialSine)
        {
          return true;
        }
      }
    }
    return false;
  }

  void ListRuns(const Branch& branch, std::size_t curve, std::vector<Stretch>& runs) const
  {
    const double rounding = RoundingInWidths * this->Surface.Width();
    for (std::size_t k = 0; k < branch.Segments.size(); ++k)
    {
      const std::int32_t triangle = this->TriangleOf(branch.Segments[k]);
      if (k == 0 || triangle != runs.back().Triangle)
      {
        runs.push_back({ curve, triangle, { this->Root(branch.Edges[k]).Point }, {} });
      }
      std::vector<Real3>& points = runs.back().Points;
      const Real3& next = this->Root(branch.Edges[k + 1]).Point;
      const bool isLast =
        k + 1 == branch.Segments.size() || this->TriangleOf(branch.Segments[k + 1]) != triangle;
      if (Length(Difference(next, points.back())) > rounding)
      {
        points.push_back(next);
      }
      else if (isLast)
      {
        points.back() = next; // the run after it starts there
      }
    }
  }

  void ChoosePoints(std::vector<Stretch>& runs)
  {
    this->Threads.For(
      static_cast<std::int64_t>(runs.size()), 4, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin, last = this->Watch.Aborted() ? begin : end; i < last; ++i)
        {
          Stretch& run = runs[static_cast<std::size_t>(i)];
          const Real3 normal = this->NormalOf(run.Triangle);
          if (run.Points.size() < 2 || normal == Real3{})
          {
            run.Chosen.assign(run.Points.begin() + 1, run.Points.end());
            continue;
          }
          run.ChordError =
            SectionSteps(this->Surface, normal, this->Request.ChordError, this->SmallEdge)
              .Walk(run.Points, run.Chosen);
        }
      });
  }

  /** Why the open curves end, from what is beyond their last edges. */
  void TellEnds(const std::vector<std::int32_t>& ends, std::vector<MeshSectionCurve>& curves)
  {
    bool isAnyOpen = false;
    for (const MeshSectionCurve& curve : curves)
    {
      isAnyOpen = isAnyOpen || !curve.Closed;
    }
    if (!isAnyOpen)
    {
      return;
    }
    std::vector<std::uint64_t> open(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      open[i] = this->Edges[static_cast<std::size_t>(ends[i])];
    }
    const std::vector<std::int32_t> uses = this->UsesOf(open);
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      MeshSectionCurve& curve = curves[i / 2];
      const CurveEnd beyond = this->Beyond[static_cast<std::size_t>(ends[i])];
      if (!curve.Closed)
      {
        curve.Ends[i % 2] = this->Degree(ends[i]) > 2 ? CurveEnd::Junction
          : beyond != CurveEnd::None                  ? beyond
          : uses[i] == 1                              ? CurveEnd::MeshBorder
                                                      : CurveEnd::ScanBorder;
      }
    }
  }

  /** How many triangles of the whole refined mesh have each edge; those that are not near are not
   * in the band. */
  std::vector<std::int32_t> UsesOf(const std::vector<std::uint64_t>& edges) const
  {
    PlaceTable table(2 * edges.size());
    std::vector<std::pair<std::uint64_t, std::size_t>> wanted;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      wanted.emplace_back(PairOfPlaces(table.Add(this->Band.Place(LowerPlace(edges[i])).data()),
                            table.Add(this->Band.Place(UpperPlace(edges[i])).data())),
        i);
    }
    std::sort(wanted.begin(), wanted.end());
    std::vector<std::int32_t> uses(edges.size(), 0);
    const auto count = [&](const double* a, const double* b) {
      const std::int32_t first = table.Find(a);
      const std::int32_t last = first != None ? table.Find(b) : None;
      if (last != None)
      {
        const std::uint64_t pair = PairOfPlaces(first, last);
        for (auto it =
               std::lower_bound(wanted.begin(), wanted.end(), std::make_pair(pair, std::size_t(0)));
             it != wanted.end() && it->first == pair; ++it)
        {
          ++uses[it->second];
        }
      }
    };
    for (const BandMesh::Triangle& triangle : this->Band.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        count(this->Band.Place(triangle.Places[k]).data(),
          this->Band.Place(triangle.Places[(k + 1) % 3]).data());
      }
    }
    const DesignedSurface& all = this->Refined.Surface;
    for (std::size_t t = 0; t < this->Refined.IsNear.size(); ++t)
    {
      for (std::size_t k = 0; k < 3 && !this->Refined.IsNear[t]; ++k)
      {
        count(all.Points.data() + 3 * static_cast<std::size_t>(all.Triangles[3 * t + k]),
          all.Points.data() + 3 * static_cast<std::size_t>(all.Triangles[3 * t + (k + 1) % 3]));
      }
    }
    return uses;
  }

  const MovingLeastSquares& Surface;
  const DesignedSurface& Mesh;
  const SectionRequest Request;
  const double SmallEdge;
  Executor& Threads;
  Monitor& Watch;
  RefinedSurface Refined;
  BandMesh Band;
  std::vector<std::uint8_t> IsArea; ///< [triangle of the band] empty if there is no area
  std::vector<std::uint64_t> Edges; ///< pairs of places, sorted
  std::vector<EdgeRoot> Roots; ///< [edge]
  std::vector<CurveEnd> Beyond; ///< [edge] what ends the curve there, if anything known does
  std::vector<Segment> Segments;
  std::vector<std::int32_t> FirstOfEdge; ///< [edge] into OfEdge
  std::vector<std::int32_t> OfEdge; ///< segments
  std::vector<std::uint8_t> IsUsed; ///< [segment]
};

} // namespace

MeshSection IntersectMesh(const MovingLeastSquares& surface, const DesignedSurface& mesh,
  const SectionRequest& request, Executor& executor, Monitor& monitor)
{
  return Sectioning(surface, mesh, request, executor, monitor).Run();
}

} // namespace sb
