// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestExactPoint.cxx
 * @brief Created points lie exactly where they are said to lie, are rounded correctly, and do not
 * depend on how they were reached; their predicates give the signs that integers of any length
 * give.
 */
#include "Check.h"
#include "ExactPoint.h"
#include "Reference.h"

#include <cstring>
#include <vector>

using namespace reference;
using sb::ExactPlane;
using sb::ExactPoint;

namespace
{

/** The homogeneous coordinates X, Y, Z, W of a created point. */
struct Rational
{
  Vector Numerator;
  Integer Denominator;

  explicit Rational(const ExactPoint& point)
    : Numerator{ ToInteger(point.GetNumerator(0)), ToInteger(point.GetNumerator(1)),
      ToInteger(point.GetNumerator(2)) }
    , Denominator(ToInteger(point.GetDenominator()))
  {
  }
};

/** A plane made of integers of any length. */
struct Plane
{
  Vector Normal;
  Integer Offset;

  Plane(const Point& a, const Point& b, const Point& c)
    : Normal(TriangleNormal(a.data(), b.data(), c.data()))
    , Offset(Dot(this->Normal, ToVector(a.data())))
  {
  }
};

bool OnPlane(const Rational& point, const Plane& plane)
{
  return Dot(plane.Normal, point.Numerator) == plane.Offset * point.Denominator;
}

bool OnLine(const Rational& point, const Point& u, const Point& v)
{
  const Vector origin = ToVector(u.data());
  Vector fromU;
  for (int axis = 0; axis < 3; ++axis)
  {
    fromU[axis] = point.Numerator[axis] - origin[axis] * point.Denominator;
  }
  const Vector cross = Cross(fromU, reference::Subtract(ToVector(v.data()), origin));
  return cross[0] == 0 && cross[1] == 0 && cross[2] == 0;
}

bool SameBits(double a, double b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

/** Whether a fraction is the midpoint of two neighbouring doubles: 54 significant bits, the last of
 * them set. */
bool IsHalfway(const Integer& numerator, const Integer& denominator)
{
  const Integer divisor = gcd(numerator, denominator);
  const Integer lowest = denominator / divisor;
  const Integer magnitude = abs(numerator) / divisor;
  return magnitude != 0 && (lowest & (lowest - 1)) == 0 && msb(magnitude) - lsb(magnitude) == 53;
}

/** What every created point has to keep. */
void CheckPoint(const ExactPoint& point)
{
  const Rational exact(point);
  CHECK(point.Exists());
  CHECK(exact.Denominator > 0);
  bool integral = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double nearest = NearestDouble(exact.Numerator[axis], exact.Denominator);
    CHECK(SameBits(point.Approximation()[axis], nearest));
    integral = integral && exact.Numerator[axis] % exact.Denominator == 0 &&
      abs(exact.Numerator[axis]) < (exact.Denominator << 53);
  }
  CHECK_EQUAL(point.IsIntegral(), integral);
}

void CheckSame(const ExactPoint& a, const ExactPoint& b)
{
  CHECK(sb::SamePoint(a, b));
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK(SameBits(a.Approximation()[axis], b.Approximation()[axis]));
    CHECK_EQUAL(sb::CompareAlong(a, b, axis), 0);
    CHECK_EQUAL(sb::Orient2D(a, b, a, axis), 0);
  }
}

bool ReferenceSame(const ExactPoint& a, const ExactPoint& b)
{
  const Rational ra(a);
  const Rational rb(b);
  bool same = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    same = same && ra.Numerator[axis] * rb.Denominator == rb.Numerator[axis] * ra.Denominator;
  }
  return same;
}

int ReferenceOrient2D(const Rational& a, const Rational& b, const Rational& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  // Differences times both denominators, which are positive.
  const auto difference = [&a](const Rational& to, int along) {
    return Integer(to.Numerator[along] * a.Denominator - a.Numerator[along] * to.Denominator);
  };
  return Sign(difference(b, u) * difference(c, v) - difference(b, v) * difference(c, u));
}

/** Five points of one temperament: u and v of a line, a, b and c of a triangle. */
std::array<Point, 5> AnyLineAndTriangle(int kind, Random& random)
{
  std::array<Point, 5> p;
  switch (kind)
  {
    case 0:
      for (Point& point : p)
      {
        point = random.LatticePoint();
      }
      break;
    case 1: // few bits far up: many coordinates halfway between two doubles
      for (Point& point : p)
      {
        for (double& x : point)
        {
          x = std::ldexp(static_cast<double>(random.Between(-8, 8)), 49);
          x = std::fabs(x) > static_cast<double>(LatticeLimit) ? 1.0 : x;
        }
      }
      break;
    case 2: // an odd grid at the top of the lattice, where a double is a quarter's multiple at best
      for (Point& point : p)
      {
        for (double& x : point)
        {
          x = static_cast<double>(LatticeLimit - random.Between(0, 12));
        }
      }
      break;
    default:
      p = random.Cluster<5>(std::int64_t{ 1 } << random.Between(1, 50));
      break;
  }
  return p;
}
constexpr int NumberOfKinds = 4;

bool Parallel(const std::array<Point, 5>& p)
{
  const Vector normal = TriangleNormal(p[2].data(), p[3].data(), p[4].data());
  return Dot(normal, reference::Subtract(ToVector(p[1].data()), ToVector(p[0].data()))) == 0;
}

ExactPoint CrossingOf(const std::array<Point, 5>& p)
{
  return ExactPoint::LinePlane(p[0].data(), p[1].data(), p[2].data(), p[3].data(), p[4].data());
}

ExactPlane PlaneThrough(const Point& a, const Point& b, const Point& c)
{
  return ExactPlane::Through(a.data(), b.data(), c.data());
}

void TestPlanes()
{
  Random random(5);
  for (int i = 0; i < 50000; ++i)
  {
    const Point a = random.LatticePoint();
    const Point b = random.LatticePoint();
    const Point c = random.LatticePoint();
    const Plane expected(a, b, c);
    const ExactPlane plane = PlaneThrough(a, b, c);
    CHECK_EQUAL(ToInteger(plane.Offset), expected.Offset);
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK_EQUAL(ToInteger(plane.Normal[axis]), expected.Normal[axis]);
      const ExactPlane upright = ExactPlane::Vertical(a.data(), b.data(), axis);
      const Vector normal = { ToInteger(upright.Normal[0]), ToInteger(upright.Normal[1]),
        ToInteger(upright.Normal[2]) };
      const Integer offset = ToInteger(upright.Offset);
      CHECK_EQUAL(normal[axis], 0);
      CHECK_EQUAL(Dot(normal, ToVector(a.data())), offset);
      CHECK_EQUAL(Dot(normal, ToVector(b.data())), offset);
      CHECK_EQUAL(Sign(Dot(normal, ToVector(c.data())) - offset),
        sb::Orient2D(a.data(), b.data(), c.data(), axis));
    }
  }
}

/** One crossing reached by the line's other points, the triangle turned, and three planes. */
void TestLinePlane()
{
  Random random(6);
  long made = 0;
  long ties = 0;
  for (int i = 0; i < 120000; ++i)
  {
    const std::array<Point, 5> p = AnyLineAndTriangle(i % NumberOfKinds, random);
    const ExactPoint point = CrossingOf(p);
    CHECK_EQUAL(point.Exists(), !Parallel(p));
    if (!point.Exists())
    {
      continue;
    }
    ++made;
    const Rational exact(point);
    CHECK(OnLine(exact, p[0], p[1]));
    CHECK(OnPlane(exact, Plane(p[2], p[3], p[4])));
    CheckPoint(point);
    for (const Integer& x : exact.Numerator)
    {
      ties += IsHalfway(x, exact.Denominator) ? 1 : 0;
    }
    if (i % 4 != 0)
    {
      continue;
    }
    const Point further = Combine(p[0], p[1], p[1], random.Between(-3, 3), 0, p[1]);
    CheckSame(point, CrossingOf({ p[1], p[0], p[3], p[2], p[4] }));
    if (further != p[0])
    {
      CheckSame(point, CrossingOf({ p[0], further, p[2], p[3], p[4] }));
    }
    // The line is where its two planes parallel to axes meet, unless it is parallel to both of
    // them.
    for (int axis = 0; axis < 3; ++axis)
    {
      const ExactPoint again = ExactPoint::ThreePlanes(PlaneThrough(p[2], p[3], p[4]),
        ExactPlane::Vertical(p[0].data(), p[1].data(), axis),
        ExactPlane::Vertical(p[0].data(), p[1].data(), (axis + 1) % 3));
      if (again.Exists())
      {
        CheckPoint(again);
        CheckSame(point, again);
      }
    }
  }
  CHECK(made > 90000);
  CHECK(ties > 1000);
}

/** Two lines in one plane: t is taken such that st meets uv. */
void TestLineLine()
{
  Random random(7);
  long made = 0;
  for (int i = 0; i < 80000; ++i)
  {
    const std::array<Point, 5> p = AnyLineAndTriangle(i % NumberOfKinds, random);
    const Point& u = p[0];
    const Point& v = p[1];
    const Point& s = p[2];
    const Point t = Combine(u, v, s, random.Between(-1, 1), random.Between(-1, 1), s);
    for (int axis = 0; axis < 3; ++axis)
    {
      const ExactPoint point = ExactPoint::LineLine(u.data(), v.data(), s.data(), t.data(), axis);
      if (!point.Exists())
      {
        continue;
      }
      ++made;
      const Rational exact(point);
      CHECK(OnLine(exact, u, v));
      CHECK(OnLine(exact, s, t));
      CheckPoint(point);
      CheckSame(point, ExactPoint::LineLine(t.data(), s.data(), v.data(), u.data(), axis));
      const ExactPoint again =
        ExactPoint::ThreePlanes(ExactPlane::Vertical(s.data(), t.data(), axis),
          PlaneThrough(u, v, s), PlaneThrough(u, v, p[3]));
      if (again.Exists())
      {
        CheckSame(point, again);
      }
    }
  }
  CHECK(made > 100000);
}

void TestThreePlanes()
{
  Random random(8);
  long made = 0;
  for (int i = 0; i < 50000; ++i)
  {
    std::array<Point, 10> p;
    const std::array<Point, 5> first = AnyLineAndTriangle(i % NumberOfKinds, random);
    const std::array<Point, 5> second = AnyLineAndTriangle(i % NumberOfKinds, random);
    std::copy(first.begin(), first.end(), p.begin());
    std::copy(second.begin(), second.end(), p.begin() + 5);
    const ExactPoint point = ExactPoint::ThreePlanes(PlaneThrough(p[0], p[1], p[2]),
      PlaneThrough(p[3], p[4], p[5]), PlaneThrough(p[6], p[7], p[8]));
    if (!point.Exists())
    {
      continue;
    }
    ++made;
    const Rational exact(point);
    CHECK(OnPlane(exact, Plane(p[0], p[1], p[2])));
    CHECK(OnPlane(exact, Plane(p[3], p[4], p[5])));
    CHECK(OnPlane(exact, Plane(p[6], p[7], p[8])));
    CheckPoint(point);
    CheckSame(point,
      ExactPoint::ThreePlanes(PlaneThrough(p[8], p[7], p[6]), PlaneThrough(p[1], p[0], p[2]),
        PlaneThrough(p[4], p[5], p[3])));
  }
  CHECK(made > 40000);
}

/** The widest values there are: the planes and lines of the cube's corners, a step off. */
void TestWidest()
{
  Random random(9);
  const auto corner = [&random]() {
    Point point;
    for (double& x : point)
    {
      x =
        static_cast<double>((random.Between(0, 1) * 2 - 1) * (LatticeLimit - random.Between(0, 1)));
    }
    return point;
  };
  std::vector<ExactPoint> points;
  unsigned widest = 0;
  for (int i = 0; i < 20000; ++i)
  {
    std::array<Point, 9> p;
    for (Point& point : p)
    {
      point = corner();
    }
    const ExactPoint point = ExactPoint::ThreePlanes(PlaneThrough(p[0], p[1], p[2]),
      PlaneThrough(p[3], p[4], p[5]), PlaneThrough(p[6], p[7], p[8]));
    if (!point.Exists())
    {
      continue;
    }
    const Rational exact(point);
    CHECK(OnPlane(exact, Plane(p[0], p[1], p[2])));
    CHECK(OnPlane(exact, Plane(p[3], p[4], p[5])));
    CHECK(OnPlane(exact, Plane(p[6], p[7], p[8])));
    CheckPoint(point);
    widest = std::max(widest, static_cast<unsigned>(msb(exact.Denominator)));
    points.push_back(point);
  }
  CHECK(points.size() > 1000);
  CHECK(widest >= 319);
  for (std::size_t i = 2; i < points.size(); ++i)
  {
    const int axis = static_cast<int>(i % 3);
    CHECK_EQUAL(sb::exact::Orient2D(points[i - 2], points[i - 1], points[i], axis),
      ReferenceOrient2D(
        Rational(points[i - 2]), Rational(points[i - 1]), Rational(points[i]), axis));
  }
}

/** Any construction, sometimes of a point that lies on the line of the two before it. */
ExactPoint AnyPoint(const std::array<Point, 5>& frame, int kind, Random& random)
{
  const std::array<Point, 5> other = AnyLineAndTriangle(kind, random);
  ExactPoint point;
  switch (random.Between(0, 3))
  {
    case 0:
      point = ExactPoint::Vertex(frame[random.Between(0, 4)].data());
      break;
    case 1: // on the line of the frame's first two points
      point = CrossingOf({ frame[0], frame[1], other[2], other[3], other[4] });
      break;
    case 2: // on the same line, the wide way
      point = ExactPoint::ThreePlanes(PlaneThrough(frame[0], frame[1], frame[2]),
        PlaneThrough(frame[0], frame[1], frame[3]), PlaneThrough(other[0], other[1], other[2]));
      break;
    default:
      point = CrossingOf(other);
      break;
  }
  return point.Exists() ? point : ExactPoint::Vertex(frame[0].data());
}

void TestPointPredicates()
{
  Random random(10);
  long turns[3] = {};
  long refinedTurns[3] = {};
  long same = 0;
  long undecided = 0;
  for (int i = 0; i < 120000; ++i)
  {
    const int kind = i % NumberOfKinds;
    const std::array<Point, 5> frame = AnyLineAndTriangle(kind, random);
    const ExactPoint a = AnyPoint(frame, kind, random);
    const ExactPoint b = AnyPoint(frame, kind, random);
    const ExactPoint c = AnyPoint(frame, kind, random);
    const Rational ra(a);
    const Rational rb(b);
    const Rational rc(c);
    const int axis = static_cast<int>(random.Between(0, 2));
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;

    const int expected = ReferenceOrient2D(ra, rb, rc, axis);
    CHECK_EQUAL(sb::Orient2D(a, b, c, axis), expected);
    CHECK_EQUAL(sb::exact::Orient2D(a, b, c, axis), expected);
    CHECK_EQUAL(sb::Orient2D(b, a, c, axis), -expected);
    ++turns[expected + 1];
    const int filtered = sb::filter::Orient2D(a.Approximation()[u], a.Approximation()[v],
      b.Approximation()[u], b.Approximation()[v], c.Approximation()[u], c.Approximation()[v]);
    undecided += filtered == sb::filter::Undecided ? 1 : 0;

    const int along =
      Sign(rb.Numerator[axis] * ra.Denominator - ra.Numerator[axis] * rb.Denominator);
    CHECK_EQUAL(sb::CompareAlong(a, b, axis), along);
    CHECK_EQUAL(sb::exact::CompareAlong(a, b, axis), along);

    const bool equal = ReferenceSame(a, b);
    CHECK_EQUAL(sb::SamePoint(a, b), equal);
    CHECK_EQUAL(sb::exact::SamePoint(a, b), equal);
    same += equal ? 1 : 0;

    // Near b, so that the filter has to give up on some.
    const std::int64_t limit = 256 * LatticeLimit;
    std::int64_t s[2];
    for (int k = 0; k < 2; ++k)
    {
      const double near = 256.0 * b.Approximation()[k == 0 ? u : v];
      s[k] = std::fabs(near) < static_cast<double>(limit) - 1000.0
        ? static_cast<std::int64_t>(near) + random.Between(-2, 2)
        : random.Between(-limit, limit);
    }
    const Integer refined =
      (ra.Numerator[u] * rb.Numerator[v] - ra.Numerator[v] * rb.Numerator[u]) * 256 +
      (ra.Numerator[v] * rb.Denominator - ra.Denominator * rb.Numerator[v]) * s[0] +
      (ra.Denominator * rb.Numerator[u] - ra.Numerator[u] * rb.Denominator) * s[1];
    CHECK_EQUAL(sb::Orient2DRefined(a, b, s, axis), Sign(refined));
    CHECK_EQUAL(sb::exact::Orient2DRefined(a, b, s, axis), Sign(refined));
    ++refinedTurns[Sign(refined) + 1];
  }
  for (int sign = 0; sign < 3; ++sign)
  {
    CHECK(turns[sign] > 5000);
    CHECK(refinedTurns[sign] > 1000);
  }
  CHECK(same > 1000);
  CHECK(undecided > 5000 && undecided < 110000);
}

void TestRefined()
{
  Random random(11);
  long heights[3] = {};
  long turns[3] = {};
  for (int i = 0; i < 100000; ++i)
  {
    const std::array<Point, 5> first = AnyLineAndTriangle(i % NumberOfKinds, random);
    const std::array<Point, 5> second = AnyLineAndTriangle(i % NumberOfKinds, random);
    const int axis = static_cast<int>(random.Between(0, 2));
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double* const T[3] = { first[0].data(), first[1].data(), first[2].data() };
    // Every second time G shares a corner with T, and s is that corner or a step of 1/256 off it.
    const bool touching = i % 2 == 0;
    const double* const G[3] = { touching ? T[1] : second[0].data(), second[1].data(),
      second[2].data() };
    std::int64_t s[2] = { 256 * static_cast<std::int64_t>(T[1][u]),
      256 * static_cast<std::int64_t>(T[1][v]) };
    s[0] += random.Between(-1, 1);
    s[1] += touching ? 0 : random.Between(-1000000, 1000000);

    const Vector a = ToVector(T[0]);
    const Vector b = ToVector(T[1]);
    const int turn =
      Sign((b[u] - a[u]) * (s[1] - 256 * a[v]) - (b[v] - a[v]) * (s[0] - 256 * a[u]));
    CHECK_EQUAL(sb::Orient2DRefined(T[0], T[1], s, axis), turn);
    ++turns[turn + 1];

    const Plane planeT(first[0], first[1], first[2]);
    const Plane planeG(touching ? first[1] : second[0], second[1], second[2]);
    if (planeT.Normal[axis] == 0 || planeG.Normal[axis] == 0)
    {
      continue;
    }
    const auto numerator = [&](const Plane& plane) {
      return Integer(256 * plane.Offset - plane.Normal[u] * s[0] - plane.Normal[v] * s[1]);
    };
    const int expected =
      Sign(numerator(planeT) * planeG.Normal[axis] - numerator(planeG) * planeT.Normal[axis]) *
      Sign(planeT.Normal[axis]) * Sign(planeG.Normal[axis]);
    CHECK_EQUAL(sb::CompareHeights(T, G, s, axis), expected);
    CHECK_EQUAL(sb::CompareHeights(G, T, s, axis), -expected);
    ++heights[expected + 1];
  }
  for (int sign = 0; sign < 3; ++sign)
  {
    CHECK(turns[sign] > 1000);
    CHECK(heights[sign] > 1000);
  }
}

/** Asked for what does not exist, nothing breaks. */
void TestNoPoint()
{
  const double a[3] = { 0.0, 0.0, 0.0 };
  const double b[3] = { 1.0, 0.0, 0.0 };
  const double c[3] = { 0.0, 1.0, 0.0 };
  const ExactPlane ground = ExactPlane::Through(a, b, c);
  const ExactPoint none[] = { ExactPoint(), ExactPoint::LinePlane(a, b, a, b, c),
    ExactPoint::LineLine(a, b, a, b, 2), ExactPoint::ThreePlanes(ground, ground, ground) };
  const ExactPoint vertex = ExactPoint::Vertex(b);
  for (const ExactPoint& point : none)
  {
    CHECK(!point.Exists());
    CHECK(!point.IsIntegral());
    CHECK(std::isnan(point.Approximation()[0]));
    CHECK(!sb::SamePoint(point, vertex));
    CHECK_EQUAL(sb::Orient2D(point, vertex, vertex, 0), 0);
  }
}

} // namespace

int main()
{
  TestNoPoint();
  TestPlanes();
  TestLinePlane();
  TestLineLine();
  TestThreePlanes();
  TestWidest();
  TestPointPredicates();
  TestRefined();
  return check::Verdict("TestExactPoint");
}
