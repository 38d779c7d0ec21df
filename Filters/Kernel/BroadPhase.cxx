// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BroadPhase.cxx
 * @brief From all triangles to candidates (in the other surfaces' boxes), to survivors (near another surface), to pairs.
 *
 * 1. Surfaces: the *region* of a surface encloses what its box has in common with the others' boxes.
 * 2. Points: each is given the code of its cell in a grid over the regions, and marks the cell (OccupancyGrid.h).
 * 3. Triangles, first pass: those that are large for the grid mark all the cells of their boxes.
 * 4. Triangles, second pass: those that are not near a cell which two surfaces share are dropped. The others survive.
 * 5. Pairs: of two surfaces whose boxes meet, the one with fewer survivors goes into the hierarchy, and the other's ask.
 *
 * Memory is linear: 4 bytes a point, some bytes a triangle for the grid, 300 a survivor in the hierarchy, 32 a pair.
 */
#include "BroadPhase.h"

#include "BVH.h"
#include "OccupancyGrid.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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

/** A large triangle may touch as many cells however many of its kind there are. */
constexpr std::int64_t CellsOfAnyLarge = 64;

struct Survivor
{
  std::int32_t Surface;
  std::int32_t Triangle;
};

/** A range of one surface's triangles, the unit of parallel work, and what the passes find in it. */
struct Chunk
{
  struct LargeTriangle
  {
    std::int32_t Triangle;
    CellRange Cells;
  };

  std::int32_t Surface;
  std::int64_t Begin;
  std::int64_t End;
  bool Inside = false; ///< whether a first corner is in or beside the region
  std::vector<LargeTriangle> Large;
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

bool IsEmpty(const Box& box)
{
  return box.Lower[0] > box.Upper[0];
}

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

  /** Call visit(i, j, common part) for all surfaces i and j whose boxes meet: each pair both ways round. */
  template <class Visit>
  void ForEachPair(Visit&& visit) const
  {
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      this->Tree.ForEachOverlap(this->Boxes[i], [&](std::int32_t other) {
        const std::size_t j = static_cast<std::size_t>(other);
        if (i != j)
        {
          visit(this->Ids[i], this->Ids[j], CommonPart(this->Boxes[i], this->Boxes[j]));
        }
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
  neighbourhood.ForEachPair([&](std::size_t i, std::size_t, const Box& common) {
    Enclose(regions[i], common);
  });
  return regions;
}

std::vector<Chunk> CutIntoChunks(const Surfaces& surfaces, const std::vector<Box>& regions)
{
  std::vector<Chunk> chunks;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (IsEmpty(regions[i]))
    {
      continue;
    }
    for (std::int64_t begin = 0; begin < surfaces[i].NumberOfTriangles; begin += ChunkSize)
    {
      const std::int64_t end = std::min(begin + ChunkSize, surfaces[i].NumberOfTriangles);
      chunks.push_back({ static_cast<std::int32_t>(i), begin, end, false, {}, {} });
    }
  }
  return chunks;
}

/** Evenly spaced triangles of all surfaces: how many candidates there are and how large. */
class Sample
{
public:
  Sample(const Surfaces& surfaces, const std::vector<Box>& regions)
    : Region(EmptyBox())
  {
    std::int64_t triangles = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      Enclose(this->Region, regions[i]);
      triangles += IsEmpty(regions[i]) ? 0 : surfaces[i].NumberOfTriangles;
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      if (!IsEmpty(regions[i]))
      {
        this->Take(surfaces[i], regions[i], std::max<std::int64_t>(triangles / SampleSize, 1));
      }
    }
  }

  /** The finest grid that costs no more than MostCells and MostMarks for each candidate. */
  GridShape FinestLinearGrid() const
  {
    // Cells need not be smaller than the triangles, but are not flattened with them at will: where all triangles lie
    // flat, the surfaces still have to be told apart across the layers.
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
      grid.SmallestSides[axis] = std::max({ this->MeanSides[axis], longest / 8, reach * 1e-6, 1e-300 });
      this->SetBits(grid, axis, 3);
    }
    for (bool refined = true; refined;)
    {
      // Halve the cells along the axis on which they are longest for the triangles.
      refined = false;
      std::size_t axis = 0;
    }
    return GridShape(this->Region, grid.Bits, grid.Sides);
  }

private:
  struct Element
  {
    std::array<double, 3> Sides;
    double Weight; ///< how many triangles it stands for
  };

  void Take(const BroadPhaseSurface& surface, const Box& region, std::int64_t usualStride)
  {
    const std::int64_t count = surface.NumberOfTriangles;
    const std::int64_t stride =
      std::max<std::int64_t>(std::min(usualStride, count / SmallestSample), 1);
    for (std::int64_t triangle = 0; triangle < count; triangle += stride)
    {
      const Box box = BoxOf(surface, triangle);
      if (!Overlap(box, region))
      {
        continue;
      }
      const Box inside = CommonPart(box, region);
      Element element;
      element.Weight = static_cast<double>(stride);
      this->Candidates += element.Weight;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        element.Sides[axis] = inside.Upper[axis] - inside.Lower[axis];
        this->MeanSides[axis] +=
          (element.Sides[axis] - this->MeanSides[axis]) * element.Weight / this->Candidates;
      }
      this->Elements.push_back(element);
    }
  }

  static std::array<double, 3> Scaled(const std::array<double, 3>& sides, int quarterOctaves)
  {
    const double factor = std::exp2(0.25 * quarterOctaves);
    return { sides[0] * factor, sides[1] * factor, sides[2] * factor };
  }

  bool Fits(const std::array<double, 3>& cellSides) const
  {
    double cells = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      cells *= (this->Region.Upper[axis] - this->Region.Lower[axis]) / cellSides[axis] + 1.0;
    }
    const double scale = std::max(this->Candidates, static_cast<double>(SampleSize));
    if (cells > std::min(MostCells * scale, LargestGrid))
    {
      return false;
    }
    double marks = 0.0;
    for (const Element& element : this->Elements)
    {
      marks += element.Weight * (element.Sides[0] / cellSides[0] + 1.0) *
        (element.Sides[1] / cellSides[1] + 1.0) * (element.Sides[2] / cellSides[2] + 1.0);
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

void MarkChunk(Chunk& chunk, const BroadPhaseSurface& surface, const Box& region,
  const GridShape& shape, OccupancyGrid& grid)
{
  const OccupancyGrid::Owner owner = OwnerOf(chunk, surface);
  for (std::int64_t triangle = chunk.Begin; triangle < chunk.End; ++triangle)
  {
    const Box box = BoxOf(surface, triangle);
    if (!Overlap(box, region))
    {
      continue;
    }
    const CellRange cells = shape.Cells(box);
    OccupancyGrid::Block block = NoBlock;
    if (cells.Count() > MostCellsOfSmall)
    {
      chunk.Large.push_back(cells);
    }
    else
    {
      block = grid.ToBlock(cells);
      grid.Mark(block, owner);
    }
    chunk.Candidates.push_back({ static_cast<std::int32_t>(triangle), block });
  }
}

/** How many cells each of the large triangles may touch for all of them to stay linear in the candidates. */
std::int64_t MostCellsOfLarge(const std::vector<Chunk>& chunks)
{
  std::size_t large = 0;
  std::size_t candidates = 0;
  for (const Chunk& chunk : chunks)
  {
    large += chunk.Large.size();
    candidates += chunk.Candidates.size();
  }
  return std::max(MostCellsOfSmall,
    static_cast<std::int64_t>(2 * candidates / std::max<std::size_t>(large, 1)));
}

/** Mark for the large triangles, each on the finest level where it touches no more than `mostCells`. */
void MarkLarge(const std::vector<Chunk>& chunks, const Surfaces& surfaces, std::int64_t mostCells,
  OccupancyGrid& grid, Executor& executor)
{
  struct Task
  {
    CellRange Cells;
    std::size_t Level;
    OccupancyGrid::Owner Owner;
  };
  std::vector<Task> tasks;
  for (const Chunk& chunk : chunks)
  {
    for (const CellRange& cells : chunk.Large)
    {
      const std::size_t level = cells.LevelFor(mostCells);
      grid.AddLevelsUpTo(level);
      tasks.push_back(
        { cells, level, OwnerOf(chunk, surfaces[static_cast<std::size_t>(chunk.Surface)]) });
    }
  }
  executor.For(
    static_cast<std::int64_t>(tasks.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const Task& task = tasks[static_cast<std::size_t>(i)];
        grid.Mark(task.Cells, task.Level, task.Owner);
      }
    });
  grid.HandDown(executor);
}

/** Large triangles that were marked coarsely survive unasked: they have been too many to be asked one by one. */
void KeepSurvivors(Chunk& chunk, const OccupancyGrid& grid, std::int64_t mostCells)
{
  auto large = chunk.Large.begin();
  for (const Chunk::Candidate& candidate : chunk.Candidates)
  {
    bool keep;
    if (candidate.Cells.First != NoBlock.First)
    {
      keep = grid.AnyShared(candidate.Cells);
    }
    else
    {
      keep = large->Count() > mostCells || grid.AnyShared(*large);
      ++large;
    }
    if (keep)
    {
      chunk.Survivors.push_back(candidate.Triangle);
    }
  }
  std::vector<Chunk::Candidate>().swap(chunk.Candidates);
}

/** All survivors, sorted by surface and triangle as the chunks are. */
std::vector<Survivor> Gather(const std::vector<Chunk>& chunks)
{
  std::size_t count = 0;
  for (const Chunk& chunk : chunks)
  {
    count += chunk.Survivors.size();
  }
  std::vector<Survivor> survivors;
  survivors.reserve(count);
  for (const Chunk& chunk : chunks)
  {
    for (const std::int32_t triangle : chunk.Survivors)
    {
      survivors.push_back({ chunk.Surface, triangle });
    }
  }
  return survivors;
}

/** Steps 1 to 3. */
std::vector<Survivor> FindSurvivors(const Surfaces& surfaces, const Neighbourhood& neighbourhood,
  Executor& executor, Monitor& monitor)
{
  const std::vector<Box> regions = FindRegions(surfaces, neighbourhood);
  std::vector<Chunk> chunks = CutIntoChunks(surfaces, regions);
  if (chunks.empty())
  {
    return {};
  }
  const GridShape shape = Sample(surfaces, regions).FinestLinearGrid();
  OccupancyGrid grid(shape.CellsAnAxis());
  const auto mark = [&](Chunk& chunk) {
    const std::size_t i = static_cast<std::size_t>(chunk.Surface);
    MarkChunk(chunk, surfaces[i], regions[i], shape, grid);
  };
  if (!ForEachChunk(chunks, executor, monitor, mark))
  {
    return {};
  }
  const std::int64_t mostCells = MostCellsOfLarge(chunks);
  MarkLarge(chunks, surfaces, mostCells, grid, executor);
  const auto keep = [&](Chunk& chunk) { KeepSurvivors(chunk, grid, mostCells); };
  if (!ForEachChunk(chunks, executor, monitor, keep))
  {
    return {};
  }
  return Gather(chunks);
}

/** What a surface does in step 4. */
struct Role
{
  std::int64_t NumberOfSurvivors = 0;
  bool InTree = false;
  bool Asks = false;
};

std::vector<Role> AssignRoles(const Surfaces& surfaces, const Neighbourhood& neighbourhood,
  const std::vector<Survivor>& survivors)
{
  std::vector<Role> roles(surfaces.size());
  for (const Survivor& survivor : survivors)
  {
    ++roles[static_cast<std::size_t>(survivor.Surface)].NumberOfSurvivors;
  }
  const auto isLighter = [&roles](std::size_t i, std::size_t j) {
    return roles[i].NumberOfSurvivors != roles[j].NumberOfSurvivors
      ? roles[i].NumberOfSurvivors < roles[j].NumberOfSurvivors
      : i < j;
  };
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    roles[i].InTree = roles[i].Asks = surfaces[i].Self;
  }
  neighbourhood.ForEachPair([&](std::size_t i, std::size_t j, const Box&) {
    roles[i].InTree = roles[i].InTree || isLighter(i, j);
  });
  neighbourhood.ForEachPair([&](std::size_t i, std::size_t j, const Box&) {
    roles[i].Asks = roles[i].Asks || (roles[j].InTree && (!roles[i].InTree || i < j));
  });
  return roles;
}

/** Step 4. A pair is found as the numbers of its two survivors, the lower one in the upper half. */
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
    this->Boxes.resize(this->InTree.size());
    executor.For(static_cast<std::int64_t>(this->Boxes.size()), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          this->Boxes[i] = this->BoxOfSurvivor(this->InTree[i]);
        }
      });
    this->Tree.Build(this->Boxes.data(), static_cast<std::int32_t>(this->Boxes.size()), executor);
  }

  std::vector<std::uint64_t> Run(Executor& executor, Monitor& monitor) const
  {
    const std::int64_t count = static_cast<std::int64_t>(this->Survivors.size());
    std::vector<std::vector<std::uint64_t>> found(static_cast<std::size_t>((count + Grain - 1) / Grain));
    executor.For(static_cast<std::int64_t>(found.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t block = begin; block < end && !monitor.Aborted(); ++block)
      {
        const std::int64_t last = std::min(count, (block + 1) * Grain);
        for (std::int64_t i = block * Grain; i < last; ++i)
        {
          this->Ask(static_cast<std::int32_t>(i), found[static_cast<std::size_t>(block)]);
        }
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

  /**
   * Each pair has to be found from one side only: where both surfaces are in the tree, from the lower survivor; where
   * one is, from the other.
   */
  void Ask(std::int32_t i, std::vector<std::uint64_t>& found) const
  {
    const Survivor& asking = this->Survivors[static_cast<std::size_t>(i)];
    const Role& role = this->RoleOf(asking);
    if (!role.Asks)
    {
      return;
    }
    const bool self = this->AllSurfaces[static_cast<std::size_t>(asking.Surface)].Self;
    this->Tree.ForEachOverlap(this->BoxOfSurvivor(i), [&](std::int32_t box) {
      const std::int32_t j = this->InTree[static_cast<std::size_t>(box)];
      const std::int32_t surface = this->Survivors[static_cast<std::size_t>(j)].Surface;
      if ((role.InTree && j <= i) || (surface == asking.Surface && !self))
      {
        return;
      }
      const std::uint64_t lower = static_cast<std::uint32_t>(std::min(i, j));
      found.push_back(lower << 32 | static_cast<std::uint32_t>(std::max(i, j)));
    });
  }

  static std::vector<std::uint64_t> Concatenated(const std::vector<std::vector<std::uint64_t>>& parts)
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
  std::vector<Box> Boxes;
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
