// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/mapping/raster_map.hpp"

namespace echomap::tests {

/// A map as lines of text, the top row first: `#` occupied, `.` free, a blank unknown.
using DrawnMap = std::vector<std::string>;

inline mapping::RasterMap map_from(const DrawnMap& drawing,
                                   double resolution_m = 0.05,
                                   const Eigen::Vector2d& origin_m = {0.0, 0.0}) {
  const int rows = static_cast<int>(drawing.size());
  mapping::RasterMap map(static_cast<int>(drawing.front().size()), rows, resolution_m, origin_m);
  for (int row = 0; row < rows; ++row) {
    const std::string& line = drawing[static_cast<std::size_t>(rows - 1 - row)];
    for (int column = 0; column < map.columns(); ++column) {
      const char mark = line[static_cast<std::size_t>(column)];
      if (mark != ' ') {
        map.set({column, row},
                mark == '#' ? mapping::CellState::kOccupied : mapping::CellState::kFree);
      }
    }
  }
  return map;
}

/// Free floor of 5 m x 5 m, in cells of 5 cm, from (-1, -1) on.
inline mapping::RasterMap free_floor() {
  return map_from(DrawnMap(100, std::string(100, '.')), 0.05, {-1.0, -1.0});
}

inline DrawnMap drawing_of(const mapping::RasterMap& map) {
  DrawnMap drawing;
  for (int row = map.rows() - 1; row >= 0; --row) {
    std::string line;
    for (int column = 0; column < map.columns(); ++column) {
      switch (map.state({column, row})) {
        case mapping::CellState::kUnknown:
          line.push_back(' ');
          break;
        case mapping::CellState::kFree:
          line.push_back('.');
          break;
        case mapping::CellState::kOccupied:
          line.push_back('#');
          break;
      }
    }
    drawing.push_back(line);
  }
  return drawing;
}

}  // namespace echomap::tests
