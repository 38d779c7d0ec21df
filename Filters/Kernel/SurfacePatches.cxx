// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePatches.h"

#include "DisjointSets.h"
#include "Hash.h"
#include "OutputAssembly.h"

#include <algorithm>
#include <cstring>

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
    this->Sets.Reset(this->NumberOfVertices + this->EndOfRegions - this->FirstRegion);
    this->JoinCoincidentVertices();
    this->JoinUntouchedFaces();
    this->JoinRegions();
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

  /** A hash table of places; the first vertex at a place stands for it. */
  void JoinCoincidentVertices()
  {
    std::size_t size = 1;
    while (size < 2 * std::size_t(this->NumberOfVertices))
    {
      size *= 2;
    }
    std::vector<std::int32_t> table(size, -1);
    for (std::int32_t vertex = 0; vertex < this->NumberOfVertices; ++vertex)
    {
      const double* p = this->World.Position(this->FirstVertex + vertex);
      std::size_t slot = std::size_t(HashOfPlace(p)) & (size - 1);
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

  static std::uint64_t HashOfPlace(const double* p)
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

  bool IsAt(std::int32_t vertex, const double* p) const
  {
    const double* q = this->World.Position(this->FirstVertex + vertex);
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  }

  void JoinUntouchedFaces()
  {
    const Surface& mesh = this->World.Mesh(this->Operand);
    this->IsCut.assign(std::size_t(mesh.NumberOfTriangles), 0);
    for (std::size_t i = this->BeginOfFaces; i < this->EndOfFaces; ++i)
    {
      this->IsCut[std::size_t(this->Cuts.Faces[i].Face - this->World.FirstFace(this->Operand))] = 1;
    }
    for (std::size_t i = 0; i < this->IsCut.size(); ++i)
    {
      if (this->IsUntouched(i))
      {
        const std::int32_t* corners = mesh.Triangles + 3 * i;
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
        for (const CornerRef corner : piece.Corners)
        {
          if (!IsNode(corner))
          {
            this->Sets.Unite(~corner - this->FirstVertex, this->SetOfRegion(piece.Region));
          }
        }
      }
    }
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
    for (std::size_t i = 0; i < this->IsCut.size(); ++i)
    {
      if (this->IsUntouched(i))
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
      const auto [low, high] = std::minmax(piece.Corners[k], piece.Corners[(k + 1) % 3]);
      const std::array<NodeId, 2> ends{ low, high };
      const auto at = std::lower_bound(this->CurveSegments.begin(), this->CurveSegments.end(), ends,
        [](const CurveSegment& segment, const std::array<NodeId, 2>& value) {
          return segment.Ends < value;
        });
      if (at != this->CurveSegments.end() && at->Ends == ends)
      {
        return true;
      }
    }
    return false;
  }

  void MarkPoints()
  {
    std::vector<std::uint8_t> nodes(std::size_t(this->Cuts.Nodes.Size()), 0);
    for (const CurveSegment& segment : this->CurveSegments)
    {
      nodes[std::size_t(segment.Ends[0])] = nodes[std::size_t(segment.Ends[1])] = 1;
    }
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
          if (IsNode(piece.Corners[k]) && nodes[std::size_t(piece.Corners[k])])
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
  DisjointSets Sets; ///< the operand's vertices, then its regions
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
