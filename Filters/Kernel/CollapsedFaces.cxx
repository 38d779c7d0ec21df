// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CollapsedFaces.h"

#include "DisjointSets.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace sb
{

namespace
{

using Place = std::tuple<double, double, double>;
using Edge = std::pair<Place, Place>; ///< ordered

Place PlaceOf(const Scene& scene, std::int32_t vertex)
{
  const double* p = scene.Position(vertex);
  return { p[0], p[1], p[2] };
}

Edge EdgeOf(const Scene& scene, const std::array<std::int32_t, 3>& corners, std::size_t edge)
{
  const Place a = PlaceOf(scene, corners[edge]);
  const Place b = PlaceOf(scene, corners[(edge + 1) % 3]);
  return a < b ? Edge(a, b) : Edge(b, a);
}

bool IsCollinear(const Scene& scene, const std::array<std::int32_t, 3>& corners)
{
  return ComputeDominantNormal(
           scene.Position(corners[0]), scene.Position(corners[1]), scene.Position(corners[2]))
           .Sign == 0;
}

/** Whether p lies on the segment strictly between its ends. */
bool IsInside(const double* p, const double* a, const double* b)
{
  bool between = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (Orient2D(a, b, p, axis) != 0)
    {
      return false;
    }
    const double low = std::min(a[axis], b[axis]);
    const double high = std::max(a[axis], b[axis]);
    if (p[axis] < low || p[axis] > high)
    {
      return false;
    }
    between = between || (low < p[axis] && p[axis] < high);
  }
  return between;
}

/** Where a vertex lies on a closed face; -1 if it does not. */
Location LocationOn(const Scene& scene, std::int32_t vertex, std::int32_t face)
{
  const std::array<std::int32_t, 3> corners = scene.Corners(face);
  const double* p = scene.Position(vertex);
  const double* const q[3] = { scene.Position(corners[0]), scene.Position(corners[1]),
    scene.Position(corners[2]) };
  if (Orient3D(q[0], q[1], q[2], p) != 0)
  {
    return -1;
  }
  const DominantNormal normal = ComputeDominantNormal(q[0], q[1], q[2]);
  Location zeros[2] = { -1, -1 };
  int numberOfZeros = 0;
  for (int edge = 0; edge < 3; ++edge)
  {
    const int side = Orient2D(q[edge], q[(edge + 1) % 3], p, normal.Axis) * normal.Sign;
    if (side < 0)
    {
      return -1;
    }
    if (side == 0)
    {
      zeros[numberOfZeros++] = static_cast<Location>(edge);
    }
  }
  if (numberOfZeros == 2)
  {
    return static_cast<Location>(
      zeros[0] == 0 && zeros[1] == 2 ? 0 : zeros[1]); // where both edges meet
  }
  return static_cast<Location>(numberOfZeros == 1 ? 3 + zeros[0] : Interior);
}

/** The collapsed faces of one operand, by their edges. */
class CollapsedEdges
{
public:
  CollapsedEdges(
    const Scene& scene, std::int32_t operand, const std::vector<std::uint8_t>& collapsed)
    : World(scene)
  {
    for (std::int32_t face = scene.FirstFace(operand); face < scene.FirstFace(operand + 1); ++face)
    {
      if (collapsed[std::size_t(face)])
      {
        this->Add(face);
      }
    }
  }

  bool IsEmpty() const { return this->Faces.empty(); }

  void Add(std::int32_t face)
  {
    const auto index = static_cast<std::int32_t>(this->Faces.size());
    this->Faces.push_back(face);
    const std::array<std::int32_t, 3> corners = this->World.Corners(face);
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      this->FaceOfEdge.emplace(EdgeOf(this->World, corners, edge), index);
    }
  }

  bool Contains(const Edge& edge) const { return this->FaceOfEdge.count(edge) > 0; }

  /** Group faces that share edges, and list the vertices of each group. */
  void Group()
  {
    DisjointSets sets(static_cast<std::int32_t>(this->Faces.size()));
    for (auto it = this->FaceOfEdge.begin(); it != this->FaceOfEdge.end(); ++it)
    {
      const auto next = std::next(it);
      if (next != this->FaceOfEdge.end() && next->first == it->first)
      {
        sets.Unite(it->second, next->second);
      }
    }
    this->GroupOfFace.resize(this->Faces.size());
    this->Vertices.assign(this->Faces.size(), {});
    for (std::size_t i = 0; i < this->Faces.size(); ++i)
    {
      this->GroupOfFace[i] = sets.Find(static_cast<std::int32_t>(i));
      for (const std::int32_t corner : this->World.Corners(this->Faces[i]))
      {
        this->Vertices[std::size_t(this->GroupOfFace[i])].push_back(corner);
      }
    }
  }

  /** The vertices of the group that an edge belongs to. */
  const std::vector<std::int32_t>& VerticesNear(const Edge& edge) const
  {
    return this
      ->Vertices[std::size_t(this->GroupOfFace[std::size_t(this->FaceOfEdge.find(edge)->second)])];
  }

private:
  const Scene& World;
  std::vector<std::int32_t> Faces;
  std::multimap<Edge, std::int32_t> FaceOfEdge; ///< index into Faces
  std::vector<std::int32_t> GroupOfFace;
  std::vector<std::vector<std::int32_t>> Vertices;
};

/** Collapse what has no area and shares an edge with a collapsed face: its edges could not be split
 * otherwise. */
void Spread(const Scene& scene, std::int32_t operand, CollapsedEdges& edges,
  std::vector<std::uint8_t>& collapsed)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::int32_t face = scene.FirstFace(operand); face < scene.FirstFace(operand + 1); ++face)
    {
      if (collapsed[std::size_t(face)])
      {
        continue;
      }
      const std::array<std::int32_t, 3> corners = scene.Corners(operand, face);
      if (!IsCollinear(scene, corners))
      {
        continue;
      }
      for (std::size_t edge = 0; edge < 3 && !collapsed[std::size_t(face)]; ++edge)
      {
        if (edges.Contains(EdgeOf(scene, corners, edge)))
        {
          collapsed[std::size_t(face)] = 1;
          edges.Add(face);
          changed = true;
        }
      }
    }
  }
}

/** The faces that a face touches, by the first `known` contacts, which are sorted. */
std::vector<std::int32_t> OthersInContact(
  const std::vector<Contact>& contacts, std::size_t known, std::int32_t face)
{
  std::vector<std::int32_t> others;
  const auto end = contacts.begin() + static_cast<std::ptrdiff_t>(known);
  for (auto it = std::lower_bound(contacts.begin(), end, face,
         [](const Contact&contact, std::int32_t value) { return contact.Face < value; });
       it != end && it->Face == face; ++it)
  {
    if (others.empty() || others.back() != it->Other)
    {
      others.push_back(it->Other);
    }
  }
  return others;
}

} // namespace

std::vector<std::uint8_t> FindCollapsedFaces(
  const Scene& scene, const std::vector<TrianglePair>& pairs)
{
  std::vector<std::uint8_t> collapsed;
  std::vector<std::uint8_t> seen(std::size_t(scene.NumberOfFaces()), 0);
  for (const TrianglePair& pair : pairs)
  {
    for (const auto& [operand, triangle] : { std::make_pair(pair.SurfaceA, pair.TriangleA),
           std::make_pair(pair.SurfaceB, pair.TriangleB) })
    {
      const std::int32_t face = scene.FirstFace(operand) + triangle;
      if (!seen[std::size_t(face)])
      {
        seen[std::size_t(face)] = 1;
        if (IsCollinear(scene, scene.Corners(operand, face)))
        {
          collapsed.resize(seen.size(), 0);
          collapsed[std::size_t(face)] = 1;
        }
      }
    }
  }
  if (!collapsed.empty())
  {
    for (std::int32_t operand = 0; operand < scene.NumberOfOperands(); ++operand)
    {
      CollapsedEdges edges(scene, operand, collapsed);
      if (!edges.IsEmpty())
      {
        Spread(scene, operand, edges, collapsed);
      }
    }
  }
  return collapsed;
}

void StitchCollapsedFaces(
  const Scene& scene, const std::vector<std::uint8_t>& collapsed, ContactSet& contacts)
{
  if (collapsed.empty())
  {
    return;
  }
  const std::size_t known = contacts.Contacts.size();
  for (std::int32_t operand = 0; operand < scene.NumberOfOperands(); ++operand)
  {
    CollapsedEdges edges(scene, operand, collapsed);
    if (edges.IsEmpty())
    {
      continue;
    }
    edges.Group();
    for (std::int32_t face = scene.FirstFace(operand); face < scene.FirstFace(operand + 1); ++face)
    {
      if (collapsed[std::size_t(face)])
      {
        continue;
      }
      const std::array<std::int32_t, 3> corners = scene.Corners(operand, face);
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        const Edge key = EdgeOf(scene, corners, edge);
        if (!edges.Contains(key))
        {
          continue;
        }
        for (const std::int32_t vertex : edges.VerticesNear(key))
        {
          if (IsInside(scene.Position(vertex), scene.Position(corners[edge]),
                scene.Position(corners[(edge + 1) % 3])))
          {
            const auto point = static_cast<std::int32_t>(contacts.Points.size());
            contacts.Points.push_back({ ExactPoint::Vertex(scene.Position(vertex)), vertex });
            const auto where = static_cast<Location>(3 + edge);
            contacts.Contacts.push_back({ face, face, -1, { where, where }, { point, point } });
            // Faces of others that the edge lies on see the point, too.
            for (const std::int32_t other : OthersInContact(contacts.Contacts, known, face))
            {
              const Location there = LocationOn(scene, vertex, other);
              if (there >= 0)
              {
                contacts.Contacts.push_back(
                  { other, face, -1, { there, there }, { point, point } });
              }
            }
          }
        }
      }
    }
  }
  std::stable_sort(
    contacts.Contacts.begin(), contacts.Contacts.end(), [](const Contact& l, const Contact& r) {
      return l.Face != r.Face ? l.Face < r.Face : l.Other < r.Other;
    });
}

} // namespace sb
