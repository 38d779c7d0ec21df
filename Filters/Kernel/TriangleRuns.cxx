// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleRuns.h"

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
  const std::int32_t count = this->NumberOfRuns();
  // Not initialised: the pages are first touched by the threads that fill them.
  const std::unique_ptr<Box[]> boxes(new Box[std::size_t(count)]);
  this->Boxes.reset(new EightBoxes[std::size_t(count)]);
  this->Normals.reset(new std::array<float, 3>[std::size_t(count)]);
  this->Views.reset(new std::uint8_t[std::size_t(count)]);
  const Lengths lengths = this->MakeRuns(boxes.get());
  // A strip of eight triangles is eight times as long as one of them. Were it much longer, runs
  // would meet many others.
  constexpr double longest = 4.0;
  if (lengths.Runs > longest * lengths.Triangles)
  {
    this->SortFaces();
    this->MakeRuns(boxes.get());
  }
  this->Hierarchy.Build(boxes.get(), count, executor);
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

TriangleRuns::Lengths TriangleRuns::MakeRuns(Box* boxes)
{
  constexpr std::int64_t grain = Grain / Width;
  const std::int64_t count = this->NumberOfRuns();
  std::vector<Lengths> parts(std::size_t((count + grain - 1) / grain));
  this->Threads.For(
    static_cast<std::int64_t>(parts.size()), 1, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t part = begin; part < end; ++part)
      {
        Lengths sum;
        for (std::int64_t run = part * grain; run < std::min(count, (part + 1) * grain); ++run)
        {
          const Lengths more = this->MakeRun(static_cast<std::int32_t>(run), boxes[run]);
          sum.Triangles += more.Triangles;
          sum.Runs += more.Runs;
        }
        parts[std::size_t(part)] = sum;
      }
    });
  Lengths total;
  for (const Lengths& part : parts)
  {
    total.Triangles += part.Triangles;
    total.Runs += part.Runs;
  }
  return total;
}

TriangleRuns::Lengths TriangleRuns::MakeRun(std::int32_t run, Box& total)
{
  const std::int32_t first = Width * run;
  const std::int32_t count = std::min(Width, static_cast<std::int32_t>(this->Faces.size()) - first);
  Lengths lengths;
  unsigned views = (1u << NumberOfViews) - 1;
  std::array<float, 3> normal{};
  for (std::int32_t lane = 0; lane < Width; ++lane)
  {
    if (lane >= count)
    {
      this->Boxes[std::size_t(run)].Set(lane, FloatBox::Nothing());
      continue;
    }
    const std::int32_t face = this->Faces[std::size_t(first + lane)];
    const Box box = this->BoxOf(face);
    lane == 0 ? void(total = box) : Enclose(total, box);
    lengths.Triangles += LongestSide(box);
    this->Boxes[std::size_t(run)].Set(lane, this->ToFrame(box));
    const std::int32_t* ids = this->World.Mesh(0).Triangles + 3 * std::size_t(face);
    views &= ViewsFacing(
      this->World.Position(ids[0]), this->World.Position(ids[1]), this->World.Position(ids[2]));
    this->AddNormal(face, normal);
  }
  this->Normals[std::size_t(run)] = normal;
  this->Views[std::size_t(run)] = static_cast<std::uint8_t>(views);
  lengths.Runs = LongestSide(total);
  return lengths;
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

void TriangleRuns::AddNormal(std::int32_t face, std::array<float, 3>& sum) const
{
  const std::int32_t* ids = this->World.Mesh(0).Triangles + 3 * std::size_t(face);
  const double* a = this->World.Position(ids[0]);
  const double* b = this->World.Position(ids[1]);
  const double* c = this->World.Position(ids[2]);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    sum[axis] += static_cast<float>((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
  }
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

void TriangleRuns::NotePlaces()
{
  this->Places.resize(std::size_t(this->World.NumberOfFaces()), -1);
  this->Threads.For(this->Hierarchy.Size(), Grain, [&](std::int64_t begin, std::int64_t end) {
    for (auto place = static_cast<std::int32_t>(begin); place < end; ++place)
    {
      const std::int32_t* faces = this->FacesOf(place);
      std::for_each(faces, faces + this->NumberOfFaces(place),
        [&](std::int32_t face) { this->Places[std::size_t(face)] = place; });
    }
  });
}

} // namespace sb
