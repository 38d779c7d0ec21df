// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointTable.h"

#include "ParallelSort.h"

#include <algorithm>

namespace sb
{

std::vector<NodeId> PointTable::Insert(
  const std::vector<ContactPoint>& points, Executor& executor)
{
  std::vector<Key> keys(points.size());
  executor.For(static_cast<std::int64_t>(points.size()), 1024,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const ContactPoint& point = points[std::size_t(i)];
        keys[std::size_t(i)] = { point.Point.Fingerprint(), point.Vertex,
          static_cast<std::int32_t>(i) };
      }
    });
  ParallelSort(keys, Before, executor);

  std::vector<NodeId> nodes(points.size());
  std::vector<Key> fresh;
  auto known = this->Known.begin();
  for (std::size_t first = 0; first < keys.size();)
  {
    std::size_t last = first;
    std::int32_t vertex = -1;
    for (; last < keys.size() && keys[last].Print == keys[first].Print; ++last)
    {
      if (keys[last].Vertex >= 0 && (vertex < 0 || keys[last].Vertex < vertex))
      {
        vertex = keys[last].Vertex;
      }
    }
    while (known != this->Known.end() && known->Print < keys[first].Print)
    {
      ++known;
    }
    NodeId node;
    if (known != this->Known.end() && known->Print == keys[first].Print)
    {
      node = known->Index;
    }
    else
    {
      node = this->Size();
      this->Points.push_back({ points[std::size_t(keys[first].Index)].Point, vertex });
      fresh.push_back({ keys[first].Print, vertex, node });
    }
    for (; first < last; ++first)
    {
      nodes[std::size_t(keys[first].Index)] = node;
    }
  }
  const auto middle = static_cast<std::ptrdiff_t>(this->Known.size());
  this->Known.insert(this->Known.end(), fresh.begin(), fresh.end());
  std::inplace_merge(this->Known.begin(), this->Known.begin() + middle, this->Known.end(), Before);
  return nodes;
}

} // namespace sb
