// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzBoolean.cxx
 * @brief Boolean operations on whatever a coverage-guided fuzzer comes upon. Not to crash is not
 * enough: every result is closed, points are inside of it as the inputs' winding numbers say, and
 * volumes add up.
 */
#include "BooleanClaims.h"
#include "FuzzBodies.h"

#include <cstdlib>

namespace
{

using namespace claims;

/** Some turned by no special angle, so that what coincided nearly coincides. */
Case ReadCase(fuzz::Bytes& bytes, Random& random)
{
  Case given;
  const bool turned = bytes.Below(4) == 3;
  const auto rotation = RandomRotation(random);
  Mesh before = Cube(0, 2);
  for (int operands = 2 + bytes.Below(3); operands > 0 && !bytes.AtEnd(); --operands)
  {
    const bool tool = bytes.Below(2) == 1;
    before = fuzz::ReadOperand(bytes, before);
    Mesh placed = before;
    if (turned && bytes.Below(2) == 1)
    {
      if (Volume(placed) == 0.0) // which side is inside would be decided by rounding
      {
        placed.Append(Cube(0, 1));
      }
      placed = Rotated(placed, rotation);
    }
    (tool && !given.Inputs.empty() ? given.Tools : given.Inputs).push_back(placed);
  }
  return given;
}

/** The volume of the points inside, each counted once. A body beside it keeps a surface that
 * encloses less than nothing from being turned over. */
double SetVolume(const Mesh& mesh)
{
  const Mesh beside = Cube(20, 25);
  Mesh both = mesh;
  both.Append(beside);
  return VolumeOf({ { both }, {}, Operation::Resolve }) - Volume(beside);
}

void CheckIdentities(Case given, Random& random)
{
  const auto volume = [&](Operation op) {
    given.Op = op;
    return SetVolume(ComputeAndCheck(given, random, Overlaps::MayRemain));
  };
  const double ofInput = SetVolume(given.Inputs.front());
  const double ofTool = SetVolume(given.Tools.front());
  const double both = volume(Operation::Intersection);
  const double scale = 125.0;
  CheckNear(volume(Operation::Union), ofInput + ofTool - both, scale);
  CheckNear(volume(Operation::Difference), ofInput - both, scale);
  CheckNear(volume(Operation::SymmetricDifference), ofInput + ofTool - 2.0 * both, scale);
}

void Check(Case given, Random& random)
{
  for (const Operation op : AllOperations)
  {
    given.Op = op;
    ComputeAndCheck(given, random, Overlaps::MayRemain);
  }
  if (given.Inputs.size() == 1 && given.Tools.size() == 1)
  {
    CheckIdentities(given, random);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  Random random(fuzz::Seed(data, size));
  const Case given = ReadCase(bytes, random);
  if (!given.Inputs.empty())
  {
    Check(given, random);
  }
  if (check::Total().Failures > 0)
  {
    std::abort();
  }
  return 0;
}
