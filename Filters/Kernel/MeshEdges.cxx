// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshEdges.h"

#include "DisjointSets.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 4096;

/** What the vertices of one block give. */
struct Part
{
  std::vector<IrregularEdge> Irregular;
  std::vector<HalfEdge> Uses;
  std::vector<FurtherFan> FurtherFans;
  std::vector<std::array<HalfEdge, 2>> RimJoins;
};

/** Looks at one vertex after the other. */
class FanExaminer
{
public:
  FanExaminer(const std::vector<std::int32_t>& corners, const VertexFans& fans,
    std::vector<HalfEdge>& mates, Part& part)
    : Corners(corners)
    , Fans(fans)
    , Mates(mates)
    , Result(part)
  {
  }

  void Examine(std::int32_t vertex)
  {
    if (this->ReadRing(vertex) && this->RingGoesAroundOnce())
    {
      this->RecordRing(vertex);
      return;
    }
    this->ListSpokes(vertex);
    this->Sets.Reset(static_cast<std::int32_t>(this->Triangles.size()));
    this->Rims.clear();
    for (std::size_t begin = 0; begin < this->Spokes.size();)
    {
      std::size_t end = begin + 1;
      for (; end < this->Spokes.size() && this->Spokes[end].Other == this->Spokes[begin].Other;
           ++end)
      {
        this->Sets.Unite(this->Spokes[begin].Place, this->Spokes[end].Place);
      }
      if (end - begin == 1)
      {
        this->Rims.push_back(begin);
      }
      if (vertex < this->Spokes[begin].Other)
      {
        this->RecordEdge(begin, end);
      }
      begin = end;
    }
    this->RecordFans(vertex);
    this->RecordRimJoins();
  }

private:
  /** Most vertices have a few triangles, one after the other once around. */
  struct Ring
  {
    static constexpr std::size_t Most = 16;

    std::size_t Size;
    std::array<std::int32_t, Most> Nexts; ///< [triangle] the corner after the vertex
    std::array<std::int32_t, Most> Lasts; ///< the one before it
    std::array<HalfEdge, Most> Outgoing; ///< from the vertex
    std::array<HalfEdge, Most> Incoming; ///< to it
    std::array<std::size_t, Most> Followers; ///< the triangle beyond the outgoing edge
  };

  bool ReadRing(std::int32_t vertex)
  {
    const VertexFans::Fan fan = this->Fans.Around(vertex);
    this->Around.Size = 0;
    if (fan.end() - fan.begin() > std::ptrdiff_t(Ring::Most))
    {
      return false;
    }
    for (const std::int32_t triangle : fan)
    {
      const std::int32_t* const c = this->Corners.data() + 3 * std::size_t(triangle);
      if (IsPinched(c))
      {
        return false;
      }
      const int at = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
      const int last = at == 0 ? 2 : at - 1;
      const std::size_t i = this->Around.Size++;
      this->Around.Nexts[i] = c[at == 2 ? 0 : at + 1];
      this->Around.Lasts[i] = c[last];
      this->Around.Outgoing[i] = 3 * triangle + at;
      this->Around.Incoming[i] = 3 * triangle + last;
    }
    return this->Around.Size > 0;
  }

  /** Whether each edge is that of two triangles which agree, and all triangles hang together: were
   * an edge that of more, the way around would close too early or never. */
  bool RingGoesAroundOnce()
  {
    Ring& ring = this->Around;
    for (std::size_t i = 0; i < ring.Size; ++i)
    {
      std::size_t matches = 0;
      for (std::size_t j = 0; j < ring.Size; ++j)
      {
        const bool isMatch = ring.Lasts[j] == ring.Nexts[i];
        ring.Followers[i] = isMatch ? j : ring.Followers[i];
        matches += isMatch;
      }
      if (matches != 1)
      {
        return false;
      }
    }
    std::size_t steps = 1;
    std::size_t at = ring.Followers[0];
    for (; at != 0 && steps < ring.Size; ++steps)
    {
      at = ring.Followers[at];
    }
    return at == 0 && steps == ring.Size;
  }

  void RecordRing(std::int32_t vertex)
  {
    for (std::size_t i = 0; i < this->Around.Size; ++i)
    {
      if (vertex < this->Around.Nexts[i])
      {
        const HalfEdge mate = this->Around.Incoming[this->Around.Followers[i]];
        this->Mates[std::size_t(this->Around.Outgoing[i])] = mate;
        this->Mates[std::size_t(mate)] = this->Around.Outgoing[i];
      }
    }
  }

  /** An edge at the vertex, as one triangle has it. */
  struct Spoke
  {
    std::int32_t Other; ///< the vertex at its other end
    HalfEdge Half;
    std::int32_t Place; ///< of the triangle, among those around the vertex
    bool IsOutgoing;

    friend bool operator<(const Spoke& l, const Spoke& r)
    {
      return l.Other != r.Other ? l.Other < r.Other : l.Half < r.Half;
    }
  };

  void ListSpokes(std::int32_t vertex)
  {
    this->Spokes.clear();
    this->Triangles.clear();
    for (const std::int32_t triangle : this->Fans.Around(vertex))
    {
      const std::int32_t* const c = this->Corners.data() + 3 * std::size_t(triangle);
      if (IsPinched(c))
      {
        continue;
      }
      const int at = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
      const int next = (at + 1) % 3;
      const int last = (at + 2) % 3;
      const auto place = static_cast<std::int32_t>(this->Triangles.size());
      this->Triangles.push_back(triangle);
      this->Spokes.push_back({ c[next], 3 * triangle + at, place, true });
      this->Spokes.push_back({ c[last], 3 * triangle + last, place, false });
    }
    std::sort(this->Spokes.begin(), this->Spokes.end());
  }

  void RecordEdge(std::size_t begin, std::size_t end)
  {
    const Spoke& first = this->Spokes[begin];
    if (end - begin == 2 && first.IsOutgoing != this->Spokes[begin + 1].IsOutgoing)
    {
      this->Mates[std::size_t(first.Half)] = this->Spokes[begin + 1].Half;
      this->Mates[std::size_t(this->Spokes[begin + 1].Half)] = first.Half;
      return;
    }
    IrregularEdge edge{ static_cast<std::int32_t>(this->Result.Uses.size()),
      static_cast<std::int32_t>(end - begin), 0 };
    for (std::size_t i = begin; i < end; ++i)
    {
      edge.Balance += this->Spokes[i].IsOutgoing ? 1 : -1;
      this->Result.Uses.push_back(this->Spokes[i].Half);
    }
    this->Result.Irregular.push_back(edge);
  }

  void RecordFans(std::int32_t vertex)
  {
    for (std::int32_t place = 1; place < this->Sets.Size(); ++place)
    {
      if (this->Sets.Find(place) == place)
      {
        this->Result.FurtherFans.push_back({ vertex, this->Triangles[std::size_t(place)] });
      }
    }
  }

  /** A fan that is open has a rim edge at either end; where many triangles share an edge, there may
   * be more of them. */
  void RecordRimJoins()
  {
    std::sort(this->Rims.begin(), this->Rims.end(), [this](std::size_t l, std::size_t r) {
      const std::int32_t fanOfL = this->Sets.Find(this->Spokes[l].Place);
      const std::int32_t fanOfR = this->Sets.Find(this->Spokes[r].Place);
      return fanOfL != fanOfR ? fanOfL < fanOfR : this->Spokes[l].Half < this->Spokes[r].Half;
    });
    for (std::size_t i = 1; i < this->Rims.size(); ++i)
    {
      const Spoke& before = this->Spokes[this->Rims[i - 1]];
      const Spoke& here = this->Spokes[this->Rims[i]];
      if (this->Sets.Find(before.Place) == this->Sets.Find(here.Place))
      {
        this->Result.RimJoins.push_back({ before.Half, here.Half });
      }
    }
  }

  const std::vector<std::int32_t>& Corners;
  const VertexFans& Fans;
  std::vector<HalfEdge>& Mates;
  Part& Result;
  Ring Around{};
  std::vector<Spoke> Spokes;
  std::vector<std::int32_t> Triangles; ///< around the vertex, but pinched ones
  DisjointSets Sets; ///< of their places
  std::vector<std::size_t> Rims; ///< spokes that one triangle has
};

template <class T>
void Append(std::vector<T>& all, const std::vector<T>& part)
{
  all.insert(all.end(), part.begin(), part.end());
}

} // namespace

MeshEdges FindMeshEdges(const std::vector<std::int32_t>& corners, std::int64_t numberOfPoints,
  const VertexFans& fans, Executor& executor)
{
  MeshEdges result;
  result.Mates.resize(corners.size());
  executor.For(
    static_cast<std::int64_t>(corners.size()), 1 << 15, [&](std::int64_t begin, std::int64_t end) {
      std::fill(result.Mates.begin() + begin, result.Mates.begin() + end, -1);
    });
  std::vector<Part> parts(static_cast<std::size_t>((numberOfPoints + Grain - 1) / Grain));
  executor.For(
    static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        FanExaminer examiner(corners, fans, result.Mates, parts[std::size_t(i)]);
        const std::int64_t last = std::min(numberOfPoints, (i + 1) * Grain);
        for (std::int64_t vertex = i * Grain; vertex < last; ++vertex)
        {
          examiner.Examine(static_cast<std::int32_t>(vertex));
        }
      }
    });
  for (Part& part : parts)
  {
    for (IrregularEdge& edge : part.Irregular)
    {
      edge.FirstUse += static_cast<std::int32_t>(result.Uses.size());
    }
    Append(result.Irregular, part.Irregular);
    Append(result.Uses, part.Uses);
    Append(result.FurtherFans, part.FurtherFans);
    Append(result.RimJoins, part.RimJoins);
  }
  return result;
}

} // namespace sb
