// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointSurfaceMesh.h"

#include "CubeCases.h"
#include "DisjointSets.h"
#include "ParallelSort.h"

#include <algorithm>
#include <limits>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 256;
constexpr double SpeckInWidths = 3.0;
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double MostCells = 1 << 28; ///< across the cloud

/** A cell of the grid, or the node at its lower corner. */
struct Cell
{
  std::int32_t X, Y, Z;

  /** Morton's order: that of the axis whose numbers differ in the highest bit. Cells that follow
   * each other are near each other, and so are their samples. */
  bool operator<(const Cell& other) const
  {
    const std::uint32_t mine[3] = { Shifted(this->X), Shifted(this->Y), Shifted(this->Z) };
    const std::uint32_t theirs[3] = { Shifted(other.X), Shifted(other.Y), Shifted(other.Z) };
    std::size_t axis = 2;
    for (std::size_t k = 2; k-- > 0;)
    {
      const std::uint32_t highest = mine[axis] ^ theirs[axis];
      const std::uint32_t bits = mine[k] ^ theirs[k];
      axis = highest < bits && highest < (highest ^ bits) ? k : axis;
    }
    return mine[axis] < theirs[axis];
  }
  bool operator==(const Cell& other) const
  {
    return this->X == other.X && this->Y == other.Y && this->Z == other.Z;
  }
  /** As if the smallest number were 0. */
  static std::uint32_t Shifted(std::int32_t a)
  {
    return static_cast<std::uint32_t>(a) ^ 0x80000000u;
  }
  Cell Corner(int corner) const
  {
    return { this->X + (corner & 1), this->Y + (corner >> 1 & 1), this->Z + (corner >> 2 & 1) };
  }
};

/** From cells to numbers: open addressing, sized for what is to come. */
class CellNumbers
{
public:
  void Reserve(std::size_t count)
  {
    if (2 * count < this->Slots.size())
    {
      return;
    }
    std::size_t size = 1024;
    while (size < 4 * count)
    {
      size *= 2;
    }
    std::vector<Slot> old(size);
    old.swap(this->Slots);
    for (const Slot& slot : old)
    {
      if (slot.Number >= 0)
      {
        this->Insert(slot.Key, slot.Number);
      }
    }
  }

  /** Reserve must have made room. */
  void Insert(const Cell& cell, std::int32_t number)
  {
    this->Slots[this->Place(cell)] = { cell, number };
  }

  /** -1 if it has none. */
  std::int32_t Find(const Cell& cell) const
  {
    return this->Slots.empty() ? -1 : this->Slots[this->Place(cell)].Number;
  }

private:
  struct Slot
  {
    Cell Key{ 0, 0, 0 };
    std::int32_t Number = -1;
  };

  std::size_t Place(const Cell& cell) const
  {
    std::uint64_t hash = static_cast<std::uint32_t>(cell.X) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ static_cast<std::uint32_t>(cell.Y)) * 0xC2B2AE3D27D4EB4Fu;
    hash = (hash ^ static_cast<std::uint32_t>(cell.Z)) * 0x9E3779B97F4A7C15u;
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t place = static_cast<std::size_t>(hash >> 20) & mask;
    while (this->Slots[place].Number >= 0 && !(this->Slots[place].Key == cell))
    {
      place = (place + 1) & mask;
    }
    return place;
  }

  std::vector<Slot> Slots;
};

void SortUnique(std::vector<Cell>& cells, Executor& executor)
{
  ParallelSort(
    cells, [](const Cell& a, const Cell& b) { return a < b; }, executor);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

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
      this->CountBorder();
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

  Real3 Place(const Cell& node) const
  {
    return { this->Origin[0] + this->Edge * node.X, this->Origin[1] + this->Edge * node.Y,
      this->Origin[2] + this->Edge * node.Z };
  }

  std::vector<Cell> CellsOfSamples() const
  {
    const PointTree& samples = this->Surface.Samples();
    std::vector<Cell> cells(static_cast<std::size_t>(samples.Size()));
    this->Threads.For(samples.Size(), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const Real3 from = Difference(samples.Point(static_cast<std::int32_t>(i)), this->Origin);
        cells[static_cast<std::size_t>(i)] = { static_cast<std::int32_t>(from[0] / this->Edge),
          static_cast<std::int32_t>(from[1] / this->Edge),
          static_cast<std::int32_t>(from[2] / this->Edge) };
      }
    });
    // In the order of the tree many that follow each other are in the same one.
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    SortUnique(cells, this->Threads);
    return cells;
  }

  /** Cells that the surface crosses, wave by wave. */
  void FollowSurface()
  {
    std::vector<Cell> wave = this->CellsOfSamples();
    CellNumbers visited;
    std::int32_t numberOfVisited = 0;
    for (int round = 0; !wave.empty() && this->Goes(); ++round)
    {
      this->Watch.Progress(0.5 * round / (round + 2.0), "Follow the surface");
      visited.Reserve(static_cast<std::size_t>(numberOfVisited) + wave.size());
      for (const Cell& cell : wave)
      {
        visited.Insert(cell, numberOfVisited++);
      }
      this->EvaluateNodes(wave);
      std::vector<Cell> next;
      for (const Cell& cell : wave)
      {
        const int inside = this->Inside(cell);
        if (inside > 0 && inside < 255)
        {
          this->Crossed.push_back(cell);
          this->AddNeighbours(cell, inside, visited, next);
        }
      }
      SortUnique(next, this->Threads);
      wave.swap(next);
    }
    SortUnique(this->Crossed, this->Threads);
  }

  /** Bit c is set if corner c is inside; -1 if the function is not known at all corners. */
  int Inside(const Cell& cell) const
  {
    int inside = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::size_t node = static_cast<std::size_t>(this->Numbers.Find(cell.Corner(corner)));
      if (!this->Known[node])
      {
        return -1;
      }
      inside |= this->Values[node] < 0.0 ? 1 << corner : 0;
    }
    return inside;
  }

  static void AddNeighbours(
    const Cell& cell, int inside, const CellNumbers& visited, std::vector<Cell>& next)
  {
    for (int face = 0; face < 6; ++face)
    {
      int count = 0;
      for (const int corner : CornersOfCubeFace(face))
      {
        count += inside >> corner & 1;
      }
      const int step = (face & 1) ? 1 : -1;
      const int axis = face / 2;
      const Cell neighbour{ cell.X + (axis == 0 ? step : 0), cell.Y + (axis == 1 ? step : 0),
        cell.Z + (axis == 2 ? step : 0) };
      if (count > 0 && count < 4 && visited.Find(neighbour) < 0)
      {
        next.push_back(neighbour);
      }
    }
  }

  void EvaluateNodes(const std::vector<Cell>& wave)
  {
    const std::size_t first = this->Nodes.size();
    for (const Cell& cell : wave)
    {
      this->Numbers.Reserve(this->Nodes.size() + 8);
      for (int corner = 0; corner < 8; ++corner)
      {
        const Cell node = cell.Corner(corner);
        if (this->Numbers.Find(node) < 0)
        {
          this->Numbers.Insert(node, static_cast<std::int32_t>(this->Nodes.size()));
          this->Nodes.push_back(node);
        }
      }
    }
    if (this->Nodes.size() > std::size_t(1) << 30)
    {
      this->Mesh.End = PointSurfaceMesh::Ending::TooFine;
    }
    this->Values.resize(this->Nodes.size(), 0.0);
    this->Known.resize(this->Nodes.size(), 0);
    this->Threads.For(static_cast<std::int64_t>(this->Nodes.size() - first), Grain,
      [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = first + static_cast<std::size_t>(begin);
             i < first + static_cast<std::size_t>(end) && !this->Watch.Aborted(); ++i)
        {
          const SurfaceValue f = this->Surface.EvaluateAt(this->Place(this->Nodes[i]), 0, near);
          this->Values[i] = f.Value;
          this->Known[i] = f.IsNear ? 1 : 0;
        }
      });
  }

  /** A vertex for each edge of the grid that the surface crosses: three places for each node. */
  void NumberVertices()
  {
    this->Vertices.assign(3 * this->Nodes.size(), -1);
    std::int32_t count = 0;
    for (const Cell& cell : this->Crossed)
    {
      std::int32_t nodes[8];
      for (int corner = 0; corner < 8; ++corner)
      {
        nodes[corner] = this->Numbers.Find(cell.Corner(corner));
      }
      for (int edge = 0; edge < 12; ++edge)
      {
        const int lower = LowerCornerOfCubeEdge(edge);
        const std::int32_t from = nodes[lower];
        const std::int32_t to = nodes[lower | 1 << edge / 4];
        const std::size_t place =
          3 * static_cast<std::size_t>(from) + static_cast<std::size_t>(edge / 4);
        if (this->Vertices[place] < 0 &&
          (this->Values[static_cast<std::size_t>(from)] < 0.0) !=
            (this->Values[static_cast<std::size_t>(to)] < 0.0))
        {
          this->Vertices[place] = count++;
          this->Ends.push_back(from);
          this->Ends.push_back(to);
        }
      }
    }
  }

  void FindRoots()
  {
    this->Watch.Progress(0.5, "Points of the surface");
    const std::int64_t count = static_cast<std::int64_t>(this->Ends.size() / 2);
    this->Mesh.Points.resize(3 * static_cast<std::size_t>(count));
    this->Mesh.Normals.resize(3 * static_cast<std::size_t>(count));
    this->Supported.resize(static_cast<std::size_t>(count));
    this->WidthOfVertex.resize(static_cast<std::size_t>(count));
    this->Threads.For(count, Grain, [this](std::int64_t begin, std::int64_t end) {
      MovingLeastSquares::Neighbourhood near;
      for (std::int64_t i = begin; i < end && !this->Watch.Aborted(); ++i)
      {
        this->FindRoot(static_cast<std::size_t>(i), near);
      }
    });
  }

  /** Newton's method on an edge, with the bracket halved where it would leave that. */
  void FindRoot(std::size_t vertex, MovingLeastSquares::Neighbourhood& near)
  {
    const std::size_t from = static_cast<std::size_t>(this->Ends[2 * vertex]);
    const std::size_t to = static_cast<std::size_t>(this->Ends[2 * vertex + 1]);
    const Real3 start = this->Place(this->Nodes[from]);
    const Real3 along = Difference(this->Place(this->Nodes[to]), start);
    const bool startsInside = this->Values[from] < 0.0;
    double lower = 0.0;
    double upper = 1.0;
    double t = this->Values[from] / (this->Values[from] - this->Values[to]);
    this->Surface.Gather(PlusScaled(start, 0.5, along), 0.5 * this->Edge, near);
    SurfaceValue f;
    Real3 x = start;
    for (int iteration = 0; iteration < 60; ++iteration)
    {
      x = PlusScaled(start, t, along);
      f = this->Surface.Evaluate(x, 1, near);
      if (!f.IsNear)
      {
        break;
      }
      ((f.Value < 0.0) == startsInside ? lower : upper) = t;
      const double slope = Dot(f.Gradient, along);
      const double newton = t - f.Value / slope;
      const double next = newton >= lower && newton <= upper ? newton : 0.5 * (lower + upper);
      const double step = std::abs(next - t);
      t = next;
      // Once steps are short the next one would be their square, unless the surface grazes the
      // edge.
      const bool grazes = std::abs(slope) < 0.2 * this->Edge;
      if (step < (grazes ? 1e-13 : 1e-7) || f.Value == 0.0)
      {
        x = PlusScaled(start, t, along);
        break;
      }
    }
    const double steepness = Length(f.Gradient);
    const Real3 normal = steepness > 0.0 ? Scaled(f.Gradient, 1.0 / steepness) : Real3{};
    std::copy_n(x.begin(), 3, this->Mesh.Points.begin() + static_cast<std::ptrdiff_t>(3 * vertex));
    std::copy_n(
      normal.begin(), 3, this->Mesh.Normals.begin() + static_cast<std::ptrdiff_t>(3 * vertex));
    this->WidthOfVertex[vertex] = f.Width;
    this->Supported[vertex] =
      f.Where == Support::Defined || f.Where == Support::Contradicting ? 1 : 0;
  }

  void MakeTriangles()
  {
    this->Watch.Progress(0.9, "Triangles");
    for (const Cell& cell : this->Crossed)
    {
      for (const CubeTriangle& triangle : TrianglesOfCube(this->Inside(cell)))
      {
        std::int32_t corners[3];
        bool supported = true;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::size_t node = static_cast<std::size_t>(
            this->Numbers.Find(cell.Corner(LowerCornerOfCubeEdge(triangle[k]))));
          corners[k] = this->Vertices[3 * node + triangle[k] / 4];
          supported = supported && this->Supported[static_cast<std::size_t>(corners[k])];
        }
        if (supported)
        {
          this->Mesh.Triangles.insert(this->Mesh.Triangles.end(), corners, corners + 3);
        }
      }
    }
    this->DropSpecks();
    this->DropUnusedVertices();
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

  /** Edges of one triangle: each edge is named from its lower to its higher end, and found twice if
   * it has two. */
  void CountBorder()
  {
    std::vector<std::uint64_t> edges;
    edges.reserve(this->Mesh.Triangles.size());
    for (std::size_t corner = 0; corner < this->Mesh.Triangles.size(); ++corner)
    {
      const std::size_t following = corner % 3 == 2 ? corner - 2 : corner + 1;
      const auto ends = std::minmax(this->Mesh.Triangles[corner], this->Mesh.Triangles[following]);
      edges.push_back(
        static_cast<std::uint64_t>(ends.first) << 32 | static_cast<std::uint64_t>(ends.second));
    }
    RadixSort(
      edges, [](std::uint64_t edge) { return edge; }, 64, this->Threads);
    for (std::size_t i = 0; i < edges.size();)
    {
      const bool paired = i + 1 < edges.size() && edges[i] == edges[i + 1];
      this->Mesh.NumberOfBorderEdges += paired ? 0 : 1;
      i += paired ? 2 : 1;
    }
  }

  const MovingLeastSquares& Surface;
  const double Edge;
  Executor& Threads;
  Monitor& Watch;
  Real3 Origin{};
  CellNumbers Numbers; ///< of nodes
  std::vector<Cell> Nodes;
  std::vector<double> Values;
  std::vector<std::uint8_t> Known;
  std::vector<Cell> Crossed;
  std::vector<std::int32_t> Vertices;
  std::vector<std::int32_t> Ends; ///< nodes of the edge of each vertex
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
