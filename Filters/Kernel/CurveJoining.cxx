// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CurveJoining.h"

#include "OutputAssembly.h"

#include <algorithm>
#include <numeric>

namespace sb
{

namespace
{

/** One end of a segment, to find the segments at a node. */
struct EndOfSegment
{
  NodeId Node;
  std::int32_t Segment;

  friend bool operator<(const EndOfSegment& l, const EndOfSegment& r)
  {
    return l.Node != r.Node ? l.Node < r.Node : l.Segment < r.Segment;
  }
};

/** Tells which edges of the arrangement are on a curve. */
class SegmentFinder
{
public:
  SegmentFinder(const Scene& scene, const Arrangement& cuts, CurveKind kind)
    : World(scene)
    , Cuts(cuts)
    , Kind(kind)
  {
  }

  std::vector<CurveSegment> Run()
  {
    std::vector<CurveSegment> segments;
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
      if (isContact && this->OperandsMeet(first, end) && this->SurfacesPart(first, end))
      {
        segments.push_back({ { uses[first].Low, uses[first].High }, this->MakersOf(first, end) });
      }
      first = end;
    }
    return segments;
  }

private:
  std::int32_t FaceOf(const EdgeUse& use) const
  {
    return this->Cuts.Regions[std::size_t(use.Region)].Face;
  }
  std::int32_t OperandOf(std::size_t use) const
  {
    return this->World.OperandOfFace(this->FaceOf(this->Cuts.EdgeUses[use]));
  }

  /** Whether it is more than one surface going on. */
  bool OperandsMeet(std::size_t first, std::size_t end) const
  {
    if (this->Kind == CurveKind::All && end - first > 2)
    {
      return true;
    }
    const std::int32_t operand = this->OperandOf(first);
    for (std::size_t i = first + 1; i < end; ++i)
    {
      if (this->OperandOf(i) != operand)
      {
        return true;
      }
    }
    return false;
  }

  /** Not so where all surfaces at the edge coincide on both of its sides. */
  bool SurfacesPart(std::size_t first, std::size_t end) const
  {
    std::vector<std::pair<std::int32_t, std::int32_t>> stacks; // operand, stack
    for (std::size_t i = first; i < end; ++i)
    {
      const EdgeUse& use = this->Cuts.EdgeUses[i];
      const std::int32_t stack = this->Cuts.Regions[std::size_t(use.Region)].Stack;
      if (stack < 0)
      {
        return true;
      }
      stacks.emplace_back(this->World.OperandOfFace(this->FaceOf(use)), stack);
    }
    std::sort(stacks.begin(), stacks.end());
    stacks.erase(std::unique(stacks.begin(), stacks.end()), stacks.end());
    const auto stacksOf = [&](std::int32_t operand) {
      std::vector<std::int32_t> result;
      for (const auto& entry : stacks)
      {
        if (entry.first == operand)
        {
          result.push_back(entry.second);
        }
      }
      return result;
    };
    const std::vector<std::int32_t> ofFirst = stacksOf(stacks.front().first);
    return std::any_of(stacks.begin(), stacks.end(),
      [&](const auto& entry) { return stacksOf(entry.first) != ofFirst; });
  }

  /** The first face at the edge, and the first one of another operand, or failing that another
   * face. */
  Curves::Makers MakersOf(std::size_t first, std::size_t end) const
  {
    const std::int32_t a = this->FaceOf(this->Cuts.EdgeUses[first]);
    const std::int32_t operandA = this->World.OperandOfFace(a);
    std::int32_t b = a;
    for (std::size_t i = first; i < end; ++i)
    {
      const std::int32_t face = this->FaceOf(this->Cuts.EdgeUses[i]);
      if (this->World.OperandOfFace(face) != operandA)
      {
        b = face;
        break;
      }
      b = b == a ? face : b;
    }
    const std::int32_t operandB = this->World.OperandOfFace(b);
    return { { operandA, operandB },
      { a - this->World.FirstFace(operandA), b - this->World.FirstFace(operandB) } };
  }

  const Scene& World;
  const Arrangement& Cuts;
  const CurveKind Kind;
};

class Joiner
{
public:
  Joiner(const Scene& scene, const PointTable& nodes, const std::vector<CurveSegment>& segments)
    : World(scene)
    , Nodes(nodes)
    , Segments(segments)
  {
  }

  Curves Run()
  {
    this->SortEnds();
    this->Taken.assign(this->Segments.size(), 0);
    this->Result.Offsets.push_back(0);
    // Open curves and those between branch points first; what remains are closed loops.
    for (const bool loops : { false, true })
    {
      for (const EndOfSegment& end : this->Ends)
      {
        if (!this->Taken[std::size_t(end.Segment)] && (loops || this->Degree(end.Node) != 2))
        {
          this->Trace(end);
        }
      }
    }
    return std::move(this->Result);
  }

private:
  void SortEnds()
  {
    for (std::size_t i = 0; i < this->Segments.size(); ++i)
    {
      for (const NodeId node : this->Segments[i].Ends)
      {
        this->Ends.push_back({ node, static_cast<std::int32_t>(i) });
      }
    }
    std::sort(this->Ends.begin(), this->Ends.end());
    this->FirstEnd.assign(std::size_t(this->Nodes.Size()) + 1, 0);
    for (const EndOfSegment& end : this->Ends)
    {
      ++this->FirstEnd[std::size_t(end.Node) + 1];
    }
    std::partial_sum(this->FirstEnd.begin(), this->FirstEnd.end(), this->FirstEnd.begin());
  }

  /** The range of Ends at a node. */
  std::pair<std::size_t, std::size_t> EndsAt(NodeId node) const
  {
    return { this->FirstEnd[std::size_t(node)], this->FirstEnd[std::size_t(node) + 1] };
  }

  std::size_t Degree(NodeId node) const
  {
    const auto [begin, end] = this->EndsAt(node);
    return end - begin;
  }

  std::int32_t PointOf(NodeId node)
  {
    if (this->PointOfNode.empty())
    {
      this->PointOfNode.assign(std::size_t(this->Nodes.Size()), -1);
    }
    std::int32_t& point = this->PointOfNode[std::size_t(node)];
    if (point < 0)
    {
      point = static_cast<std::int32_t>(this->Result.Points.size());
      this->Result.Points.push_back(PlaceOfNode(this->World, this->Nodes, node));
    }
    return point;
  }

  void Trace(const EndOfSegment& start)
  {
    NodeId node = start.Node;
    std::int32_t segment = start.Segment;
    this->Result.Connectivity.push_back(this->PointOf(node));
    while (segment >= 0)
    {
      const CurveSegment& here = this->Segments[std::size_t(segment)];
      this->Taken[std::size_t(segment)] = 1;
      this->Result.Segments.push_back(here.Makers);
      node = here.Ends[0] == node ? here.Ends[1] : here.Ends[0];
      this->Result.Connectivity.push_back(this->PointOf(node));
      segment = -1;
      if (this->Degree(node) == 2)
      {
        const auto [begin, end] = this->EndsAt(node);
        for (std::size_t i = begin; i < end; ++i)
        {
          if (!this->Taken[std::size_t(this->Ends[i].Segment)])
          {
            segment = this->Ends[i].Segment;
          }
        }
      }
    }
    this->Result.Offsets.push_back(static_cast<std::int32_t>(this->Result.Connectivity.size()));
  }

  const Scene& World;
  const PointTable& Nodes;
  const std::vector<CurveSegment>& Segments;
  std::vector<EndOfSegment> Ends; ///< sorted
  std::vector<std::size_t> FirstEnd; ///< [node]
  std::vector<std::uint8_t> Taken;
  std::vector<std::int32_t> PointOfNode;
  Curves Result;
};

} // namespace

std::vector<CurveSegment> FindCurveSegments(
  const Scene& scene, const Arrangement& cuts, CurveKind kind)
{
  return SegmentFinder(scene, cuts, kind).Run();
}

Curves JoinSegments(
  const Scene& scene, const PointTable& nodes, const std::vector<CurveSegment>& segments)
{
  return Joiner(scene, nodes, segments).Run();
}

} // namespace sb
