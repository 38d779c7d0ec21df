// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SoundTriangles.h"

#include <atomic>
#include <cmath>

namespace sb
{

bool IsFinitePoint(const double* point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

SoundTriangles::SoundTriangles(const Surface& surface, const CellRuns& cells, Executor& executor)
  : Sound(surface)
  , SoundCells(cells)
{
  std::atomic<bool> isAllSound{ true };
  executor.For(surface.NumberOfTriangles, 1 << 14, [&](std::int64_t begin, std::int64_t end) {
    bool isSound = true;
    for (std::int64_t i = begin; i < end; ++i)
    {
      isSound = isSound && this->Judge(surface, i) == Soundness::Sound;
    }
    if (!isSound)
    {
      isAllSound = false;
    }
  });
  if (!isAllSound)
  {
    this->Filter(surface, cells);
  }
}

SoundTriangles::Soundness SoundTriangles::Judge(const Surface& surface, std::int64_t triangle) const
{
  const std::int32_t* ids = surface.Triangles + 3 * triangle;
  for (int i = 0; i < 3; ++i)
  {
    if (ids[i] < 0 || ids[i] >= surface.NumberOfPoints)
    {
      return Soundness::BadIndex;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    if (!IsFinitePoint(surface.Points + 3 * std::int64_t(ids[i])))
    {
      return Soundness::NotFinite;
    }
  }
  return Soundness::Sound;
}

void SoundTriangles::Filter(const Surface& surface, const CellRuns& cells)
{
  for (std::int64_t cell = 0; cell < cells.NumberOfCells; ++cell)
  {
    this->Firsts.push_back(static_cast<std::int32_t>(this->Originals.size()));
    for (std::int32_t i = cells.First(cell); i < cells.First(cell + 1); ++i)
    {
      const Soundness soundness = this->Judge(surface, i);
      if (soundness == Soundness::Sound)
      {
        this->Originals.push_back(i);
        this->Triangles.insert(this->Triangles.end(), surface.Triangles + 3 * std::int64_t(i),
          surface.Triangles + 3 * std::int64_t(i) + 3);
        continue;
      }
      this->First = this->First < 0 ? i : this->First;
      this->BadIndices += soundness == Soundness::BadIndex;
      this->NotFinite += soundness == Soundness::NotFinite;
    }
  }
  this->Firsts.push_back(static_cast<std::int32_t>(this->Originals.size()));
  this->Originals.push_back(-1); // so that it is not empty, even if nothing is sound
  this->Sound.Triangles = this->Triangles.data();
  this->Sound.NumberOfTriangles = static_cast<std::int64_t>(this->Triangles.size() / 3);
  this->SoundCells.Firsts = this->Firsts.data();
}

} // namespace sb
