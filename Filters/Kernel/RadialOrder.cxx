// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RadialOrder.h"

#include <algorithm>

namespace sb
{

RadialOrder::Entry RadialOrder::MakeEntry(NodeId low, NodeId high, const HalfPlane& piece) const
{
  Entry entry;
  entry.Piece = piece;
  const std::array<std::int32_t, 3> corners = this->World.Corners(piece.Face);
  for (std::size_t i = 0; i < 3; ++i)
  {
    entry.Corners[i] = this->World.Position(corners[i]);
  }
  entry.Normal = ComputeDominantNormal(entry.Corners[0], entry.Corners[1], entry.Corners[2]);
  // A piece lies to the left of its edges in its face's orientation.
  const int wanted = piece.RunsUp ? entry.Normal.Sign : -entry.Normal.Sign;
  entry.Witness = entry.Corners[2];
  for (const double* corner : entry.Corners)
  {
    if (Orient2D(this->Nodes.Point(low), this->Nodes.Point(high), ExactPoint::Vertex(corner),
          entry.Normal.Axis) == wanted)
    {
      entry.Witness = corner;
      break;
    }
  }
  entry.Sector = 0;
  return entry;
}

int RadialOrder::Turn(const Entry& a, const Entry& b)
{
  const int side = Orient3D(a.Corners[0], a.Corners[1], a.Corners[2], b.Witness);
  return a.Piece.RunsUp ? side : -side;
}

bool RadialOrder::IsOnSameSide(NodeId low, NodeId high, const Entry& a, const Entry& b) const
{
  const int side = Orient2D(
    this->Nodes.Point(low), this->Nodes.Point(high), ExactPoint::Vertex(b.Witness), a.Normal.Axis);
  return side == (a.Piece.RunsUp ? a.Normal.Sign : -a.Normal.Sign);
}

void RadialOrder::Sort(NodeId low, NodeId high, std::vector<HalfPlane>& pieces)
{
  this->Entries.clear();
  for (const HalfPlane& piece : pieces)
  {
    this->Entries.push_back(this->MakeEntry(low, high, piece));
  }
  const Entry first = this->Entries.front();
  for (std::size_t i = 1; i < this->Entries.size(); ++i)
  {
    Entry& entry = this->Entries[i];
    const int turn = Turn(first, entry);
    entry.Sector = turn > 0                         ? 1
      : turn < 0                                    ? 3
      : this->IsOnSameSide(low, high, first, entry) ? 0
                                                    : 2;
  }
  std::sort(this->Entries.begin(), this->Entries.end(), [](const Entry& a, const Entry& b) {
    if (a.Sector != b.Sector)
    {
      return a.Sector < b.Sector;
    }
    const int turn = a.Sector % 2 == 0 ? 0 : Turn(a, b);
    if (turn != 0)
    {
      return turn > 0;
    }
    const bool turnsAlongAxis = (a.Normal.Sign > 0) == a.Piece.RunsUp;
    return turnsAlongAxis ? a.Piece.Face < b.Piece.Face : b.Piece.Face < a.Piece.Face;
  });
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    pieces[i] = this->Entries[i].Piece;
  }
}

} // namespace sb
