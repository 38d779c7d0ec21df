// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointTable.h"

#include "ParallelSort.h"

#include <algorithm>

namespace sb
{

std::vector<NodeId> PointTable::Insert(const std::vector<ContactPoint>& points, Executor& executor)
{
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double* p = points[i].Point.Approximation();
    keys[i] = { { p[0], p[1], p[2] }, static_cast<std::int32_t>(i) };
  }
  ParallelSort(keys, Before, executor);

  std::vector<NodeId> nodes(points.size());
  std::vector<Key> fresh;
  std::vector<NodeId> here; // the nodes at one place
  auto known = this->Known.begin();
  for (std::size_t i = 0; i < keys.size();)
  {
    const std::array<double, 3> place = keys[i].Place;
    while (known != this->Known.end() && known->Place < place)
    {
      ++known;
    }
    here.clear();
    for (; known != this->Known.end() && known->Place == place; ++known)
    {
      here.push_back(known->Index);
    }
    for (; i < keys.size() && keys[i].Place == place; ++i)
    {
      const ContactPoint& point = points[std::size_t(keys[i].Index)];
      const auto same = std::find_if(here.begin(), here.end(),
        [&](NodeId node) { return SamePoint(this->Point(node), point.Point); });
      NodeId& node = nodes[std::size_t(keys[i].Index)];
      if (same == here.end())
      {
        node = this->Size();
        this->Points.push_back(point);
        here.push_back(node);
        fresh.push_back({ place, node });
        continue;
      }
      node = *same;
      std::int32_t& vertex = this->Points[std::size_t(node)].Vertex;
      if (point.Vertex >= 0 && (vertex < 0 || point.Vertex < vertex))
      {
        vertex = point.Vertex;
      }
    }
  }
  const auto middle = static_cast<std::ptrdiff_t>(this->Known.size());
  this->Known.insert(this->Known.end(), fresh.begin(), fresh.end());
  std::inplace_merge(this->Known.begin(), this->Known.begin() + middle, this->Known.end(), Before);
  return nodes;
}

} // namespace sb
