// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ContactCurves.h"

#include "ParallelSort.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace sb
{

namespace
{

/** A contact as its face sees it, with its ends as near as doubles can say. */
struct Line
{
  std::array<NodeId, 2> Nodes; ///< ascending
  std::array<const double*, 2> Ends;
  double Low; ///< along the axis of the sweep
  double High;

  bool IsPoint() const { return this->Nodes[0] == this->Nodes[1]; }
};

/** Whether the contacts of one face meet in common ends only. */
class FaceChecker
{
public:
  FaceChecker(const Scene& scene, const ContactSet& contacts, const std::vector<NodeId>& nodes,
    const PointTable& table)
    : World(scene)
    , Contacts(contacts)
    , Nodes(nodes)
    , Table(table)
  {
  }

  bool MeetInEndsOnly(std::size_t first, std::size_t end)
  {
    constexpr std::size_t many = 1000; // such a face is cut as quickly
    if (end - first > many)
    {
      return false;
    }
    this->Collect(first, end);
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      for (std::size_t k = i + 1;
           k < this->Lines.size() && this->Lines[k].Low <= this->Lines[i].High; ++k)
      {
        if (!this->MeetInEndsOnly(this->Lines[i], this->Lines[k]))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  void Collect(std::size_t first, std::size_t end)
  {
    const std::array<std::int32_t, 3> corners =
      this->World.Corners(this->Contacts.Contacts[first].Face);
    const DominantNormal normal = ComputeDominantNormal(this->World.Position(corners[0]),
      this->World.Position(corners[1]), this->World.Position(corners[2]));
    this->U = std::size_t(normal.Axis + 1) % 3;
    this->V = std::size_t(normal.Axis + 2) % 3;
    this->Lines.clear();
    for (std::size_t i = first; i < end; ++i)
    {
      const Contact& contact = this->Contacts.Contacts[i];
      const auto [low, high] = std::minmax(
        this->Nodes[std::size_t(contact.Points[0])], this->Nodes[std::size_t(contact.Points[1])]);
      Line line;
      line.Nodes = { low, high };
      line.Ends = { this->Table.Point(low).Approximation(),
        this->Table.Point(high).Approximation() };
      line.Low = std::min(line.Ends[0][this->U], line.Ends[1][this->U]);
      line.High = std::max(line.Ends[0][this->U], line.Ends[1][this->U]);
      this->Lines.push_back(line);
    }
    std::sort(this->Lines.begin(), this->Lines.end(), [](const Line& l, const Line& r) {
      return l.Low != r.Low ? l.Low < r.Low : l.Nodes < r.Nodes;
    });
  }

  bool MeetInEndsOnly(const Line& a, const Line& b) const
  {
    if (a.Nodes == b.Nodes || this->AreApartAlongV(a, b))
    {
      return true;
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      for (std::size_t k = 0; k < 2; ++k)
      {
        if (a.Nodes[i] == b.Nodes[k])
        {
          return a.IsPoint() || b.IsPoint() ||
            this->LeaveApart(a.Ends[i], a.Ends[1 - i], b.Ends[1 - k]);
        }
      }
    }
    return this->IsOnOneSide(a, b) || this->IsOnOneSide(b, a);
  }

  /** Whether two segments that start at one point have no other one in common: they go different
   * ways along an axis, or their lines are two. */
  bool LeaveApart(const double* start, const double* a, const double* b) const
  {
    const auto goOppositely = [&](std::size_t axis) {
      return (a[axis] < start[axis] && start[axis] < b[axis]) ||
        (b[axis] < start[axis] && start[axis] < a[axis]);
    };
    return goOppositely(this->U) || goOppositely(this->V) || this->Turn(start, a, b) != 0;
  }

  /** Rounding keeps the order of coordinates, so boxes that are apart stay apart. */
  bool AreApartAlongV(const Line& a, const Line& b) const
  {
    const auto [lowA, highA] = std::minmax(a.Ends[0][this->V], a.Ends[1][this->V]);
    const auto [lowB, highB] = std::minmax(b.Ends[0][this->V], b.Ends[1][this->V]);
    return highA < lowB || highB < lowA;
  }

  bool IsOnOneSide(const Line& of, const Line& line) const
  {
    const int first = this->Turn(of.Ends[0], of.Ends[1], line.Ends[0]);
    return first != 0 && first == this->Turn(of.Ends[0], of.Ends[1], line.Ends[1]);
  }

  /**
   * The orientation of the exact points, or 0 where the rounded ones cannot tell. A coordinate is
   * below 2^52 and so off by 1/4 at most, a difference of two of them by 1, and the difference of
   * their products by the sum of the four differences and 2.
   */
  int Turn(const double* a, const double* b, const double* c) const
  {
    const double bu = b[this->U] - a[this->U];
    const double bv = b[this->V] - a[this->V];
    const double cu = c[this->U] - a[this->U];
    const double cv = c[this->V] - a[this->V];
    const double left = bu * cv;
    const double right = bv * cu;
    const double sum = std::abs(bu) + std::abs(bv) + std::abs(cu) + std::abs(cv);
    const double products = std::abs(left) + std::abs(right);
    const double bound = 1.01 * (sum + 2.0 + 4.0e-16 * products); // the last term: their rounding
    const double turn = left - right;
    return turn > bound ? 1 : turn < -bound ? -1 : 0;
  }

  const Scene& World;
  const ContactSet& Contacts;
  const std::vector<NodeId>& Nodes;
  const PointTable& Table;
  std::size_t U = 0; ///< the axes that the face is looked at along
  std::size_t V = 1;
  std::vector<Line> Lines;
};

/** Where the contacts of each face begin. */
std::vector<std::size_t> ListFaces(const ContactSet& contacts)
{
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < contacts.Contacts.size(); ++i)
  {
    if (i == 0 || contacts.Contacts[i].Face != contacts.Contacts[i - 1].Face)
    {
      begins.push_back(i);
    }
  }
  begins.push_back(contacts.Contacts.size());
  return begins;
}

bool AllMeetInEndsOnly(const Scene& scene, const ContactSet& contacts,
  const std::vector<NodeId>& nodes, const PointTable& table, Executor& executor)
{
  const std::vector<std::size_t> begins = ListFaces(contacts);
  std::atomic<bool> all{ true };
  executor.For(
    static_cast<std::int64_t>(begins.size()) - 1, 512, [&](std::int64_t begin, std::int64_t end) {
      FaceChecker checker(scene, contacts, nodes, table);
      for (std::int64_t i = begin; i < end && all.load(std::memory_order_relaxed); ++i)
      {
        if (!checker.MeetInEndsOnly(begins[std::size_t(i)], begins[std::size_t(i) + 1]))
        {
          all = false;
        }
      }
    });
  return all;
}

/** A segment as one pair of faces makes it. */
struct PairSegment
{
  std::array<NodeId, 2> Ends;
  std::array<std::int32_t, 2> Faces; ///< ascending, and so their operands
};

} // namespace

std::optional<std::vector<CurveSegment>> FindSegmentsOfContacts(
  const Scene& scene, const ContactSet& contacts, PointTable& nodes, Executor& executor)
{
  if (std::any_of(contacts.Contacts.begin(), contacts.Contacts.end(),
        [](const Contact& contact) { return contact.OtherEdge != -1; }))
  {
    return std::nullopt; // areas that coincide
  }
  const std::vector<NodeId> nodeOf = nodes.Insert(contacts.Points, executor);
  if (!AllMeetInEndsOnly(scene, contacts, nodeOf, nodes, executor))
  {
    return std::nullopt;
  }
  std::vector<PairSegment> pairs;
  for (const Contact& contact : contacts.Contacts)
  {
    const auto [low, high] =
      std::minmax(nodeOf[std::size_t(contact.Points[0])], nodeOf[std::size_t(contact.Points[1])]);
    if (low != high && contact.Face < contact.Other)
    {
      pairs.push_back({ { low, high }, { contact.Face, contact.Other } });
    }
  }
  ParallelSort(
    pairs,
    [](const PairSegment& l, const PairSegment& r) {
      return l.Ends != r.Ends ? l.Ends < r.Ends : l.Faces < r.Faces;
    },
    executor);
  std::vector<CurveSegment> segments;
  for (const PairSegment& pair : pairs)
  {
    if (segments.empty() || segments.back().Ends != pair.Ends)
    {
      const std::array<std::int32_t, 2> operands{ scene.OperandOfFace(pair.Faces[0]),
        scene.OperandOfFace(pair.Faces[1]) };
      segments.push_back({ pair.Ends,
        { operands,
          { pair.Faces[0] - scene.FirstFace(operands[0]),
            pair.Faces[1] - scene.FirstFace(operands[1]) } } });
    }
  }
  return segments;
}

} // namespace sb
