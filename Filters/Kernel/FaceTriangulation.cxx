// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceTriangulation.h"

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
  while (from != to)
  {
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

void FaceTriangulation::RestoreDelaunay(std::vector<std::pair<int, int>>& edges)
{
  bool changed = true;
  for (int round = 0; changed && round < 8; ++round)
  {
    changed = false;
    for (std::pair<int, int>& ends : edges)
    {
      const auto [cell, edge] = this->FindEdge(ends.first, ends.second);
      if (cell != None && this->ShouldFlip(cell, edge))
      {
        const int across = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)];
        this->Flip(cell, edge);
        // The flipped pair shares the edge between the first corners of both cells.
        ends = { this->Triangles[std::size_t(across)].Vertices[0],
          this->Triangles[std::size_t(across)].Vertices[1] };
        changed = true;
      }
    }
  }
}

template <class Visitor>
void FaceTriangulation::VisitCellsAround(int vertex, Visitor&& visitor) const
{
  const int first = this->CellOfVertex[std::size_t(vertex)];
  int cell = first;
  do
  {
    const int i = this->IndexOf(cell, vertex);
    if (visitor(cell, i))
    {
      return;
    }
    cell = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(Next(i))];
  } while (cell != None && cell != first);
  if (cell == first)
  {
    return;
  }
  // The vertex is on the face's boundary: go round the other way for the rest.
  cell =
    this->Triangles[std::size_t(first)].Neighbours[std::size_t(Last(this->IndexOf(first, vertex)))];
  while (cell != None)
  {
    const int i = this->IndexOf(cell, vertex);
    if (visitor(cell, i))
    {
      return;
    }
    cell = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(Last(i))];
  }
}

std::pair<int, int> FaceTriangulation::FindEdge(int a, int b) const
{
  std::pair<int, int> found{ None, None };
  this->VisitCellsAround(a, [&](int cell, int i) {
    const std::array<int, 3>& vertices = this->Triangles[std::size_t(cell)].Vertices;
    if (vertices[std::size_t(Next(i))] == b)
    {
      found = { cell, Last(i) };
    }
    else if (vertices[std::size_t(Last(i))] == b)
    {
      found = { cell, Next(i) };
    }
    return found.first != None;
  });
  return found;
}

void FaceTriangulation::Mark(int cell, int edge, int constraint)
{
  Cell& here = this->Triangles[std::size_t(cell)];
  if (here.Constraints[std::size_t(edge)] != None)
  {
    return;
  }
  here.Constraints[std::size_t(edge)] = constraint;
  const int across = here.Neighbours[std::size_t(edge)];
  if (across != None)
  {
    const int a = here.Vertices[std::size_t(Next(edge))];
    const int b = here.Vertices[std::size_t(Last(edge))];
    const int opposite = 3 - this->IndexOf(across, a) - this->IndexOf(across, b);
    this->Triangles[std::size_t(across)].Constraints[std::size_t(opposite)] = constraint;
  }
}

int FaceTriangulation::Advance(int from, int to, int constraint, ConstraintSource& source)
{
  // Leave `from`: along an edge, or through the cell whose far edge the segment crosses.
  int reached = None;
  int cell = None;
  int edge = None;
  this->VisitCellsAround(from, [&](int candidate, int i) {
    const std::array<int, 3>& vertices = this->Triangles[std::size_t(candidate)].Vertices;
    const int right = vertices[std::size_t(Next(i))];
    const int left = vertices[std::size_t(Last(i))];
    const int sideOfRight = right == to ? 0 : this->Orientation(from, to, right);
    const int sideOfLeft = left == to ? 0 : this->Orientation(from, to, left);
    if (sideOfRight == 0 && sideOfLeft > 0)
    {
      reached = right;
      this->Mark(candidate, Last(i), constraint);
    }
    else if (sideOfLeft == 0 && sideOfRight < 0)
    {
      reached = left;
      this->Mark(candidate, Next(i), constraint);
    }
    else if (sideOfRight < 0 && sideOfLeft > 0)
    {
      cell = candidate;
      edge = i;
    }
    return reached != None || cell != None;
  });
  if (reached != None)
  {
    return reached;
  }

  std::vector<std::pair<int, int>> crossed;
  for (;;)
  {
    const Cell& here = this->Triangles[std::size_t(cell)];
    const int right = here.Vertices[std::size_t(Next(edge))];
    const int left = here.Vertices[std::size_t(Last(edge))];
    const int other = here.Constraints[std::size_t(edge)];
    if (other != None)
    {
      this->OwnPoints.push_back(source.Crossing(constraint, other));
      reached = this->AddVertex(&this->OwnPoints.back());
      this->SplitEdge(cell, edge, reached);
      break;
    }
    crossed.emplace_back(right, left);
    const int across = here.Neighbours[std::size_t(edge)];
    const int opposite = 3 - this->IndexOf(across, right) - this->IndexOf(across, left);
    const int far = this->Triangles[std::size_t(across)].Vertices[std::size_t(opposite)];
    const int side = far == to ? 0 : this->Orientation(from, to, far);
    if (side == 0)
    {
      reached = far;
      break;
    }
    // Seen from across, the edge runs from left to right: the next edge crossed is (far, left) or
    // (right, far).
    cell = across;
    edge = side < 0 ? this->IndexOf(across, right) : this->IndexOf(across, left);
  }
  this->RemoveCrossings(from, reached, constraint, crossed);
  return reached;
}

void FaceTriangulation::RemoveCrossings(
  int from, int to, int constraint, const std::vector<std::pair<int, int>>& crossed)
{
  std::vector<std::pair<int, int>> created;
  std::deque<std::pair<int, int>> queue(crossed.begin(), crossed.end());
  while (!queue.empty())
  {
    const std::pair<int, int> ends = queue.front();
    queue.pop_front();
    const auto [cell, edge] = this->FindEdge(ends.first, ends.second);
    if (!this->IsConvex(cell, edge))
    {
      queue.push_back(ends);
      continue;
    }
    const int across = this->Triangles[std::size_t(cell)].Neighbours[std::size_t(edge)];
    this->Flip(cell, edge);
    const int p = this->Triangles[std::size_t(across)].Vertices[0];
    const int q = this->Triangles[std::size_t(across)].Vertices[1];
    const bool touchesEnd = p == from || p == to || q == from || q == to;
    if (!touchesEnd && this->Orientation(from, to, p) != this->Orientation(from, to, q))
    {
      queue.emplace_back(p, q);
    }
    else if (!((p == from && q == to) || (p == to && q == from)))
    {
      created.emplace_back(p, q);
    }
  }
  // Mark first, so that the new edge is not flipped away.
  const auto [cell, edge] = this->FindEdge(from, to);
  this->Mark(cell, edge, constraint);
  this->RestoreDelaunay(created);
}

} // namespace sb
