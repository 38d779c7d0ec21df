// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCheck.h"

#include "DuplicateCells.h"
#include "Ingest.h"
#include "MeshEdges.h"
#include "Scene.h"
#include "ShellNesting.h"
#include "SoundTriangles.h"
#include "Stages.h"
#include "VertexFans.h"

#include <algorithm>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 1 << 14;

Defect KindOf(const IrregularEdge& edge)
{
  return edge.IsRim()    ? Defect::RimEdge
    : !edge.IsManifold() ? Defect::ManyFoldEdge
                         : Defect::ContradictoryEdge;
}

/** Runs the stages one after the other. */
class CheckRun
{
public:
  CheckRun(const SurfaceCheckRequest& request, Executor& executor, Monitor& monitor)
    : Request(request)
    , Threads(executor)
    , Watch(monitor)
    , Clock(this->Result.Times, monitor)
  {
  }

  SurfaceCheckResult Run()
  {
    if (IsTooLarge(this->Request.Mesh))
    {
      this->Result.Condition = Status::TooLarge;
      return std::move(this->Result);
    }
    const SoundTriangles sound(this->Request.Mesh, this->Request.Cells, this->Threads);
    this->Sound = &sound;
    this->Result.TriangleMarks.resize(std::size_t(this->Request.Mesh.NumberOfTriangles), 0);
    this->Result.ShellOfTriangle.resize(std::size_t(this->Request.Mesh.NumberOfTriangles), -1);
    this->Result.PointMarks.resize(std::size_t(this->Request.Mesh.NumberOfPoints), 0);
    this->MarkUnsound();
    this->Timed("Vertices", 0.05, [&] { this->FindVertices(); });
    this->Timed("Edges", 0.15, [&] { this->FindEdges(); });
    this->Timed("Shells", 0.25, [&] { this->FindAllShells(); });
    this->Timed("Duplicates", 0.35, [&] { this->FindDuplicates(); });
    if (sound.Mesh().NumberOfTriangles > 0)
    {
      this->LookOnLattice();
    }
    if (this->Watch.Aborted())
    {
      this->Result = {};
      this->Result.Condition = Status::Aborted;
      return std::move(this->Result);
    }
    this->Timed("Marks", 0.95, [&] { this->MarkOrientation(); });
    this->Result.Shells = std::move(this->Set.Shells);
    this->Watch.Progress(1.0, "Done");
    return std::move(this->Result);
  }

private:
  template <class Stage>
  void Timed(const char* name, double progress, Stage&& stage)
  {
    if (!this->Watch.Aborted())
    {
      this->Clock.Timed(name, progress, [&] {
        stage();
        return 0;
      });
    }
  }

  void Mark(std::int32_t soundTriangle, Defect defect)
  {
    this->Result.TriangleMarks[std::size_t(this->Sound->Original(soundTriangle))] |= BitOf(defect);
  }

  void MarkPoint(std::int32_t point, Defect defect)
  {
    this->Result.PointMarks[std::size_t(point)] |= BitOf(defect);
  }

  /** Triangles that are not sound are those that no sound one stands for. */
  void MarkUnsound()
  {
    SurfaceCheckCounts& counts = this->Result.Counts;
    counts.BadIndexTriangles = this->Sound->NumberWithBadIndex();
    counts.NotFiniteTriangles = this->Sound->NumberNotFinite();
    const Surface& mesh = this->Request.Mesh;
    for (std::int64_t point = 0; point < mesh.NumberOfPoints; ++point)
    {
      if (!IsFinitePoint(mesh.Points + 3 * point))
      {
        ++counts.NotFinitePoints;
        this->MarkPoint(static_cast<std::int32_t>(point), Defect::NotFinite);
      }
    }
    if (this->Sound->FirstUnsound() < 0)
    {
      return;
    }
    std::vector<std::uint8_t> isSound(this->Result.TriangleMarks.size(), 0);
    for (std::int32_t i = 0; i < this->Sound->Mesh().NumberOfTriangles; ++i)
    {
      isSound[std::size_t(this->Sound->Original(i))] = 1;
    }
    for (std::size_t i = 0; i < isSound.size(); ++i)
    {
      if (!isSound[i])
      {
        this->Result.TriangleMarks[i] = BitOf(this->DefectOfUnsound(i));
      }
    }
  }

  Defect DefectOfUnsound(std::size_t triangle) const
  {
    const std::int32_t* ids = this->Request.Mesh.Triangles + 3 * triangle;
    const bool isBad = std::any_of(ids, ids + 3,
      [this](std::int32_t id) { return id < 0 || id >= this->Request.Mesh.NumberOfPoints; });
    return isBad ? Defect::BadIndex : Defect::NotFinite;
  }

  void FindVertices()
  {
    const Surface& mesh = this->Sound->Mesh();
    this->Fans.Build(mesh, this->Threads);
    this->Corners.resize(std::size_t(3 * mesh.NumberOfTriangles));
    this->Threads.For(3 * mesh.NumberOfTriangles, Grain, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        this->Corners[std::size_t(i)] = this->Fans.VertexOf(mesh.Triangles[i]);
      }
    });
    for (std::int32_t point = 0; point < mesh.NumberOfPoints; ++point)
    {
      const VertexFans::Fan fan = this->Fans.Around(point);
      this->Result.Counts.Vertices += fan.begin() != fan.end();
      if (this->Fans.VertexOf(point) != point)
      {
        ++this->Result.Counts.DuplicatePoints;
        this->MarkPoint(point, Defect::Duplicate);
      }
    }
  }

  void FindEdges()
  {
    this->Use =
      FindMeshEdges(this->Corners, this->Sound->Mesh().NumberOfPoints, this->Fans, this->Threads);
    std::int32_t last = -1;
    for (const FurtherFan& fan : this->Use.FurtherFans)
    {
      if (fan.Vertex != last)
      {
        last = fan.Vertex;
        this->Result.TouchingVertices.push_back(last);
      }
    }
    this->Result.Counts.TouchingVertices =
      static_cast<std::int64_t>(this->Result.TouchingVertices.size());
  }

  void FindAllShells()
  {
    this->Set =
      FindShells(this->Sound->Mesh(), this->Corners, this->Fans, this->Use, this->Threads);
    for (std::size_t i = 0; i < this->Set.OfTriangle.size(); ++i)
    {
      const auto triangle = static_cast<std::int32_t>(i);
      this->Result.ShellOfTriangle[std::size_t(this->Sound->Original(triangle))] =
        this->Set.OfTriangle[i];
    }
    for (const Shell& shell : this->Set.Shells)
    {
      this->Result.Counts.Edges += shell.NumberOfEdges;
      this->Result.Counts.ClosedShells += shell.IsClosed;
      this->Result.Counts.OneSidedShells += !shell.IsOrientable;
    }
    this->Result.Counts.Rims = this->Set.NumberOfRims;
    this->ListDefectEdges();
    this->MarkVertices();
  }

  void ListDefectEdges()
  {
    SurfaceCheckCounts& counts = this->Result.Counts;
    for (std::size_t i = 0; i < this->Use.Irregular.size(); ++i)
    {
      const IrregularEdge& edge = this->Use.Irregular[i];
      const HalfEdge* const uses = this->Use.Uses.data() + edge.FirstUse;
      DefectEdge found{ KindOf(edge), {}, {}, edge.NumberOfUses, this->Set.RimOfEdge[i] };
      const std::int32_t* const corners = this->Sound->Mesh().Triangles + 3 * (uses[0] / 3);
      found.Points = { corners[uses[0] % 3], corners[(uses[0] + 1) % 3] };
      found.Triangles = { this->Sound->Original(uses[0] / 3),
        edge.NumberOfUses > 1 ? this->Sound->Original(uses[1] / 3) : -1 };
      for (std::int32_t use = 0; use < edge.NumberOfUses; ++use)
      {
        this->Mark(uses[use] / 3, found.Kind);
      }
      counts.RimEdges += edge.IsRim();
      counts.ManyFoldEdges += !edge.IsManifold();
      counts.ContradictoryEdges += edge.IsContradiction();
      this->Result.Edges.push_back(found);
    }
    // A Boolean looks for contradictions first.
    this->Result.IsContradictory = counts.ContradictoryEdges > 0;
  }

  /** All points at the place of a marked vertex. */
  void MarkVertices()
  {
    const std::int64_t count = this->Request.Mesh.NumberOfPoints;
    std::vector<std::uint16_t> marks(
      this->Use.Irregular.empty() && this->Use.FurtherFans.empty() ? 0 : std::size_t(count));
    if (marks.empty())
    {
      return;
    }
    std::vector<std::int32_t> rims(std::size_t(count), -1);
    for (const DefectEdge& edge : this->Result.Edges)
    {
      for (const std::int32_t point : edge.Points)
      {
        const auto vertex = std::size_t(this->Fans.VertexOf(point));
        marks[vertex] |= BitOf(edge.Kind);
        rims[vertex] = edge.Rim >= 0 && rims[vertex] < 0 ? edge.Rim : rims[vertex];
      }
    }
    for (const std::int32_t vertex : this->Result.TouchingVertices)
    {
      marks[std::size_t(vertex)] |= BitOf(Defect::TouchingVertex);
    }
    this->Result.RimOfPoint.resize(std::size_t(count));
    for (std::int32_t point = 0; point < count; ++point)
    {
      const auto vertex = std::size_t(this->Fans.VertexOf(point));
      this->Result.PointMarks[std::size_t(point)] |= marks[vertex];
      this->Result.RimOfPoint[std::size_t(point)] = rims[vertex];
    }
  }

  void FindDuplicates()
  {
    const CellRuns& cells = this->Sound->Cells();
    this->FirstCopies = FindDuplicateCells(this->Corners, cells, this->Use, this->Threads);
    for (std::size_t cell = 0; cell < this->FirstCopies.size(); ++cell)
    {
      if (this->FirstCopies[cell] != static_cast<std::int32_t>(cell))
      {
        ++this->Result.Counts.DuplicateCells;
        for (std::int32_t i = cells.First(std::int64_t(cell));
             i < cells.First(std::int64_t(cell) + 1); ++i)
        {
          this->Mark(i, Defect::Duplicate);
        }
      }
    }
  }

  /** What is decided with integers. */
  void LookOnLattice()
  {
    BooleanRequest surface;
    surface.Operands.push_back({ this->Sound->Mesh(), Group::Input, nullptr });
    Ingested ingested;
    this->Timed("Measures", 0.4, [&] {
      surface.Operands[0].Known = Examine(this->Sound->Mesh(), this->Threads, OpenSurfaces::Accept);
      ingested = Ingest(surface, this->Threads);
      this->Result.Report = ingested.Reports[0];
      this->Result.IsInsideOut = ingested.Swapped[0] != 0;
      ingested.Swapped[0] = 0; // it is looked at as it is
    });
    if (this->Watch.Aborted())
    {
      return;
    }
    const Scene scene(surface, ingested, this->Threads);
    this->Timed("Areas", 0.45, [&] { this->FindWithoutArea(scene); });
    this->Timed("Nesting", 0.5,
      [&] { FindNesting(scene, this->Collapsed, this->Set, this->Threads, this->Watch); });
    if (this->Request.SelfIntersections)
    {
      this->Timed("Self-intersections", 0.6, [&] { this->FindMeetings(scene); });
    }
  }

  void FindWithoutArea(const Scene& scene)
  {
    this->Collapsed = FindFacesWithoutArea(scene, this->Threads);
    for (std::size_t i = 0; i < this->Collapsed.size(); ++i)
    {
      if (this->Collapsed[i])
      {
        ++this->Result.Counts.WithoutArea;
        this->Mark(static_cast<std::int32_t>(i), Defect::NoArea);
      }
    }
  }

  void FindMeetings(const Scene& scene)
  {
    SelfIntersections found = FindSelfIntersections(
      { scene, this->Corners, this->Use, this->Collapsed, this->Sound->Cells(), this->FirstCopies },
      this->Threads, this->Watch);
    this->Result.Counts.SelfIntersections = static_cast<std::int64_t>(found.Pairs.size());
    if (found.Pairs.empty())
    {
      return;
    }
    this->Result.MeetingsOfTriangle.resize(this->Result.TriangleMarks.size(), 0);
    for (const std::array<std::int32_t, 2>& pair : found.Pairs)
    {
      for (const std::int32_t triangle : pair)
      {
        ++this->Result.MeetingsOfTriangle[std::size_t(this->Sound->Original(triangle))];
        this->Mark(triangle, Defect::SelfIntersection);
      }
    }
    for (SelfContact& contact : found.Contacts)
    {
      contact.Triangles = { this->Sound->Original(contact.Triangles[0]),
        this->Sound->Original(contact.Triangles[1]) };
    }
    this->Result.SelfContacts = std::move(found.Contacts);
  }

  void MarkOrientation()
  {
    SurfaceCheckCounts& counts = this->Result.Counts;
    for (const Shell& shell : this->Set.Shells)
    {
      counts.InvertedShells += shell.IsClosed && shell.WindingInFront < 0;
      counts.CoveredShells += shell.IsClosed && shell.WindingInFront > 0;
    }
    if (counts.InvertedShells == 0 && this->Set.IsFlipped.empty())
    {
      return;
    }
    for (std::size_t i = 0; i < this->Set.OfTriangle.size(); ++i)
    {
      const std::int32_t shell = this->Set.OfTriangle[i];
      const bool isFlipped = !this->Set.IsFlipped.empty() && this->Set.IsFlipped[i];
      const bool isInverted = shell >= 0 && this->Set.Shells[std::size_t(shell)].IsClosed &&
        this->Set.Shells[std::size_t(shell)].WindingInFront < 0;
      if (isFlipped || isInverted)
      {
        ++counts.WrongWayTriangles;
        this->Mark(static_cast<std::int32_t>(i), Defect::WrongWay);
      }
    }
  }

  const SurfaceCheckRequest& Request;
  Executor& Threads;
  Monitor& Watch;
  SurfaceCheckResult Result;
  StageClock Clock;
  const SoundTriangles* Sound = nullptr;
  VertexFans Fans;
  std::vector<std::int32_t> Corners; ///< three vertices a sound triangle
  MeshEdges Use;
  ShellSet Set;
  std::vector<std::int32_t> FirstCopies; ///< [cell]
  std::vector<std::uint8_t> Collapsed; ///< [sound triangle]
};

} // namespace

std::int64_t SurfaceCheckResult::Genus() const
{
  std::int64_t sum = 0;
  for (const Shell& shell : this->Shells)
  {
    if (shell.Genus < 0)
    {
      return -1;
    }
    sum += shell.Genus;
  }
  return sum;
}

SurfaceCheckResult CheckSurface(
  const SurfaceCheckRequest& request, Executor& executor, Monitor& monitor)
{
  return CheckRun(request, executor, monitor).Run();
}

} // namespace sb
