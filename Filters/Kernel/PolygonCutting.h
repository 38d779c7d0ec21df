// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonCutting.h
 * @brief Cuts a convex polygon, with or without points inside its sides, into triangles.
 *
 * Which points are corners and which lie inside a side is known from how the polygon was made, so
 * nothing has to be measured but for the shape of the triangles: a corner next to a point inside a
 * side is cut off first (that point then is a corner), and then the one with the shortest diagonal.
 */
#ifndef sb_PolygonCutting_h
#define sb_PolygonCutting_h

#include <array>
#include <cstdint>
#include <vector>

namespace sb
{

class ConvexOutline
{
public:
  void Clear()
  {
    this->Ids.clear();
    this->Flat.clear();
  }

  /** Append a point; @param inSide whether it lies inside a side. */
  void Add(std::int32_t id, bool inSide)
  {
    this->Ids.push_back(id);
    this->Flat.push_back(inSide ? 1 : 0);
  }

  /** Append the triangles, oriented as the polygon. @param placeOf gives coordinates by id. */
  template <class PlaceOf>
  void Cut(PlaceOf&& placeOf, std::vector<std::array<std::int32_t, 3>>& triangles)
  {
    while (this->Ids.size() > 3)
    {
      std::size_t ear = this->CornerNextToFlat();
      ear = ear < this->Ids.size() ? ear : this->ShortestDiagonal(placeOf);
      const std::size_t before = this->Before(ear);
      const std::size_t after = this->After(ear);
      triangles.push_back({ this->Ids[before], this->Ids[ear], this->Ids[after] });
      this->Flat[before] = this->Flat[after] = 0;
      this->Ids.erase(this->Ids.begin() + static_cast<std::ptrdiff_t>(ear));
      this->Flat.erase(this->Flat.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({ this->Ids[0], this->Ids[1], this->Ids[2] });
  }

private:
  std::size_t Before(std::size_t i) const { return (i == 0 ? this->Ids.size() : i) - 1; }
  std::size_t After(std::size_t i) const { return i + 1 == this->Ids.size() ? 0 : i + 1; }

  std::size_t CornerNextToFlat() const
  {
    std::size_t i = 0;
    while (i < this->Ids.size() &&
      (this->Flat[i] || !(this->Flat[this->Before(i)] || this->Flat[this->After(i)])))
    {
      ++i;
    }
    return i;
  }

  template <class PlaceOf>
  std::size_t ShortestDiagonal(PlaceOf&& placeOf) const
  {
    std::size_t best = 0;
    double least = -1.0;
    for (std::size_t i = 0; i < this->Ids.size(); ++i)
    {
      const double* p = placeOf(this->Ids[this->Before(i)]);
      const double* q = placeOf(this->Ids[this->After(i)]);
      double length = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        length += (p[axis] - q[axis]) * (p[axis] - q[axis]);
      }
      if (least < 0.0 || length < least)
      {
        least = length;
        best = i;
      }
    }
    return best;
  }

  std::vector<std::int32_t> Ids;
  std::vector<std::uint8_t> Flat; ///< 1: inside a side
};

} // namespace sb

#endif
