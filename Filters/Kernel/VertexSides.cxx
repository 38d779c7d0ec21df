// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexSides.h"

#include <algorithm>
#include <cmath>

namespace sb
{

namespace
{

constexpr std::int64_t grain = 1 << 14;

VertexSides::Word SidesOf(
  const double* p, const Lattice& lattice, const std::vector<HalfSpace>& planes)
{
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
  {
    return VertexSides::NotFinite;
  }
  double q[3];
  lattice.Quantise(p, q);
  unsigned word = 0;
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    const int bit = static_cast<int>(std::min<std::size_t>(i, VertexSides::PlaneBits - 1));
    const int side = planes[i].Side(q);
    word |= static_cast<unsigned>(side <= 0) << bit;
    word |= static_cast<unsigned>(side < 0) << (bit + VertexSides::PlaneBits);
  }
  return static_cast<VertexSides::Word>(word);
}

/** What one block of triangles adds. */
class FaceBlock
{
public:
  FaceBlock(const Surface& mesh, VertexSides& sides, std::size_t numberOfPlanes, bool insideOut)
    : Mesh(mesh)
    , Sides(sides)
    , InsideOut(insideOut)
    , Certain(numberOfPlanes > VertexSides::PlaneBits ? VertexSides::NotInFront >> 1
                                                      : VertexSides::NotInFront)
  {
  }

  FaceSides Run(std::int64_t begin, std::int64_t end, std::vector<Fate>& fates)
  {
    for (std::int64_t face = begin; face < end; ++face)
    {
      fates[std::size_t(face)] = this->FateOf(face);
    }
    return std::move(this->Found);
  }

private:
  Fate FateOf(std::int64_t face)
  {
    const std::int32_t* ids = this->Mesh.Triangles + 3 * face;
    const auto count = static_cast<std::uint32_t>(this->Mesh.NumberOfPoints);
    if (static_cast<std::uint32_t>(ids[0]) >= count ||
      static_cast<std::uint32_t>(ids[1]) >= count || static_cast<std::uint32_t>(ids[2]) >= count)
    {
      this->Found.BadIndex = this->Found.BadIndex < 0 ? face : this->Found.BadIndex;
      return Fate::Dropped;
    }
    const VertexSides::Word a = this->Sides.Of(ids[0]);
    const VertexSides::Word b = this->Sides.Of(ids[1]);
    const VertexSides::Word c = this->Sides.Of(ids[2]);
    const unsigned any = unsigned(a) | b | c;
    const unsigned all = unsigned(a) & b & c;
    if ((any & VertexSides::NotFinite) != 0)
    {
      this->Found.BadCoordinate = this->Found.BadCoordinate < 0 ? face : this->Found.BadCoordinate;
      return Fate::Dropped;
    }
    const Fate fate =
      this->InsideOut ? this->FateOfRest(face, any, all) : this->FateOf(face, any, all);
    if (fate != Fate::Dropped)
    {
      this->Sides.MarkUsed(ids[0], a);
      this->Sides.MarkUsed(ids[1], b);
      this->Sides.MarkUsed(ids[2], c);
    }
    return fate;
  }

  /** Whether some plane has the whole triangle behind it, while no plane before touches it: their
   * caps need what it adds to their contours. */
  static bool IsBehind(unsigned planes, unsigned any)
  {
    const unsigned before = (planes & (0u - planes)) - 1u;
    return planes != 0 && (any & before) == 0;
  }

  Fate Touch(std::int64_t face, Fate fate)
  {
    this->Found.Touched.push_back(static_cast<std::int32_t>(face));
    return fate;
  }

  Fate FateOf(std::int64_t face, unsigned any, unsigned all)
  {
    // No corner in front of some plane, and one behind it: nothing is left.
    if (IsBehind(all & (any >> VertexSides::PlaneBits) & this->Certain, any))
    {
      return Fate::Dropped;
    }
    return (any & VertexSides::NotInFront) == 0 ? Fate::Kept : this->Touch(face, Fate::Split);
  }

  Fate FateOfRest(std::int64_t face, unsigned any, unsigned all)
  {
    if ((any & VertexSides::NotInFront) == 0)
    {
      return Fate::Dropped;
    }
    // With all corners behind a plane, no point of what is taken out lies on its edges.
    const unsigned behind = (all >> VertexSides::PlaneBits) & this->Certain;
    if (behind == 0)
    {
      return this->Touch(face, Fate::Split);
    }
    return IsBehind(behind, any) ? Fate::Kept : this->Touch(face, Fate::Kept);
  }

  const Surface& Mesh;
  VertexSides& Sides;
  const bool InsideOut;
  const unsigned Certain;
  FaceSides Found;
};

} // namespace

VertexSides FindVertexSides(const Surface& mesh, const Lattice& lattice,
  const std::vector<HalfSpace>& planes, Executor& executor)
{
  VertexSides sides;
  sides.Words.reset(new std::atomic<VertexSides::Word>[std::size_t(mesh.NumberOfPoints)]);
  executor.For(mesh.NumberOfPoints, grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      sides.Words[std::size_t(i)].store(
        SidesOf(mesh.Points + 3 * i, lattice, planes), std::memory_order_relaxed);
    }
  });
  return sides;
}

FaceSides FindFaceSides(const Surface& mesh, VertexSides& sides, std::size_t numberOfPlanes,
  bool insideOut, std::vector<Fate>& fates, Executor& executor)
{
  const std::int64_t count = mesh.NumberOfTriangles;
  std::vector<FaceSides> blocks(std::size_t((count + grain - 1) / grain));
  executor.For(
    static_cast<std::int64_t>(blocks.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t block = begin; block < end; ++block)
      {
        blocks[std::size_t(block)] =
          FaceBlock(mesh, sides, numberOfPlanes, insideOut)
            .Run(block * grain, std::min(count, (block + 1) * grain), fates);
      }
    });
  FaceSides all;
  for (const FaceSides& block : blocks)
  {
    all.Touched.insert(all.Touched.end(), block.Touched.begin(), block.Touched.end());
    all.BadIndex = all.BadIndex < 0 ? block.BadIndex : all.BadIndex;
    all.BadCoordinate = all.BadCoordinate < 0 ? block.BadCoordinate : all.BadCoordinate;
  }
  return all;
}

} // namespace sb
