// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamSnap.h"

#include "Intersection.h"
#include "MeshEdit.h"
#include "SeamTarget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 64;
constexpr double ShortEdge = 0.1; ///< in spacings; moves are about a tenth as long
constexpr double FlatEnough = 0.005; ///< in spacings: how far a collapse may bend the tool
constexpr double FlatAtLast = 0.02; ///< the same, for what is stuck else
constexpr double LongestMove = 1.0; ///< in spacings
constexpr double ClearedWay = 3.0; ///< in ways of a vertex that is stuck
/** Cosines between a triangle and its surface. */
constexpr double LeastFacingOfCloud = 0.1;
constexpr double LeastFacingOfTool = 0.9;
constexpr double LeastFacingOfEar = 0.9;
constexpr double LeastFacingAtLast = 0.02; ///< of both, for what is stuck else
constexpr int MovingPasses = 4;
constexpr int MostRounds = 4; ///< of the whole, each without what crossed in the one before

constexpr std::uint8_t OfCloud = 1;
constexpr std::uint8_t OfTool = 2;
constexpr std::uint8_t OnSeam = OfCloud | OfTool;

/** For each point, which operands' triangles have it. */
std::vector<std::uint8_t> SidesOf(const CombinedMesh& mesh)
{
  std::vector<std::uint8_t> sides(static_cast<std::size_t>(mesh.NumberOfPoints()), 0);
  for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
  {
    sides[static_cast<std::size_t>(mesh.Triangles[corner])] |=
      mesh.Source[corner / 3] == 0 ? OfCloud : OfTool;
  }
  return sides;
}

/** Mark all corners of triangles with a marked corner, too. */
void Grow(const CombinedMesh& mesh, std::vector<std::uint8_t>& marked)
{
  const std::vector<std::uint8_t> before = marked;
  for (std::int32_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const std::int32_t* const ids = mesh.Corners(t);
    if (before[static_cast<std::size_t>(ids[0])] || before[static_cast<std::size_t>(ids[1])] ||
      before[static_cast<std::size_t>(ids[2])])
    {
      for (int k = 0; k < 3; ++k)
      {
        marked[static_cast<std::size_t>(ids[k])] = 1;
      }
    }
  }
}

/** One round: collapses, moves, and what they led to. */
class SnapRound
{
public:
  SnapRound(const SeamSnapRequest& request, CombinedMesh& mesh,
    const std::vector<std::uint8_t>& sides, const std::vector<std::uint8_t>& zone,
    const std::vector<std::uint8_t>& caution, Executor& executor, Monitor& monitor)
    : Request(request)
    , Mesh(mesh)
    , Sides(sides)
    , Caution(caution)
    , Threads(executor)
    , Watch(monitor)
    , Edit(mesh, zone, [this](std::int32_t triangle) { return this->FrontOf(triangle); })
    , Touched(sides.size(), 0)
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (sides[i] == OnSeam)
      {
        this->Seam.push_back(static_cast<std::int32_t>(i));
      }
    }
  }

  void Run()
  {
    this->FindFreedoms();
    this->CollapseShortEdges();
    this->FindTargets();
    this->MoveAll();
    this->FindTargetsAcross();
    this->MoveAll();
    this->HelpStuck();
    this->AtLast = true;
    this->FindTargetsAcross();
    this->MoveAll();
    this->HelpStuck();
  }

  /** Points that were moved or took up others. */
  const std::vector<std::uint8_t>& TouchedPoints() const { return this->Touched; }
  std::int64_t NumberOfCollapses() const { return this->Collapses; }

  /** The seam as it is, in the numbers before Finish. */
  std::vector<SeamVertex> Vertices()
  {
    std::vector<SeamVertex> vertices;
    for (std::size_t i = 0; i < this->Seam.size(); ++i)
    {
      if (!this->Edit.IsGone(this->Seam[i]))
      {
        vertices.push_back({ this->Seam[i], 0.0, this->Targets[i].Tangency, this->Done[i] != 0 });
      }
    }
    this->Threads.For(
      static_cast<std::int64_t>(vertices.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          const SurfaceValue f =
            this->Request.Cloud->EvaluateAt(this->Mesh.Point(vertices[i].Point), 1, near);
          const double steepness = Length(f.Gradient);
          vertices[i].Residual = steepness > 0.0 ? std::abs(f.Value) / steepness : 0.0;
        }
      });
    return vertices;
  }

  std::vector<std::int32_t> Finish() { return this->Edit.Finish(); }

private:
  MeshEdit::Front FrontOf(std::int32_t triangle) const
  {
    const bool ofCloud = this->Mesh.Source[static_cast<std::size_t>(triangle)] == 0;
    const double least = ofCloud ? LeastFacingOfCloud : LeastFacingOfTool;
    return { FrontOfTriangle(this->Mesh, triangle, this->Request),
      ofCloud && this->IsEar(triangle) ? LeastFacingOfEar
        : this->AtLast                 ? LeastFacingAtLast
                                       : least };
  }

  /** Whether all corners are on the seam: of the cloud, such a triangle may come to lie in the
   * tool. */
  bool IsEar(std::int32_t triangle) const
  {
    const std::int32_t* const ids = this->Mesh.Corners(triangle);
    return std::all_of(ids, ids + 3, [this](std::int32_t id) { return this->IsOnSeam(id); });
  }

  /** The tool's triangles that the pieces around a point are parts of. */
  std::vector<std::int32_t> ToolTrianglesAt(std::int32_t point) const
  {
    std::vector<std::int32_t> parents;
    for (const std::int32_t t : this->Edit.TrianglesAt(point))
    {
      if (this->Mesh.Source[static_cast<std::size_t>(t)] != 0)
      {
        parents.push_back(this->Mesh.Parent[static_cast<std::size_t>(t)]);
      }
    }
    std::sort(parents.begin(), parents.end());
    parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
    return parents;
  }

  void FindFreedoms()
  {
    this->Freedoms.resize(this->Seam.size());
    this->PlaceInSeam.assign(this->Sides.size(), -1);
    for (std::size_t i = 0; i < this->Seam.size(); ++i)
    {
      this->PlaceInSeam[static_cast<std::size_t>(this->Seam[i])] = static_cast<std::int32_t>(i);
      this->Freedoms[i] = FreedomOn(
        *this->Request.Tool, this->ToolTrianglesAt(this->Seam[i]), this->Mesh.Point(this->Seam[i]));
    }
    this->Done.assign(this->Seam.size(), 0);
  }

  /** Whether a point must not be touched: it was once, and triangles crossed. */
  bool IsFrozen(std::int32_t point) const
  {
    return this->Caution[static_cast<std::size_t>(point)] > (this->AtLast ? 0 : 1);
  }

  bool IsOnSeam(std::int32_t point) const
  {
    return this->Sides[static_cast<std::size_t>(point)] == OnSeam;
  }

  /** Whether the edge is part of the seam: one triangle of each operand has it. */
  bool IsSeamEdge(std::int32_t a, std::int32_t b) const
  {
    int ofCloud = 0;
    int ofTool = 0;
    for (const std::int32_t t : this->Edit.TrianglesAt(a))
    {
      const std::int32_t* const ids = this->Mesh.Corners(t);
      if (std::find(ids, ids + 3, b) != ids + 3)
      {
        (this->Mesh.Source[static_cast<std::size_t>(t)] == 0 ? ofCloud : ofTool) += 1;
      }
    }
    return ofCloud == 1 && ofTool == 1;
  }

  /** Whether a point of the seam shapes the tool more than another one does. */
  bool IsSharper(std::int32_t a, std::int32_t b) const
  {
    return this->FreedomOf(a).What > this->FreedomOf(b).What;
  }

  const SeamFreedom& FreedomOf(std::int32_t point) const
  {
    return this
      ->Freedoms[static_cast<std::size_t>(this->PlaceInSeam[static_cast<std::size_t>(point)])];
  }

  /** Points of the tool may vanish where they do not shape it, those of the seam into others of the
   * seam only, and not from a crease into a face. */
  bool TryCollapse(std::int32_t gone, std::int32_t kept)
  {
    if (this->IsFrozen(gone) ||
      (this->IsOnSeam(gone) &&
        !(this->IsOnSeam(kept) && this->IsSeamEdge(gone, kept) &&
          (this->AtLast || !this->IsSharper(gone, kept)))) ||
      !this->IsFlatTowards(gone, kept) || this->MakesEar(gone, kept) ||
      this->LeavesBorder(gone, kept) || !this->Edit.Collapse(gone, kept))
    {
      return false;
    }
    this->Touched[static_cast<std::size_t>(kept)] = 1;
    ++this->Collapses;
    return true;
  }

  /** Whether a triangle of the cloud would get all its corners on the seam: it would lie in the
   * tool, on the triangles there. */
  bool MakesEar(std::int32_t gone, std::int32_t kept) const
  {
    const std::vector<std::int32_t>& triangles = this->Edit.TrianglesAt(gone);
    return this->IsOnSeam(kept) && !this->IsOnSeam(gone) &&
      std::any_of(triangles.begin(), triangles.end(), [&](std::int32_t t) {
        const std::int32_t* const ids = this->Mesh.Corners(t);
        return this->Mesh.Source[static_cast<std::size_t>(t)] == 0 &&
          std::find(ids, ids + 3, kept) == ids + 3 &&
          std::all_of(
            ids, ids + 3, [&](std::int32_t id) { return id == gone || this->IsOnSeam(id); });
      });
  }

  /** Whether a patch meets itself at the first point, and not all the way to the second one: its
   * triangles would come to lie on both sides of its border, and have no u and v. */
  bool LeavesBorder(std::int32_t gone, std::int32_t kept) const
  {
    const ToolSurface& tool = *this->Request.Tool;
    const Real3 place = this->Mesh.Point(gone);
    if (!tool.MeetsItselfAmong(this->ToolTrianglesAt(gone), place))
    {
      return false;
    }
    std::vector<std::int32_t> between;
    for (const std::int32_t t : this->Edit.TrianglesAt(gone))
    {
      const std::int32_t* const ids = this->Mesh.Corners(t);
      if (this->Mesh.Source[static_cast<std::size_t>(t)] != 0 &&
        std::find(ids, ids + 3, kept) != ids + 3)
      {
        between.push_back(this->Mesh.Parent[static_cast<std::size_t>(t)]);
      }
    }
    return !tool.MeetsItselfAmong(between, place);
  }

  /** Whether a place is on the other side of a border of the patch that a seam vertex is on. */
  bool IsAcrossBorder(std::int32_t point, const Real3& place) const
  {
    const ToolSurface& tool = *this->Request.Tool;
    const std::int32_t there = tool.NearestTo(place, this->Request.Spacing).Triangle;
    const std::vector<std::int32_t> here = this->ToolTrianglesAt(point);
    return there >= 0 && std::any_of(here.begin(), here.end(), [&](std::int32_t t) {
      return tool.MeetsItselfBetween(t, there, place);
    });
  }

  /** How far the tool may be bent. */
  double BendOfTool() const
  {
    return (this->AtLast ? FlatAtLast : FlatEnough) * this->Request.Spacing;
  }

  bool IsFlatTowards(std::int32_t gone, std::int32_t kept) const
  {
    return IsNearPlanes(
      *this->Request.Tool, this->ToolTrianglesAt(gone), this->Mesh.Point(kept), this->BendOfTool());
  }

  /** Collapse what is short at the seam. */
  void CollapseShortEdges()
  {
    for (const std::int32_t point : this->Seam)
    {
      this->CollapseAround(point, ShortEdge * this->Request.Spacing);
    }
  }

  /** Collapse the edges of a point that are shorter than the limit, others into the point or the
   * point into another one. */
  void CollapseAround(std::int32_t point, double limit)
  {
    bool again = !this->Edit.IsGone(point) && !this->IsFrozen(point);
    while (again)
    {
      again = false;
      for (const std::int32_t other : this->Edit.Neighbours(point))
      {
        const bool isShort =
          Length(Difference(this->Mesh.Point(other), this->Mesh.Point(point))) < limit;
        if (!isShort || !this->Edit.IsInZone(other) || this->IsFrozen(other))
        {
          continue;
        }
        again = this->TryCollapse(other, point);
        if (again || (this->IsOnSeam(other) && this->TryCollapse(point, other)))
        {
          break;
        }
      }
      again = again && !this->Edit.IsGone(point);
    }
  }

  template <class Find>
  void ForSeam(const Find& find)
  {
    this->Threads.For(static_cast<std::int64_t>(this->Seam.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = static_cast<std::size_t>(begin);
             i < static_cast<std::size_t>(end) && !this->Watch.Aborted(); ++i)
        {
          find(i, near);
        }
      });
  }

  void FindTargets()
  {
    this->Targets.resize(this->Seam.size());
    this->ForSeam([this](std::size_t i, auto& near) {
      this->Targets[i] =
        FindSeamTarget(*this->Request.Cloud, *this->Request.Tool, this->Freedoms[i],
          this->Mesh.Point(this->Seam[i]), LongestMove * this->Request.Spacing, near);
    });
  }

  /** For what could not be moved: places on other triangles of the tool, if it is flat that far. */
  void FindTargetsAcross()
  {
    this->ForSeam([this](std::size_t i, auto& near) {
      const std::int32_t point = this->Seam[i];
      if (this->Done[i] || this->Edit.IsGone(point))
      {
        return;
      }
      const SeamTarget target = FindSeamTargetAcross(*this->Request.Cloud, *this->Request.Tool,
        this->Mesh.Point(point), LongestMove * this->Request.Spacing, near);
      if (target.Reached &&
        IsNearPlanes(
          *this->Request.Tool, this->ToolTrianglesAt(point), target.Place, this->BendOfTool()) &&
        this->Freedoms[i].What != SeamFreedom::Kind::Border &&
        !this->IsAcrossBorder(point, target.Place))
      {
        this->Targets[i] = target;
      }
    });
  }

  /** Whether a vertex of the seam has still to be moved, and where to is known. */
  bool IsToMove(std::size_t i) const
  {
    return !this->Done[i] && this->Targets[i].Reached && !this->Edit.IsGone(this->Seam[i]) &&
      !this->IsFrozen(this->Seam[i]);
  }

  /** Over and over, as a vertex may get its way when its neighbours have moved. */
  void MoveAll()
  {
    for (int pass = 0; pass < MovingPasses; ++pass)
    {
      bool stuck = false;
      for (std::size_t i = 0; i < this->Seam.size(); ++i)
      {
        if (this->IsToMove(i))
        {
          this->MoveOne(i);
          stuck = stuck || !this->Done[i];
        }
      }
      if (!stuck || this->Watch.Aborted())
      {
        return;
      }
    }
  }

  void MoveOne(std::size_t i)
  {
    const std::int32_t point = this->Seam[i];
    const Real3 from = this->Mesh.Point(point);
    const Real3 way = Difference(this->Targets[i].Place, from);
    if (!this->IsOnTool(i))
    {
      this->Targets[i].Reached = false;
      return;
    }
    for (double share = 1.0; share > 0.2; share *= 0.5)
    {
      if (this->AtLast && share < 1.0 && this->MoveFlipping(i))
      {
        return;
      }
      const Real3 place = share == 1.0 ? this->Targets[i].Place : PlusScaled(from, share, way);
      if (this->Edit.Move(point, place))
      {
        this->Done[i] = share == 1.0 ? 1 : 0;
        this->Touched[static_cast<std::size_t>(point)] = 1;
        return;
      }
    }
  }

  /** Over edges of triangles that are thinner than the way. */
  bool MoveFlipping(std::size_t i)
  {
    const bool isMoved = this->Edit.MoveFlipping(this->Seam[i], this->Targets[i].Place,
      [this](const MeshEdit::EdgeToFlip& edge) { return this->MayFlip(edge); });
    this->Done[i] = isMoved ? 1 : this->Done[i];
    this->Touched[static_cast<std::size_t>(this->Seam[i])] |= isMoved ? 1 : 0;
    return isMoved;
  }

  /** Whether the edge does not shape what it is on. One of the cloud must not be replaced by one
   * across the tool, from seam to seam. */
  bool MayFlip(const MeshEdit::EdgeToFlip& edge) const
  {
    const std::int32_t t = edge.Triangle;
    const std::int32_t u = edge.Other;
    if (this->Mesh.Source[static_cast<std::size_t>(t)] == 0)
    {
      return !(this->IsOnSeam(edge.Top) && this->IsOnSeam(edge.Bottom));
    }
    const std::vector<std::int32_t> parents{ this->Mesh.Parent[static_cast<std::size_t>(t)],
      this->Mesh.Parent[static_cast<std::size_t>(u)] };
    const std::vector<std::int32_t>& faces = this->Request.Tool->Body().FaceId;
    if (!faces.empty() &&
      faces[static_cast<std::size_t>(parents[0])] != faces[static_cast<std::size_t>(parents[1])])
    {
      return false;
    }
    if (this->Request.Tool->MeetsItselfBetween(parents[0], parents[1], this->MiddleOfEdge(edge)))
    {
      return false;
    }
    const auto isFlat = [&](std::int32_t id) {
      return IsNearPlanes(*this->Request.Tool, parents, this->Mesh.Point(id), this->BendOfTool());
    };
    return std::all_of(this->Mesh.Corners(t), this->Mesh.Corners(t) + 3, isFlat) &&
      std::all_of(this->Mesh.Corners(u), this->Mesh.Corners(u) + 3, isFlat);
  }

  Real3 MiddleOfEdge(const MeshEdit::EdgeToFlip& edge) const
  {
    Real3 middle{};
    const std::int32_t* const ids = this->Mesh.Corners(edge.Triangle);
    for (int k = 0; k < 3; ++k)
    {
      middle = ids[k] == edge.Top ? middle : PlusScaled(middle, 0.5, this->Mesh.Point(ids[k]));
    }
    return middle;
  }

  /** A target in the plane of a triangle may lie beyond the triangle. */
  bool IsOnTool(std::size_t i) const
  {
    const bool ofFacets = !this->Request.Tool->Body().HasPatches();
    const double limit = (ofFacets ? 1e-7 : 0.5) * this->Request.Spacing;
    return this->Request.Tool->Distance(this->Targets[i].Place, limit) < limit;
  }

  bool IsStuck(std::size_t i) const
  {
    return !this->Done[i] && !this->Edit.IsGone(this->Seam[i]) && !this->IsFrozen(this->Seam[i]);
  }

  void HelpStuck()
  {
    this->ClearStuck();
    this->MoveAll();
    this->CollapseStuck();
    this->MoveAll();
  }

  /** What could not be moved takes up what is in its way. */
  void ClearStuck()
  {
    for (std::size_t i = 0; i < this->Seam.size(); ++i)
    {
      if (this->IsStuck(i) && this->Targets[i].Reached)
      {
        const Real3 from = this->Mesh.Point(this->Seam[i]);
        const double way = Length(Difference(this->Targets[i].Place, from));
        // At last more of what is short may go than in the beginning.
        this->CollapseAround(this->Seam[i],
          std::max(ClearedWay * way, this->AtLast ? ShortEdge * this->Request.Spacing : 0.0));
        this->CollapseInTheWay(i);
      }
    }
  }

  /** What is not on the seam, of triangles that would turn over, goes elsewhere. */
  void CollapseInTheWay(std::size_t i)
  {
    if (this->Edit.IsGone(this->Seam[i]))
    {
      return;
    }
    for (const std::int32_t t : this->Edit.InTheWay(this->Seam[i], this->Targets[i].Place))
    {
      const std::int32_t* const ids = this->Mesh.Corners(t);
      for (int k = 0; k < 3; ++k)
      {
        if (!this->IsOnSeam(ids[k]) && this->CollapseAway(ids[k]))
        {
          this->CollapseInTheWay(i);
          return;
        }
      }
    }
  }

  /** Collapse a point into the nearest neighbour that it can go into. */
  bool CollapseAway(std::int32_t point)
  {
    if (!this->Edit.IsInZone(point))
    {
      return false;
    }
    std::vector<std::int32_t> others = this->Edit.Neighbours(point);
    std::stable_sort(others.begin(), others.end(), [&](std::int32_t a, std::int32_t b) {
      const Real3 place = this->Mesh.Point(point);
      return Length(Difference(this->Mesh.Point(a), place)) <
        Length(Difference(this->Mesh.Point(b), place));
    });
    return std::any_of(others.begin(), others.end(), [&](std::int32_t other) {
      return this->Edit.IsInZone(other) && !this->IsFrozen(other) &&
        this->TryCollapse(point, other);
    });
  }

  /** What still could not be moved goes into a neighbour that could. */
  void CollapseStuck()
  {
    for (std::size_t i = 0; i < this->Seam.size(); ++i)
    {
      if (!this->IsStuck(i))
      {
        continue;
      }
      for (const std::int32_t other : this->Edit.Neighbours(this->Seam[i]))
      {
        const std::int32_t place = this->PlaceInSeam[static_cast<std::size_t>(other)];
        if (place >= 0 && this->Done[static_cast<std::size_t>(place)] &&
          this->TryCollapse(this->Seam[i], other))
        {
          break;
        }
      }
    }
  }

  const SeamSnapRequest& Request;
  CombinedMesh& Mesh;
  const std::vector<std::uint8_t>& Sides;
  const std::vector<std::uint8_t>& Caution;
  Executor& Threads;
  Monitor& Watch;
  MeshEdit Edit;
  bool AtLast = false; ///< all that may be done without risk is done
  std::vector<std::uint8_t> Touched;
  std::vector<std::int32_t> Seam;
  std::vector<std::int32_t> PlaceInSeam; ///< [point], or -1
  std::vector<SeamFreedom> Freedoms; ///< as Seam, and so are the next two
  std::vector<SeamTarget> Targets;
  std::vector<std::uint8_t> Done; ///< is where it should be
  std::int64_t Collapses = 0;
};

/** The points of triangles near the touched ones that cross others, and how many segments that
 * makes. */
std::vector<std::int32_t> FindCrossing(const CombinedMesh& mesh, std::vector<std::uint8_t> near,
  std::int64_t& crossings, Executor& executor, Monitor& monitor)
{
  Grow(mesh, near);
  std::vector<std::int32_t> triangles;
  std::vector<std::int32_t> corners;
  for (std::int32_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const std::int32_t* const ids = mesh.Corners(t);
    if (near[static_cast<std::size_t>(ids[0])] && near[static_cast<std::size_t>(ids[1])] &&
      near[static_cast<std::size_t>(ids[2])])
    {
      triangles.push_back(t);
      corners.insert(corners.end(), ids, ids + 3);
    }
  }
  IntersectionRequest request;
  request.Operands.push_back({ { mesh.Points.data(), mesh.NumberOfPoints(), corners.data(),
                                 static_cast<std::int64_t>(triangles.size()) },
    Group::Input, nullptr });
  request.Split.assign(1, 0);
  const IntersectionResult found = ComputeIntersection(request, executor, monitor);
  crossings = static_cast<std::int64_t>(found.Intersection.Segments.size());
  std::vector<std::int32_t> points;
  for (const Curves::Makers& makers : found.Intersection.Segments)
  {
    for (const std::int32_t maker : makers.Triangle)
    {
      const std::int32_t* const ids = mesh.Corners(triangles[static_cast<std::size_t>(maker)]);
      points.insert(points.end(), ids, ids + 3);
    }
  }
  return points;
}

void Summarise(SeamSnap& snap)
{
  for (const SeamVertex& vertex : snap.Vertices)
  {
    snap.LargestResidual = std::max(snap.LargestResidual, vertex.Residual);
    snap.NumberOfBackedOff += vertex.Snapped ? 0 : 1;
  }
}

} // namespace

Real3 FrontOfTriangle(
  const CombinedMesh& mesh, std::int32_t triangle, const SeamSnapRequest& request)
{
  const std::size_t t = static_cast<std::size_t>(triangle);
  const double sign = mesh.Reversed[t] ? -1.0 : 1.0;
  const std::int32_t parent = mesh.Parent[t];
  if (mesh.Source[t] != 0)
  {
    return Scaled(request.Tool->Normal(parent), sign);
  }
  const std::int32_t* const ids =
    request.CloudMesh.Triangles + 3 * static_cast<std::size_t>(parent);
  Real3 sum{};
  for (int k = 0; k < 3; ++k)
  {
    const double* const n = request.CloudNormals->data() + 3 * static_cast<std::size_t>(ids[k]);
    sum = PlusScaled(sum, 1.0, { n[0], n[1], n[2] });
  }
  const double length = Length(sum);
  return length > 0.0 ? Scaled(sum, sign / length) : Real3{};
}

SeamSnap SnapSeam(
  const CombinedMesh& mesh, const SeamSnapRequest& request, Executor& executor, Monitor& monitor)
{
  const std::vector<std::uint8_t> sides = SidesOf(mesh);
  std::vector<std::uint8_t> zone(sides.size());
  std::transform(sides.begin(), sides.end(), zone.begin(),
    [](std::uint8_t side) { return static_cast<std::uint8_t>(side == OnSeam ? 1 : 0); });
  Grow(mesh, zone);
  Grow(mesh, zone);
  std::vector<std::uint8_t> caution(sides.size(), 0);
  SeamSnap snap;
  for (int round = 0; round < MostRounds; ++round)
  {
    snap = SeamSnap();
    snap.Mesh = mesh;
    SnapRound one(request, snap.Mesh, sides, zone, caution, executor, monitor);
    one.Run();
    snap.Vertices = one.Vertices();
    snap.NumberOfCollapses = one.NumberOfCollapses();
    snap.PointMap = one.Finish();
    std::vector<std::uint8_t> touched(static_cast<std::size_t>(snap.Mesh.NumberOfPoints()), 0);
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (one.TouchedPoints()[i])
      {
        touched[static_cast<std::size_t>(snap.PointMap[i])] = 1;
      }
    }
    for (SeamVertex& vertex : snap.Vertices)
    {
      vertex.Point = snap.PointMap[static_cast<std::size_t>(vertex.Point)];
    }
    const std::vector<std::int32_t> crossing =
      FindCrossing(snap.Mesh, touched, snap.NumberOfCrossings, executor, monitor);
    snap.Aborted = monitor.Aborted();
    if (crossing.empty() || snap.Aborted)
    {
      break;
    }
    std::vector<std::uint8_t> crosses(touched.size(), 0);
    for (const std::int32_t point : crossing)
    {
      crosses[static_cast<std::size_t>(point)] = 1;
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      caution[i] =
        static_cast<std::uint8_t>(caution[i] + crosses[static_cast<std::size_t>(snap.PointMap[i])]);
    }
  }
  Summarise(snap);
  return snap;
}

} // namespace sb
