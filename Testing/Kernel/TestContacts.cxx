// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestContacts.cxx
 * @brief Two triangles meet exactly where rational arithmetic says, and both are told the same.
 */
#include "Check.h"
#include "Contacts.h"
#include "Rational.h"
#include "Shapes.h"

#include <map>
#include <string>

namespace
{

using Places = std::map<rational::Point, std::pair<sb::Location, sb::Location>>;

struct Meeting
{
  Places Ends; ///< of all contacts, with their places on the first and the second triangle
  std::size_t Segments; ///< different ones that are longer than a point
  std::size_t Contacts;
};

char Letter(sb::Location location)
{
  return sb::IsCorner(location) ? 'V' : sb::IsEdge(location) ? 'E' : 'F';
}

/** What is at each end, for the first triangle and the second: "EF VV" is an edge in a face, and
 * two corners. */
std::string Kinds(const Meeting& meeting)
{
  std::vector<std::string> kinds;
  for (const auto& [point, where] : meeting.Ends)
  {
    kinds.emplace_back(1, Letter(where.first));
    kinds.back().push_back(Letter(where.second));
  }
  std::sort(kinds.begin(), kinds.end());
  std::string all;
  for (const std::string& kind : kinds)
  {
    if (!all.empty())
    {
      all.push_back(' ');
    }
    all += kind;
  }
  return all;
}

rational::Triangle TriangleOf(const sb::Scene& scene, std::int32_t face)
{
  const std::array<std::int32_t, 3> corners = scene.Corners(face);
  return { rational::ToPoint(scene.Position(corners[0])),
    rational::ToPoint(scene.Position(corners[1])), rational::ToPoint(scene.Position(corners[2])) };
}

/** One contact is what it says it is. */
void CheckContact(const shapes::Stage& stage, const sb::ContactSet& set, const sb::Contact& contact)
{
  const rational::Triangle own = TriangleOf(stage.World, contact.Face);
  const rational::Triangle other = TriangleOf(stage.World, contact.Other);
  const bool coplanar =
    rational::Cross(rational::Normal(own), rational::Normal(other)) == rational::Point{ 0, 0, 0 };
  CHECK_EQUAL(contact.OtherEdge == -1, !coplanar);
  bool onOneOwnEdge = false;
  for (std::size_t edge = 0; edge < 3; ++edge)
  {
    bool both = true;
    for (const std::int32_t point : contact.Points)
    {
      both = both &&
        rational::InsideEdge(
          own, edge, rational::ToPoint(set.Points[static_cast<std::size_t>(point)].Point)) == 0;
    }
    onOneOwnEdge = onOneOwnEdge || both;
  }
  CHECK(contact.OtherEdge != -2 || onOneOwnEdge);
  for (std::size_t end = 0; end < 2; ++end)
  {
    const sb::ContactPoint& point = set.Points[static_cast<std::size_t>(contact.Points[end])];
    const rational::Point place = rational::ToPoint(point.Point);
    CHECK_EQUAL(int(contact.Ends[end]), int(rational::Locate(own, place)));
    if (contact.OtherEdge >= 0)
    {
      CHECK(rational::InsideEdge(other, static_cast<std::size_t>(contact.OtherEdge), place) == 0);
    }
    if (point.Vertex >= 0)
    {
      CHECK(rational::ToPoint(stage.World.Position(point.Vertex)) == place);
    }
    else
    {
      CHECK(!sb::IsCorner(contact.Ends[end]));
    }
  }
}

Meeting Meet(const shapes::Mesh& a, const shapes::Mesh& b)
{
  shapes::Stage stage({ { a }, { b }, sb::Operation::Union });
  const sb::ContactSet set =
    sb::FindContacts(stage.World, { { 0, 0, 1, 0 } }, {}, stage.Executor, stage.Monitor);
  Meeting meeting{ {}, 0, set.Contacts.size() };
  std::map<std::pair<rational::Point, rational::Point>, int> segments[2];
  for (const sb::Contact& contact : set.Contacts)
  {
    CheckContact(stage, set, contact);
    rational::Point ends[2];
    for (std::size_t end = 0; end < 2; ++end)
    {
      ends[end] =
        rational::ToPoint(set.Points[static_cast<std::size_t>(contact.Points[end])].Point);
      const auto place = meeting.Ends.emplace(ends[end], std::make_pair(-1, -1)).first;
      (contact.Face == 0 ? place->second.first : place->second.second) = contact.Ends[end];
    }
    ++segments[contact.Face][std::minmax(ends[0], ends[1])];
  }
  // The same segments for both.
  CHECK(segments[0] == segments[1]);
  meeting.Segments = static_cast<std::size_t>(std::count_if(segments[0].begin(), segments[0].end(),
    [](const auto& entry) { return entry.first.first != entry.first.second; }));
  for (const auto& [point, where] : meeting.Ends)
  {
    CHECK(where.first >= 0 && where.second >= 0);
  }
  CHECK_EQUAL(set.NumberOfPairs, set.Contacts.empty() ? 0 : 1);
  return meeting;
}

std::vector<rational::Point> PointsOf(const Meeting& meeting)
{
  std::vector<rational::Point> points;
  for (const auto& entry : meeting.Ends)
  {
    points.push_back(entry.first);
  }
  return points;
}

/** The meeting is the set that both have in common, found by cutting one down by the other. */
void CheckAgainstReference(const shapes::Mesh& a, const shapes::Mesh& b)
{
  const Meeting meeting = Meet(a, b);
  shapes::Stage stage({ { a }, { b }, sb::Operation::Union });
  const std::vector<rational::Point> expected =
    rational::Intersection(TriangleOf(stage.World, 0), TriangleOf(stage.World, 1));
  CHECK(PointsOf(meeting) == expected);
  CHECK_EQUAL(
    meeting.Segments, expected.size() < 2 ? 0 : (expected.size() == 2 ? 1 : expected.size()));
}

shapes::Mesh Turned(const shapes::Mesh& triangle, int turn, bool reversed)
{
  shapes::Mesh mesh = reversed ? triangle.Reversed() : triangle;
  std::rotate(mesh.Triangles[0].begin(), mesh.Triangles[0].begin() + turn, mesh.Triangles[0].end());
  return mesh;
}

/** A class of contact, whichever way the corners are listed and whichever triangle comes first. */
void CheckClass(const shapes::Mesh& a, const shapes::Mesh& b, const std::string& kinds,
  const std::string& kindsSwapped)
{
  const std::vector<rational::Point> points = PointsOf(Meet(a, b));
  for (int turnOfA = 0; turnOfA < 3; ++turnOfA)
  {
    for (int turnOfB = 0; turnOfB < 3; ++turnOfB)
    {
      for (int reversal = 0; reversal < 4; ++reversal)
      {
        const shapes::Mesh first = Turned(a, turnOfA, (reversal & 1) != 0);
        const shapes::Mesh second = Turned(b, turnOfB, (reversal & 2) != 0);
        const Meeting meeting = Meet(first, second);
        CHECK(PointsOf(meeting) == points);
        CHECK_EQUAL(Kinds(meeting), kinds);
        const Meeting swapped = Meet(second, first);
        CHECK(PointsOf(swapped) == points);
        CHECK_EQUAL(Kinds(swapped), kindsSwapped);
      }
    }
  }
  CheckAgainstReference(a, b);
}

void CheckClasses()
{
  using shapes::Triangle;
  const shapes::Mesh floor = Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 });
  // In different planes.
  CheckClass(floor, Triangle({ 0, 0, 0 }, { 1, 1, 2 }, { -1, 0, 2 }), "VV", "VV");
  CheckClass(floor, Triangle({ 2, 0, 0 }, { 2, 1, 2 }, { 2, -1, 2 }), "EV", "VE");
  CheckClass(floor, Triangle({ 1, 1, 0 }, { 1, 2, 2 }, { 2, 1, 2 }), "FV", "VF");
  CheckClass(floor, Triangle({ 2, -1, -1 }, { 2, 1, 1 }, { 2, -4, 4 }), "EE", "EE");
  CheckClass(floor, Triangle({ 1, 1, -1 }, { 1, 1, 1 }, { 9, 9, 1 }), "EF FE", "EF FE");
  CheckClass(floor, Triangle({ 1, 1, -1 }, { 1, 2, 1 }, { 2, 1, 1 }), "FE FE", "EF EF");
  CheckClass(floor, Triangle({ 1, 1, 0 }, { 2, 1, 0 }, { 1, 1, 3 }), "FV FV", "VF VF");
  CheckClass(floor, Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 1, 1, 3 }), "VV VV", "VV VV");
  CheckClass(floor, Triangle({ 1, 0, 0 }, { 3, 0, 0 }, { 1, 0, 3 }), "EV EV", "VE VE");
  CheckClass(floor, Triangle({ -1, 0, 0 }, { 9, 0, 0 }, { 1, 0, 3 }), "VE VE", "EV EV");
  CheckClass(floor, Triangle({ -1, 0, 0 }, { 2, 0, 0 }, { 1, -2, 3 }), "EV VE", "EV VE");
  CheckClass(floor, Triangle({ 0, 0, -1 }, { 0, 0, 1 }, { 4, 4, 0 }), "EF VE", "EV FE");
  CheckClass(floor, Triangle({ 1, 1, 1 }, { 1, 2, 1 }, { 2, 1, 1 }), "", "");
  CheckClass(floor, Triangle({ 3, 3, -1 }, { 3, 3, 1 }, { 5, 5, 1 }), "", "");
  // In one plane.
  CheckClass(floor, Triangle({ 0, 0, 0 }, { -4, 0, 0 }, { 0, -4, 0 }), "VV", "VV");
  CheckClass(floor, Triangle({ 2, 0, 0 }, { 1, -2, 0 }, { 3, -2, 0 }), "EV", "VE");
  CheckClass(floor, Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 1, -4, 0 }), "VV VV", "VV VV");
  CheckClass(floor, Triangle({ 1, 0, 0 }, { 3, 0, 0 }, { 1, -4, 0 }), "EV EV", "VE VE");
  CheckClass(floor, Triangle({ 2, 0, 0 }, { 6, 0, 0 }, { 3, -4, 0 }), "EV VE", "EV VE");
  CheckClass(floor, Triangle({ 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 }), "FV FV FV", "VF VF VF");
  CheckClass(floor, Triangle({ -1, -1, 0 }, { 9, -1, 0 }, { -1, 9, 0 }), "VF VF VF", "FV FV FV");
  CheckClass(floor, Triangle({ 0, 4, 0 }, { 0, 0, 0 }, { 4, 0, 0 }), "VV VV VV", "VV VV VV");
  CheckClass(floor, Triangle({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }), "EV EV VV", "VE VE VV");
  CheckClass(Triangle({ 0, 0, 0 }, { 6, 0, 0 }, { 3, 6, 0 }),
    Triangle({ 0, 4, 0 }, { 3, -2, 0 }, { 6, 4, 0 }), "EE EE EE EE EE EE", "EE EE EE EE EE EE");
  CheckClass(floor, Triangle({ 5, 0, 0 }, { 9, 0, 0 }, { 5, 4, 0 }), "", "");
  CheckClass(floor, Triangle({ 3, 3, 0 }, { 5, 3, 0 }, { 3, 5, 0 }), "", "");
}

void CheckRandomPairs()
{
  shapes::Random random(1);
  const auto triangle = [&](int extent) {
    for (;;)
    {
      const shapes::Mesh mesh = shapes::Triangle(shapes::IntegerPoint(random, -extent, extent),
        shapes::IntegerPoint(random, -extent, extent),
        shapes::IntegerPoint(random, -extent, extent));
      if (shapes::Area(mesh) > 0.0)
      {
        return mesh;
      }
    }
  };
  int meeting = 0;
  constexpr int pairs = 1200;
  for (int i = 0; i < pairs; ++i)
  {
    shapes::Mesh a = triangle(1 + i % 3);
    shapes::Mesh b = triangle(1 + i % 3);
    if (i % 4 == 0)
    {
      // In one plane, which is steep or flat.
      const double slope = shapes::Between(random, -1, 1);
      const auto flatten = [&](const shapes::Point& p) {
        return shapes::Point{ p[0], p[1], slope * (p[0] + p[1]) };
      };
      a = a.Mapped(flatten);
      b = b.Mapped(flatten);
      if (shapes::Area(a) == 0.0 || shapes::Area(b) == 0.0)
      {
        continue;
      }
    }
    CheckAgainstReference(a, b);
    meeting += !Meet(a, b).Ends.empty();
  }
  CHECK(meeting > pairs / 4 && meeting < pairs - pairs / 10);
}

/** Coordinates of full length, where the line of two planes has to be found by hundreds of bits. */
void CheckLargeCoordinates()
{
  reference::Random random(2);
  for (int i = 0; i < 80; ++i)
  {
    const auto p = random.Cluster<6>(i % 2 == 0 ? 1000 : reference::LatticeLimit / 2);
    const shapes::Mesh a = shapes::Triangle(p[0], p[1], p[2]);
    CheckAgainstReference(a, shapes::Triangle(p[3], p[4], p[5]));
    CheckAgainstReference(a, shapes::Triangle(p[0], p[4], p[5]));
    CheckAgainstReference(a, shapes::Triangle(p[1], p[0], p[5]));
  }
}

/** Neighbours of one operand touch in what they share; that is no contact, all else is. */
void CheckOneOperand()
{
  const auto contacts = [](const shapes::Mesh& a, const shapes::Mesh& b) {
    shapes::Mesh both = a;
    both.Append(b);
    shapes::Stage stage({ { both }, {}, sb::Operation::Resolve });
    return sb::FindContacts(stage.World, { { 0, 0, 0, 1 } }, {}, stage.Executor, stage.Monitor)
      .Contacts.size();
  };
  using shapes::Triangle;
  const shapes::Mesh floor = Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 });
  CHECK_EQUAL(contacts(floor, Triangle({ 4, 0, 0 }, { 0, 0, 0 }, { 1, 1, 3 })), 0u);
  CHECK_EQUAL(contacts(floor, Triangle({ 4, 0, 0 }, { 0, 0, 0 }, { 1, -1, 0 })), 0u);
  CHECK_EQUAL(contacts(floor, Triangle({ 0, 0, 0 }, { -1, 0, 2 }, { 0, -1, 2 })), 0u);
  CHECK(contacts(floor, Triangle({ 0, 0, 0 }, { 3, 0, 0 }, { 1, -1, 0 })) > 0);
  CHECK(contacts(floor, Triangle({ 0, 0, 0 }, { 2, 2, 0 }, { 1, -1, 3 })) > 0);
  CHECK(contacts(floor, Triangle({ 1, 1, 0 }, { 2, 2, 1 }, { 1, -1, 3 })) > 0);
}

/** Collapsed faces are skipped; ranges of pairs come out in order. */
void CheckSet()
{
  shapes::Stage stage(
    { { shapes::Sphere({ 0, 0, 0 }, 1.0, 6) }, { shapes::Cube(-0.7, 0.7) }, sb::Operation::Union });
  std::vector<sb::TrianglePair> pairs;
  for (std::int32_t i = 0; i < stage.World.FirstFace(1); ++i)
  {
    for (std::int32_t j = 0; j < 12; ++j)
    {
      pairs.push_back({ 0, i, 1, j });
    }
  }
  CHECK(pairs.size() > 2048); // several ranges
  const sb::ContactSet set =
    sb::FindContacts(stage.World, pairs, {}, stage.Executor, stage.Monitor);
  CHECK(set.Contacts.size() > 100);
  CHECK(std::is_sorted(
    set.Contacts.begin(), set.Contacts.end(), [](const sb::Contact& l, const sb::Contact& r) {
      return std::make_pair(l.Face, l.Other) < std::make_pair(r.Face, r.Other);
    }));
  for (const sb::Contact& contact : set.Contacts)
  {
    CheckContact(stage, set, contact);
  }
  std::vector<std::uint8_t> collapsed(static_cast<std::size_t>(stage.World.NumberOfFaces()), 0);
  const std::int32_t skipped = set.Contacts.front().Face;
  collapsed[static_cast<std::size_t>(skipped)] = 1;
  const sb::ContactSet fewer =
    sb::FindContacts(stage.World, pairs, collapsed, stage.Executor, stage.Monitor);
  CHECK(fewer.Contacts.size() < set.Contacts.size());
  for (const sb::Contact& contact : fewer.Contacts)
  {
    CHECK(contact.Face != skipped && contact.Other != skipped);
  }
}

} // namespace

int main()
{
  CheckClasses();
  CheckRandomPairs();
  CheckLargeCoordinates();
  CheckOneOperand();
  CheckSet();
  return check::Verdict("TestContacts");
}
