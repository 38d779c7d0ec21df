// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CopyRun.h
 * @brief A stretch of output points or cells that are copies of one operand's.
 */
#ifndef CopyRun_h
#define CopyRun_h

#include "vtkType.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace sbvtk
{

/** Output entries [First, First + Count) are copies of the entries Id(0), ... Id(Count - 1) of an
 * operand. */
struct CopyRun
{
  std::int32_t Operand = 0;
  std::int64_t First = 0;
  std::int64_t Count = 0;
  const std::int32_t* PointIds = nullptr; ///< the kernel's point ids, or
  const vtkIdType* CellIds = nullptr; ///< VTK's cell ids

  std::int64_t Id(std::int64_t i) const
  {
    return this->PointIds ? this->PointIds[i] : this->CellIds[i];
  }
};

/**
 * Copy the entries [begin, end) of a run, each `size` bytes, from the operand's array to the
 * output's. Where the ids are consecutive, which is nearly everywhere, this is one memcpy a block.
 */
inline void CopyEntries(const CopyRun& run, std::int64_t begin, std::int64_t end,
  const char* source, char* target, std::int64_t size)
{
  constexpr std::int64_t blockLength = 256;
  for (std::int64_t block = begin; block < end; block += blockLength)
  {
    const std::int64_t blockEnd = std::min(end, block + blockLength);
    bool consecutive = true;
    for (std::int64_t i = block + 1; i < blockEnd; ++i)
    {
      consecutive &= run.Id(i) == run.Id(i - 1) + 1;
    }
    char* out = target + (run.First + block) * size;
    if (consecutive)
    {
      std::memcpy(out, source + run.Id(block) * size, (blockEnd - block) * size);
      continue;
    }
    for (std::int64_t i = block; i < blockEnd; ++i, out += size)
    {
      std::memcpy(out, source + run.Id(i) * size, size);
    }
  }
}

} // namespace sbvtk

#endif
