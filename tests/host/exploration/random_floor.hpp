// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>

#include "host/exploration/cost_grid.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// Free floor on which a share of the cells is occupied; a function of the seed alone.
inline mapping::RasterMap random_floor(int columns, int rows, double occupied, std::uint32_t seed) {
  std::mt19937 random(seed);
  mapping::RasterMap map(columns, rows, 0.05, {0.0, 0.0});
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const bool stands = static_cast<double>(random()) < occupied * 4294967296.0;
      map.set({x, y}, stands ? mapping::CellState::kOccupied : mapping::CellState::kFree);
    }
  }
  return map;
}

/// Of a robot so small that only occupied cells are closed to it.
inline CostGridParams of_a_dot() {
  CostGridParams params;
  params.robot_radius_m = 0.01;
  params.clearance_m = 0.0;
  params.standing_m = 0.0;
  return params;
}

}  // namespace echomap::exploration
