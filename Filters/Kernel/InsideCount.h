// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InsideCount.h
 * @brief The value of the operation at a point whose winding numbers change one at a time.
 */
#ifndef sb_InsideCount_h
#define sb_InsideCount_h

#include "Scene.h"

#include <cstdint>
#include <vector>

namespace sb
{

class InsideCount
{
public:
  /** Starts outside of all operands. */
  InsideCount(const Scene& scene, Operation operation)
    : World(scene)
    , Op(operation)
    , Windings(std::size_t(scene.NumberOfOperands()), 0)
  {
    for (std::int32_t operand = 0; operand < scene.NumberOfOperands(); ++operand)
    {
      ++(scene.Side(operand) == Group::Input ? this->Inputs : this->Tools);
    }
  }

  void Add(std::int32_t operand, int change)
  {
    int& winding = this->Windings[std::size_t(operand)];
    int& inside =
      this->World.Side(operand) == Group::Input ? this->InsideInputs : this->InsideTools;
    inside -= winding >= 1;
    this->Multiple -= IsMultipleValue(winding);
    winding += change;
    inside += winding >= 1;
    this->Multiple += IsMultipleValue(winding);
  }

  /** How many operands enclose the point more than once, or the wrong way round. */
  int NumberOfMultiple() const { return this->Multiple; }
  bool IsMultiple(std::int32_t operand) const
  {
    return IsMultipleValue(this->Windings[std::size_t(operand)]);
  }

  /** Whether the point is inside an operand of the group that this one is not in. */
  bool IsInsideOtherGroup(std::int32_t operand) const
  {
    return (this->World.Side(operand) == Group::Input ? this->InsideTools : this->InsideInputs) > 0;
  }

  bool IsInside() const
  {
    switch (this->Op)
    {
      case Operation::Union:
      case Operation::Resolve:
        return this->InsideInputs + this->InsideTools > 0;
      case Operation::Intersection:
        return this->Tools == 0 ? this->InsideInputs == this->Inputs
                                : this->InsideInputs > 0 && this->InsideTools > 0;
      case Operation::Difference:
        return this->InsideInputs > 0 && this->InsideTools == 0;
      case Operation::SymmetricDifference:
        return (this->InsideInputs > 0) != (this->InsideTools > 0);
    }
    return false;
  }

private:
  static bool IsMultipleValue(int winding) { return winding < 0 || winding > 1; }

  const Scene& World;
  Operation Op;
  std::vector<int> Windings;
  int Inputs = 0;
  int Tools = 0;
  int InsideInputs = 0;
  int InsideTools = 0;
  int Multiple = 0;
};

} // namespace sb

#endif
