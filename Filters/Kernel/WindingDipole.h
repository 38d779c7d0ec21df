// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WindingDipole.h
 * @brief A group of oriented areas seen from afar: what it adds to a winding number (Barill,
 * Dickson, Schmidt, Levin, Jacobson, Fast Winding Numbers for Soups and Clouds, 2018, section 4).
 */
#ifndef sb_WindingDipole_h
#define sb_WindingDipole_h

#include "Vector3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sb
{

struct WindingDipole
{
  /** A group counts as a dipole from this many of its radii on; the paper's beta. */
  static constexpr double Beta = 2.5;

  Vector3 Center;
  Vector3 Normal; ///< sum of the normals, as long as their areas
  Vector3 Moment[3]; ///< [k] sum of (the part's centre - Center)_k times its normal
  double Area = 0.0;
  double Radius = 0.0;

  /** The dipole of parts[begin, end): moments move with the centre. */
  static WindingDipole Of(
    const std::vector<WindingDipole>& parts, std::size_t begin, std::size_t end)
  {
    WindingDipole sum;
    Vector3 plain;
    for (std::size_t i = begin; i < end; ++i)
    {
      sum.Area += parts[i].Area;
      sum.Center = sum.Center + parts[i].Area * parts[i].Center;
      plain = plain + parts[i].Center;
      sum.Normal = sum.Normal + parts[i].Normal;
    }
    sum.Center = sum.Area > 0.0 ? (1.0 / sum.Area) * sum.Center
                                : (1.0 / static_cast<double>(end - begin)) * plain;
    for (std::size_t i = begin; i < end; ++i)
    {
      const Vector3 offset = parts[i].Center - sum.Center;
      const double by[3] = { offset.X, offset.Y, offset.Z };
      for (int k = 0; k < 3; ++k)
      {
        sum.Moment[k] = sum.Moment[k] + parts[i].Moment[k] + by[k] * parts[i].Normal;
      }
      sum.Radius = std::max(sum.Radius, Length(offset) + parts[i].Radius);
    }
    return sum;
  }

  bool IsFar(double squaredDistance) const
  {
    return squaredDistance > Beta * Beta * this->Radius * this->Radius;
  }

  /** Its solid angle. @param r from the place that looks to Center, of the squared length given. */
  double SolidAngle(const Vector3& r, double squaredLength) const
  {
    const double inverse = 1.0 / std::sqrt(squaredLength);
    const double cube = inverse * inverse * inverse;
    const Vector3 unit = inverse * r;
    const double trace = this->Moment[0].X + this->Moment[1].Y + this->Moment[2].Z;
    const double along = unit.X * Dot(this->Moment[0], unit) + unit.Y * Dot(this->Moment[1], unit) +
      unit.Z * Dot(this->Moment[2], unit);
    return cube * (Dot(r, this->Normal) + trace - 3.0 * along);
  }
};

/**
 * A complete tree of dipoles without pointers: node i of a level has the nodes 8i..8i+7 of the
 * level below; those of the lowest level are given.
 */
class WindingTree
{
public:
  static constexpr std::size_t Width = 8;

  std::vector<WindingDipole>& Lowest()
  {
    if (this->Levels.empty())
    {
      this->Levels.emplace_back();
    }
    return this->Levels.front();
  }

  bool IsEmpty() const { return this->Levels.empty() || this->Levels.front().empty(); }

  /** Make the levels above the lowest one. @param loop as Executor::For, without grain */
  template <class Loop>
  void Build(const Loop& loop)
  {
    this->Levels.resize(1);
    this->Levels.reserve(16);
    while (this->Levels.back().size() > 1)
    {
      const std::vector<WindingDipole>& below = this->Levels.back();
      std::vector<WindingDipole> level((below.size() + Width - 1) / Width);
      loop(static_cast<std::int64_t>(level.size()), [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          level[i] = WindingDipole::Of(below, i * Width, std::min(below.size(), (i + 1) * Width));
        }
      });
      this->Levels.push_back(std::move(level));
    }
  }

  /** The solid angle at a place; `nearBy(i)` gives that of node i of the lowest level, which is too
   * near to be a dipole. */
  template <class NearBy>
  double SolidAngleAt(const Vector3& place, const NearBy& nearBy) const
  {
    struct Open
    {
      int Level;
      std::int32_t Index;
    };
    std::array<Open, 16 * Width> stack;
    std::size_t numberOpen = 0;
    double sum = 0.0;
    stack[numberOpen++] = { static_cast<int>(this->Levels.size()) - 1, 0 };
    while (numberOpen > 0)
    {
      const Open open = stack[--numberOpen];
      const WindingDipole& group =
        this->Levels[static_cast<std::size_t>(open.Level)][static_cast<std::size_t>(open.Index)];
      const Vector3 r = group.Center - place;
      const double squared = SquaredLength(r);
      if (group.IsFar(squared))
      {
        sum += group.SolidAngle(r, squared);
      }
      else if (open.Level == 0)
      {
        sum += nearBy(open.Index);
      }
      else
      {
        const std::size_t below = this->Levels[static_cast<std::size_t>(open.Level - 1)].size();
        const std::size_t first = static_cast<std::size_t>(open.Index) * Width;
        for (std::size_t child = first; child < std::min(below, first + Width); ++child)
        {
          stack[numberOpen++] = { open.Level - 1, static_cast<std::int32_t>(child) };
        }
      }
    }
    return sum;
  }

private:
  std::vector<std::vector<WindingDipole>> Levels;
};

} // namespace sb

#endif
