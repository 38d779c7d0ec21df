// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestTriangleBuild.cxx
 * @brief Building the tree: median splits from the top, then boxes from the bottom.
 *
 * A box has one axis along the sum of its triangles' normals and one along the direction in which
 * their corners spread most; both come from sums that nodes hand upwards. Its size is measured on
 * the corners themselves for nodes of up to 512 triangles, and on the eight boxes below for larger
 * ones, where a little more is no loss.
 */
#include "NearestTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 4096;
/** Levels whose boxes are measured on the corners: of 1, 8, 64 and 512 triangles. */
constexpr int MeasuredLevels = 4;
/** A patch whose normals add up to less than this share of its area has no side to lie along. */
constexpr double FlatShare = 0.2;

/** What is sorted: the middle of a triangle's box, in the frame. */
struct Middle
{
  std::array<float, 3> Place;
  std::int32_t Triangle;
};

struct Range
{
  std::int64_t Begin;
  std::int64_t End;
};

std::int64_t PowerOfWidth(int exponent) { return std::int64_t(1) << (3 * exponent); }

/** Put the lower half of the middles along the range's longest side first; returns where the upper
 * half begins. Halves are full nodes but for the last. */
std::int64_t SplitRange(std::vector<Middle>& middles, const Range& range)
{
  std::array<float, 3> lower = middles[static_cast<std::size_t>(range.Begin)].Place;
  std::array<float, 3> upper = lower;
  for (std::int64_t i = range.Begin; i < range.End; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const float place = middles[static_cast<std::size_t>(i)].Place[axis];
      lower[axis] = std::min(lower[axis], place);
      upper[axis] = std::max(upper[axis], place);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    longest = upper[axis] - lower[axis] > upper[longest] - lower[longest] ? axis : longest;
  }
  std::int64_t unit = NearestTriangle::Width;
  while (unit * NearestTriangle::Width < range.End - range.Begin)
  {
    unit *= NearestTriangle::Width;
  }
  const std::int64_t units = (range.End - range.Begin + unit - 1) / unit;
  const std::int64_t middle = range.Begin + units / 2 * unit;
  const auto at = [&middles](
                    std::int64_t i) { return middles.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(range.Begin), at(middle), at(range.End),
    [longest](const Middle& a, const Middle& b) { return a.Place[longest] < b.Place[longest]; });
  return middle;
}

void SplitWholly(std::vector<Middle>& middles, const Range& range)
{
  if (range.End - range.Begin <= NearestTriangle::Width)
  {
    return;
  }
  const std::int64_t middle = SplitRange(middles, range);
  SplitWholly(middles, { range.Begin, middle });
  SplitWholly(middles, { middle, range.End });
}

/** The first splits one after another, those of a round in parallel; then one task a range. */
void SplitAll(std::vector<Middle>& middles, Executor& executor)
{
  std::vector<Range> ranges{ { 0, static_cast<std::int64_t>(middles.size()) } };
  const std::size_t wanted = static_cast<std::size_t>(8 * executor.NumberOfThreads());
  while (ranges.size() < wanted &&
    ranges.front().End - ranges.front().Begin > 4 * NearestTriangle::Width)
  {
    std::vector<Range> halves(2 * ranges.size());
    executor.For(
      static_cast<std::int64_t>(ranges.size()), 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          const Range range = ranges[i];
          const bool splits = range.End - range.Begin > NearestTriangle::Width;
          const std::int64_t middle = splits ? SplitRange(middles, range) : range.End;
          halves[2 * i] = { range.Begin, middle };
          halves[2 * i + 1] = { middle, range.End };
        }
      });
    ranges.swap(halves);
  }
  executor.For(
    static_cast<std::int64_t>(ranges.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        SplitWholly(middles, ranges[static_cast<std::size_t>(i)]);
      }
    });
}

Vector3 Unit(const Vector3& a)
{
  const double length = Length(a);
  return length > 0.0 ? (1.0 / length) * a : Vector3{};
}

/** A unit vector at right angles to the unit vector `normal`. */
Vector3 AnyAcross(const Vector3& normal)
{
  const Vector3 other =
    std::fabs(normal.X) < 0.6 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 };
  return Unit(Cross(normal, other));
}

} // namespace

/** What nodes hand upwards: sums over the corners and the triangles below. */
struct NearestTriangle::Summary
{
  double Corners = 0.0;
  Vector3 Sum; ///< of the corners
  double XX = 0.0, YY = 0.0, ZZ = 0.0, XY = 0.0, YZ = 0.0, ZX = 0.0; ///< of their products
  Vector3 Normal; ///< of the triangles, twice their areas long
  double Area = 0.0; ///< twice

  void AddCorner(const Vector3& p)
  {
    this->Corners += 1.0;
    this->Sum = this->Sum + p;
    this->XX += p.X * p.X;
    this->YY += p.Y * p.Y;
    this->ZZ += p.Z * p.Z;
    this->XY += p.X * p.Y;
    this->YZ += p.Y * p.Z;
    this->ZX += p.Z * p.X;
  }

  void Add(const Summary& other)
  {
    this->Corners += other.Corners;
    this->Sum = this->Sum + other.Sum;
    this->XX += other.XX;
    this->YY += other.YY;
    this->ZZ += other.ZZ;
    this->XY += other.XY;
    this->YZ += other.YZ;
    this->ZX += other.ZX;
    this->Normal = this->Normal + other.Normal;
    this->Area += other.Area;
  }

  Vector3 Mean() const { return (1.0 / this->Corners) * this->Sum; }

  /** The corners' covariance along two directions. */
  double Spread(const Vector3& u, const Vector3& v) const
  {
    const Vector3 product{ this->XX * v.X + this->XY * v.Y + this->ZX * v.Z,
      this->XY * v.X + this->YY * v.Y + this->YZ * v.Z,
      this->ZX * v.X + this->YZ * v.Y + this->ZZ * v.Z };
    return Dot(u, product) - Dot(u, this->Sum) * Dot(v, this->Sum) / this->Corners;
  }

  /** Three directions at right angles, the last one along the normals. */
  std::array<Vector3, 3> Axes() const
  {
    if (!(Length(this->Normal) > FlatShare * this->Area))
    {
      return { Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 }, Vector3{ 0.0, 0.0, 1.0 } };
    }
    const Vector3 normal = Unit(this->Normal);
    const Vector3 u = AnyAcross(normal);
    const Vector3 v = Cross(normal, u);
    const double angle =
      0.5 * std::atan2(2.0 * this->Spread(u, v), this->Spread(u, u) - this->Spread(v, v));
    const Vector3 first = std::cos(angle) * u + std::sin(angle) * v;
    return { first, Cross(normal, first), normal };
  }
};

/** The box of one lane while it is being measured: intervals along its axes, which are those that
 * the node will hold. */
class NearestTriangle::Builder
{
public:
  /** @param reference a point near the box. */
  Builder(const std::array<Vector3, 3>& axes, const Vector3& reference)
    : Reference(reference)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Axes[k] = { static_cast<float>(axes[k].X), static_cast<float>(axes[k].Y),
        static_cast<float>(axes[k].Z) };
      this->Lower[k] = std::numeric_limits<double>::infinity();
      this->Upper[k] = -std::numeric_limits<double>::infinity();
    }
  }

  void Enclose(const Vector3& point)
  {
    const Vector3 offset = point - this->Reference;
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Extend(k, Dot(this->Axes[k], offset), 0.0);
    }
  }

  /** Enclose the box in a lane; its axes are taken to be at right angles, which Store's margin
   * makes up for. */
  void Enclose(const Node& node, int lane)
  {
    const Vector3 offset =
      Vector3{ node.Center[0][lane], node.Center[1][lane], node.Center[2][lane] } - this->Reference;
    for (std::size_t k = 0; k < 3; ++k)
    {
      double radius = 0.0;
      for (int j = 0; j < 3; ++j)
      {
        const Vector3 axis{ node.Axis[j][0][lane], node.Axis[j][1][lane], node.Axis[j][2][lane] };
        radius += std::fabs(Dot(this->Axes[k], axis)) * node.Extent[j][lane];
      }
      this->Extend(k, Dot(this->Axes[k], offset), radius);
    }
  }

  void Store(Node& node, int lane) const
  {
    Vector3 center = this->Reference;
    double size = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      center = center + 0.5 * (this->Lower[k] + this->Upper[k]) * this->Axes[k];
      size += this->Upper[k] - this->Lower[k];
    }
    const Vector3 rounded{ static_cast<float>(center.X), static_cast<float>(center.Y),
      static_cast<float>(center.Z) };
    node.Center[0][lane] = static_cast<float>(rounded.X);
    node.Center[1][lane] = static_cast<float>(rounded.Y);
    node.Center[2][lane] = static_cast<float>(rounded.Z);
    for (std::size_t k = 0; k < 3; ++k)
    {
      node.Axis[k][0][lane] = static_cast<float>(this->Axes[k].X);
      node.Axis[k][1][lane] = static_cast<float>(this->Axes[k].Y);
      node.Axis[k][2][lane] = static_cast<float>(this->Axes[k].Z);
      const double middle = Dot(this->Axes[k], rounded - this->Reference);
      const double extent = std::max(this->Upper[k] - middle, middle - this->Lower[k]);
      node.Extent[k][lane] = static_cast<float>((extent + 1e-6 * size) * (1.0 + 1e-6) + 1e-15);
    }
  }

  static void StoreNothing(Node& node, int lane)
  {
    for (int k = 0; k < 3; ++k)
    {
      node.Center[k][lane] = 0.0f;
      node.Extent[k][lane] = -1e15f;
      for (int coordinate = 0; coordinate < 3; ++coordinate)
      {
        node.Axis[k][coordinate][lane] = k == coordinate ? 1.0f : 0.0f;
      }
    }
  }

private:
  void Extend(std::size_t k, double middle, double radius)
  {
    this->Lower[k] = std::min(this->Lower[k], middle - radius);
    this->Upper[k] = std::max(this->Upper[k], middle + radius);
  }

  std::array<Vector3, 3> Axes;
  Vector3 Reference;
  std::array<double, 3> Lower{};
  std::array<double, 3> Upper{};
};

namespace
{

/** Axes of one triangle: along its longest edge, across, and its normal. */
std::array<Vector3, 3> TriangleAxes(const std::array<Vector3, 3>& corners)
{
  Vector3 longest;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 edge = corners[(k + 1) % 3] - corners[k];
    longest = SquaredLength(edge) > SquaredLength(longest) ? edge : longest;
  }
  Vector3 along = Unit(longest);
  if (!(SquaredLength(along) > 0.0))
  {
    along = { 1.0, 0.0, 0.0 };
  }
  Vector3 normal = Unit(Cross(corners[1] - corners[0], corners[2] - corners[0]));
  // A triangle without area may have a normal of rounding errors: what counts is the right angle.
  normal = Unit(normal - Dot(normal, along) * along);
  if (!(std::fabs(Dot(normal, along)) < 1e-9 && SquaredLength(normal) > 0.5))
  {
    normal = AnyAcross(along);
  }
  return { along, Cross(normal, along), normal };
}

} // namespace

void NearestTriangle::ChooseFrame(Executor& executor)
{
  const Surface& mesh = this->Triangles;
  struct Bounds
  {
    std::array<double, 3> Lower;
    std::array<double, 3> Upper;
  };
  constexpr std::int64_t blockSize = 4 * Grain;
  std::vector<Bounds> blocks(
    static_cast<std::size_t>((mesh.NumberOfTriangles - 1) / blockSize + 1));
  executor.For(
    static_cast<std::int64_t>(blocks.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t block = begin; block < end; ++block)
      {
        Bounds bounds;
        bounds.Lower.fill(std::numeric_limits<double>::infinity());
        bounds.Upper.fill(-std::numeric_limits<double>::infinity());
        const std::int64_t last = std::min(mesh.NumberOfTriangles, (block + 1) * blockSize);
        for (std::int64_t i = 3 * block * blockSize; i < 3 * last; ++i)
        {
          const double* point = mesh.Points + 3 * std::int64_t(mesh.Triangles[i]);
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            bounds.Lower[axis] = std::min(bounds.Lower[axis], point[axis]);
            bounds.Upper[axis] = std::max(bounds.Upper[axis], point[axis]);
          }
        }
        blocks[static_cast<std::size_t>(block)] = bounds;
      }
    });
  double halfSide = 1e-300;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double lower = blocks.front().Lower[axis];
    double upper = blocks.front().Upper[axis];
    for (const Bounds& block : blocks)
    {
      lower = std::min(lower, block.Lower[axis]);
      upper = std::max(upper, block.Upper[axis]);
    }
    this->LowerBounds[axis] = lower;
    this->UpperBounds[axis] = upper;
    this->Origin[axis] = 0.5 * lower + 0.5 * upper;
    halfSide = std::max({ halfSide, this->Origin[axis] - lower, upper - this->Origin[axis] });
  }
  int exponent = 0;
  std::frexp(halfSide, &exponent);
  this->FrameScale = std::ldexp(1.0, -std::max(exponent, -990));
}

void NearestTriangle::SortTriangles(Executor& executor)
{
  const Surface& mesh = this->Triangles;
  std::vector<Middle> middles(static_cast<std::size_t>(mesh.NumberOfTriangles));
  executor.For(mesh.NumberOfTriangles, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      const double* p[3];
      for (std::int64_t corner = 0; corner < 3; ++corner)
      {
        p[corner] = mesh.Points + 3 * std::int64_t(mesh.Triangles[3 * i + corner]);
      }
      Middle& middle = middles[static_cast<std::size_t>(i)];
      middle.Triangle = static_cast<std::int32_t>(i);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double lower = std::min({ p[0][axis], p[1][axis], p[2][axis] });
        const double upper = std::max({ p[0][axis], p[1][axis], p[2][axis] });
        middle.Place[axis] =
          static_cast<float>((0.5 * lower + 0.5 * upper - this->Origin[axis]) * this->FrameScale);
      }
    }
  });
  SplitAll(middles, executor);
  this->Order.resize(middles.size());
  executor.For(mesh.NumberOfTriangles, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      this->Order[i] = middles[i].Triangle;
    }
  });
}

/** The boxes of single triangles, and the sums over each eight of them. */
void NearestTriangle::FillLowestLevel(std::vector<Summary>& summaries, Executor& executor)
{
  const std::size_t count = this->Order.size();
  std::vector<Node>& nodes = this->Levels.emplace_back((count + Width - 1) / Width);
  summaries.assign(nodes.size(), Summary());
  const Vector3 origin{ this->Origin[0], this->Origin[1], this->Origin[2] };
  executor.For(static_cast<std::int64_t>(nodes.size()), Grain / Width,
    [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        Summary summary;
        for (int lane = 0; lane < Width; ++lane)
        {
          const std::size_t place = i * Width + static_cast<std::size_t>(lane);
          if (place >= count)
          {
            Builder::StoreNothing(nodes[i], lane);
            continue;
          }
          const std::array<Vector3, 3> corners = this->CornersFrom(origin, this->Order[place]);
          Builder box(TriangleAxes(corners), corners[0]);
          for (const Vector3& corner : corners)
          {
            box.Enclose(corner);
            summary.AddCorner(corner);
          }
          box.Store(nodes[i], lane);
          const Vector3 normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
          summary.Normal = summary.Normal + normal;
          summary.Area += Length(normal);
        }
        summaries[i] = summary;
      }
    });
}

/** The boxes of the nodes of the level below. */
void NearestTriangle::FillNextLevel(std::vector<Summary>& summaries, Executor& executor)
{
  const int level = static_cast<int>(this->Levels.size());
  const std::size_t countBelow = this->Levels.back().size();
  std::vector<Node>& nodes = this->Levels.emplace_back((countBelow + Width - 1) / Width);
  const std::vector<Node>& below = this->Levels[static_cast<std::size_t>(level - 1)];
  std::vector<Summary> sums(nodes.size());
  executor.For(static_cast<std::int64_t>(nodes.size()),
    std::max<std::int64_t>(1, Grain / 8 / PowerOfWidth(level)),
    [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        for (int lane = 0; lane < Width; ++lane)
        {
          const std::size_t child = i * Width + static_cast<std::size_t>(lane);
          if (child >= countBelow)
          {
            Builder::StoreNothing(nodes[i], lane);
            continue;
          }
          Builder box(summaries[child].Axes(), summaries[child].Mean());
          this->EncloseNode(box, below[child], level, child);
          box.Store(nodes[i], lane);
          sums[i].Add(summaries[child]);
        }
      }
    });
  summaries.swap(sums);
}

/** Enclose what is under node `child` of the level below `level`. */
void NearestTriangle::EncloseNode(
  Builder& box, const Node& node, int level, std::size_t child) const
{
  if (level >= MeasuredLevels)
  {
    for (int lane = 0; lane < Width; ++lane)
    {
      if (node.Extent[0][lane] >= 0.0f)
      {
        box.Enclose(node, lane);
      }
    }
    return;
  }
  const Vector3 origin{ this->Origin[0], this->Origin[1], this->Origin[2] };
  const std::size_t size = static_cast<std::size_t>(PowerOfWidth(level));
  const std::size_t last = std::min(this->Order.size(), (child + 1) * size);
  for (std::size_t place = child * size; place < last; ++place)
  {
    for (const Vector3& corner : this->CornersFrom(origin, this->Order[place]))
    {
      box.Enclose(corner);
    }
  }
}

void NearestTriangle::Build(const Surface& surface, Executor& executor)
{
  this->Triangles = surface;
  this->Order.clear();
  this->Levels.clear();
  if (surface.NumberOfTriangles <= 0)
  {
    return;
  }
  this->ChooseFrame(executor);
  this->SortTriangles(executor);
  this->Levels.reserve(MostLevels);
  std::vector<Summary> summaries;
  this->FillLowestLevel(summaries, executor);
  while (this->Levels.back().size() > 1)
  {
    this->FillNextLevel(summaries, executor);
  }
}

} // namespace sb
