// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceTriangulation.h
 * @brief A constrained triangulation of one face: all its contacts become edges of it.
 *
 * Points are inserted one by one and edges flipped towards Delaunay (Lawson 1977). A segment takes
 * out the cells that it crosses; what is left on either side of it can be seen from the segment,
 * and is filled in time proportional to its corners (Toussaint and Avis 1982; that segments in
 * random order cross few cells is in Shewchuk and Brown, "Fast segment insertion and incremental
 * construction of constrained Delaunay triangulations", Computational Geometry 48(8), 2015). Every
 * decision that the topology rests on is an exact orientation of exact points, so the result is a
 * valid triangulation whatever the input. Only the shape of the triangles depends on floating
 * point: the in-circle test is evaluated on rounded points, and a flip is made only where the exact
 * quadrilateral is convex.
 */
#ifndef sb_FaceTriangulation_h
#define sb_FaceTriangulation_h

#include "DisjointSets.h"
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

  /** The same where there is such an edge already, and else nothing; @return whether there is. */
  bool ConstrainEdge(int from, int to, int constraint);

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
  /** The number, in the cell across an edge, of the vertex opposite to it. */
  int Opposite(int cell, int edge) const;
  void Flip(int cell, int edge);
  bool IsConvex(int cell, int edge) const;
  bool ShouldFlip(int cell, int edge) const;
  void RestoreDelaunayAround(int vertex);
  void RestoreDelaunay(const std::vector<int>& cells);
  /** The edge between two vertices; if there is none, the one of them that has fewer cells around
   * it. */
  Place FindEdge(int a, int b) const;
  /** Connect `from` towards `to` up to the first vertex on the way, which is returned. */
  int Advance(int from, int to, int constraint, ConstraintSource& source);
  void Mark(int cell, int edge, int constraint);
  /** The next vertex along an edge that a constraint on the same line has marked, or None. */
  int FollowLine(int from, int to, int constraint) const;
  /** Whether a vertex on the line is on the same side of `from` as `to`. */
  bool IsAhead(int from, int to, int vertex) const;
  /** Where the segment leaves `from`: along the edge to a vertex, or across the edge of a cell. */
  Place Leave(int from, int to) const;
  /** Split a constrained edge where the constraint crosses it. */
  int Cross(int cell, int edge, int constraint, ConstraintSource& source);

  /** @name Cells that a segment crosses are taken out and the two sides filled anew */
  ///@{
  /** An edge of the boundary of what is taken out; it starts where the one before ends. */
  struct RimEdge
  {
    int End;
    int Cell; ///< beyond it, and the number of the edge there
    int Edge;
    int Constraint;
    int Slit; ///< if cells on both sides have been taken out
  };
  struct Slit
  {
    int Low; ///< the same for both sides
    int High;
    int Cell; ///< the new cell on this side
    int Edge;
  };
  int OpenCavity(const Place& start, int from, int to, int constraint, ConstraintSource& source);
  void CloseCavity(int from, int constraint);
  void LookOut();
  RimEdge FillCavity(const std::vector<RimEdge>& rim, int from, bool isLeft, std::size_t& next);
  void Attach(int cell, int edge, const RimEdge& rim);
  void Connect(int cell, int edge, int otherCell, int otherEdge);
  void JoinSlits();
  ///@}

  /** A walk around a vertex from cell to cell. */
  struct Circle
  {
    int Vertex;
    int Cell;
    int Index; ///< of the vertex in the cell
    int First;
    bool IsBackward;
  };
  Circle CircleAround(int vertex) const;
  bool GoOn(Circle& circle) const;
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
  DisjointSets Lines; ///< constraints on one line, as far as that has been noticed
  std::vector<int> Cavity;
  std::vector<std::uint8_t> IsInCavity;
  std::vector<RimEdge> LeftRim;
  std::vector<RimEdge> RightRim;
  std::vector<RimEdge> Chain;
  std::vector<Slit> Slits;
};

} // namespace sb

#endif
