// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cut.h"

#include "CapContours.h"
#include "CapFilling.h"
#include "CapPolygons.h"
#include "CellClip.h"
#include "CellGroups.h"
#include "ClipPoints.h"
#include "FaceClip.h"
#include "Ingest.h"
#include "PlaneOnLattice.h"
#include "Stages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sb
{

namespace
{

constexpr std::int64_t grain = 1 << 14;

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/** Twice the area vector of a triangle along a direction. */
double TwiceArea(const std::array<double, 3>& a, const std::array<double, 3>& b,
  const std::array<double, 3>& c, const std::array<double, 3>& direction)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t u = (i + 1) % 3;
    const std::size_t v = (i + 2) % 3;
    sum += direction[i] * ((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
  }
  return sum;
}

/** One cross-section. */
class Section
{
public:
  Section(const Surface& mesh, const Lattice& lattice, const HalfSpace& plane)
    : Planes(1, plane)
    , Points(mesh, lattice, this->Planes)
  {
  }

  void Run(const CutRequest& request, const std::vector<std::int32_t>& faces,
    const std::array<double, 3>& normal)
  {
    std::vector<Contour> contours(1);
    FaceClip clip(this->Points, false);
    CellClip cell(this->Points, clip);
    VisitCells(faces, request.FirstTriangles, request.NumberOfCells,
      [&](auto begin, auto end, std::int32_t first, std::int32_t last) {
        if (last - first > 1 && cell.IsFlat(first, last))
        {
          cell.Run(std::vector<std::int32_t>(begin, end), first, last, contours);
          return;
        }
        std::for_each(begin, end, [&](std::int32_t face) { clip.Clip(face, contours); });
      });
    SplitSegments splits;
    const OpenContourCount open = CompleteContours(this->Points, contours, splits);
    this->Result.JoinedContours = open.Joined;
    this->Result.OpenContours = open.Removed;
    const CapFilling cap = FillCapContour(this->Points, 0, contours[0], FillRule::NonZero, splits);
    this->AddTriangles(cap);
    this->AddPolygons(cap, normal);
  }

  CutResult Result;

private:
  std::int32_t IdOf(std::int32_t instance)
  {
    const std::int32_t first = this->Points.Instance(this->Points.Node(instance));
    this->Ids.resize(std::size_t(this->Points.NumberOfInstances()), -1);
    std::int32_t& id = this->Ids[std::size_t(first)];
    if (id < 0)
    {
      id = static_cast<std::int32_t>(this->Result.Points.size());
      this->Result.Points.push_back(this->Points.Output(first));
    }
    return id;
  }

  void AddTriangles(const CapFilling& cap)
  {
    for (std::size_t i = 0; i < cap.Triangles.size(); ++i)
    {
      // A cap looks backwards; a cross-section is seen from in front.
      const std::array<std::int32_t, 3>& triangle = cap.Triangles[i];
      this->Result.Triangles.push_back(
        { this->IdOf(triangle[0]), this->IdOf(triangle[2]), this->IdOf(triangle[1]) });
    }
    this->Result.PolygonOfTriangle = cap.Regions;
  }

  const std::array<double, 3>& Place(std::int32_t id) const
  {
    return this->Result.Points[std::size_t(id)].Position;
  }

  void AddPolygons(const CapFilling& cap, const std::array<double, 3>& normal)
  {
    for (const std::int32_t depth : cap.Depths)
    {
      this->Result.Polygons.push_back({ 0, depth, 0.0, 0.0 });
    }
    for (std::size_t i = 0; i < this->Result.Triangles.size(); ++i)
    {
      const std::array<std::int32_t, 3>& t = this->Result.Triangles[i];
      this->Result.Polygons[std::size_t(cap.Regions[i])].Area +=
        std::fabs(TwiceArea(this->Place(t[0]), this->Place(t[1]), this->Place(t[2]), normal) / 2.0);
    }
    const RegionLoops loops = FindRegionLoops(this->Result.Triangles, cap.Regions);
    std::vector<std::size_t> order(loops.Regions.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<double> areas;
    for (std::size_t loop = 0; loop < order.size(); ++loop)
    {
      areas.push_back(this->MeasureLoop(loops, loop, normal));
    }
    // Of a region's loops the one around it encloses most.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) {
      return loops.Regions[l] != loops.Regions[r] ? loops.Regions[l] < loops.Regions[r]
                                                  : std::fabs(areas[l]) > std::fabs(areas[r]);
    });
    for (const std::size_t loop : order)
    {
      this->AddLoop(loops, loop);
    }
  }

  /** The area within a loop; adds its length to its polygon's perimeter. */
  double MeasureLoop(
    const RegionLoops& loops, std::size_t loop, const std::array<double, 3>& normal)
  {
    const auto begin = static_cast<std::size_t>(loops.Offsets[loop]);
    const auto end = static_cast<std::size_t>(loops.Offsets[loop + 1]);
    double& perimeter = this->Result.Polygons[std::size_t(loops.Regions[loop])].Perimeter;
    const std::array<double, 3>& apex = this->Place(loops.Connectivity[begin]);
    double area = 0.0;
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::array<double, 3>& here = this->Place(loops.Connectivity[i]);
      const std::array<double, 3>& next =
        this->Place(loops.Connectivity[i + 1 < end ? i + 1 : begin]);
      perimeter += Distance(here, next);
      area += TwiceArea(apex, here, next, normal) / 2.0;
    }
    return area;
  }

  void AddLoop(const RegionLoops& loops, std::size_t loop)
  {
    CutResult& result = this->Result;
    const std::int32_t region = loops.Regions[loop];
    const bool isFirst = result.PolygonOfLoop.empty() || result.PolygonOfLoop.back() != region;
    result.LoopPoints.insert(result.LoopPoints.end(),
      loops.Connectivity.begin() + loops.Offsets[loop],
      loops.Connectivity.begin() + loops.Offsets[loop + 1]);
    result.LoopOffsets.push_back(static_cast<std::int32_t>(result.LoopPoints.size()));
    result.PolygonOfLoop.push_back(region);
    result.IsHole.push_back(isFirst ? 0 : 1);
  }

  std::vector<HalfSpace> Planes;
  ClipPoints Points;
  std::vector<std::int32_t> Ids; ///< by instance
};

class Cutter
{
public:
  Cutter(const CutRequest& request, Executor& executor, Monitor& monitor)
    : Request(request)
    , Mesh(request.Mesh)
    , Threads(executor)
    , Listener(monitor)
    , Laps(this->Result.Times, this->Result.Remarks, monitor)
  {
  }

  CutResult Run()
  {
    if (!this->Check() || !this->FindFaces() || !this->CutAll())
    {
      CutResult empty;
      empty.Remarks = this->Result.Remarks;
      empty.Condition = empty.Remarks.front().Condition;
      return empty;
    }
    return std::move(this->Result);
  }

private:
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
    const bool goodOffsets = std::all_of(this->Request.Offsets.begin(), this->Request.Offsets.end(),
      [](double offset) { return std::isfinite(offset); });
    if (!IsPlane(this->Request.Plane) || !goodOffsets)
    {
      this->Add(Status::BadRequest);
      return false;
    }
    return true;
  }

  /** The planes at the offsets. */
  std::vector<ClipPlane> PlacePlanes()
  {
    const std::array<double, 3>& n = this->Request.Plane.Normal;
    const double largest = std::max(std::fabs(n[0]), std::max(std::fabs(n[1]), std::fabs(n[2])));
    const double length =
      largest * std::hypot(std::hypot(n[0] / largest, n[1] / largest), n[2] / largest);
    std::vector<ClipPlane> planes;
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Normal[i] = n[i] / length;
    }
    for (const double offset : this->Request.Offsets)
    {
      planes.push_back(this->Request.Plane);
      for (std::size_t i = 0; i < 3; ++i)
      {
        planes.back().Origin[i] += offset * this->Normal[i];
      }
    }
    return planes;
  }

  bool FindFaces()
  {
    std::vector<ClipPlane> planes = this->PlacePlanes();
    const MeshBounds bounds = FindBounds(this->Mesh, this->Threads);
    this->Grid = PlaceOnLattice(bounds, planes);
    for (const ClipPlane& plane : planes)
    {
      this->Planes.emplace_back(plane, this->Grid);
    }
    this->Order.resize(planes.size());
    std::iota(this->Order.begin(), this->Order.end(), 0);
    std::stable_sort(this->Order.begin(), this->Order.end(), [&](std::int32_t l, std::int32_t r) {
      return this->Request.Offsets[std::size_t(l)] < this->Request.Offsets[std::size_t(r)];
    });
    for (const std::int32_t plane : this->Order)
    {
      this->Heights.push_back(this->Request.Offsets[std::size_t(plane)]);
    }
    // Heights are only to be near the truth: generous for their rounding and for the lattice.
    double size = std::fabs(this->Request.Plane.Origin[0]) +
      std::fabs(this->Request.Plane.Origin[1]) + std::fabs(this->Request.Plane.Origin[2]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      size += std::max(std::fabs(bounds.Low[i]), std::fabs(bounds.High[i]));
    }
    for (const double height : this->Heights)
    {
      size = std::max(size, std::fabs(height));
    }
    this->Margin = 1e-13 * size + 4.0 * this->Grid.ToWorld(1.0);
    return this->ListFaces() && this->Laps.End("Faces", 0.2);
  }

  struct FaceBlock
  {
    std::vector<std::pair<std::int32_t, std::int32_t>> Reached; ///< place in Order, face
    std::int64_t BadIndex = -1;
    std::int64_t BadCoordinate = -1;
  };

  double HeightOf(std::int32_t vertex) const
  {
    const double* p = this->Mesh.Points + 3 * std::int64_t(vertex);
    double height = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      height += this->Normal[i] * (p[i] - this->Request.Plane.Origin[i]);
    }
    return height;
  }

  void LookAt(std::int64_t face, FaceBlock& block) const
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    bool finite = true;
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::int32_t vertex = this->Mesh.Triangles[3 * face + corner];
      if (vertex < 0 || vertex >= this->Mesh.NumberOfPoints)
      {
        block.BadIndex = block.BadIndex < 0 ? face : block.BadIndex;
        return;
      }
      const double height = this->HeightOf(vertex);
      finite = finite && std::isfinite(height);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    if (!finite)
    {
      block.BadCoordinate = block.BadCoordinate < 0 ? face : block.BadCoordinate;
      return;
    }
    const auto first =
      std::lower_bound(this->Heights.begin(), this->Heights.end(), low - this->Margin);
    for (auto height = first; height != this->Heights.end() && *height <= high + this->Margin;
         ++height)
    {
      block.Reached.emplace_back(
        static_cast<std::int32_t>(height - this->Heights.begin()), static_cast<std::int32_t>(face));
    }
  }

  bool ListFaces()
  {
    const std::int64_t count = this->Mesh.NumberOfTriangles;
    std::vector<FaceBlock> blocks(std::size_t((count + grain - 1) / grain));
    this->Threads.For(
      static_cast<std::int64_t>(blocks.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end; ++block)
        {
          const std::int64_t last = std::min(count, (block + 1) * grain);
          for (std::int64_t face = block * grain; face < last; ++face)
          {
            this->LookAt(face, blocks[std::size_t(block)]);
          }
        }
      });
    this->Faces.resize(this->Planes.size());
    for (const FaceBlock& block : blocks)
    {
      if (block.BadIndex >= 0)
      {
        this->Add(Status::BadIndex).Triangle = block.BadIndex;
        return false;
      }
      if (block.BadCoordinate >= 0)
      {
        this->Add(Status::BadCoordinate).Triangle = block.BadCoordinate;
        return false;
      }
      for (const auto& reached : block.Reached)
      {
        this->Faces[std::size_t(this->Order[std::size_t(reached.first)])].push_back(reached.second);
      }
    }
    return true;
  }

  bool CutAll()
  {
    std::vector<CutResult> parts(this->Planes.size());
    this->Threads.For(
      static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end && !this->Listener.Aborted(); ++i)
        {
          Section section(this->Mesh, this->Grid, this->Planes[std::size_t(i)]);
          section.Run(this->Request, this->Faces[std::size_t(i)], this->Normal);
          parts[std::size_t(i)] = std::move(section.Result);
        }
      });
    for (std::size_t plane = 0; plane < parts.size(); ++plane)
    {
      this->Append(parts[plane], static_cast<std::int32_t>(plane));
    }
    return this->Laps.End("Sections", 1.0);
  }

  void Append(const CutResult& part, std::int32_t plane)
  {
    CutResult& all = this->Result;
    const auto firstPoint = static_cast<std::int32_t>(all.Points.size());
    const auto firstPolygon = static_cast<std::int32_t>(all.Polygons.size());
    const std::int32_t firstCorner = all.LoopOffsets.back();
    all.Points.insert(all.Points.end(), part.Points.begin(), part.Points.end());
    for (CutPolygon polygon : part.Polygons)
    {
      polygon.Plane = plane;
      all.Polygons.push_back(polygon);
    }
    for (const std::array<std::int32_t, 3>& t : part.Triangles)
    {
      all.Triangles.push_back({ t[0] + firstPoint, t[1] + firstPoint, t[2] + firstPoint });
    }
    for (const std::int32_t polygon : part.PolygonOfTriangle)
    {
      all.PolygonOfTriangle.push_back(polygon + firstPolygon);
    }
    for (const std::int32_t point : part.LoopPoints)
    {
      all.LoopPoints.push_back(point + firstPoint);
    }
    for (std::size_t loop = 0; loop < part.PolygonOfLoop.size(); ++loop)
    {
      all.LoopOffsets.push_back(part.LoopOffsets[loop + 1] + firstCorner);
      all.PolygonOfLoop.push_back(part.PolygonOfLoop[loop] + firstPolygon);
      all.IsHole.push_back(part.IsHole[loop]);
    }
    all.JoinedContours += part.JoinedContours;
    all.OpenContours += part.OpenContours;
  }

  const CutRequest& Request;
  const Surface& Mesh;
  Executor& Threads;
  Monitor& Listener;
  CutResult Result;
  StageLaps Laps;

  std::array<double, 3> Normal{}; ///< of length one
  Lattice Grid;
  std::vector<HalfSpace> Planes;
  std::vector<std::int32_t> Order; ///< planes by height
  std::vector<double> Heights; ///< in that order
  double Margin = 0.0;
  std::vector<std::vector<std::int32_t>> Faces; ///< by plane: those that may reach it
};

} // namespace

CutResult CutSurface(const CutRequest& request, Executor& executor, Monitor& monitor)
{
  return Cutter(request, executor, monitor).Run();
}

} // namespace sb
