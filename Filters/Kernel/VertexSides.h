// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexSides.h
 * @brief Two streaming passes that tell which triangles are in front of all planes, which are not,
 * and which have to be looked at.
 *
 * A vertex gets one word of 16 bits: for each plane whether it is not in front, and whether it is
 * behind. Planes from the seventh on share their bits; what these say in doubt is left to the
 * closer look.
 */
#ifndef sb_VertexSides_h
#define sb_VertexSides_h

#include "Boolean.h"
#include "HalfSpace.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace sb
{

class VertexSides
{
public:
  using Word = std::uint16_t;
  static constexpr int PlaneBits = 7;
  static constexpr Word NotInFront = 0x007f; ///< a bit a plane
  static constexpr Word Behind = 0x3f80; ///< the same, shifted by PlaneBits
  static constexpr Word Used = 0x4000; ///< a triangle that is not dropped has it
  static constexpr Word NotFinite = 0x8000;

  std::unique_ptr<std::atomic<Word>[]> Words; ///< by vertex

  Word Of(std::int64_t vertex) const
  {
    return this->Words[std::size_t(vertex)].load(std::memory_order_relaxed);
  }
  /** Whether a vertex lies in front of all planes and has a triangle there; or, inside out, behind
   * one of them. */
  bool IsKept(std::int64_t vertex, bool insideOut) const
  {
    const Word word = this->Of(vertex);
    return insideOut ? (word & Used) != 0 && (word & Behind) != 0 : word == Used;
  }
  void MarkUsed(std::int64_t vertex, Word word)
  {
    if ((word & Used) == 0)
    {
      this->Words[std::size_t(vertex)].store(
        static_cast<Word>(word | Used), std::memory_order_relaxed);
    }
  }
};

VertexSides FindVertexSides(const Surface& mesh, const Lattice& lattice,
  const std::vector<HalfSpace>& planes, Executor& executor);

struct FaceSides
{
  std::vector<std::int32_t> Touched; ///< triangles to be looked at, ascending
  std::int64_t BadIndex = -1; ///< the first triangle that names a point which does not exist
  std::int64_t BadCoordinate = -1; ///< the first triangle with a corner that is not finite
};

/**
 * Sets the fates of all triangles (Split means that it has to be looked at), and marks the vertices
 * in use. Inside out, kept is what is dropped otherwise; a triangle may then be kept and touched.
 */
FaceSides FindFaceSides(const Surface& mesh, VertexSides& sides, std::size_t numberOfPlanes,
  bool insideOut, std::vector<Fate>& fates, Executor& executor);

} // namespace sb

#endif
