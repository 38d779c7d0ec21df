// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellClip.h"

#include "Predicates.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace sb
{

namespace
{

/** Corners are the same where their instances are, or else their vertices. */
std::int64_t KeyOf(const FaceClip::Corner& corner)
{
  return corner.Instance >= 0 ? std::int64_t(corner.Instance) : -1 - std::int64_t(corner.Vertex);
}

/** For each point the one thing that arrives there and the one that leaves, or that there are more.
 */
class Joints
{
public:
  static constexpr std::int64_t none = -1;
  static constexpr std::int64_t several = -2;

  struct Joint
  {
    std::int64_t Arriving = none;
    std::int64_t Leaving = none;
  };

  void Add(std::int64_t from, std::int64_t to, std::int64_t index)
  {
    std::int64_t& leaving = this->ByKey[from].Leaving;
    leaving = leaving == none ? index : several;
    std::int64_t& arriving = this->ByKey[to].Arriving;
    arriving = arriving == none ? index : several;
  }

  const Joint& At(std::int64_t key) { return this->ByKey[key]; }

  /** After `removed`, which left this point, was joined to `index`. */
  void Rename(std::int64_t key, std::int64_t index) { this->ByKey[key].Arriving = index; }

private:
  std::unordered_map<std::int64_t, Joint> ByKey;
};

} // namespace

bool CellClip::IsFlat(std::int32_t first, std::int32_t last) const
{
  const auto corner = [&](std::int32_t face, std::size_t k) {
    return this->Points.Position(this->Points.Corners(face)[k]);
  };
  const std::array<double, 3> a = corner(first, 0);
  const std::array<double, 3> b = corner(first, 1);
  const std::array<double, 3> c = corner(first, 2);
  const DominantNormal normal = ComputeDominantNormal(a.data(), b.data(), c.data());
  bool isFlat = normal.Sign != 0;
  for (std::int32_t face = first + 1; face < last && isFlat; ++face)
  {
    const std::array<double, 3> p = corner(face, 0);
    const std::array<double, 3> q = corner(face, 1);
    const std::array<double, 3> r = corner(face, 2);
    isFlat = Orient2D(p.data(), q.data(), r.data(), normal.Axis) == normal.Sign &&
      Orient3D(a.data(), b.data(), c.data(), p.data()) == 0 &&
      Orient3D(a.data(), b.data(), c.data(), q.data()) == 0 &&
      Orient3D(a.data(), b.data(), c.data(), r.data()) == 0;
  }
  return isFlat;
}

const std::vector<CellSide>& CellClip::Run(const std::vector<std::int32_t>& faces,
  std::int32_t first, std::int32_t last, std::vector<Contour>& contours)
{
  this->FindDiagonals(first, last);
  this->Segments.assign(contours.size(), Contour());
  this->Sides.clear();
  for (const std::int32_t face : faces)
  {
    const std::vector<FaceClip::Corner>& polygon = this->Clip.Clip(face, this->Segments);
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      this->Sides.push_back({ polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1] });
    }
  }
  this->CancelSides();
  this->JoinSides();
  for (std::size_t plane = 0; plane < contours.size(); ++plane)
  {
    this->JoinSegments(this->Segments[plane]);
    contours[plane].insert(
      contours[plane].end(), this->Segments[plane].begin(), this->Segments[plane].end());
  }
  return this->Sides;
}

/** The edges that two of the triangles share. */
void CellClip::FindDiagonals(std::int32_t first, std::int32_t last)
{
  std::vector<Edge> edges;
  for (std::int32_t face = first; face < last; ++face)
  {
    const std::array<std::int32_t, 3> corners = this->Points.Corners(face);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto ends = std::minmax({ corners[k], corners[(k + 1) % 3] });
      edges.push_back({ ends.first, ends.second });
    }
  }
  std::sort(edges.begin(), edges.end());
  this->Diagonals.clear();
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    if (edges[i] == edges[i + 1])
    {
      this->Diagonals.push_back(edges[i]);
    }
  }
}

bool CellClip::IsOnDiagonal(std::int32_t instance) const
{
  Edge edge;
  return instance >= 0 && this->Points.IsOnEdge(instance, edge) &&
    std::binary_search(this->Diagonals.begin(), this->Diagonals.end(), edge);
}

/** Take sides out against the opposite ones of neighbouring triangles. */
void CellClip::CancelSides()
{
  using Name = std::array<std::int64_t, 3>; // the ends, the lower first; the place in Sides
  std::vector<Name> names;
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    const auto ends = std::minmax({ KeyOf(this->Sides[i].From), KeyOf(this->Sides[i].To) });
    names.push_back({ ends.first, ends.second, static_cast<std::int64_t>(i) });
  }
  std::sort(names.begin(), names.end());
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const bool isPair = i + 1 < names.size() && names[i][0] == names[i + 1][0] &&
      names[i][1] == names[i + 1][1] &&
      KeyOf(this->Sides[std::size_t(names[i][2])].From) ==
        KeyOf(this->Sides[std::size_t(names[i + 1][2])].To);
    if (isPair)
    {
      ++i;
    }
    else
    {
      left.push_back(static_cast<std::size_t>(names[i][2]));
    }
  }
  std::sort(left.begin(), left.end());
  std::vector<CellSide> kept;
  for (const std::size_t i : left)
  {
    kept.push_back(this->Sides[i]);
  }
  this->Sides.swap(kept);
}

/** Whether two sides run along the plane that made the point on a diagonal between them. */
bool CellClip::IsStraight(const CellSide& side, const CellSide& next) const
{
  if (side.From.Instance < 0 || next.To.Instance < 0)
  {
    return false;
  }
  const HalfSpace& plane = this->Points.Plane(this->Points.PlaneOnEdge(side.To.Instance));
  return plane.Side(this->Points.Point(this->Points.Node(side.From.Instance))) == 0 &&
    plane.Side(this->Points.Point(this->Points.Node(next.To.Instance))) == 0;
}

void CellClip::JoinSides()
{
  Joints joints;
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    joints.Add(KeyOf(this->Sides[i].From), KeyOf(this->Sides[i].To), static_cast<std::int64_t>(i));
  }
  std::vector<std::uint8_t> removed(this->Sides.size(), 0);
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    const FaceClip::Corner corner = this->Sides[i].From;
    const Joints::Joint joint = joints.At(KeyOf(corner));
    if (joint.Arriving < 0 || joint.Leaving != static_cast<std::int64_t>(i) ||
      joint.Arriving == joint.Leaving || !this->IsOnDiagonal(corner.Instance))
    {
      continue;
    }
    CellSide& before = this->Sides[std::size_t(joint.Arriving)];
    if (this->IsStraight(before, this->Sides[i]))
    {
      before.To = this->Sides[i].To;
      removed[i] = 1;
      if (joints.At(KeyOf(before.To)).Arriving == static_cast<std::int64_t>(i))
      {
        joints.Rename(KeyOf(before.To), joint.Arriving);
      }
    }
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    if (!removed[i])
    {
      this->Sides[next++] = this->Sides[i];
    }
  }
  this->Sides.resize(next);
}

void CellClip::JoinSegments(Contour& contour) const
{
  Joints joints;
  for (std::size_t i = 0; i < contour.size(); ++i)
  {
    joints.Add(contour[i].From, contour[i].To, static_cast<std::int64_t>(i));
  }
  std::vector<std::uint8_t> removed(contour.size(), 0);
  for (std::size_t i = 0; i < contour.size(); ++i)
  {
    const Joints::Joint joint = joints.At(contour[i].From);
    if (joint.Arriving < 0 || joint.Leaving != static_cast<std::int64_t>(i) ||
      joint.Arriving == joint.Leaving || !this->IsOnDiagonal(contour[i].From))
    {
      continue;
    }
    Segment& before = contour[std::size_t(joint.Arriving)];
    const Carrier& line = contour[i].Line;
    const bool isStraight = before.Line.Of == line.Of &&
      (line.Of == Carrier::Kind::Face ||
        (line.Of == Carrier::Kind::Plane && before.Line.A == line.A));
    if (isStraight)
    {
      before.To = contour[i].To;
      removed[i] = 1;
      if (joints.At(before.To).Arriving == static_cast<std::int64_t>(i))
      {
        joints.Rename(before.To, joint.Arriving);
      }
    }
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < contour.size(); ++i)
  {
    if (!removed[i])
    {
      contour[next++] = contour[i];
    }
  }
  contour.resize(next);
}

} // namespace sb
