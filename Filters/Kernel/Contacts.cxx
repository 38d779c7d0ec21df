// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Contacts.h"

#include "ParallelSort.h"

#include <algorithm>

namespace sb
{

namespace
{

struct Triangle
{
  std::int32_t Face;
  std::array<std::int32_t, 3> Vertices;
  const double* P[3];
};

Triangle MakeTriangle(const Scene& scene, std::int32_t operand, std::int32_t triangle)
{
  Triangle result;
  result.Face = scene.FirstFace(operand) + triangle;
  result.Vertices = scene.Corners(operand, result.Face);
  for (int i = 0; i < 3; ++i)
  {
    result.P[i] = scene.Position(result.Vertices[i]);
  }
  return result;
}

/**
 * One end of a chord: where a triangle's boundary meets a line or plane. Below and Above are the
 * corners of the edge that meets it, on its negative and positive side. Where the end is a corner,
 * one of the two is that corner.
 */
struct ChordEnd
{
  Location Where;
  std::int8_t Below;
  std::int8_t Above;
};

ChordEnd CrossingEdge(int from, int to, const int signs[3])
{
  const auto edge = static_cast<Location>((from + 1) % 3 == to ? 3 + from : 3 + to);
  return signs[from] < 0
    ? ChordEnd{ edge, static_cast<std::int8_t>(from), static_cast<std::int8_t>(to) }
    : ChordEnd{ edge, static_cast<std::int8_t>(to), static_cast<std::int8_t>(from) };
}

ChordEnd CornerEnd(int corner, const int signs[3])
{
  const int other = signs[(corner + 1) % 3] != 0 ? (corner + 1) % 3 : (corner + 2) % 3;
  return signs[other] > 0 ? ChordEnd{ static_cast<Location>(corner),
    static_cast<std::int8_t>(corner), static_cast<std::int8_t>(other) }
                          : ChordEnd{ static_cast<Location>(corner),
                              static_cast<std::int8_t>(other), static_cast<std::int8_t>(corner) };
}

struct Chord
{
  ChordEnd Ends[2];
  bool IsPoint;
  Location Inside; ///< where points strictly between the ends lie: interior, or the edge that the
                   ///< chord runs along
};

/**
 * The chord of a triangle whose corners have these signs (not all equal in sign, not all zero), in
 * the order that a counter-clockwise triangle meets a line which has its positive side on the left:
 * first end first.
 */
Chord MakeChord(const int signs[3])
{
  int positive = 0;
  int zero = 0;
  for (int i = 0; i < 3; ++i)
  {
    positive += signs[i] > 0;
    zero += signs[i] == 0;
  }
  const int negative = 3 - positive - zero;
  Chord chord;
  chord.IsPoint = false;
  chord.Inside = Interior;

  // The corner that is alone on its side; the chord cuts it off.
  int apex = 0;
  const int apexSign = positive == 1 ? 1 : (negative == 1 ? -1 : 0);
  while (signs[apex] != apexSign)
  {
    ++apex;
  }
  if (apexSign == 0)
  {
    chord.Ends[0] = chord.Ends[1] = CornerEnd(apex, signs);
    chord.IsPoint = true;
    return chord;
  }
  const int next = (apex + 1) % 3;
  const int last = (apex + 2) % 3;
  const ChordEnd atNext =
    signs[next] == 0 ? CornerEnd(next, signs) : CrossingEdge(apex, next, signs);
  const ChordEnd atLast =
    signs[last] == 0 ? CornerEnd(last, signs) : CrossingEdge(apex, last, signs);
  chord.Ends[0] = apexSign > 0 ? atNext : atLast;
  chord.Ends[1] = apexSign > 0 ? atLast : atNext;
  if (zero == 2)
  {
    chord.Inside = static_cast<Location>(3 + next);
  }
  return chord;
}

bool OnOneSide(const int signs[3])
{
  return (signs[0] > 0 && signs[1] > 0 && signs[2] > 0) ||
    (signs[0] < 0 && signs[1] < 0 && signs[2] < 0);
}

bool HaveSameCorners(const Triangle& a, const Triangle& b)
{
  return std::all_of(std::begin(a.P), std::end(a.P), [&](const double* p) {
    return std::any_of(std::begin(b.P), std::end(b.P),
      [&](const double* q) { return p[0] == q[0] && p[1] == q[1] && p[2] == q[2]; });
  });
}

/** Marks the corners of `a` that are corners of `b`, too. */
std::array<bool, 3> CommonCorners(const Triangle& a, const Triangle& b)
{
  std::array<bool, 3> common;
  for (std::size_t i = 0; i < 3; ++i)
  {
    common[i] = std::any_of(std::begin(b.P), std::end(b.P),
      [&](const double* q) { return a.P[i][0] == q[0] && a.P[i][1] == q[1] && a.P[i][2] == q[2]; });
  }
  return common;
}

/**
 * Whether all corners of `b` that are not corners of `a` are off a's plane on one side: then the
 * two have but those corners in common, or the edge between them. Most pairs of one operand are
 * such neighbours, and the signs of their common corners, which are 0, need not be computed.
 */
bool MeetInCornersOnly(const Triangle& a, const Triangle& b, const std::array<bool, 3>& commonOfB)
{
  int side = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (!commonOfB[i])
    {
      const int sign = Orient3D(a.P[0], a.P[1], a.P[2], b.P[i]);
      if (sign == 0 || sign == -side)
      {
        return false;
      }
      side = sign;
    }
  }
  return side != 0;
}

/** Collects what the pairs of one range of the pair list give. */
class Collector
{
public:
  explicit Collector(const Scene& scene)
    : World(&scene)
  {
  }

  void Intersect(const Triangle& a, const Triangle& b, bool sameOperand)
  {
    if (sameOperand && this->AreNeighboursApart(a, b))
    {
      return;
    }
    int signsOfA[3];
    int signsOfB[3];
    for (int i = 0; i < 3; ++i)
    {
      signsOfB[i] = Orient3D(a.P[0], a.P[1], a.P[2], b.P[i]);
    }
    if (OnOneSide(signsOfB))
    {
      return;
    }
    // Two copies of one triangle have all edges in common, but they also overlap.
    this->SkipsCommonEdges = sameOperand && !HaveSameCorners(a, b);
    const std::size_t before = this->Contacts.size();
    if (signsOfB[0] == 0 && signsOfB[1] == 0 && signsOfB[2] == 0)
    {
      this->IntersectCoplanar(a, b);
    }
    else
    {
      for (int i = 0; i < 3; ++i)
      {
        signsOfA[i] = Orient3D(b.P[0], b.P[1], b.P[2], a.P[i]);
      }
      if (OnOneSide(signsOfA))
      {
        return;
      }
      this->IntersectCrossing(a, signsOfA, b, signsOfB);
    }
    this->NumberOfPairs += this->Contacts.size() > before;
  }

  std::vector<Contact> Contacts;
  std::vector<ContactPoint> Points;
  std::int64_t NumberOfPairs = 0;

private:
  static bool AreNeighboursApart(const Triangle& a, const Triangle& b)
  {
    const std::array<bool, 3> ofB = CommonCorners(b, a);
    return (ofB[0] || ofB[1] || ofB[2]) &&
      (MeetInCornersOnly(a, b, ofB) || MeetInCornersOnly(b, a, CommonCorners(a, b)));
  }

  /** An end of a contact, as both triangles see it. */
  struct End
  {
    Location OnA;
    Location OnB;
    std::int32_t Point;
  };

  void IntersectCrossing(
    const Triangle& a, const int signsOfA[3], const Triangle& b, const int signsOfB[3])
  {
    // Along the cross product of the normals, a triangle is met clockwise seen from its plane's
    // other side: hence the second chord is taken as it comes, the first one reversed.
    const Chord p = Reversed(MakeChord(signsOfA));
    const Chord q = MakeChord(signsOfB);
    const auto order = [&](const ChordEnd& ofA, const ChordEnd& ofB) {
      return -Orient3D(a.P[ofA.Below], a.P[ofA.Above], b.P[ofB.Below], b.P[ofB.Above]);
    };

    const int endToStart = order(p.Ends[1], q.Ends[0]);
    const int startToEnd = order(p.Ends[0], q.Ends[1]);
    if (endToStart < 0 || startToEnd > 0)
    {
      return;
    }
    const auto at = [&](const ChordEnd* ofA, const ChordEnd* ofB) {
      return this->MakeEnd(a, b, ofA, p.Inside, ofB, q.Inside);
    };
    End ends[2];
    if (endToStart == 0)
    {
      ends[0] = ends[1] = at(&p.Ends[1], &q.Ends[0]);
    }
    else if (startToEnd == 0)
    {
      ends[0] = ends[1] = at(&p.Ends[0], &q.Ends[1]);
    }
    else if (p.IsPoint)
    {
      ends[0] = ends[1] = at(&p.Ends[0], nullptr);
    }
    else if (q.IsPoint)
    {
      ends[0] = ends[1] = at(nullptr, &q.Ends[0]);
    }
    else
    {
      // The overlap starts at the later start and ends at the earlier end.
      const int starts = order(p.Ends[0], q.Ends[0]);
      const int stops = order(p.Ends[1], q.Ends[1]);
      ends[0] = at(starts >= 0 ? &p.Ends[0] : nullptr, starts <= 0 ? &q.Ends[0] : nullptr);
      ends[1] = at(stops <= 0 ? &p.Ends[1] : nullptr, stops >= 0 ? &q.Ends[1] : nullptr);
    }
    this->Add(a, b, -1, -1, ends);
  }

  static Chord Reversed(Chord chord)
  {
    std::swap(chord.Ends[0], chord.Ends[1]);
    return chord;
  }

  /** The end of a contact at an end of a's chord, of b's chord, or of both. */
  End MakeEnd(const Triangle& a, const Triangle& b, const ChordEnd* ofA, Location insideA,
    const ChordEnd* ofB, Location insideB)
  {
    End end;
    end.OnA = ofA ? ofA->Where : insideA;
    end.OnB = ofB ? ofB->Where : insideB;
    if (ofA && IsCorner(ofA->Where))
    {
      end.Point = this->AddVertex(a.Vertices[ofA->Where]);
    }
    else if (ofB && IsCorner(ofB->Where))
    {
      end.Point = this->AddVertex(b.Vertices[ofB->Where]);
    }
    else if (ofA)
    {
      end.Point = this->AddPoint(
        ExactPoint::LinePlane(a.P[ofA->Below], a.P[ofA->Above], b.P[0], b.P[1], b.P[2]));
    }
    else
    {
      end.Point = this->AddPoint(
        ExactPoint::LinePlane(b.P[ofB->Below], b.P[ofB->Above], a.P[0], a.P[1], a.P[2]));
    }
    return end;
  }

  void IntersectCoplanar(const Triangle& a, const Triangle& b)
  {
    const std::size_t before = this->Contacts.size();
    const DominantNormal normalOfA = ComputeDominantNormal(a.P[0], a.P[1], a.P[2]);
    const int turnOfB = Orient2D(b.P[0], b.P[1], b.P[2], normalOfA.Axis);
    for (int edge = 0; edge < 3; ++edge)
    {
      this->IntersectEdge(a, edge, b, turnOfB, normalOfA.Axis, false);
      this->IntersectEdge(b, edge, a, normalOfA.Sign, normalOfA.Axis, true);
    }
    this->DropRepeated(before);
  }

  /** Whether two points are at one place; new points never are at a vertex. */
  bool IsSamePlace(std::int32_t a, std::int32_t b) const
  {
    const ContactPoint& p = this->Points[std::size_t(a)];
    const ContactPoint& q = this->Points[std::size_t(b)];
    return a == b || (p.Vertex >= 0 && q.Vertex >= 0 && SamePoint(p.Point, q.Point));
  }

  /**
   * Coplanar triangles that have a corner or a part of an edge in common come upon it up to six
   * times. Of the contacts from `before` on, keep each segment once, and points that are on none.
   */
  void DropRepeated(std::size_t before)
  {
    this->Found.assign(
      this->Contacts.begin() + static_cast<std::ptrdiff_t>(before), this->Contacts.end());
    this->Contacts.resize(before);
    for (const bool points : { false, true })
    {
      for (std::size_t i = 0; i < this->Found.size(); i += 2)
      {
        const bool isPoint = this->Found[i].Points[0] == this->Found[i].Points[1];
        if (isPoint == points && !this->IsKnown(this->Found[i], before))
        {
          this->Contacts.push_back(this->Found[i]);
          this->Contacts.push_back(this->Found[i + 1]);
        }
      }
    }
  }

  /** Whether a contact is among those from `before` on, or an end of one of them. */
  bool IsKnown(const Contact& contact, std::size_t before) const
  {
    const auto [first, last] = contact.Points;
    for (std::size_t i = before; i < this->Contacts.size(); i += 2)
    {
      const auto [start, end] = this->Contacts[i].Points;
      if ((this->IsSamePlace(first, start) &&
            this->IsSamePlace(last, first == last ? start : end)) ||
        (this->IsSamePlace(first, end) && this->IsSamePlace(last, first == last ? end : start)))
      {
        return true;
      }
    }
    return false;
  }

  /** The part of an edge of `a` that lies in the coplanar triangle `b`; `turn` is b's orientation
   * in the projection. */
  void IntersectEdge(
    const Triangle& a, int edge, const Triangle& b, int turn, int axis, bool swapped)
  {
    const int head = (edge + 1) % 3;
    const double* u = a.P[edge];
    const double* v = a.P[head];
    int signs[3];
    for (int i = 0; i < 3; ++i)
    {
      signs[i] = Orient2D(u, v, b.P[i], axis);
    }
    if (OnOneSide(signs))
    {
      return;
    }
    Chord chord = MakeChord(signs);
    if (turn < 0)
    {
      chord = Reversed(chord);
    }
    // The sign of (point - chord end) along the edge.
    const auto order = [&](const double* point, const ChordEnd& end) {
      return -Orient2D(b.P[end.Below], b.P[end.Above], point, axis);
    };

    if (order(v, chord.Ends[0]) < 0 || order(u, chord.Ends[1]) > 0)
    {
      return;
    }
    const auto along = static_cast<Location>(3 + edge);
    const auto atChordEnd = [&](const ChordEnd& end) {
      return End{ along, end.Where,
        IsCorner(end.Where)
          ? this->AddVertex(b.Vertices[end.Where])
          : this->AddPoint(ExactPoint::LineLine(u, v, b.P[end.Below], b.P[end.Above], axis)) };
    };
    const auto atCorner = [&](int corner, Location onB) {
      return End{ static_cast<Location>(corner), onB, this->AddVertex(a.Vertices[corner]) };
    };

    End ends[2];
    if (order(v, chord.Ends[0]) == 0)
    {
      ends[0] = ends[1] = atCorner(head, chord.Ends[0].Where);
    }
    else if (order(u, chord.Ends[1]) == 0)
    {
      ends[0] = ends[1] = atCorner(edge, chord.Ends[1].Where);
    }
    else if (chord.IsPoint)
    {
      ends[0] = ends[1] = atChordEnd(chord.Ends[0]);
    }
    else
    {
      const int start = order(u, chord.Ends[0]);
      const int stop = order(v, chord.Ends[1]);
      ends[0] = start < 0 ? atChordEnd(chord.Ends[0])
                          : atCorner(edge, start == 0 ? chord.Ends[0].Where : chord.Inside);
      ends[1] = stop > 0 ? atChordEnd(chord.Ends[1])
                         : atCorner(head, stop == 0 ? chord.Ends[1].Where : chord.Inside);
    }
    if (swapped)
    {
      std::swap(ends[0].OnA, ends[0].OnB);
      std::swap(ends[1].OnA, ends[1].OnB);
      this->Add(b, a, static_cast<std::int8_t>(edge), -2, ends);
    }
    else
    {
      this->Add(a, b, -2, static_cast<std::int8_t>(edge), ends);
    }
  }

  /**
   * Record the contact for both triangles. The carriers say what draws its line: an edge of the
   * other triangle, -1 the other's plane, -2 the triangle's own edge (then nothing has to be drawn
   * but the edge itself).
   */
  void Add(const Triangle& a, const Triangle& b, std::int8_t carrierOnA, std::int8_t carrierOnB,
    const End ends[2])
  {
    if (this->SkipsCommonEdges && IsCorner(ends[0].OnA) && IsCorner(ends[0].OnB) &&
      IsCorner(ends[1].OnA) && IsCorner(ends[1].OnB))
    {
      return; // a corner or an edge that the two have in common
    }
    this->Contacts.push_back({ a.Face, b.Face, carrierOnA, { ends[0].OnA, ends[1].OnA },
      { ends[0].Point, ends[1].Point } });
    this->Contacts.push_back({ b.Face, a.Face, carrierOnB, { ends[0].OnB, ends[1].OnB },
      { ends[0].Point, ends[1].Point } });
  }

  /** Where many faces meet, a vertex comes up again and again: it is looked for among the last. */
  std::int32_t AddVertex(std::int32_t vertex)
  {
    this->Recent.resize(256, { -1, -1 });
    auto& [known, point] = this->Recent[static_cast<std::size_t>(vertex) % this->Recent.size()];
    if (known != vertex)
    {
      this->Points.push_back({ ExactPoint::Vertex(this->World->Position(vertex)), vertex });
      known = vertex;
      point = static_cast<std::int32_t>(this->Points.size() - 1);
    }
    return point;
  }

  std::int32_t AddPoint(const ExactPoint& point)
  {
    this->Points.push_back({ point, -1 });
    return static_cast<std::int32_t>(this->Points.size() - 1);
  }

  const Scene* World;
  bool SkipsCommonEdges = false;
  std::vector<Contact> Found;
  std::vector<std::pair<std::int32_t, std::int32_t>> Recent; ///< vertices and their points
};

} // namespace

ContactSet FindContacts(const Scene& scene, const std::vector<TrianglePair>& pairs,
  const std::vector<std::uint8_t>& collapsed, Executor& executor, Monitor& monitor)
{
  // Fixed ranges, so that the result does not depend on the threads.
  constexpr std::int64_t rangeSize = 2048;
  const auto numberOfPairs = static_cast<std::int64_t>(pairs.size());
  const std::int64_t numberOfRanges = (numberOfPairs + rangeSize - 1) / rangeSize;
  std::vector<Collector> collectors(static_cast<std::size_t>(numberOfRanges), Collector(scene));
  executor.For(numberOfRanges, 1, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t range = begin; range < end && !monitor.Aborted(); ++range)
    {
      const std::int64_t stop = std::min(numberOfPairs, (range + 1) * rangeSize);
      for (std::int64_t i = range * rangeSize; i < stop; ++i)
      {
        const TrianglePair& pair = pairs[std::size_t(i)];
        const Triangle a = MakeTriangle(scene, pair.SurfaceA, pair.TriangleA);
        const Triangle b = MakeTriangle(scene, pair.SurfaceB, pair.TriangleB);
        if (collapsed.empty() ||
          (!collapsed[std::size_t(a.Face)] && !collapsed[std::size_t(b.Face)]))
        {
          collectors[std::size_t(range)].Intersect(a, b, pair.SurfaceA == pair.SurfaceB);
        }
      }
    }
  });

  ContactSet result;
  for (Collector& collector : collectors)
  {
    const auto offset = static_cast<std::int32_t>(result.Points.size());
    for (Contact contact : collector.Contacts)
    {
      contact.Points[0] += offset;
      contact.Points[1] += offset;
      result.Contacts.push_back(contact);
    }
    result.Points.insert(result.Points.end(), collector.Points.begin(), collector.Points.end());
    result.NumberOfPairs += collector.NumberOfPairs;
    collector = Collector(scene);
  }
  ParallelSort(
    result.Contacts,
    [](const Contact& l, const Contact& r) {
      return l.Face != r.Face        ? l.Face < r.Face
        : l.Other != r.Other         ? l.Other < r.Other
        : l.Points[0] != r.Points[0] ? l.Points[0] < r.Points[0]
        : l.Points[1] != r.Points[1] ? l.Points[1] < r.Points[1]
                                     : l.OtherEdge < r.OtherEdge;
    },
    executor);
  return result;
}

} // namespace sb
