// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClipPoints.h
 * @brief The points that lie on clipping planes: each has a name that says what makes it, and a
 * node that says where it is.
 *
 * A *name* is an input vertex, an edge and a plane, a face and two planes, or three planes. Faces
 * that share an edge ask for its points by the same name, so nothing is handed from face to face.
 * Different names may mean one place (a plane through a vertex, four planes in a point, vertices
 * that coincide): they are different *instances* of one *node*. Equal is what is equal exactly.
 */
#ifndef sb_ClipPoints_h
#define sb_ClipPoints_h

#include "Boolean.h"
#include "ExactPoint.h"
#include "HalfSpace.h"
#include "Lattice.h"

#include <array>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace sb
{

class ClipPoints
{
public:
  static constexpr std::int32_t None = -1;

  /** The mesh and the planes have to outlive this. */
  ClipPoints(const Surface& mesh, const Lattice& lattice, const std::vector<HalfSpace>& planes);

  ///@{
  /** The instance of a name, made when first asked for. */
  std::int32_t AtVertex(std::int32_t vertex);
  std::int32_t OnEdge(std::int32_t from, std::int32_t to, std::int32_t plane);
  std::int32_t InFace(std::int32_t face, std::int32_t plane, std::int32_t other);
  std::int32_t AtCorner(std::int32_t plane, std::int32_t other, std::int32_t third);
  ///@}

  /** A point without a name of its own: where two contours of one plane cross. */
  std::int32_t Add(const ExactPoint& point);

  std::int32_t Node(std::int32_t instance) const { return this->Nodes[std::size_t(instance)]; }
  const ExactPoint& Point(std::int32_t node) const { return this->Points[std::size_t(node)]; }
  std::int32_t NumberOfNodes() const { return static_cast<std::int32_t>(this->Points.size()); }
  std::int32_t NumberOfInstances() const { return static_cast<std::int32_t>(this->Nodes.size()); }
  /** The first instance of a node. */
  std::int32_t Instance(std::int32_t node) const { return this->Firsts[std::size_t(node)]; }

  /** Lattice coordinates of a vertex. */
  std::array<double, 3> Position(std::int32_t vertex) const
  {
    std::array<double, 3> q;
    this->Grid.Quantise(this->Mesh.Points + 3 * std::int64_t(vertex), q.data());
    return q;
  }
  std::array<std::int32_t, 3> Corners(std::int32_t face) const
  {
    const std::int32_t* ids = this->Mesh.Triangles + 3 * std::int64_t(face);
    return { ids[0], ids[1], ids[2] };
  }
  ExactPlane PlaneOfFace(std::int32_t face) const;
  const HalfSpace& Plane(std::int32_t plane) const { return this->Planes[std::size_t(plane)]; }
  std::int32_t NumberOfPlanes() const { return static_cast<std::int32_t>(this->Planes.size()); }

  /** Whether an instance is named by an edge, and then that edge, the lower vertex first. */
  bool IsOnEdge(std::int32_t instance, std::array<std::int32_t, 2>& edge) const;

  /** The point as the caller gets it: a vertex with its own bytes, a new point rounded once. */
  InterpolatedPoint Output(std::int32_t instance) const;

private:
  using Name = std::array<std::int32_t, 4>;
  struct HashOfName
  {
    std::size_t operator()(const Name& name) const;
  };

  template <class Make>
  std::int32_t Find(const Name& name, Make&& make);
  std::int32_t AddInstance(const Name& name, const ExactPoint& point);
  std::int32_t FindNode(const ExactPoint& point);

  const Surface& Mesh;
  const Lattice& Grid;
  const std::vector<HalfSpace>& Planes;
  std::unordered_map<Name, std::int32_t, HashOfName> Known;
  std::unordered_multimap<std::uint64_t, std::int32_t> NodesByPlace;
  std::deque<ExactPoint> Points; ///< by node; addresses stay
  std::vector<std::int32_t> Firsts; ///< by node
  std::vector<std::int32_t> Nodes; ///< by instance
  std::vector<Name> Names; ///< by instance
};

} // namespace sb

#endif
