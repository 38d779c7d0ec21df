// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SheetSides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{

namespace
{

bool Before(const SheetVote& l, const SheetVote& r)
{
  return l.Patch != r.Patch ? l.Patch < r.Patch
    : l.Sheet != r.Sheet    ? l.Sheet < r.Sheet
                            : l.Behind < r.Behind;
}

bool SamePlace(const SheetVote& l, const SheetVote& r)
{
  return l.Patch == r.Patch && l.Sheet == r.Sheet;
}

using Vector = std::array<double, 3>;

Vector Difference(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vector Along(const Vector& from, const Vector& direction, double parameter)
{
  return { from[0] + parameter * direction[0], from[1] + parameter * direction[1],
    from[2] + parameter * direction[2] };
}

/** The point of triangle abc nearest to p (Ericson, "Real-Time Collision Detection", 2005,
 * section 5.1.5). */
Vector NearestPoint(const Vector& p, const Vector& a, const Vector& b, const Vector& c)
{
  const Vector ab = Difference(b, a);
  const Vector ac = Difference(c, a);
  const Vector ap = Difference(p, a);
  const double d1 = Dot(ab, ap);
  const double d2 = Dot(ac, ap);
  if (d1 <= 0 && d2 <= 0)
  {
    return a;
  }
  const Vector bp = Difference(p, b);
  const double d3 = Dot(ab, bp);
  const double d4 = Dot(ac, bp);
  if (d3 >= 0 && d4 <= d3)
  {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    return Along(a, ab, d1 / (d1 - d3));
  }
  const Vector cp = Difference(p, c);
  const double d5 = Dot(ab, cp);
  const double d6 = Dot(ac, cp);
  if (d6 >= 0 && d5 <= d6)
  {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    return Along(a, ac, d2 / (d2 - d6));
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    return Along(b, Difference(c, b), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
  }
  const double scale = 1.0 / (va + vb + vc);
  return Along(Along(a, ab, vb * scale), ac, vc * scale);
}

} // namespace

void Vote(const std::vector<std::int32_t>& sheets, const std::vector<PieceAtEdge>& pieces,
  const RadialOrder& order, std::vector<SheetVote>& votes)
{
  const std::size_t count = pieces.size();
  for (const std::int32_t sheet : sheets)
  {
    std::vector<std::size_t> ofSheet;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (pieces[i].Operand == sheet)
      {
        ofSheet.push_back(i);
      }
    }
    for (std::size_t i = 0; i < count && !ofSheet.empty(); ++i)
    {
      if (pieces[i].Operand == sheet)
      {
        continue;
      }
      // The sheet's piece before this one shows the side that faces the direction of turning: the
      // front if it runs up.
      std::size_t before = ofSheet.back();
      for (const std::size_t j : ofSheet)
      {
        before = j < i ? j : before;
      }
      bool behind = !pieces[before].RunsUp;
      if (ofSheet.size() == 1 && order.Turn(before, i) < 0)
      {
        // The sheet ends here: beyond its rim, the side of its plane goes on to count.
        behind = !behind;
      }
      votes.push_back({ pieces[i].Patch, sheet, behind });
    }
  }
}

int SheetSides::Find(std::int32_t patch, std::int32_t sheet) const
{
  const SheetVote wanted{ patch, sheet, false };
  const auto found = std::lower_bound(this->Votes.begin(), this->Votes.end(), wanted, Before);
  return found != this->Votes.end() && SamePlace(*found, wanted) ? int(found->Behind) : -1;
}

SheetSides CountVotes(std::vector<SheetVote> votes, std::vector<std::uint8_t>& nonSeparating)
{
  std::sort(votes.begin(), votes.end(), Before);
  for (std::size_t i = 1; i < votes.size(); ++i)
  {
    if (SamePlace(votes[i - 1], votes[i]) && votes[i - 1].Behind != votes[i].Behind)
    {
      nonSeparating[std::size_t(votes[i].Sheet)] = 1;
    }
  }
  votes.erase(std::unique(votes.begin(), votes.end(), SamePlace), votes.end());
  SheetSides result;
  result.Votes = std::move(votes);
  return result;
}

bool DistanceSign::IsBehind(std::int32_t face, std::int32_t sheet) const
{
  const auto position = [this](std::int32_t vertex) {
    const double* p = this->World.Position(vertex);
    return Vector{ p[0], p[1], p[2] };
  };
  Vector middle{};
  for (const std::int32_t corner : this->World.Corners(face))
  {
    middle = Along(middle, position(corner), 1.0 / 3.0);
  }
  double nearest = std::numeric_limits<double>::infinity();
  double bestSteepness = 0.0;
  double side = 0.0;
  for (std::int32_t i = this->World.FirstFace(sheet); i < this->World.FirstFace(sheet + 1); ++i)
  {
    const std::array<std::int32_t, 3> corners = this->World.Corners(sheet, i);
    const Vector a = position(corners[0]);
    const Vector b = position(corners[1]);
    const Vector c = position(corners[2]);
    const Vector normal = Cross(Difference(b, a), Difference(c, a));
    const double length = std::sqrt(Dot(normal, normal));
    const Vector offset = Difference(middle, NearestPoint(middle, a, b, c));
    const double distance = Dot(offset, offset);
    if (length == 0.0 || distance > nearest * (1 + 1e-12))
    {
      continue;
    }
    // Of faces that are equally near (they share the nearest edge or vertex), the one seen most
    // squarely decides.
    const double height = Dot(offset, normal) / length;
    const double steepness = distance > 0 ? std::abs(height) / std::sqrt(distance) : 1.0;
    if (distance < nearest * (1 - 1e-12) || steepness > bestSteepness)
    {
      bestSteepness = steepness;
      side = height;
    }
    nearest = std::min(nearest, distance);
  }
  return side < 0;
}

} // namespace sb
