// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Ingest.h"

#include "Hash.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace sb
{

namespace
{

constexpr std::int64_t BlockSize = 1 << 14;

/** What one block of triangles adds; blocks are added up in their order, so that sums do not depend on the threads. */
struct BlockSums
{
  std::int64_t BadIndex = -1;      ///< first triangle with a point id out of range
  std::int64_t BadCoordinate = -1; ///< first triangle with a coordinate that is not finite
  double Volume = 0.0;
  double Area = 0.0;
  std::uint64_t Boundary = 0;
  std::array<double, 3> Low;
  std::array<double, 3> High;

  BlockSums()
  {
    this->Low.fill(std::numeric_limits<double>::infinity());
    this->High.fill(-std::numeric_limits<double>::infinity());
  }
};

std::uint64_t HashPoint(const double* p)
{
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double coordinate = p[axis] + 0.0; // the two zeros are one place
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    hash = Mix(bits + 0x9e3779b97f4a7c15u * (hash + 1));
  }
  return hash;
}

/** A hash of a directed edge, minus that of the opposite one; without branches, which could not be predicted. */
std::uint64_t HashEdge(std::uint64_t from, std::uint64_t to)
{
  constexpr std::uint64_t odd = 0xd6e8feb86659fd93u;
  const std::uint64_t hash = Mix(std::min(from, to) * odd + std::max(from, to));
  const std::uint64_t negate = 0 - std::uint64_t(from > to);
  const std::uint64_t differ = 0 - std::uint64_t(from != to);
  return ((hash ^ negate) - negate) & differ;
}

BlockSums Measure(
  const Surface& mesh, const std::uint64_t* hashes, std::int64_t begin, std::int64_t end)
{
  BlockSums sums;
  const auto limit = static_cast<std::uint32_t>(mesh.NumberOfPoints);
  const double* origin = mesh.Points;
  for (std::int64_t i = begin; i < end; ++i)
  {
    const std::int32_t* ids = mesh.Triangles + 3 * i;
    if (static_cast<std::uint32_t>(ids[0]) >= limit || static_cast<std::uint32_t>(ids[1]) >= limit ||
      static_cast<std::uint32_t>(ids[2]) >= limit)
    {
      sums.BadIndex = i;
      return sums;
    }
    const double* a = mesh.Points + 3 * std::int64_t(ids[0]);
    const double* b = mesh.Points + 3 * std::int64_t(ids[1]);
    const double* c = mesh.Points + 3 * std::int64_t(ids[2]);
    double u[3];
    double v[3];
    double w[3];
    double poison = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      u[axis] = b[axis] - a[axis];
      v[axis] = c[axis] - a[axis];
      w[axis] = a[axis] - origin[axis];
      poison += (a[axis] + b[axis] + c[axis]) * 0.0;
      sums.Low[axis] = std::min(sums.Low[axis], std::min(a[axis], std::min(b[axis], c[axis])));
      sums.High[axis] = std::max(sums.High[axis], std::max(a[axis], std::max(b[axis], c[axis])));
    }
    if (!(poison == 0.0) && sums.BadCoordinate < 0)
    {
      for (const double* p : { a, b, c })
      {
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        {
          sums.BadCoordinate = i;
        }
      }
    }
    const double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    sums.Volume += w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    sums.Area += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const std::uint64_t ha = hashes[ids[0]];
    const std::uint64_t hb = hashes[ids[1]];
    const std::uint64_t hc = hashes[ids[2]];
    sums.Boundary += HashEdge(ha, hb) + HashEdge(hb, hc) + HashEdge(hc, ha);
  }
  return sums;
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
        edges.push_back({ std::min(from, to), std::max(from, to), i,
          static_cast<std::int8_t>(k), from < to });
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

std::int64_t FindBadPoint(const Surface& mesh, std::int64_t triangle)
{
  for (int k = 0; k < 3; ++k)
  {
    const std::int32_t id = mesh.Triangles[3 * triangle + k];
    const double* p = mesh.Points + 3 * std::int64_t(id);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return id;
    }
  }
  return -1;
}

/** Makes the examination of one surface. */
class Examiner
{
public:
  Examiner(const Surface& mesh, Executor& executor)
    : Mesh(mesh)
    , Threads(executor)
  {
  }

  Examination Result;

  void Run()
  {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() / 4;
    if (this->Mesh.NumberOfTriangles > most || this->Mesh.NumberOfPoints > most)
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
    this->Threads.For(this->Mesh.NumberOfPoints, BlockSize,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin; i < end; ++i)
        {
          hashes[std::size_t(i)] = HashPoint(this->Mesh.Points + 3 * i);
        }
      });
    const std::int64_t count = this->Mesh.NumberOfTriangles;
    std::vector<BlockSums> blocks(std::size_t((count + BlockSize - 1) / BlockSize));
    this->Threads.For(static_cast<std::int64_t>(blocks.size()), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin; i < end; ++i)
        {
          blocks[std::size_t(i)] = Measure(
            this->Mesh, hashes.data(), i * BlockSize, std::min(count, (i + 1) * BlockSize));
        }
      });
    if (!this->AddUp(blocks))
    {
      return;
    }
    if (!this->Result.Report.Closed)
    {
      this->Result.Remarks.push_back(
        Diagnose(this->Mesh, hashes, this->Result.Rim, this->Threads));
      this->Result.IsOpen = true;
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

  /** @return whether all indices and coordinates are good. */
  bool AddUp(const std::vector<BlockSums>& blocks)
  {
    BlockSums total;
    for (const BlockSums& block : blocks)
    {
      if (block.BadIndex >= 0)
      {
        this->Add(Status::BadIndex).Triangle = block.BadIndex;
        return false;
      }
      if (block.BadCoordinate >= 0)
      {
        Remark& remark = this->Add(Status::BadCoordinate);
        remark.Triangle = block.BadCoordinate;
        remark.Point = FindBadPoint(this->Mesh, block.BadCoordinate);
        return false;
      }
      total.Volume += block.Volume;
      total.Area += block.Area;
      total.Boundary += block.Boundary;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        total.Low[axis] = std::min(total.Low[axis], block.Low[axis]);
        total.High[axis] = std::max(total.High[axis], block.High[axis]);
      }
    }
    this->Result.Report.Volume = total.Volume / 6.0;
    this->Result.Report.Area = total.Area / 2.0;
    this->Result.Report.Closed = total.Boundary == 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Result.Report.Bounds[2 * axis] = total.Low[axis];
      this->Result.Report.Bounds[2 * axis + 1] = total.High[axis];
    }
    return true;
  }

  const Surface& Mesh;
  Executor& Threads;
};

} // namespace

std::shared_ptr<const Examination> Examine(const Surface& surface, Executor& executor)
{
  Examiner examiner(surface, executor);
  examiner.Run();
  return std::make_shared<const Examination>(std::move(examiner.Result));
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
  }
  return result;
}

} // namespace sb
