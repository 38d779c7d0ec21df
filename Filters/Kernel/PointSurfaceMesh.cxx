// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointSurfaceMesh.h"

#include "BorderEdges.h"
#include "CubeCases.h"
#include "DisjointSets.h"
#include "EdgeRoot.h"
#include "GridBlocks.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 16; ///< of blocks
constexpr std::size_t MostBlocks = std::size_t(1) << 24;
constexpr double CurvedStep = 1e-7; ///< of FindEdgeRoot; leaves errors of 1e-8 of a spacing
constexpr double SpeckInWidths = 3.0;
constexpr double FacesAway = 0.1; ///< cosine between a triangle and the surface
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double MostCells = 1 << 28; ///< across the cloud

/** Nodes and cells of one block, and what is known of them. */
struct Block
{
  BlockBits Asked = 0; ///< cells that were looked at, or are in this wave
  BlockBits Next = 0; ///< cells to look at in the next wave
  BlockBits Wave = 0;
  BlockBits Wanted = 0; ///< nodes to evaluate
  BlockBits Evaluated = 0;
  BlockBits Known = 0; ///< nodes with a value
  BlockBits Inside = 0;
  BlockBits Crossed = 0; ///< cells
  std::array<BlockBits, 3> Edges{}; ///< crossed, for each axis
  std::array<std::int32_t, 3> FirstVertex{}; ///< on those edges
  std::array<std::int32_t, 8> Above{ -1, -1, -1, -1, -1, -1, -1, -1 }; ///< -1 if not looked up
  std::array<double, 64> Values{};
};

/** The box around a piece of the mesh, and the largest width in it. */
struct PieceBox
{
  Real3 Lower{ Infinity, Infinity, Infinity };
  Real3 Upper{ -Infinity, -Infinity, -Infinity };
  double Width = 0.0;

  void Add(const double* point, double width)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Lower[axis] = std::min(this->Lower[axis], point[axis]);
      this->Upper[axis] = std::max(this->Upper[axis], point[axis]);
    }
    this->Width = std::max(this->Width, width);
  }
  double Diagonal() const { return Length(Difference(this->Upper, this->Lower)); }
};

/** All steps and what they share. */
class Meshing
{
public:
  Meshing(const MovingLeastSquares& surface, double cell, Executor& executor, Monitor& monitor)
    : Surface(surface)
    , Edge(cell)
    , Threads(executor)
    , Watch(monitor)
  {
    // Nodes at odd places: a cloud aligned with the axes would else have whole sheets of zeros.
    const Real3 lower = surface.Samples().Lower();
    this->Origin = { lower[0] - 0.371 * cell, lower[1] - 0.433 * cell, lower[2] - 0.519 * cell };
  }

  PointSurfaceMesh Run()
  {
    const Real3 extent =
      Difference(this->Surface.Samples().Upper(), this->Surface.Samples().Lower());
    if (!(*std::max_element(extent.begin(), extent.end()) / this->Edge < MostCells))
    {
      this->Mesh.End = PointSurfaceMesh::Ending::TooFine;
    }
    if (this->Goes())
    {
      this->FollowSurface();
    }
    if (this->Goes())
    {
      this->NumberVertices();
    }
    if (this->Goes())
    {
      this->FindRoots();
    }
    if (this->Goes())
    {
      this->MakeTriangles();
    }
    if (this->Goes())
    {
      this->Mesh.NumberOfBorderEdges =
        CountBorderEdges(this->Mesh.Triangles, this->Mesh.Points.size() / 3);
      return std::move(this->Mesh);
    }
    PointSurfaceMesh none;
    none.End = this->Mesh.End;
    return none;
  }

private:
  bool Goes()
  {
    if (this->Watch.Aborted())
    {
      this->Mesh.End = PointSurfaceMesh::Ending::Aborted;
    }
    return this->Mesh.End == PointSurfaceMesh::Ending::Done;
  }

  Real3 Place(std::size_t block, int node) const
  {
    const GridPlace& place = this->Numbers.Place(static_cast<std::int32_t>(block));
    return { this->Origin[0] + this->Edge * (BlockSide * place.X + (node & 3)),
      this->Origin[1] + this->Edge * (BlockSide * place.Y + (node >> 2 & 3)),
      this->Origin[2] + this->Edge * (BlockSide * place.Z + (node >> 4)) };
  }

  /** Look up what reaches the nodes of a block, and the edges above them. */
  void Surround(std::size_t block, MovingLeastSquares::Neighbourhood& near) const
  {
    const double half = 0.5 * (BlockSide - 1) * this->Edge;
    const Real3 lowest = this->Place(block, 0);
    this->Surface.Surround(
      { lowest[0] + half, lowest[1] + half, lowest[2] + half }, 3.3 * this->Edge, near);
  }

  std::int32_t NumberOfBlock(const GridPlace& place)
  {
    const std::int32_t number = this->Numbers.Of(place);
    if (static_cast<std::size_t>(number) == this->Blocks.size())
    {
      this->Blocks.emplace_back();
    }
    return number;
  }

  /** The block above one on the axes whose bits are set. */
  std::size_t BlockAbove(std::size_t block, std::size_t axes)
  {
    if (axes == 0)
    {
      return block;
    }
    std::int32_t above = this->Blocks[block].Above[axes];
    if (above < 0)
    {
      const GridPlace& place = this->Numbers.Place(static_cast<std::int32_t>(block));
      above = this->NumberOfBlock({ place.X + static_cast<std::int32_t>(axes & 1),
        place.Y + static_cast<std::int32_t>(axes >> 1 & 1),
        place.Z + static_cast<std::int32_t>(axes >> 2) });
      this->Blocks[block].Above[axes] = above;
    }
    return static_cast<std::size_t>(above);
  }

  void AskNext(std::size_t block, BlockBits cells)
  {
    Block& asked = this->Blocks[block];
    cells &= ~asked.Asked & ~asked.Next;
    if (cells != 0 && asked.Next == 0)
    {
      this->NextWave.push_back(block);
    }
    asked.Next |= cells;
  }

  void AskForCellsOfSamples()
  {
    const PointTree& samples = this->Surface.Samples();
    std::vector<GridPlace> cells(static_cast<std::size_t>(samples.Size()));
    this->Threads.For(samples.Size(), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const Real3 from = Difference(samples.Point(static_cast<std::int32_t>(i)), this->Origin);
        cells[static_cast<std::size_t>(i)] = { static_cast<std::int32_t>(from[0] / this->Edge),
          static_cast<std::int32_t>(from[1] / this->Edge),
          static_cast<std::int32_t>(from[2] / this->Edge) };
      }
    });
    // In the order of the tree many that follow each other are in the same block.
    GridPlace last{ -1, -1, -1 };
    std::size_t block = 0;
    for (const GridPlace& cell : cells)
    {
      const GridPlace place{ cell.X / BlockSide, cell.Y / BlockSide, cell.Z / BlockSide };
      if (!(place == last))
      {
        block = static_cast<std::size_t>(this->NumberOfBlock(place));
        last = place;
      }
      this->AskNext(block,
        BlockBits(1) << (cell.X % BlockSide + BlockSide * (cell.Y % BlockSide) +
          BlockSide * BlockSide * (cell.Z % BlockSide)));
    }
  }

  /** Cells that the surface crosses, wave by wave. */
  void FollowSurface()
  {
    this->AskForCellsOfSamples();
    for (int round = 0; !this->NextWave.empty() && this->Goes(); ++round)
    {
      this->Watch.Progress(0.5 * round / (round + 2.0), "Follow the surface");
      const std::vector<std::size_t> wave = std::move(this->NextWave);
      this->NextWave.clear();
      for (const std::size_t block : wave)
      {
        Block& own = this->Blocks[block];
        own.Wave = std::exchange(own.Next, 0);
        own.Asked |= own.Wave;
      }
      this->EvaluateNodes(wave);
      for (const std::size_t block : wave)
      {
        this->FindCrossed(block);
      }
    }
  }

  /** Of a set in each block, the cells of one by which of their corners are in it. */
  BitsAbove CellsOf(std::size_t block, BlockBits Block::*set) const
  {
    BitsAbove nodes{};
    for (std::size_t above = 0; above < 8; ++above)
    {
      const std::int32_t number =
        above == 0 ? static_cast<std::int32_t>(block) : this->Blocks[block].Above[above];
      nodes[above] = number < 0 ? 0 : this->Blocks[static_cast<std::size_t>(number)].*set;
    }
    return CellsByCorner(nodes);
  }

  /** Of the cells in this wave, those that the surface crosses; their neighbours beyond faces that
   * it crosses are next. */
  void FindCrossed(std::size_t block)
  {
    const BitsAbove known = this->CellsOf(block, &Block::Known);
    const BitsAbove inside = this->CellsOf(block, &Block::Inside);
    BlockBits crossed = this->Blocks[block].Wave;
    for (const BlockBits corner : known)
    {
      crossed &= corner;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const BlockBits below = crossed & MixedFace(inside, axis, 0);
      const BlockBits above = crossed & MixedFace(inside, axis, 1);
      this->AskNext(block, StepDown(below, axis) | StepUp(above, axis));
      this->AskBeside(block, axis, -1, StepOutDown(below, axis));
      this->AskBeside(block, axis, 1, StepOutUp(above, axis));
    }
    BlockBits all = ~BlockBits(0);
    BlockBits any = 0;
    for (const BlockBits corner : inside)
    {
      all &= corner;
      any |= corner;
    }
    this->Blocks[block].Crossed |= crossed & any & ~all;
  }

  /** Cells with corners inside as well as outside on one of their faces. */
  static BlockBits MixedFace(const BitsAbove& inside, std::size_t axis, std::size_t side)
  {
    BlockBits all = ~BlockBits(0);
    BlockBits any = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      if ((corner >> axis & 1) == side)
      {
        all &= inside[corner];
        any |= inside[corner];
      }
    }
    return any & ~all;
  }

  void AskBeside(std::size_t block, std::size_t axis, std::int32_t step, BlockBits cells)
  {
    if (cells != 0)
    {
      const GridPlace place =
        this->Numbers.Place(static_cast<std::int32_t>(block)).Moved(axis, step);
      this->AskNext(static_cast<std::size_t>(this->NumberOfBlock(place)), cells);
    }
  }

  void EvaluateNodes(const std::vector<std::size_t>& wave)
  {
    std::vector<std::size_t> wanting;
    for (const std::size_t block : wave)
    {
      const BitsAbove nodes = CornersOfCells(this->Blocks[block].Wave);
      for (std::size_t axes = 0; axes < 8; ++axes)
      {
        if (nodes[axes] != 0)
        {
          const std::size_t above = this->BlockAbove(block, axes);
          Block& owner = this->Blocks[above];
          const BlockBits wanted = nodes[axes] & ~owner.Evaluated;
          if (wanted != 0 && owner.Wanted == 0)
          {
            wanting.push_back(above);
          }
          owner.Wanted |= wanted;
        }
      }
    }
    if (this->Blocks.size() > MostBlocks)
    {
      this->Mesh.End = PointSurfaceMesh::Ending::TooFine;
    }
    this->ForBlocks(wanting, [this](std::size_t block, auto& near) {
      Block& own = this->Blocks[block];
      this->Surround(block, near);
      ForBits(own.Wanted, [&](int node) {
        const SurfaceValue f = this->Surface.EvaluateAt(this->Place(block, node), 0, near);
        own.Values[static_cast<std::size_t>(node)] = f.Value;
        own.Known |= BlockBits(f.IsNear ? 1 : 0) << node;
        own.Inside |= BlockBits(f.Value < 0.0 ? 1 : 0) << node;
      });
      own.Evaluated |= std::exchange(own.Wanted, 0);
    });
  }

  template <class Body>
  void ForBlocks(const std::vector<std::size_t>& blocks, const Body& body)
  {
    this->Threads.For(
      static_cast<std::int64_t>(blocks.size()), Grain, [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::int64_t i = begin; i < end && !this->Watch.Aborted(); ++i)
        {
          body(blocks[static_cast<std::size_t>(i)], near);
        }
      });
  }

  /** A vertex for each edge of a crossed cell that the surface crosses. */
  void NumberVertices()
  {
    for (std::size_t block = 0; block < this->Blocks.size(); ++block)
    {
      for (std::size_t axis = 0; axis < 3 && this->Blocks[block].Crossed != 0; ++axis)
      {
        const BitsAbove edges = EdgesOfCells(this->Blocks[block].Crossed, axis);
        for (std::size_t axes = 0; axes < 8; ++axes)
        {
          if (edges[axes] != 0)
          {
            this->Blocks[this->BlockAbove(block, axes)].Edges[axis] |= edges[axes];
          }
        }
      }
    }
    std::int64_t count = 0;
    for (std::size_t block = 0; block < this->Blocks.size(); ++block)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        // Not all owners of edges have asked for the block above them before.
        const BlockBits beyond = this->Blocks[block].Edges[axis] == 0
          ? 0
          : this->Blocks[this->BlockAbove(block, std::size_t(1) << axis)].Inside;
        Block& own = this->Blocks[block];
        own.Edges[axis] &= own.Inside ^ (StepDown(own.Inside, axis) | StepOutDown(beyond, axis));
        own.FirstVertex[axis] = static_cast<std::int32_t>(count);
        count += NumberOfBits(own.Edges[axis]);
      }
    }
    this->NumberOfVertices = static_cast<std::size_t>(count);
    if (count > std::numeric_limits<std::int32_t>::max())
    {
      this->Mesh.End = PointSurfaceMesh::Ending::TooFine;
    }
  }

  void FindRoots()
  {
    this->Watch.Progress(0.5, "Points of the surface");
    this->Mesh.Points.resize(3 * this->NumberOfVertices);
    this->Mesh.Normals.resize(3 * this->NumberOfVertices);
    this->Supported.resize(this->NumberOfVertices);
    this->WidthOfVertex.resize(this->NumberOfVertices);
    std::vector<std::size_t> crossed;
    for (std::size_t block = 0; block < this->Blocks.size(); ++block)
    {
      const std::array<BlockBits, 3>& edges = this->Blocks[block].Edges;
      if ((edges[0] | edges[1] | edges[2]) != 0)
      {
        crossed.push_back(block);
      }
    }
    this->ForBlocks(crossed, [this](std::size_t block, auto& near) {
      this->Surround(block, near);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        std::size_t vertex = static_cast<std::size_t>(this->Blocks[block].FirstVertex[axis]);
        ForBits(this->Blocks[block].Edges[axis],
          [&](int node) { this->FindRoot(block, node, axis, vertex++, near); });
      }
    });
  }

  void FindRoot(std::size_t block, int node, std::size_t axis, std::size_t vertex,
    MovingLeastSquares::Neighbourhood& near)
  {
    const Block& own = this->Blocks[block];
    const BlockBits bit = BlockBits(1) << node;
    const bool isLast = StepUp(bit, axis) == 0;
    const std::size_t beyond =
      isLast ? static_cast<std::size_t>(own.Above[std::size_t(1) << axis]) : block;
    const int other = node + (isLast ? -3 : 1) * BlockStride[axis];
    CrossedEdge edge;
    edge.Start = this->Place(block, node);
    edge.Along[axis] = this->Edge;
    edge.ValueAtStart = own.Values[static_cast<std::size_t>(node)];
    edge.ValueAtEnd = this->Blocks[beyond].Values[static_cast<std::size_t>(other)];
    edge.StartsInside = (own.Inside & bit) != 0;
    const EdgeRoot root = FindEdgeRoot(this->Surface, edge, CurvedStep, near);
    const double steepness = Length(root.Surface.Gradient);
    const Real3 normal = steepness > 0.0 ? Scaled(root.Surface.Gradient, 1.0 / steepness) : Real3{};
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(3 * vertex);
    std::copy_n(root.Point.begin(), 3, this->Mesh.Points.begin() + first);
    std::copy_n(normal.begin(), 3, this->Mesh.Normals.begin() + first);
    this->WidthOfVertex[vertex] = root.Surface.Width;
    this->Supported[vertex] = root.IsSupported() ? 1 : 0;
  }

  std::int32_t VertexOn(std::size_t block, int cell, int edge) const
  {
    const std::size_t axis = static_cast<std::size_t>(edge / 4);
    const int corner = LowerCornerOfCubeEdge(edge);
    BlockBits bit = BlockBits(1) << cell;
    std::size_t axes = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (corner >> a & 1)
      {
        const BlockBits up = StepUp(bit, a);
        axes |= up == 0 ? std::size_t(1) << a : 0;
        bit = up == 0 ? StepOutUp(bit, a) : up;
      }
    }
    const std::size_t owner =
      axes == 0 ? block : static_cast<std::size_t>(this->Blocks[block].Above[axes]);
    const Block& above = this->Blocks[owner];
    return above.FirstVertex[axis] + NumberOfBits(above.Edges[axis] & (bit - 1));
  }

  void MakeTriangles()
  {
    this->Watch.Progress(0.9, "Triangles");
    this->Mesh.Triangles.reserve(6 * this->NumberOfVertices + 3);
    for (std::size_t block = 0; block < this->Blocks.size(); ++block)
    {
      if (this->Blocks[block].Crossed == 0)
      {
        continue;
      }
      const BitsAbove corners = this->CellsOf(block, &Block::Inside);
      ForBits(this->Blocks[block].Crossed, [&](int cell) {
        int inside = 0;
        for (std::size_t corner = 0; corner < 8; ++corner)
        {
          inside |= static_cast<int>(corners[corner] >> cell & 1) << corner;
        }
        this->AddTriangles(block, cell, inside);
      });
    }
    this->DropSpecks();
    this->DropUnusedVertices();
  }

  void AddTriangles(std::size_t block, int cell, int inside)
  {
    for (const CubeLoop& loop : LoopsOfCube(inside))
    {
      for (const CubeTriangle& triangle : this->BestFill(block, cell, loop))
      {
        const std::array<std::int32_t, 3> corners = this->VerticesOf(block, cell, triangle);
        if (this->IsSupported(corners))
        {
          this->Mesh.Triangles.insert(this->Mesh.Triangles.end(), corners.begin(), corners.end());
        }
      }
    }
  }

  std::array<std::int32_t, 3> VerticesOf(
    std::size_t block, int cell, const CubeTriangle& triangle) const
  {
    return { this->VertexOn(block, cell, triangle[0]), this->VertexOn(block, cell, triangle[1]),
      this->VertexOn(block, cell, triangle[2]) };
  }

  bool IsSupported(const std::array<std::int32_t, 3>& corners) const
  {
    return std::all_of(corners.begin(), corners.end(),
      [this](std::int32_t vertex) { return this->Supported[static_cast<std::size_t>(vertex)]; });
  }

  /** The first way to fill a loop; but where that has a triangle which does not face as the surface
   * does, as at a crease within a cube, the one that faces best. */
  const CubeFill& BestFill(std::size_t block, int cell, const CubeLoop& loop) const
  {
    const CubeFill* best = &loop.front();
    double bestFacing = this->LeastFacing(block, cell, loop.front());
    if (bestFacing < FacesAway)
    {
      for (const CubeFill& fill : loop)
      {
        const double facing = this->LeastFacing(block, cell, fill);
        if (facing > bestFacing)
        {
          bestFacing = facing;
          best = &fill;
        }
      }
    }
    return *best;
  }

  /** The least cosine between a triangle and the mean of the normals in its corners. */
  double LeastFacing(std::size_t block, int cell, const CubeFill& fill) const
  {
    double least = 1.0;
    for (const CubeTriangle& triangle : fill)
    {
      const std::array<std::int32_t, 3> corners = this->VerticesOf(block, cell, triangle);
      const Real3 a = this->Vertex(this->Mesh.Points, corners[0]);
      const Real3 turn = Cross(Difference(this->Vertex(this->Mesh.Points, corners[1]), a),
        Difference(this->Vertex(this->Mesh.Points, corners[2]), a));
      Real3 normal{};
      for (const std::int32_t vertex : corners)
      {
        normal = PlusScaled(normal, 1.0, this->Vertex(this->Mesh.Normals, vertex));
      }
      const double lengths = Length(turn) * Length(normal);
      least = lengths > 0.0 ? std::min(least, Dot(turn, normal) / lengths) : least;
    }
    return least;
  }

  static Real3 Vertex(const std::vector<double>& triples, std::int32_t vertex)
  {
    const double* const x = triples.data() + 3 * static_cast<std::size_t>(vertex);
    return { x[0], x[1], x[2] };
  }

  void DropSpecks()
  {
    const std::size_t count = this->Supported.size();
    const std::vector<std::int32_t>& corners = this->Mesh.Triangles;
    DisjointSets pieces(static_cast<std::int32_t>(count));
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      pieces.Unite(corners[i], corners[i + 1]);
      pieces.Unite(corners[i], corners[i + 2]);
    }
    std::vector<std::size_t> pieceOf(corners.size() / 3);
    std::vector<std::size_t> numbers(count, 0); // of pieces, from 1 on
    std::vector<PieceBox> boxes;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (i % 3 == 0)
      {
        std::size_t& number = numbers[static_cast<std::size_t>(pieces.Find(corners[i]))];
        if (number == 0)
        {
          boxes.emplace_back();
          number = boxes.size();
        }
        pieceOf[i / 3] = number - 1;
      }
      const std::size_t vertex = static_cast<std::size_t>(corners[i]);
      boxes[pieceOf[i / 3]].Add(this->Mesh.Points.data() + 3 * vertex, this->WidthOfVertex[vertex]);
    }
    const auto longest = std::max_element(boxes.begin(), boxes.end(),
      [](const PieceBox& a, const PieceBox& b) { return a.Diagonal() < b.Diagonal(); });
    const auto isSpeck = [&](const PieceBox& box) {
      return &box != &*longest && box.Diagonal() < SpeckInWidths * box.Width;
    };
    this->Mesh.NumberOfSpecks = std::count_if(boxes.begin(), boxes.end(), isSpeck);
    if (this->Mesh.NumberOfSpecks == 0)
    {
      return;
    }
    std::vector<std::int32_t> kept;
    for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
    {
      if (!isSpeck(boxes[pieceOf[i / 3]]))
      {
        kept.push_back(this->Mesh.Triangles[i]);
      }
    }
    this->Mesh.Triangles.swap(kept);
  }

  void DropUnusedVertices()
  {
    std::vector<std::int32_t> number(this->Supported.size(), -1);
    for (const std::int32_t vertex : this->Mesh.Triangles)
    {
      number[static_cast<std::size_t>(vertex)] = 0;
    }
    std::int32_t count = 0;
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex)
    {
      if (number[vertex] < 0)
      {
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t place = 3 * static_cast<std::size_t>(count) + k;
        this->Mesh.Points[place] = this->Mesh.Points[3 * vertex + k];
        this->Mesh.Normals[place] = this->Mesh.Normals[3 * vertex + k];
      }
      number[vertex] = count++;
    }
    this->Mesh.Points.resize(3 * static_cast<std::size_t>(count));
    this->Mesh.Normals.resize(3 * static_cast<std::size_t>(count));
    for (std::int32_t& vertex : this->Mesh.Triangles)
    {
      vertex = number[static_cast<std::size_t>(vertex)];
    }
  }

  const MovingLeastSquares& Surface;
  const double Edge;
  Executor& Threads;
  Monitor& Watch;
  Real3 Origin{};
  BlockNumbers Numbers;
  std::vector<Block> Blocks;
  std::vector<std::size_t> NextWave; ///< blocks with cells to look at
  std::size_t NumberOfVertices = 0;
  std::vector<std::uint8_t> Supported;
  std::vector<double> WidthOfVertex;
  PointSurfaceMesh Mesh;
};

} // namespace

PointSurfaceMesh MeshPointSurface(
  const MovingLeastSquares& surface, double cell, Executor& executor, Monitor& monitor)
{
  return Meshing(surface, cell, executor, monitor).Run();
}

} // namespace sb
