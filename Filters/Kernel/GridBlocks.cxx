// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GridBlocks.h"

#include "Hash.h"

namespace sb
{

std::int32_t BlockNumbers::Of(const GridPlace& place)
{
  if (2 * this->Places.size() >= this->Slots.size())
  {
    this->Slots.assign(this->Slots.empty() ? 1024 : 2 * this->Slots.size(), -1);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      this->Slots[this->SlotOf(this->Places[i])] = static_cast<std::int32_t>(i);
    }
  }
  std::int32_t& number = this->Slots[this->SlotOf(place)];
  if (number < 0)
  {
    number = this->Size();
    this->Places.push_back(place);
  }
  return number;
}

/** Where it is, or where there is room for it. */
std::size_t BlockNumbers::SlotOf(const GridPlace& place) const
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t slot =
    static_cast<std::size_t>(HashPair(place.X, place.Y, static_cast<std::uint32_t>(place.Z))) &
    mask;
  while (
    this->Slots[slot] >= 0 && !(this->Places[static_cast<std::size_t>(this->Slots[slot])] == place))
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

} // namespace sb
