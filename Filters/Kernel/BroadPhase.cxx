// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BroadPhase.cxx
 * @brief From all triangles to candidates (in the other surfaces' boxes), to survivors (near
 * another surface), to pairs.
 *
 * 1. Surfaces: the *region* of a surface encloses what its box has in common with the others'
 * boxes.
 * 2. Blocks: what is in no block that meets another surface's block is dropped (TriangleBlocks.h).
 * 3. Points: each gets the code of its cell in a grid over the regions, and marks the cell
 * (OccupancyGrid.h).
 * 4. Triangles, first pass: where the box touches more cells than the corners are in, it marks them
 * all. The grid is chosen so that this is rare, and so most of the work is done for points, which
 * are fewer and lie in a row.
 * 5. Triangles, second pass: those survive that touch a cell which several surfaces marked.
 * 6. Pairs: of two surfaces whose boxes meet, the one with fewer survivors goes into the hierarchy,
 * and the other's ask.
 *
 * Memory is linear: 4 bytes a point, some bytes a triangle for the grid, 300 a survivor in the
 * hierarchy, 32 a pair.
 */
#include "BroadPhase.h"

#include "BVH.h"
#include "OccupancyGrid.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

namespace sb
{

namespace
{

using Surfaces = std::vector<BroadPhaseSurface>;

constexpr std::int64_t ChunkSize = 8192;
constexpr std::int64_t SampleSize = 2048;
constexpr std::int64_t SmallestSample = 16;

// What the grid may cost: cells, and cells marked by large triangles, for each candidate.
constexpr double MostCells = 2.0;
constexpr double MostMarks = 2.0;
constexpr int MostBits = 23;

/** A triangle that touches more cells is large, and marks only once all the large ones are known.
 */
constexpr std::int64_t MostCellsOfSmall = 64;

struct Survivor
{
  std::int32_t Surface;
  std::int32_t Triangle;
};

/** A range of one surface's triangles, the unit of parallel work, and what the passes find in it.
 */
struct Chunk
{
  std::int32_t Surface;
  std::int64_t Begin;
  std::int64_t End;
  bool Inside = false; ///< whether a corner is inside the surface's region
  std::vector<std::int32_t> Wide; ///< triangles that touch more cells than their corners are in
  std::vector<CellRange> Large; ///< the cells of those with too many to be marked at once
  std::vector<std::int32_t> Survivors;
};

Box BoxOf(const BroadPhaseSurface& surface, std::int64_t triangle)
{
  const std::int32_t* const corners = surface.Triangles + 3 * triangle;
  const double* const a = surface.Points + 3 * static_cast<std::int64_t>(corners[0]);
  const double* const b = surface.Points + 3 * static_cast<std::int64_t>(corners[1]);
  const double* const c = surface.Points + 3 * static_cast<std::int64_t>(corners[2]);
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.Lower[axis] = std::min(std::min(a[axis], b[axis]), c[axis]);
    box.Upper[axis] = std::max(std::max(a[axis], b[axis]), c[axis]);
  }
  return box;
}

Box BoxOf(const BroadPhaseSurface& surface)
{
  const std::array<double, 6>& bounds = surface.Bounds;
  return { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } };
}

Box EmptyBox()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return { { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
}

bool IsEmpty(const Box& box) { return box.Lower[0] > box.Upper[0]; }

Box CommonPart(const Box& a, const Box& b)
{
  Box common;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    common.Lower[axis] = std::max(a.Lower[axis], b.Lower[axis]);
    common.Upper[axis] = std::min(a.Upper[axis], b.Upper[axis]);
  }
  return common;
}

/** The surfaces that have triangles, and which of their boxes meet. */
class Neighbourhood
{
public:
  Neighbourhood(const Surfaces& surfaces, Executor& executor)
  {
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      if (surfaces[i].NumberOfTriangles > 0)
      {
        this->Boxes.push_back(BoxOf(surfaces[i]));
        this->Ids.push_back(i);
      }
    }
    this->Tree.Build(this->Boxes.data(), static_cast<std::int32_t>(this->Boxes.size()), executor);
  }

  /** Call visit(i, j, common part) for all surfaces i < j whose boxes meet. */
  template <class Visit>
  void ForEachPair(Visit&& visit) const
  {
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      const BVH::Query query{ this->Boxes[i], static_cast<std::int32_t>(i) + 1 };
      this->Tree.ForEachOverlap(&query, 1, [&](int, std::int32_t other) {
        const std::size_t j = static_cast<std::size_t>(other);
        visit(this->Ids[i], this->Ids[j], CommonPart(this->Boxes[i], this->Boxes[j]));
      });
    }
  }

private:
  std::vector<Box> Boxes;
  std::vector<std::size_t> Ids;
  BVH Tree;
};

std::vector<Box> FindRegions(const Surfaces& surfaces, const Neighbourhood& neighbourhood)
{
  std::vector<Box> regions(surfaces.size(), EmptyBox());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (surfaces[i].Self && surfaces[i].NumberOfTriangles > 0)
    {
      regions[i] = BoxOf(surfaces[i]);
    }
  }
  neighbourhood.ForEachPair([&](std::size_t i, std::size_t j, const Box& common) {
    Enclose(regions[i], common);
    Enclose(regions[j], common);
  });
  return regions;
}

/** What is left of one surface to look at. */
struct Remainder
{
  std::vector<Chunk> Chunks; ///< the triangles of the blocks near another surface
  std::vector<std::pair<std::int32_t, std::int32_t>> Points; ///< [first, last], ascending, apart
};

/** Ranges sorted, and those that overlap or follow each other put together. */
std::vector<std::pair<std::int32_t, std::int32_t>> Joined(
  std::vector<std::pair<std::int32_t, std::int32_t>> ranges)
{
  std::sort(ranges.begin(), ranges.end());
  std::size_t last = 0;
  for (std::size_t i = 1; i < ranges.size(); ++i)
  {
    if (ranges[i].first <= ranges[last].second + 1)
    {
      ranges[last].second = std::max(ranges[last].second, ranges[i].second);
    }
    else
    {
      ranges[++last] = ranges[i];
    }
  }
  ranges.resize(std::min(ranges.size(), last + 1));
  return ranges;
}

Remainder RemainderOf(std::int32_t surface, const std::vector<TriangleBlock>& blocks,
  std::int64_t numberOfTriangles, const NearBlocks& near)
{
  Remainder remainder;
  for (const auto& [firstBlock, endBlock] : near.Runs(static_cast<std::size_t>(surface)))
  {
    for (std::int64_t block = firstBlock; block < endBlock; ++block)
    {
      const TriangleBlock& of = blocks[static_cast<std::size_t>(block)];
      remainder.Points.emplace_back(of.LowestPoint, of.HighestPoint);
    }
    const std::int64_t end = std::min(endBlock * TriangleBlock::Size, numberOfTriangles);
    for (std::int64_t begin = firstBlock * TriangleBlock::Size; begin < end; begin += ChunkSize)
    {
      remainder.Chunks.push_back(
        { surface, begin, std::min(begin + ChunkSize, end), false, {}, {}, {} });
    }
  }
  remainder.Points = Joined(std::move(remainder.Points));
  return remainder;
}

/** What is left of each surface after step 2. */
std::vector<Remainder> DropFarBlocks(
  const Surfaces& surfaces, const Neighbourhood& neighbourhood, Executor& executor)
{
  std::vector<std::vector<TriangleBlock>> made(surfaces.size());
  std::vector<const std::vector<TriangleBlock>*> blocks;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const BroadPhaseSurface& surface = surfaces[i];
    if (!surface.Blocks)
    {
      made[i] = BlocksOf(surface.Points, surface.Triangles, surface.NumberOfTriangles, executor);
    }
    blocks.push_back(surface.Blocks ? surface.Blocks : &made[i]);
  }
  NearBlocks near(blocks, executor);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (surfaces[i].Self)
    {
      near.MarkAll(i);
    }
  }
  neighbourhood.ForEachPair(
    [&near](std::size_t i, std::size_t j, const Box& common) { near.MarkMeeting(i, j, common); });
  std::vector<Remainder> remainders;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    remainders.push_back(
      RemainderOf(static_cast<std::int32_t>(i), *blocks[i], surfaces[i].NumberOfTriangles, near));
  }
  return remainders;
}

/** Evenly spaced triangles of what is left of all surfaces: how many candidates there are and how
 * large. */
class Sample
{
public:
  Sample(const Surfaces& surfaces, const std::vector<Box>& regions,
    const std::vector<Remainder>& remainders)
    : Region(EmptyBox())
  {
    std::int64_t triangles = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      Enclose(this->Region, regions[i]);
      triangles += NumberOfTriangles(remainders[i]);
    }
    const std::int64_t usualStride = std::max<std::int64_t>(triangles / SampleSize, 1);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      const std::int64_t most = NumberOfTriangles(remainders[i]) / SmallestSample;
      const std::int64_t stride = std::max<std::int64_t>(std::min(usualStride, most), 1);
      std::int64_t skip = 0;
      for (const Chunk& chunk : remainders[i].Chunks)
      {
        skip = this->Take(surfaces[i], regions[i], chunk, skip, stride);
      }
    }
  }

  /** The finest grid that costs no more than MostCells and MostMarks for each candidate. */
  GridShape FinestLinearGrid() const
  {
    // Cells need not be smaller than the triangles, but are not flattened with them at will: where
    // all triangles lie flat, the surfaces still have to be told apart across the layers.
    double longest = 0.0;
    double reach = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      longest = std::max(longest, this->MeanSides[axis]);
      reach = std::max(reach, this->Region.Upper[axis] - this->Region.Lower[axis]);
    }
    Grid grid{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      grid.SmallestSides[axis] =
        std::max({ this->MeanSides[axis], longest / 8, reach * 1e-6, 1e-300 });
      this->SetBits(grid, axis, 3);
    }
    // Halve the cells along the axis on which they are longest for the triangles, as long as that
    // is affordable.
    for (std::array<bool, 3> open{ true, true, true };;)
    {
      std::size_t longestAxis = 3;
      double longestRatio = 1.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double ratio = grid.Sides[axis] / grid.SmallestSides[axis];
        if (open[axis] && ratio > longestRatio)
        {
          longestAxis = axis;
          longestRatio = ratio;
        }
      }
      if (longestAxis == 3)
      {
        return GridShape(this->Region, grid.Bits, grid.Sides);
      }
      Grid finer = grid;
      this->SetBits(finer, longestAxis, grid.Bits[longestAxis] + 1);
      open[longestAxis] = this->IsAffordable(finer);
      grid = open[longestAxis] ? finer : grid;
    }
  }

private:
  struct Element
  {
    std::array<double, 3> Sides;
    double Weight; ///< how many triangles it stands for
  };

  struct Grid
  {
    std::array<int, 3> Bits;
    std::array<double, 3> Sides;
    std::array<double, 3> SmallestSides;
  };

  static std::int64_t NumberOfTriangles(const Remainder& remainder)
  {
    std::int64_t number = 0;
    for (const Chunk& chunk : remainder.Chunks)
    {
      number += chunk.End - chunk.Begin;
    }
    return number;
  }

  /** Take every stride-th triangle of a chunk after the first `skip`; returns how many to skip in
   * the next. */
  std::int64_t Take(const BroadPhaseSurface& surface, const Box& region, const Chunk& chunk,
    std::int64_t skip, std::int64_t stride)
  {
    std::int64_t triangle = chunk.Begin + skip;
    for (; triangle < chunk.End; triangle += stride)
    {
      const Box box = BoxOf(surface, triangle);
      if (Overlap(box, region))
      {
        this->Add(CommonPart(box, region), static_cast<double>(stride));
      }
    }
    return triangle - chunk.End;
  }

  void Add(const Box& inside, double weight)
  {
    Element element;
    element.Weight = weight;
    this->Candidates += weight;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      element.Sides[axis] = inside.Upper[axis] - inside.Lower[axis];
      this->MeanSides[axis] +=
        (element.Sides[axis] - this->MeanSides[axis]) * weight / this->Candidates;
    }
    this->Elements.push_back(element);
  }

  void SetBits(Grid& grid, std::size_t axis, int bits) const
  {
    const double reach = this->Region.Upper[axis] - this->Region.Lower[axis];
    grid.Bits[axis] = bits;
    grid.Sides[axis] = std::max(reach / ((1 << bits) - GridShape::Spare), grid.SmallestSides[axis]);
  }

  bool IsAffordable(const Grid& grid) const
  {
    const int bits = grid.Bits[0] + grid.Bits[1] + grid.Bits[2];
    const double scale = std::max(this->Candidates, static_cast<double>(SampleSize));
    if (bits > MostBits || std::ldexp(1.0, bits) > MostCells * scale)
    {
      return false;
    }
    double marks = 0.0;
    for (const Element& element : this->Elements)
    {
      double cells = 1.0;
      bool large = false;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        cells *= element.Sides[axis] / grid.Sides[axis] + 1.0;
        large = large || element.Sides[axis] > grid.Sides[axis];
      }
      marks += large ? element.Weight * cells : 0.0;
    }
    return marks <= MostMarks * scale;
  }

  Box Region;
  std::vector<Element> Elements;
  double Candidates = 0.0;
  std::array<double, 3> MeanSides{};
};

/** Run body(chunk) over all chunks in parallel; false if the caller wants to stop. */
template <class Body>
bool ForEachChunk(std::vector<Chunk>& chunks, Executor& executor, Monitor& monitor, Body&& body)
{
  executor.For(
    static_cast<std::int64_t>(chunks.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end && !monitor.Aborted(); ++i)
      {
        body(chunks[static_cast<std::size_t>(i)]);
      }
    });
  return !monitor.Aborted();
}

/** Steps 3 to 5; the words of the grid have to hold the numbers of the surfaces twice. */
template <class Word>
class SurvivorSearch
{
public:
  SurvivorSearch(const Surfaces& surfaces, const std::vector<Box>& regions,
    std::vector<Remainder> remainders, Executor& executor, Monitor& monitor)
    : AllSurfaces(surfaces)
    , Host(executor)
    , Ear(monitor)
    , Shape(Sample(surfaces, regions, remainders).FinestLinearGrid())
    , Grid(this->Shape)
  {
    for (const Box& region : regions)
    {
      this->Insides.push_back(IsEmpty(region) ? CellRange{} : this->Shape.Cells(region));
    }
    for (Remainder& remainder : remainders)
    {
      this->AddPointBlocks(remainder.Points);
      std::move(remainder.Chunks.begin(), remainder.Chunks.end(), std::back_inserter(this->Chunks));
    }
  }

  std::vector<Survivor> Run()
  {
    this->Codes.reset(new std::uint32_t[static_cast<std::size_t>(this->NumberOfCodes)]);
    this->ForEach(this->Blocks, [this](PointBlock& block) { this->MarkPoints(block); });
    this->ForEach(this->Chunks, [this](Chunk& chunk) { this->MarkWide(chunk); });
    const std::int64_t mostCells = this->MarkLarge();
    this->ForEach(this->Blocks, [this](const PointBlock& block) { this->FlagPoints(block); });
    this->ForEach(this->Chunks, [this, mostCells](Chunk& chunk) { this->Keep(chunk, mostCells); });
    return this->Gather();
  }

private:
  /** In a point's code: set if the point is inside the region, later only if its cell is shared. */
  static constexpr std::uint32_t Flag = GridShape::FreeBit;

  /** A range of one surface's points. */
  struct PointBlock
  {
    std::size_t Surface;
    std::int64_t Begin;
    std::int64_t End;
    bool Inside; ///< whether any is inside the region
  };

  /** Run body(item) for all items in parallel, unless the caller wants to stop. */
  template <class Item, class Body>
  void ForEach(std::vector<Item>& items, Body&& body)
  {
    this->Host.For(
      static_cast<std::int64_t>(items.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end && !this->Ear.Aborted(); ++i)
        {
          body(items[static_cast<std::size_t>(i)]);
        }
      });
  }

  /** The mark of a surface; one that is to meet itself marks as two. */
  Word MarkOf(std::size_t surface) const
  {
    return this->AllSurfaces[surface].Self
      ? OccupancyGrid<Word>::Everybody
      : OccupancyGrid<Word>::MarkOf(static_cast<std::int32_t>(surface));
  }

  /** Make blocks of the next surface's points. Room is made for the codes of the others, too, but
   * never touched. */
  void AddPointBlocks(const std::vector<std::pair<std::int32_t, std::int32_t>>& ranges)
  {
    const std::size_t surface = this->FirstCodes.size();
    this->FirstCodes.push_back(this->NumberOfCodes);
    for (const auto& [first, last] : ranges)
    {
      for (std::int64_t begin = first; begin <= last; begin += ChunkSize)
      {
        this->Blocks.push_back(
          { surface, begin, std::min<std::int64_t>(begin + ChunkSize, last + 1), false });
      }
    }
    this->NumberOfCodes += ranges.empty() ? 0 : ranges.back().second + 1;
  }

  std::uint32_t* CodesOf(std::size_t surface) const
  {
    return this->Codes.get() + this->FirstCodes[surface];
  }

  void MarkPoints(PointBlock& block)
  {
    const double* const points = this->AllSurfaces[block.Surface].Points;
    std::uint32_t* const codes = this->CodesOf(block.Surface);
    const CellRange& inside = this->Insides[block.Surface];
    const Word mark = this->MarkOf(block.Surface);
    std::array<double, 3> before;
    std::array<double, 3> behind;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      before[axis] = inside.First[axis] - 1;
      behind[axis] = inside.Last[axis] + 1;
    }
    const GridShape shape = this->Shape; // a copy, which the marks cannot be suspected to change
    for (std::int64_t i = block.Begin; i < block.End; ++i)
    {
      std::array<std::int32_t, 3> cell;
      bool isInside = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double coordinate = points[3 * i + static_cast<std::int64_t>(axis)];
        cell[axis] = shape.Cell(coordinate, axis, before[axis], behind[axis]);
        isInside =
          isInside & (cell[axis] >= inside.First[axis]) & (cell[axis] <= inside.Last[axis]);
      }
      const std::uint32_t code = shape.Code(cell);
      codes[i] = isInside ? code | Flag : code;
      if (isInside)
      {
        this->Grid.MarkCell(shape.Index(code), mark);
        block.Inside = true;
      }
    }
  }

  void MarkWide(Chunk& chunk)
  {
    const std::size_t surface = static_cast<std::size_t>(chunk.Surface);
    const std::int32_t* const triangles = this->AllSurfaces[surface].Triangles;
    const std::uint32_t* const codes = this->CodesOf(surface);
    const Word mark = this->MarkOf(surface);
    const GridShape shape = this->Shape;
    std::uint32_t flags = 0;
    for (std::int64_t triangle = chunk.Begin; triangle < chunk.End; ++triangle)
    {
      const std::int32_t* const corners = triangles + 3 * triangle;
      const std::uint32_t a = codes[corners[0]];
      const std::uint32_t b = codes[corners[1]];
      const std::uint32_t c = codes[corners[2]];
      flags |= a | b | c;
      if (shape.IsCompact(a, b, c))
      {
        continue;
      }
      const CellRange cells = this->CellsOf(a, b, c, this->Insides[surface]);
      if (cells.IsEmpty())
      {
        continue;
      }
      chunk.Wide.push_back(static_cast<std::int32_t>(triangle));
      if (cells.Count() <= MostCellsOfSmall)
      {
        this->Grid.MarkRange(cells, 0, mark);
      }
      else
      {
        chunk.Large.push_back(cells);
      }
    }
    chunk.Inside = (flags & Flag) != 0;
  }

  /** The cells inside the region that the box of a triangle touches, from its corners' codes. */
  CellRange CellsOf(
    std::uint32_t a, std::uint32_t b, std::uint32_t c, const CellRange& inside) const
  {
    CellRange cells;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int32_t cellA = this->Shape.CellOf(a, axis);
      const std::int32_t cellB = this->Shape.CellOf(b, axis);
      const std::int32_t cellC = this->Shape.CellOf(c, axis);
      cells.First[axis] = std::max(std::min({ cellA, cellB, cellC }), inside.First[axis]);
      cells.Last[axis] = std::min(std::max({ cellA, cellB, cellC }), inside.Last[axis]);
    }
    return cells;
  }

  /**
   * Mark for the large triangles, each at the finest level where it touches few enough cells for
   * all of them to stay linear in the triangles. Returns that number of cells.
   */
  std::int64_t MarkLarge()
  {
    std::int64_t large = 0;
    std::int64_t triangles = 0;
    for (const Chunk& chunk : this->Chunks)
    {
      large += static_cast<std::int64_t>(chunk.Large.size());
      triangles += chunk.End - chunk.Begin;
    }
    const std::int64_t mostCells =
      std::max(MostCellsOfSmall, 2 * triangles / std::max<std::int64_t>(large, 1));
    for (const Chunk& chunk : this->Chunks)
    {
      for (const CellRange& cells : chunk.Large)
      {
        this->Grid.AddLevelsUpTo(cells.LevelFor(mostCells));
      }
    }
    this->ForEach(this->Chunks, [this, mostCells](const Chunk& chunk) {
      for (const CellRange& cells : chunk.Large)
      {
        this->Grid.MarkRange(
          cells, cells.LevelFor(mostCells), this->MarkOf(static_cast<std::size_t>(chunk.Surface)));
      }
    });
    this->Grid.HandDown(this->Host);
    return mostCells;
  }

  void FlagPoints(const PointBlock& block)
  {
    if (!block.Inside)
    {
      return;
    }
    std::uint32_t* const codes = this->CodesOf(block.Surface);
    for (std::int64_t i = block.Begin; i < block.End; ++i)
    {
      const bool isShared = this->Grid.IsShared(this->Shape.Index(codes[i]));
      codes[i] = isShared ? codes[i] : codes[i] & ~Flag;
    }
  }

  /** Wide triangles that touch more than `mostCells` cells survive unasked: there may be too many
   * of them to ask. */
  void Keep(Chunk& chunk, std::int64_t mostCells) const
  {
    const std::size_t surface = static_cast<std::size_t>(chunk.Surface);
    const std::int32_t* const triangles = this->AllSurfaces[surface].Triangles;
    const std::uint32_t* const codes = this->CodesOf(surface);
    const auto codeOf = [triangles, codes](std::int64_t triangle, std::int64_t corner) {
      return codes[triangles[3 * triangle + corner]];
    };
    for (std::int64_t i = chunk.Begin; chunk.Inside && i < chunk.End; ++i)
    {
      if (((codeOf(i, 0) | codeOf(i, 1) | codeOf(i, 2)) & Flag) != 0)
      {
        chunk.Survivors.push_back(static_cast<std::int32_t>(i));
      }
    }
    const std::ptrdiff_t compact = static_cast<std::ptrdiff_t>(chunk.Survivors.size());
    for (const std::int32_t i : chunk.Wide)
    {
      const std::uint32_t a = codeOf(i, 0);
      const std::uint32_t b = codeOf(i, 1);
      const std::uint32_t c = codeOf(i, 2);
      if (((a | b | c) & Flag) == 0)
      {
        const CellRange cells = this->CellsOf(a, b, c, this->Insides[surface]);
        if (cells.Count() > mostCells || this->Grid.AnyShared(cells))
        {
          chunk.Survivors.push_back(i);
        }
      }
    }
    std::inplace_merge(
      chunk.Survivors.begin(), chunk.Survivors.begin() + compact, chunk.Survivors.end());
  }

  /** All survivors, sorted by surface and triangle as the chunks are. */
  std::vector<Survivor> Gather() const
  {
    std::size_t count = 0;
    for (const Chunk& chunk : this->Chunks)
    {
      count += chunk.Survivors.size();
    }
    std::vector<Survivor> survivors;
    survivors.reserve(count);
    for (const Chunk& chunk : this->Chunks)
    {
      for (const std::int32_t triangle : chunk.Survivors)
      {
        survivors.push_back({ chunk.Surface, triangle });
      }
    }
    return survivors;
  }

  const Surfaces& AllSurfaces;
  Executor& Host;
  Monitor& Ear;
  GridShape Shape;
  OccupancyGrid<Word> Grid;
  std::vector<Chunk> Chunks;
  std::vector<CellRange> Insides; ///< [surface], the cells of its region
  std::vector<PointBlock> Blocks;
  std::vector<std::int64_t> FirstCodes; ///< [surface], where the code of its point 0 is
  std::int64_t NumberOfCodes = 0;
  std::unique_ptr<std::uint32_t[]> Codes; ///< of all points of all surfaces, with their flags
};

std::vector<Survivor> FindSurvivors(const Surfaces& surfaces, const Neighbourhood& neighbourhood,
  Executor& executor, Monitor& monitor)
{
  const std::vector<Box> regions = FindRegions(surfaces, neighbourhood);
  if (std::all_of(regions.begin(), regions.end(), IsEmpty))
  {
    return {};
  }
  std::vector<Remainder> remainders = DropFarBlocks(surfaces, neighbourhood, executor);
  return surfaces.size() <= 16
    ? SurvivorSearch<std::uint8_t>(surfaces, regions, std::move(remainders), executor, monitor)
        .Run()
    : SurvivorSearch<std::uint32_t>(surfaces, regions, std::move(remainders), executor, monitor)
        .Run();
}

/** What a surface does in step 6. Its survivors are in a row, and so are those of them in the tree.
 */
struct Role
{
  std::int32_t Begin = 0; ///< its first survivor
  std::int32_t End = 0; ///< one past its last
  std::int32_t TreeBegin = 0; ///< how many boxes of the surfaces before it are in the tree
  bool Self = false;
  bool InTree = false;
  bool Asks = false;

  std::int32_t NumberOfSurvivors() const { return this->End - this->Begin; }

  /**
   * The first box in the tree to ask survivor i about. Each pair has to be found from one side
   * only: where both surfaces are in the tree, from the lower survivor; where one is, from the
   * other.
   */
  std::int32_t FirstBox(std::int32_t i) const
  {
    return !this->InTree ? 0 : this->TreeBegin + (this->Self ? i + 1 : this->End) - this->Begin;
  }
};

std::vector<Role> AssignRoles(const Surfaces& surfaces, const Neighbourhood& neighbourhood,
  const std::vector<Survivor>& survivors)
{
  std::vector<Role> roles(surfaces.size());
  for (const Survivor& survivor : survivors)
  {
    ++roles[static_cast<std::size_t>(survivor.Surface)].End;
  }
  std::int32_t end = 0;
  for (Role& role : roles)
  {
    role.Begin = end;
    role.End = end += role.End;
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    roles[i].InTree = roles[i].Asks = roles[i].Self = surfaces[i].Self;
  }
  neighbourhood.ForEachPair([&](std::size_t i, std::size_t j, const Box&) {
    (roles[i].NumberOfSurvivors() <= roles[j].NumberOfSurvivors() ? roles[i] : roles[j]).InTree =
      true;
  });
  neighbourhood.ForEachPair([&](std::size_t i, std::size_t j, const Box&) {
    (roles[j].InTree ? roles[i] : roles[j]).Asks = true;
  });
  std::int32_t boxes = 0;
  for (Role& role : roles)
  {
    role.TreeBegin = boxes;
    boxes += role.InTree ? role.NumberOfSurvivors() : 0;
  }
  return roles;
}

/** Step 5. A pair is found as the numbers of its two survivors, the lower one in the upper half. */
class PairSearch
{
public:
  PairSearch(const Surfaces& surfaces, const std::vector<Role>& roles,
    const std::vector<Survivor>& survivors, Executor& executor)
    : AllSurfaces(surfaces)
    , Roles(roles)
    , Survivors(survivors)
  {
    for (std::size_t i = 0; i < survivors.size(); ++i)
    {
      if (this->RoleOf(survivors[i]).InTree)
      {
        this->InTree.push_back(static_cast<std::int32_t>(i));
      }
    }
    std::vector<Box> boxes(this->InTree.size());
    executor.For(
      static_cast<std::int64_t>(boxes.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          boxes[i] = this->BoxOfSurvivor(this->InTree[i]);
        }
      });
    this->Tree.Build(boxes.data(), static_cast<std::int32_t>(boxes.size()), executor);
  }

  std::vector<std::uint64_t> Run(Executor& executor, Monitor& monitor) const
  {
    const std::int64_t count = static_cast<std::int64_t>(this->Survivors.size());
    std::vector<std::vector<std::uint64_t>> found(
      static_cast<std::size_t>((count + Grain - 1) / Grain));
    executor.For(
      static_cast<std::int64_t>(found.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end && !monitor.Aborted(); ++block)
        {
          this->Ask(static_cast<std::int32_t>(block * Grain),
            static_cast<std::int32_t>(std::min(count, (block + 1) * Grain)),
            found[static_cast<std::size_t>(block)]);
        }
      });
    return Concatenated(found);
  }

private:
  static constexpr std::int64_t Grain = 1024;

  const Role& RoleOf(const Survivor& survivor) const
  {
    return this->Roles[static_cast<std::size_t>(survivor.Surface)];
  }

  Box BoxOfSurvivor(std::int32_t i) const
  {
    const Survivor& survivor = this->Survivors[static_cast<std::size_t>(i)];
    return BoxOf(this->AllSurfaces[static_cast<std::size_t>(survivor.Surface)], survivor.Triangle);
  }

  /** Survivors that ask together: in mesh order those that follow each other mostly lie near each
   * other. */
  struct Group
  {
    std::array<BVH::Query, BVH::Width> Queries;
    std::array<std::int32_t, BVH::Width> Survivors;
    int Size = 0;
    Box Bounds;
    double LongestSide = 0.0;

    /** Whether a box can join without making the group much larger than its members. */
    bool Suits(const Box& box) const
    {
      if (this->Size == 0 || this->Size == BVH::Width)
      {
        return this->Size == 0;
      }
      Box bounds = this->Bounds;
      Enclose(bounds, box);
      return sb::LongestSide(bounds) <= 4.0 * std::max(this->LongestSide, sb::LongestSide(box));
    }

    void Add(const Box& box, std::int32_t firstBox, std::int32_t survivor)
    {
      this->Size == 0 ? void(this->Bounds = box) : Enclose(this->Bounds, box);
      this->LongestSide = std::max(this->Size == 0 ? 0.0 : this->LongestSide, sb::LongestSide(box));
      this->Queries[static_cast<std::size_t>(this->Size)] = { box, firstBox };
      this->Survivors[static_cast<std::size_t>(this->Size)] = survivor;
      ++this->Size;
    }
  };

  /** Ask for the survivors begin..end-1. */
  void Ask(std::int32_t begin, std::int32_t end, std::vector<std::uint64_t>& found) const
  {
    Group group;
    for (std::int32_t i = begin; i < end; ++i)
    {
      const Role& role = this->RoleOf(this->Survivors[static_cast<std::size_t>(i)]);
      if (role.Asks)
      {
        const Box box = this->BoxOfSurvivor(i);
        if (!group.Suits(box))
        {
          this->Ask(group, found);
          group.Size = 0;
        }
        group.Add(box, role.FirstBox(i), i);
      }
    }
    this->Ask(group, found);
  }

  void Ask(const Group& group, std::vector<std::uint64_t>& found) const
  {
    this->Tree.ForEachOverlap(group.Queries.data(), group.Size, [&](int query, std::int32_t box) {
      const std::int32_t i = group.Survivors[static_cast<std::size_t>(query)];
      const std::int32_t j = this->InTree[static_cast<std::size_t>(box)];
      const std::uint64_t lower = static_cast<std::uint32_t>(std::min(i, j));
      found.push_back(lower << 32 | static_cast<std::uint32_t>(std::max(i, j)));
    });
  }

  static std::vector<std::uint64_t> Concatenated(
    const std::vector<std::vector<std::uint64_t>>& parts)
  {
    std::size_t count = 0;
    for (const std::vector<std::uint64_t>& part : parts)
    {
      count += part.size();
    }
    std::vector<std::uint64_t> all;
    all.reserve(count);
    for (const std::vector<std::uint64_t>& part : parts)
    {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  const Surfaces& AllSurfaces;
  const std::vector<Role>& Roles;
  const std::vector<Survivor>& Survivors;
  std::vector<std::int32_t> InTree; ///< survivors, ascending
  BVH Tree;
};

} // namespace

std::vector<TrianglePair> FindOverlappingPairs(
  const std::vector<BroadPhaseSurface>& surfaces, Executor& executor, Monitor& monitor)
{
  const Neighbourhood neighbourhood(surfaces, executor);
  const std::vector<Survivor> survivors = FindSurvivors(surfaces, neighbourhood, executor, monitor);
  const std::vector<Role> roles = AssignRoles(surfaces, neighbourhood, survivors);
  const PairSearch search(surfaces, roles, survivors, executor);
  std::vector<std::uint64_t> found = search.Run(executor, monitor);
  if (monitor.Aborted())
  {
    return {};
  }
  RadixSort(
    found, [](std::uint64_t pair) { return pair; }, 64, executor);
  std::vector<TrianglePair> pairs;
  pairs.reserve(found.size());
  for (const std::uint64_t pair : found)
  {
    const Survivor& a = survivors[pair >> 32];
    const Survivor& b = survivors[pair & 0xffffffffu];
    pairs.push_back({ a.Surface, a.Triangle, b.Surface, b.Triangle });
  }
  return pairs;
}

} // namespace sb
