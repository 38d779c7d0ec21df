// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StitchedSeams.h"

namespace sb
{

namespace
{

/** Whether both ends of a contact lie in an edge of its face. */
bool LiesInEdge(const Contact& contact, int edge)
{
  for (const Location end : contact.Ends)
  {
    if (end != edge && end != (edge + 1) % 3 && end != 3 + edge)
    {
      return false;
    }
  }
  return true;
}

} // namespace

StitchedSeams::StitchedSeams(const std::vector<std::uint8_t>& collapsed, const MeshEdges& edges)
  : Collapsed(collapsed)
  , Edges(edges)
  , Sets(static_cast<std::int32_t>(collapsed.size()))
{
  for (std::int32_t face = 0; face < this->Sets.Size(); ++face)
  {
    for (int edge = 0; edge < 3 && collapsed[std::size_t(face)]; ++edge)
    {
      const HalfEdge mate = edges.Mates[3 * std::size_t(face) + std::size_t(edge)];
      if (mate >= 0 && collapsed[std::size_t(mate / 3)])
      {
        this->Sets.Unite(face, mate / 3);
      }
    }
  }
}

std::int32_t StitchedSeams::SeamOf(std::int32_t face, int edge) const
{
  const HalfEdge mate = this->Edges.Mates[3 * std::size_t(face) + std::size_t(edge)];
  return mate >= 0 && this->Collapsed[std::size_t(mate / 3)] ? this->Sets.Root(mate / 3) : -1;
}

bool StitchedSeams::IsAlongSeam(const Contact& contact, const Contact& asOtherSeesIt) const
{
  for (int mine = 0; mine < 3 && !this->Collapsed.empty(); ++mine)
  {
    const std::int32_t seam = LiesInEdge(contact, mine) ? this->SeamOf(contact.Face, mine) : -1;
    for (int its = 0; its < 3 && seam >= 0; ++its)
    {
      if (LiesInEdge(asOtherSeesIt, its) && this->SeamOf(contact.Other, its) == seam)
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace sb
