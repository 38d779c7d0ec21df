// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPredicates.cxx
 * @brief The predicates on lattice points give the signs that integers of any length give.
 */
#include "Check.h"
#include "Predicates.h"
#include "Reference.h"

using namespace reference;

namespace
{

using Four = std::array<Point, 4>;

/** How often a sign came out, so that no kind of case can go missing unnoticed. */
struct Tally
{
  long Negative = 0;
  long Zero = 0;
  long Positive = 0;

  void Count(int sign)
  {
    (sign < 0 ? this->Negative : (sign == 0 ? this->Zero : this->Positive)) += 1;
  }
};

/** Points in general position, in one plane, a step off a plane, on one line, or repeated. */
Four AnyFour(int kind, Random& random)
{
  Four p = { random.LatticePoint(), random.LatticePoint(), random.LatticePoint(),
    random.LatticePoint() };
  if (kind >= 4)
  {
    p = random.Cluster<4>(std::int64_t{ 1 } << random.Between(1, 50));
  }
  const std::int64_t i = random.Between(-3, 3);
  const std::int64_t j = random.Between(-3, 3);
  switch (kind % 4)
  {
    case 1:
      p[3] = Combine(p[0], p[1], p[2], i, j, p[0]);
      break;
    case 2:
      p[3] = Nudge(Combine(p[0], p[1], p[2], i, j, p[1]), random);
      break;
    case 3:
      p[2] = Combine(p[0], p[1], p[2], i, 0, p[1]);
      break;
    default:
      break;
  }
  return p;
}

void CheckOrient3D(const Four& p, Tally& tally)
{
  const double* a = p[0].data();
  const double* b = p[1].data();
  const double* c = p[2].data();
  const double* d = p[3].data();
  const int expected =
    Sign(Dot(TriangleNormal(a, b, c), reference::Subtract(ToVector(d), ToVector(a))));
  CHECK_EQUAL(sb::Orient3D(a, b, c, d), expected);
  CHECK_EQUAL(sb::exact::Orient3D(a, b, c, d), expected);
  CHECK_EQUAL(sb::Orient3D(b, a, c, d), -expected);
  CHECK_EQUAL(sb::Orient3D(d, c, b, a), expected);
  tally.Count(expected);
}

void CheckProjections(const Four& p, Tally& turns, Tally& normals)
{
  const double* a = p[0].data();
  const double* b = p[1].data();
  const double* c = p[2].data();
  const Vector normal = TriangleNormal(a, b, c);
  int largest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int expected = Sign(normal[axis]);
    CHECK_EQUAL(sb::Orient2D(a, b, c, axis), expected);
    CHECK_EQUAL(sb::exact::Orient2D(a, b, c, axis), expected);
    CHECK_EQUAL(sb::Orient2D(c, b, a, axis), -expected);
    turns.Count(expected);
    largest = abs(normal[axis]) > abs(normal[largest]) ? axis : largest;
  }
  const sb::DominantNormal dominant = sb::ComputeDominantNormal(a, b, c);
  CHECK_EQUAL(dominant.Axis, largest);
  CHECK_EQUAL(dominant.Sign, Sign(normal[largest]));
  const sb::DominantNormal unfiltered = sb::exact::ComputeDominantNormal(a, b, c);
  CHECK_EQUAL(unfiltered.Axis, largest);
  CHECK_EQUAL(unfiltered.Sign, Sign(normal[largest]));
  normals.Count(dominant.Sign);
}

void TestAgainstReference()
{
  Random random(3);
  for (int kind = 0; kind < 8; ++kind)
  {
    Tally orient3D;
    Tally turns;
    Tally normals;
    for (int i = 0; i < 25000; ++i)
    {
      const Four p = AnyFour(kind, random);
      CheckOrient3D(p, orient3D);
      CheckProjections(p, turns, normals);
    }
    if (kind % 4 == 3)
    {
      CHECK_EQUAL(turns.Zero, 75000);
      CHECK_EQUAL(normals.Zero, 25000);
    }
    else
    {
      CHECK(turns.Negative > 1000 && turns.Positive > 1000);
    }
    if (kind % 4 == 1 || kind % 4 == 3)
    {
      CHECK_EQUAL(orient3D.Zero, 25000);
    }
    else
    {
      CHECK(orient3D.Negative > 1000 && orient3D.Positive > 1000);
    }
  }
}

/** The largest determinants there are: corners of the lattice's cube, and a step inside. */
void TestCorners()
{
  Random random(4);
  Tally tally;
  for (int i = 0; i < 100000; ++i)
  {
    Four p;
    for (Point& point : p)
    {
      for (double& x : point)
      {
        x = static_cast<double>(
          (random.Between(0, 1) * 2 - 1) * (LatticeLimit - random.Between(0, 1)));
      }
    }
    CheckOrient3D(p, tally);
  }
  CHECK(tally.Negative > 1000 && tally.Zero > 1000 && tally.Positive > 1000);
}

/** A tilted plane far out, and points one step off it: products of 160 bits that differ in the last
 * ones. */
void TestThinnest()
{
  const double m = static_cast<double>(LatticeLimit);
  const double a[3] = { -m, -m, -m };
  const double b[3] = { m, m - 1.0, m };
  const double c[3] = { m - 1.0, m, m };
  const double on[3] = { -m, -m, -m };
  const double off[3] = { m, m, m };
  CHECK_EQUAL(sb::Orient3D(a, b, c, on), 0);
  CHECK_EQUAL(sb::Orient3D(a, b, c, off),
    Sign(Dot(TriangleNormal(a, b, c), reference::Subtract(ToVector(off), ToVector(a)))));
  CHECK(sb::Orient3D(a, b, c, off) != 0);
}

void TestConventions()
{
  const double o[3] = { 0.0, 0.0, 0.0 };
  const double x[3] = { 1.0, 0.0, 0.0 };
  const double y[3] = { 0.0, 1.0, 0.0 };
  const double z[3] = { 0.0, 0.0, 1.0 };
  CHECK_EQUAL(sb::Orient3D(o, x, y, z), 1);
  CHECK_EQUAL(sb::Orient2D(o, x, y, 2), 1);
  CHECK_EQUAL(sb::Orient2D(o, y, z, 0), 1);
  CHECK_EQUAL(sb::Orient2D(o, z, x, 1), 1);
  CHECK_EQUAL(sb::ComputeDominantNormal(o, y, x).Axis, 2);
  CHECK_EQUAL(sb::ComputeDominantNormal(o, y, x).Sign, -1);
  // The face x + y + z = 1 has three equal components: the lowest axis wins.
  CHECK_EQUAL(sb::ComputeDominantNormal(x, y, z).Axis, 0);
  CHECK_EQUAL(sb::ComputeDominantNormal(x, y, z).Sign, 1);
  CHECK_EQUAL(sb::ComputeDominantNormal(x, x, z).Sign, 0);
}

} // namespace

int main()
{
  TestConventions();
  TestThinnest();
  TestCorners();
  TestAgainstReference();
  return check::Verdict("TestPredicates");
}
