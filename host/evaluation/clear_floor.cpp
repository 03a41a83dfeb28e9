// SPDX-License-Identifier: MIT
#include "host/evaluation/clear_floor.hpp"

#include "host/mapping/distance_field.hpp"

namespace echomap::evaluation {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

RasterMap padded(const RasterMap& map) {
  return mapping::cut_out(map, {{-1, -1}, {map.columns(), map.rows()}});
}

void keep_off(const RasterMap& map,
              const std::function<bool(CellState)>& is_obstacle,
              double margin_m,
              RasterMap& floor) {
  RasterMap obstacles(map.columns(), map.rows(), map.resolution_m(), map.origin_m());
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (is_obstacle(map.state({x, y}))) {
        obstacles.set({x, y}, CellState::kOccupied);
      }
    }
  }
  const mapping::DistanceField distances(obstacles, margin_m + map.resolution_m());
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.resolution_m() * static_cast<double>(distances.distance_cells({x, y})) < margin_m) {
        floor.set({x, y}, CellState::kUnknown);
      }
    }
  }
}

std::vector<Eigen::Vector2d> take_region_m(CellIndex seed, RasterMap& floor) {
  std::vector<Eigen::Vector2d> region_m;
  std::vector<CellIndex> open{seed};
  while (!open.empty()) {
    const CellIndex cell = open.back();
    open.pop_back();
    if (floor.state(cell) != CellState::kFree) {
      continue;
    }
    floor.set(cell, CellState::kUnknown);
    region_m.push_back(floor.center_m(cell));
    open.push_back({cell.x + 1, cell.y});
    open.push_back({cell.x - 1, cell.y});
    open.push_back({cell.x, cell.y + 1});
    open.push_back({cell.x, cell.y - 1});
  }
  return region_m;
}

}  // namespace echomap::evaluation
