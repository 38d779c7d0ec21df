// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatches.h"

#include "DisjointSets.h"
#include "Hash.h"
#include "OutputAssembly.h"

#include <algorithm>

namespace sb
{

namespace
{

class PatchFinder
{
public:
  PatchFinder(const Scene& scene, const Arrangement& cuts, const std::vector<CurveSegment>& curves,
    std::int32_t operand, SplitSurface& surface)
    : World(scene)
    , Cuts(cuts)
    , CurveSegments(curves)
    , Operand(operand)
    , Out(surface)
    , FirstVertex(scene.FirstVertex(operand))
    , NumberOfVertices(scene.FirstVertex(operand + 1) - scene.FirstVertex(operand))
  {
    const auto before = [](const CutFace& cut, std::int32_t face) { return cut.Face < face; };
    const auto begin = cuts.Faces.begin();
    const auto end = cuts.Faces.end();
    this->BeginOfFaces =
      std::size_t(std::lower_bound(begin, end, scene.FirstFace(operand), before) - begin);
    this->EndOfFaces =
      std::size_t(std::lower_bound(begin, end, scene.FirstFace(operand + 1), before) - begin);
    this->FirstRegion = this->RegionAt(this->BeginOfFaces);
    this->EndOfRegions = this->RegionAt(this->EndOfFaces);
  }

  void Run()
  {
    this->MarkCutFaces();
    this->JoinCoincidentVertices();
    this->MarkCurves();
    this->JoinUntouchedFaces();
    this->JoinRegions();
    this->JoinHemFaces();
    this->NumberPatches();
    this->MarkPoints();
  }

private:
  std::int32_t RegionAt(std::size_t cutFace) const
  {
    return cutFace < this->Cuts.Faces.size()
      ? this->Cuts.Pieces[std::size_t(this->Cuts.Faces[cutFace].FirstPiece)].Region
      : static_cast<std::int32_t>(this->Cuts.Regions.size());
  }
  std::int32_t SetOfRegion(std::int32_t region) const
  {
    return this->NumberOfVertices + region - this->FirstRegion;
  }
  bool IsOwn(std::int32_t region) const
  {
    return region >= this->FirstRegion && region < this->EndOfRegions;
  }
  std::int32_t FaceOfRegion(std::int32_t region) const
  {
    return this->Cuts.Regions[std::size_t(region)].Face;
  }
  bool IsUntouched(std::size_t triangle) const
  {
    return this->Out.Fates[std::size_t(this->Operand)][triangle] == Fate::Kept &&
      !this->IsCut[triangle];
  }

  void MarkCutFaces()
  {
    this->IsCut.assign(std::size_t(this->World.Mesh(this->Operand).NumberOfTriangles), 0);
    for (std::size_t i = this->BeginOfFaces; i < this->EndOfFaces; ++i)
    {
      this->IsCut[std::size_t(this->TriangleOf(i))] = 1;
    }
  }

  std::int32_t TriangleOf(std::size_t cutFace) const
  {
    return this->Cuts.Faces[cutFace].Face - this->World.FirstFace(this->Operand);
  }

  /** A hash table of places; the first vertex at a place stands for it. */
  void JoinCoincidentVertices()
  {
    this->Sets.Reset(this->NumberOfVertices + this->EndOfRegions - this->FirstRegion);
    std::size_t size = 1;
    while (size < 2 * std::size_t(this->NumberOfVertices))
    {
      size *= 2;
    }
    std::vector<std::int32_t> table(size, -1);
    for (std::int32_t vertex = 0; vertex < this->NumberOfVertices; ++vertex)
    {
      const double* p = this->World.Position(this->FirstVertex + vertex);
      std::size_t slot = std::size_t(HashPlace(p)) & (size - 1);
      while (table[slot] >= 0 && !this->IsAt(table[slot], p))
      {
        slot = (slot + 1) & (size - 1);
      }
      if (table[slot] < 0)
      {
        table[slot] = vertex;
      }
      else
      {
        this->Sets.Unite(table[slot], vertex);
      }
    }
  }

  bool IsAt(std::int32_t vertex, const double* p) const
  {
    const double* q = this->World.Position(this->FirstVertex + vertex);
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  }

  /** Find the nodes on curves, and the places of vertices among them. */
  void MarkCurves()
  {
    this->IsNodeOnCurve.assign(std::size_t(this->Cuts.Nodes.Size()), 0);
    for (const CurveSegment& segment : this->CurveSegments)
    {
      for (const NodeId node : segment.Ends)
      {
        this->IsNodeOnCurve[std::size_t(node)] = 1;
      }
    }
    std::vector<NodeId> nodeOfPlace(std::size_t(this->NumberOfVertices), -1);
    bool isAny = false;
    this->ForEachVertexNode([&](std::int32_t vertex, NodeId node, std::int32_t) {
      if (this->IsNodeOnCurve[std::size_t(node)])
      {
        nodeOfPlace[std::size_t(this->Sets.Find(vertex))] = node;
        isAny = true;
      }
    });
    if (isAny)
    {
      this->CurveNodes.resize(nodeOfPlace.size());
      for (std::int32_t vertex = 0; vertex < this->NumberOfVertices; ++vertex)
      {
        this->CurveNodes[std::size_t(vertex)] = nodeOfPlace[std::size_t(this->Sets.Find(vertex))];
      }
    }
  }

  /** Call visit(vertex of the operand, node, region) for the corners of cut faces that are nodes.
   */
  template <class Visit>
  void ForEachVertexNode(Visit&& visit)
  {
    const Surface& mesh = this->World.Mesh(this->Operand);
    for (std::size_t i = this->BeginOfFaces; i < this->EndOfFaces; ++i)
    {
      const std::int32_t* corners = mesh.Triangles + 3 * std::size_t(this->TriangleOf(i));
      for (std::int32_t p = this->Cuts.Faces[i].FirstPiece; p < this->Cuts.EndOfPieces(i); ++p)
      {
        const Piece& piece = this->Cuts.Pieces[std::size_t(p)];
        for (std::size_t k = 0; k < 3; ++k)
        {
          if (IsCorner(piece.Where[k]) && IsNode(piece.Corners[k]))
          {
            visit(corners[piece.Where[k]], piece.Corners[k], piece.Region);
          }
        }
      }
    }
  }

  /** The node at a corner of a piece: a face may have a corner on a curve that it takes no part in.
   * -1: the corner is a vertex off the curves. */
  NodeId NodeAt(const Piece& piece, std::size_t k) const
  {
    const CornerRef corner = piece.Corners[k];
    return IsNode(corner)        ? corner
      : this->CurveNodes.empty() ? -1
                                 : this->CurveNodes[std::size_t(~corner - this->FirstVertex)];
  }

  bool IsHemFace(const std::int32_t* corners) const
  {
    return !this->CurveNodes.empty() &&
      std::any_of(corners, corners + 3,
        [this](std::int32_t vertex) { return this->CurveNodes[std::size_t(vertex)] >= 0; });
  }

  void JoinUntouchedFaces()
  {
    const Surface& mesh = this->World.Mesh(this->Operand);
    for (std::size_t i = 0; i < this->IsCut.size(); ++i)
    {
      if (this->IsUntouched(i))
      {
        const std::int32_t* corners = mesh.Triangles + 3 * i;
        if (this->IsHemFace(corners))
        {
          this->HemFaces.push_back(static_cast<std::int32_t>(i));
          continue;
        }
        this->Sets.Unite(corners[0], corners[1]);
        this->Sets.Unite(corners[0], corners[2]);
      }
    }
  }

  void JoinRegions()
  {
    for (std::size_t i = this->BeginOfFaces; i < this->EndOfFaces; ++i)
    {
      for (std::int32_t p = this->Cuts.Faces[i].FirstPiece; p < this->Cuts.EndOfPieces(i); ++p)
      {
        const Piece& piece = this->Cuts.Pieces[std::size_t(p)];
        for (std::size_t k = 0; k < 3; ++k)
        {
          if (IsNode(piece.Corners[k]))
          {
            continue;
          }
          if (this->NodeAt(piece, k) < 0)
          {
            this->Sets.Unite(
              ~piece.Corners[k] - this->FirstVertex, this->SetOfRegion(piece.Region));
            continue;
          }
          for (const std::size_t other : { (k + 1) % 3, (k + 2) % 3 })
          {
            this->AddHemEdge(
              this->NodeAt(piece, k), this->NodeAt(piece, other), this->SetOfRegion(piece.Region));
          }
        }
      }
    }
    this->ForEachVertexNode([&](std::int32_t vertex, NodeId node, std::int32_t region) {
      if (!this->IsNodeOnCurve[std::size_t(node)])
      {
        this->Sets.Unite(vertex, this->SetOfRegion(region));
      }
    });
    this->JoinAcrossEdges();
  }

  void JoinAcrossEdges()
  {
    const std::vector<EdgeUse>& uses = this->Cuts.EdgeUses;
    std::size_t curve = 0;
    std::vector<std::int32_t> regions;
    for (std::size_t first = 0; first < uses.size();)
    {
      const std::array<NodeId, 2> ends{ uses[first].Low, uses[first].High };
      bool isContact = false;
      regions.clear();
      for (; first < uses.size() && uses[first].Low == ends[0] && uses[first].High == ends[1];
           ++first)
      {
        isContact = isContact || uses[first].IsContact;
        if (this->IsOwn(uses[first].Region))
        {
          regions.push_back(uses[first].Region);
        }
      }
      while (curve < this->CurveSegments.size() && this->CurveSegments[curve].Ends < ends)
      {
        ++curve;
      }
      if (curve == this->CurveSegments.size() || this->CurveSegments[curve].Ends != ends)
      {
        isContact ? this->JoinAcrossContact(regions) : this->JoinAll(regions);
      }
    }
  }

  struct HemEdge
  {
    std::array<NodeId, 2> Ends;
    std::int32_t Set;
  };

  void AddHemEdge(NodeId from, NodeId to, std::int32_t set)
  {
    if (from >= 0 && to >= 0)
    {
      this->Hem.push_back({ { std::min(from, to), std::max(from, to) }, set });
    }
  }

  /**
   * A face of an operand that meets itself may have corners on a curve that it takes no part in. It
   * hangs together with others by its other corners, and by its edges.
   */
  void JoinHemFaces()
  {
    const Surface& mesh = this->World.Mesh(this->Operand);
    for (std::size_t i = 0; i < this->HemFaces.size(); ++i)
    {
      const std::int32_t set = this->Sets.Add();
      const std::int32_t* corners = mesh.Triangles + 3 * std::size_t(this->HemFaces[i]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const NodeId from = this->CurveNodes[std::size_t(corners[k])];
        if (from < 0)
        {
          this->Sets.Unite(corners[k], set);
        }
        this->AddHemEdge(from, this->CurveNodes[std::size_t(corners[(k + 1) % 3])], set);
      }
    }
    this->JoinAcrossHem();
  }

  void JoinAcrossHem()
  {
    std::vector<HemEdge>& edges = this->Hem;
    std::sort(edges.begin(), edges.end(), [](const HemEdge& l, const HemEdge& r) {
      return l.Ends != r.Ends ? l.Ends < r.Ends : l.Set < r.Set;
    });
    const std::vector<EdgeUse>& uses = this->Cuts.EdgeUses;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (this->IsOnCurve(edges[i].Ends))
      {
        continue;
      }
      if (i > 0 && edges[i].Ends == edges[i - 1].Ends)
      {
        this->Sets.Unite(edges[i - 1].Set, edges[i].Set);
      }
      auto use = std::lower_bound(uses.begin(), uses.end(), edges[i].Ends,
        [](const EdgeUse& l, const std::array<NodeId, 2>& ends) {
          return l.Low != ends[0] ? l.Low < ends[0] : l.High < ends[1];
        });
      for (; use != uses.end() && use->Low == edges[i].Ends[0] && use->High == edges[i].Ends[1];
           ++use)
      {
        if (this->IsOwn(use->Region))
        {
          this->Sets.Unite(this->SetOfRegion(use->Region), edges[i].Set);
        }
      }
    }
  }

  bool IsOnCurve(const std::array<NodeId, 2>& ends) const
  {
    const auto at = std::lower_bound(this->CurveSegments.begin(), this->CurveSegments.end(), ends,
      [](const CurveSegment& segment, const std::array<NodeId, 2>& value) {
        return segment.Ends < value;
      });
    return at != this->CurveSegments.end() && at->Ends == ends;
  }

  void JoinAll(const std::vector<std::int32_t>& regions)
  {
    for (std::size_t i = 1; i < regions.size(); ++i)
    {
      this->Sets.Unite(this->SetOfRegion(regions[0]), this->SetOfRegion(regions[i]));
    }
  }

  /** Sheets of one operand may cross here: each goes on in its own face, or from one face to the
   * next. */
  void JoinAcrossContact(std::vector<std::int32_t>& regions)
  {
    std::size_t alone = 0; // regions of the face by which the sheet gets here, and no further
    for (std::size_t i = 0; i < regions.size(); ++i)
    {
      if (i + 1 < regions.size() &&
        this->FaceOfRegion(regions[i]) == this->FaceOfRegion(regions[i + 1]))
      {
        this->Sets.Unite(this->SetOfRegion(regions[i]), this->SetOfRegion(regions[i + 1]));
        ++i;
      }
      else
      {
        regions[alone++] = regions[i];
      }
    }
    regions.resize(alone);
    if (alone == 2)
    {
      this->JoinAll(regions);
    }
  }

  std::int32_t PatchOfSet(std::int32_t member)
  {
    std::int32_t& patch = this->Patches[std::size_t(this->Sets.Find(member))];
    if (patch < 0)
    {
      patch = this->Out.NumberOfPatches++;
    }
    return patch;
  }

  /** In the order of the triangles, so that the numbers say something. */
  void NumberPatches()
  {
    const Surface& mesh = this->World.Mesh(this->Operand);
    this->Patches.assign(std::size_t(this->Sets.Size()), -1);
    this->Out.PatchOfTriangle.assign(std::size_t(mesh.NumberOfTriangles), -1);
    this->Out.HasCurveEdge.assign(std::size_t(mesh.NumberOfTriangles), 0);
    this->Out.PatchOfPiece.reserve(this->Out.Split.Parent.size());
    std::size_t cut = this->BeginOfFaces;
    std::size_t hem = 0;
    const std::int32_t firstOfHem =
      this->Sets.Size() - static_cast<std::int32_t>(this->HemFaces.size());
    for (std::size_t i = 0; i < this->IsCut.size(); ++i)
    {
      if (hem < this->HemFaces.size() && std::size_t(this->HemFaces[hem]) == i)
      {
        this->Out.PatchOfTriangle[i] =
          this->PatchOfSet(firstOfHem + static_cast<std::int32_t>(hem));
        ++hem;
      }
      else if (this->IsUntouched(i))
      {
        this->Out.PatchOfTriangle[i] = this->PatchOfSet(mesh.Triangles[3 * i]);
      }
      else if (this->IsCut[i])
      {
        this->NumberCutFace(i, cut++);
      }
    }
  }

  void NumberCutFace(std::size_t triangle, std::size_t cut)
  {
    const std::int32_t first = this->Cuts.Faces[cut].FirstPiece;
    if (!IsGivenAsPieces(this->Cuts, cut))
    {
      const Piece& piece = this->Cuts.Pieces[std::size_t(first)];
      this->Out.PatchOfTriangle[triangle] = this->PatchOfSet(this->SetOfRegion(piece.Region));
      this->Out.HasCurveEdge[triangle] = this->IsAnyEdgeOnCurve(piece);
      return;
    }
    for (std::int32_t p = first; p < this->Cuts.EndOfPieces(cut); ++p)
    {
      this->Out.PatchOfPiece.push_back(
        this->PatchOfSet(this->SetOfRegion(this->Cuts.Pieces[std::size_t(p)].Region)));
    }
  }

  bool IsAnyEdgeOnCurve(const Piece& piece) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const NodeId from = this->NodeAt(piece, k);
      const NodeId to = this->NodeAt(piece, (k + 1) % 3);
      if (this->IsOnCurve({ std::min(from, to), std::max(from, to) }))
      {
        return true;
      }
    }
    return false;
  }

  void MarkPoints()
  {
    this->Out.IsOnCurve.assign(
      this->Out.KeptPoints[std::size_t(this->Operand)].size() + this->Out.Interpolated.size(), 0);
    const Surface& mesh = this->World.Mesh(this->Operand);
    std::size_t output = 0;
    for (std::size_t i = this->BeginOfFaces; i < this->EndOfFaces; ++i)
    {
      const bool whole = !IsGivenAsPieces(this->Cuts, i);
      const auto triangle =
        std::size_t(this->Cuts.Faces[i].Face - this->World.FirstFace(this->Operand));
      for (std::int32_t p = this->Cuts.Faces[i].FirstPiece; p < this->Cuts.EndOfPieces(i); ++p)
      {
        const Piece& piece = this->Cuts.Pieces[std::size_t(p)];
        for (std::size_t k = 0; k < 3; ++k)
        {
          const NodeId node = this->NodeAt(piece, k);
          if (node >= 0 && this->IsNodeOnCurve[std::size_t(node)])
          {
            const std::int32_t point = whole
              ? this->Out.PointMap[std::size_t(this->Operand)][std::size_t(
                  mesh.Triangles[3 * triangle + std::size_t(piece.Where[k])])]
              : this->Out.Split.Corners[output][k];
            this->Out.IsOnCurve[std::size_t(point)] = 1;
          }
        }
        output += !whole;
      }
    }
    for (const std::int32_t triangle : this->HemFaces)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::int32_t vertex = mesh.Triangles[3 * std::size_t(triangle) + k];
        if (this->CurveNodes[std::size_t(vertex)] >= 0)
        {
          const std::int32_t point =
            this->Out.PointMap[std::size_t(this->Operand)][std::size_t(vertex)];
          this->Out.IsOnCurve[std::size_t(point)] = 1;
        }
      }
    }
  }

  const Scene& World;
  const Arrangement& Cuts;
  const std::vector<CurveSegment>& CurveSegments; ///< sorted by their ends
  const std::int32_t Operand;
  SplitSurface& Out;
  const std::int32_t FirstVertex;
  const std::int32_t NumberOfVertices;
  std::size_t BeginOfFaces; ///< of the arrangement's cut faces
  std::size_t EndOfFaces;
  std::int32_t FirstRegion;
  std::int32_t EndOfRegions;
  DisjointSets Sets; ///< the operand's vertices, then its regions, then its hem faces
  std::vector<std::uint8_t> IsNodeOnCurve;
  std::vector<NodeId> CurveNodes; ///< [vertex] the node there if it is on a curve, else -1; empty
                                  ///< where all are -1
  std::vector<HemEdge> Hem;
  std::vector<std::int32_t> HemFaces; ///< untouched triangles with corners on curves, ascending
  std::vector<std::uint8_t> IsCut; ///< [triangle]
  std::vector<std::int32_t> Patches; ///< [set]
};

/** Everything of one operand, and nothing of the others. */
Classification KeepAllOf(const Scene& scene, const Arrangement& cuts,
  const std::vector<std::uint8_t>& collapsed, std::int32_t operand)
{
  Classification all;
  all.Fates.resize(std::size_t(scene.NumberOfOperands()));
  std::vector<Fate>& fates = all.Fates[std::size_t(operand)];
  const std::int32_t first = scene.FirstFace(operand);
  const std::int32_t end = scene.FirstFace(operand + 1);
  fates.assign(std::size_t(end - first), Fate::Kept);
  for (std::int32_t face = first; face < end && !collapsed.empty(); ++face)
  {
    if (collapsed[std::size_t(face)])
    {
      fates[std::size_t(face - first)] = Fate::Dropped;
    }
  }
  for (const CutFace& cut : cuts.Faces)
  {
    if (cut.Face >= first && cut.Face < end)
    {
      fates[std::size_t(cut.Face - first)] = Fate::Split;
    }
  }
  for (const Region& region : cuts.Regions)
  {
    all.RegionFates.push_back(
      region.Face >= first && region.Face < end ? Fate::Kept : Fate::Dropped);
  }
  return all;
}

} // namespace

SplitSurface SplitAlongCurves(const Scene& scene, const Arrangement& cuts,
  const std::vector<CurveSegment>& curves, const std::vector<std::uint8_t>& collapsed,
  std::int32_t operand, Executor& executor)
{
  SplitSurface surface;
  AssembleOutput(scene, cuts, KeepAllOf(scene, cuts, collapsed, operand), SeamPoints::PerSide,
    surface, executor);
  PatchFinder(scene, cuts, curves, operand, surface).Run();
  return surface;
}

} // namespace sb
