// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTriangleBlocks.cxx
 * @brief Blocks enclose their triangles; those marked are those that meet another surface's block,
 * and where neighbours are listed together these are few.
 */
#include "Check.h"
#include "ThreadExecutor.h"
#include "TriangleBlocks.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using Runs = std::vector<std::pair<std::int64_t, std::int64_t>>;
constexpr std::int64_t Size = sb::TriangleBlock::Size;

/** A strip of triangles in the plane z = height along the x axis, from x = begin on, half a unit a
 * triangle. */
struct Strip
{
  Strip(double begin, double height, std::int64_t triangles)
  {
    for (std::int64_t i = 0; i < triangles + 2; ++i)
    {
      this->Points.insert(this->Points.end(), { begin + 0.5 * double(i), double(i % 2), height });
    }
    for (std::int32_t i = 0; i < triangles; ++i)
    {
      this->Triangles.insert(this->Triangles.end(), { i, i + 1, i + 2 });
    }
  }

  std::int64_t NumberOfTriangles() const
  {
    return static_cast<std::int64_t>(this->Triangles.size() / 3);
  }

  std::vector<sb::TriangleBlock> Blocks(int threads = 1) const
  {
    sb::ThreadExecutor executor(threads);
    return sb::BlocksOf(
      this->Points.data(), this->Triangles.data(), this->NumberOfTriangles(), executor);
  }

  /** List the triangles in another order. */
  void Shuffle()
  {
    std::vector<std::int32_t> order(static_cast<std::size_t>(this->NumberOfTriangles()));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    std::vector<std::int32_t> shuffled;
    for (const std::int32_t triangle : order)
    {
      const auto first = this->Triangles.begin() + 3 * triangle;
      shuffled.insert(shuffled.end(), first, first + 3);
    }
    this->Triangles = shuffled;
  }

  std::vector<double> Points;
  std::vector<std::int32_t> Triangles;
};

sb::Box BoundsOf(const std::vector<sb::TriangleBlock>& blocks)
{
  sb::Box all = blocks.front().Bounds;
  for (const sb::TriangleBlock& block : blocks)
  {
    sb::Enclose(all, block.Bounds);
  }
  return all;
}

/** The runs of marked blocks of two strips that are near one another. */
std::vector<Runs> RunsOfMeeting(const Strip& a, const Strip& b)
{
  const std::vector<sb::TriangleBlock> ofA = a.Blocks();
  const std::vector<sb::TriangleBlock> ofB = b.Blocks();
  const std::vector<const std::vector<sb::TriangleBlock>*> both{ &ofA, &ofB };
  sb::ThreadExecutor executor(2);
  sb::NearBlocks near(both, executor);
  sb::Box common = BoundsOf(ofA);
  const sb::Box other = BoundsOf(ofB);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    common.Lower[axis] = std::max(common.Lower[axis], other.Lower[axis]);
    common.Upper[axis] = std::min(common.Upper[axis], other.Upper[axis]);
  }
  near.MarkMeeting(0, 1, common);
  return { near.Runs(0), near.Runs(1) };
}

void BlocksEncloseTheirTrianglesAndPoints()
{
  const Strip strip(3.0, 2.0, 3 * Size + 5);
  const std::vector<sb::TriangleBlock> blocks = strip.Blocks();
  CHECK_EQUAL(blocks.size(), 4u);
  for (std::int64_t i = 0; i < 4; ++i)
  {
    const sb::TriangleBlock& block = blocks[static_cast<std::size_t>(i)];
    const std::int64_t last = std::min((i + 1) * Size, strip.NumberOfTriangles()) + 1;
    CHECK_EQUAL(block.LowestPoint, i * Size);
    CHECK_EQUAL(block.HighestPoint, last);
    CHECK_EQUAL(block.Bounds.Lower[0], 3.0 + 0.5 * double(i * Size));
    CHECK_EQUAL(block.Bounds.Upper[0], 3.0 + 0.5 * double(last));
    CHECK_EQUAL(block.Bounds.Lower[1], 0.0);
    CHECK_EQUAL(block.Bounds.Upper[1], 1.0);
    CHECK_EQUAL(block.Bounds.Lower[2], 2.0);
    CHECK_EQUAL(block.Bounds.Upper[2], 2.0);
  }
  const std::vector<sb::TriangleBlock> threaded = strip.Blocks(3);
  CHECK(std::equal(blocks.begin(), blocks.end(), threaded.begin(),
    [](const sb::TriangleBlock& l, const sb::TriangleBlock& r) {
      return l.Bounds.Lower == r.Bounds.Lower && l.Bounds.Upper == r.Bounds.Upper &&
        l.LowestPoint == r.LowestPoint && l.HighestPoint == r.HighestPoint;
    }));
}

/** Strips of 40 and 10 blocks; the second starts where the first is three quarters through. */
void OnlyBlocksThatMeetAreMarked()
{
  const Strip a(0.0, 0.0, 40 * Size);
  const Strip b(15.0 * double(Size) + 1.5, 0.0, 10 * Size);
  const std::vector<Runs> runs = RunsOfMeeting(a, b);
  CHECK(runs[0] == Runs({ { 30, 40 } }));
  CHECK(runs[1] == Runs({ { 0, 10 } }));

  const Strip beyond(0.5 * double(40 * Size) + 2.0, 0.0, 10 * Size);
  CHECK(RunsOfMeeting(a, beyond)[0].empty());
  const Strip touching(0.5 * double(40 * Size) + 0.5, 0.0, 10 * Size);
  CHECK(RunsOfMeeting(a, touching)[0] == Runs({ { 39, 40 } }));
  CHECK(RunsOfMeeting(a, touching)[1] == Runs({ { 0, 1 } }));
}

void WithoutOrderNothingIsRuledOutInTheCommonPart()
{
  Strip a(0.0, 0.0, 40 * Size);
  a.Shuffle();
  const Strip b(15.0 * double(Size) + 1.5, 0.0, 10 * Size);
  const std::vector<Runs> runs = RunsOfMeeting(a, b);
  CHECK(runs[0] == Runs({ { 0, 40 } }));
  CHECK(runs[1] == Runs({ { 0, 10 } }));
}

} // namespace

int main()
{
  BlocksEncloseTheirTrianglesAndPoints();
  OnlyBlocksThatMeetAreMarked();
  WithoutOrderNothingIsRuledOutInTheCommonPart();
  return check::Verdict("TestTriangleBlocks");
}
