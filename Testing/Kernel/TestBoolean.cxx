// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBoolean.cxx
 * @brief The identities that any Boolean operation obeys, on random surfaces with small integer
 * coordinates, where everything degenerate happens; points are tested by winding numbers that are
 * computed from the inputs alone.
 *
 * `TestBoolean family seed` runs one case again; a failure prints both.
 */
#include "BooleanClaims.h"
#include "ThreadExecutor.h"

#include <atomic>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>

namespace
{

using namespace claims;

/** All identities of two clean closed surfaces. */
void CheckPair(const Mesh& a, const Mesh& b, Random& random)
{
  Case given{ { a }, { b }, Operation::Union };
  const auto volume = [&](Operation op, bool swapped) {
    given.Op = op;
    const Case turned{ given.Tools, given.Inputs, op };
    const Mesh mesh = ComputeAndCheck(swapped ? turned : given, random);
    return Volume(mesh);
  };
  const double ofA = Volume(a);
  const double ofB = Volume(b);
  const double scale = std::abs(ofA) + std::abs(ofB);
  const double both = volume(Operation::Intersection, false);
  CheckNear(volume(Operation::Union, false), ofA + ofB - both, scale);
  CheckNear(volume(Operation::Difference, false), ofA - both, scale);
  CheckNear(volume(Operation::SymmetricDifference, false), ofA + ofB - 2 * both, scale);
  CheckNear(volume(Operation::Resolve, false), ofA + ofB - both, scale);
  CheckNear(volume(Operation::Intersection, true), both, scale);
  CheckNear(volume(Operation::Union, true), ofA + ofB - both, scale);
  CheckNear(volume(Operation::Difference, true), ofB - both, scale);
  CheckNear(volume(Operation::SymmetricDifference, true), ofA + ofB - 2 * both, scale);
}

// --- families of random cases
// ---------------------------------------------------------------------------------------

void SmallBoxes(Random& random)
{
  CheckPair(RandomBox(random, 0, 3), RandomBox(random, 0, 3), random);
}

void Tetrahedra(Random& random)
{
  CheckPair(RandomConvex(random, -2, 2, 4), RandomConvex(random, -2, 2, 4), random);
}

void ConvexBodies(Random& random)
{
  CheckPair(RandomConvex(random, -2, 2, Between(random, 5, 9)),
    RandomConvex(random, -2, 2, Between(random, 5, 9)), random);
}

void BoxAndConvexBody(Random& random)
{
  CheckPair(RandomBox(random, -2, 2), RandomConvex(random, -2, 2, Between(random, 4, 8)), random);
}

/** A surface and itself, moved by at most one, or turned over, or with its triangles in another
 * order. */
void NearCopies(Random& random)
{
  const Mesh a = RandomConvex(random, -2, 2, Between(random, 4, 8));
  Mesh b = a.Translated(IntegerPoint(random, -1, 1));
  if (Between(random, 0, 1) == 0)
  {
    b = a;
    std::shuffle(b.Triangles.begin(), b.Triangles.end(), random);
    for (Corners& t : b.Triangles)
    {
      std::rotate(t.begin(), t.begin() + Between(random, 0, 2), t.end());
    }
  }
  CheckPair(a, b, random);
}

void RotatedCopies(Random& random)
{
  const Mesh a = Between(random, 0, 1) == 0 ? Cube(-1, 1) : RandomConvex(random, -2, 2, 6);
  Mesh b = a;
  if (Between(random, 0, 1) == 0)
  {
    b = Rotated(a, RandomRotation(random));
  }
  else
  {
    // About an axis that stays: two pairs of coplanar faces.
    const double angle = Between(random, 1, 7) * 0.39269908169872414;
    b = Rotated(a,
      { Point{ std::cos(angle), -std::sin(angle), 0 }, Point{ std::sin(angle), std::cos(angle), 0 },
        Point{ 0, 0, 1 } });
  }
  CheckPair(a, b, random);
}

/** Spheres that coincide, touch in a vertex, share all but a shift, or cross. */
void Spheres(Random& random)
{
  const int divisions = Between(random, 1, 6);
  const Mesh a = Sphere({ 0, 0, 0 }, 1.0, divisions);
  const Point along[] = { { 1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 } };
  const double distance[] = { 0.0, 0.5, 1.0, 2.0, 2.0, 1.9999999999 };
  const Mesh b = Sphere(distance[Between(random, 0, 5)] * along[Between(random, 0, 2)], 1.0,
    Between(random, 0, 1) == 0 ? divisions : Between(random, 1, 6));
  CheckPair(a, b, random);
}

/** One operand of boxes that overlap each other. */
void SelfOverlapping(Random& random)
{
  const Mesh a = RandomBoxes(random, 0, 4, Between(random, 2, 4));
  const Mesh b = Between(random, 0, 1) == 0 ? RandomBox(random, 0, 4)
                                            : RandomBoxes(random, 0, 4, Between(random, 2, 3));
  for (const Operation op : AllOperations)
  {
    ComputeAndCheck({ { a }, { b }, op }, random,
      op == Operation::Resolve ? Overlaps::None : Overlaps::MayRemain);
    ComputeAndCheck({ { b }, { a }, op }, random,
      op == Operation::Resolve ? Overlaps::None : Overlaps::MayRemain);
  }
}

/** Tetrahedra and the like in one operand, some of them turned over: negative windings, too. */
void SelfOverlappingConvex(Random& random)
{
  const auto some = [&] {
    Mesh mesh;
    for (int i = Between(random, 1, 3); i > 0; --i)
    {
      const Mesh body = RandomConvex(random, -2, 2, Between(random, 4, 5));
      mesh.Append(Between(random, 0, 3) == 0 ? body.Reversed() : body);
    }
    return Volume(mesh) > 0 ? mesh : RandomBox(random, -2, 2);
  };
  const Mesh a = some();
  const Mesh b = some();
  for (const Operation op : AllOperations)
  {
    ComputeAndCheck({ { a }, { b }, op }, random,
      op == Operation::Resolve ? Overlaps::None : Overlaps::MayRemain);
  }
}

/** Two bodies of one operand that overlap, and a box inside the one that touches the other, or goes
 * through it. Bodies far away make all faces near, and these come in any order: which one is asked
 * first is chance. */
void TouchedWhereBodiesOverlap(Random& random)
{
  Mesh bodies = Cube(0, 4);
  bodies.Append(Box({ double(Between(random, -2, 3)), 1, 1 }, { 6, 3, 3 }));
  const double low = Between(random, 6, 8) * 0.5;
  Mesh box = Box({ low, 1.5, 1.5 }, { low + 1.0, 2.5, 2.5 });
  box.Append(Cube(-4, -3));
  box.Append(Cube(7, 8));
  std::shuffle(bodies.Triangles.begin(), bodies.Triangles.end(), random);
  std::shuffle(box.Triangles.begin(), box.Triangles.end(), random);
  for (const auto& operands : { std::make_pair(bodies, box), std::make_pair(box, bodies) })
  {
    const Mesh both =
      ComputeMesh({ { operands.first }, { operands.second }, Operation::Intersection });
    CHECK_EQUAL(NumberOfOpenEdges(both), 0);
    CHECK_EQUAL(Volume(both), 1.0);
  }
}

/** Shells of one operand inside each other, where the other operand meets but one of them. */
void NestedShells(Random& random)
{
  Mesh a = Cube(0, 10);
  a.Append(Between(random, 0, 1) == 0 ? RandomBox(random, 2, 6) : RandomConvex(random, 2, 6, 5));
  if (Between(random, 0, 1) == 0)
  {
    a.Append(RandomBox(random, 11, 13).Reversed());
  }
  const Mesh b = Between(random, 0, 1) == 0 ? RandomBox(random, 1, 7) : RandomBox(random, 9, 14);
  for (const Operation op : AllOperations)
  {
    for (const bool swapped : { false, true })
    {
      ComputeAndCheck({ { swapped ? b : a }, { swapped ? a : b }, op }, random,
        op == Operation::Resolve ? Overlaps::None : Overlaps::MayRemain);
    }
  }
}

/** Triangles that an operand has twice, by the same points or by others. */
void DoubledTriangles(Random& random)
{
  const Mesh body = RandomConvex(random, -2, 2, Between(random, 4, 6));
  Mesh a = body;
  if (Between(random, 0, 1) == 0)
  {
    a.Append(body);
  }
  else
  {
    a.Triangles.insert(a.Triangles.end(), body.Triangles.begin(), body.Triangles.end());
  }
  const Mesh b = RandomConvex(random, -2, 2, Between(random, 4, 6));
  for (const Operation op : AllOperations)
  {
    ComputeAndCheck({ { a }, { b }, op }, random,
      op == Operation::Resolve ? Overlaps::None : Overlaps::MayRemain);
  }
}

/** Every triangle with points of its own. */
void Soups(Random& random)
{
  const auto soup = [&] {
    const Mesh body = RandomConvex(random, -2, 2, Between(random, 4, 7));
    Mesh mesh;
    for (const Corners& t : body.Triangles)
    {
      mesh.AddTriangle(body.At(t, 0), body.At(t, 1), body.At(t, 2));
    }
    return mesh;
  };
  const Mesh a = soup();
  CheckPair(a, soup(), random);
}

void ResolveAlone(Random& random)
{
  const Mesh boxes = RandomBoxes(random, 0, 4, Between(random, 1, 5));
  ComputeAndCheck({ { boxes }, {}, Operation::Resolve }, random);
  // Few places: boxes that share whole faces, edges and vertices.
  ComputeAndCheck({ { RandomBoxes(random, 0, 2, 3) }, {}, Operation::Resolve }, random);
  Mesh bodies;
  for (int i = 0; i < 3; ++i)
  {
    bodies.Append(RandomConvex(random, -2, 2, 4));
  }
  ComputeAndCheck({ { bodies }, {}, Operation::Resolve }, random);
}

void ManyOperands(Random& random)
{
  Case given;
  const int operands = Between(random, 3, 6);
  for (int i = 0; i < operands; ++i)
  {
    const Mesh mesh = Between(random, 0, 1) == 0
      ? RandomBox(random, -2, 2)
      : RandomConvex(random, -2, 2, Between(random, 4, 6));
    (i == 0 || Between(random, 0, 1) == 0 ? given.Inputs : given.Tools).push_back(mesh);
  }
  for (const Operation op : AllOperations)
  {
    given.Op = op;
    ComputeAndCheck(given, random);
  }
}

void EmptyOperands(Random& random)
{
  const Mesh a = RandomConvex(random, -2, 2, 5);
  const double volume = Volume(a);
  Mesh points; // points without triangles are the empty set, too
  points.Points = a.Points;
  const Mesh nothing[] = { {}, points };
  const Mesh& empty = nothing[Between(random, 0, 1)];
  const auto check = [&](const Mesh& first, const Mesh& second, Operation op, double expected) {
    const Case given{ { first }, { second }, op };
    const BooleanResult result = Compute(given);
    CHECK(result.Condition == Status::EmptyOperand);
    CheckForm(given, result);
    const Mesh mesh = ResultMesh(given, result);
    CHECK_EQUAL(NumberOfOpenEdges(mesh), 0);
    CheckNear(mesh.Triangles.empty() ? 0.0 : Volume(mesh), expected, volume);
  };
  check(a, empty, Operation::Union, volume);
  check(a, empty, Operation::Intersection, 0);
  check(a, empty, Operation::Difference, volume);
  check(a, empty, Operation::SymmetricDifference, volume);
  check(a, empty, Operation::Resolve, volume);
  check(empty, a, Operation::Union, volume);
  check(empty, a, Operation::Intersection, 0);
  check(empty, a, Operation::Difference, 0);
  check(empty, a, Operation::SymmetricDifference, volume);
  check(empty, empty, Operation::Union, 0);
}

/** An operand that is inside out counts as if it were not, and says so. */
void InsideOut(Random& random)
{
  const Mesh a = RandomConvex(random, -2, 2, 6);
  const Mesh b = RandomConvex(random, -2, 2, 6);
  for (const Operation op : AllOperations)
  {
    const double expected = Volume(ComputeMesh({ { a }, { b }, op }));
    const Case given{ { a }, { b.Reversed() }, op };
    const BooleanResult result = Compute(given);
    CHECK(result.Condition == Status::InsideOut);
    const Mesh mesh = ResultMesh(given, result);
    CHECK_EQUAL(NumberOfOpenEdges(mesh), 0);
    CheckNear(mesh.Triangles.empty() ? 0.0 : Volume(mesh), expected, Volume(a) + Volume(b));
  }
}

// --- the same whatever the numbers
// ---------------------------------------------------------------------------------

/** Everything but the times, as bytes. */
std::string Bytes(const BooleanResult& result)
{
  std::string bytes;
  const auto put = [&](const auto& value) {
    static_assert(std::is_arithmetic<std::decay_t<decltype(value)>>::value ||
      std::is_enum<std::decay_t<decltype(value)>>::value);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  const auto putAll = [&](const auto& values) {
    put(values.size());
    for (const auto& value : values)
    {
      put(value);
    }
  };
  put(result.Condition);
  put(result.Remarks.size());
  for (const sb::Remark& remark : result.Remarks)
  {
    put(remark.Condition);
    put(remark.Operand);
    put(remark.Triangle);
    put(remark.Point);
    put(remark.Count);
  }
  for (const auto* lists : { &result.PointMap, &result.KeptPoints })
  {
    put(lists->size());
    for (const std::vector<std::int32_t>& list : *lists)
    {
      putAll(list);
    }
  }
  for (const std::vector<Fate>& fates : result.Fates)
  {
    putAll(fates);
  }
  for (const sb::InterpolatedPoint& point : result.Interpolated)
  {
    putAll(point.Position);
    put(point.Operand);
    putAll(point.PointIds);
    putAll(point.Weights);
  }
  for (const Corners& corners : result.Split.Corners)
  {
    putAll(corners);
  }
  putAll(result.Split.Operand);
  putAll(result.Split.Parent);
  putAll(result.Split.Reversed);
  for (const Point& p : result.Intersection.Points)
  {
    putAll(p);
  }
  putAll(result.Intersection.Connectivity);
  putAll(result.Intersection.Offsets);
  for (const sb::Curves::Makers& makers : result.Intersection.Segments)
  {
    putAll(makers.Operand);
    putAll(makers.Triangle);
  }
  for (const sb::OperandReport& report : result.Operands)
  {
    put(report.Closed);
    put(report.Volume);
    put(report.Area);
    putAll(report.Bounds);
  }
  put(result.NumberOfContacts);
  return bytes;
}

sb::ThreadExecutor& TwoThreads()
{
  static sb::ThreadExecutor executor(2);
  return executor;
}

/** One thread or two: the same bytes. */
void Threads(Random& random)
{
  Case given;
  given.Op = AllOperations[Between(random, 0, 4)];
  switch (Between(random, 0, 3))
  {
    case 0: // long enough for several ranges in every loop
      given.Inputs = { Sphere({ 0, 0, 0 }, 1.0, 48) };
      given.Tools = { Sphere({ Uniform(random, 0, 1), Uniform(random, 0, 1), 0.25 }, 1.0, 40) };
      break;
    case 1:
      given.Inputs = { RandomBoxes(random, 0, 12, 40) };
      given.Tools = { RandomBoxes(random, 0, 12, 40) };
      break;
    case 2:
      given.Inputs = { Sphere({ 0, 0, 0 }, 1.0, 24) };
      given.Tools = { Sphere({ 0, 0, 0 }, 1.0, 24), RandomBox(random, -1, 1) };
      break;
    default:
      given.Inputs = { RandomBox(random, 0, 3), RandomConvex(random, 0, 3, 7) };
      given.Tools = { RandomConvex(random, 0, 3, 7) };
      break;
  }
  sb::SerialExecutor one;
  sb::Monitor monitor;
  for (const sb::SeamPoints seams : { sb::SeamPoints::PerSide, sb::SeamPoints::Shared })
  {
    const std::string first = Bytes(sb::ComputeBoolean(given.Request(), seams, one, monitor));
    CHECK(first == Bytes(sb::ComputeBoolean(given.Request(), seams, TwoThreads(), monitor)));
  }
}

/** A scale of two changes positions only; other scales and shifts keep the identities. */
void ShiftsAndScales(Random& random)
{
  const Mesh a = RandomConvex(random, -2, 2, Between(random, 4, 7));
  const Mesh b = Between(random, 0, 1) == 0 ? RandomBox(random, -2, 2)
                                            : RandomConvex(random, -2, 2, Between(random, 4, 7));
  const auto compute = [&](const std::function<Mesh(const Mesh&)>& map, Operation op) {
    const Case given{ { map(a) }, { map(b) }, op };
    BooleanResult result = Compute(given);
    CHECK_EQUAL(NumberOfOpenEdges(ResultMesh(given, result)), 0);
    return std::make_pair(ResultMesh(given, result), result);
  };
  const double scale = Volume(a) + Volume(b);
  const auto volume = [](const Mesh& mesh) { return mesh.Triangles.empty() ? 0.0 : Volume(mesh); };
  for (const Operation op : { Operation::Union, Operation::Difference, Operation::Intersection })
  {
    const auto plain = compute([](const Mesh& mesh) { return mesh; }, op);
    const double expected = volume(plain.first);

    const double two = std::ldexp(1.0, Between(random, -300, 300));
    const auto scaled = compute([&](const Mesh& mesh) { return mesh.Scaled(two); }, op);
    CHECK(scaled.second.Fates == plain.second.Fates);
    CHECK(scaled.second.Split.Corners == plain.second.Split.Corners);
    CHECK(scaled.second.Split.Reversed == plain.second.Split.Reversed);
    CHECK(scaled.first.Points == plain.first.Scaled(two).Points);

    const auto large = compute([](const Mesh& mesh) { return mesh.Scaled(1e6); }, op);
    CheckNear(volume(large.first), 1e18 * expected, 1e18 * scale);
    CHECK_EQUAL(large.second.NumberOfContacts, plain.second.NumberOfContacts);
    const auto small = compute([](const Mesh& mesh) { return mesh.Scaled(1e-6); }, op);
    CheckNear(volume(small.first), 1e-18 * expected, 1e-18 * scale);

    const Point shift{ 1e6, -1e6, 1e6 };
    const auto moved = compute([&](const Mesh& mesh) { return mesh.Translated(shift); }, op);
    CheckNear(volume(moved.first), expected, 100 * scale);
    CHECK_EQUAL(moved.second.NumberOfContacts, plain.second.NumberOfContacts);
  }
}

/** Shared seams close the result by point ids where the inputs are. */
void SharedSeams(Random& random)
{
  Case given;
  given.Inputs = { RandomConvex(random, -2, 2, 6) };
  given.Tools = { RandomBox(random, -2, 2) };
  if (Between(random, 0, 1) == 0)
  {
    given.Inputs.push_back(RandomConvex(random, -2, 2, 6));
  }
  for (const Operation op : AllOperations)
  {
    given.Op = op;
    const BooleanResult result = Compute(given, sb::SeamPoints::Shared);
    const Mesh mesh = ResultMesh(given, result);
    CHECK_EQUAL(NumberOfOpenEdges(mesh), 0);
    CHECK_EQUAL(NumberOfOpenEdgesById(mesh), 0);
    CheckNear(
      mesh.Triangles.empty() ? 0.0 : Volume(mesh),
      [&] {
        const Mesh perSide = ComputeMesh(given);
        return perSide.Triangles.empty() ? 0.0 : Volume(perSide);
      }(),
      100.0);
  }
}

// --- open operands
// --------------------------------------------------------------------------------------------------

/** A body cut through by a plane: two closed parts that add up, one on each side. */
void CutByPlane(Random& random)
{
  const Mesh body = Between(random, 0, 1) == 0 ? RandomBox(random, -2, 2)
                                               : RandomConvex(random, -2, 2, Between(random, 4, 8));
  Point normal;
  do
  {
    normal = IntegerPoint(random, -2, 2);
  } while (Dot(normal, normal) == 0.0);
  const Point through = IntegerPoint(random, -1, 1);
  // Two integer directions across the normal, right-handed with it.
  Point u = Cross(normal, { 1, 0, 0 });
  u = Dot(u, u) == 0.0 ? Cross(normal, { 0, 1, 0 }) : u;
  const Point v = Cross(normal, u);
  const double far = 20.0;
  const Mesh plane = Sheet(through - far * u - far * v, through + far * u - far * v,
    through + far * u + far * v, through - far * u + far * v);

  int front = 0;
  int behind = 0;
  for (const Point& p : body.Points)
  {
    front += Dot(normal, p - through) > 0;
    behind += Dot(normal, p - through) < 0;
  }
  double volume = 0.0;
  for (const Operation op : { Operation::Difference, Operation::Intersection })
  {
    const Case given{ { body }, { plane }, op };
    const BooleanResult result = Compute(given);
    CHECK(result.Condition == Status::OpenOperand);
    CheckForm(given, result);
    const Mesh mesh = ResultMesh(given, result);
    CHECK_EQUAL(NumberOfOpenEdges(mesh), 0);
    if ((op == Operation::Difference ? front : behind) == 0)
    {
      CHECK_EQUAL(mesh.Triangles.size(), 0u);
    }
    volume += mesh.Triangles.empty() ? 0.0 : Volume(mesh);
    for (int i = 0; i < 6; ++i)
    {
      const Point p{ Uniform(random, -2.1, 2.1), Uniform(random, -2.1, 2.1),
        Uniform(random, -2.1, 2.1) };
      const bool isFront = Dot(normal, p - through) > 0;
      CHECK_EQUAL(RoundedWinding(mesh, p),
        RoundedWinding(body, p) == 1 && isFront == (op == Operation::Difference) ? 1 : 0);
    }
  }
  CheckNear(volume, Volume(body), Volume(body));
}

/** A sheet that ends inside a body has no inside: it takes nothing away, and says so. */
void SheetThatEndsInside(Random& random)
{
  const Mesh body = Cube(-2, 2);
  const double low =
    Between(random, 0, 1) == 0 ? -1.0 : -3.0; // all inside, or coming in from outside
  const double height = Between(random, -1, 1);
  Mesh sheet = Sheet({ low, -1, height }, { 1, -1, height }, { 1, 1, height }, { low, 1, height });
  if (Between(random, 0, 1) == 0)
  {
    sheet = sheet.Reversed();
  }
  for (const Operation op : { Operation::Difference, Operation::Intersection })
  {
    const Case given{ { body }, { sheet }, op };
    const BooleanResult result = Compute(given);
    CHECK(result.Condition == Status::NonSeparatingSheet);
    const Mesh mesh = ResultMesh(given, result);
    CHECK_EQUAL(NumberOfOpenEdges(mesh), 0);
    CheckNear(
      mesh.Triangles.empty() ? 0.0 : Volume(mesh), op == Operation::Difference ? 64.0 : 0.0, 64.0);
  }
}

/** A tube through a box drills a hole. */
void TubeThroughBox(Random& random)
{
  const int sides = 2 * Between(random, 2, 12);
  const double radius = Between(random, 1, 3) * 0.5;
  const Mesh tube = Tube(radius, -3.0, 3.0, sides);
  const double base =
    0.5 * sides * radius * radius * std::sin(2.0 * 3.14159265358979323846 / sides);
  const Mesh box = Cube(-2, 2);
  const double inside = 4.0 * base;
  const auto volume = [&](Operation op) {
    const Case given{ { box }, { tube }, op };
    const BooleanResult result = Compute(given);
    CHECK(result.Condition == Status::OpenOperand);
    const Mesh mesh = ResultMesh(given, result);
    CHECK_EQUAL(NumberOfOpenEdges(mesh), 0);
    return Volume(mesh);
  };
  CheckNear(volume(Operation::Difference), 64.0 - inside, 64.0);
  CheckNear(volume(Operation::Intersection), inside, 64.0);
}

// --- stopping
// ----------------------------------------------------------------------------------------------------------

/** Says to stop from some call on. */
class StoppingMonitor : public sb::Monitor
{
public:
  explicit StoppingMonitor(int calls)
    : Left(calls)
  {
  }
  bool Aborted() override { return this->Left.fetch_sub(1) <= 0; }
  int NumberLeft() const { return this->Left; }

private:
  std::atomic<int> Left;
};

void Abort(Random& random)
{
  Case given;
  given.Op = AllOperations[Between(random, 0, 4)];
  given.Inputs = { RandomBoxes(random, 0, 4, 3) };
  given.Tools = { RandomBox(random, 0, 4), Sphere({ 2, 2, 2 }, 1.5, 3) };
  sb::SerialExecutor one;
  StoppingMonitor never(1 << 30);
  const BooleanResult whole =
    sb::ComputeBoolean(given.Request(), sb::SeamPoints::PerSide, one, never);
  CHECK(!sb::IsError(whole.Condition));
  const int calls = (1 << 30) - never.NumberLeft();
  CHECK(calls > 5);
  StoppingMonitor stopping(Between(random, 0, calls - 1));
  sb::Executor& executor = Between(random, 0, 1) == 0 ? static_cast<sb::Executor&>(TwoThreads())
                                                      : static_cast<sb::Executor&>(one);
  const BooleanResult result =
    sb::ComputeBoolean(given.Request(), sb::SeamPoints::PerSide, executor, stopping);
  CHECK(result.Condition == Status::Aborted);
  CHECK(result.Fates.empty() && result.PointMap.empty() && result.KeptPoints.empty());
  CHECK(result.Interpolated.empty() && result.Split.Corners.empty());
  CHECK(result.Intersection.Points.empty() && result.Intersection.Connectivity.empty());
}

// --- single cases
// ---------------------------------------------------------------------------------------------------

void CheckBadRequests()
{
  const Mesh box = Cube(0, 1);
  sb::SerialExecutor executor;
  sb::Monitor monitor;
  const auto condition = [&](const sb::BooleanRequest& request) {
    const BooleanResult result =
      sb::ComputeBoolean(request, sb::SeamPoints::PerSide, executor, monitor);
    CHECK(result.Fates.empty() && result.Split.Corners.empty() && result.Interpolated.empty());
    CHECK(!result.Remarks.empty());
    return result.Condition;
  };
  CHECK(condition(sb::BooleanRequest()) == Status::BadRequest);
  Mesh bad = box;
  bad.Triangles[3][1] = 8;
  CHECK(condition(Case{ { box }, { bad }, Operation::Union }.Request()) == Status::BadIndex);
  bad = box;
  bad.Points[3][1] = std::nan("");
  CHECK(condition(Case{ { bad }, { box }, Operation::Union }.Request()) == Status::BadCoordinate);
  bad = box;
  std::swap(bad.Triangles[3][1], bad.Triangles[3][2]);
  CHECK(condition(Case{ { bad }, { box }, Operation::Union }.Request()) ==
    Status::InconsistentOrientation);
}

/** Known figures: two unit overlaps of cubes, and a face in common. */
void CheckKnownFigures()
{
  const auto figures = [](const Mesh& a, const Mesh& b, Operation op) {
    const Mesh mesh = ComputeMesh({ { a }, { b }, op });
    return std::make_pair(Volume(mesh), Area(mesh));
  };
  const Mesh a = Cube(0, 2);
  const Mesh b = Cube(1, 3);
  CHECK(figures(a, b, Operation::Union) == std::make_pair(15.0, 42.0));
  CHECK(figures(a, b, Operation::Intersection) == std::make_pair(1.0, 6.0));
  CHECK(figures(a, b, Operation::Difference) == std::make_pair(7.0, 24.0));
  CHECK(figures(a, b, Operation::SymmetricDifference) == std::make_pair(14.0, 48.0));
  // Beside each other: the common face goes away, and nothing is in both.
  const Mesh c = Box({ 2, 0, 0 }, { 4, 2, 2 });
  CHECK(figures(a, c, Operation::Union) == std::make_pair(16.0, 40.0));
  CHECK(ComputeMesh({ { a }, { c }, Operation::Intersection }).Triangles.empty());
  CHECK(figures(a, c, Operation::Difference) == std::make_pair(8.0, 24.0));
  // A cavity.
  CHECK(figures(Cube(0, 3), b.Translated({ 0, 0, 0 }).Scaled(0.5), Operation::Difference) ==
    std::make_pair(26.0, 60.0));
  // The same surface twice.
  CHECK(figures(a, a, Operation::Union) == std::make_pair(8.0, 24.0));
  CHECK(figures(a, a, Operation::Intersection) == std::make_pair(8.0, 24.0));
  CHECK(ComputeMesh({ { a }, { a }, Operation::Difference }).Triangles.empty());
  CHECK(ComputeMesh({ { a }, { a }, Operation::SymmetricDifference }).Triangles.empty());
  // Two bodies of one operand that share a face, which resolving takes away, or are the same.
  const auto resolved = [](Mesh first, const Mesh& second) {
    first.Append(second);
    const Mesh mesh = ComputeMesh({ { first }, {}, Operation::Resolve });
    return std::make_pair(Volume(mesh), Area(mesh));
  };
  CHECK(resolved(a, c) == std::make_pair(16.0, 40.0));
  CHECK(resolved(a, a) == std::make_pair(8.0, 24.0));
  CHECK(resolved(a, b) == std::make_pair(15.0, 42.0));
  // A shell inside another one of the same operand changes nothing, though only the inner one is
  // met.
  Mesh shells = Cube(0, 10);
  shells.Append(Cube(2, 5));
  const Mesh crossing = Cube(4, 7);
  CHECK(ComputeMesh({ { crossing }, { shells }, Operation::Difference }).Triangles.empty());
  CHECK(figures(crossing, shells, Operation::Intersection) == std::make_pair(27.0, 54.0));
}

// --- running
// ----------------------------------------------------------------------------------------------------------

struct Family
{
  const char* Name;
  void (*Run)(Random&);
  int Cases;
};

constexpr Family Families[] = {
  { "SmallBoxes", SmallBoxes, 500 },
  { "Tetrahedra", Tetrahedra, 500 },
  { "ConvexBodies", ConvexBodies, 300 },
  { "BoxAndConvexBody", BoxAndConvexBody, 300 },
  { "NearCopies", NearCopies, 300 },
  { "RotatedCopies", RotatedCopies, 200 },
  { "Spheres", Spheres, 60 },
  { "SelfOverlapping", SelfOverlapping, 300 },
  { "SelfOverlappingConvex", SelfOverlappingConvex, 300 },
  { "TouchedWhereBodiesOverlap", TouchedWhereBodiesOverlap, 100 },
  { "NestedShells", NestedShells, 100 },
  { "DoubledTriangles", DoubledTriangles, 150 },
  { "Soups", Soups, 200 },
  { "ResolveAlone", ResolveAlone, 300 },
  { "ManyOperands", ManyOperands, 300 },
  { "EmptyOperands", EmptyOperands, 20 },
  { "InsideOut", InsideOut, 100 },
  { "Threads", Threads, 16 },
  { "ShiftsAndScales", ShiftsAndScales, 200 },
  { "SharedSeams", SharedSeams, 200 },
  { "CutByPlane", CutByPlane, 400 },
  { "SheetThatEndsInside", SheetThatEndsInside, 12 },
  { "TubeThroughBox", TubeThroughBox, 20 },
  { "Abort", Abort, 200 },
};

/** @return whether all claims hold. */
bool RunCase(const Family& family, std::uint64_t seed)
{
  const long failures = check::Total().Failures;
  Random random(seed);
  family.Run(random);
  return check::Total().Failures == failures;
}

void RunFamily(const Family& family)
{
  std::vector<std::uint64_t> failed;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(family.Cases); ++seed)
  {
    if (!RunCase(family, seed))
    {
      failed.push_back(seed);
    }
  }
  if (!failed.empty())
  {
    const std::size_t shown = 12;
    std::cerr << failed.size() << " of " << family.Cases << " cases fail, run again as:";
    for (std::size_t i = 0; i < std::min(shown, failed.size()); ++i)
    {
      std::cerr << (i == 0 ? std::string(" TestBoolean ") + family.Name : std::string(" |")) << " "
                << failed[i];
    }
    std::cerr << "\n";
  }
}

} // namespace

int main(int argc, char** argv)
{
  const bool single = argc > 2;
  if (!single)
  {
    CheckBadRequests();
    CheckKnownFigures();
  }
  for (const Family& family : Families)
  {
    if (!single)
    {
      RunFamily(family);
    }
    else if (family.Name == std::string(argv[1]))
    {
      RunCase(family, std::stoull(argv[2]));
    }
  }
  return check::Verdict("TestBoolean");
}
