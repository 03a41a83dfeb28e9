// SPDX-License-Identifier: MIT
#include "host/mapping/tile_index.hpp"

#include <algorithm>
#include <utility>

namespace echomap::mapping {

using geometry::CellIndex;

std::int32_t TileIndex::find(CellIndex tile) const {
  std::size_t slot = first_slot(tile);
  while (slots_[slot].number != kNone && slots_[slot].tile != tile) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  return slots_[slot].number;
}

void TileIndex::insert(CellIndex tile, std::int32_t number) {
  if (2 * ++used_ > slots_.size()) {
    grow();
  }
  place({tile, number});
}

void TileIndex::clear() {
  std::fill(slots_.begin(), slots_.end(), Slot{});
  used_ = 0;
}

/// Fibonacci hashing: the golden ratio's bits spread neighbours over the table.
std::size_t TileIndex::first_slot(CellIndex tile) const {
  const auto column = static_cast<std::uint32_t>(tile.x);
  const auto row = static_cast<std::uint32_t>(tile.y);
  const std::uint64_t key = (std::uint64_t{column} << 32) | row;
  return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> 32) & (slots_.size() - 1);
}

void TileIndex::grow() {
  const auto before = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
  for (const Slot& moved : before) {
    if (moved.number != kNone) {
      place(moved);
    }
  }
}

void TileIndex::place(const Slot& placed) {
  std::size_t slot = first_slot(placed.tile);
  while (slots_[slot].number != kNone) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  slots_[slot] = placed;
}

}  // namespace echomap::mapping
