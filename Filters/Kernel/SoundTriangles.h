// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SoundTriangles.h
 * @brief The triangles that can be looked at: those whose points exist and are numbers.
 */
#ifndef sb_SoundTriangles_h
#define sb_SoundTriangles_h

#include "Boolean.h"
#include "CellRuns.h"
#include "Executor.h"

#include <cstdint>
#include <vector>

namespace sb
{

class SoundTriangles
{
public:
  /** The surface and the runs have to outlive this. */
  SoundTriangles(const Surface& surface, const CellRuns& cells, Executor& executor);
  SoundTriangles(const SoundTriangles&) = delete;
  SoundTriangles& operator=(const SoundTriangles&) = delete;

  /** The same points, and the triangles that are sound. */
  const Surface& Mesh() const { return this->Sound; }
  /** The same cells, some of which may have lost triangles. */
  const CellRuns& Cells() const { return this->SoundCells; }

  /** The number that a sound triangle has in the surface as it was given. */
  std::int32_t Original(std::int32_t triangle) const
  {
    return this->Originals.empty() ? triangle : this->Originals[static_cast<std::size_t>(triangle)];
  }

  std::int64_t NumberWithBadIndex() const { return this->BadIndices; }
  std::int64_t NumberNotFinite() const { return this->NotFinite; }
  std::int64_t FirstUnsound() const { return this->First; } ///< -1 if none

private:
  enum class Soundness : std::uint8_t
  {
    Sound,
    BadIndex,
    NotFinite
  };

  Soundness Judge(const Surface& surface, std::int64_t triangle) const;
  void Filter(const Surface& surface, const CellRuns& cells);

  Surface Sound;
  CellRuns SoundCells;
  std::int64_t BadIndices = 0;
  std::int64_t NotFinite = 0;
  std::int64_t First = -1;
  std::vector<std::int32_t> Originals; ///< empty if all are sound
  std::vector<std::int32_t> Triangles;
  std::vector<std::int32_t> Firsts;
};

/** Whether all three coordinates of a point are numbers, and not infinite. */
bool IsFinitePoint(const double* point);

} // namespace sb

#endif
