// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/cell_index.hpp"

namespace echomap::mapping {

/// Finds the number of a tile by its place: a hash table with open addressing, so that ground
/// without a tile costs nothing however far apart the tiles lie.
class TileIndex {
 public:
  static constexpr std::int32_t kNone = -1;

  /// The tile's number, or kNone.
  std::int32_t find(geometry::CellIndex tile) const {
    std::size_t slot = first_slot(tile);
    while (slots_[slot].number != kNone && slots_[slot].tile != tile) {
      slot = (slot + 1) & mask_;
    }
    return slots_[slot].number;
  }
  /// `tile` must not be in yet and `number` not be negative.
  void insert(geometry::CellIndex tile, std::int32_t number);
  /// Forgets all tiles; the memory stays.
  void clear();
  std::size_t memory_bytes() const { return slots_.capacity() * sizeof(Slot); }

 private:
  struct Slot {
    geometry::CellIndex tile;
    std::int32_t number = kNone;
  };

  /// Fibonacci hashing: the golden ratio's bits spread neighbours over the table.
  std::size_t first_slot(geometry::CellIndex tile) const {
    const auto column = static_cast<std::uint32_t>(tile.x);
    const auto row = static_cast<std::uint32_t>(tile.y);
    const std::uint64_t key = (std::uint64_t{column} << 32) | row;
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> 32) & mask_;
  }
  void grow();
  void place(const Slot& placed);

  std::vector<Slot> slots_ = std::vector<Slot>(16);  ///< A power of two, at most half full.
  std::size_t mask_ = 15;                            ///< One less than there are slots.
  std::size_t used_ = 0;
};

}  // namespace echomap::mapping
