// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceClip.h"

#include "Predicates.h"

#include <algorithm>

namespace sb
{

int FaceClip::SideOf(const Corner& corner, std::int32_t plane) const
{
  const HalfSpace& space = this->Points.Plane(plane);
  return corner.Vertex >= 0 ? space.Side(this->Points.Position(corner.Vertex).data())
                            : space.Side(this->Points.Point(this->Points.Node(corner.Instance)));
}

bool FaceClip::LooksBackwards(std::int32_t plane) const
{
  const std::array<std::int32_t, 3> corners = this->Points.Corners(this->Face);
  const DominantNormal normal = ComputeDominantNormal(this->Points.Position(corners[0]).data(),
    this->Points.Position(corners[1]).data(), this->Points.Position(corners[2]).data());
  // It lies in the plane, so the two normals are parallel.
  return normal.Sign * this->Points.Plane(plane).Direction()[normal.Axis] < 0.0;
}

std::int32_t FaceClip::InstanceOf(Corner& corner)
{
  if (corner.Instance < 0)
  {
    corner.Instance = this->Points.AtVertex(corner.Vertex);
  }
  return corner.Instance;
}

Carrier FaceClip::CarrierOf(std::int32_t label) const
{
  if (label >= 3)
  {
    return { Carrier::Kind::Plane, label - 3, -1 };
  }
  const std::array<std::int32_t, 3> corners = this->Points.Corners(this->Face);
  return { Carrier::Kind::Edge, corners[std::size_t(label)],
    corners[std::size_t((label + 1) % 3)] };
}

FaceClip::Corner FaceClip::Crossing(std::size_t side, std::int32_t plane)
{
  const Carrier line = this->CarrierOf(this->Labels[side]);
  return { -1,
    line.Of == Carrier::Kind::Plane ? this->Points.InFace(this->Face, line.A, plane)
                                    : this->Points.OnEdge(line.A, line.B, plane) };
}

const std::vector<FaceClip::Corner>& FaceClip::Clip(
  std::int32_t face, std::vector<Contour>& contours)
{
  this->Face = face;
  this->Polygon.clear();
  for (const std::int32_t vertex : this->Points.Corners(face))
  {
    this->Polygon.push_back({ vertex, -1 });
  }
  this->Labels = { 0, 1, 2 };
  for (std::int32_t plane = 0; plane < this->Points.NumberOfPlanes(); ++plane)
  {
    if (!this->ClipBy(plane, contours))
    {
      this->Polygon.clear();
      break;
    }
  }
  return this->Polygon;
}

bool FaceClip::ClipBy(std::int32_t plane, std::vector<Contour>& contours)
{
  this->Sides.clear();
  bool anyInFront = false;
  bool anyOther = false;
  bool anyBehind = false;
  for (Corner& corner : this->Polygon)
  {
    const int side = this->SideOf(corner, plane);
    this->Sides.push_back(side);
    anyInFront |= side > 0;
    anyOther |= side <= 0;
    anyBehind |= side < 0;
    if (side == 0)
    {
      this->InstanceOf(corner);
    }
  }
  if (anyInFront)
  {
    if (anyOther)
    {
      this->Cut(plane, contours[std::size_t(plane)]);
    }
    return true;
  }
  if (anyBehind || !this->KeepsFacesInPlane || !this->LooksBackwards(plane))
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Polygon.size(); ++i)
  {
    const std::size_t next = i + 1 == this->Polygon.size() ? 0 : i + 1;
    contours[std::size_t(plane)].push_back({ this->Polygon[next].Instance,
      this->Polygon[i].Instance, this->CarrierOf(this->Labels[i]) });
  }
  return true;
}

void FaceClip::Cut(std::int32_t plane, Contour& contour)
{
  const std::size_t size = this->Polygon.size();
  // Start behind the last corner that is not in front and followed by one that is.
  std::size_t start = 0;
  while (!(this->Sides[start] <= 0 && this->Sides[(start + 1) % size] > 0))
  {
    ++start;
  }
  this->NextPolygon.clear();
  this->NextLabels.clear();
  const bool startsOn = this->Sides[start] == 0;
  this->NextPolygon.push_back(startsOn ? this->Polygon[start] : this->Crossing(start, plane));
  this->NextLabels.push_back(this->Labels[start]);
  std::size_t i = (start + 1) % size;
  for (; this->Sides[i] > 0; i = (i + 1) % size)
  {
    this->NextPolygon.push_back(this->Polygon[i]);
    this->NextLabels.push_back(this->Labels[i]);
  }
  if (i == start && startsOn)
  {
    return; // a corner touches the plane
  }
  const std::size_t last = (i + size - 1) % size;
  const bool endsOn = this->Sides[i] == 0;
  Corner end = endsOn ? this->Polygon[i] : this->Crossing(last, plane);
  // An edge that lies in the plane keeps its own line; any other is where the triangle meets the
  // plane. So is a side in an earlier plane, which may be the same one and have no line with it.
  const bool isOldSide = endsOn && startsOn && (i + 1) % size == start;
  const Carrier line = isOldSide && this->Labels[i] < 3
    ? this->CarrierOf(this->Labels[i])
    : Carrier{ Carrier::Kind::Face, this->Face, -1 };
  this->NextPolygon.push_back(end);
  this->NextLabels.push_back(isOldSide ? this->Labels[i] : 3 + plane);
  contour.push_back({ this->NextPolygon.front().Instance, end.Instance, line });
  this->Polygon.swap(this->NextPolygon);
  this->Labels.swap(this->NextLabels);
}

} // namespace sb
