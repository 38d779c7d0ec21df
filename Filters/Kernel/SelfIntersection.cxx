// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersection.h"

#include "BVH.h"
#include "Contacts.h"
#include "ParallelSort.h"
#include "Predicates.h"
#include "StitchedSeams.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 4096;
constexpr std::int64_t GroupGrain = 128;

/**
 * A triangle as the filter sees it; in the order of the hierarchy, so that what is compared lies
 * together. Its plane's normal, from exact differences, gives signs of Orient3D wherever their size
 * is above Error times the offset (the bound of Predicates.h, with the largest of three factors).
 */
struct FlatTriangle
{
  double P[3][3];
  double Normal[3];
  double Error;
  std::int32_t Vertices[3];
  std::int32_t Face;
};

void SetPlane(FlatTriangle& triangle)
{
  const double* a = triangle.P[0];
  double p[3];
  double q[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = triangle.P[1][axis] - a[axis];
    q[axis] = triangle.P[2][axis] - a[axis];
  }
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double left = p[(axis + 1) % 3] * q[(axis + 2) % 3];
    const double right = p[(axis + 2) % 3] * q[(axis + 1) % 3];
    triangle.Normal[axis] = left - right;
    largest = std::max(largest, std::fabs(left) + std::fabs(right));
  }
  constexpr double sevenRoundings = 7.0 / 9007199254740992.0;
  triangle.Error = sevenRoundings * largest;
}

/** Which corners of one triangle are corners of another one: bit i for corner i. */
unsigned CommonCorners(const FlatTriangle& of, const FlatTriangle& with)
{
  unsigned common = 0;
  for (unsigned i = 0; i < 3; ++i)
  {
    const std::int32_t v = of.Vertices[i];
    common |= static_cast<unsigned>(
                (v == with.Vertices[0]) | (v == with.Vertices[1]) | (v == with.Vertices[2]))
      << i;
  }
  return common;
}

/** Whether all corners of `b` that are not `common` are certainly off a's plane on one side. */
bool IsOffPlane(const FlatTriangle& a, const FlatTriangle& b, unsigned common)
{
  int side = 0;
  for (unsigned i = 0; i < 3; ++i)
  {
    if (common >> i & 1u)
    {
      continue;
    }
    const double r[3] = { b.P[i][0] - a.P[0][0], b.P[i][1] - a.P[0][1], b.P[i][2] - a.P[0][2] };
    const double height = r[0] * a.Normal[0] + r[1] * a.Normal[1] + r[2] * a.Normal[2];
    const double reach = std::fabs(r[0]) + std::fabs(r[1]) + std::fabs(r[2]);
    if (!(std::fabs(height) > a.Error * reach))
    {
      return false;
    }
    const int sign = height > 0.0 ? 1 : -1;
    if (sign == -side)
    {
      return false;
    }
    side = sign;
  }
  return true;
}

/**
 * Whether an edge of `a` has `b` beyond it, seen along a's dominant axis: the plane through the
 * edge along that axis then parts the two, but for corners that they have in common.
 */
bool IsBeyondEdge(
  const FlatTriangle& a, const FlatTriangle& b, unsigned commonOfA, unsigned commonOfB)
{
  int axis = std::fabs(a.Normal[1]) > std::fabs(a.Normal[0]) ? 1 : 0;
  axis = std::fabs(a.Normal[2]) > std::fabs(a.Normal[axis]) ? 2 : axis;
  const int turn = Orient2D(a.P[0], a.P[1], a.P[2], axis);
  for (unsigned edge = 0; edge < 3 && turn != 0; ++edge)
  {
    const unsigned head = (edge + 1) % 3;
    const unsigned apex = (edge + 2) % 3;
    bool isBeyond = (commonOfA >> apex & 1u) == 0;
    for (unsigned i = 0; i < 3 && isBeyond; ++i)
    {
      isBeyond =
        (commonOfB >> i & 1u) != 0 || Orient2D(a.P[edge], a.P[head], b.P[i], axis) * turn < 0;
    }
    if (isBeyond)
    {
      return true;
    }
  }
  return false;
}

/** Whether two triangles certainly have no more than corners or an edge in common. */
bool AreApart(const FlatTriangle& a, const FlatTriangle& b)
{
  const unsigned commonOfB = CommonCorners(b, a);
  const unsigned commonOfA = commonOfB == 0 ? 0 : CommonCorners(a, b);
  if (commonOfB == 7)
  {
    return false; // copies: which of them count, is for others to say
  }
  return IsOffPlane(a, b, commonOfB) || IsOffPlane(b, a, commonOfA) ||
    IsBeyondEdge(a, b, commonOfA, commonOfB) || IsBeyondEdge(b, a, commonOfB, commonOfA);
}

class SelfSearch
{
public:
  SelfSearch(const SelfIntersectionInput& input, Executor& executor, Monitor& monitor)
    : In(input)
    , Threads(executor)
    , Watch(monitor)
  {
  }

  SelfIntersections Run()
  {
    this->ListFaces();
    this->BuildTree();
    this->OrderTriangles();
    std::vector<TrianglePair> pairs = this->FindCandidates();
    this->Triangles.reset();
    if (this->Watch.Aborted())
    {
      return {};
    }
    return this->Gather(
      FindContacts(this->In.World, pairs, this->In.Collapsed, this->Threads, this->Watch));
  }

private:
  /** Those that have an area. */
  void ListFaces()
  {
    const std::int32_t count = this->In.World.NumberOfFaces();
    this->Faces.reserve(std::size_t(count));
    for (std::int32_t face = 0; face < count; ++face)
    {
      if (this->In.Collapsed.empty() || !this->In.Collapsed[std::size_t(face)])
      {
        this->Faces.push_back(face);
      }
    }
  }

  const double* CornerOf(std::int32_t face, std::size_t corner) const
  {
    return this->In.World.Position(
      this->In.World.Mesh(0).Triangles[3 * std::size_t(face) + corner]);
  }

  void BuildTree()
  {
    const std::unique_ptr<Box[]> boxes(new Box[this->Faces.size()]);
    this->Threads.For(static_cast<std::int64_t>(this->Faces.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i)
        {
          const double* a = this->CornerOf(this->Faces[i], 0);
          const double* b = this->CornerOf(this->Faces[i], 1);
          const double* c = this->CornerOf(this->Faces[i], 2);
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            boxes[i].Lower[axis] = std::min({ a[axis], b[axis], c[axis] });
            boxes[i].Upper[axis] = std::max({ a[axis], b[axis], c[axis] });
          }
        }
      });
    this->Tree.Build(boxes.get(), static_cast<std::int32_t>(this->Faces.size()), this->Threads);
  }

  void OrderTriangles()
  {
    // Not initialised: the pages are first touched by the threads that fill them.
    this->Triangles.reset(new FlatTriangle[this->Faces.size()]);
    this->Threads.For(static_cast<std::int64_t>(this->Faces.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t place = std::size_t(begin); place < std::size_t(end); ++place)
        {
          FlatTriangle& triangle = this->Triangles[place];
          triangle.Face = this->Faces[std::size_t(this->Tree.Order()[place])];
          for (std::size_t i = 0; i < 3; ++i)
          {
            std::copy_n(this->CornerOf(triangle.Face, i), 3, triangle.P[i]);
            triangle.Vertices[i] = this->In.Corners[3 * std::size_t(triangle.Face) + i];
          }
          SetPlane(triangle);
        }
      });
  }

  std::vector<TrianglePair> FindCandidates()
  {
    const std::int64_t groups = this->Tree.NumberOfGroups();
    std::vector<std::vector<std::uint64_t>> parts(
      std::size_t((groups + GroupGrain - 1) / GroupGrain));
    this->Threads.For(
      static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t part = begin; part < end && !this->Watch.Aborted(); ++part)
        {
          const std::int64_t last = std::min(groups, (part + 1) * GroupGrain);
          for (std::int64_t group = part * GroupGrain; group < last; ++group)
          {
            this->AskGroup(static_cast<std::int32_t>(group), parts[std::size_t(part)]);
          }
        }
      });
    return this->Sorted(parts);
  }

  void AskGroup(std::int32_t group, std::vector<std::uint64_t>& found) const
  {
    this->Tree.ForEachPairOfGroup(group, [&](std::int32_t p, std::int32_t q) {
      const FlatTriangle& a = this->Triangles[std::size_t(p)];
      const FlatTriangle& b = this->Triangles[std::size_t(q)];
      if (!AreApart(a, b))
      {
        const std::uint64_t lower = static_cast<std::uint32_t>(std::min(a.Face, b.Face));
        found.push_back(lower << 32 | static_cast<std::uint32_t>(std::max(a.Face, b.Face)));
      }
    });
  }

  bool AreCopies(std::int32_t a, std::int32_t b) const
  {
    return !this->In.FirstCopies.empty() &&
      this->In.FirstCopies[std::size_t(this->In.Cells.CellOf(a))] ==
      this->In.FirstCopies[std::size_t(this->In.Cells.CellOf(b))] &&
      this->In.Cells.CellOf(a) != this->In.Cells.CellOf(b);
  }

  std::vector<TrianglePair> Sorted(const std::vector<std::vector<std::uint64_t>>& parts)
  {
    std::vector<std::uint64_t> keys;
    for (const std::vector<std::uint64_t>& part : parts)
    {
      keys.insert(keys.end(), part.begin(), part.end());
    }
    RadixSort(
      keys, [](std::uint64_t key) { return key; }, 64, this->Threads);
    std::vector<TrianglePair> pairs;
    for (const std::uint64_t key : keys)
    {
      const auto a = static_cast<std::int32_t>(key >> 32);
      const auto b = static_cast<std::int32_t>(key & 0xffffffffu);
      if (!this->AreCopies(a, b))
      {
        pairs.push_back({ 0, a, 0, b });
      }
    }
    return pairs;
  }

  /** Contacts come twice, once for either face, and sorted. */
  SelfIntersections Gather(const ContactSet& set) const
  {
    SelfIntersections result;
    const StitchedSeams seams(this->In.Collapsed, this->In.Edges);
    for (const Contact& contact : set.Contacts)
    {
      if (contact.Face > contact.Other ||
        (!this->In.Collapsed.empty() && seams.IsAlongSeam(contact, AsOtherSeesIt(set, contact))))
      {
        continue;
      }
      SelfContact found;
      found.Triangles = { contact.Face, contact.Other };
      for (std::size_t end = 0; end < 2; ++end)
      {
        found.Ends[end] = this->PositionOf(set.Points[std::size_t(contact.Points[end])]);
      }
      if (result.Pairs.empty() || result.Pairs.back() != found.Triangles)
      {
        result.Pairs.push_back(found.Triangles);
      }
      result.Contacts.push_back(found);
    }
    return result;
  }

  static const Contact& AsOtherSeesIt(const ContactSet& set, const Contact& contact)
  {
    auto it = std::lower_bound(
      set.Contacts.begin(), set.Contacts.end(), contact, [](const Contact& l, const Contact& r) {
        return l.Face != r.Other ? l.Face < r.Other : l.Other < r.Face;
      });
    while (it->Points[0] != contact.Points[0] || it->Points[1] != contact.Points[1])
    {
      ++it;
    }
    return *it;
  }

  std::array<double, 3> PositionOf(const ContactPoint& point) const
  {
    if (point.Vertex >= 0)
    {
      return this->In.World.OriginalPosition(point.Vertex);
    }
    const double* q = point.Point.Approximation();
    const Lattice& grid = this->In.World.Grid();
    return { grid.ToWorld(q[0]), grid.ToWorld(q[1]), grid.ToWorld(q[2]) };
  }

  const SelfIntersectionInput& In;
  Executor& Threads;
  Monitor& Watch;
  std::vector<std::int32_t> Faces;
  BVH Tree;
  std::unique_ptr<FlatTriangle[]> Triangles; ///< in the order of the tree
};

} // namespace

std::vector<std::uint8_t> FindFacesWithoutArea(const Scene& scene, Executor& executor)
{
  const std::int64_t count = scene.NumberOfFaces();
  std::vector<std::uint8_t> collapsed(static_cast<std::size_t>(count), 0);
  std::atomic<bool> isAny{ false };
  executor.For(count, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t face = begin; face < end; ++face)
    {
      const std::int32_t* ids = scene.Mesh(0).Triangles + 3 * face;
      if (ComputeDominantNormal(
            scene.Position(ids[0]), scene.Position(ids[1]), scene.Position(ids[2]))
            .Sign == 0)
      {
        collapsed[std::size_t(face)] = 1;
        isAny = true;
      }
    }
  });
  return isAny ? collapsed : std::vector<std::uint8_t>();
}

SelfIntersections FindSelfIntersections(
  const SelfIntersectionInput& input, Executor& executor, Monitor& monitor)
{
  return SelfSearch(input, executor, monitor).Run();
}

} // namespace sb
