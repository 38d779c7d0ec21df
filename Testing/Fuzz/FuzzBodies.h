// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzBodies.h
 * @brief Closed surfaces from any bytes: few small integers as coordinates, so that everything that
 * can coincide does; bodies that are flat, inside out, doubled or run through themselves.
 */
#ifndef sb_FuzzBodies_h
#define sb_FuzzBodies_h

#include "Shapes.h"

#include <cstddef>
#include <cstdint>

namespace fuzz
{

using shapes::Mesh;
using shapes::Point;

/** What the fuzzer hands over, read byte by byte; zeros after its end. */
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , End(data + size)
  {
  }

  bool AtEnd() const { return this->Data == this->End; }

  /** 0 to limit - 1. */
  int Below(int limit) { return this->AtEnd() ? 0 : *this->Data++ % limit; }

private:
  const std::uint8_t* Data;
  const std::uint8_t* End;
};

inline Point ReadPoint(Bytes& bytes)
{
  const int places = 5;
  const double x = bytes.Below(places);
  const double y = bytes.Below(places);
  const double z = bytes.Below(places);
  return { x, y, z };
}

/** Two tips joined to a closed polygon, which may touch or cross itself. */
inline Mesh ReadBipyramid(Bytes& bytes)
{
  Mesh mesh;
  const int corners = 3 + bytes.Below(4);
  for (int i = 0; i < corners + 2; ++i)
  {
    mesh.Points.push_back(ReadPoint(bytes));
  }
  for (int i = 0; i < corners; ++i)
  {
    const int next = (i + 1) % corners;
    mesh.Triangles.push_back({ i, next, corners });
    mesh.Triangles.push_back({ next, i, corners + 1 });
  }
  return mesh;
}

/** Corners in any order: flat and inside out, too. */
inline Mesh ReadBox(Bytes& bytes)
{
  const Point low = ReadPoint(bytes);
  const Point high = ReadPoint(bytes);
  return shapes::Box(low, high);
}

inline Point ReadShift(Bytes& bytes)
{
  const double x = bytes.Below(2);
  const double y = bytes.Below(2);
  const double z = bytes.Below(2);
  return { x, y, z };
}

inline Mesh ReadTetrahedron(Bytes& bytes)
{
  Mesh mesh;
  for (int i = 0; i < 4; ++i)
  {
    mesh.Points.push_back(ReadPoint(bytes));
  }
  mesh.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  return mesh;
}

/** Every triangle with points of its own. */
inline Mesh AsSoup(const Mesh& mesh)
{
  Mesh soup;
  for (const shapes::Corners& t : mesh.Triangles)
  {
    soup.AddTriangle(mesh.At(t, 0), mesh.At(t, 1), mesh.At(t, 2));
  }
  return soup;
}

/** One closed surface, or what was read `before` moved by less than two. */
inline Mesh ReadBody(Bytes& bytes, const Mesh& before)
{
  Mesh mesh;
  switch (bytes.Below(4))
  {
    case 0:
      mesh = ReadBox(bytes);
      break;
    case 1:
      mesh = ReadTetrahedron(bytes);
      break;
    case 2:
      mesh = ReadBipyramid(bytes);
      break;
    default:
      mesh = before.Translated(ReadShift(bytes));
      break;
  }
  switch (bytes.Below(8))
  {
    case 0:
      return mesh.Reversed();
    case 1:
      return AsSoup(mesh);
    default:
      return mesh;
  }
}

/** One to three bodies in one surface that encloses no negative volume in all. */
inline Mesh ReadOperand(Bytes& bytes, const Mesh& before)
{
  Mesh operand;
  Mesh body = before;
  for (int bodies = 1 + bytes.Below(3); bodies > 0; --bodies)
  {
    body = ReadBody(bytes, body);
    operand.Append(body);
  }
  return operand.Triangles.empty() || Volume(operand) >= 0.0 ? operand : operand.Reversed();
}

/** Numbers to start a generator from: the same bytes, the same points. */
inline std::uint64_t Seed(const std::uint8_t* data, std::size_t size)
{
  std::uint64_t hash = 14695981039346656037u; // FNV-1a
  for (std::size_t i = 0; i < size; ++i)
  {
    hash = (hash ^ data[i]) * 1099511628211u;
  }
  return hash;
}

} // namespace fuzz

#endif
