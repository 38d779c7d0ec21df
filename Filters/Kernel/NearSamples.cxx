// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NearSamples.h"

#include "TriangleDistance.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace sb
{
namespace
{

/** A triangle with all that is farther than the distance from it cut off by planes. */
class GrownTriangle
{
public:
  GrownTriangle(const Real3& a, const Real3& b, const Real3& c, double distance)
    : Corners{ a, b, c }
    , Distance(distance)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Lower[axis] = std::min({ a[axis], b[axis], c[axis] }) - distance;
      this->Upper[axis] = std::max({ a[axis], b[axis], c[axis] }) + distance;
    }
    const Real3 normal = Cross(Difference(b, a), Difference(c, a));
    const double size = Length(normal);
    if (!(size > 0.0))
    {
      return; // no plane: the box has to do
    }
    const Real3 unit = Scaled(normal, 1.0 / size);
    this->AddPlane(unit, a);
    this->AddPlane(Scaled(unit, -1.0), a);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Real3 along = Difference(this->Corners[(k + 1) % 3], this->Corners[k]);
      this->AddPlane(Scaled(Cross(along, unit), 1.0 / Length(along)), this->Corners[k]);
    }
  }

  bool MayMeet(const Real3& lower, const Real3& upper) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (lower[axis] > this->Upper[axis] || upper[axis] < this->Lower[axis])
      {
        return false;
      }
    }
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      double least = -this->Planes[k].Offset;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double n = this->Planes[k].Normal[axis];
        least += n * (n > 0.0 ? lower[axis] : upper[axis]);
      }
      if (least > this->Distance)
      {
        return false;
      }
    }
    return true;
  }

  bool IsNear(const Real3& x) const
  {
    std::array<Vector3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Real3 from = Difference(this->Corners[k], x);
      corners[k] = { from[0], from[1], from[2] };
    }
    return FindNearestOnTriangle(corners[0], corners[1], corners[2]).SquaredDistance <
      this->Distance * this->Distance;
  }

private:
  struct Plane
  {
    Real3 Normal;
    double Offset;
  };

  void AddPlane(const Real3& normal, const Real3& through)
  {
    this->Planes[this->Count++] = { normal, Dot(normal, through) };
  }

  std::array<Real3, 3> Corners;
  double Distance;
  Real3 Lower{};
  Real3 Upper{};
  std::array<Plane, 5> Planes{};
  std::size_t Count = 0;
};

} // namespace

bool IsNearSamples(
  const PointTree& samples, const Real3& a, const Real3& b, const Real3& c, double distance)
{
  const GrownTriangle triangle(a, b, c, distance);
  bool found = false;
  samples.ForRanges([&](const Real3& lower,
                      const Real3& upper) { return !found && triangle.MayMeet(lower, upper); },
    [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t i = begin; i < end && !found; ++i)
      {
        found = triangle.IsNear(samples.Point(i));
      }
    });
  return found;
}

} // namespace sb
