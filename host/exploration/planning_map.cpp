// SPDX-License-Identifier: MIT
#include "host/exploration/planning_map.hpp"

#include <algorithm>
#include <cstdint>

namespace echomap::exploration {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

std::vector<Eigen::Vector2d> places_of(const pipeline::Snapshot& snapshot) {
  std::vector<Eigen::Vector2d> places_m;
  places_m.reserve(snapshot.trajectory->size() + 1);
  for (const pipeline::StampedPose& pose : *snapshot.trajectory) {
    places_m.push_back(pose.T_map_robot.position_m());
  }
  places_m.push_back(snapshot.latest.T_map_robot.position_m());
  return places_m;
}

RasterMap planning_map(const pipeline::Snapshot& snapshot, double margin_m, double robot_radius_m) {
  const RasterMap known = mapping::rasterize(*snapshot.grid);
  const auto margin = 1 + static_cast<std::int32_t>(margin_m / known.resolution_m());
  RasterMap map = mapping::cut_out(
      known, {{-margin, -margin}, {known.columns() - 1 + margin, known.rows() - 1 + margin}});
  CellIndex last{-1, -1};
  for (const Eigen::Vector2d& place_m : places_of(snapshot)) {
    if (map.cell_at(place_m) != last) {
      draw_disc(map, place_m, robot_radius_m, {CellState::kUnknown}, CellState::kFree);
      draw_disc(map, place_m, map.resolution_m(), {CellState::kOccupied}, CellState::kFree);
      last = map.cell_at(place_m);
    }
  }
  return map;
}

CostGrid costs_on(const RasterMap& map,
                  const pipeline::Snapshot& snapshot,
                  const CostGridParams& params) {
  CostGrid costs(map, snapshot.latest.T_map_robot.position_m(), params);
  costs.open_along(map, places_of(snapshot), map.resolution_m(), params);
  return costs;
}

void draw_disc(RasterMap& map,
               const Eigen::Vector2d& at_m,
               double radius_m,
               std::initializer_list<CellState> from,
               CellState state) {
  const CellIndex low = map.cell_at(at_m.array() - radius_m);
  const CellIndex high = map.cell_at(at_m.array() + radius_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const bool is_in = (map.center_m({x, y}) - at_m).norm() <= radius_m;
      const bool is_from = std::find(from.begin(), from.end(), map.state({x, y})) != from.end();
      if (is_in && is_from && map.contains({x, y})) {
        map.set({x, y}, state);
      }
    }
  }
}

}  // namespace echomap::exploration
