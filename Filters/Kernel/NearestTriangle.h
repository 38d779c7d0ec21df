// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestTriangle.h
 * @brief The triangle nearest to a point, by a tree of oriented boxes.
 *
 * Seen from a distance h, the axis-aligned box of a patch of size s comes closer than the patch
 * itself by about s, so that of a hierarchy of such boxes (BVH.h) some h/s must be opened before
 * one knows that none is nearer. A box along the patch's own normal is only as thick as the patch
 * is curved (Gottschalk, Lin, Manocha, OBBTree, 1996), and a handful are opened however far the
 * query is.
 *
 * Triangles are put into groups of eight by median splits (White and Jain, Similarity Indexing with
 * the SS-tree, 1996, call it VAMSplit), so that the tree is complete and needs no pointers: node i
 * of a level has the boxes of the nodes 8i..8i+7 of the level below, of triangles on the lowest.
 * Boxes are floats, rounded outward; they only choose which triangles are measured. What is
 * measured is in doubles, and of triangles at the same distance the one with the smallest number is
 * given, so the answer depends neither on the tree nor on where the search began.
 */
#ifndef sb_NearestTriangle_h
#define sb_NearestTriangle_h

#include "Boolean.h"
#include "Executor.h"
#include "TriangleDistance.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

class NearestTriangle
{
public:
  static constexpr int Width = 8;

  struct Answer
  {
    std::int32_t Triangle = -1; ///< -1 if none is near enough
    Feature Where = Feature::Face;
    Vector3 Place; ///< from the query to the nearest point, times Scale()
    double SquaredDistance = 0.0; ///< times Scale() squared
  };

  /** The surface has to stay alive and unchanged; all its coordinates and ids have to be valid. */
  void Build(const Surface& surface, Executor& executor);

  bool IsEmpty() const { return this->Order.empty(); }
  const Surface& Mesh() const { return this->Triangles; }

  /** A power of two: lengths in a frame in which the surface's half-size is below one. */
  double Scale() const { return this->FrameScale; }

  /**
   * The nearest triangle not farther than `limit` (in the unit of the points, infinity for none).
   * `guess`, a triangle that is probably near or -1, only makes it faster. Thread-safe.
   */
  Answer Find(const Vector3& query, double limit, std::int32_t guess) const;

  /** Triangles of the lowest nodes, one node after another. */
  const std::vector<std::int32_t>& TriangleOrder() const { return this->Order; }

  /** The corners of a triangle relative to `query`, times Scale(). */
  std::array<Vector3, 3> CornersFrom(const Vector3& query, std::int32_t triangle) const;

  /** The box of all triangles: xmin xmax ymin ymax zmin zmax. */
  std::array<double, 6> Bounds() const
  {
    return { this->LowerBounds[0], this->UpperBounds[0], this->LowerBounds[1], this->UpperBounds[1],
      this->LowerBounds[2], this->UpperBounds[2] };
  }

  /** Whether a point lies outside of the box of all triangles. */
  bool IsOutsideBounds(const Vector3& point) const;

  double BytesATriangle() const;

private:
  static constexpr int MostLevels = 11; // 8^11 > 2^31

  /** Eight oriented boxes, coordinate by coordinate: |Axis[k] . (x - Center)| <= Extent[k]. */
  struct alignas(32) Node
  {
    float Center[3][Width];
    float Axis[3][3][Width]; ///< [k][coordinate]
    float Extent[3][Width]; ///< very negative in a lane without a box
  };

  struct Summary;
  class Builder;

  template <class Real>
  struct Search;

  void ChooseFrame(Executor& executor);
  void SortTriangles(Executor& executor);
  void FillLowestLevel(std::vector<Summary>& summaries, Executor& executor);
  void FillNextLevel(std::vector<Summary>& summaries, Executor& executor);
  void EncloseNode(Builder& box, const Node& node, int level, std::size_t child) const;

  /** Descends from the root with the boxes measured by Boxes::Measure: four or eight at a time, or
   * in doubles. All give the same answers. */
  template <class Boxes>
  void Descend(Search<typename Boxes::Real>& search, Answer& best) const;
  void DescendFast(Search<float>& search, Answer& best) const;
  void DescendByEight(Search<float>& search, Answer& best) const;

  struct PlainBoxes;
  struct FourBoxes;
  struct EightBoxes;
  struct FarBoxes;

  void Measure(const Vector3& query, std::int32_t triangle, Answer& best) const;
  template <class Searching>
  void MeasureWithin(Searching& search, std::int32_t triangle, Answer& best) const;

  Surface Triangles;
  std::array<double, 3> Origin{};
  std::array<double, 3> LowerBounds{};
  std::array<double, 3> UpperBounds{};
  double FrameScale = 1.0;
  std::vector<std::int32_t> Order;
  std::vector<std::vector<Node>> Levels; ///< [0] has the triangles' boxes; the last has one node
};

} // namespace sb

#endif
