// SPDX-License-Identifier: MIT
#include "hil_mock/runner/truth_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echomap::runner {
namespace {

constexpr double kMarginM = 0.1;
/// Sizes that are whole numbers of cells but for rounding stay whole.
constexpr double kRounding = 1e-6;

Eigen::Vector2d centre_m(const TruthMap& map, int column, int row) {
  return {map.origin_x_m + (column + 0.5) * map.resolution_m,
          map.origin_y_m + (row + 0.5) * map.resolution_m};
}

std::size_t index(const TruthMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
         static_cast<std::size_t>(column);
}

TruthMap empty_map_around(const world::Polygon& room_m, double resolution_m) {
  Eigen::Vector2d min_m = room_m.front();
  Eigen::Vector2d max_m = room_m.front();
  for (const Eigen::Vector2d& corner_m : room_m) {
    min_m = min_m.cwiseMin(corner_m);
    max_m = max_m.cwiseMax(corner_m);
  }
  const Eigen::Vector2d cells =
      (max_m - min_m + Eigen::Vector2d::Constant(2.0 * kMarginM)) / resolution_m;
  TruthMap map;
  map.resolution_m = resolution_m;
  map.width = static_cast<int>(std::ceil(cells.x() - kRounding));
  map.height = static_cast<int>(std::ceil(cells.y() - kRounding));
  map.origin_x_m = min_m.x() - kMarginM;
  map.origin_y_m = min_m.y() - kMarginM;
  map.cells.assign(index(map, 0, map.height), TruthCell::kUnknown);
  return map;
}

/// Occupies every cell that a wall passes at half a cell's distance from its centre or nearer.
void draw_walls(const world::FloorPlan& plan, TruthMap& map) {
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const double clearance_m = plan.clearance_m(centre_m(map, column, row));
      if (clearance_m <= 0.5 * map.resolution_m + 1e-9) {
        map.cells[index(map, column, row)] = TruthCell::kOccupied;
      }
    }
  }
}

/// Frees what can be reached from the start without crossing a wall or falling into a hole.
void flood_from_start(const world::FloorPlan& plan, TruthMap& map) {
  const Eigen::Vector2d start_m = plan.T_world_start().position_m();
  std::vector<std::pair<int, int>> open;
  open.emplace_back(static_cast<int>((start_m.x() - map.origin_x_m) / map.resolution_m),
                    static_cast<int>((start_m.y() - map.origin_y_m) / map.resolution_m));
  while (!open.empty()) {
    const auto [column, row] = open.back();
    open.pop_back();
    TruthCell& cell = map.cells[index(map, column, row)];
    if (cell != TruthCell::kUnknown || plan.is_hole(centre_m(map, column, row))) {
      continue;
    }
    cell = TruthCell::kFree;
    open.insert(open.end(),
                {{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}});
  }
}

}  // namespace

TruthCell TruthMap::at(int column, int row) const { return cells[index(*this, column, row)]; }

TruthMap draw_truth_map(const world::FloorPlan& plan, double resolution_m) {
  TruthMap map = empty_map_around(plan.room_m(), resolution_m);
  draw_walls(plan, map);
  flood_from_start(plan, map);
  return map;
}

}  // namespace echomap::runner
