// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "host/mapping/grid_tile.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// Adds `centilogits_of(cell)`, evidence in hundredths of log-odds, to every cell of a rectangle as
/// OccupancyGrid::add does to one, tile by tile.
template <class Evidence>
void insert_cells(const CellBounds& bounds, Evidence&& centilogits_of, OccupancyGrid& grid) {
  CellBounds touched;
  grid.begin_insertion();
  for (std::int32_t tile_y = bounds.min.y >> kTileBits; tile_y <= bounds.max.y >> kTileBits;
       ++tile_y) {
    for (std::int32_t tile_x = bounds.min.x >> kTileBits; tile_x <= bounds.max.x >> kTileBits;
         ++tile_x) {
      const geometry::CellIndex low{std::max(bounds.min.x, tile_x * kTileSide),
                                    std::max(bounds.min.y, tile_y * kTileSide)};
      const geometry::CellIndex high{std::min(bounds.max.x, tile_x * kTileSide + kTileSide - 1),
                                     std::min(bounds.max.y, tile_y * kTileSide + kTileSide - 1)};
      GridTile* tile = nullptr;
      for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
          const StepPair steps = grid.steps(centilogits_of(geometry::CellIndex{x, y}));
          if (steps.up == steps.down) {
            continue;
          }
          tile = tile == nullptr ? &grid.writable_tile({tile_x, tile_y}) : tile;
          std::uint8_t& byte = tile->row(y & (kTileSide - 1))[x & (kTileSide - 1)];
          byte = after_evidence(byte, steps, grid.limits());
          touched = united(touched, {{x, y}, {x, y}});
        }
      }
    }
  }
  grid.end_insertion(touched);
}

}  // namespace echomap::mapping
