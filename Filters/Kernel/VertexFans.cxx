// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexFans.h"

#include "Hash.h"
#include "ParallelSort.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <memory>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 8192;
constexpr int HashBits = 33; // three digits of the radix sort; those that share them are compared

std::uint64_t HashPlace(const double* point)
{
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double coordinate = point[axis] + 0.0; // the two zeros are one place
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    hash = Mix(bits + 0x9e3779b97f4a7c15u * (hash + 1));
  }
  return hash;
}

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

void VertexFans::Build(const Surface& surface, Executor& executor)
{
  this->WeldPoints(surface, executor);
  const std::size_t numberOfPoints = static_cast<std::size_t>(surface.NumberOfPoints);
  const std::unique_ptr<std::atomic<std::int32_t>[]> counts(
    new std::atomic<std::int32_t>[numberOfPoints]);
  executor.For(surface.NumberOfPoints, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
    {
      counts[static_cast<std::size_t>(i)].store(0, std::memory_order_relaxed);
    }
  });
  const auto forEachCorner = [&](auto&& visit) {
    executor.For(surface.NumberOfTriangles, Grain, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          visit(static_cast<std::size_t>(this->VertexOf(surface.Triangles[3 * i + corner])),
            static_cast<std::int32_t>(i));
        }
      }
    });
  };
  forEachCorner([&](std::size_t vertex, std::int32_t) {
    counts[vertex].fetch_add(1, std::memory_order_relaxed);
  });
  this->Starts.resize(numberOfPoints);
  executor.For(surface.NumberOfPoints, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      this->Starts[i] = counts[i].exchange(0, std::memory_order_relaxed);
    }
  });
  this->Triangles.resize(static_cast<std::size_t>(ExclusivePrefixSum(this->Starts, executor)));
  forEachCorner([&](std::size_t vertex, std::int32_t triangle) {
    const std::int64_t place =
      this->Starts[vertex] + counts[vertex].fetch_add(1, std::memory_order_relaxed);
    this->Triangles[static_cast<std::size_t>(place)] = triangle;
  });
  // In the order of arrival until here; sorted, it depends on nothing but the surface.
  this->Ends.resize(numberOfPoints);
  executor.For(surface.NumberOfPoints, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      const auto first = this->Triangles.begin() + static_cast<std::ptrdiff_t>(this->Starts[i]);
      const auto last = first + counts[i].load(std::memory_order_relaxed);
      std::sort(first, last);
      this->Ends[i] = std::unique(first, last) - this->Triangles.begin();
    }
  });
}

} // namespace sb
