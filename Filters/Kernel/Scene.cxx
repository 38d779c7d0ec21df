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

Scene::Scene(const BooleanRequest& request, const Ingested& ingested, Executor& executor)
  : Units(Lattice::ForMagnitude(LargestMagnitude(ingested.Reports)))
  , Swapped(ingested.Swapped)
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
    this->PlacePoints(operand, executor);
    this->PlaceBoxes(ingested.Reports[operand], ingested.Examinations[operand]->Blocks);
  }
}

void Scene::PlacePoints(std::int32_t operand, Executor& executor)
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
}

/** Rounding to the lattice is monotone, so the box of rounded points is the rounded box. */
void Scene::PlaceBoxes(const OperandReport& report, std::vector<TriangleBlock> blocks)
{
  std::array<double, 6> bounds{};
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    bounds[i] = this->Units.ToLattice(report.Bounds[i]);
  }
  this->LatticeBounds.push_back(bounds);
  for (TriangleBlock& block : blocks)
  {
    this->Units.Quantise(block.Bounds.Lower.data(), block.Bounds.Lower.data());
    this->Units.Quantise(block.Bounds.Upper.data(), block.Bounds.Upper.data());
  }
  this->LatticeBlocks.push_back(std::move(blocks));
}

} // namespace sb
