// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Ingest.h"

#include "Hash.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace sb
{

namespace
{

constexpr std::int64_t BlockSize = 1 << 14;

/** What one block of triangles adds; blocks are added up in their order, so that sums do not depend
 * on the threads. */
struct TriangleSums
{
  std::int64_t BadIndex = -1; ///< first triangle with a point id out of range
  double Volume = 0.0;
  double Area = 0.0;
  std::uint64_t Boundary = 0;
};

/**
 * A triangle's area in a plane where each point lies at a random place, made of its hash. The area
 * is a sum over the edges which changes its sign with their direction, so edges that are used both
 * ways cancel, and those of a closed surface all do.
 */
std::uint64_t AreaAtRandomPlaces(std::uint64_t a, std::uint64_t b, std::uint64_t c)
{
  const auto other = [](std::uint64_t hash) { return (hash ^ (hash >> 32)) * 0xd6e8feb86659fd93u; };
  const std::uint64_t otherA = other(a);
  const std::uint64_t otherB = other(b);
  const std::uint64_t otherC = other(c);
  return a * (otherB - otherC) + b * (otherC - otherA) + c * (otherA - otherB);
}

TriangleSums MeasureTriangles(
  const Surface& mesh, const std::uint64_t* hashes, std::int64_t begin, std::int64_t end)
{
  TriangleSums sums;
  const auto limit = static_cast<std::uint32_t>(mesh.NumberOfPoints);
  const double* origin = mesh.Points;
  for (std::int64_t i = begin; i < end; ++i)
  {
    const std::int32_t* ids = mesh.Triangles + 3 * i;
    if (static_cast<std::uint32_t>(ids[0]) >= limit ||
      static_cast<std::uint32_t>(ids[1]) >= limit || static_cast<std::uint32_t>(ids[2]) >= limit)
    {
      sums.BadIndex = i;
      return sums;
    }
    const double* a = mesh.Points + 3 * std::int64_t(ids[0]);
    const double* b = mesh.Points + 3 * std::int64_t(ids[1]);
    const double* c = mesh.Points + 3 * std::int64_t(ids[2]);
    const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
    const double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    sums.Volume +=
      (a[0] - origin[0]) * n[0] + (a[1] - origin[1]) * n[1] + (a[2] - origin[2]) * n[2];
    sums.Area += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    sums.Boundary += AreaAtRandomPlaces(hashes[ids[0]], hashes[ids[1]], hashes[ids[2]]);
  }
  return sums;
}

bool IsFinite(const double* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/** A directed edge of a triangle, its ends named by their hashes. */
struct EdgeOfTriangle
{
  std::uint64_t Low;
  std::uint64_t High;
  std::int32_t Triangle;
  std::int8_t Edge;
  bool RunsUp;

  friend bool operator<(const EdgeOfTriangle& l, const EdgeOfTriangle& r)
  {
    return l.Low != r.Low ? l.Low < r.Low
      : l.High != r.High  ? l.High < r.High
                          : l.Triangle < r.Triangle;
  }
};

/** Says what is wrong with a surface that is known not to be closed, and lists its rim. */
Remark Diagnose(const Surface& mesh, const std::vector<std::uint64_t>& hashes,
  std::vector<RimEdge>& rim, Executor& executor)
{
  std::vector<EdgeOfTriangle> edges;
  edges.reserve(std::size_t(3 * mesh.NumberOfTriangles));
  for (std::int32_t i = 0; i < mesh.NumberOfTriangles; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::uint64_t from = hashes[std::size_t(mesh.Triangles[3 * std::size_t(i) + k])];
      const std::uint64_t to =
        hashes[std::size_t(mesh.Triangles[3 * std::size_t(i) + (k + 1) % 3])];
      if (from != to)
      {
        edges.push_back(
          { std::min(from, to), std::max(from, to), i, static_cast<std::int8_t>(k), from < to });
      }
    }
  }
  ParallelSort(
    edges, [](const EdgeOfTriangle& l, const EdgeOfTriangle& r) { return l < r; }, executor);

  Remark boundary;
  boundary.Condition = Status::OpenOperand;
  Remark inconsistent;
  inconsistent.Condition = Status::InconsistentOrientation;
  for (std::size_t first = 0; first < edges.size();)
  {
    std::size_t end = first;
    std::int64_t balance = 0;
    for (; end < edges.size() && edges[end].Low == edges[first].Low &&
         edges[end].High == edges[first].High;
         ++end)
    {
      balance += edges[end].RunsUp ? 1 : -1;
    }
    Remark* remark = nullptr;
    if ((end - first) % 2 == 1)
    {
      remark = &boundary;
      rim.push_back({ edges[first].Triangle, edges[first].Edge });
    }
    else if (balance != 0)
    {
      remark = &inconsistent;
    }
    if (remark)
    {
      ++remark->Count;
      remark->Triangle = remark->Triangle < 0 ? edges[first].Triangle : remark->Triangle;
    }
    first = end;
  }
  return inconsistent.Count > 0 ? inconsistent : boundary;
}

/** The first triangle with a corner that is not finite, and that corner. */
Remark FindBadCoordinate(const Surface& mesh)
{
  Remark remark;
  remark.Condition = Status::BadCoordinate;
  for (std::int64_t i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    if (!IsFinite(mesh.Points + 3 * std::int64_t(mesh.Triangles[i])))
    {
      remark.Triangle = i / 3;
      remark.Point = mesh.Triangles[i];
      break;
    }
  }
  return remark;
}

/** Makes the examination of one surface. */
class Examiner
{
public:
  Examiner(const Surface& mesh, OpenSurfaces open, Executor& executor)
    : Mesh(mesh)
    , Open(open)
    , Threads(executor)
  {
  }

  Examination Result;

  void Run()
  {
    if (IsTooLarge(this->Mesh))
    {
      this->Add(Status::TooLarge);
      return;
    }
    if (this->Mesh.NumberOfTriangles == 0)
    {
      this->Result.Report.Closed = true;
      this->Add(Status::EmptyOperand);
      return;
    }
    std::vector<std::uint64_t> hashes(std::size_t(this->Mesh.NumberOfPoints));
    this->Threads.For(
      this->Mesh.NumberOfPoints, BlockSize, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          hashes[std::size_t(i)] = HashPlace(this->Mesh.Points + 3 * i);
        }
      });
    if (!this->MeasureAllTriangles(hashes) || !this->HasGoodCoordinates())
    {
      return;
    }
    this->MeasureBounds();
    if (!this->Result.Report.Closed)
    {
      this->Result.IsOpen = true;
      if (this->Open == OpenSurfaces::Diagnose)
      {
        this->Result.Remarks.push_back(
          Diagnose(this->Mesh, hashes, this->Result.Rim, this->Threads));
      }
    }
    else if (this->Result.Report.Volume < 0.0)
    {
      this->Result.IsInsideOut = true;
      this->Add(Status::InsideOut);
    }
  }

private:
  Remark& Add(Status condition)
  {
    this->Result.Remarks.emplace_back();
    this->Result.Remarks.back().Condition = condition;
    return this->Result.Remarks.back();
  }

  /** @return whether all point ids are good. */
  bool MeasureAllTriangles(const std::vector<std::uint64_t>& hashes)
  {
    const std::int64_t count = this->Mesh.NumberOfTriangles;
    std::vector<TriangleSums> sums(
      static_cast<std::size_t>((count + TriangleBlock::Size - 1) / TriangleBlock::Size));
    this->Result.Blocks.resize(sums.size());
    this->Threads.For(
      static_cast<std::int64_t>(sums.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          const std::int64_t first = i * TriangleBlock::Size;
          const std::int64_t last = std::min(count, first + TriangleBlock::Size);
          TriangleSums& block = sums[std::size_t(i)];
          block = MeasureTriangles(this->Mesh, hashes.data(), first, last);
          if (block.BadIndex < 0)
          {
            this->Result.Blocks[std::size_t(i)] =
              BlockOf(this->Mesh.Points, this->Mesh.Triangles, first, last);
          }
        }
      });
    TriangleSums total;
    for (const TriangleSums& block : sums)
    {
      if (block.BadIndex >= 0)
      {
        this->Add(Status::BadIndex).Triangle = block.BadIndex;
        return false;
      }
      total.Volume += block.Volume;
      total.Area += block.Area;
      total.Boundary += block.Boundary;
    }
    this->Result.Report.Volume = total.Volume / 6.0;
    this->Result.Report.Area = total.Area / 2.0;
    this->Result.Report.Closed = total.Boundary == 0;
    return true;
  }

  /** @return whether all points in use are finite. */
  bool HasGoodCoordinates()
  {
    // A coordinate that is not finite makes the area of its triangle, and so the sum, not finite;
    // but so do coordinates beyond 1e150.
    if (std::isfinite(this->Result.Report.Area))
    {
      return true;
    }
    const Remark remark = FindBadCoordinate(this->Mesh);
    if (remark.Triangle >= 0)
    {
      this->Result.Remarks.push_back(remark);
    }
    return remark.Triangle < 0;
  }

  void MeasureBounds()
  {
    Box total = this->Result.Blocks.front().Bounds;
    for (const TriangleBlock& block : this->Result.Blocks)
    {
      Enclose(total, block.Bounds);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Result.Report.Bounds[2 * axis] = total.Lower[axis];
      this->Result.Report.Bounds[2 * axis + 1] = total.Upper[axis];
    }
  }

  const Surface& Mesh;
  const OpenSurfaces Open;
  Executor& Threads;
};

} // namespace

std::shared_ptr<const Examination> Examine(
  const Surface& surface, Executor& executor, OpenSurfaces open)
{
  Examiner examiner(surface, open, executor);
  examiner.Run();
  return std::make_shared<const Examination>(std::move(examiner.Result));
}

bool IsTooLarge(const Surface& surface)
{
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() / 4;
  return surface.NumberOfTriangles > most || surface.NumberOfPoints > most;
}

Ingested Ingest(const BooleanRequest& request, Executor& executor)
{
  Ingested result;
  for (const Operand& operand : request.Operands)
  {
    const std::shared_ptr<const Examination> examination =
      operand.Known ? operand.Known : Examine(operand.Mesh, executor);
    const auto index = static_cast<std::int32_t>(result.Reports.size());
    for (Remark remark : examination->Remarks)
    {
      remark.Operand = index;
      result.Remarks.push_back(remark);
    }
    result.Reports.push_back(examination->Report);
    result.Open.push_back(examination->IsOpen);
    result.Swapped.push_back(examination->IsInsideOut);
    result.Rims.push_back(examination->Rim);
    result.Examinations.push_back(examination);
  }
  return result;
}

} // namespace sb
