// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CombinedMesh.h"

#include "Hash.h"
#include "ParallelSort.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace sb
{
namespace
{

std::uint64_t Bits(double value)
{
  value += 0.0; // the two zeros are one place
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/** Collects triangles by provisional point numbers, part after part. */
class Combiner
{
public:
  explicit Combiner(const std::vector<Surface>& meshes)
    : Meshes(meshes)
  {
  }

  void Add(const CombinedPart& part)
  {
    const CutSurfaces& cut = *part.Cut;
    const std::size_t operand = part.Source;
    if (&cut != this->LastCut)
    {
      this->LastCut = &cut;
      this->First = static_cast<std::int32_t>(this->Mesh.OriginalPoint.size());
      this->AddPoints(cut);
    }
    const std::int32_t first = this->First;
    const std::vector<Fate>& fates = cut.Fates[operand];
    for (std::size_t t = 0; t < fates.size(); ++t)
    {
      const bool whole = fates[t] == Fate::Kept || fates[t] == Fate::KeptReversed;
      const double confidence = part.TriangleConfidence ? (*part.TriangleConfidence)[t] : 1.0;
      if (whole && confidence >= 0.0)
      {
        const std::int32_t* const ids = this->Meshes[operand].Triangles + 3 * t;
        const std::vector<std::int32_t>& map = cut.PointMap[operand];
        this->AddTriangle(part, static_cast<std::int32_t>(t), fates[t] == Fate::KeptReversed,
          confidence,
          { first + map[static_cast<std::size_t>(ids[0])],
            first + map[static_cast<std::size_t>(ids[1])],
            first + map[static_cast<std::size_t>(ids[2])] });
      }
    }
    for (std::size_t p = 0; p < cut.Split.Corners.size(); ++p)
    {
      const double confidence = part.PieceConfidence ? (*part.PieceConfidence)[p] : 1.0;
      if (cut.Split.Operand[p] == part.Source && confidence >= 0.0)
      {
        const std::array<std::int32_t, 3>& ids = cut.Split.Corners[p];
        this->AddTriangle(part, cut.Split.Parent[p], cut.Split.Reversed[p] != 0, confidence,
          { first + ids[0], first + ids[1], first + ids[2] });
      }
    }
  }

  /** Join points at one place, and drop those that no triangle uses. */
  CombinedMesh Finish(Executor& executor)
  {
    const std::size_t count = this->Mesh.OriginalPoint.size();
    const std::vector<std::int32_t> same = FirstAtPlace(this->Mesh.Points.data(), count, executor);
    std::vector<std::int32_t> number(count, -1);
    for (std::int32_t& corner : this->Mesh.Triangles)
    {
      corner = same[static_cast<std::size_t>(corner)];
      number[static_cast<std::size_t>(corner)] = 0;
    }
    std::int32_t used = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (number[i] == 0)
      {
        const std::size_t to = static_cast<std::size_t>(used);
        std::copy_n(this->Mesh.Points.begin() + 3 * static_cast<std::int64_t>(i), 3,
          this->Mesh.Points.begin() + 3 * static_cast<std::int64_t>(used));
        this->Mesh.OriginalPoint[to] = this->Mesh.OriginalPoint[i];
        this->Mesh.PointSource[to] = this->Mesh.PointSource[i];
        number[i] = used++;
      }
    }
    this->Mesh.Points.resize(3 * static_cast<std::size_t>(used));
    this->Mesh.OriginalPoint.resize(static_cast<std::size_t>(used));
    this->Mesh.PointSource.resize(static_cast<std::size_t>(used));
    for (std::int32_t& corner : this->Mesh.Triangles)
    {
      corner = number[static_cast<std::size_t>(corner)];
    }
    return std::move(this->Mesh);
  }

private:
  /** All points of the cut: those of its operands that it keeps, then the others. */
  void AddPoints(const CutSurfaces& cut)
  {
    for (std::size_t operand = 0; operand < cut.KeptPoints.size(); ++operand)
    {
      for (const std::int32_t id : cut.KeptPoints[operand])
      {
        this->AddPoint(
          this->Meshes[operand].Points + 3 * static_cast<std::size_t>(id), id, operand);
      }
    }
    for (const InterpolatedPoint& point : cut.Interpolated)
    {
      this->AddPoint(point.Position.data(), -1, 0);
    }
  }

  void AddPoint(const double* place, std::int32_t original, std::size_t operand)
  {
    this->Mesh.Points.insert(this->Mesh.Points.end(), place, place + 3);
    this->Mesh.OriginalPoint.push_back(original);
    this->Mesh.PointSource.push_back(static_cast<std::uint8_t>(operand));
  }

  void AddTriangle(const CombinedPart& part, std::int32_t parent, bool reversed, double confidence,
    std::array<std::int32_t, 3> corners)
  {
    const bool turned = reversed != part.TurnOver;
    if (turned)
    {
      std::swap(corners[1], corners[2]);
    }
    this->Mesh.Triangles.insert(this->Mesh.Triangles.end(), corners.begin(), corners.end());
    this->Mesh.Source.push_back(part.Source);
    this->Mesh.Parent.push_back(parent);
    this->Mesh.Reversed.push_back(turned ? 1 : 0);
    this->Mesh.Confidence.push_back(confidence);
  }

  const std::vector<Surface>& Meshes;
  const CutSurfaces* LastCut = nullptr;
  std::int32_t First = 0;
  CombinedMesh Mesh;
};

} // namespace

std::vector<std::int32_t> FirstAtPlace(const double* points, std::size_t count, Executor& executor)
{
  std::vector<KeyedIndex> keys(count);
  executor.For(
    static_cast<std::int64_t>(count), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const double* const p = points + 3 * i;
        keys[i] = { Mix(Bits(p[0]) + Mix(Bits(p[1]) + Mix(Bits(p[2])))),
          static_cast<std::int32_t>(i) };
      }
    });
  RadixSort(
    keys, [](const KeyedIndex& key) { return key.Key; }, 64, executor);
  std::vector<std::int32_t> first(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    // The sort is stable: of equal hashes the smaller number comes first.
    const std::size_t self = static_cast<std::size_t>(keys[i].Index);
    first[self] = keys[i].Index;
    for (std::size_t j = i; j > 0 && keys[j - 1].Key == keys[i].Key; --j)
    {
      const std::size_t other = static_cast<std::size_t>(keys[j - 1].Index);
      const double* const p = points + 3 * self;
      const double* const q = points + 3 * other;
      if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2])
      {
        first[self] = first[other];
        break;
      }
    }
  }
  return first;
}

CombinedMesh Combine(
  const std::vector<CombinedPart>& parts, const std::vector<Surface>& meshes, Executor& executor)
{
  Combiner combiner(meshes);
  for (const CombinedPart& part : parts)
  {
    combiner.Add(part);
  }
  return combiner.Finish(executor);
}

} // namespace sb
