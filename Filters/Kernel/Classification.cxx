// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Classification.h"

#include "Hash.h"
#include "InsideCount.h"
#include "ProbePlacement.h"
#include "RadialOrder.h"
#include "SheetSides.h"
#include "WindingQuery.h"

#include <algorithm>
#include <numeric>

namespace sb
{

namespace
{

enum class FaceState : std::uint8_t
{
  Far, ///< outside all other operands' boxes
  Untouched, ///< near others, but no contact
  Cut, ///< its regions decide
  Collapsed ///< has no area and takes no part
};

/** What the two sides of a patch, met across a wedge, have to do with each other: their winding
 * numbers are equal. */
struct Relation
{
  std::int32_t PatchA;
  std::int32_t PatchB;
  bool BehindA; ///< which side of A it is
  bool BehindB;

  friend bool operator==(const Relation& l, const Relation& r)
  {
    return l.PatchA == r.PatchA && l.PatchB == r.PatchB && l.BehindA == r.BehindA &&
      l.BehindB == r.BehindB;
  }
};

struct Patch
{
  std::int32_t Operand;
  std::int32_t Face; ///< one of its faces
  std::int32_t Region; ///< if that face is cut, one of its regions on it, else -1
  bool HasRim = false; ///< a sheet ends here
  bool FrontInside = false;
  bool BehindInside = false;
};

/** A step of a walk through a tree of patches that comes by every patch once and takes back all
 * changes on the way. */
struct Step
{
  std::int32_t Patch; ///< entered, or -1 when going back
  std::int32_t Raised; ///< operand whose winding number goes up by one, or -1
  std::int32_t Lowered; ///< operand whose winding number goes down by one, or -1
};

struct KnownWinding
{
  std::int32_t Operand;
  int Value;
};

struct Tree
{
  std::size_t FirstStep;
  std::size_t EndOfSteps;
  std::int32_t Probed; ///< the patch that queries are asked at
  std::vector<KnownWinding> AtRoot; ///< in front of the first patch, where not 0
};

/** How many faces a thread takes at a time. */
constexpr std::int64_t BlockSize = 1 << 14;

class Classifier
{
public:
  Classifier(const ClassificationInput& input, Executor& executor, Monitor& monitor)
    : In(input)
    , World(input.World)
    , Cuts(input.Cuts)
    , Threads(executor)
    , Watch(monitor)
    , NumberOfOperands(input.World.NumberOfOperands())
  {
    this->Result.SelfIntersecting = input.Cuts.SelfIntersecting;
    this->Result.NonSeparating.assign(std::size_t(this->NumberOfOperands), 0);
    for (std::int32_t operand = 0; operand < this->NumberOfOperands; ++operand)
    {
      if (input.Open[std::size_t(operand)])
      {
        this->OpenOperands.push_back(operand);
      }
    }
  }

  Classification Run()
  {
    this->MarkFaces();
    this->JoinPatches();
    this->ListPatches();
    this->MarkRims();
    this->RelateAcrossContacts();
    this->PlantTrees();
    this->CheckCycles();
    this->CheckFoldedRegions();
    this->FindWindingsAtRoots();
    if (!this->Watch.Aborted() && !this->MustStartAgain())
    {
      // A sheet found not to divide what it runs through counts otherwise from the start.
      while (this->Evaluate())
      {
      }
      this->DecideFaces();
      this->DecideRegions();
    }
    return std::move(this->Result);
  }

private:
  /** Whether an operand that was taken to be clean is not. */
  bool MustStartAgain() const
  {
    for (std::size_t i = 0; i < this->Result.SelfIntersecting.size(); ++i)
    {
      if (this->Result.SelfIntersecting[i] && !this->In.Self[i] && !this->In.Open[i])
      {
        return true;
      }
    }
    return false;
  }

  // --- patches
  // -----------------------------------------------------------------------------------------------------

  /** The boxes of other operands that an operand's faces have to be looked at for; nothing if all
   * faces have to be. */
  std::vector<std::array<double, 6>> NearBoxes(std::int32_t operand) const
  {
    const auto meets = [](const std::array<double, 6>& a, const std::array<double, 6>& b) {
      return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] &&
        b[4] <= a[5];
    };
    std::vector<std::array<double, 6>> boxes;
    for (std::int32_t other = 0; other < this->NumberOfOperands; ++other)
    {
      if (other != operand && this->World.FirstFace(other) < this->World.FirstFace(other + 1) &&
        meets(this->World.Bounds(operand), this->World.Bounds(other)))
      {
        boxes.push_back(this->World.Bounds(other));
      }
    }
    constexpr std::size_t few = 4;
    if (boxes.size() > few)
    {
      std::array<double, 6> hull = boxes.front();
      for (const std::array<double, 6>& box : boxes)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          hull[2 * axis] = std::min(hull[2 * axis], box[2 * axis]);
          hull[2 * axis + 1] = std::max(hull[2 * axis + 1], box[2 * axis + 1]);
        }
      }
      boxes.assign(1, hull);
    }
    return boxes;
  }

  void MarkFaces()
  {
    this->States.assign(std::size_t(this->World.NumberOfFaces()), FaceState::Far);
    this->Near.resize(std::size_t(this->NumberOfOperands));
    for (std::int32_t operand = 0; operand < this->NumberOfOperands; ++operand)
    {
      this->ListNearFaces(operand);
      for (const std::int32_t face : this->Near[std::size_t(operand)])
      {
        this->States[std::size_t(face)] = FaceState::Untouched;
      }
    }
    for (const CutFace& cut : this->Cuts.Faces)
    {
      this->States[std::size_t(cut.Face)] = FaceState::Cut;
    }
    for (std::size_t face = 0; face < this->In.Collapsed.size(); ++face)
    {
      if (this->In.Collapsed[face])
      {
        this->States[face] = FaceState::Collapsed;
      }
    }
  }

  void ListNearFaces(std::int32_t operand)
  {
    // A sheet has no far side: its sign reaches everywhere.
    const bool everywhere = !this->OpenOperands.empty() || this->IsSelf(operand);
    const std::vector<std::array<double, 6>> boxes = this->NearBoxes(operand);
    if (boxes.empty() && !everywhere)
    {
      return;
    }
    const std::int32_t first = this->World.FirstFace(operand);
    const std::int64_t count = this->World.FirstFace(operand + 1) - first;
    const std::vector<TriangleBlock>& blocks = this->World.Blocks(operand);
    std::vector<std::vector<std::int32_t>> found(blocks.size());
    this->Threads.For(
      static_cast<std::int64_t>(blocks.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end; ++block)
        {
          const Box& bounds = blocks[std::size_t(block)].Bounds;
          const bool wholly = everywhere || IsInsideAny(bounds, boxes);
          if (!wholly && !MeetsAny(bounds, boxes))
          {
            continue;
          }
          const std::int64_t stop = std::min(count, (block + 1) * TriangleBlock::Size);
          for (std::int64_t i = block * TriangleBlock::Size; i < stop; ++i)
          {
            const std::int32_t face = first + static_cast<std::int32_t>(i);
            if (wholly || MeetsAny(this->BoxOf(operand, face), boxes))
            {
              found[std::size_t(block)].push_back(face);
            }
          }
        }
      });
    std::vector<std::int32_t>& near = this->Near[std::size_t(operand)];
    for (const std::vector<std::int32_t>& block : found)
    {
      near.insert(near.end(), block.begin(), block.end());
    }
  }

  Box BoxOf(std::int32_t operand, std::int32_t face) const
  {
    const std::array<std::int32_t, 3> corners = this->World.Corners(operand, face);
    const double* a = this->World.Position(corners[0]);
    const double* b = this->World.Position(corners[1]);
    const double* c = this->World.Position(corners[2]);
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box.Lower[axis] = std::min({ a[axis], b[axis], c[axis] });
      box.Upper[axis] = std::max({ a[axis], b[axis], c[axis] });
    }
    return box;
  }

  static bool MeetsAny(const Box& box, const std::vector<std::array<double, 6>>& others)
  {
    return std::any_of(others.begin(), others.end(), [&box](const std::array<double, 6>& other) {
      return box.Lower[0] <= other[1] && box.Upper[0] >= other[0] && box.Lower[1] <= other[3] &&
        box.Upper[1] >= other[2] && box.Lower[2] <= other[5] && box.Upper[2] >= other[4];
    });
  }

  static bool IsInsideAny(const Box& box, const std::vector<std::array<double, 6>>& others)
  {
    return std::any_of(others.begin(), others.end(), [&box](const std::array<double, 6>& other) {
      return box.Lower[0] >= other[0] && box.Upper[0] <= other[1] && box.Lower[1] >= other[2] &&
        box.Upper[1] <= other[3] && box.Lower[2] >= other[4] && box.Upper[2] <= other[5];
    });
  }

  std::int32_t SetOfRegion(std::int32_t region) const
  {
    return this->World.NumberOfVertices() + region;
  }

  void JoinPatches()
  {
    this->Sets.Reset(
      this->World.NumberOfVertices() + static_cast<std::int32_t>(this->Cuts.Regions.size()));
    // Operands share no vertex, so their sets can be joined at the same time.
    this->Threads.For(this->NumberOfOperands, 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        this->JoinUntouchedFaces(static_cast<std::int32_t>(i));
      }
    });
    for (const Piece& piece : this->Cuts.Pieces)
    {
      for (const CornerRef corner : piece.Corners)
      {
        if (!IsNode(corner))
        {
          this->Sets.Unite(~corner, this->SetOfRegion(piece.Region));
        }
      }
    }
    this->GroupEdges();
  }

  void JoinUntouchedFaces(std::int32_t operand)
  {
    for (const std::int32_t face : this->Near[std::size_t(operand)])
    {
      if (this->States[std::size_t(face)] == FaceState::Untouched)
      {
        const std::array<std::int32_t, 3> corners = this->World.Corners(operand, face);
        this->Sets.Unite(corners[0], corners[1]);
        this->Sets.Unite(corners[0], corners[2]);
      }
    }
  }

  /** Free edges join the regions beside them; the others are contact edges. */
  void GroupEdges()
  {
    const std::vector<EdgeUse>& uses = this->Cuts.EdgeUses;
    for (std::size_t first = 0; first < uses.size();)
    {
      std::size_t end = first;
      bool isContact = false;
      while (
        end < uses.size() && uses[end].Low == uses[first].Low && uses[end].High == uses[first].High)
      {
        isContact = isContact || uses[end].IsContact;
        ++end;
      }
      if (isContact || this->IsSingularEdge(first, end))
      {
        this->ContactEdges.push_back({ first, end });
      }
      else
      {
        for (std::size_t i = first + 1; i < end; ++i)
        {
          this->Sets.Unite(
            this->SetOfRegion(uses[first].Region), this->SetOfRegion(uses[i].Region));
        }
      }
      first = end;
    }
  }

  /** Whether sides do not simply continue across a free edge: of an operand cut against itself,
   * where it is not manifold. */
  bool IsSingularEdge(std::size_t first, std::size_t end) const
  {
    const std::vector<EdgeUse>& uses = this->Cuts.EdgeUses;
    return this->In.Self[std::size_t(this->OperandOfRegion(uses[first].Region))] &&
      (end - first != 2 || uses[first].RunsUp == uses[first + 1].RunsUp);
  }

  std::int32_t OperandOfRegion(std::int32_t region) const
  {
    return this->World.OperandOfFace(this->Cuts.Regions[std::size_t(region)].Face);
  }

  void ListPatches()
  {
    this->PatchOfSet.assign(std::size_t(this->Sets.Size()), -1);
    for (std::int32_t operand = 0; operand < this->NumberOfOperands; ++operand)
    {
      for (const std::vector<SetAndFace>& block : this->ListSets(operand))
      {
        for (const SetAndFace& entry : block)
        {
          if (this->PatchOfSet[std::size_t(entry.Set)] < 0)
          {
            this->AddPatch(entry.Set, operand, entry.Face, -1);
          }
        }
      }
    }
    for (std::size_t region = 0; region < this->Cuts.Regions.size(); ++region)
    {
      const auto id = static_cast<std::int32_t>(region);
      const std::int32_t set = this->Sets.Find(this->SetOfRegion(id));
      if (this->PatchOfSet[std::size_t(set)] < 0)
      {
        this->AddPatch(set, this->OperandOfRegion(id), this->Cuts.Regions[region].Face, id);
      }
    }
    this->PreferFacesWithArea();
  }

  bool HasArea(std::int32_t face) const
  {
    const std::array<std::int32_t, 3> corners = this->World.Corners(face);
    return ComputeDominantNormal(this->World.Position(corners[0]), this->World.Position(corners[1]),
             this->World.Position(corners[2]))
             .Sign != 0;
  }

  /** A patch stands for itself by a face with area, if it has one: others have no side to ask
   * about.
   */
  void PreferFacesWithArea()
  {
    std::vector<std::uint8_t> isFlat(this->Patches.size(), 0);
    std::vector<std::uint8_t> hasFlat(std::size_t(this->NumberOfOperands), 0);
    for (std::size_t p = 0; p < this->Patches.size(); ++p)
    {
      isFlat[p] = !this->HasArea(this->Patches[p].Face);
      hasFlat[std::size_t(this->Patches[p].Operand)] |= isFlat[p];
    }
    for (std::int32_t operand = 0; operand < this->NumberOfOperands; ++operand)
    {
      if (!hasFlat[std::size_t(operand)])
      {
        continue;
      }
      for (const std::int32_t face : this->Near[std::size_t(operand)])
      {
        if (this->States[std::size_t(face)] != FaceState::Untouched)
        {
          continue;
        }
        const std::int32_t set = this->Sets.Find(this->World.Corners(operand, face)[0]);
        const auto patch = std::size_t(this->PatchOfSet[std::size_t(set)]);
        if (isFlat[patch] && this->HasArea(face))
        {
          isFlat[patch] = 0;
          this->Patches[patch].Face = face;
        }
      }
    }
    for (std::size_t region = 0; region < this->Cuts.Regions.size(); ++region)
    {
      const auto id = static_cast<std::int32_t>(region);
      const auto patch = std::size_t(this->PatchOfRegion(id));
      if (isFlat[patch]) // cut faces have area
      {
        isFlat[patch] = 0;
        this->Patches[patch].Face = this->Cuts.Regions[region].Face;
        this->Patches[patch].Region = id;
      }
    }
  }

  struct SetAndFace
  {
    std::int32_t Set;
    std::int32_t Face;
  };

  /** The sets that an operand's untouched faces are in, block by block, each with a face: repeated
   * only where the set changes from one face to the next. */
  std::vector<std::vector<SetAndFace>> ListSets(std::int32_t operand) const
  {
    const std::vector<std::int32_t>& near = this->Near[std::size_t(operand)];
    const auto count = static_cast<std::int64_t>(near.size());
    std::vector<std::vector<SetAndFace>> blocks(
      static_cast<std::size_t>((count + BlockSize - 1) / BlockSize));
    this->Threads.For(
      static_cast<std::int64_t>(blocks.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t block = begin; block < end; ++block)
        {
          std::vector<SetAndFace>& list = blocks[std::size_t(block)];
          const std::int64_t stop = std::min(count, (block + 1) * BlockSize);
          for (std::int64_t i = block * BlockSize; i < stop; ++i)
          {
            const std::int32_t face = near[std::size_t(i)];
            if (this->States[std::size_t(face)] == FaceState::Untouched)
            {
              const std::int32_t set = this->Sets.Root(this->World.Corners(operand, face)[0]);
              if (list.empty() || list.back().Set != set)
              {
                list.push_back({ set, face });
              }
            }
          }
        }
      });
    return blocks;
  }

  void AddPatch(std::int32_t set, std::int32_t operand, std::int32_t face, std::int32_t region)
  {
    this->PatchOfSet[std::size_t(set)] = static_cast<std::int32_t>(this->Patches.size());
    this->Patches.push_back({ operand, face, region });
  }

  std::int32_t PatchOfRegion(std::int32_t region) const
  {
    return this->PatchOfSet[std::size_t(this->Sets.Root(this->SetOfRegion(region)))];
  }

  void MarkRims()
  {
    for (const std::int32_t sheet : this->OpenOperands)
    {
      for (const RimEdge& rim : this->In.Rims[std::size_t(sheet)])
      {
        const std::int32_t face = this->World.FirstFace(sheet) + rim.Triangle;
        if (this->States[std::size_t(face)] == FaceState::Untouched)
        {
          const std::int32_t set = this->Sets.Find(this->World.Corners(sheet, face)[0]);
          this->Patches[std::size_t(this->PatchOfSet[std::size_t(set)])].HasRim = true;
        }
        else if (this->States[std::size_t(face)] == FaceState::Cut)
        {
          this->MarkRimOfCutFace(face, rim.Edge);
        }
      }
    }
  }

  void MarkRimOfCutFace(std::int32_t face, std::int32_t edge)
  {
    const auto isOnEdge = [&](Location where) {
      return where == 3 + edge || where == edge || where == (edge + 1) % 3;
    };
    const auto cut = std::lower_bound(this->Cuts.Faces.begin(), this->Cuts.Faces.end(), face,
      [](const CutFace& l, std::int32_t r) { return l.Face < r; });
    const std::int32_t end = this->Cuts.EndOfPieces(std::size_t(cut - this->Cuts.Faces.begin()));
    for (std::int32_t i = cut->FirstPiece; i < end; ++i)
    {
      const Piece& piece = this->Cuts.Pieces[std::size_t(i)];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t next = (k + 1) % 3;
        if (isOnEdge(piece.Where[k]) && isOnEdge(piece.Where[next]) &&
          !this->IsContactEdge(piece.Corners[k], piece.Corners[next]))
        {
          this->Patches[std::size_t(this->PatchOfRegion(piece.Region))].HasRim = true;
        }
      }
    }
  }

  /** Whether an edge of the arrangement lies on a contact: a rim there ends on another surface, and
   * not in space. */
  bool IsContactEdge(CornerRef a, CornerRef b) const
  {
    const EdgeUse wanted{ std::min(a, b), std::max(a, b), -1, false, false };
    const std::vector<EdgeUse>& uses = this->Cuts.EdgeUses;
    for (auto use = std::lower_bound(uses.begin(), uses.end(), wanted);
         use != uses.end() && use->Low == wanted.Low && use->High == wanted.High; ++use)
    {
      if (use->IsContact)
      {
        return true;
      }
    }
    return false;
  }

  // --- relations
  // ---------------------------------------------------------------------------------------------------

  void RelateAcrossContacts()
  {
    constexpr std::int64_t edgesPerBatch = 512;
    const auto numberOfEdges = static_cast<std::int64_t>(this->ContactEdges.size());
    const std::int64_t numberOfBatches = (numberOfEdges + edgesPerBatch - 1) / edgesPerBatch;
    std::vector<std::vector<Relation>> relations(static_cast<std::size_t>(numberOfBatches));
    std::vector<std::vector<SheetVote>> votes(static_cast<std::size_t>(numberOfBatches));
    std::vector<std::vector<std::int32_t>> folded(static_cast<std::size_t>(numberOfBatches));
    this->Threads.For(numberOfBatches, 1, [&](std::int64_t begin, std::int64_t end) {
      RadialOrder order(this->World, this->Cuts.Nodes);
      for (std::int64_t batch = begin; batch < end; ++batch)
      {
        const std::int64_t stop = std::min(numberOfEdges, (batch + 1) * edgesPerBatch);
        for (std::int64_t i = batch * edgesPerBatch; i < stop && !this->Watch.Aborted(); ++i)
        {
          this->RelateAround(this->ContactEdges[std::size_t(i)], order,
            relations[std::size_t(batch)], votes[std::size_t(batch)], folded[std::size_t(batch)]);
        }
      }
    });

    for (const std::vector<std::int32_t>& batch : folded)
    {
      this->FoldedRegions.insert(this->FoldedRegions.end(), batch.begin(), batch.end());
    }
    DisjointSets connected(static_cast<std::int32_t>(this->Patches.size()));
    for (const std::vector<Relation>& batch : relations)
    {
      for (const Relation& relation : batch)
      {
        (connected.Unite(relation.PatchA, relation.PatchB) ? this->Forest : this->Cycles)
          .push_back(relation);
      }
    }
    for (const std::vector<SheetVote>& batch : votes)
    {
      this->Votes.insert(this->Votes.end(), batch.begin(), batch.end());
    }
    this->Sides = CountVotes(std::move(this->Votes), this->Result.NonSeparating);
  }

  void RelateAround(const std::pair<std::size_t, std::size_t>& edge, RadialOrder& order,
    std::vector<Relation>& relations, std::vector<SheetVote>& votes,
    std::vector<std::int32_t>& folded) const
  {
    const std::vector<EdgeUse>& uses = this->Cuts.EdgeUses;
    std::vector<HalfPlane> pieces;
    for (std::size_t i = edge.first; i < edge.second; ++i)
    {
      pieces.push_back(
        { uses[i].Region, this->Cuts.Regions[std::size_t(uses[i].Region)].Face, uses[i].RunsUp });
    }
    if (pieces.size() < 2)
    {
      return; // the rim of a sheet in free space
    }
    order.Sort(uses[edge.first].Low, uses[edge.first].High, pieces);
    this->FindFolded(pieces, order, folded);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const HalfPlane& here = pieces[i];
      const HalfPlane& next = pieces[(i + 1) % pieces.size()];
      const Relation relation{ this->PatchOfRegion(here.Region), this->PatchOfRegion(next.Region),
        !here.RunsUp, next.RunsUp };
      if (relations.empty() || !(relations.back() == relation))
      {
        relations.push_back(relation);
      }
    }
    if (!this->OpenOperands.empty())
    {
      std::vector<PieceAtEdge> seen;
      for (const HalfPlane& piece : pieces)
      {
        const std::int32_t patch = this->PatchOfRegion(piece.Region);
        seen.push_back({ patch, this->Patches[std::size_t(patch)].Operand, piece.RunsUp });
      }
      Vote(this->OpenOperands, seen, order, votes);
    }
  }

  /** Pieces of one operand on top of each other: bodies that touch, or walls without thickness. */
  void FindFolded(const std::vector<HalfPlane>& pieces, const RadialOrder& order,
    std::vector<std::int32_t>& folded) const
  {
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const std::int32_t operand = this->OperandOfRegion(pieces[i].Region);
      for (std::size_t k = i + 1; k < pieces.size() && !this->IsSelf(operand); ++k)
      {
        if (this->OperandOfRegion(pieces[k].Region) == operand && order.Coincide(i, k))
        {
          folded.push_back(pieces[i].Region);
          folded.push_back(pieces[k].Region);
        }
      }
    }
  }

  /**
   * In front of a clean operand its winding number is 0. Where two of its pieces coincide, their
   * layers (RadialOrder.h) decide that, and not the surface: it is asked about.
   */
  void CheckFoldedRegions()
  {
    std::vector<std::int32_t>& folded = this->FoldedRegions;
    std::sort(folded.begin(), folded.end());
    folded.erase(std::unique(folded.begin(), folded.end()), folded.end());
    const ProbePlacement placement(this->World, this->Cuts);
    constexpr int attempts = 16;
    for (int attempt = 0; attempt < attempts && !folded.empty(); ++attempt)
    {
      std::vector<std::int32_t> asked;
      std::vector<WindingQuery> queries;
      for (const std::int32_t region : folded)
      {
        const std::int32_t face = this->Cuts.Regions[std::size_t(region)].Face;
        if (const auto line = placement.Place(face, region, attempt))
        {
          asked.push_back(region);
          queries.push_back({ *line, this->OperandOfRegion(region), 0, false });
        }
      }
      AnswerQueries(this->World, this->In.Collapsed, queries, this->Threads);
      folded.clear();
      for (std::size_t i = 0; i < asked.size(); ++i)
      {
        if (queries[i].Degenerate)
        {
          folded.push_back(asked[i]);
        }
        else if (WindingInFront(placement, queries[i], true) != 0)
        {
          this->Result.SelfIntersecting[std::size_t(queries[i].Operand)] = 1;
        }
      }
    }
  }

  /** From just above a face to just in front of it, which matters if it is one of the operand's
   * own. */
  static int WindingInFront(const ProbePlacement& placement, const WindingQuery& query, bool isOwn)
  {
    const bool frontIsUp = placement.NormalSign(query.Line.Face) > 0;
    return query.Winding - (!frontIsUp && isOwn ? 1 : 0);
  }

  // --- winding numbers
  // ---------------------------------------------------------------------------------------------

  bool IsOpen(std::int32_t operand) const { return this->In.Open[std::size_t(operand)] != 0; }
  bool IsSelf(std::int32_t operand) const { return this->In.Self[std::size_t(operand)] != 0; }

  void PlantTrees()
  {
    // Neighbours in the forest, as ranges of one array.
    std::vector<std::size_t> firstLink(this->Patches.size() + 1, 0);
    for (const Relation& relation : this->Forest)
    {
      ++firstLink[std::size_t(relation.PatchA) + 1];
      ++firstLink[std::size_t(relation.PatchB) + 1];
    }
    for (std::size_t i = 1; i < firstLink.size(); ++i)
    {
      firstLink[i] += firstLink[i - 1];
    }
    std::vector<Relation> links(2 * this->Forest.size());
    std::vector<std::size_t> next(firstLink.begin(), firstLink.end() - 1);
    for (const Relation& relation : this->Forest)
    {
      links[next[std::size_t(relation.PatchA)]++] = relation;
      links[next[std::size_t(relation.PatchB)]++] = { relation.PatchB, relation.PatchA,
        relation.BehindB, relation.BehindA };
    }
    next.assign(firstLink.begin(), firstLink.end() - 1);

    std::vector<std::uint8_t> planted(this->Patches.size(), 0);
    std::vector<std::pair<std::int32_t, Step>>
      path; // the patch, and the step that takes its entering back
    for (std::size_t root = 0; root < this->Patches.size(); ++root)
    {
      if (planted[root])
      {
        continue;
      }
      Tree tree{ this->Steps.size(), 0, static_cast<std::int32_t>(root), {} };
      planted[root] = 1;
      this->Steps.push_back({ static_cast<std::int32_t>(root), -1, -1 });
      path.assign(1, { static_cast<std::int32_t>(root), { -1, -1, -1 } });
      while (!path.empty())
      {
        const auto here = std::size_t(path.back().first);
        if (next[here] == firstLink[here + 1])
        {
          this->Steps.push_back(path.back().second);
          path.pop_back();
          continue;
        }
        const Relation& link = links[next[here]++];
        if (planted[std::size_t(link.PatchB)])
        {
          continue;
        }
        planted[std::size_t(link.PatchB)] = 1;
        // In front of B: what is in front of A, one more if the sides meet behind A, one less if
        // behind B.
        const std::int32_t up = link.BehindA ? this->Patches[here].Operand : -1;
        const std::int32_t down =
          link.BehindB ? this->Patches[std::size_t(link.PatchB)].Operand : -1;
        this->Steps.push_back({ link.PatchB, up, down });
        path.push_back({ link.PatchB, { -1, down, up } });
      }
      tree.EndOfSteps = this->Steps.size();
      this->Trees.push_back(tree);
    }
  }

  template <class OnEnter>
  void Walk(const Tree& tree, std::vector<int>& relative, OnEnter&& onEnter) const
  {
    for (std::size_t i = tree.FirstStep; i < tree.EndOfSteps; ++i)
    {
      const Step& step = this->Steps[i];
      if (step.Raised >= 0)
      {
        ++relative[std::size_t(step.Raised)];
      }
      if (step.Lowered >= 0)
      {
        --relative[std::size_t(step.Lowered)];
      }
      if (step.Patch >= 0)
      {
        onEnter(step.Patch);
      }
    }
  }

  /**
   * Relations outside the forest have to agree with it; where one does not, an operand contradicts
   * itself. To compare whole vectors of winding numbers, each is represented by one sum of random
   * weights.
   */
  void CheckCycles()
  {
    const auto weight = [this](std::int32_t operand) {
      return operand < 0 || this->IsOpen(operand) ? 0 : Mix(std::uint64_t(operand) + 1);
    };
    std::vector<std::uint64_t> sums(this->Patches.size(), 0);
    std::uint64_t sum = 0;
    for (const Step& step : this->Steps)
    {
      sum += weight(step.Raised) - weight(step.Lowered);
      if (step.Patch >= 0)
      {
        sums[std::size_t(step.Patch)] = sum;
      }
    }
    for (const Relation& relation : this->Cycles)
    {
      const std::int32_t a = this->Patches[std::size_t(relation.PatchA)].Operand;
      const std::int32_t b = this->Patches[std::size_t(relation.PatchB)].Operand;
      const std::uint64_t sideOfA =
        sums[std::size_t(relation.PatchA)] + (relation.BehindA ? weight(a) : 0);
      const std::uint64_t sideOfB =
        sums[std::size_t(relation.PatchB)] + (relation.BehindB ? weight(b) : 0);
      if (sideOfA != sideOfB)
      {
        this->Result.SelfIntersecting[std::size_t(a)] = 1;
        this->Result.SelfIntersecting[std::size_t(b)] = 1;
      }
    }
  }

  /** A question to the operand about the winding number at the root of a tree. */
  struct Question
  {
    std::size_t Tree;
    std::int32_t Patch; ///< where it is asked
    std::int32_t Operand;
    int Relative; ///< winding number in front of that patch, less that at the root
    bool IsCheck; ///< the answer has been assumed
    int Assumed; ///< winding number at the root
  };

  /** What the walks through the trees know of each operand while the winding numbers at the roots
   * are looked for. */
  struct RootSearch
  {
    RootSearch(std::int32_t numberOfOperands, const ProbePlacement& placement)
      : Relative(std::size_t(numberOfOperands), 0)
      , LastSeen(std::size_t(numberOfOperands), -1)
      , AtRoot(std::size_t(numberOfOperands), 0)
      , Placement(placement)
    {
    }

    std::vector<int> Relative; ///< winding numbers in front of the patch, less those at the root
    std::vector<int> RelativeAtProbe; ///< the same of the patch that the tree asks at
    std::vector<std::int32_t> LastSeen; ///< the last tree with a patch of the operand
    std::vector<int> AtRoot; ///< of the operands in that tree
    std::vector<std::int32_t> Present; ///< the operands in this tree
    std::vector<Question> Checks; ///< of this tree
    std::vector<Question> Questions; ///< of all trees
    const ProbePlacement& Placement;
  };

  void FindWindingsAtRoots()
  {
    this->ListMeetings();
    const ProbePlacement placement(this->World, this->Cuts);
    RootSearch search(this->NumberOfOperands, placement);
    for (std::size_t t = 0; t < this->Trees.size(); ++t)
    {
      this->SearchTree(t, search);
      for (Question& check : search.Checks)
      {
        check.Assumed = search.AtRoot[std::size_t(check.Operand)];
        this->CheckOrAsk(placement, check, search.Questions);
      }
      this->AskAtProbe(t, search);
    }
    this->Ask(search.Questions);
  }

  /** Walk through a tree: which operands are in it, with which winding numbers at its root, where
   * to ask, and what is to be checked. */
  void SearchTree(std::size_t t, RootSearch& search)
  {
    Tree& tree = this->Trees[t];
    search.Present.clear();
    search.Checks.clear();
    search.RelativeAtProbe = search.Relative;
    bool probeIsWhole = this->Patches[std::size_t(tree.Probed)].Region < 0;
    this->Walk(tree, search.Relative, [&](std::int32_t p) {
      const Patch& patch = this->Patches[std::size_t(p)];
      if (!probeIsWhole && patch.Region < 0)
      {
        // A face that nothing touches is the safest place to ask at.
        probeIsWhole = true;
        tree.Probed = p;
        search.RelativeAtProbe = search.Relative;
      }
      this->ListChecks(t, p, search.Relative, search.Checks);
      if (!this->IsOpen(patch.Operand))
      {
        this->AssumeAtRoot(t, patch.Operand, search);
      }
    });
  }

  /** In front of a clean operand's patch its winding number is 0, which tells it at the root. */
  void AssumeAtRoot(std::size_t t, std::int32_t operand, RootSearch& search)
  {
    const auto index = std::size_t(operand);
    const auto stamp = static_cast<std::int32_t>(t);
    const int atRoot = -search.Relative[index];
    if (search.LastSeen[index] != stamp)
    {
      search.LastSeen[index] = stamp;
      search.AtRoot[index] = atRoot;
      search.Present.push_back(operand);
      if (!this->IsSelf(operand) && atRoot != 0)
      {
        this->Trees[t].AtRoot.push_back({ operand, atRoot });
      }
    }
    else if (!this->IsSelf(operand) && search.AtRoot[index] != atRoot)
    {
      this->Result.SelfIntersecting[index] = 1;
    }
  }

  /** Ask every operand at the one place of the tree: to check those that are in it, to find the
   * number of those that are not. */
  void AskAtProbe(std::size_t t, RootSearch& search)
  {
    Tree& tree = this->Trees[t];
    const Patch& probed = this->Patches[std::size_t(tree.Probed)];
    if (probed.Region >= 0 && !search.Placement.Place(probed.Face, probed.Region, 0))
    {
      this->FindPlace(search.Placement, tree, search.Relative, search.RelativeAtProbe);
    }
    for (const std::int32_t operand : search.Present)
    {
      const auto index = std::size_t(operand);
      search.Questions.push_back({ t, tree.Probed, operand, search.RelativeAtProbe[index],
        !this->IsSelf(operand), search.AtRoot[index] });
    }
    const std::int32_t face = this->Patches[std::size_t(tree.Probed)].Face;
    for (std::int32_t operand = 0; operand < this->NumberOfOperands; ++operand)
    {
      if (search.LastSeen[std::size_t(operand)] != static_cast<std::int32_t>(t) &&
        !this->IsOpen(operand) && this->MayBeInside(face, operand))
      {
        search.Questions.push_back({ t, tree.Probed, operand, 0, false, 0 });
      }
    }
  }

  /** The other operands whose faces follow on those of a patch around an edge, as far as they are
   * taken to be clean. */
  void ListMeetings()
  {
    const auto add = [this](std::int32_t patch, std::int32_t other) {
      const std::int32_t operand = this->Patches[std::size_t(other)].Operand;
      if (operand != this->Patches[std::size_t(patch)].Operand && !this->IsSelf(operand) &&
        !this->IsOpen(operand))
      {
        this->Meetings.push_back({ patch, operand });
      }
    };
    for (const Relation& relation : this->Forest)
    {
      add(relation.PatchA, relation.PatchB);
      add(relation.PatchB, relation.PatchA);
    }
    std::sort(this->Meetings.begin(), this->Meetings.end());
    this->Meetings.erase(
      std::unique(this->Meetings.begin(), this->Meetings.end()), this->Meetings.end());
  }

  /**
   * The winding number of an operand is the same all over another one's patch, so that to ask at
   * one place shows whether it is what was assumed. Its own patches may run through each other
   * unseen, and do not tell. Where a patch follows on another one's only, the number is that one's.
   */
  void ListChecks(std::size_t tree, std::int32_t p, const std::vector<int>& relative,
    std::vector<Question>& checks) const
  {
    for (auto meeting = std::lower_bound(this->Meetings.begin(), this->Meetings.end(),
           std::pair<std::int32_t, std::int32_t>(p, -1));
         meeting != this->Meetings.end() && meeting->first == p; ++meeting)
    {
      checks.push_back(
        { tree, p, meeting->second, relative[std::size_t(meeting->second)], true, 0 });
    }
  }

  /** Outside of an operand's box its winding number is known. */
  void CheckOrAsk(
    const ProbePlacement& placement, const Question& check, std::vector<Question>& questions)
  {
    const Patch& patch = this->Patches[std::size_t(check.Patch)];
    if (patch.Region >= 0 && !placement.Place(patch.Face, patch.Region, 0))
    {
      this->FindPlaceOn(placement, check.Patch);
    }
    if (patch.Region >= 0 || this->MayBeInside(patch.Face, check.Operand))
    {
      questions.push_back(check);
    }
    else if (check.Assumed + check.Relative != 0)
    {
      this->Result.SelfIntersecting[std::size_t(check.Operand)] = 1;
    }
  }

  /** Regions by the patch that they belong to: the regions, and where each patch's begin. */
  struct RegionsByPatch
  {
    std::vector<std::int32_t> First;
    std::vector<std::int32_t> Regions;
  };

  void ListRegionsOfPatches()
  {
    std::vector<std::int32_t>& first = this->OfPatches.First;
    first.assign(this->Patches.size() + 1, 0);
    const auto count = static_cast<std::int32_t>(this->Cuts.Regions.size());
    for (std::int32_t region = 0; region < count; ++region)
    {
      ++first[std::size_t(this->PatchOfRegion(region)) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next(first);
    this->OfPatches.Regions.resize(std::size_t(count));
    for (std::int32_t region = 0; region < count; ++region)
    {
      const std::int32_t place = next[std::size_t(this->PatchOfRegion(region))]++;
      this->OfPatches.Regions[std::size_t(place)] = region;
    }
  }

  /** Let a patch stand for itself by the first of its regions that is wide enough to ask at.
   * @return whether there is one */
  bool FindPlaceOn(const ProbePlacement& placement, std::int32_t p)
  {
    if (this->OfPatches.First.empty())
    {
      this->ListRegionsOfPatches();
    }
    const std::int32_t end = this->OfPatches.First[std::size_t(p) + 1];
    for (std::int32_t i = this->OfPatches.First[std::size_t(p)]; i < end; ++i)
    {
      const std::int32_t region = this->OfPatches.Regions[std::size_t(i)];
      const std::int32_t face = this->Cuts.Regions[std::size_t(region)].Face;
      if (placement.Place(face, region, 0))
      {
        this->Patches[std::size_t(p)].Face = face;
        this->Patches[std::size_t(p)].Region = region;
        return true;
      }
    }
    return false;
  }

  /** Probe a tree at the first of its regions that is wide enough, where the one it stands for is
   * not. */
  void FindPlace(const ProbePlacement& placement, Tree& tree, std::vector<int>& relative,
    std::vector<int>& relativeAtProbe)
  {
    bool isFound = false;
    this->Walk(tree, relative, [&](std::int32_t p) {
      if (!isFound && this->FindPlaceOn(placement, p))
      {
        isFound = true;
        tree.Probed = p;
        relativeAtProbe = relative;
      }
    });
  }

  /** Whether all corners of a face are inside the box of an operand. */
  bool MayBeInside(std::int32_t face, std::int32_t operand) const
  {
    if (this->World.FirstFace(operand) == this->World.FirstFace(operand + 1))
    {
      return false;
    }
    const std::array<double, 6>& box = this->World.Bounds(operand);
    for (const std::int32_t corner : this->World.Corners(face))
    {
      const double* p = this->World.Position(corner);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        if (p[axis] < box[2 * axis] || p[axis] > box[2 * axis + 1])
        {
          return false;
        }
      }
    }
    return true;
  }

  void Ask(std::vector<Question> questions)
  {
    // Patches without area enclose nothing: kept or dropped, they change no solid.
    questions.erase(std::remove_if(questions.begin(), questions.end(),
                      [&](const Question& question) {
                        return !this->HasArea(this->Patches[std::size_t(question.Patch)].Face);
                      }),
      questions.end());
    const ProbePlacement placement(this->World, this->Cuts);
    // A line that meets an edge is asked again elsewhere. Where no place is left, in solids thinner
    // than the lattice, the last answer stands.
    constexpr int attempts = 64;
    for (int attempt = 0; !questions.empty() && !this->Watch.Aborted(); ++attempt)
    {
      const bool isLast = attempt + 1 == attempts;
      std::vector<Question> again;
      std::vector<Question> asked;
      std::vector<WindingQuery> queries;
      for (const Question& question : questions)
      {
        const Patch& patch = this->Patches[std::size_t(question.Patch)];
        if (const auto line = placement.Place(patch.Face, patch.Region, attempt))
        {
          asked.push_back(question);
          queries.push_back({ *line, question.Operand, 0, false });
        }
        else if (!isLast)
        {
          again.push_back(question);
        }
      }
      AnswerQueries(this->World, this->In.Collapsed, queries, this->Threads);
      for (std::size_t i = 0; i < asked.size(); ++i)
      {
        const Question& question = asked[i];
        if (queries[i].Degenerate && !isLast)
        {
          again.push_back(question);
          continue;
        }
        const Patch& patch = this->Patches[std::size_t(question.Patch)];
        const int atRoot =
          WindingInFront(placement, queries[i], patch.Operand == question.Operand) -
          question.Relative;
        if (question.IsCheck)
        {
          if (atRoot != question.Assumed)
          {
            this->Result.SelfIntersecting[std::size_t(question.Operand)] = 1;
          }
        }
        else if (atRoot != 0)
        {
          this->Trees[question.Tree].AtRoot.push_back({ question.Operand, atRoot });
        }
      }
      questions = std::move(again);
    }
  }

  // --- decisions
  // ---------------------------------------------------------------------------------------------------

  /** @return whether a sheet was found not to separate. */
  bool Evaluate()
  {
    const std::vector<std::uint8_t> before = this->Result.NonSeparating;
    InsideCount count(this->World, this->In.Op);
    const DistanceSign distance(this->World);
    for (const Tree& tree : this->Trees)
    {
      for (const KnownWinding& known : tree.AtRoot)
      {
        count.Add(known.Operand, known.Value);
      }
      for (std::size_t i = tree.FirstStep; i < tree.EndOfSteps; ++i)
      {
        const Step& step = this->Steps[i];
        if (step.Raised >= 0 && !this->IsOpen(step.Raised))
        {
          count.Add(step.Raised, 1);
        }
        if (step.Lowered >= 0 && !this->IsOpen(step.Lowered))
        {
          count.Add(step.Lowered, -1);
        }
        if (step.Patch >= 0)
        {
          this->EvaluatePatch(step.Patch, count, distance);
        }
      }
      for (const KnownWinding& known : tree.AtRoot)
      {
        count.Add(known.Operand, -known.Value);
      }
    }
    return this->Result.NonSeparating != before;
  }

  void EvaluatePatch(std::int32_t p, InsideCount& count, const DistanceSign& distance)
  {
    Patch& patch = this->Patches[std::size_t(p)];
    if (count.NumberOfMultiple() > 0)
    {
      for (std::int32_t operand = 0; operand < this->NumberOfOperands; ++operand)
      {
        if (operand != patch.Operand && !this->IsSelf(operand) && count.IsMultiple(operand))
        {
          this->Result.SelfIntersecting[std::size_t(operand)] = 1;
        }
      }
    }
    if (patch.HasRim && count.IsInsideOtherGroup(patch.Operand))
    {
      this->Result.NonSeparating[std::size_t(patch.Operand)] = 1;
    }
    // Sheets stand in for this patch only.
    std::vector<std::int32_t> behindSheets;
    for (const std::int32_t sheet : this->OpenOperands)
    {
      if (sheet != patch.Operand && !this->Result.NonSeparating[std::size_t(sheet)] &&
        this->IsBehind(p, sheet, distance))
      {
        behindSheets.push_back(sheet);
        count.Add(sheet, 1);
      }
    }
    patch.FrontInside = count.IsInside();
    count.Add(patch.Operand, 1);
    patch.BehindInside = count.IsInside();
    count.Add(patch.Operand, -1);
    if (this->Result.NonSeparating[std::size_t(patch.Operand)] &&
      this->World.Side(patch.Operand) == Group::Tool)
    {
      patch.BehindInside = patch.FrontInside;
    }
    for (const std::int32_t sheet : behindSheets)
    {
      count.Add(sheet, -1);
    }
  }

  bool IsBehind(std::int32_t patch, std::int32_t sheet, const DistanceSign& distance) const
  {
    const int side = this->Sides.Find(patch, sheet);
    return side >= 0 ? side == 1 : distance.IsBehind(this->Patches[std::size_t(patch)].Face, sheet);
  }

  static Fate Decide(bool frontInside, bool behindInside)
  {
    return frontInside == behindInside ? Fate::Dropped
      : behindInside                   ? Fate::Kept
                                       : Fate::KeptReversed;
  }

  void DecideFaces()
  {
    this->Result.Fates.resize(std::size_t(this->NumberOfOperands));
    for (std::int32_t operand = 0; operand < this->NumberOfOperands; ++operand)
    {
      InsideCount count(this->World, this->In.Op);
      const bool outside = count.IsInside();
      count.Add(operand, 1);
      const Fate far = Decide(outside, count.IsInside());
      const std::int32_t first = this->World.FirstFace(operand);
      std::vector<Fate>& fates = this->Result.Fates[std::size_t(operand)];
      fates.assign(std::size_t(this->World.FirstFace(operand + 1) - first), far);
      const std::vector<std::int32_t>& near = this->Near[std::size_t(operand)];
      this->Threads.For(static_cast<std::int64_t>(near.size()), BlockSize,
        [&](std::int64_t begin, std::int64_t end) {
          for (std::int64_t i = begin; i < end; ++i)
          {
            const std::int32_t face = near[std::size_t(i)];
            fates[std::size_t(face - first)] = this->DecideFace(operand, face);
          }
        });
    }
    // Cut and collapsed faces may lie beyond the boxes, where a collapsed face has been stitched.
    for (const CutFace& cut : this->Cuts.Faces)
    {
      this->FateOf(cut.Face) = Fate::Split;
    }
    for (std::size_t face = 0; face < this->In.Collapsed.size(); ++face)
    {
      if (this->In.Collapsed[face])
      {
        this->FateOf(static_cast<std::int32_t>(face)) = Fate::Dropped;
      }
    }
  }

  Fate& FateOf(std::int32_t face)
  {
    const std::int32_t operand = this->World.OperandOfFace(face);
    return this->Result
      .Fates[std::size_t(operand)][std::size_t(face - this->World.FirstFace(operand))];
  }

  /** The fate of a near face. */
  Fate DecideFace(std::int32_t operand, std::int32_t face) const
  {
    switch (this->States[std::size_t(face)])
    {
      case FaceState::Cut:
        return Fate::Split;
      case FaceState::Untouched: {
        const std::int32_t set = this->Sets.Root(this->World.Corners(operand, face)[0]);
        const Patch& patch = this->Patches[std::size_t(this->PatchOfSet[std::size_t(set)])];
        return Decide(patch.FrontInside, patch.BehindInside);
      }
      case FaceState::Far:
      case FaceState::Collapsed:
        break;
    }
    return Fate::Dropped;
  }

  void DecideRegions()
  {
    const std::vector<Region>& regions = this->Cuts.Regions;
    this->Result.RegionFates.resize(regions.size());
    std::vector<std::vector<std::int32_t>> stacks(std::size_t(this->Cuts.NumberOfStacks));
    for (std::size_t i = 0; i < regions.size(); ++i)
    {
      const auto region = static_cast<std::int32_t>(i);
      const Patch& patch = this->Patches[std::size_t(this->PatchOfRegion(region))];
      this->Result.RegionFates[i] = Decide(patch.FrontInside, patch.BehindInside);
      if (regions[i].Stack >= 0)
      {
        stacks[std::size_t(regions[i].Stack)].push_back(region);
      }
    }
    for (const std::vector<std::int32_t>& stack : stacks)
    {
      this->DecideStack(stack);
    }
  }

  /** Regions of one stack, lowest layer first (RadialOrder.h): by face id. */
  void DecideStack(const std::vector<std::int32_t>& stack)
  {
    const auto side = [this](std::int32_t region, bool upper) {
      const Patch& patch = this->Patches[std::size_t(this->PatchOfRegion(region))];
      return this->FacesUp(region) == upper ? patch.FrontInside : patch.BehindInside;
    };
    const bool below = side(stack.front(), false);
    const bool above = side(stack.back(), true);
    for (const std::int32_t region : stack)
    {
      this->Result.RegionFates[std::size_t(region)] = Fate::Dropped;
    }
    if (below == above)
    {
      return;
    }
    // The first that faces outwards as it is; failing that, the first.
    const auto chosen = std::find_if(stack.begin(), stack.end(),
      [&](std::int32_t region) { return this->FacesUp(region) == below; });
    const std::int32_t region = chosen != stack.end() ? *chosen : stack.front();
    this->Result.RegionFates[std::size_t(region)] =
      chosen != stack.end() ? Fate::Kept : Fate::KeptReversed;
  }

  bool FacesUp(std::int32_t region) const
  {
    const std::array<std::int32_t, 3> corners =
      this->World.Corners(this->Cuts.Regions[std::size_t(region)].Face);
    return ComputeDominantNormal(this->World.Position(corners[0]), this->World.Position(corners[1]),
             this->World.Position(corners[2]))
             .Sign > 0;
  }

  const ClassificationInput& In;
  const Scene& World;
  const Arrangement& Cuts;
  Executor& Threads;
  Monitor& Watch;
  const std::int32_t NumberOfOperands;
  std::vector<std::int32_t> OpenOperands;

  std::vector<FaceState> States;
  std::vector<std::vector<std::int32_t>> Near; ///< [operand] its faces that are not far, ascending
  DisjointSets Sets; ///< over vertices, then regions
  std::vector<std::pair<std::size_t, std::size_t>> ContactEdges; ///< ranges of edge uses
  std::vector<std::int32_t> PatchOfSet;
  RegionsByPatch OfPatches; ///< made where it is needed
  std::vector<std::int32_t> FoldedRegions;
  std::vector<Patch> Patches;
  std::vector<Relation> Forest;
  std::vector<Relation> Cycles; ///< the other relations
  std::vector<std::pair<std::int32_t, std::int32_t>>
    Meetings; ///< patches and the clean operands that they meet, ascending
  std::vector<SheetVote> Votes;
  SheetSides Sides;
  std::vector<Step> Steps;
  std::vector<Tree> Trees;
  Classification Result;
};

} // namespace

Classification Classify(const ClassificationInput& input, Executor& executor, Monitor& monitor)
{
  return Classifier(input, executor, monitor).Run();
}

} // namespace sb
