// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ProbePlacement.h"

#include "Hash.h"

#include <cmath>

namespace sb
{

namespace
{

/** Positive weights that add up to 256; near the middle first. */
std::array<std::int64_t, 3> Weights(int attempt)
{
  if (attempt == 0)
  {
    return { 85, 86, 85 };
  }
  const std::uint64_t random = Mix(std::uint64_t(attempt));
  const auto a = std::int64_t(1 + random % 200);
  const auto b = 1 + std::int64_t((random >> 20) % std::uint64_t(254 - a));
  return { a, b, 256 - a - b };
}

} // namespace

DominantNormal ProbePlacement::NormalOf(std::int32_t face) const
{
  const std::array<std::int32_t, 3> corners = this->World.Corners(face);
  return ComputeDominantNormal(this->World.Position(corners[0]), this->World.Position(corners[1]),
    this->World.Position(corners[2]));
}

int ProbePlacement::NormalSign(std::int32_t face) const { return this->NormalOf(face).Sign; }

std::optional<Probe> ProbePlacement::Place(
  std::int32_t face, std::int32_t region, int attempt) const
{
  const DominantNormal normal = this->NormalOf(face);
  Probe probe;
  probe.Face = face;
  probe.Axis = normal.Axis;
  if (region >= 0)
  {
    const std::int32_t first = this->Cuts.Regions[std::size_t(region)].FirstPiece;
    const std::int32_t count = this->Cuts.EndOfPiecesOfRegion(region) - first;
    for (int i = 0; i < 8 * count + 64; ++i)
    {
      const Piece& piece = this->Cuts.Pieces[std::size_t(first + (i + attempt) % count)];
      if (this->PlaceInPiece(piece, normal.Sign, attempt + i / count, probe))
      {
        return probe;
      }
    }
    return std::nullopt;
  }
  const std::array<std::int32_t, 3> corners = this->World.Corners(face);
  const std::array<std::int64_t, 3> weights = Weights(attempt);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::size_t axis = (std::size_t(normal.Axis) + 1 + i) % 3;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      probe.Place[i] +=
        weights[corner] * static_cast<std::int64_t>(this->World.Position(corners[corner])[axis]);
    }
  }
  return probe;
}

bool ProbePlacement::PlaceInPiece(const Piece& piece, int sign, int attempt, Probe& probe) const
{
  const std::array<std::int64_t, 3> weights = Weights(attempt);
  std::array<ExactPoint, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[i] = IsNode(piece.Corners[i])
      ? this->Cuts.Nodes.Point(piece.Corners[i])
      : ExactPoint::Vertex(this->World.Position(~piece.Corners[i]));
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::size_t axis = (std::size_t(probe.Axis) + 1 + i) % 3;
    const double base = corners[0].Approximation()[axis];
    const double offset = double(weights[1]) * (corners[1].Approximation()[axis] - base) +
      double(weights[2]) * (corners[2].Approximation()[axis] - base);
    probe.Place[i] = static_cast<std::int64_t>(256.0 * base) + std::llround(offset);
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (Orient2DRefined(corners[i], corners[(i + 1) % 3], probe.Place.data(), probe.Axis) != sign)
    {
      return false;
    }
  }
  return true;
}

} // namespace sb
