// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceRemainder.h"

#include "Predicates.h"

namespace sb
{

void FaceRemainder::Insert(const std::vector<Point>& points, std::vector<int>& vertices)
{
  for (const Point& point : points)
  {
    const int vertex = this->Mesh.Insert(point.Place);
    this->Ids.resize(std::size_t(this->Mesh.NumberOfVertices()), point.Id);
    vertices.push_back(vertex);
  }
}

void FaceRemainder::Cut(const std::array<Point, 3>& corners, const std::vector<Point>& onEdges,
  const std::vector<Point>& part, std::vector<std::array<std::int32_t, 3>>& triangles)
{
  if (onEdges.empty() && part.empty())
  {
    triangles.push_back({ corners[0].Id, corners[1].Id, corners[2].Id });
    return;
  }
  const DominantNormal normal = ComputeDominantNormal(corners[0].Place->Approximation(),
    corners[1].Place->Approximation(), corners[2].Place->Approximation());
  if (normal.Sign == 0)
  {
    return; // without area: nothing of it is left
  }
  this->Mesh.Reset(
    { corners[0].Place, corners[1].Place, corners[2].Place }, normal.Axis, normal.Sign);
  this->Ids = { corners[0].Id, corners[1].Id, corners[2].Id };
  std::vector<int> vertices;
  this->Insert(onEdges, vertices);
  vertices.clear();
  this->Insert(part, vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const int next = vertices[i + 1 == vertices.size() ? 0 : i + 1];
    this->Mesh.Constrain(vertices[i], next, 0, *this);
  }
  const std::vector<std::uint8_t> isPart = this->FindPart(vertices);
  for (std::size_t cell = 0; cell < this->Mesh.Cells().size(); ++cell)
  {
    if (!isPart[cell])
    {
      const std::array<int, 3>& c = this->Mesh.Cells()[cell].Vertices;
      triangles.push_back({ this->Ids[std::size_t(c[0])], this->Ids[std::size_t(c[1])],
        this->Ids[std::size_t(c[2])] });
    }
  }
}

/** The cells to the left of the outline, and all that hang together with them. */
std::vector<std::uint8_t> FaceRemainder::FindPart(const std::vector<int>& outline) const
{
  const std::vector<FaceTriangulation::Cell>& cells = this->Mesh.Cells();
  std::vector<std::uint8_t> isPart(cells.size(), 0);
  std::vector<std::size_t> stack;
  for (std::size_t cell = 0; cell < cells.size() && stack.empty() && !outline.empty(); ++cell)
  {
    // The part is convex: a cell with all its corners on the outline, or between two of its points,
    // is told by an edge that runs as the outline does.
    for (std::size_t k = 0; k < 3 && stack.empty(); ++k)
    {
      const int from = cells[cell].Vertices[(k + 1) % 3];
      const int to = cells[cell].Vertices[(k + 2) % 3];
      if (cells[cell].Constraints[k] == FaceTriangulation::None)
      {
        continue;
      }
      for (std::size_t i = 0; i < outline.size(); ++i)
      {
        const int next = outline[i + 1 == outline.size() ? 0 : i + 1];
        const bool startsHere = from == outline[i];
        if (startsHere && (to == next || this->Mesh.Orientation(from, next, to) == 0))
        {
          // Along the outline and not against it: the part's other corners lie to the left.
          const int other = outline[(i + 2) % outline.size()];
          if (this->Mesh.Orientation(from, to, other) > 0)
          {
            stack.push_back(cell);
            isPart[cell] = 1;
            break;
          }
        }
      }
    }
  }
  while (!stack.empty())
  {
    const std::size_t here = stack.back();
    stack.pop_back();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int across = cells[here].Neighbours[k];
      if (across != FaceTriangulation::None && !isPart[std::size_t(across)] &&
        cells[here].Constraints[k] == FaceTriangulation::None)
      {
        isPart[std::size_t(across)] = 1;
        stack.push_back(std::size_t(across));
      }
    }
  }
  return isPart;
}

} // namespace sb
