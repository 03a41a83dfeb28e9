// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/mapping/raster_map.hpp"

namespace echomap::terminal_view {

/// A map drawn from the top: '#' is occupied, '.' free, all else unknown. Cells of 10 cm, the
/// lower left one at the origin.
inline mapping::RasterMap drawn_room(const std::vector<std::string>& rows) {
  mapping::RasterMap map(
      static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), 0.1, {0.0, 0.0});
  for (int y = 0; y < map.rows(); ++y) {
    const std::string& row = rows[rows.size() - 1 - static_cast<std::size_t>(y)];
    for (int x = 0; x < map.columns(); ++x) {
      const char cell = row[static_cast<std::size_t>(x)];
      if (cell == '#') {
        map.set({x, y}, mapping::CellState::kOccupied);
      } else if (cell == '.') {
        map.set({x, y}, mapping::CellState::kFree);
      }
    }
  }
  return map;
}

}  // namespace echomap::terminal_view
