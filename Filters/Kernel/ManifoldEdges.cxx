// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ManifoldEdges.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace sb
{

namespace
{

class ContactSeparator
{
public:
  ContactSeparator(std::vector<std::array<std::int32_t, 3>>& triangles, std::int64_t numberOfPieces,
    std::int32_t firstPoint, std::int32_t numberOfPoints)
    : Triangles(triangles)
    , NumberOfPieces(numberOfPieces)
    , FirstPoint(firstPoint)
    , NumberOfPoints(numberOfPoints)
  {
  }

  std::vector<std::int32_t> Run()
  {
    this->ListEdges();
    std::vector<std::pair<std::size_t, std::size_t>> contacts;
    this->VisitEdges([&](std::size_t begin, std::size_t end) {
      if (end - begin > 2)
      {
        contacts.emplace_back(begin, end);
      }
    });
    if (contacts.empty())
    {
      return {};
    }
    this->Fans.resize(3 * this->Triangles.size());
    std::iota(this->Fans.begin(), this->Fans.end(), std::size_t(0));
    this->VisitEdges([&](std::size_t begin, std::size_t end) {
      if (end - begin == 2)
      {
        this->Join(this->Edges[begin], this->Edges[begin + 1]);
      }
    });
    for (const auto& contact : contacts)
    {
      this->PairUp(contact.first, contact.second);
    }
    this->GiveOutPoints(contacts);
    return std::move(this->Copies);
  }

private:
  /** One triangle's use of an edge, which it runs through from corner Corner to the next. */
  struct Use
  {
    std::int32_t Low;
    std::int32_t High;
    std::size_t Corner; ///< 3 * triangle + corner
  };

  std::int32_t& PointAt(std::size_t corner) { return this->Triangles[corner / 3][corner % 3]; }
  static std::size_t NextCorner(std::size_t corner)
  {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  bool IsForward(const Use& use) { return this->PointAt(use.Corner) == use.Low; }
  std::size_t LowCorner(const Use& use)
  {
    return this->IsForward(use) ? use.Corner : NextCorner(use.Corner);
  }
  std::size_t HighCorner(const Use& use)
  {
    return this->IsForward(use) ? NextCorner(use.Corner) : use.Corner;
  }
  bool IsPiece(const Use& use) const
  {
    return static_cast<std::int64_t>(use.Corner / 3) < this->NumberOfPieces;
  }

  void ListEdges()
  {
    for (std::size_t corner = 0; corner < 3 * this->Triangles.size(); ++corner)
    {
      const auto ends = std::minmax({ this->PointAt(corner), this->PointAt(NextCorner(corner)) });
      if (ends.second >= this->FirstPoint)
      {
        this->Edges.push_back({ ends.first, ends.second, corner });
      }
    }
    std::sort(this->Edges.begin(), this->Edges.end(), [](const Use& l, const Use& r) {
      return std::make_pair(l.Low, l.High) != std::make_pair(r.Low, r.High)
        ? std::make_pair(l.Low, l.High) < std::make_pair(r.Low, r.High)
        : l.Corner < r.Corner;
    });
  }

  template <class Visitor>
  void VisitEdges(Visitor&& visit)
  {
    for (std::size_t begin = 0, end = 0; begin < this->Edges.size(); begin = end)
    {
      for (end = begin;
           end < this->Edges.size() && this->Edges[end].Low == this->Edges[begin].Low &&
           this->Edges[end].High == this->Edges[begin].High;
           ++end)
      {
      }
      visit(begin, end);
    }
  }

  /** The set of corners of one point that are joined across edges. */
  std::size_t Fan(std::size_t corner)
  {
    while (this->Fans[corner] != corner)
    {
      this->Fans[corner] = this->Fans[this->Fans[corner]];
      corner = this->Fans[corner];
    }
    return corner;
  }

  void Unite(std::size_t a, std::size_t b)
  {
    a = this->Fan(a);
    b = this->Fan(b);
    this->Fans[std::max(a, b)] = std::min(a, b);
  }

  void Join(const Use& a, const Use& b)
  {
    this->Unite(this->LowCorner(a), this->LowCorner(b));
    this->Unite(this->HighCorner(a), this->HighCorner(b));
  }

  /** How little two triangles have to do with each other: first those of one fan, then like with
   * like. */
  int Strangeness(const Use& a, const Use& b)
  {
    const bool joined = this->Fan(this->LowCorner(a)) == this->Fan(this->LowCorner(b)) ||
      this->Fan(this->HighCorner(a)) == this->Fan(this->HighCorner(b));
    return (joined ? 0 : 2) + (this->IsPiece(a) == this->IsPiece(b) ? 0 : 1);
  }

  void PairUp(std::size_t begin, std::size_t end)
  {
    std::vector<Use> forward;
    std::vector<Use> backward;
    for (std::size_t i = begin; i < end; ++i)
    {
      (this->IsForward(this->Edges[i]) ? forward : backward).push_back(this->Edges[i]);
    }
    std::vector<std::pair<Use, Use>> pairs;
    for (int strangeness = 0; strangeness < 4; ++strangeness)
    {
      for (std::size_t i = 0; i < forward.size(); ++i)
      {
        for (std::size_t k = 0; k < backward.size(); ++k)
        {
          if (this->Strangeness(forward[i], backward[k]) == strangeness)
          {
            pairs.emplace_back(forward[i], backward[k]);
            forward.erase(forward.begin() + static_cast<std::ptrdiff_t>(i--));
            backward.erase(backward.begin() + static_cast<std::ptrdiff_t>(k));
            break;
          }
        }
      }
    }
    for (const auto& pair : pairs)
    {
      this->Join(pair.first, pair.second);
    }
  }

  void GiveOutPoints(const std::vector<std::pair<std::size_t, std::size_t>>& contacts)
  {
    std::vector<std::int32_t> shared;
    for (const auto& contact : contacts)
    {
      shared.push_back(this->Edges[contact.first].Low);
      shared.push_back(this->Edges[contact.first].High);
    }
    std::sort(shared.begin(), shared.end());
    shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
    std::map<std::int32_t, std::vector<std::size_t>> corners;
    for (std::size_t corner = 0; corner < 3 * this->Triangles.size(); ++corner)
    {
      const std::int32_t point = this->PointAt(corner);
      if (point >= this->FirstPoint && std::binary_search(shared.begin(), shared.end(), point))
      {
        corners[point].push_back(corner);
      }
    }
    for (const auto& entry : corners)
    {
      std::map<std::size_t, std::int32_t> instances;
      for (const std::size_t corner : entry.second)
      {
        const auto known = instances.find(this->Fan(corner));
        if (known != instances.end())
        {
          this->PointAt(corner) = known->second;
          continue;
        }
        std::int32_t instance = entry.first;
        if (!instances.empty())
        {
          instance = this->NumberOfPoints++;
          this->Copies.push_back(entry.first);
        }
        instances[this->Fan(corner)] = instance;
        this->PointAt(corner) = instance;
      }
    }
  }

  std::vector<std::array<std::int32_t, 3>>& Triangles;
  const std::int64_t NumberOfPieces;
  const std::int32_t FirstPoint;
  std::int32_t NumberOfPoints;
  std::vector<Use> Edges;
  std::vector<std::size_t> Fans; ///< union-find over corners
  std::vector<std::int32_t> Copies;
};

} // namespace

std::vector<std::int32_t> SeparateContacts(std::vector<std::array<std::int32_t, 3>>& triangles,
  std::int64_t numberOfPieces, std::int32_t firstPoint, std::int32_t numberOfPoints)
{
  return ContactSeparator(triangles, numberOfPieces, firstPoint, numberOfPoints).Run();
}

} // namespace sb
