// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrangement.h"

#include "FaceTriangulation.h"
#include "Hash.h"
#include "HilbertCurve.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cmath>

namespace sb
{

namespace
{

/** Corners that are points made while a face was cut count from here until they have become nodes.
 */
constexpr CornerRef FirstPending = 1 << 30;

/** The boundary of a region, order and direction aside. */
struct RegionKey
{
  std::array<std::uint64_t, 2> Boundary;
  std::int32_t Region;

  friend bool operator<(const RegionKey& l, const RegionKey& r)
  {
    return l.Boundary != r.Boundary ? l.Boundary < r.Boundary : l.Region < r.Region;
  }
};

/** An edge use whose ends may still be pending points. */
struct RawEdgeUse
{
  CornerRef From;
  CornerRef To;
  std::int32_t Region;
  bool IsContact;
};

/** What cutting a range of faces gives; regions, pieces and pending points are numbered within the
 * range. */
struct Batch
{
  std::vector<CutFace> Faces;
  std::vector<Region> Regions;
  std::vector<std::uint8_t> IsCoplanar; ///< [region] its face has coplanar contacts
  std::vector<Piece> Pieces;
  std::vector<RawEdgeUse> EdgeUses;
  std::vector<ContactPoint> Pending;
  std::vector<std::uint8_t> SelfIntersecting;
};

/** Cuts one face after the other. */
class FaceCutter : public ConstraintSource
{
public:
  FaceCutter(const Scene& scene, const ContactSet& contacts, const std::vector<NodeId>& nodes,
    const PointTable& table, const std::vector<NodeId>& nodeOfVertex,
    const std::vector<std::uint8_t>& self, Batch& batch)
    : World(scene)
    , Contacts(contacts)
    , Nodes(nodes)
    , Table(table)
    , NodeOfVertex(nodeOfVertex)
    , Self(self)
    , Out(batch)
  {
    this->Out.SelfIntersecting.assign(std::size_t(scene.NumberOfOperands()), 0);
  }

  void Cut(std::int32_t face, std::size_t firstContact, std::size_t endOfContacts)
  {
    this->Begin(face, firstContact, endOfContacts);
    this->InsertPoints();
    this->DrawContacts();
    this->CollectRegions();
  }

  ExactPoint Crossing(int constraint, int other) override
  {
    const Contact& first = this->ContactOf(constraint);
    const Contact& second = this->ContactOf(other);
    const std::int32_t operand = this->World.OperandOfFace(first.Other);
    if (!this->Self[std::size_t(operand)] && operand == this->World.OperandOfFace(second.Other))
    {
      this->Out.SelfIntersecting[std::size_t(operand)] = 1;
    }
    // An edge of a coplanar face is known by two of its points, which makes for smaller numbers.
    if (first.OtherEdge >= 0)
    {
      return this->OnEdge(first, second);
    }
    return second.OtherEdge >= 0
      ? this->OnEdge(second, first)
      : ExactPoint::ThreePlanes(ExactPlane::Through(this->P(0), this->P(1), this->P(2)),
          this->PlaneOf(first), this->PlaneOf(second));
  }

  void PassesThrough(int constraint, int vertex) override
  {
    // A clean operand's neighbouring faces meet at their ends only. So a point that another face of
    // the same operand makes inside this one's line shows two faces that touch without having been
    // cut against each other.
    const Contact& contact = this->ContactOf(constraint);
    const std::int32_t operand = this->World.OperandOfFace(contact.Other);
    if (this->Self[std::size_t(operand)] || this->Out.SelfIntersecting[std::size_t(operand)] ||
      std::size_t(vertex) >= this->NodeOfLocal.size())
    {
      return;
    }
    this->ListMakers();
    const Maker wanted{ this->NodeOfLocal[std::size_t(vertex)], operand, -1 };
    for (auto maker = std::lower_bound(this->Makers.begin(), this->Makers.end(), wanted);
         maker != this->Makers.end() && maker->Node == wanted.Node && maker->Operand == operand;
         ++maker)
    {
      if (maker->Face != contact.Other)
      {
        this->Out.SelfIntersecting[std::size_t(operand)] = 1;
        return;
      }
    }
  }

private:
  struct PointOnFace
  {
    NodeId Node;
    Location Where;
    int Vertex;
    std::uint64_t Order;
  };

  /** A face whose contact ends at a node. */
  struct Maker
  {
    NodeId Node;
    std::int32_t Operand;
    std::int32_t Face;

    friend bool operator<(const Maker& l, const Maker& r)
    {
      return l.Node != r.Node    ? l.Node < r.Node
        : l.Operand != r.Operand ? l.Operand < r.Operand
                                 : l.Face < r.Face;
    }
  };

  /** A contact that is not an edge of the triangulation of the points. */
  struct Stroke
  {
    std::uint64_t Rank;
    int From;
    int To;
    int Constraint;
  };

  const double* P(int corner) const
  {
    return this->World.Position(this->Corners[std::size_t(corner)]);
  }
  const Contact& ContactOf(int constraint) const
  {
    return this->Contacts.Contacts[this->FirstContact + std::size_t(constraint)];
  }

  std::array<const double*, 3> CornersOf(const Contact& contact) const
  {
    const std::array<std::int32_t, 3> corners = this->World.Corners(contact.Other);
    return { this->World.Position(corners[0]), this->World.Position(corners[1]),
      this->World.Position(corners[2]) };
  }

  ExactPlane PlaneOf(const Contact& contact) const
  {
    const std::array<const double*, 3> p = this->CornersOf(contact);
    return ExactPlane::Through(p[0], p[1], p[2]);
  }

  /** Where a contact along an edge of a coplanar face crosses another. */
  ExactPoint OnEdge(const Contact& contact, const Contact& other) const
  {
    const std::array<const double*, 3> p = this->CornersOf(contact);
    const std::array<const double*, 3> q = this->CornersOf(other);
    const auto edge = std::size_t(contact.OtherEdge);
    const double* from = p[edge];
    const double* to = p[(edge + 1) % 3];
    if (other.OtherEdge < 0)
    {
      return ExactPoint::LinePlane(from, to, q[0], q[1], q[2]);
    }
    const auto otherEdge = std::size_t(other.OtherEdge);
    return ExactPoint::LineLine(from, to, q[otherEdge], q[(otherEdge + 1) % 3], this->Normal.Axis);
  }

  void Begin(std::int32_t face, std::size_t firstContact, std::size_t endOfContacts)
  {
    this->Face = face;
    this->FirstContact = firstContact;
    this->EndOfContacts = endOfContacts;
    this->Operand = this->World.OperandOfFace(face);
    this->Corners = this->World.Corners(this->Operand, face);
    this->Normal = ComputeDominantNormal(this->P(0), this->P(1), this->P(2));
    this->HasCoplanar = false;
    this->Makers.clear();

    this->OnFace.clear();
    for (std::size_t i = firstContact; i < endOfContacts; ++i)
    {
      const Contact& contact = this->Contacts.Contacts[i];
      this->HasCoplanar = this->HasCoplanar || contact.OtherEdge != -1;
      for (int end = 0; end < 2; ++end)
      {
        this->OnFace.push_back(
          { this->Nodes[std::size_t(contact.Points[end])], contact.Ends[end], 0, 0 });
      }
    }
    std::sort(this->OnFace.begin(), this->OnFace.end(),
      [](const PointOnFace& l, const PointOnFace& r) { return l.Node < r.Node; });
    this->OnFace.erase(
      std::unique(this->OnFace.begin(), this->OnFace.end(),
        [](const PointOnFace& l, const PointOnFace& r) { return l.Node == r.Node; }),
      this->OnFace.end());
  }

  void InsertPoints()
  {
    std::array<const ExactPoint*, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t vertex = this->Corners[i];
      this->CornerPoints[i] = ExactPoint::Vertex(this->World.Position(vertex));
      corners[i] = &this->CornerPoints[i];
      const NodeId node = this->NodeOfVertex.empty() ? -1 : this->NodeOfVertex[std::size_t(vertex)];
      this->CornerRefs[i] = node >= 0 ? node : ~vertex;
    }
    for (PointOnFace& point : this->OnFace)
    {
      if (IsCorner(point.Where))
      {
        this->CornerRefs[std::size_t(point.Where)] = point.Node;
        point.Vertex = point.Where;
      }
    }
    this->Mesh.Reset(corners, this->Normal.Axis, this->Normal.Sign);
    this->NodeOfLocal.assign(this->CornerRefs.begin(), this->CornerRefs.end());
    this->WhereOfLocal.assign({ 0, 1, 2 });

    for (const std::size_t i : this->InsertionOrder())
    {
      PointOnFace& point = this->OnFace[i];
      const ExactPoint& place = this->Table.Point(point.Node);
      point.Vertex = IsEdge(point.Where) && this->Order.size() <= few
        ? this->Mesh.InsertOnEdge(&place, point.Where - 3)
        : this->Mesh.Insert(&place);
      this->NodeOfLocal.push_back(point.Node);
      this->WhereOfLocal.push_back(point.Where);
    }
  }

  static constexpr std::size_t few = 16;

  /** All points but the corners; many of them along a space-filling curve, so that each is found
   * near the one before. */
  const std::vector<std::size_t>& InsertionOrder()
  {
    this->Order.clear();
    for (std::size_t i = 0; i < this->OnFace.size(); ++i)
    {
      if (!IsCorner(this->OnFace[i].Where))
      {
        this->Order.push_back(i);
      }
    }
    if (this->Order.size() > few)
    {
      this->RankAlongCurve();
      std::sort(this->Order.begin(), this->Order.end(), [this](std::size_t l, std::size_t r) {
        return this->OnFace[l].Order != this->OnFace[r].Order
          ? this->OnFace[l].Order < this->OnFace[r].Order
          : l < r;
      });
    }
    return this->Order;
  }

  /** Over the box of the points, which may be crowded in a corner of the face. */
  void RankAlongCurve()
  {
    const int u = (this->Normal.Axis + 1) % 3;
    const int v = (this->Normal.Axis + 2) % 3;
    std::array<double, 2> low{ HUGE_VAL, HUGE_VAL };
    std::array<double, 2> high{ -HUGE_VAL, -HUGE_VAL };
    for (const std::size_t i : this->Order)
    {
      const double* p = this->Table.Point(this->OnFace[i].Node).Approximation();
      low = { std::min(low[0], p[u]), std::min(low[1], p[v]) };
      high = { std::max(high[0], p[u]), std::max(high[1], p[v]) };
    }
    const double extent = std::max(high[0] - low[0], high[1] - low[1]);
    const double scale = extent > 0.0 ? 65535.0 / extent : 0.0;
    for (const std::size_t i : this->Order)
    {
      const double* p = this->Table.Point(this->OnFace[i].Node).Approximation();
      this->OnFace[i].Order =
        HilbertIndex(static_cast<std::uint32_t>(std::clamp((p[u] - low[0]) * scale, 0.0, 65535.0)),
          static_cast<std::uint32_t>(std::clamp((p[v] - low[1]) * scale, 0.0, 65535.0)));
    }
  }

  int VertexOfEnd(const Contact& contact, int end) const
  {
    const NodeId node = this->Nodes[std::size_t(contact.Points[end])];
    return std::lower_bound(this->OnFace.begin(), this->OnFace.end(), node,
      [](const PointOnFace& point, NodeId value) { return point.Node < value; })
      ->Vertex;
  }

  /** All contacts of the face by the nodes at which they end; listed when first asked for. */
  void ListMakers()
  {
    if (!this->Makers.empty())
    {
      return;
    }
    for (std::size_t i = this->FirstContact; i < this->EndOfContacts; ++i)
    {
      const Contact& contact = this->Contacts.Contacts[i];
      const std::int32_t operand = this->World.OperandOfFace(contact.Other);
      for (const std::int32_t point : contact.Points)
      {
        this->Makers.push_back({ this->Nodes[std::size_t(point)], operand, contact.Other });
      }
    }
    std::sort(this->Makers.begin(), this->Makers.end());
  }

  void DrawContacts()
  {
    this->Strokes.clear();
    for (std::size_t i = this->FirstContact; i < this->EndOfContacts; ++i)
    {
      const Contact& contact = this->Contacts.Contacts[i];
      const int from = this->VertexOfEnd(contact, 0);
      const int to = this->VertexOfEnd(contact, 1);
      const int constraint = static_cast<int>(i - this->FirstContact);
      if (from != to && !this->Mesh.ConstrainEdge(from, to, constraint))
      {
        this->Strokes.push_back({ Mix(std::uint64_t(constraint)), from, to, constraint });
      }
    }
    // A long contact can cross many edges, but not contacts drawn before, which end it or are ended
    // by it. In random order the edges left to cross become few soon (Shewchuk and Brown, "Fast
    // segment insertion and incremental construction of constrained Delaunay triangulations",
    // Computational Geometry 48(8), 2015, section 4).
    if (this->Strokes.size() > few)
    {
      std::sort(this->Strokes.begin(), this->Strokes.end(),
        [](const Stroke& l, const Stroke& r) { return l.Rank < r.Rank; });
    }
    for (const Stroke& stroke : this->Strokes)
    {
      this->Mesh.Constrain(stroke.From, stroke.To, stroke.Constraint, *this);
    }
  }

  CornerRef RefOf(int vertex)
  {
    const auto index = std::size_t(vertex);
    while (this->NodeOfLocal.size() <= index)
    {
      // A crossing of two contacts, made while they were drawn.
      this->Out.Pending.push_back(
        { this->Mesh.Point(static_cast<int>(this->NodeOfLocal.size())), -1 });
      this->NodeOfLocal.push_back(
        FirstPending + static_cast<CornerRef>(this->Out.Pending.size() - 1));
      this->WhereOfLocal.push_back(Interior);
    }
    return this->NodeOfLocal[index];
  }

  void CollectRegions()
  {
    const std::vector<FaceTriangulation::Cell>& cells = this->Mesh.Cells();
    this->Out.Faces.push_back({ this->Face, static_cast<std::int32_t>(this->Out.Pieces.size()) });
    this->Visited.assign(cells.size(), 0);
    for (std::size_t seed = 0; seed < cells.size(); ++seed)
    {
      if (this->Visited[seed])
      {
        continue;
      }
      const auto region = static_cast<std::int32_t>(this->Out.Regions.size());
      this->Out.Regions.push_back(
        { this->Face, static_cast<std::int32_t>(this->Out.Pieces.size()), -1 });
      this->Out.IsCoplanar.push_back(this->HasCoplanar);
      this->Front.assign(1, static_cast<int>(seed));
      this->Visited[seed] = 1;
      while (!this->Front.empty())
      {
        const auto cell = std::size_t(this->Front.back());
        this->Front.pop_back();
        this->AddPiece(cells[cell], region);
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
          const int across = cells[cell].Neighbours[edge];
          if (cells[cell].Constraints[edge] == FaceTriangulation::None &&
            across != FaceTriangulation::None && !this->Visited[std::size_t(across)])
          {
            this->Visited[std::size_t(across)] = 1;
            this->Front.push_back(across);
          }
        }
      }
    }
  }

  void AddPiece(const FaceTriangulation::Cell& cell, std::int32_t region)
  {
    Piece piece;
    piece.Region = region;
    for (std::size_t i = 0; i < 3; ++i)
    {
      piece.Corners[i] = this->RefOf(cell.Vertices[i]);
      piece.Where[i] = this->WhereOfLocal[std::size_t(cell.Vertices[i])];
    }
    this->Out.Pieces.push_back(piece);
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const CornerRef from = piece.Corners[(edge + 1) % 3];
      const CornerRef to = piece.Corners[(edge + 2) % 3];
      const bool isContact = cell.Constraints[edge] != FaceTriangulation::None;
      const bool isOnBoundary = cell.Neighbours[edge] == FaceTriangulation::None;
      // An edge with an untouched end is no contact, and its faces are joined by that end. Regions
      // that cover the same points are found by their boundaries, for which such edges matter too.
      if (isContact || isOnBoundary)
      {
        this->Out.EdgeUses.push_back({ from, to, region, isContact });
      }
    }
  }

  const Scene& World;
  const ContactSet& Contacts;
  const std::vector<NodeId>& Nodes;
  const PointTable& Table;
  const std::vector<NodeId>& NodeOfVertex;
  const std::vector<std::uint8_t>& Self;
  Batch& Out;

  std::int32_t Face = -1;
  std::int32_t Operand = -1;
  std::size_t FirstContact = 0;
  std::size_t EndOfContacts = 0;
  std::array<std::int32_t, 3> Corners{};
  DominantNormal Normal{};
  bool HasCoplanar = false;
  std::array<ExactPoint, 3> CornerPoints;
  std::array<CornerRef, 3> CornerRefs{};
  std::vector<PointOnFace> OnFace;
  std::vector<std::size_t> Order;
  std::vector<Maker> Makers;
  std::vector<Stroke> Strokes;
  std::vector<CornerRef> NodeOfLocal;
  std::vector<Location> WhereOfLocal;
  std::vector<std::uint8_t> Visited;
  std::vector<int> Front;
  FaceTriangulation Mesh;
};

/** The faces to cut, each with its range of contacts. */
struct WorkItem
{
  std::int32_t Face;
  std::size_t FirstContact;
  std::size_t EndOfContacts;
};

std::vector<WorkItem> ListWork(const Scene& scene, const ContactSet& contacts,
  const std::vector<std::uint8_t>& self, const std::vector<std::uint8_t>& collapsed)
{
  std::vector<WorkItem> work;
  const std::vector<Contact>& all = contacts.Contacts;
  std::size_t contact = 0;
  const auto takeUpTo = [&](std::int32_t endOfFaces) {
    while (contact < all.size() && all[contact].Face < endOfFaces)
    {
      std::size_t end = contact;
      while (end < all.size() && all[end].Face == all[contact].Face)
      {
        ++end;
      }
      work.push_back({ all[contact].Face, contact, end });
      contact = end;
    }
  };
  for (std::int32_t operand = 0; operand < scene.NumberOfOperands(); ++operand)
  {
    const std::int32_t endOfFaces = scene.FirstFace(operand + 1);
    if (!self[std::size_t(operand)])
    {
      takeUpTo(endOfFaces);
      continue;
    }
    for (std::int32_t face = scene.FirstFace(operand); face < endOfFaces; ++face)
    {
      if (contact < all.size() && all[contact].Face == face)
      {
        takeUpTo(face + 1);
      }
      else if (collapsed.empty() || !collapsed[std::size_t(face)])
      {
        work.push_back({ face, contact, contact });
      }
    }
  }
  return work;
}

/** Nodes for all vertices of operands that are cut against themselves; empty where there are none.
 */
std::vector<NodeId> MakeVertexNodes(
  const Scene& scene, const std::vector<std::uint8_t>& self, PointTable& table, Executor& executor)
{
  std::vector<NodeId> result;
  std::vector<ContactPoint> points;
  std::vector<std::int32_t> vertices;
  for (std::int32_t operand = 0; operand < scene.NumberOfOperands(); ++operand)
  {
    if (self[std::size_t(operand)])
    {
      for (std::int32_t v = scene.FirstVertex(operand); v < scene.FirstVertex(operand + 1); ++v)
      {
        points.push_back({ ExactPoint::Vertex(scene.Position(v)), v });
        vertices.push_back(v);
      }
    }
  }
  if (!points.empty())
  {
    result.assign(std::size_t(scene.NumberOfVertices()), -1);
    const std::vector<NodeId> nodes = table.Insert(points, executor);
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      result[std::size_t(vertices[i])] = nodes[i];
    }
  }
  return result;
}

/** Put the batches together; pending points become nodes. */
std::vector<RegionKey> Merge(std::vector<Batch>& batches, Arrangement& result, Executor& executor)
{
  std::vector<ContactPoint> pending;
  for (const Batch& batch : batches)
  {
    pending.insert(pending.end(), batch.Pending.begin(), batch.Pending.end());
  }
  const std::vector<NodeId> nodes = result.Nodes.Insert(pending, executor);

  std::vector<RegionKey> keys;
  CornerRef firstPending = 0;
  for (Batch& batch : batches)
  {
    const auto firstPiece = static_cast<std::int32_t>(result.Pieces.size());
    const auto firstRegion = static_cast<std::int32_t>(result.Regions.size());
    const auto settle = [&](CornerRef corner) {
      return corner < FirstPending ? corner
                                   : nodes[std::size_t(corner - FirstPending + firstPending)];
    };
    for (CutFace face : batch.Faces)
    {
      face.FirstPiece += firstPiece;
      result.Faces.push_back(face);
    }
    for (Region region : batch.Regions)
    {
      region.FirstPiece += firstPiece;
      result.Regions.push_back(region);
    }
    for (Piece piece : batch.Pieces)
    {
      piece.Region += firstRegion;
      for (CornerRef& corner : piece.Corners)
      {
        corner = settle(corner);
      }
      result.Pieces.push_back(piece);
    }
    const std::size_t firstKey = keys.size();
    std::vector<std::int32_t> keyOfRegion(batch.Regions.size(), -1);
    for (std::size_t i = 0; i < batch.Regions.size(); ++i)
    {
      if (batch.IsCoplanar[i])
      {
        keyOfRegion[i] = static_cast<std::int32_t>(keys.size() - firstKey);
        keys.push_back({ { 0, 0 }, firstRegion + static_cast<std::int32_t>(i) });
      }
    }
    for (const RawEdgeUse& use : batch.EdgeUses)
    {
      const CornerRef from = settle(use.From);
      const CornerRef to = settle(use.To);
      const auto [low, high] = std::minmax(from, to);
      const std::int32_t key = keyOfRegion[std::size_t(use.Region)];
      if (key >= 0)
      {
        RegionKey& boundary = keys[firstKey + std::size_t(key)];
        boundary.Boundary[0] += HashPair(low, high, 0);
        boundary.Boundary[1] += HashPair(low, high, 1);
      }
      if (IsNode(low))
      {
        result.EdgeUses.push_back(
          { low, high, use.Region + firstRegion, from < to, use.IsContact });
      }
    }
    for (std::size_t i = 0; i < batch.SelfIntersecting.size(); ++i)
    {
      result.SelfIntersecting[i] |= batch.SelfIntersecting[i];
    }
    firstPending += static_cast<CornerRef>(batch.Pending.size());
    batch = Batch();
  }
  return keys;
}

void FindStacks(std::vector<RegionKey>& keys, Arrangement& result, Executor& executor)
{
  ParallelSort(
    keys, [](const RegionKey& l, const RegionKey& r) { return l < r; }, executor);
  for (std::size_t first = 0; first < keys.size();)
  {
    std::size_t last = first;
    while (last < keys.size() && keys[last].Boundary == keys[first].Boundary)
    {
      ++last;
    }
    if (last - first > 1)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        result.Regions[std::size_t(keys[i].Region)].Stack = result.NumberOfStacks;
      }
      ++result.NumberOfStacks;
    }
    first = last;
  }
}

} // namespace

Arrangement MakeArrangement(const Scene& scene, const ContactSet& contacts,
  const std::vector<std::uint8_t>& self, const std::vector<std::uint8_t>& collapsed,
  Executor& executor, Monitor& monitor)
{
  Arrangement result;
  result.SelfIntersecting.assign(std::size_t(scene.NumberOfOperands()), 0);
  const std::vector<NodeId> nodes = result.Nodes.Insert(contacts.Points, executor);
  const std::vector<NodeId> nodeOfVertex = MakeVertexNodes(scene, self, result.Nodes, executor);
  const std::vector<WorkItem> work = ListWork(scene, contacts, self, collapsed);

  constexpr std::int64_t facesPerBatch = 128;
  const auto numberOfFaces = static_cast<std::int64_t>(work.size());
  const std::int64_t numberOfBatches = (numberOfFaces + facesPerBatch - 1) / facesPerBatch;
  std::vector<Batch> batches(static_cast<std::size_t>(numberOfBatches));
  executor.For(numberOfBatches, 1, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      FaceCutter cutter(
        scene, contacts, nodes, result.Nodes, nodeOfVertex, self, batches[std::size_t(i)]);
      const std::int64_t stop = std::min(numberOfFaces, (i + 1) * facesPerBatch);
      for (std::int64_t face = i * facesPerBatch; face < stop && !monitor.Aborted(); ++face)
      {
        const WorkItem& item = work[std::size_t(face)];
        cutter.Cut(item.Face, item.FirstContact, item.EndOfContacts);
      }
    }
  });

  std::vector<RegionKey> keys = Merge(batches, result, executor);
  FindStacks(keys, result, executor);
  ParallelSort(
    result.EdgeUses, [](const EdgeUse& l, const EdgeUse& r) { return l < r; }, executor);
  return result;
}

} // namespace sb
