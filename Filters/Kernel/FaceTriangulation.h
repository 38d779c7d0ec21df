// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceTriangulation.h
 * @brief A constrained triangulation of one face: all its contacts become edges of it.
 *
 * Points are inserted one by one and edges flipped towards Delaunay (Lawson 1977); constraints are
 * then enforced by flipping what crosses them (Sloan, "A fast algorithm for generating constrained
 * Delaunay triangulations", Computers & Structures 47(3), 1993). Every decision that the topology
 * rests on is an exact orientation of exact points, so the result is a valid triangulation whatever
 * the input. Only the shape of the triangles depends on floating point: the in-circle test is
 * evaluated on rounded points, and a flip is made only where the exact quadrilateral is convex.
 */
#ifndef sb_FaceTriangulation_h
#define sb_FaceTriangulation_h

#include "ExactPoint.h"

#include <array>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace sb
{

/** What the triangulation asks of whoever knows where its constraints come from. */
class ConstraintSource
{
public:
  virtual ~ConstraintSource() = default;
  /** The point where two constraints cross. */
  virtual ExactPoint Crossing(int constraint, int other) = 0;
  /** The constraint runs through a vertex which is neither of its ends. */
  virtual void PassesThrough(int constraint, int vertex) = 0;
};

class FaceTriangulation
{
public:
  static constexpr int None = -1;

  /** Corners counter-clockwise as seen from where the face's normal points. */
  struct Cell
  {
    std::array<int, 3> Vertices;
    std::array<int, 3>
      Neighbours; ///< across the edge opposite to each vertex; None outside the face
    std::array<int, 3> Constraints; ///< on that edge; None if free
  };

  /**
   * Start from a face's three corners (vertices 0, 1, 2). The points have to outlive the
   * triangulation.
   * @param axis,sign the dominant axis of the face's normal, and the sign of that component (not 0)
   */
  void Reset(const std::array<const ExactPoint*, 3>& corners, int axis, int sign);

  /** Insert a point of the closed face; @return its vertex (an existing one if the point coincides
   * with it). */
  int Insert(const ExactPoint* point);

  /** Insert a point inside the edge from corner `edge` to the next; quicker, as it need not be
   * searched for. */
  int InsertOnEdge(const ExactPoint* point, int edge);

  /** Make the segment between two vertices a chain of edges, each marked with the constraint. */
  void Constrain(int from, int to, int constraint, ConstraintSource& source);

  const std::vector<Cell>& Cells() const { return this->Triangles; }
  int NumberOfVertices() const { return static_cast<int>(this->Points.size()); }
  const ExactPoint& Point(int vertex) const { return *this->Points[std::size_t(vertex)]; }

  /** Exact orientation of three vertices, positive counter-clockwise. */
  int Orientation(int a, int b, int c) const
  {
    return this->Orientation(this->Point(a), this->Point(b), this->Point(c));
  }

private:
  struct Place
  {
    int Cell;
    int Edge; ///< the edge (by its opposite vertex) that the point lies on, or None
    int Vertex; ///< the vertex that the point coincides with, or None
  };

  int Orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) const
  {
    return this->Sign * Orient2D(a, b, c, this->Axis);
  }

  Place Locate(const ExactPoint& point);
  Place LocateOnEdge(const ExactPoint& point, int edge) const;
  int InsertAt(const Place& place, const ExactPoint* point);
  void SplitCell(int cell, int vertex);
  void SplitEdge(int cell, int edge, int vertex);
  int AddVertex(const ExactPoint* point);
  int AddCell();
  void SetCell(int cell, const std::array<int, 3>& vertices, const std::array<int, 3>& neighbours,
    const std::array<int, 3>& constraints);
  void Relink(int cell, int oldNeighbour, int newNeighbour);
  int IndexOf(int cell, int vertex) const;
  void Flip(int cell, int edge);
  bool IsConvex(int cell, int edge) const;
  bool ShouldFlip(int cell, int edge) const;
  void RestoreDelaunayAround(int vertex);
  void RestoreDelaunay(std::vector<std::pair<int, int>>& edges);
  std::pair<int, int> FindEdge(int a, int b) const;
  /** Connect `from` towards `to` up to the first vertex on the way, which is returned. */
  int Advance(int from, int to, int constraint, ConstraintSource& source);
  void Mark(int cell, int edge, int constraint);
  void RemoveCrossings(
    int from, int to, int constraint, const std::vector<std::pair<int, int>>& crossed);
  template <class Visitor>
  void VisitCellsAround(int vertex, Visitor&& visitor) const;

  int Axis = 2;
  int Sign = 1;
  std::vector<const ExactPoint*> Points;
  std::deque<ExactPoint> OwnPoints;
  std::vector<int> CellOfVertex;
  std::vector<Cell> Triangles;
  int LastCell = 0;
  unsigned Turn = 0;
  std::vector<int> Stack;
};

} // namespace sb

#endif
