// SPDX-License-Identifier: MIT
#include "host/exploration/unknown_islands.hpp"

#include <optional>
#include <vector>

namespace echomap::exploration {

namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

/// Of the sides of these cells that are known ones; empty where they reach the edge of the map.
std::optional<float> occupied_share(const RasterMap& map, const std::vector<CellIndex>& cells) {
  int known = 0;
  int occupied = 0;
  for (const CellIndex cell : cells) {
    if (cell.x == 0 || cell.y == 0 || cell.x + 1 == map.columns() || cell.y + 1 == map.rows()) {
      return std::nullopt;
    }
    for_each_side(map, cell, [&](CellIndex side) {
      known += map.state(side) != CellState::kUnknown ? 1 : 0;
      occupied += map.state(side) == CellState::kOccupied ? 1 : 0;
    });
  }
  return static_cast<float>(occupied) / static_cast<float>(known);
}

}  // namespace

CellValues<float> occupied_rim_shares(const RasterMap& map) {
  CellValues<float> shares(map, 1.0F);
  CellValues<char> is_taken(map, 0);
  const auto is_unknown = [&](CellIndex cell) { return map.state(cell) == CellState::kUnknown; };
  for_each_cell(map, [&](CellIndex seed) {
    if (is_taken[seed] != 0 || !is_unknown(seed)) {
      return;
    }
    const auto cells = joined_to(map, seed, is_taken, is_unknown);
    if (const auto share = occupied_share(map, cells)) {
      for (const CellIndex cell : cells) {
        shares[cell] = *share;
      }
    }
  });
  return shares;
}

}  // namespace echomap::exploration
