// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shapes.h
 * @brief Surfaces to feed the kernel with, and measures of what it gives back that share no code
 * with it.
 */
#ifndef sb_Shapes_h
#define sb_Shapes_h

#include "Arrangement.h"
#include "Boolean.h"
#include "BroadPhase.h"
#include "CollapsedFaces.h"
#include "Contacts.h"
#include "Ingest.h"
#include "Scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace shapes
{

using Point = std::array<double, 3>;
using Corners = std::array<std::int32_t, 3>;

inline Point operator+(const Point& a, const Point& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Point operator-(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point operator*(double factor, const Point& a)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double Length(const Point& a) { return std::sqrt(Dot(a, a)); }

// --- surfaces
// -------------------------------------------------------------------------------------------------------

struct Mesh
{
  std::vector<Point> Points;
  std::vector<Corners> Triangles;

  sb::Surface View() const
  {
    return { this->Points.empty() ? nullptr : this->Points.front().data(),
      static_cast<std::int64_t>(this->Points.size()),
      this->Triangles.empty() ? nullptr : this->Triangles.front().data(),
      static_cast<std::int64_t>(this->Triangles.size()) };
  }

  const Point& At(const Corners& triangle, std::size_t corner) const
  {
    return this->Points[static_cast<std::size_t>(triangle[corner])];
  }

  void Append(const Mesh& other)
  {
    const auto first = static_cast<std::int32_t>(this->Points.size());
    this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
    for (const Corners& t : other.Triangles)
    {
      this->Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
  }

  void AddTriangle(const Point& a, const Point& b, const Point& c)
  {
    const auto first = static_cast<std::int32_t>(this->Points.size());
    for (const Point* p : { &a, &b, &c })
    {
      this->Points.push_back(*p);
    }
    this->Triangles.push_back({ first, first + 1, first + 2 });
  }

  template <class Map>
  Mesh Mapped(Map&& map) const
  {
    Mesh result(*this);
    for (Point& p : result.Points)
    {
      p = map(p);
    }
    return result;
  }

  Mesh Translated(const Point& by) const
  {
    return this->Mapped([&](const Point& p) { return p + by; });
  }

  Mesh Scaled(double by) const
  {
    return this->Mapped([&](const Point& p) { return by * p; });
  }

  /** Every triangle turned over. */
  Mesh Reversed() const
  {
    Mesh result(*this);
    for (Corners& t : result.Triangles)
    {
      std::swap(t[1], t[2]);
    }
    return result;
  }
};

inline Mesh Triangle(const Point& a, const Point& b, const Point& c)
{
  Mesh mesh;
  mesh.AddTriangle(a, b, c);
  return mesh;
}

/** Low corner, high corner; its edges and their diagonals on integers where the corners are. */
inline Mesh Box(const Point& low, const Point& high)
{
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.Points.push_back(
      { i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2] });
  }
  mesh.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return mesh;
}

inline Mesh Cube(double low, double high) { return Box({ low, low, low }, { high, high, high }); }

/** The convex hull of integer points, its coplanar parts fanned; empty if they lie in one plane. */
inline Mesh ConvexHull(std::vector<Point> points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Mesh mesh;
  mesh.Points = points;
  std::set<std::vector<std::size_t>> done;
  const std::size_t count = points.size();
  for (std::size_t a = 0; a < count; ++a)
  {
    for (std::size_t b = 0; b < count; ++b)
    {
      for (std::size_t c = a + 1; c < count; ++c)
      {
        const Point normal = Cross(points[b] - points[a], points[c] - points[a]);
        std::vector<std::size_t> facet;
        bool below = false;
        bool above = Dot(normal, normal) == 0.0;
        for (std::size_t i = 0; i < count && !above; ++i)
        {
          const double height = Dot(normal, points[i] - points[a]);
          above = height > 0.0;
          below = below || height < 0.0;
          if (height == 0.0)
          {
            facet.push_back(i);
          }
        }
        if (above || !below || !done.insert(facet).second)
        {
          continue;
        }
        // Walk around the facet: the next corner has all others on its left, and is the farthest of
        // those in line.
        std::vector<std::size_t> ring{ *std::min_element(facet.begin(), facet.end()) };
        do
        {
          const std::size_t here = ring.back();
          std::size_t next = here;
          for (const std::size_t i : facet)
          {
            const double turn =
              Dot(normal, Cross(points[next] - points[here], points[i] - points[here]));
            if (i != here &&
              (next == here || turn < 0.0 ||
                (turn == 0.0 &&
                  Length(points[i] - points[here]) > Length(points[next] - points[here]))))
            {
              next = i;
            }
          }
          ring.push_back(next);
        } while (ring.back() != ring.front());
        for (std::size_t i = 1; i + 2 < ring.size(); ++i)
        {
          mesh.Triangles.push_back({ static_cast<std::int32_t>(ring[0]),
            static_cast<std::int32_t>(ring[i]), static_cast<std::int32_t>(ring[i + 1]) });
        }
      }
    }
  }
  return mesh;
}

/** An octahedron, each face divided into `divisions` squared, pushed out to the sphere. */
inline Mesh Sphere(const Point& centre, double radius, int divisions)
{
  Mesh mesh;
  std::map<std::array<int, 3>, std::int32_t> known;
  const auto at = [&](const std::array<int, 3>& place) {
    const auto [it, isNew] = known.emplace(place, static_cast<std::int32_t>(mesh.Points.size()));
    if (isNew)
    {
      const Point p{ double(place[0]), double(place[1]), double(place[2]) };
      mesh.Points.push_back(centre + (radius / Length(p)) * p);
    }
    return it->second;
  };
  for (int octant = 0; octant < 8; ++octant)
  {
    const int x = octant & 1 ? -1 : 1;
    const int y = octant & 2 ? -1 : 1;
    const int z = octant & 4 ? -1 : 1;
    const auto add = [&](const std::array<int, 3>& a, const std::array<int, 3>& b,
                       const std::array<int, 3>& c) {
      x* y* z > 0 ? mesh.Triangles.push_back({ at(a), at(b), at(c) })
                  : mesh.Triangles.push_back({ at(a), at(c), at(b) });
    };
    const auto corner = [&](int i, int j) {
      return std::array<int, 3>{ x * (divisions - i - j), y * i, z * j };
    };
    for (int i = 0; i < divisions; ++i)
    {
      for (int j = 0; i + j < divisions; ++j)
      {
        add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 1 < divisions)
        {
          add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
      }
    }
  }
  return mesh;
}

/** A flat quadrangle in two triangles, counter-clockwise as seen from its front. */
inline Mesh Sheet(const Point& a, const Point& b, const Point& c, const Point& d)
{
  Mesh mesh;
  mesh.Points = { a, b, c, d };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return mesh;
}

/** The wall of a prism along z over a regular polygon, outward oriented, without its ends. */
inline Mesh Tube(double radius, double low, double high, int sides)
{
  Mesh mesh;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / sides;
    mesh.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle), low });
    mesh.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle), high });
    const std::int32_t here = 2 * i;
    const std::int32_t next = 2 * ((i + 1) % sides);
    mesh.Triangles.push_back({ here, next, next + 1 });
    mesh.Triangles.push_back({ here, next + 1, here + 1 });
  }
  return mesh;
}

// --- random surfaces
// ------------------------------------------------------------------------------------------------

using Random = std::mt19937_64;

inline int Between(Random& random, int low, int high)
{
  return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

inline double Uniform(Random& random, double low, double high)
{
  return low + (high - low) * (static_cast<double>(random() >> 11) / 9007199254740992.0);
}

inline Point IntegerPoint(Random& random, int low, int high)
{
  const double x = Between(random, low, high);
  const double y = Between(random, low, high);
  const double z = Between(random, low, high);
  return { x, y, z };
}

/** Corners at integers in [low, high]. */
inline Mesh RandomBox(Random& random, int low, int high)
{
  Point a;
  Point b;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int from = Between(random, low, high - 1);
    a[axis] = from;
    b[axis] = Between(random, from + 1, high);
  }
  return Box(a, b);
}

/** The hull of `count` points at integers in [low, high]; never empty. */
inline Mesh RandomConvex(Random& random, int low, int high, int count)
{
  for (;;)
  {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i)
    {
      points.push_back(IntegerPoint(random, low, high));
    }
    Mesh mesh = ConvexHull(points);
    if (!mesh.Triangles.empty())
    {
      return mesh;
    }
  }
}

/** Boxes in one surface, overlapping, touching or not. */
inline Mesh RandomBoxes(Random& random, int low, int high, int count)
{
  Mesh mesh;
  for (int i = 0; i < count; ++i)
  {
    mesh.Append(RandomBox(random, low, high));
  }
  return mesh;
}

/** A map that turns about the origin by a random angle around a random axis. */
inline std::array<Point, 3> RandomRotation(Random& random)
{
  double q[4];
  double norm = 0.0;
  do
  {
    norm = 0.0;
    for (double& x : q)
    {
      x = Uniform(random, -1.0, 1.0);
      norm += x * x;
    }
  } while (norm < 0.01 || norm > 1.0);
  for (double& x : q)
  {
    x /= std::sqrt(norm);
  }
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return { Point{ 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y) },
    Point{ 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x) },
    Point{ 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y) } };
}

inline Mesh Rotated(const Mesh& mesh, const std::array<Point, 3>& rows)
{
  return mesh.Mapped([&](const Point& p) {
    return Point{ Dot(rows[0], p), Dot(rows[1], p), Dot(rows[2], p) };
  });
}

// --- measures
// -------------------------------------------------------------------------------------------------------

inline double Volume(const Mesh& mesh)
{
  long double sum = 0.0L;
  for (const Corners& t : mesh.Triangles)
  {
    const Point& origin = mesh.Points.front();
    sum += Dot(
      mesh.At(t, 0) - origin, Cross(mesh.At(t, 1) - mesh.At(t, 0), mesh.At(t, 2) - mesh.At(t, 0)));
  }
  return static_cast<double>(sum / 6.0L);
}

inline double Area(const Mesh& mesh)
{
  long double sum = 0.0L;
  for (const Corners& t : mesh.Triangles)
  {
    sum += Length(Cross(mesh.At(t, 1) - mesh.At(t, 0), mesh.At(t, 2) - mesh.At(t, 0)));
  }
  return static_cast<double>(sum / 2.0L);
}

/** How many edges are not used as often one way as the other; `name` tells which corners are the
 * same. */
template <class Name>
std::int64_t NumberOfOpenEdges(const Mesh& mesh, Name&& name)
{
  using Key = decltype(name(std::int32_t()));
  std::map<std::pair<Key, Key>, std::int64_t> balance;
  for (const Corners& t : mesh.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Key from = name(t[i]);
      const Key to = name(t[(i + 1) % 3]);
      if (from < to)
      {
        ++balance[{ from, to }];
      }
      else if (to < from)
      {
        --balance[{ to, from }];
      }
    }
  }
  return std::count_if(
    balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; });
}

/** Corners are the same where their coordinates are, exactly. */
inline std::int64_t NumberOfOpenEdges(const Mesh& mesh)
{
  return NumberOfOpenEdges(
    mesh, [&](std::int32_t id) { return mesh.Points[static_cast<std::size_t>(id)] + Point{}; });
}

/** Corners are the same where their ids are. */
inline std::int64_t NumberOfOpenEdgesById(const Mesh& mesh)
{
  return NumberOfOpenEdges(mesh, [](std::int32_t id) { return id; });
}

/** The winding number by the sum of solid angles (van Oosterom and Strackee 1983); an integer off a
 * closed surface. */
inline double Winding(const Mesh& mesh, const Point& p)
{
  double sum = 0.0;
  for (const Corners& t : mesh.Triangles)
  {
    const Point a = mesh.At(t, 0) - p;
    const Point b = mesh.At(t, 1) - p;
    const Point c = mesh.At(t, 2) - p;
    const double la = Length(a);
    const double lb = Length(b);
    const double lc = Length(c);
    sum += std::atan2(
      Dot(a, Cross(b, c)), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
  }
  return sum / (2.0 * 3.14159265358979323846);
}

// --- the kernel
// -----------------------------------------------------------------------------------------------------

/** A request and the surfaces it looks at. */
struct Case
{
  std::vector<Mesh> Inputs;
  std::vector<Mesh> Tools;
  sb::Operation Op = sb::Operation::Union;

  sb::BooleanRequest Request() const
  {
    sb::BooleanRequest request;
    request.Op = this->Op;
    for (std::size_t i = 0; i < this->NumberOfOperands(); ++i)
    {
      request.Operands.emplace_back();
      request.Operands.back().Mesh = this->Operand(i).View();
      request.Operands.back().Side = i < this->Inputs.size() ? sb::Group::Input : sb::Group::Tool;
    }
    return request;
  }

  const Mesh& Operand(std::size_t i) const
  {
    return i < this->Inputs.size() ? this->Inputs[i] : this->Tools[i - this->Inputs.size()];
  }
  std::size_t NumberOfOperands() const { return this->Inputs.size() + this->Tools.size(); }
};

/** The surface that a result describes, its points numbered as the result numbers them. */
inline Mesh ResultMesh(const Case& given, const sb::BooleanResult& result)
{
  Mesh mesh;
  for (std::size_t operand = 0; operand < result.KeptPoints.size(); ++operand)
  {
    for (const std::int32_t point : result.KeptPoints[operand])
    {
      mesh.Points.push_back(given.Operand(operand).Points[static_cast<std::size_t>(point)]);
    }
  }
  for (const sb::InterpolatedPoint& point : result.Interpolated)
  {
    mesh.Points.push_back(point.Position);
  }
  const auto add = [&](Corners t, bool reversed) {
    if (reversed)
    {
      std::swap(t[1], t[2]);
    }
    mesh.Triangles.push_back(t);
  };
  for (std::size_t operand = 0; operand < result.Fates.size(); ++operand)
  {
    for (std::size_t i = 0; i < result.Fates[operand].size(); ++i)
    {
      const sb::Fate fate = result.Fates[operand][i];
      if (fate == sb::Fate::Kept || fate == sb::Fate::KeptReversed)
      {
        Corners t = given.Operand(operand).Triangles[i];
        for (std::int32_t& corner : t)
        {
          corner = result.PointMap[operand][static_cast<std::size_t>(corner)];
        }
        add(t, fate == sb::Fate::KeptReversed);
      }
    }
  }
  for (std::size_t i = 0; i < result.Split.Corners.size(); ++i)
  {
    add(result.Split.Corners[i], result.Split.Reversed[i] != 0);
  }
  return mesh;
}

inline sb::BooleanResult Compute(const Case& given, sb::SeamPoints seams = sb::SeamPoints::PerSide)
{
  sb::SerialExecutor executor;
  sb::Monitor monitor;
  return sb::ComputeBoolean(given.Request(), seams, executor, monitor);
}

inline Mesh ComputeMesh(const Case& given) { return ResultMesh(given, Compute(given)); }

inline double VolumeOf(const Case& given)
{
  const Mesh mesh = ComputeMesh(given);
  return mesh.Triangles.empty() ? 0.0 : Volume(mesh);
}

/** What the stages after the first work on. */
struct Stage
{
  explicit Stage(const Case& given)
    : Given(given)
    , Request(Given.Request())
    , Checked(sb::Ingest(Request, Executor))
    , World(Request, Checked, Executor)
  {
  }

  const Case Given;
  sb::SerialExecutor Executor;
  sb::Monitor Monitor;
  const sb::BooleanRequest Request;
  const sb::Ingested Checked;
  const sb::Scene World;
};

/** The stages up to the arrangement, one after the other; `self` says which operands are cut
 * against themselves. */
struct CutStage : Stage
{
  explicit CutStage(const Case& given, std::vector<std::uint8_t> self = {})
    : Stage(given)
    , Self(std::move(self))
  {
    this->Self.resize(given.NumberOfOperands(), 0);
    std::vector<sb::BroadPhaseSurface> surfaces;
    for (std::int32_t i = 0; i < this->World.NumberOfOperands(); ++i)
    {
      const sb::Surface& mesh = this->World.Mesh(i);
      surfaces.push_back(
        { mesh.NumberOfTriangles > 0 ? this->World.Position(this->World.FirstVertex(i)) : nullptr,
          mesh.Triangles, mesh.NumberOfTriangles, this->World.Bounds(i),
          this->Self[static_cast<std::size_t>(i)] != 0, &this->World.Blocks(i) });
    }
    this->Pairs = sb::FindOverlappingPairs(surfaces, this->Executor, this->Monitor);
    this->Collapsed = sb::FindCollapsedFaces(this->World, this->Pairs);
    this->Contacts =
      sb::FindContacts(this->World, this->Pairs, this->Collapsed, this->Executor, this->Monitor);
    sb::StitchCollapsedFaces(this->World, this->Collapsed, this->Contacts);
    this->Cuts = sb::MakeArrangement(
      this->World, this->Contacts, this->Self, this->Collapsed, this->Executor, this->Monitor);
  }

  std::vector<std::uint8_t> Self;
  std::vector<sb::TrianglePair> Pairs;
  std::vector<std::uint8_t> Collapsed;
  sb::ContactSet Contacts;
  sb::Arrangement Cuts;
};

} // namespace shapes

#endif
