// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Clip.h"

#include "CapContours.h"
#include "CapFilling.h"
#include "CellClip.h"
#include "CellGroups.h"
#include "CellOutline.h"
#include "ClipPoints.h"
#include "FaceClip.h"
#include "FaceRemainder.h"
#include "Ingest.h"
#include "ManifoldEdges.h"
#include "PlaneOnLattice.h"
#include "PolygonCutting.h"
#include "Stages.h"
#include "VertexSides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace sb
{

namespace
{

constexpr std::int64_t grain = 1 << 14;

double AreaOf(const double* a, const double* b, const double* c)
{
  const double p[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double q[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  return std::hypot(std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2]),
           p[0] * q[1] - p[1] * q[0]) /
    2.0;
}

class Clipper
{
public:
  Clipper(const ClipRequest& request, Executor& executor, Monitor& monitor)
    : Request(request)
    , Mesh(request.Mesh)
    , Threads(executor)
    , Laps(this->Result.Times, this->Result.Remarks, monitor)
  {
  }

  ClipResult Run()
  {
    const bool good = this->Check() && this->FindSides() && this->FindFates() && this->CutFaces() &&
      this->MakeCaps() && this->MakeOutput();
    this->Result.Condition = GravestCondition(this->Result.Remarks);
    if (!good)
    {
      ClipResult empty;
      empty.Condition = this->Result.Condition;
      empty.Remarks = this->Result.Remarks;
      return empty;
    }
    return std::move(this->Result);
  }

private:
  /** Both ends, on the lattice, the lower one first. */
  using EdgePlace = std::pair<std::array<double, 3>, std::array<double, 3>>;

  Remark& Add(Status condition)
  {
    this->Result.Remarks.emplace_back();
    this->Result.Remarks.back().Condition = condition;
    return this->Result.Remarks.back();
  }

  bool Check()
  {
    if (IsTooLarge(this->Mesh))
    {
      this->Add(Status::TooLarge);
      return false;
    }
    const bool goodPlanes =
      std::all_of(this->Request.Planes.begin(), this->Request.Planes.end(), IsPlane);
    if (!goodPlanes)
    {
      this->Add(Status::BadRequest);
      return false;
    }
    return true;
  }

  bool FindSides()
  {
    const MeshBounds bounds = FindBounds(this->Mesh, this->Threads);
    std::vector<ClipPlane> planes = this->Request.Planes;
    this->IsRest = this->Request.InsideOut && planes.size() != 1;
    if (this->Request.InsideOut && planes.size() == 1)
    {
      // What is not in front of one plane is in front of the opposite one.
      for (double& component : planes[0].Normal)
      {
        component = -component;
      }
    }
    this->Grid = PlaceOnLattice(bounds, planes);
    for (const ClipPlane& plane : planes)
    {
      this->Planes.emplace_back(plane, this->Grid);
    }
    this->Sides = FindVertexSides(this->Mesh, this->Grid, this->Planes, this->Threads);
    return this->Laps.End("Sides", 0.3);
  }

  bool FindFates()
  {
    this->Result.Fates.resize(std::size_t(this->Mesh.NumberOfTriangles));
    const FaceSides faces = FindFaceSides(this->Mesh, this->Sides, this->Planes.size(),
      this->IsRest, this->Result.Fates, this->Threads);
    if (faces.BadIndex >= 0)
    {
      this->Add(Status::BadIndex).Triangle = faces.BadIndex;
      return false;
    }
    if (faces.BadCoordinate >= 0)
    {
      this->Add(Status::BadCoordinate).Triangle = faces.BadCoordinate;
      return false;
    }
    this->Touched = faces.Touched;
    this->NumberKept();
    return this->Laps.End("Fates", 0.6);
  }

  /** Give the points that are kept their ids. */
  void NumberKept()
  {
    const std::int64_t count = this->Mesh.NumberOfPoints;
    const std::int64_t blocks = (count + grain - 1) / grain;
    std::vector<std::int64_t> firsts(std::size_t(blocks) + 1, 0);
    const auto forEach = [&](auto&& body) {
      this->Threads.For(blocks, 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end; ++block)
        {
          body(block, block * grain, std::min(count, (block + 1) * grain));
        }
      });
    };
    forEach([&](std::int64_t block, std::int64_t begin, std::int64_t end) {
      std::int64_t kept = 0;
      for (std::int64_t i = begin; i < end; ++i)
      {
        kept += this->Sides.IsKept(i, this->IsRest);
      }
      firsts[std::size_t(block) + 1] = kept;
    });
    for (std::size_t block = 0; block < std::size_t(blocks); ++block)
    {
      firsts[block + 1] += firsts[block];
    }
    this->Result.PointMap.resize(std::size_t(count));
    this->Result.KeptPoints.resize(std::size_t(firsts.back()));
    forEach([&](std::int64_t block, std::int64_t begin, std::int64_t end) {
      std::int32_t next = static_cast<std::int32_t>(firsts[std::size_t(block)]);
      for (std::int64_t i = begin; i < end; ++i)
      {
        const bool kept = this->Sides.IsKept(i, this->IsRest);
        this->Result.PointMap[std::size_t(i)] = kept ? next : -1;
        if (kept)
        {
          this->Result.KeptPoints[std::size_t(next++)] = static_cast<std::int32_t>(i);
        }
      }
    });
  }

  void CutFace(FaceClip& clip, std::int32_t face)
  {
    const std::vector<FaceClip::Corner>& polygon = clip.Clip(face, this->Contours);
    if (polygon.size() > 2 ||
      (this->IsRest && this->Result.Fates[std::size_t(face)] == Fate::Split))
    {
      this->PolygonFaces.push_back(face);
      this->PolygonCorners.insert(this->PolygonCorners.end(), polygon.begin(), polygon.end());
      this->PolygonEnds.push_back(this->PolygonCorners.size());
    }
  }

  void CutCell(CellClip& cell, std::int32_t first, std::int32_t last)
  {
    std::vector<std::int32_t> faces;
    for (std::int32_t face = first; face < last; ++face)
    {
      if (this->Result.Fates[std::size_t(face)] != Fate::Dropped)
      {
        faces.push_back(face);
        this->Result.Fates[std::size_t(face)] = Fate::Split;
      }
    }
    const std::vector<CellSide>& sides = cell.Run(faces, first, last, this->Contours);
    if (!sides.empty())
    {
      this->CellFaces.push_back(first);
      this->CellSides.insert(this->CellSides.end(), sides.begin(), sides.end());
      this->CellEnds.push_back(this->CellSides.size());
    }
  }

  bool CutFaces()
  {
    this->Points.reset(new ClipPoints(this->Mesh, this->Grid, this->Planes));
    this->Contours.resize(this->Planes.size());
    FaceClip clip(*this->Points);
    CellClip cell(*this->Points, clip);
    VisitCells(this->Touched, this->Request.FirstTriangles, this->Request.NumberOfCells,
      [&](auto begin, auto end, std::int32_t first, std::int32_t last) {
        if (last - first > 1 && !this->IsRest && cell.IsFlat(first, last))
        {
          this->CutCell(cell, first, last);
          return;
        }
        std::for_each(begin, end, [&](std::int32_t face) { this->CutFace(clip, face); });
      });
    return this->Laps.End("Cuts", 0.7);
  }

  bool MakeCaps()
  {
    const OpenContourCount open = CompleteContours(*this->Points, this->Contours, this->Splits);
    this->Result.JoinedContours = open.Joined;
    this->Result.OpenContours = open.Removed;
    for (std::int32_t plane = 0; plane < this->Points->NumberOfPlanes(); ++plane)
    {
      this->FillCap(plane);
    }
    return this->Laps.End("Caps", 0.9);
  }

  void FillCap(std::int32_t plane)
  {
    const CapFilling cap = FillCapContour(
      *this->Points, plane, this->Contours[std::size_t(plane)], FillRule::Winding, this->Splits);
    for (std::size_t i = 0; i < cap.Triangles.size(); ++i)
    {
      this->CapInstances.push_back(cap.Triangles[i]);
      this->Result.PlaneOfCap.push_back(plane);
    }
  }

  bool MakeOutput()
  {
    if (this->IsRest)
    {
      this->ListPointsOnEdges();
    }
    for (std::size_t i = 0; i < this->PolygonFaces.size(); ++i)
    {
      this->IsRest ? this->AddRemainder(i) : this->AddPieces(i);
      this->Result.Parents.resize(this->Result.Pieces.size(), this->PolygonFaces[i]);
    }
    for (std::size_t i = 0; i < this->CellFaces.size(); ++i)
    {
      this->AddPiecesOfCell(i);
      this->Result.Parents.resize(this->Result.Pieces.size(), this->CellFaces[i]);
    }
    this->RemoveCollapsed();
    for (const std::array<std::int32_t, 3>& triangle : this->CapInstances)
    {
      // The rest of the solid lies on the other side of the caps.
      this->Result.Caps.push_back(
        { this->IdOfInstance(triangle[0]), this->IdOfInstance(triangle[this->IsRest ? 2 : 1]),
          this->IdOfInstance(triangle[this->IsRest ? 1 : 2]) });
    }
    for (std::size_t plane = 0; plane < this->Contours.size(); ++plane)
    {
      for (const Segment& segment : this->Contours[plane])
      {
        this->Result.Outline.push_back(
          { { this->IdOfInstance(segment.From), this->IdOfInstance(segment.To) },
            static_cast<std::int32_t>(plane) });
      }
    }
    this->Separate();
    this->MeasureCaps();
    return this->Laps.End("Pieces", 1.0);
  }

  void MeasureCaps()
  {
    this->Result.CapAreas.assign(this->Planes.size(), 0.0);
    for (std::size_t i = 0; i < this->Result.Caps.size(); ++i)
    {
      const std::array<std::int32_t, 3>& cap = this->Result.Caps[i];
      this->Result.CapAreas[std::size_t(this->Result.PlaneOfCap[i])] +=
        AreaOf(this->PlaceOf(cap[0]), this->PlaceOf(cap[1]), this->PlaceOf(cap[2]));
    }
  }

  /** Contacts along edges: on pieces and caps together. */
  void Separate()
  {
    std::vector<std::array<std::int32_t, 3>> all = this->Result.Pieces;
    all.insert(all.end(), this->Result.Caps.begin(), this->Result.Caps.end());
    const auto firstPoint = static_cast<std::int32_t>(this->Result.KeptPoints.size());
    const std::vector<std::int32_t> copies =
      SeparateContacts(all, static_cast<std::int64_t>(this->Result.Pieces.size()), firstPoint,
        firstPoint + static_cast<std::int32_t>(this->Result.Created.size()));
    for (const std::int32_t point : copies)
    {
      const InterpolatedPoint copy = this->Result.Created[std::size_t(point - firstPoint)];
      this->Result.Created.push_back(copy);
    }
    const auto firstCap = all.begin() + static_cast<std::ptrdiff_t>(this->Result.Pieces.size());
    std::copy(all.begin(), firstCap, this->Result.Pieces.begin());
    std::copy(firstCap, all.end(), this->Result.Caps.begin());
  }

  /** The id in the result of a point on a plane. */
  std::int32_t IdOfInstance(std::int32_t instance)
  {
    if (this->Request.Seams == SeamPoints::Shared)
    {
      instance = this->Points->Instance(this->Points->Node(instance));
    }
    const auto size = static_cast<std::size_t>(this->Points->NumberOfInstances());
    this->IdOfInstances.resize(std::max(size, this->IdOfInstances.size()), -1);
    std::int32_t& id = this->IdOfInstances[std::size_t(instance)];
    if (id < 0)
    {
      id = static_cast<std::int32_t>(this->Result.KeptPoints.size() + this->Result.Created.size());
      this->Result.Created.push_back(this->Points->Output(instance));
    }
    return id;
  }

  std::int32_t IdOf(const FaceClip::Corner& corner)
  {
    return corner.Instance >= 0 ? this->IdOfInstance(corner.Instance)
                                : this->Result.PointMap[std::size_t(corner.Vertex)];
  }

  const double* PlaceOf(std::int32_t id) const
  {
    const auto firstCreated = static_cast<std::int32_t>(this->Result.KeptPoints.size());
    return id >= firstCreated
      ? this->Result.Created[std::size_t(id - firstCreated)].Position.data()
      : this->Mesh.Points + 3 * std::int64_t(this->Result.KeptPoints[std::size_t(id)]);
  }

  /** A triangle whose corners became one point adds nothing to any edge: leave it out. */
  void RemoveCollapsed()
  {
    std::size_t next = 0;
    for (std::size_t i = 0; i < this->Result.Pieces.size(); ++i)
    {
      const std::array<std::int32_t, 3> t = this->Result.Pieces[i];
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        this->Result.Parents[next] = this->Result.Parents[i];
        this->Result.Pieces[next++] = t;
      }
    }
    this->Result.Pieces.resize(next);
    this->Result.Parents.resize(next);
  }

  /** Cut what is left of a triangle into triangles. */
  void AddPieces(std::size_t polygon)
  {
    const std::size_t begin = polygon == 0 ? 0 : this->PolygonEnds[polygon - 1];
    const std::size_t end = this->PolygonEnds[polygon];
    this->Outline.Clear();
    for (std::size_t i = begin; i < end; ++i)
    {
      const FaceClip::Corner& corner = this->PolygonCorners[i];
      const FaceClip::Corner& next = this->PolygonCorners[i + 1 == end ? begin : i + 1];
      this->Outline.Add(this->IdOf(corner), false);
      if (!this->Splits.empty() && corner.Instance >= 0 && next.Instance >= 0)
      {
        this->SplitNodes.clear();
        AppendSplit(this->Splits, this->Points->Node(corner.Instance),
          this->Points->Node(next.Instance), this->SplitNodes);
        for (std::size_t k = 1; k + 1 < this->SplitNodes.size(); ++k)
        {
          this->Outline.Add(this->IdOfInstance(this->Points->Instance(this->SplitNodes[k])), true);
        }
      }
    }
    this->Outline.Cut([this](std::int32_t id) { return this->PlaceOf(id); }, this->Result.Pieces);
  }

  /** Cut what is left of a flat cell into triangles. */
  void AddPiecesOfCell(std::size_t cell)
  {
    const std::array<std::int32_t, 3> corners = this->Points->Corners(this->CellFaces[cell]);
    CellOutline outline(ComputeDominantNormal(this->Points->Position(corners[0]).data(),
      this->Points->Position(corners[1]).data(), this->Points->Position(corners[2]).data()));
    for (std::size_t i = cell == 0 ? 0 : this->CellEnds[cell - 1]; i < this->CellEnds[cell]; ++i)
    {
      const CellSide& side = this->CellSides[i];
      this->SplitNodes.clear();
      if (side.From.Instance >= 0 && side.To.Instance >= 0)
      {
        AppendSplit(this->Splits, this->Points->Node(side.From.Instance),
          this->Points->Node(side.To.Instance), this->SplitNodes);
      }
      std::int32_t from = this->AddTo(outline, side.From);
      for (std::size_t k = 1; k + 1 < this->SplitNodes.size(); ++k)
      {
        const std::int32_t between =
          this->AddTo(outline, { -1, this->Points->Instance(this->SplitNodes[k]) });
        outline.AddSide(from, between);
        from = between;
      }
      outline.AddSide(from, this->AddTo(outline, side.To));
    }
    outline.Cut([this](std::int32_t id) { return this->PlaceOf(id); }, this->Result.Pieces);
  }

  /** A corner of an outline: its id in the result. */
  std::int32_t AddTo(CellOutline& outline, const FaceClip::Corner& corner)
  {
    const std::int32_t id = this->IdOf(corner);
    if (corner.Instance >= 0)
    {
      outline.AddPoint(id, this->Points->Point(this->Points->Node(corner.Instance)));
    }
    else
    {
      outline.AddPoint(id, ExactPoint::Vertex(this->Points->Position(corner.Vertex).data()));
    }
    return id;
  }

  /** An edge by where it is: neighbours need not share its vertices. */
  EdgePlace PlaceOfEdge(std::int32_t from, std::int32_t to) const
  {
    const std::array<double, 3> a = this->Points->Position(from);
    const std::array<double, 3> b = this->Points->Position(to);
    return a < b ? EdgePlace(a, b) : EdgePlace(b, a);
  }

  /** What neighbours put on edges, a triangle has to have on its side, too. */
  void ListPointsOnEdges()
  {
    std::array<std::int32_t, 2> edge;
    for (const FaceClip::Corner& corner : this->PolygonCorners)
    {
      if (corner.Instance >= 0 && this->Points->IsOnEdge(corner.Instance, edge))
      {
        std::vector<std::int32_t>& planes =
          this->PlanesOnEdges[this->PlaceOfEdge(edge[0], edge[1])];
        const std::int32_t plane = this->Points->PlaneOnEdge(corner.Instance);
        if (std::find(planes.begin(), planes.end(), plane) == planes.end())
        {
          planes.push_back(plane);
        }
      }
    }
  }

  FaceRemainder::Point PointOf(std::int32_t instance)
  {
    return { &this->Points->Point(this->Points->Node(instance)), this->IdOfInstance(instance) };
  }

  /** Cut what the part in front of all planes leaves of a triangle into triangles. */
  void AddRemainder(std::size_t polygon)
  {
    const std::int32_t face = this->PolygonFaces[polygon];
    const std::array<std::int32_t, 3> vertices = this->Points->Corners(face);
    std::array<ExactPoint, 3> places;
    std::array<FaceRemainder::Point, 3> corners;
    std::vector<FaceRemainder::Point> onEdges;
    for (std::size_t k = 0; k < 3; ++k)
    {
      places[k] = ExactPoint::Vertex(this->Points->Position(vertices[k]).data());
      corners[k] = { &places[k], this->IdOfVertex(vertices[k]) };
      const std::int32_t next = vertices[(k + 1) % 3];
      const auto found = this->PlanesOnEdges.find(this->PlaceOfEdge(vertices[k], next));
      for (std::size_t i = 0; found != this->PlanesOnEdges.end() && i < found->second.size(); ++i)
      {
        onEdges.push_back(this->PointOf(this->Points->OnEdge(vertices[k], next, found->second[i])));
      }
    }
    this->Remainder.Cut(
      corners, onEdges, this->PartOf(polygon, vertices, places), this->Result.Pieces);
  }

  /** The id of a triangle's corner; -1 where it lies in front of all planes. */
  std::int32_t IdOfVertex(std::int32_t vertex)
  {
    const VertexSides::Word word = this->Sides.Of(vertex);
    const bool isOnPlane =
      (word & VertexSides::NotInFront) != 0 && (word & VertexSides::Behind) == 0;
    return isOnPlane ? this->IdOfInstance(this->Points->AtVertex(vertex))
                     : this->Result.PointMap[std::size_t(vertex)];
  }

  std::vector<FaceRemainder::Point> PartOf(std::size_t polygon,
    const std::array<std::int32_t, 3>& vertices, const std::array<ExactPoint, 3>& places)
  {
    const std::size_t begin = polygon == 0 ? 0 : this->PolygonEnds[polygon - 1];
    const std::size_t end = this->PolygonEnds[polygon];
    std::vector<FaceRemainder::Point> part;
    for (std::size_t i = begin; i < end; ++i)
    {
      const FaceClip::Corner& corner = this->PolygonCorners[i];
      const FaceClip::Corner& next = this->PolygonCorners[i + 1 == end ? begin : i + 1];
      if (corner.Instance < 0)
      {
        const auto k =
          std::find(vertices.begin(), vertices.end(), corner.Vertex) - vertices.begin();
        part.push_back({ &places[std::size_t(k)], -1 });
        continue;
      }
      part.push_back(this->PointOf(corner.Instance));
      if (next.Instance >= 0)
      {
        this->SplitNodes.clear();
        AppendSplit(this->Splits, this->Points->Node(corner.Instance),
          this->Points->Node(next.Instance), this->SplitNodes);
        for (std::size_t k = 1; k + 1 < this->SplitNodes.size(); ++k)
        {
          part.push_back(this->PointOf(this->Points->Instance(this->SplitNodes[k])));
        }
      }
    }
    return part;
  }

  const ClipRequest& Request;
  const Surface& Mesh;
  Executor& Threads;
  ClipResult Result;
  StageLaps Laps;

  Lattice Grid;
  std::vector<HalfSpace> Planes;
  VertexSides Sides;
  std::vector<std::int32_t> Touched;
  std::unique_ptr<ClipPoints> Points;
  std::vector<Contour> Contours; ///< by plane
  SplitSegments Splits;
  std::vector<std::int32_t> PolygonFaces;
  std::vector<FaceClip::Corner> PolygonCorners;
  std::vector<std::size_t> PolygonEnds;
  std::vector<std::int32_t> CellFaces; ///< by flat cell that is cut: its first triangle
  std::vector<CellSide> CellSides;
  std::vector<std::size_t> CellEnds;
  std::vector<std::array<std::int32_t, 3>> CapInstances;
  std::vector<std::int32_t> IdOfInstances;
  ConvexOutline Outline;
  bool IsRest = false; ///< kept is what several planes leave, which is not convex
  std::map<EdgePlace, std::vector<std::int32_t>> PlanesOnEdges; ///< those that cut there
  FaceRemainder Remainder;
  std::vector<std::int32_t> SplitNodes;
};

} // namespace

ClipResult ClipSurface(const ClipRequest& request, Executor& executor, Monitor& monitor)
{
  return Clipper(request, executor, monitor).Run();
}

} // namespace sb
