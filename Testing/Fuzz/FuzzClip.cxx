// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzClip.cxx
 * @brief Clips by up to three planes that go through vertices, along edges and in faces: both parts
 * are closed, points are in one or the other, and volumes add up.
 */
#include "BooleanClaims.h"
#include "ClipClaims.h"
#include "FuzzBodies.h"

#include <cstdlib>

namespace
{

using namespace claims;

double VolumeOrZero(const Mesh& mesh) { return mesh.Triangles.empty() ? 0.0 : Volume(mesh); }

bool IsInFront(const std::vector<ClipPlane>& planes, const Point& p)
{
  return std::all_of(planes.begin(), planes.end(),
    [&](const ClipPlane& plane) { return Dot(plane.Normal, p - plane.Origin) > 0.0; });
}

std::vector<ClipPlane> ReadPlanes(fuzz::Bytes& bytes)
{
  std::vector<ClipPlane> planes(1 + static_cast<std::size_t>(bytes.Below(3)));
  for (ClipPlane& plane : planes)
  {
    plane.Origin = fuzz::ReadPoint(bytes);
    plane.Normal = fuzz::ReadPoint(bytes) - Point{ 2, 2, 2 };
    if (Length(plane.Normal) == 0.0)
    {
      plane.Normal = { 0, 0, 1 };
    }
  }
  return planes;
}

void Check(const Mesh& body, const std::vector<ClipPlane>& planes, Random& random)
{
  const Mesh front = Clip(body, planes);
  const Mesh rest = Clip(body, planes, true);
  CHECK_EQUAL(NumberOfOpenEdges(front), 0);
  CHECK_EQUAL(NumberOfOpenEdges(rest), 0);
  CheckNear(VolumeOrZero(front) + VolumeOrZero(rest), VolumeOrZero(body), 125.0);
  for (int i = 0; i < 8; ++i)
  {
    const Point p{ Uniform(random, -0.1, 5.1), Uniform(random, -0.1, 5.1),
      Uniform(random, -0.1, 5.1) };
    const int inside = RoundedWinding(body, p);
    CHECK_EQUAL(RoundedWinding(front, p), IsInFront(planes, p) ? inside : 0);
    CHECK_EQUAL(RoundedWinding(rest, p), IsInFront(planes, p) ? 0 : inside);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  Random random(fuzz::Seed(data, size));
  const std::vector<ClipPlane> planes = ReadPlanes(bytes);
  const Mesh operand = fuzz::ReadOperand(bytes, Cube(0, 2));
  const Mesh body = ComputeMesh({ { operand }, {}, Operation::Resolve });
  if (!body.Triangles.empty())
  {
    Check(body, planes, random);
  }
  if (check::Total().Failures > 0)
  {
    std::abort();
  }
  return 0;
}
