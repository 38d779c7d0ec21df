// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include <cmath>

namespace sb
{

namespace
{

double LargestMagnitude(const std::vector<OperandReport>& reports)
{
  double largest = 0.0;
  for (const OperandReport& report : reports)
  {
    for (double bound : report.Bounds)
    {
      largest = std::max(largest, std::abs(bound));
    }
  }
  return largest;
}

} // namespace

Scene::Scene(const BooleanRequest& request, const std::vector<OperandReport>& reports,
  const std::vector<std::uint8_t>& swapped, Executor& executor)
  : Units(Lattice::ForTolerance(LargestMagnitude(reports), request.Tolerance))
  , Swapped(swapped)
  , FirstVertices{ 0 }
  , FirstFaces{ 0 }
{
  for (const Operand& operand : request.Operands)
  {
    // An operand without triangles is the empty set; its points take no part.
    const std::int64_t points =
      operand.Mesh.NumberOfTriangles > 0 ? operand.Mesh.NumberOfPoints : 0;
    this->Meshes.push_back(operand.Mesh);
    this->Sides.push_back(operand.Side);
    this->FirstVertices.push_back(this->FirstVertices.back() + static_cast<std::int32_t>(points));
    this->FirstFaces.push_back(
      this->FirstFaces.back() + static_cast<std::int32_t>(operand.Mesh.NumberOfTriangles));
  }

  // Not initialised: the pages are first touched by the threads that fill them.
  this->Coordinates.reset(new double[3 * std::size_t(this->NumberOfVertices()) + 1]);
  for (std::int32_t operand = 0; operand < this->NumberOfOperands(); ++operand)
  {
    const double* in = this->Meshes[operand].Points;
    double* out = this->Coordinates.get() + 3 * std::size_t(this->FirstVertices[operand]);
    executor.For(this->FirstVertices[operand + 1] - this->FirstVertices[operand], 1 << 15,
      [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
        {
          this->Units.Quantise(in + 3 * i, out + 3 * i);
        }
      });

    std::array<double, 6> bounds{};
    for (int corner = 0; corner < 2; ++corner)
    {
      const double world[3] = { reports[operand].Bounds[corner],
        reports[operand].Bounds[2 + corner], reports[operand].Bounds[4 + corner] };
      double lattice[3];
      this->Units.Quantise(world, lattice);
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds[2 * axis + corner] = lattice[axis];
      }
    }
    this->LatticeBounds.push_back(bounds);
  }
}

} // namespace sb
