// SPDX-License-Identifier: MIT
#include "host/mapping/tile_index.hpp"

#include <algorithm>
#include <utility>

namespace echomap::mapping {

using geometry::CellIndex;

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

void TileIndex::grow() {
  const auto before = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
  mask_ = slots_.size() - 1;
  for (const Slot& moved : before) {
    if (moved.number != kNone) {
      place(moved);
    }
  }
}

void TileIndex::place(const Slot& placed) {
  std::size_t slot = first_slot(placed.tile);
  while (slots_[slot].number != kNone) {
    slot = (slot + 1) & mask_;
  }
  slots_[slot] = placed;
}

}  // namespace echomap::mapping
