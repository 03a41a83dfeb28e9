// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// A value for each cell of a map.
template <class T>
class CellValues {
 public:
  CellValues(const mapping::RasterMap& map, T value)
      : columns_(static_cast<std::size_t>(map.columns())),
        values_(columns_ * static_cast<std::size_t>(map.rows()), value) {}
  T& operator[](geometry::CellIndex cell) { return values_[index(cell)]; }
  const T& operator[](geometry::CellIndex cell) const { return values_[index(cell)]; }

 private:
  std::size_t index(geometry::CellIndex cell) const {
    return static_cast<std::size_t>(cell.y) * columns_ + static_cast<std::size_t>(cell.x);
  }

  std::size_t columns_;
  std::vector<T> values_;
};

/// All cells, row by row.
template <class Visitor>
void for_each_cell(const mapping::RasterMap& map, Visitor&& visit) {
  for (std::int32_t y = 0; y < map.rows(); ++y) {
    for (std::int32_t x = 0; x < map.columns(); ++x) {
      visit(geometry::CellIndex{x, y});
    }
  }
}

/// The cells beside one that are on the map.
template <class Visitor>
void for_each_side(const mapping::RasterMap& map, geometry::CellIndex cell, Visitor&& visit) {
  constexpr geometry::CellIndex kSides[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (const geometry::CellIndex side : kSides) {
    const geometry::CellIndex next{cell.x + side.x, cell.y + side.y};
    if (map.contains(next)) {
      visit(next);
    }
  }
}

/// The cells that hang together with `seed` by sides and that `belongs` has; each is taken once.
template <class Belongs>
std::vector<geometry::CellIndex> joined_to(const mapping::RasterMap& map,
                                           geometry::CellIndex seed,
                                           CellValues<char>& is_taken,
                                           Belongs&& belongs) {
  std::vector<geometry::CellIndex> cells{seed};
  is_taken[seed] = 1;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for_each_side(map, cells[i], [&](geometry::CellIndex next) {
      if (is_taken[next] == 0 && belongs(next)) {
        is_taken[next] = 1;
        cells.push_back(next);
      }
    });
  }
  return cells;
}

}  // namespace echomap::exploration
