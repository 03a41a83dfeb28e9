// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/grid_tile.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// Adds `centilogits_of(cell)`, evidence in hundredths of log-odds, to every cell of a rectangle as
/// OccupancyGrid::add does to one, row by row of its tiles.
template <class Evidence>
void insert_cells(const CellBounds& bounds, Evidence&& centilogits_of, OccupancyGrid& grid) {
  CellBounds touched;
  int last_centilogits = 0;
  StepPair steps;
  const EvidenceLimits limits = grid.limits();
  /// Of a row within one tile, which is made when the first evidence falls on it.
  const auto insert_row =
      [&](geometry::CellIndex tile_index, geometry::CellIndex first, std::int32_t last_x) {
        std::uint8_t* row = nullptr;
        std::int32_t touched_to = first.x;
        for (geometry::CellIndex cell = first; cell.x <= last_x; ++cell.x) {
          if (const int centilogits = centilogits_of(cell); centilogits != last_centilogits) {
            last_centilogits = centilogits;
            steps = grid.steps(centilogits);
          }
          if (steps.up == steps.down) {
            continue;
          }
          if (row == nullptr) {
            row = grid.writable_tile(tile_index).row(cell.y & (kTileSide - 1));
            first = cell;
          }
          std::uint8_t& byte = row[cell.x & (kTileSide - 1)];
          byte = after_evidence(byte, steps, limits);
          touched_to = cell.x;
        }
        if (row != nullptr) {
          touched = united(touched, {first, {touched_to, first.y}});
        }
      };
  grid.begin_insertion();
  for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x;) {
      const std::int32_t last_x = std::min(bounds.max.x, x | (kTileSide - 1));
      insert_row({x >> kTileBits, y >> kTileBits}, {x, y}, last_x);
      x = last_x + 1;
    }
  }
  grid.end_insertion(touched);
}

}  // namespace echomap::mapping
