// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleRuns.h"

#include "PatchOutline.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace sb
{

namespace
{

constexpr std::int64_t Grain = 4096;

} // namespace

TriangleRuns::TriangleRuns(
  const Scene& scene, const std::vector<std::uint8_t>& leftOut, Executor& executor)
  : World(scene)
  , Threads(executor)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::array<double, 6>& bounds = scene.Bounds(0);
    this->Middle[axis] = 0.5 * bounds[2 * axis] + 0.5 * bounds[2 * axis + 1];
  }
  this->ListFaces(leftOut);
  // Runs of one or two triangles are those of a mesh whose neighbours are not together.
  constexpr std::size_t fewest = 3;
  if (fewest * this->MakeRuns() > this->Faces.size())
  {
    this->SortFaces();
    this->MakeRuns();
  }
  this->BuildTree();
  this->NotePlaces();
}

void TriangleRuns::ListFaces(const std::vector<std::uint8_t>& leftOut)
{
  const std::int32_t count = this->World.NumberOfFaces();
  if (leftOut.empty())
  {
    this->Faces.resize(std::size_t(count));
    std::iota(this->Faces.begin(), this->Faces.end(), 0);
    return;
  }
  for (std::int32_t face = 0; face < count; ++face)
  {
    if (!leftOut[std::size_t(face)])
    {
      this->Faces.push_back(face);
    }
  }
}

/** Along the curve of a hierarchy of them all. */
void TriangleRuns::SortFaces()
{
  const auto count = static_cast<std::int32_t>(this->Faces.size());
  const std::unique_ptr<Box[]> boxes(new Box[std::size_t(count)]);
  this->Threads.For(count, Grain, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i)
    {
      boxes[i] = this->BoxOf(this->Faces[i]);
    }
  });
  BVH curve;
  curve.Build(boxes.get(), count, this->Threads);
  std::vector<std::int32_t> sorted(this->Faces.size());
  std::transform(curve.Order().begin(), curve.Order().end(), sorted.begin(),
    [this](std::int32_t i) { return this->Faces[std::size_t(i)]; });
  this->Faces = std::move(sorted);
}

/** @return how many there are. */
std::size_t TriangleRuns::MakeRuns()
{
  const auto count = static_cast<std::int64_t>(this->Faces.size());
  this->Parts.clear();
  this->Parts.resize(std::size_t((count + Grain - 1) / Grain));
  this->Threads.For(
    static_cast<std::int64_t>(this->Parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t part = begin; part < end; ++part)
      {
        this->MakeRunsOfPart(static_cast<std::int32_t>(part * Grain),
          static_cast<std::int32_t>(std::min(count, (part + 1) * Grain)),
          this->Parts[std::size_t(part)]);
      }
    });
  std::size_t total = 0;
  for (const std::vector<TriangleRun>& part : this->Parts)
  {
    total += part.size();
  }
  return total;
}

/** A run ends where it would be longer than its triangles end to end. */
void TriangleRuns::MakeRunsOfPart(
  std::int32_t begin, std::int32_t end, std::vector<TriangleRun>& runs) const
{
  runs.reserve(std::size_t((end - begin) / 6));
  double length = 0.0;
  for (std::int32_t i = begin; i < end; ++i)
  {
    const std::int32_t face = this->Faces[std::size_t(i)];
    const Box box = this->BoxOf(face);
    length += LongestSide(box);
    if (!runs.empty() && runs.back().Size < MostFaces)
    {
      Box total = runs.back().Bounds;
      Enclose(total, box);
      if (LongestSide(total) <= length)
      {
        runs.back().Bounds = total;
        this->Add(face, box, runs.back());
        continue;
      }
    }
    runs.push_back({ {}, box, {}, i, 0, (1u << NumberOfViews) - 1 });
    for (int lane = 0; lane < EightBoxes::Width; ++lane)
    {
      runs.back().Boxes.Set(lane, FloatBox::Nothing());
    }
    this->Add(face, box, runs.back());
    length = LongestSide(box);
  }
}

void TriangleRuns::Add(std::int32_t face, const Box& box, TriangleRun& run) const
{
  const std::int32_t* ids = this->World.Mesh(0).Triangles + 3 * std::size_t(face);
  const double* a = this->World.Position(ids[0]);
  const double* b = this->World.Position(ids[1]);
  const double* c = this->World.Position(ids[2]);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    run.Normal[axis] +=
      static_cast<float>((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
  }
  run.Views &= ViewsFacing(a, b, c);
  run.Boxes.Set(run.Size++, this->ToFrame(box));
}

/** Every step is monotone, so boxes that meet as doubles meet as floats, too. */
FloatBox TriangleRuns::ToFrame(const Box& box) const
{
  FloatBox inFrame;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    inFrame.Lower[axis] = static_cast<float>(box.Lower[axis] - this->Middle[axis]);
    inFrame.Upper[axis] = static_cast<float>(box.Upper[axis] - this->Middle[axis]);
  }
  return inFrame;
}

Box TriangleRuns::BoxOf(std::int32_t face) const
{
  const std::int32_t* ids = this->World.Mesh(0).Triangles + 3 * std::size_t(face);
  const double* a = this->World.Position(ids[0]);
  const double* b = this->World.Position(ids[1]);
  const double* c = this->World.Position(ids[2]);
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.Lower[axis] = std::min({ a[axis], b[axis], c[axis] });
    box.Upper[axis] = std::max({ a[axis], b[axis], c[axis] });
  }
  return box;
}

void TriangleRuns::BuildTree()
{
  std::vector<const TriangleRun*> inOrder;
  std::vector<Box> boxes;
  for (const std::vector<TriangleRun>& part : this->Parts)
  {
    for (const TriangleRun& run : part)
    {
      inOrder.push_back(&run);
      boxes.push_back(run.Bounds);
    }
  }
  this->Hierarchy.Build(boxes.data(), static_cast<std::int32_t>(boxes.size()), this->Threads);
  for (const std::int32_t i : this->Hierarchy.Order())
  {
    this->ByPlace.push_back(inOrder[std::size_t(i)]);
  }
}

void TriangleRuns::NotePlaces()
{
  this->Places.resize(std::size_t(this->World.NumberOfFaces()), -1);
  this->Threads.For(this->Count(), Grain / MostFaces, [&](std::int64_t begin, std::int64_t end) {
    for (auto place = static_cast<std::int32_t>(begin); place < end; ++place)
    {
      const std::int32_t* faces = this->FacesOf(place);
      std::for_each(faces, faces + (*this)[place].Size,
        [&](std::int32_t face) { this->Places[std::size_t(face)] = place; });
    }
  });
}

} // namespace sb
