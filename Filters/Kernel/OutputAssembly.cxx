// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputAssembly.h"

#include "ParallelSort.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sb
{

namespace
{

/** Marks of input points, in place of output ids that are not known yet. */
constexpr std::int32_t Unused = -1;
constexpr std::int32_t Used = 0;

Fate Opposite(Fate fate)
{
  return fate == Fate::Kept ? Fate::KeptReversed : fate == Fate::KeptReversed ? Fate::Kept : fate;
}

/** A corner of a piece that is not a corner of its face, and what makes it the same output point as
 * another. */
struct Instance
{
  NodeId Node;
  std::int32_t Operand;
  std::int32_t CarrierLow; ///< the two input points of the edge it is on, or -1 and the face
  std::int32_t CarrierHigh;
  std::int32_t Corner; ///< 3 * output piece + corner

  friend bool operator<(const Instance& l, const Instance& r)
  {
    return std::tie(l.Node, l.Operand, l.CarrierLow, l.CarrierHigh, l.Corner) <
      std::tie(r.Node, r.Operand, r.CarrierLow, r.CarrierHigh, r.Corner);
  }
  bool IsSamePoint(const Instance& other) const
  {
    return this->Node == other.Node && this->Operand == other.Operand &&
      this->CarrierLow == other.CarrierLow && this->CarrierHigh == other.CarrierHigh;
  }
};

class Assembler
{
public:
  Assembler(const Scene& scene, const Arrangement& cuts, SeamPoints seams, CutSurfaces& result,
    Executor& executor)
    : World(scene)
    , Cuts(cuts)
    , Seams(seams)
    , Out(result)
    , Threads(executor)
  {
  }

  void Run(Classification&& classes)
  {
    this->Out.Fates = std::move(classes.Fates);
    this->SettleWholeFaces(classes.RegionFates);
    this->SelectPieces(classes.RegionFates);
    this->PlaceCorners();
    this->UndoSwaps();
  }

private:
  /** A face that is one piece without new points stays a whole triangle. */
  void SettleWholeFaces(const std::vector<Fate>& regionFates)
  {
    for (std::size_t i = 0; i < this->Cuts.Faces.size(); ++i)
    {
      const CutFace& cut = this->Cuts.Faces[i];
      const std::int32_t operand = this->World.OperandOfFace(cut.Face);
      std::vector<Fate>& fates = this->Out.Fates[std::size_t(operand)];
      if (!fates.empty() && !IsGivenAsPieces(this->Cuts, i))
      {
        const Piece& piece = this->Cuts.Pieces[std::size_t(cut.FirstPiece)];
        fates[std::size_t(cut.Face - this->World.FirstFace(operand))] =
          regionFates[std::size_t(piece.Region)];
      }
    }
  }

  void SelectPieces(const std::vector<Fate>& regionFates)
  {
    for (std::size_t i = 0; i < this->Cuts.Faces.size(); ++i)
    {
      const CutFace& cut = this->Cuts.Faces[i];
      const std::int32_t end = this->Cuts.EndOfPieces(i);
      if (!IsGivenAsPieces(this->Cuts, i))
      {
        continue;
      }
      const std::int32_t operand = this->World.OperandOfFace(cut.Face);
      for (std::int32_t p = cut.FirstPiece; p < end; ++p)
      {
        const Fate fate = regionFates[std::size_t(this->Cuts.Pieces[std::size_t(p)].Region)];
        if (fate != Fate::Dropped)
        {
          this->Out.Split.Operand.push_back(operand);
          this->Out.Split.Parent.push_back(cut.Face - this->World.FirstFace(operand));
          this->Out.Split.Reversed.push_back(fate == Fate::KeptReversed);
          this->Selected.push_back(p);
        }
      }
    }
    this->Out.Split.Corners.resize(this->Selected.size());
  }

  void PlaceCorners()
  {
    const std::int32_t operands = this->World.NumberOfOperands();
    this->Out.PointMap.resize(std::size_t(operands));
    this->Out.KeptPoints.resize(std::size_t(operands));
    this->Threads.For(operands, 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        this->MarkKept(static_cast<std::int32_t>(i));
      }
    });
    std::vector<Instance> instances = this->CollectInstances();
    if (this->Seams == SeamPoints::Shared)
    {
      this->ShareVertices(instances);
    }
    else
    {
      this->ListMoved();
    }
    this->NumberKept();
    this->NumberInstances(std::move(instances));
    this->NumberMoved();
    this->NumberOwnCorners();
  }

  void MarkKept(std::int32_t operand)
  {
    const Surface& mesh = this->World.Mesh(operand);
    std::vector<std::int32_t>& map = this->Out.PointMap[std::size_t(operand)];
    map.assign(std::size_t(mesh.NumberOfPoints), Unused);
    const std::vector<Fate>& fates = this->Out.Fates[std::size_t(operand)];
    for (std::size_t i = 0; i < fates.size(); ++i)
    {
      if (fates[i] == Fate::Kept || fates[i] == Fate::KeptReversed)
      {
        const std::int32_t* ids = mesh.Triangles + 3 * i;
        map[std::size_t(ids[0])] = Used;
        map[std::size_t(ids[1])] = Used;
        map[std::size_t(ids[2])] = Used;
      }
    }
  }

  /** The id, in its operand's mesh, of the corner of a face. */
  std::int32_t PointOfCorner(std::int32_t operand, std::int32_t face, Location corner) const
  {
    return this->World.Corners(operand, face)[std::size_t(corner)] -
      this->World.FirstVertex(operand);
  }

  std::vector<Instance> CollectInstances()
  {
    std::vector<Instance> instances;
    for (std::size_t i = 0; i < this->Selected.size(); ++i)
    {
      const Piece& piece = this->Cuts.Pieces[std::size_t(this->Selected[i])];
      const std::int32_t operand = this->Out.Split.Operand[i];
      const std::int32_t face = this->World.FirstFace(operand) + this->Out.Split.Parent[i];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Location where = piece.Where[k];
        if (IsCorner(where))
        {
          this->Out.PointMap[std::size_t(operand)]
                            [std::size_t(this->PointOfCorner(operand, face, where))] = Used;
          continue;
        }
        Instance instance{ piece.Corners[k], operand, -1, face,
          static_cast<std::int32_t>(3 * i + k) };
        if (this->Seams == SeamPoints::Shared)
        {
          instance.Operand = 0;
          instance.CarrierHigh = -1;
        }
        else if (IsEdge(where))
        {
          const std::int32_t a =
            this->PointOfCorner(operand, face, static_cast<Location>(where - 3));
          const std::int32_t b =
            this->PointOfCorner(operand, face, static_cast<Location>((where - 2) % 3));
          instance.CarrierLow = std::min(a, b);
          instance.CarrierHigh = std::max(a, b);
        }
        instances.push_back(instance);
      }
    }
    ParallelSort(
      instances, [](const Instance& l, const Instance& r) { return l < r; }, this->Threads);
    return instances;
  }

  /** A corner of a cut face, and the input vertex that stands for its node. */
  struct Alias
  {
    NodeId Node;
    std::int32_t Vertex;

    friend bool operator<(const Alias& l, const Alias& r)
    {
      return l.Node != r.Node ? l.Node < r.Node : l.Vertex < r.Vertex;
    }
  };

  /** Input points that are the same node become one output point, and so do the instances there. */
  void ShareVertices(const std::vector<Instance>& instances)
  {
    std::vector<Alias> aliases;
    for (const Piece& piece : this->Cuts.Pieces)
    {
      const std::int32_t face = this->Cuts.Regions[std::size_t(piece.Region)].Face;
      const std::array<std::int32_t, 3> corners = this->World.Corners(face);
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (IsCorner(piece.Where[k]) && IsNode(piece.Corners[k]))
        {
          const std::int32_t vertex = corners[std::size_t(piece.Where[k])];
          if (this->MarkOf(vertex) == Used)
          {
            aliases.push_back({ piece.Corners[k], vertex });
          }
        }
      }
    }
    // A vertex may stand for instances although no face of its own that uses it is left.
    for (const Instance& instance : instances)
    {
      const std::int32_t vertex = this->Cuts.Nodes.Vertex(instance.Node);
      if (vertex >= 0)
      {
        this->MarkOf(vertex) = Used;
        aliases.push_back({ instance.Node, vertex });
      }
    }
    std::sort(aliases.begin(), aliases.end());
    for (std::size_t i = 0; i < aliases.size();)
    {
      const Alias first = aliases[i];
      for (; i < aliases.size() && aliases[i].Node == first.Node; ++i)
      {
        if (aliases[i].Vertex != first.Vertex)
        {
          this->MarkOf(aliases[i].Vertex) = Unused;
          this->Shared.push_back({ aliases[i].Vertex, first.Vertex });
        }
      }
      this->VertexOfNode.push_back(first);
    }
  }

  /**
   * Input points that are one node, but differ in what rounding to the lattice takes away, would
   * leave a gap of that size: they all get the place of the lowest of them.
   */
  void ListMoved()
  {
    for (const Piece& piece : this->Cuts.Pieces)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (!IsCorner(piece.Where[k]) || !IsNode(piece.Corners[k]))
        {
          continue;
        }
        const std::int32_t face = this->Cuts.Regions[std::size_t(piece.Region)].Face;
        const std::int32_t vertex = this->World.Corners(face)[std::size_t(piece.Where[k])];
        const std::int32_t standard = this->Cuts.Nodes.Vertex(piece.Corners[k]);
        if (standard >= 0 && standard != vertex && this->MarkOf(vertex) == Used &&
          this->World.OriginalPosition(vertex) != this->World.OriginalPosition(standard))
        {
          this->MarkOf(vertex) = Unused;
          this->Moved.push_back({ piece.Corners[k], vertex });
        }
      }
    }
  }

  void NumberMoved()
  {
    for (const Alias& moved : this->Moved)
    {
      const std::int32_t operand = this->World.OperandOfVertex(moved.Vertex);
      const std::int32_t id = moved.Vertex - this->World.FirstVertex(operand);
      this->MarkOf(moved.Vertex) = this->NumberOfPoints++;
      this->Out.Interpolated.push_back({ PlaceOfNode(this->World, this->Cuts.Nodes, moved.Node),
        operand, { id, id, id }, { 1.0, 0.0, 0.0 } });
    }
  }

  std::int32_t& MarkOf(std::int32_t vertex)
  {
    const std::int32_t operand = this->World.OperandOfVertex(vertex);
    return this->Out
      .PointMap[std::size_t(operand)][std::size_t(vertex - this->World.FirstVertex(operand))];
  }

  void NumberKept()
  {
    for (std::size_t operand = 0; operand < this->Out.PointMap.size(); ++operand)
    {
      std::vector<std::int32_t>& map = this->Out.PointMap[operand];
      std::vector<std::int32_t>& kept = this->Out.KeptPoints[operand];
      kept.reserve(map.size());
      for (std::size_t i = 0; i < map.size(); ++i)
      {
        if (map[i] == Used)
        {
          map[i] = this->NumberOfPoints++;
          kept.push_back(static_cast<std::int32_t>(i));
        }
      }
    }
    for (const std::pair<std::int32_t, std::int32_t>& share : this->Shared)
    {
      this->MarkOf(share.first) = this->MarkOf(share.second);
    }
  }

  void NumberInstances(std::vector<Instance> instances)
  {
    std::vector<std::pair<std::int32_t, NodeId>> created; // a corner, and its node
    for (std::size_t i = 0; i < instances.size();)
    {
      const Instance first = instances[i];
      std::int32_t point = -1;
      const auto standsFor = std::lower_bound(
        this->VertexOfNode.begin(), this->VertexOfNode.end(), Alias{ first.Node, -1 });
      if (standsFor != this->VertexOfNode.end() && standsFor->Node == first.Node)
      {
        point = this->MarkOf(standsFor->Vertex);
      }
      else
      {
        point = this->NumberOfPoints++;
        created.emplace_back(first.Corner, first.Node);
      }
      for (; i < instances.size() && instances[i].IsSamePoint(first); ++i)
      {
        const auto corner = std::size_t(instances[i].Corner);
        this->Out.Split.Corners[corner / 3][corner % 3] = point;
      }
    }
    this->Out.Interpolated.resize(created.size());
    this->Threads.For(
      static_cast<std::int64_t>(created.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          this->Out.Interpolated[std::size_t(i)] =
            this->Interpolate(created[std::size_t(i)].first, created[std::size_t(i)].second);
        }
      });
  }

  InterpolatedPoint Interpolate(std::int32_t corner, NodeId node) const
  {
    const auto piece = std::size_t(corner / 3);
    InterpolatedPoint point;
    point.Operand = this->Out.Split.Operand[piece];
    const std::int32_t face = this->World.FirstFace(point.Operand) + this->Out.Split.Parent[piece];
    const std::array<std::int32_t, 3> vertices = this->World.Corners(point.Operand, face);
    std::array<const double*, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
    {
      point.PointIds[i] = vertices[i] - this->World.FirstVertex(point.Operand);
      p[i] = this->World.Position(vertices[i]);
    }
    point.Position = PlaceOfNode(this->World, this->Cuts.Nodes, node);
    point.Weights = Barycentric(this->Cuts.Nodes.Point(node).Approximation(), p,
      this->Cuts.Pieces[std::size_t(this->Selected[piece])].Where[std::size_t(corner % 3)]);
    return point;
  }

  static std::array<double, 3> Barycentric(
    const double* x, const std::array<const double*, 3>& p, Location where)
  {
    std::array<double, 3> weights{};
    if (IsEdge(where))
    {
      const auto from = std::size_t(where - 3);
      const std::size_t to = (from + 1) % 3;
      std::size_t axis = 0;
      for (std::size_t i = 1; i < 3; ++i)
      {
        if (std::abs(p[to][i] - p[from][i]) > std::abs(p[to][axis] - p[from][axis]))
        {
          axis = i;
        }
      }
      weights[to] = std::clamp((x[axis] - p[from][axis]) / (p[to][axis] - p[from][axis]), 0.0, 1.0);
      weights[from] = 1.0 - weights[to];
      return weights;
    }
    const DominantNormal normal = ComputeDominantNormal(p[0], p[1], p[2]);
    const int u = (normal.Axis + 1) % 3;
    const int v = (normal.Axis + 2) % 3;
    const auto area = [&](const double* a, const double* b) {
      return (a[u] - x[u]) * (b[v] - x[v]) - (a[v] - x[v]) * (b[u] - x[u]);
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      weights[i] = std::max(0.0, normal.Sign * area(p[(i + 1) % 3], p[(i + 2) % 3]));
      sum += weights[i];
    }
    for (double& weight : weights)
    {
      weight = sum > 0.0 ? weight / sum : 1.0 / 3.0;
    }
    return weights;
  }

  void NumberOwnCorners()
  {
    for (std::size_t i = 0; i < this->Selected.size(); ++i)
    {
      const Piece& piece = this->Cuts.Pieces[std::size_t(this->Selected[i])];
      const std::int32_t operand = this->Out.Split.Operand[i];
      const std::int32_t face = this->World.FirstFace(operand) + this->Out.Split.Parent[i];
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (IsCorner(piece.Where[k]))
        {
          this->Out.Split.Corners[i][k] = this->Out.PointMap[std::size_t(operand)][std::size_t(
            this->PointOfCorner(operand, face, piece.Where[k]))];
        }
      }
    }
  }

  /** Operands that were read inside out are given back in the orientation in which they came. */
  void UndoSwaps()
  {
    for (std::int32_t operand = 0; operand < this->World.NumberOfOperands(); ++operand)
    {
      if (this->World.IsSwapped(operand))
      {
        for (Fate& fate : this->Out.Fates[std::size_t(operand)])
        {
          fate = Opposite(fate);
        }
      }
    }
    for (std::size_t i = 0; i < this->Out.Split.Operand.size(); ++i)
    {
      if (this->World.IsSwapped(this->Out.Split.Operand[i]))
      {
        std::swap(this->Out.Split.Corners[i][1], this->Out.Split.Corners[i][2]);
        this->Out.Split.Reversed[i] = !this->Out.Split.Reversed[i];
      }
    }
  }

  const Scene& World;
  const Arrangement& Cuts;
  const SeamPoints Seams;
  CutSurfaces& Out;
  Executor& Threads;
  std::vector<std::int32_t> Selected; ///< the pieces in the result
  std::vector<Alias> VertexOfNode; ///< sorted by node
  std::vector<std::pair<std::int32_t, std::int32_t>> Shared;
  std::vector<Alias> Moved;
  std::int32_t NumberOfPoints = 0;
};

} // namespace

std::array<double, 3> PlaceOfNode(const Scene& scene, const PointTable& nodes, NodeId node)
{
  const std::int32_t vertex = nodes.Vertex(node);
  if (vertex >= 0)
  {
    return scene.OriginalPosition(vertex);
  }
  const double* p = nodes.Point(node).Approximation();
  return { scene.Grid().ToWorld(p[0]), scene.Grid().ToWorld(p[1]), scene.Grid().ToWorld(p[2]) };
}

void AssembleOutput(const Scene& scene, const Arrangement& cuts, Classification&& classes,
  SeamPoints seams, CutSurfaces& result, Executor& executor)
{
  Assembler(scene, cuts, seams, result, executor).Run(std::move(classes));
}

} // namespace sb
