// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexFans.h
 * @brief The triangles around each vertex, where points at one place are one vertex.
 *
 * A surface with split normals has several points at a corner. Their triangles make one fan, so
 * that the normal there is that of the corner and not of one of its sides.
 */
#ifndef sb_VertexFans_h
#define sb_VertexFans_h

#include "Boolean.h"
#include "Executor.h"

#include <cstdint>
#include <vector>

namespace sb
{

class VertexFans
{
public:
  void Build(const Surface& surface, Executor& executor);

  /** A vertex is named by the first of its points. */
  std::int32_t VertexOf(std::int32_t point) const
  {
    return this->Vertices.empty() ? point : this->Vertices[static_cast<std::size_t>(point)];
  }

  struct Fan
  {
    const std::int32_t* First;
    const std::int32_t* Last;
    const std::int32_t* begin() const { return this->First; }
    const std::int32_t* end() const { return this->Last; }
  };

  /** The triangles that have the vertex, ascending; each once. */
  Fan Around(std::int32_t vertex) const
  {
    const std::int32_t* triangles = this->Triangles.data();
    return { triangles + this->Starts[static_cast<std::size_t>(vertex)],
      triangles + this->Starts[static_cast<std::size_t>(vertex) + 1] };
  }

private:
  void WeldPoints(const Surface& surface, Executor& executor);
  template <class Visit>
  void ForEachVertex(const std::int32_t* points, Visit&& visit) const;

  std::vector<std::int32_t> Vertices; ///< [point], empty if all points are apart
  std::vector<std::int64_t> Starts; ///< [vertex], and the end of the last one
  std::vector<std::int32_t> Triangles;
};

} // namespace sb

#endif
