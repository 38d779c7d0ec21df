// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexFans.h"

#include "Hash.h"
#include "ParallelSort.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 8192;
constexpr int HashBits = 33; // three digits of the radix sort; those that share them are compared

bool SamePlace(const double* points, std::int32_t a, std::int32_t b)
{
  const double* p = points + 3 * std::int64_t(a);
  const double* q = points + 3 * std::int64_t(b);
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

} // namespace

void VertexFans::WeldPoints(const Surface& surface, Executor& executor)
{
  std::vector<KeyedIndex> keys(static_cast<std::size_t>(surface.NumberOfPoints));
  executor.For(surface.NumberOfPoints, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      const double* point = surface.Points + 3 * i;
      const bool isPlace = point[0] == point[0] && point[1] == point[1] && point[2] == point[2];
      // What is not a number equals nothing: many of them are not to be compared with one another.
      keys[static_cast<std::size_t>(i)] = { isPlace ? HashPlace(point)
                                                    : Mix(static_cast<std::uint64_t>(i)),
        static_cast<std::int32_t>(i) };
    }
  });
  const std::uint64_t mask = (std::uint64_t(1) << HashBits) - 1;
  RadixSort(
    keys, [](const KeyedIndex& keyed) { return keyed.Key; }, HashBits, executor);
  this->Vertices.clear();
  // The sort is stable, so the first of equal places is the one with the smallest id.
  for (std::size_t begin = 0; begin < keys.size();)
  {
    std::size_t end = begin + 1;
    while (end < keys.size() && ((keys[end].Key ^ keys[begin].Key) & mask) == 0)
    {
      for (std::size_t other = begin; other < end; ++other)
      {
        if (SamePlace(surface.Points, keys[other].Index, keys[end].Index))
        {
          if (this->Vertices.empty())
          {
            this->Vertices.resize(keys.size());
            for (std::size_t i = 0; i < keys.size(); ++i)
            {
              this->Vertices[i] = static_cast<std::int32_t>(i);
            }
          }
          this->Vertices[static_cast<std::size_t>(keys[end].Index)] = keys[other].Index;
          break;
        }
      }
      ++end;
    }
    begin = end;
  }
}

/** Each of a triangle's vertices once, though points may be at one place. */
template <class Visit>
void VertexFans::ForEachVertex(const std::int32_t* points, Visit&& visit) const
{
  const std::int32_t a = this->VertexOf(points[0]);
  const std::int32_t b = this->VertexOf(points[1]);
  const std::int32_t c = this->VertexOf(points[2]);
  visit(static_cast<std::size_t>(a));
  if (b != a)
  {
    visit(static_cast<std::size_t>(b));
  }
  if (c != a && c != b)
  {
    visit(static_cast<std::size_t>(c));
  }
}

void VertexFans::Build(const Surface& surface, Executor& executor)
{
  this->WeldPoints(surface, executor);
  // Each part of the triangles has a count of its own for each vertex, so that no two threads
  // change the same one, and triangles of a vertex come in their order.
  constexpr std::int64_t most = 4;
  const std::int64_t numberOfParts = std::clamp<std::int64_t>(
    surface.NumberOfTriangles / Grain, 1, std::min<std::int64_t>(most, executor.NumberOfThreads()));
  std::vector<std::vector<std::int32_t>> counts(static_cast<std::size_t>(numberOfParts));
  const auto forEachCorner = [&](auto&& visit) {
    executor.For(numberOfParts, 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t part = begin; part < end; ++part)
      {
        std::vector<std::int32_t>& ofPart = counts[static_cast<std::size_t>(part)];
        ofPart.resize(static_cast<std::size_t>(surface.NumberOfPoints));
        const std::int64_t last = surface.NumberOfTriangles * (part + 1) / numberOfParts;
        for (std::int64_t i = surface.NumberOfTriangles * part / numberOfParts; i < last; ++i)
        {
          this->ForEachVertex(surface.Triangles + 3 * i, [&](std::size_t vertex) {
            visit(vertex, ofPart[vertex]++, static_cast<std::int32_t>(i));
          });
        }
      }
    });
  };
  forEachCorner([](std::size_t, std::int32_t, std::int32_t) {});
  this->Starts.resize(static_cast<std::size_t>(surface.NumberOfPoints) + 1);
  executor.For(surface.NumberOfPoints, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      std::int32_t sum = 0;
      for (std::vector<std::int32_t>& ofPart : counts)
      {
        sum += std::exchange(ofPart[i], sum);
      }
      this->Starts[i] = sum;
    }
  });
  this->Starts.back() = 0;
  this->Triangles.resize(static_cast<std::size_t>(ExclusivePrefixSum(this->Starts, executor)));
  forEachCorner([&](std::size_t vertex, std::int32_t place, std::int32_t triangle) {
    this->Triangles[static_cast<std::size_t>(this->Starts[vertex] + place)] = triangle;
  });
}

} // namespace sb
