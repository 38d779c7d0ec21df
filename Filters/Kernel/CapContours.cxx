// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CapContours.h"

#include "OpenContours.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

namespace sb
{

namespace
{

/** Where a contour crosses a line: it leaves what is kept (+1) or enters it (-1). */
struct Event
{
  std::int32_t Node;
  std::int32_t Instance;
  int Change;
};

/** The direction of the line in which two planes meet, as far as it orders points: its largest
 * component. Sign 0: they are parallel. */
DominantNormal LineDirection(const HalfSpace& plane, const HalfSpace& other)
{
  DominantNormal direction{ 0, 0 };
  WideInteger<2> largest;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto component = [&](const HalfSpace& space, int i) {
      return WideInteger<1>::FromIntegral(space.Direction()[i]);
    };
    const WideInteger<2> value = Multiply(component(plane, u), component(other, v)) -
      Multiply(component(plane, v), component(other, u));
    if (value.Magnitude() > largest)
    {
      largest = value.Magnitude();
      direction = { axis, value.Sign() };
    }
  }
  return direction;
}

/** Cuts one cap by one plane. */
class CapCutter
{
public:
  CapCutter(ClipPoints& points, std::int32_t cap, std::int32_t plane)
    : Points(points)
    , Cap(cap)
    , Plane(plane)
  {
  }

  /** Cut the cap's contour; the pieces on the common line go to the plane's contour, too. */
  void Cut(Contour& ofCap, Contour& ofPlane)
  {
    Contour kept;
    for (const Segment& segment : ofCap)
    {
      this->CutSegment(segment, kept);
    }
    ofCap.swap(kept);
    this->FillLine(ofCap, ofPlane);
  }

private:
  int SideOf(std::int32_t instance) const
  {
    return this->Points.Plane(this->Plane).Side(this->Points.Point(this->Points.Node(instance)));
  }

  void CutSegment(const Segment& segment, Contour& kept)
  {
    const int from = this->SideOf(segment.From);
    const int to = this->SideOf(segment.To);
    if (from > 0 && to > 0)
    {
      kept.push_back(segment);
    }
    else if (from > 0 || to > 0)
    {
      const std::int32_t end = from > 0 ? segment.To : segment.From;
      const bool isOn = (from > 0 ? to : from) == 0;
      const std::int32_t crossing = isOn ? end : this->Crossing(segment);
      kept.push_back(from > 0 ? Segment{ segment.From, crossing, segment.Line }
                              : Segment{ crossing, segment.To, segment.Line });
      this->Events.push_back({ this->Points.Node(crossing), crossing, from > 0 ? 1 : -1 });
    }
  }

  std::int32_t Crossing(const Segment& segment)
  {
    const Carrier& line = segment.Line;
    switch (line.Of)
    {
      case Carrier::Kind::Face:
        return this->Points.InFace(line.A, this->Cap, this->Plane);
      case Carrier::Kind::Edge:
        return this->Points.OnEdge(line.A, line.B, this->Plane);
      case Carrier::Kind::Plane:
        return this->Points.AtCorner(line.A, this->Cap, this->Plane);
      case Carrier::Kind::Join:
        break;
    }
    return CrossingOfJoin(this->Points, segment, this->Cap, this->Plane);
  }

  void FillLine(Contour& ofCap, Contour& ofPlane)
  {
    const DominantNormal along =
      LineDirection(this->Points.Plane(this->Cap), this->Points.Plane(this->Plane));
    std::sort(this->Events.begin(), this->Events.end(), [&](const Event& l, const Event& r) {
      const int order = l.Node == r.Node ? 0
                                         : along.Sign *
          CompareAlong(this->Points.Point(l.Node), this->Points.Point(r.Node), along.Axis);
      return order != 0 ? order > 0 : l.Instance < r.Instance;
    });
    int depth = 0;
    for (std::size_t i = 0; i + 1 < this->Events.size(); ++i)
    {
      depth += this->Events[i].Change;
      const Event& here = this->Events[i];
      const Event& next = this->Events[i + 1];
      if (here.Node == next.Node)
      {
        continue;
      }
      for (int copy = 0; copy < std::abs(depth); ++copy)
      {
        const std::int32_t from = depth > 0 ? here.Instance : next.Instance;
        const std::int32_t to = depth > 0 ? next.Instance : here.Instance;
        ofCap.push_back({ from, to, { Carrier::Kind::Plane, this->Plane, -1 } });
        ofPlane.push_back({ to, from, { Carrier::Kind::Plane, this->Cap, -1 } });
      }
    }
  }

  ClipPoints& Points;
  std::int32_t Cap;
  std::int32_t Plane;
  std::vector<Event> Events;
};

/** Finds the nodes that lie inside segments on the line of two planes. */
class LineConformer
{
public:
  LineConformer(
    const ClipPoints& points, const std::vector<Contour>& contours, SplitSegments& splits)
    : Points(points)
    , Contours(contours)
    , Splits(splits)
  {
    for (const Contour& contour : contours)
    {
      this->Nodes.emplace_back();
      for (const Segment& segment : contour)
      {
        this->Nodes.back().push_back(points.Node(segment.From));
        this->Nodes.back().push_back(points.Node(segment.To));
      }
      MakeUnique(this->Nodes.back());
    }
  }

  void Conform(std::int32_t plane, std::int32_t other)
  {
    const DominantNormal along =
      LineDirection(this->Points.Plane(plane), this->Points.Plane(other));
    std::vector<std::int32_t> line;
    this->AddNodesOn(other, this->Nodes[std::size_t(plane)], line);
    this->AddNodesOn(plane, this->Nodes[std::size_t(other)], line);
    MakeUnique(line);
    if (along.Sign == 0 || line.size() < 3)
    {
      return;
    }
    std::sort(line.begin(), line.end(), [&](std::int32_t l, std::int32_t r) {
      return l != r && CompareAlong(this->Points.Point(l), this->Points.Point(r), along.Axis) > 0;
    });
    std::unordered_map<std::int32_t, std::size_t> places;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      places[line[i]] = i;
    }
    for (const std::int32_t cap : { plane, other })
    {
      for (const Segment& segment : this->Contours[std::size_t(cap)])
      {
        const auto from = places.find(this->Points.Node(segment.From));
        const auto to = places.find(this->Points.Node(segment.To));
        if (from != places.end() && to != places.end())
        {
          this->Split(line, from->second, to->second);
        }
      }
    }
  }

private:
  static void MakeUnique(std::vector<std::int32_t>& nodes)
  {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }

  void AddNodesOn(std::int32_t plane, const std::vector<std::int32_t>& nodes,
    std::vector<std::int32_t>& line) const
  {
    for (const std::int32_t node : nodes)
    {
      if (this->Points.Plane(plane).Side(this->Points.Point(node)) == 0)
      {
        line.push_back(node);
      }
    }
  }

  void Split(const std::vector<std::int32_t>& line, std::size_t from, std::size_t to)
  {
    const std::size_t low = std::min(from, to);
    const std::size_t high = std::max(from, to);
    if (high - low < 2)
    {
      return;
    }
    std::vector<std::int32_t> between(line.begin() + static_cast<std::ptrdiff_t>(low) + 1,
      line.begin() + static_cast<std::ptrdiff_t>(high));
    if (line[low] > line[high])
    {
      std::reverse(between.begin(), between.end());
    }
    this->Splits[std::minmax(line[low], line[high])] = between;
  }

  const ClipPoints& Points;
  const std::vector<Contour>& Contours;
  SplitSegments& Splits;
  std::vector<std::vector<std::int32_t>> Nodes; ///< by plane
};

/** Replace each segment by its parts. */
void SplitContour(const ClipPoints& points, const SplitSegments& splits, Contour& contour)
{
  Contour parts;
  std::vector<std::int32_t> nodes;
  for (const Segment& segment : contour)
  {
    nodes.clear();
    AppendSplit(splits, points.Node(segment.From), points.Node(segment.To), nodes);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      parts.push_back({ i == 0 ? segment.From : points.Instance(nodes[i]),
        i + 2 == nodes.size() ? segment.To : points.Instance(nodes[i + 1]), segment.Line });
    }
  }
  contour.swap(parts);
}

} // namespace

void AppendSplit(
  const SplitSegments& splits, std::int32_t from, std::int32_t to, std::vector<std::int32_t>& nodes)
{
  const auto found = splits.find(std::minmax(from, to));
  if (found == splits.end())
  {
    nodes.insert(nodes.end(), { from, to });
    return;
  }
  std::vector<std::int32_t> chain = found->second;
  if (from > to)
  {
    std::reverse(chain.begin(), chain.end());
  }
  chain.push_back(to);
  // A part may itself be divided, by what another cap found later.
  for (const std::int32_t next : chain)
  {
    AppendSplit(splits, from, next, nodes);
    if (next != to)
    {
      nodes.pop_back();
    }
    from = next;
  }
}

void CancelSegments(const ClipPoints& points, Contour& contour)
{
  const auto key = [&](const Segment& segment) {
    return std::minmax({ points.Node(segment.From), points.Node(segment.To) });
  };
  std::stable_sort(contour.begin(), contour.end(),
    [&](const Segment& l, const Segment& r) { return key(l) < key(r); });
  Contour left;
  for (std::size_t i = 0; i < contour.size();)
  {
    const auto ends = key(contour[i]);
    std::size_t end = i;
    int net = 0;
    for (; end < contour.size() && key(contour[end]) == ends; ++end)
    {
      net += points.Node(contour[end].From) == ends.first ? 1 : -1;
    }
    for (; i < end && ends.first != ends.second; ++i)
    {
      const int direction = points.Node(contour[i].From) == ends.first ? 1 : -1;
      if (direction * net > 0)
      {
        left.push_back(contour[i]);
        net -= direction;
      }
    }
    i = end;
  }
  contour.swap(left);
}

OpenContourCount CompleteContours(
  ClipPoints& points, std::vector<Contour>& contours, SplitSegments& splits)
{
  OpenContourCount count;
  for (std::int32_t plane = 0; plane < points.NumberOfPlanes(); ++plane)
  {
    Contour& contour = contours[std::size_t(plane)];
    for (std::int32_t cap = 0; cap < plane; ++cap)
    {
      CapCutter(points, cap, plane).Cut(contours[std::size_t(cap)], contour);
    }
    CancelSegments(points, contour);
    const OpenContourCount open = CloseContour(points, plane, contour);
    count.Joined += open.Joined;
    count.Removed += open.Removed;
  }
  if (points.NumberOfPlanes() > 1)
  {
    LineConformer conformer(points, contours, splits);
    for (std::int32_t plane = 1; plane < points.NumberOfPlanes(); ++plane)
    {
      for (std::int32_t other = 0; other < plane; ++other)
      {
        conformer.Conform(plane, other);
      }
    }
    for (Contour& contour : contours)
    {
      SplitContour(points, splits, contour);
      CancelSegments(points, contour);
    }
  }
  return count;
}

} // namespace sb
