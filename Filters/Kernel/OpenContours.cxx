// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenContours.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

namespace sb
{

namespace
{

class ContourCloser
{
public:
  ContourCloser(const ClipPoints& points, std::int32_t plane, Contour& contour)
    : Points(points)
    , Normal(points.Plane(plane).Dominant())
    , Segments(contour)
  {
  }

  OpenContourCount Close()
  {
    OpenContourCount count;
    this->CountEnds();
    if (std::all_of(this->Surplus.begin(), this->Surplus.end(),
          [](const auto& entry) { return entry.second == 0; }))
    {
      return count;
    }
    this->TracePaths();
    this->MakeHull();
    this->ChooseJoins();
    this->Rebuild(count);
    return count;
  }

private:
  static constexpr std::size_t none = ~std::size_t(0);

  /** Segments that follow each other from a loose start to a loose end. */
  struct Path
  {
    std::vector<std::size_t> Members;
    std::size_t Next = none; ///< the path that its end is joined to
    bool IsReached = false; ///< another path is joined to its start
  };
  /** Where on the hull a node lies: the edge that it starts or lies inside of. */
  struct Place
  {
    std::int32_t Node;
    std::size_t Edge; ///< from that hull corner to the next; none for a node inside the hull
  };

  std::int32_t From(std::size_t segment) const
  {
    return this->Points.Node(this->Segments[segment].From);
  }
  std::int32_t To(std::size_t segment) const
  {
    return this->Points.Node(this->Segments[segment].To);
  }

  /** The turn of three nodes as seen from outside of the cap, against the plane's normal. */
  int Turn(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    return -this->Normal.Sign *
      Orient2D(
        this->Points.Point(a), this->Points.Point(b), this->Points.Point(c), this->Normal.Axis);
  }

  void CountEnds()
  {
    for (std::size_t i = 0; i < this->Segments.size(); ++i)
    {
      ++this->Surplus[this->From(i)];
      --this->Surplus[this->To(i)];
    }
  }

  void TracePaths()
  {
    std::unordered_multimap<std::int32_t, std::size_t> leaving;
    for (std::size_t i = this->Segments.size(); i-- > 0;)
    {
      leaving.emplace(this->From(i), i);
    }
    this->IsLoose.assign(this->Segments.size(), 0);
    for (std::size_t i = 0; i < this->Segments.size(); ++i)
    {
      while (this->Surplus[this->From(i)] > 0)
      {
        --this->Surplus[this->From(i)];
        this->TracePath(this->From(i), leaving);
      }
    }
  }

  void TracePath(std::int32_t node, std::unordered_multimap<std::int32_t, std::size_t>& leaving)
  {
    this->Paths.emplace_back();
    for (auto next = leaving.find(node); next != leaving.end(); next = leaving.find(node))
    {
      const std::size_t segment = next->second;
      leaving.erase(next);
      this->Paths.back().Members.push_back(segment);
      this->IsLoose[segment] = 1;
      node = this->To(segment);
      if (this->Surplus[node] < 0)
      {
        ++this->Surplus[node];
        return;
      }
    }
  }

  /** The corners of the convex hull, counter-clockwise (A. M. Andrew's chains, 1979). */
  void MakeHull()
  {
    std::vector<std::int32_t> nodes;
    for (const auto& entry : this->Surplus)
    {
      nodes.push_back(entry.first);
    }
    const int u = (this->Normal.Axis + 1) % 3;
    const int v = (this->Normal.Axis + 2) % 3;
    std::sort(nodes.begin(), nodes.end(), [&](std::int32_t l, std::int32_t r) {
      const ExactPoint& pl = this->Points.Point(l);
      const ExactPoint& pr = this->Points.Point(r);
      const int order = l == r ? 0 : CompareAlong(pl, pr, u);
      return order != 0 ? order > 0 : l != r && CompareAlong(pl, pr, v) > 0;
    });
    for (int chain = 0; chain < 2; ++chain)
    {
      const std::size_t start = this->Hull.size();
      for (const std::int32_t node : nodes)
      {
        while (this->Hull.size() >= start + 2 &&
          this->Turn(this->Hull[this->Hull.size() - 2], this->Hull.back(), node) <= 0)
        {
          this->Hull.pop_back();
        }
        this->Hull.push_back(node);
      }
      this->Hull.pop_back();
      std::reverse(nodes.begin(), nodes.end());
    }
  }

  Place Find(std::int32_t node) const
  {
    for (std::size_t i = 0; i < this->Hull.size(); ++i)
    {
      const std::int32_t from = this->Hull[i];
      const std::int32_t to = this->Hull[(i + 1) % this->Hull.size()];
      if (node == from || (node != to && this->Turn(from, to, node) == 0))
      {
        return { node, i };
      }
    }
    return { node, none };
  }

  double Distance(std::int32_t a, std::int32_t b) const
  {
    const double* p = this->Points.Point(a).Approximation();
    const double* q = this->Points.Point(b).Approximation();
    return std::hypot(std::hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
  }

  /** Whether a segment between two nodes runs along the hull, counter-clockwise. */
  bool RunsAlongHull(const Place& end, const Place& start) const
  {
    if (end.Edge == none || start.Edge == none || end.Node == start.Node)
    {
      return false;
    }
    const std::int32_t from = this->Hull[end.Edge];
    const std::int32_t to = this->Hull[(end.Edge + 1) % this->Hull.size()];
    return start.Node == to ||
      (start.Edge == end.Edge && this->Distance(from, end.Node) < this->Distance(from, start.Node));
  }

  void ChooseJoins()
  {
    std::vector<Place> starts;
    std::vector<Place> ends;
    for (const Path& path : this->Paths)
    {
      starts.push_back(this->Find(this->From(path.Members.front())));
      ends.push_back(this->Find(this->To(path.Members.back())));
    }
    std::vector<std::tuple<double, std::size_t, std::size_t>> candidates;
    for (std::size_t i = 0; i < this->Paths.size(); ++i)
    {
      for (std::size_t k = 0; k < this->Paths.size(); ++k)
      {
        if (this->RunsAlongHull(ends[i], starts[k]))
        {
          candidates.emplace_back(this->Distance(ends[i].Node, starts[k].Node), i, k);
        }
      }
    }
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [length, end, start] : candidates)
    {
      if (this->Paths[end].Next == none && !this->Paths[start].IsReached)
      {
        this->Paths[end].Next = start;
        this->Paths[start].IsReached = true;
      }
    }
  }

  bool IsClosed(std::size_t path) const
  {
    std::size_t next = this->Paths[path].Next;
    while (next != none && next != path)
    {
      next = this->Paths[next].Next;
    }
    return next == path;
  }

  void Rebuild(OpenContourCount& count)
  {
    Contour closed;
    for (std::size_t i = 0; i < this->Segments.size(); ++i)
    {
      if (!this->IsLoose[i])
      {
        closed.push_back(this->Segments[i]);
      }
    }
    for (std::size_t i = 0; i < this->Paths.size(); ++i)
    {
      if (!this->IsClosed(i))
      {
        ++count.Removed;
        continue;
      }
      for (const std::size_t member : this->Paths[i].Members)
      {
        closed.push_back(this->Segments[member]);
      }
      ++count.Joined;
      closed.push_back({ this->Segments[this->Paths[i].Members.back()].To,
        this->Segments[this->Paths[this->Paths[i].Next].Members.front()].From, Carrier() });
    }
    this->Segments.swap(closed);
  }

  const ClipPoints& Points;
  const DominantNormal Normal;
  Contour& Segments;
  std::unordered_map<std::int32_t, int> Surplus; ///< by node: segments that leave, less those that
                                                 ///< arrive
  std::vector<Path> Paths;
  std::vector<std::uint8_t> IsLoose; ///< by segment: part of a path
  std::vector<std::int32_t> Hull;
};

} // namespace

OpenContourCount CloseContour(const ClipPoints& points, std::int32_t plane, Contour& contour)
{
  return ContourCloser(points, plane, contour).Close();
}

std::int32_t CrossingOfJoin(
  ClipPoints& points, const Segment& segment, std::int32_t plane, std::int32_t other)
{
  // The ends are rational, so their line has no plane of small numbers; that of their nearest
  // lattice points has, and a join is a guess anyway.
  const int axis = points.Plane(plane).Dominant().Axis;
  double from[3];
  double to[3];
  for (int i = 0; i < 3; ++i)
  {
    from[i] = std::nearbyint(points.Point(points.Node(segment.From)).Approximation()[i]);
    to[i] = std::nearbyint(points.Point(points.Node(segment.To)).Approximation()[i]);
  }
  const ExactPoint crossing = ExactPoint::ThreePlanes(
    ExactPlane::Vertical(from, to, axis), points.Plane(plane).Plane(), points.Plane(other).Plane());
  return crossing.Exists() ? points.Add(crossing) : segment.To;
}

} // namespace sb
