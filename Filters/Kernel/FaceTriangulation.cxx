// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceTriangulation.h"

#include <algorithm>
#include <cmath>

namespace sb
{

namespace
{

constexpr int Next(int i) { return i == 2 ? 0 : i + 1; }
constexpr int Last(int i) { return i == 0 ? 2 : i - 1; }

/**
 * Whether d lies inside the circle through a, b, c (counter-clockwise) by more than rounding can
 * explain. The margin keeps cocircular points from being flipped to and fro.
 */
bool InsideCircle(const double* a, const double* b, const double* c, const double* d, int u, int v)
{
  const double adx = a[u] - d[u];
  const double ady = a[v] - d[v];
  const double bdx = b[u] - d[u];
  const double bdy = b[v] - d[v];
  const double cdx = c[u] - d[u];
  const double cdy = c[v] - d[v];
  const double ad = adx * adx + ady * ady;
  const double bd = bdx * bdx + bdy * bdy;
  const double cd = cdx * cdx + cdy * cdy;
  const double determinant =
    ad * (bdx * cdy - bdy * cdx) + bd * (cdx * ady - cdy * adx) + cd * (adx * bdy - ady * bdx);
  const double magnitude = ad * (std::abs(bdx * cdy) + std::abs(bdy * cdx)) +
    bd * (std::abs(cdx * ady) + std::abs(cdy * adx)) +
    cd * (std::abs(adx * bdy) + std::abs(ady * bdx));
  return determinant > 1e-14 * magnitude;
}

} // namespace

void FaceTriangulation::Reset(const std::array<const ExactPoint*, 3>& corners, int axis, int sign)
{
  this->Axis = axis;
  this->Sign = sign;
  this->Points.assign(corners.begin(), corners.end());
  this->OwnPoints.clear();
  this->CellOfVertex.assign(3, 0);
  this->Triangles.assign(1, { { 0, 1, 2 }, { None, None, None }, { None, None, None } });
  this->LastCell = 0;
  this->Turn = 0;
  this->Lines.Reset(0);
}

int FaceTriangulation::Insert(const ExactPoint* point)
{
  return this->InsertAt(this->Locate(*point), point);
}

int FaceTriangulation::InsertOnEdge(const ExactPoint* point, int edge)
{
  return this->InsertAt(this->LocateOnEdge(*point, edge), point);
}

int FaceTriangulation::InsertAt(const Place& place, const ExactPoint* point)
{
  if (place.Vertex != None)
  {
    return place.Vertex;
  }
  const int vertex = this->AddVertex(point);
  if (place.Edge == None)
  {
    this->SplitCell(place.Cell, vertex);
  }
  else
  {
    this->SplitEdge(place.Cell, place.Edge, vertex);
  }
  this->RestoreDelaunayAround(vertex);
  return vertex;
}

void FaceTriangulation::Constrain(int from, int to, int constraint, ConstraintSource& source)
{
  this->Lines.Extend(constraint + 1);
  while (from != to)
  {
    const Place place = this->FindEdge(from, to);
    if (place.Cell != None)
    {
      this->Mark(place.Cell, place.Edge, constraint);
      return;
    }
    if (place.Vertex == to)
    {
      std::swap(from, to); // fewer cells to look at
    }
    const int before = this->NumberOfVertices();
    const int reached = this->Advance(from, to, constraint, source);
    if (reached != to && reached < before)
    {
      source.PassesThrough(constraint, reached);
    }
    from = reached;
  }
}

FaceTriangulation::Place FaceTriangulation::Locate(const ExactPoint& point)
{
  // A walk that looks at the edges in changing order ends in any triangulation, Delaunay or not
  // (Devillers, Pion and Teillaud, "Walking in a triangulation", 2002).
  int cell = this->LastCell;
  for (;;)
  {
    const Cell& here = this->Triangles[std::size_t(cell)];
    this->Turn = this->Turn * 1103515245u + 12345u;
    const int start = static_cast<int>((this->Turn >> 16) % 3u);
    int onEdge = None;
    int onOther = None;
    bool moved = false;
    for (int k = 0; k < 3 && !moved; ++k)
    {
      const int i = (start + k) % 3;
      const int side = this->Orientation(this->Point(here.Vertices[std::size_t(Next(i))]),
        this->Point(here.Vertices[std::size_t(Last(i))]), point);
      if (side < 0 && here.Neighbours[std::size_t(i)] != None)
      {
        cell = here.Neighbours[std::size_t(i)];
        moved = true;
      }
      else if (side == 0)
      {
        (onEdge == None ? onEdge : onOther) = i;
      }
    }
    if (!moved)
    {
      this->LastCell = cell;
      const int vertex = onOther == None ? None : here.Vertices[std::size_t(3 - onEdge - onOther)];
      return { cell, onEdge, vertex };
    }
  }
}

FaceTriangulation::Place FaceTriangulation::LocateOnEdge(const ExactPoint& point, int edge) const
{
  // Along the coordinate in which the edge is longest, points of it are ordered as on the edge.
  const double* from = this->Point(edge).Approximation();
  const double* to = this->Point(Next(edge)).Approximation();
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(to[i] - from[i]) > std::abs(to[axis] - from[axis]) ? i : axis;
  }
  const int forward = to[axis] > from[axis] ? 1 : -1;
  for (int vertex = edge;;)
  {
    // The boundary edge that leaves the vertex: the one without a neighbour, counter-clockwise.
    Place place{ None, None, None };
    this->VisitCellsAround(vertex, [&](int cell, int i) {
      if (this->Triangles[std::size_t(cell)].Neighbours[std::size_t(Last(i))] == None)
      {
        place = { cell, Last(i), None };
      }
      return place.Cell != None;
    });
    const int next =
      this->Triangles[std::size_t(place.Cell)].Vertices[std::size_t(Last(place.Edge))];
    const int beyond = forward * CompareAlong(point, this->Point(next), axis);
    if (beyond >= 0)
    {
      place.Vertex = beyond == 0 ? next : None;
      return place;
    }
    vertex = next;
  }
}

int FaceTriangulation::AddVertex(const ExactPoint* point)
{
  this->Points.push_back(point);
  this->CellOfVertex.push_back(0);
  return this->NumberOfVertices() - 1;
}

int FaceTriangulation::AddCell()
{
  this->Triangles.emplace_back();
  return static_cast<int>(this->Triangles.size()) - 1;
}

void FaceTriangulation::SetCell(int cell, const std::array<int, 3>& vertices,
  const std::array<int, 3>& neighbours, const std::array<int, 3>& constraints)
{
  this->Triangles[std::size_t(cell)] = { vertices, neighbours, constraints };
  for (int vertex : vertices)
  {
    this->CellOfVertex[std::size_t(vertex)] = cell;
  }
}

void FaceTriangulation::Relink(int cell, int oldNeighbour, int newNeighbour)
{
  if (cell == None)
  {
    return;
  }
  for (int& neighbour : this->Triangles[std::size_t(cell)].Neighbours)
  {
    if (neighbour == oldNeighbour)
    {
      neighbour = newNeighbour;
      return;
    }
  }
}

int FaceTriangulation::Opposite(int cell, int edge) const
{
  const Cell& here = this->Triangles[std::size_t(cell)];
  const int across = here.Neighbours[std::size_t(edge)];
  return 3 - this->IndexOf(across, here.Vertices[std::size_t(Next(edge))]) -
    this->IndexOf(across, here.Vertices[std::size_t(Last(edge))]);
}

int FaceTriangulation::IndexOf(int cell, int vertex) const
{
  const std::array<int, 3>& vertices = this->Triangles[std::size_t(cell)].Vertices;
  return vertices[0] == vertex ? 0 : (vertices[1] == vertex ? 1 : 2);
}

void FaceTriangulation::SplitCell(int cell, int vertex)
{
  const Cell old = this->Triangles[std::size_t(cell)];
  const auto [a, b, c] = old.Vertices;
  const int second = this->AddCell();
  const int third = this->AddCell();
  this->SetCell(cell, { vertex, b, c }, { old.Neighbours[0], second, third },
    { old.Constraints[0], None, None });
  this->SetCell(second, { vertex, c, a }, { old.Neighbours[1], third, cell },
    { old.Constraints[1], None, None });
  this->SetCell(third, { vertex, a, b }, { old.Neighbours[2], cell, second },
    { old.Constraints[2], None, None });
  this->Relink(old.Neighbours[1], cell, second);
  this->Relink(old.Neighbours[2], cell, third);
}

void FaceTriangulation::SplitEdge(int cell, int edge, int vertex)
{
  const Cell here = this->Triangles[std::size_t(cell)];
  const auto at = [](const std::array<int, 3>& values, int i) { return values[std::size_t(i)]; };
  const int apex = at(here.Vertices, edge);
  const int a = at(here.Vertices, Next(edge));
  const int b = at(here.Vertices, Last(edge));
  const int constraint = at(here.Constraints, edge);
  const int across = at(here.Neighbours, edge);

  const int second = this->AddCell();
  const int fourth = across == None ? None : this->AddCell();
  // On this side: (apex, a, vertex) and (apex, vertex, b).
  this->SetCell(cell, { apex, a, vertex },
    { across == None ? None : fourth, second, at(here.Neighbours, Last(edge)) },
    { constraint, None, at(here.Constraints, Last(edge)) });
  this->SetCell(second, { apex, vertex, b }, { across, at(here.Neighbours, Next(edge)), cell },
    { constraint, at(here.Constraints, Next(edge)), None });
  this->Relink(at(here.Neighbours, Next(edge)), cell, second);
  if (across == None)
  {
    return;
  }
  // On the other side, where the edge runs from b to a: (far, b, vertex) and (far, vertex, a).
  const Cell there = this->Triangles[std::size_t(across)];
  const int opposite = 3 - this->IndexOf(across, a) - this->IndexOf(across, b);
  const int far = at(there.Vertices, opposite);
  this->SetCell(across, { far, b, vertex },
    { second, fourth, at(there.Neighbours, Last(opposite)) },
    { constraint, None, at(there.Constraints, Last(opposite)) });
  this->SetCell(fourth, { far, vertex, a }, { cell, at(there.Neighbours, Next(opposite)), across },
    { constraint, at(there.Constraints, Next(opposite)), None });
  this->Relink(at(there.Neighbours, Next(opposite)), across, fourth);
}

void FaceTriangulation::Flip(int cell, int edge)
{
  const Cell here = this->Triangles[std::size_t(cell)];
  const int across = here.Neighbours[std::size_t(edge)];
  const Cell there = this->Triangles[std::size_t(across)];
  const int p = here.Vertices[std::size_t(edge)];
  const int a = here.Vertices[std::size_t(Next(edge))];
  const int b = here.Vertices[std::size_t(Last(edge))];
  const int opposite = 3 - this->IndexOf(across, a) - this->IndexOf(across, b);
  const int q = there.Vertices[std::size_t(opposite)];
  // here holds edges (b,p) and (p,a), there holds (a,q) and (q,b).
  const int nearB = here.Neighbours[std::size_t(Next(edge))];
  const int nearA = here.Neighbours[std::size_t(Last(edge))];
  const int farA = there.Neighbours[std::size_t(Next(opposite))];
  const int farB = there.Neighbours[std::size_t(Last(opposite))];
  this->SetCell(cell, { p, a, q }, { farA, across, nearA },
    { there.Constraints[std::size_t(Next(opposite))], None,
      here.Constraints[std::size_t(Last(edge))] });
  this->SetCell(across, { p, q, b }, { farB, nearB, cell },
    { there.Constraints[std::size_t(Last(opposite))], here.Constraints[std::size_t(Next(edge))],
      None });
  this->Relink(farA, across, cell);
  this->Relink(nearB, cell, across);
}

bool FaceTriangulation::IsConvex(int cell, int edge) const
{
  const Cell& here = this->Triangles[std::size_t(cell)];
  const int across = here.Neighbours[std::size_t(edge)];
  const int p = here.Vertices[std::size_t(edge)];
  const int a = here.Vertices[std::size_t(Next(edge))];
  const int b = here.Vertices[std::size_t(Last(edge))];
  const int opposite = 3 - this->IndexOf(across, a) - this->IndexOf(across, b);
  const int q = this->Triangles[std::size_t(across)].Vertices[std::size_t(opposite)];
  return this->Orientation(p, a, q) > 0 && this->Orientation(p, q, b) > 0;
}

bool FaceTriangulation::ShouldFlip(int cell, int edge) const
{
  const Cell& here = this->Triangles[std::size_t(cell)];
  const int across = here.Neighbours[std::size_t(edge)];
  if (across == None || here.Constraints[std::size_t(edge)] != None)
  {
    return false;
  }
  const int a = here.Vertices[std::size_t(Next(edge))];
  const int b = here.Vertices[std::size_t(Last(edge))];
  const int opposite = 3 - this->IndexOf(across, a) - this->IndexOf(across, b);
  const int q = this->Triangles[std::size_t(across)].Vertices[std::size_t(opposite)];
  int u = (this->Axis + 1) % 3;
  int v = (this->Axis + 2) % 3;
  if (this->Sign < 0)
  {
    std::swap(u, v);
  }
  return InsideCircle(this->Point(here.Vertices[0]).Approximation(),
           this->Point(here.Vertices[1]).Approximation(),
           this->Point(here.Vertices[2]).Approximation(), this->Point(q).Approximation(), u, v) &&
    this->IsConvex(cell, edge);
}

void FaceTriangulation::RestoreDelaunayAround(int vertex)
{
  std::vector<int>& stack = this->Stack;
  stack.clear();
  this->VisitCellsAround(vertex, [&](int cell, int) {
    stack.push_back(cell);
    return false;
  });
  // Rounded points can disagree with the exact ones; the bound ends any cycle that this could
  // cause.
  for (int budget = 64 + 8 * static_cast<int>(stack.size()); !stack.empty() && budget > 0; --budget)
  {
    const int cell = stack.back();
    stack.pop_back();
    const int edge = this->IndexOf(cell, vertex);
    if (this->Triangles[std::size_t(cell)].Vertices[std::size_t(edge)] == vertex &&
      this->ShouldFlip(cell, edge))
    {
      const int across = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)];
      this->Flip(cell, edge);
      stack.push_back(cell);
      stack.push_back(across);
    }
  }
}

void FaceTriangulation::RestoreDelaunay(const std::vector<int>& cells)
{
  std::vector<int>& stack = this->Stack;
  stack.assign(cells.rbegin(), cells.rend());
  for (int budget = 64 + 8 * static_cast<int>(stack.size()); !stack.empty() && budget > 0; --budget)
  {
    const int cell = stack.back();
    stack.pop_back();
    for (int edge = 0; edge < 3; ++edge)
    {
      if (this->ShouldFlip(cell, edge))
      {
        const int across = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)];
        this->Flip(cell, edge);
        stack.push_back(across);
        stack.push_back(cell);
        break;
      }
    }
  }
}

FaceTriangulation::Circle FaceTriangulation::CircleAround(int vertex) const
{
  const int first = this->CellOfVertex[std::size_t(vertex)];
  return { vertex, first, this->IndexOf(first, vertex), first, false };
}

bool FaceTriangulation::GoOn(Circle& circle) const
{
  const auto neighbour = [this](int cell, int edge) {
    return this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)];
  };
  int cell = None;
  if (!circle.IsBackward)
  {
    cell = neighbour(circle.Cell, Next(circle.Index));
    if (cell == circle.First)
    {
      return false;
    }
    if (cell == None)
    {
      // The vertex is on the face's boundary: go round the other way for the rest.
      circle.IsBackward = true;
      cell = neighbour(circle.First, Last(this->IndexOf(circle.First, circle.Vertex)));
    }
  }
  else
  {
    cell = neighbour(circle.Cell, Last(circle.Index));
  }
  circle.Cell = cell;
  circle.Index = cell == None ? None : this->IndexOf(cell, circle.Vertex);
  return cell != None;
}

template <class Visitor>
void FaceTriangulation::VisitCellsAround(int vertex, Visitor&& visitor) const
{
  Circle circle = this->CircleAround(vertex);
  while (!visitor(circle.Cell, circle.Index) && this->GoOn(circle))
  {
  }
}

FaceTriangulation::Place FaceTriangulation::FindEdge(int a, int b) const
{
  // Round both ends at a time: of many edges that end at one vertex, each is found from its other
  // end.
  std::array<Circle, 2> circles{ this->CircleAround(a), this->CircleAround(b) };
  for (std::size_t turn = 0;; turn = 1 - turn)
  {
    Circle& circle = circles[turn];
    const std::array<int, 3>& vertices = this->Triangles[std::size_t(circle.Cell)].Vertices;
    const int wanted = circles[1 - turn].Vertex;
    for (const int side : { Next(circle.Index), Last(circle.Index) })
    {
      if (vertices[std::size_t(side)] == wanted)
      {
        return { circle.Cell, 3 - circle.Index - side, None };
      }
    }
    if (!this->GoOn(circle))
    {
      return { None, None, circle.Vertex };
    }
  }
}

void FaceTriangulation::Mark(int cell, int edge, int constraint)
{
  Cell& here = this->Triangles[std::size_t(cell)];
  const int known = here.Constraints[std::size_t(edge)];
  if (known != None)
  {
    this->Lines.Unite(known, constraint);
    return;
  }
  here.Constraints[std::size_t(edge)] = constraint;
  const int across = here.Neighbours[std::size_t(edge)];
  if (across != None)
  {
    this->Triangles[std::size_t(across)].Constraints[std::size_t(this->Opposite(cell, edge))] =
      constraint;
  }
}

bool FaceTriangulation::ConstrainEdge(int from, int to, int constraint)
{
  this->Lines.Extend(constraint + 1);
  const Place place = this->FindEdge(from, to);
  if (place.Cell == None)
  {
    return false;
  }
  this->Mark(place.Cell, place.Edge, constraint);
  return true;
}

int FaceTriangulation::FollowLine(int from, int to, int constraint) const
{
  int reached = None;
  this->VisitCellsAround(from, [&](int cell, int i) {
    const Cell& here = this->Triangles[std::size_t(cell)];
    for (const int side : { Next(i), Last(i) })
    {
      // The edge opposite to `side` runs to the third vertex.
      const int other = here.Constraints[std::size_t(side)];
      const int vertex = here.Vertices[std::size_t(3 - i - side)];
      if (other != None && this->Lines.Root(other) == this->Lines.Root(constraint) &&
        this->IsAhead(from, to, vertex))
      {
        reached = vertex;
      }
    }
    return reached != None;
  });
  return reached;
}

bool FaceTriangulation::IsAhead(int from, int to, int vertex) const
{
  const int u = (this->Axis + 1) % 3;
  const int v = (this->Axis + 2) % 3;
  const int along = CompareAlong(this->Point(from), this->Point(to), u);
  return along != 0 ? CompareAlong(this->Point(from), this->Point(vertex), u) == along
                    : CompareAlong(this->Point(from), this->Point(vertex), v) ==
      CompareAlong(this->Point(from), this->Point(to), v);
}

FaceTriangulation::Place FaceTriangulation::Leave(int from, int to) const
{
  Place place{ None, None, None };
  // What has been found out about the cell before: it shares a vertex with this one.
  std::array<int, 2> vertices{ None, None };
  std::array<int, 2> sides{ 0, 0 };
  const auto sideOf = [&](int vertex) {
    return vertex == vertices[0] ? sides[0]
      : vertex == vertices[1]    ? sides[1]
                                 : this->Orientation(from, to, vertex);
  };
  this->VisitCellsAround(from, [&](int cell, int i) {
    const Cell& here = this->Triangles[std::size_t(cell)];
    const int right = here.Vertices[std::size_t(Next(i))];
    const int left = here.Vertices[std::size_t(Last(i))];
    const int sideOfRight = sideOf(right);
    const int sideOfLeft = sideOf(left);
    vertices = { right, left };
    sides = { sideOfRight, sideOfLeft };
    if (sideOfRight == 0 && sideOfLeft > 0)
    {
      place = { cell, Last(i), right };
    }
    else if (sideOfLeft == 0 && sideOfRight < 0)
    {
      place = { cell, Next(i), left };
    }
    else if (sideOfRight < 0 && sideOfLeft > 0)
    {
      place = { cell, i, None };
    }
    return place.Cell != None;
  });
  return place;
}

int FaceTriangulation::Advance(int from, int to, int constraint, ConstraintSource& source)
{
  const int known = this->FollowLine(from, to, constraint);
  if (known != None)
  {
    return known;
  }
  const Place start = this->Leave(from, to);
  if (start.Vertex != None)
  {
    this->Mark(start.Cell, start.Edge, constraint);
    return start.Vertex;
  }
  if (this->Triangles[std::size_t(start.Cell)].Constraints[std::size_t(start.Edge)] != None)
  {
    const int reached = this->Cross(start.Cell, start.Edge, constraint, source);
    this->ConstrainEdge(from, reached, constraint);
    return reached;
  }
  const int reached = this->OpenCavity(start, from, to, constraint, source);
  this->CloseCavity(from, constraint);
  return reached;
}

int FaceTriangulation::Cross(int cell, int edge, int constraint, ConstraintSource& source)
{
  const int other = this->Triangles[std::size_t(cell)].Constraints[std::size_t(edge)];
  this->OwnPoints.push_back(source.Crossing(constraint, other));
  const int vertex = this->AddVertex(&this->OwnPoints.back());
  this->SplitEdge(cell, edge, vertex);
  return vertex;
}

int FaceTriangulation::OpenCavity(
  const Place& start, int from, int to, int constraint, ConstraintSource& source)
{
  int cell = start.Cell;
  int edge = start.Edge;
  int right = this->Triangles[std::size_t(cell)].Vertices[std::size_t(Next(edge))];
  int left = this->Triangles[std::size_t(cell)].Vertices[std::size_t(Last(edge))];
  this->Cavity.assign(1, cell);
  this->LeftRim.clear();
  this->RightRim.clear();
  this->LeftRim.push_back({ left, cell, Next(edge), None, None });
  this->RightRim.push_back({ right, cell, Last(edge), None, None });
  for (;;)
  {
    int across = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)];
    int far =
      this->Triangles[std::size_t(across)].Vertices[std::size_t(this->Opposite(cell, edge))];
    int side = far == to ? 0 : this->Orientation(from, to, far);
    int way = None;
    if (side != 0)
    {
      way = this->IndexOf(across, side > 0 ? left : right);
      if (this->Triangles[std::size_t(across)].Constraints[std::size_t(way)] != None)
      {
        far = this->Cross(across, way, constraint, source);
        side = 0;
        across = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)];
      }
    }
    this->Cavity.push_back(across);
    if (side >= 0)
    {
      this->LeftRim.push_back({ far, across, this->IndexOf(across, right), None, None });
    }
    if (side <= 0)
    {
      this->RightRim.push_back({ far, across, this->IndexOf(across, left), None, None });
    }
    if (side == 0)
    {
      return far;
    }
    (side > 0 ? left : right) = far;
    cell = across;
    edge = way;
  }
}

void FaceTriangulation::CloseCavity(int from, int constraint)
{
  this->LookOut();
  std::size_t next = 0;
  const RimEdge left = this->FillCavity(this->LeftRim, from, true, next);
  const RimEdge right = this->FillCavity(this->RightRim, from, false, next);
  this->Connect(left.Cell, left.Edge, right.Cell, right.Edge);
  this->Triangles[std::size_t(left.Cell)].Constraints[std::size_t(left.Edge)] = constraint;
  this->Triangles[std::size_t(right.Cell)].Constraints[std::size_t(right.Edge)] = constraint;
  this->JoinSlits();
  this->RestoreDelaunay(this->Cavity);
}

void FaceTriangulation::LookOut()
{
  this->IsInCavity.resize(this->Triangles.size(), 0);
  for (const int cell : this->Cavity)
  {
    this->IsInCavity[std::size_t(cell)] = 1;
  }
  this->Slits.clear();
  for (std::vector<RimEdge>* rim : { &this->LeftRim, &this->RightRim })
  {
    for (RimEdge& edge : *rim)
    {
      const int cell = edge.Cell;
      const int own = edge.Edge;
      edge.Constraint = this->Triangles[std::size_t(cell)].Constraints[std::size_t(own)];
      edge.Cell = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(own)];
      edge.Edge = edge.Cell == None ? None : this->Opposite(cell, own);
      if (edge.Cell != None && this->IsInCavity[std::size_t(edge.Cell)])
      {
        const int here = 3 * cell + own;
        const int there = 3 * edge.Cell + edge.Edge;
        edge.Slit = static_cast<int>(this->Slits.size());
        this->Slits.push_back({ std::min(here, there), std::max(here, there), None, None });
      }
    }
  }
  for (const int cell : this->Cavity)
  {
    this->IsInCavity[std::size_t(cell)] = 0;
  }
}

FaceTriangulation::RimEdge FaceTriangulation::FillCavity(
  const std::vector<RimEdge>& rim, int from, bool isLeft, std::size_t& next)
{
  // What lies between the segment and the rim can be seen from the segment. Of such a polygon every
  // convex corner can be cut off, in the order of the rim (Toussaint and Avis, "On a convex hull
  // algorithm for polygons and its application to triangulation problems", Pattern Recognition
  // 15(1), 1982).
  std::vector<RimEdge>& chain = this->Chain;
  chain.assign(1, { from, None, None, None, None });
  for (RimEdge edge : rim)
  {
    while (chain.size() > 1)
    {
      const int a = chain[chain.size() - 2].End;
      const int b = chain.back().End;
      if (a == edge.End || this->Orientation(a, b, edge.End) != (isLeft ? -1 : 1))
      {
        break;
      }
      const int cell = this->Cavity[next++];
      const int free = isLeft ? 2 : 1;
      this->SetCell(cell,
        isLeft ? std::array<int, 3>{ a, edge.End, b } : std::array<int, 3>{ a, b, edge.End },
        { None, None, None }, { None, None, None });
      this->Attach(cell, 0, edge);
      this->Attach(cell, 3 - free, chain.back());
      chain.pop_back();
      edge = { edge.End, cell, free, None, None };
    }
    chain.push_back(edge);
  }
  return chain[1];
}

void FaceTriangulation::Attach(int cell, int edge, const RimEdge& rim)
{
  this->Triangles[std::size_t(cell)].Constraints[std::size_t(edge)] = rim.Constraint;
  if (rim.Slit != None)
  {
    this->Slits[std::size_t(rim.Slit)].Cell = cell;
    this->Slits[std::size_t(rim.Slit)].Edge = edge;
  }
  else if (rim.Cell != None)
  {
    this->Connect(cell, edge, rim.Cell, rim.Edge);
  }
}

void FaceTriangulation::Connect(int cell, int edge, int otherCell, int otherEdge)
{
  this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)] = otherCell;
  this->Triangles[std::size_t(otherCell)].Neighbours[std::size_t(otherEdge)] = cell;
}

void FaceTriangulation::JoinSlits()
{
  std::sort(this->Slits.begin(), this->Slits.end(),
    [](const Slit& l, const Slit& r) { return l.Low != r.Low ? l.Low < r.Low : l.High < r.High; });
  for (std::size_t i = 0; i + 1 < this->Slits.size(); i += 2)
  {
    this->Connect(
      this->Slits[i].Cell, this->Slits[i].Edge, this->Slits[i + 1].Cell, this->Slits[i + 1].Edge);
  }
}

} // namespace sb
