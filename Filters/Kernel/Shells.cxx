// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shells.h"

#include "DisjointSets.h"
#include "FlippedTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 1 << 13;

/** What triangles or vertices that follow each other in one shell add to it. */
struct ShellRun
{
  std::int32_t Shell;
  std::int64_t Count = 0;
  double Volume = 0.0;
  double Area = 0.0;
  Box Bounds{};
};

class ShellFinder
{
public:
  ShellFinder(const Surface& mesh, const std::vector<std::int32_t>& corners, const VertexFans& fans,
    const MeshEdges& edges, Executor& executor)
    : Mesh(mesh)
    , Corners(corners)
    , Fans(fans)
    , Edges(edges)
    , Threads(executor)
    , Sets(static_cast<std::int32_t>(mesh.NumberOfTriangles))
  {
  }

  ShellSet Run()
  {
    this->JoinMates();
    FlippedTriangles flipped = FindFlippedTriangles(this->Sets, this->Edges);
    this->JoinIrregular();
    this->NumberShells();
    this->CountEdges();
    this->FindRims();
    this->CountVertices();
    this->Measure();
    for (const std::int32_t triangle : flipped.OneSided)
    {
      this->ShellOf(triangle).IsOrientable = false;
    }
    this->Result.IsFlipped = std::move(flipped.IsFlipped);
    this->CountHandles();
    return std::move(this->Result);
  }

private:
  Shell& ShellOf(std::int32_t triangle)
  {
    return this->Result.Shells[std::size_t(this->Result.OfTriangle[std::size_t(triangle)])];
  }

  std::int32_t TriangleAt(const IrregularEdge& edge) const
  {
    return this->Edges.Uses[std::size_t(edge.FirstUse)] / 3;
  }

  void JoinMates()
  {
    const auto count = static_cast<HalfEdge>(this->Edges.Mates.size());
    for (HalfEdge half = 0; half < count; ++half)
    {
      if (this->Edges.Mates[std::size_t(half)] > half)
      {
        this->Sets.Unite(half / 3, this->Edges.Mates[std::size_t(half)] / 3);
      }
    }
  }

  void JoinIrregular()
  {
    for (const IrregularEdge& edge : this->Edges.Irregular)
    {
      for (std::int32_t use = 1; use < edge.NumberOfUses; ++use)
      {
        this->Sets.Unite(
          this->TriangleAt(edge), this->Edges.Uses[std::size_t(edge.FirstUse + use)] / 3);
      }
    }
  }

  /** A set is named by its first triangle, so that numbers go up with those. */
  void NumberShells()
  {
    std::vector<std::int32_t>& shells = this->Result.OfTriangle;
    shells.resize(std::size_t(this->Mesh.NumberOfTriangles));
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(shells.size()); ++i)
    {
      const std::int32_t root = this->Sets.Find(i);
      if (IsPinched(this->Corners.data() + 3 * std::size_t(i)))
      {
        shells[std::size_t(i)] = -1;
      }
      else if (root == i)
      {
        shells[std::size_t(i)] = static_cast<std::int32_t>(this->Result.Shells.size());
        this->Result.Shells.emplace_back();
        this->Result.Shells.back().FirstTriangle = i;
      }
      else
      {
        shells[std::size_t(i)] = shells[std::size_t(root)];
      }
    }
  }

  /** An edge of two triangles is half an edge for each; what others differ from that. */
  void CountEdges()
  {
    for (const IrregularEdge& edge : this->Edges.Irregular)
    {
      Shell& shell = this->ShellOf(this->TriangleAt(edge));
      shell.NumberOfEdges += 2 - edge.NumberOfUses;
      shell.IsClosed = shell.IsClosed && edge.Balance == 0;
      shell.IsManifold = shell.IsManifold && edge.IsManifold();
    }
  }

  void FindRims()
  {
    std::vector<std::pair<HalfEdge, std::int32_t>> rims; // and their irregular edges
    const auto count = static_cast<std::int32_t>(this->Edges.Irregular.size());
    for (std::int32_t i = 0; i < count; ++i)
    {
      const IrregularEdge& edge = this->Edges.Irregular[std::size_t(i)];
      if (edge.IsRim())
      {
        rims.emplace_back(this->Edges.Uses[std::size_t(edge.FirstUse)], i);
      }
    }
    std::sort(rims.begin(), rims.end());
    const auto placeOf = [&rims](HalfEdge half) {
      return static_cast<std::int32_t>(
        std::lower_bound(rims.begin(), rims.end(), std::make_pair(half, 0)) - rims.begin());
    };
    DisjointSets loops(static_cast<std::int32_t>(rims.size()));
    for (const std::array<HalfEdge, 2>& join : this->Edges.RimJoins)
    {
      loops.Unite(placeOf(join[0]), placeOf(join[1]));
    }
    this->Result.RimOfEdge.assign(std::size_t(count), -1);
    for (std::int32_t place = 0; place < loops.Size(); ++place)
    {
      const auto [half, edge] = rims[std::size_t(place)];
      const std::int32_t root = loops.Find(place);
      if (root == place)
      {
        ++this->ShellOf(half / 3).NumberOfRims;
        this->Result.RimOfEdge[std::size_t(edge)] = this->Result.NumberOfRims++;
      }
      else
      {
        this->Result.RimOfEdge[std::size_t(edge)] =
          this->Result.RimOfEdge[std::size_t(rims[std::size_t(root)].second)];
      }
    }
  }

  /** Let add(i, run of its shell) look at each of `count` items; shellOf(i) < 0 leaves one out. */
  template <class ShellOfItem, class Add, class Take>
  void Gather(std::int64_t count, ShellOfItem&& shellOf, Add&& add, Take&& take)
  {
    std::vector<std::vector<ShellRun>> parts(std::size_t((count + Grain - 1) / Grain));
    this->Threads.For(
      static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t part = begin; part < end; ++part)
        {
          std::vector<ShellRun>& runs = parts[std::size_t(part)];
          for (std::int64_t i = part * Grain; i < std::min(count, (part + 1) * Grain); ++i)
          {
            const std::int32_t shell = shellOf(i);
            if (shell < 0)
            {
              continue;
            }
            if (runs.empty() || runs.back().Shell != shell)
            {
              runs.push_back({ shell });
            }
            add(i, runs.back());
          }
        }
      });
    for (const std::vector<ShellRun>& runs : parts)
    {
      for (const ShellRun& run : runs)
      {
        take(this->Result.Shells[std::size_t(run.Shell)], run);
      }
    }
  }

  void CountVertices()
  {
    this->Gather(
      this->Mesh.NumberOfPoints,
      [this](std::int64_t vertex) {
        for (const std::int32_t triangle : this->Fans.Around(static_cast<std::int32_t>(vertex)))
        {
          if (this->Result.OfTriangle[std::size_t(triangle)] >= 0)
          {
            return this->Result.OfTriangle[std::size_t(triangle)];
          }
        }
        return -1;
      },
      [](std::int64_t, ShellRun& run) { ++run.Count; },
      [](Shell& shell, const ShellRun& run) { shell.NumberOfVertices += run.Count; });
    for (const FurtherFan& fan : this->Edges.FurtherFans)
    {
      ++this->ShellOf(fan.Triangle).NumberOfVertices;
    }
  }

  void Measure()
  {
    this->Gather(
      this->Mesh.NumberOfTriangles,
      [this](std::int64_t i) { return this->Result.OfTriangle[std::size_t(i)]; },
      [this](std::int64_t i, ShellRun& run) { this->AddTriangle(i, run); },
      [](Shell& shell, const ShellRun& run) {
        shell.NumberOfTriangles == 0 ? void(shell.Bounds = run.Bounds)
                                     : Enclose(shell.Bounds, run.Bounds);
        shell.NumberOfTriangles += run.Count;
        shell.Volume += run.Volume / 6.0;
        shell.Area += run.Area / 2.0;
      });
  }

  const double* CornerOf(std::int64_t triangle, int corner) const
  {
    return this->Mesh.Points + 3 * std::int64_t(this->Mesh.Triangles[3 * triangle + corner]);
  }

  /** Volumes are measured from a point of the shell, where least is lost by rounding. */
  void AddTriangle(std::int64_t i, ShellRun& run) const
  {
    const double* a = this->CornerOf(i, 0);
    const double* b = this->CornerOf(i, 1);
    const double* c = this->CornerOf(i, 2);
    const double* o = this->CornerOf(this->Result.Shells[std::size_t(run.Shell)].FirstTriangle, 0);
    const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    const double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    run.Volume += (a[0] - o[0]) * n[0] + (a[1] - o[1]) * n[1] + (a[2] - o[2]) * n[2];
    run.Area += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box.Lower[axis] = std::min({ a[axis], b[axis], c[axis] });
      box.Upper[axis] = std::max({ a[axis], b[axis], c[axis] });
    }
    run.Count++ == 0 ? void(run.Bounds = box) : Enclose(run.Bounds, box);
  }

  void CountHandles()
  {
    for (Shell& shell : this->Result.Shells)
    {
      shell.NumberOfEdges = (3 * shell.NumberOfTriangles + shell.NumberOfEdges) / 2;
      if (shell.IsManifold && shell.IsOrientable)
      {
        shell.Genus =
          static_cast<std::int32_t>((2 - shell.NumberOfRims - shell.EulerCharacteristic()) / 2);
      }
    }
  }

  const Surface& Mesh;
  const std::vector<std::int32_t>& Corners;
  const VertexFans& Fans;
  const MeshEdges& Edges;
  Executor& Threads;
  DisjointSets Sets; ///< of triangles
  ShellSet Result;
};

} // namespace

ShellSet FindShells(const Surface& mesh, const std::vector<std::int32_t>& corners,
  const VertexFans& fans, const MeshEdges& edges, Executor& executor)
{
  return ShellFinder(mesh, corners, fans, edges, executor).Run();
}

} // namespace sb
