// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultMeasures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sbvtk
{
namespace
{

constexpr std::int64_t grain = 8192;

using Vector = std::array<double, 3>;

Vector Difference(const double* a, const double* b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/** Volumes are summed as tetrahedra over one apex; an apex amid the surface keeps them small. */
Vector Apex(const sb::BooleanResult& result)
{
  Vector apex{};
  for (const sb::OperandReport& operand : result.Operands)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      apex[axis] += 0.5 * (operand.Bounds[2 * axis] + operand.Bounds[2 * axis + 1]) /
        static_cast<double>(result.Operands.size());
    }
  }
  return apex;
}

/** Adds six times the volume and twice the area of one triangle. */
void AddTriangle(const double* a, const double* b, const double* c, const Vector& apex, double sign,
  ResultMeasures& sum)
{
  const Vector ab = Difference(b, a);
  const Vector ac = Difference(c, a);
  const Vector normal{ ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
    ab[0] * ac[1] - ab[1] * ac[0] };
  const Vector arm = Difference(a, apex.data());
  sum.Volume += sign * (arm[0] * normal[0] + arm[1] * normal[1] + arm[2] * normal[2]);
  sum.Area += std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

template <typename AddOne>
ResultMeasures SumOfBlocks(std::int64_t count, sb::Executor& executor, const AddOne& addOne)
{
  std::vector<ResultMeasures> blocks((count + grain - 1) / grain);
  executor.For(count, grain, [&](std::int64_t begin, std::int64_t end) {
    ResultMeasures block;
    for (std::int64_t i = begin; i < end; ++i)
    {
      addOne(i, block);
    }
    blocks[begin / grain] = block;
  });
  ResultMeasures sum;
  for (const ResultMeasures& block : blocks)
  {
    sum.Volume += block.Volume;
    sum.Area += block.Area;
  }
  return sum;
}

/** Positions of the output points in double precision. */
class Positions
{
public:
  Positions(
    const std::vector<std::shared_ptr<OperandSurface>>& operands, const sb::BooleanResult& result)
    : Operands(operands)
    , Result(result)
  {
    for (const std::vector<std::int32_t>& kept : result.KeptPoints)
    {
      this->Ends.push_back(
        (this->Ends.empty() ? 0 : this->Ends.back()) + static_cast<std::int64_t>(kept.size()));
    }
  }

  const double* operator[](std::int64_t point) const
  {
    std::int64_t begin = 0;
    for (std::size_t operand = 0; operand < this->Ends.size(); ++operand)
    {
      if (point < this->Ends[operand])
      {
        return this->Operands[operand]->Mesh().Points +
          3 * static_cast<std::int64_t>(this->Result.KeptPoints[operand][point - begin]);
      }
      begin = this->Ends[operand];
    }
    return this->Result.Interpolated[point - begin].Position.data();
  }

private:
  const std::vector<std::shared_ptr<OperandSurface>>& Operands;
  const sb::BooleanResult& Result;
  std::vector<std::int64_t> Ends;
};

/** What one operand's triangles add that are in the result as they are, or turned over. */
ResultMeasures MeasureWholeTriangles(const sb::Surface& mesh, const sb::OperandReport& report,
  const std::vector<sb::Fate>& fates, const Vector& apex, sb::Executor& executor)
{
  // Of a closed operand the whole is known: where most of it is kept, less work takes away the
  // rest.
  const auto count = static_cast<std::int64_t>(fates.size());
  const bool fromWhole =
    report.Closed && 2 * std::count(fates.begin(), fates.end(), sb::Fate::Kept) > count;
  ResultMeasures result =
    SumOfBlocks(count, executor, [&](std::int64_t triangle, ResultMeasures& sum) {
      const sb::Fate fate = fates[triangle];
      const double times =
        fate == sb::Fate::Kept ? 1.0 : (fate == sb::Fate::KeptReversed ? -1.0 : 0.0);
      const double more = fromWhole ? times - 1.0 : times;
      if (more == 0.0)
      {
        return;
      }
      const std::int32_t* ids = mesh.Triangles + 3 * triangle;
      ResultMeasures one;
      AddTriangle(mesh.Points + 3 * static_cast<std::int64_t>(ids[0]),
        mesh.Points + 3 * static_cast<std::int64_t>(ids[1]),
        mesh.Points + 3 * static_cast<std::int64_t>(ids[2]), apex, 1.0, one);
      sum.Volume += more * one.Volume;
      sum.Area += (fromWhole ? std::abs(times) - 1.0 : 1.0) * one.Area;
    });
  if (fromWhole)
  {
    result.Volume += 6.0 * report.Volume;
    result.Area += 2.0 * report.Area;
  }
  return result;
}

} // namespace

ResultMeasures MeasureResult(const std::vector<std::shared_ptr<OperandSurface>>& operands,
  const sb::BooleanResult& result, sb::Executor& executor)
{
  const Vector apex = Apex(result);
  ResultMeasures total;
  const auto add = [&total](const ResultMeasures& part) {
    total.Volume += part.Volume;
    total.Area += part.Area;
  };
  for (std::size_t operand = 0; operand < operands.size(); ++operand)
  {
    add(MeasureWholeTriangles(
      operands[operand]->Mesh(), result.Operands[operand], result.Fates[operand], apex, executor));
  }
  const Positions positions(operands, result);
  add(SumOfBlocks(static_cast<std::int64_t>(result.Split.Corners.size()), executor,
    [&](std::int64_t piece, ResultMeasures& sum) {
      const std::array<std::int32_t, 3>& corners = result.Split.Corners[piece];
      AddTriangle(positions[corners[0]], positions[corners[1]], positions[corners[2]], apex,
        result.Split.Reversed[piece] ? -1.0 : 1.0, sum);
    }));
  total.Volume /= 6.0;
  total.Area /= 2.0;
  return total;
}

} // namespace sbvtk
