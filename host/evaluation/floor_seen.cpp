// SPDX-License-Identifier: MIT
#include "host/evaluation/floor_seen.hpp"

#include <algorithm>
#include <limits>

#include "host/evaluation/clear_floor.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::evaluation {

namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kAlongWallsM = 0.05;

/// A robot that stands beside a wall stands nearer than its radius by a cell.
CellIndex nearest_free_cell(const RasterMap& floor, const Eigen::Vector2d& point_m) {
  CellIndex nearest = floor.cell_at(point_m);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& center_m : mapping::centers_m(floor, CellState::kFree)) {
    if ((center_m - point_m).norm() < nearest_m) {
      nearest_m = (center_m - point_m).norm();
      nearest = floor.cell_at(center_m);
    }
  }
  return nearest;
}

}  // namespace

std::vector<Eigen::Vector2d> floor_in_reach_m(const RasterMap& truth,
                                              const Eigen::Vector2d& start_m,
                                              double robot_radius_m) {
  geometry::ParameterValidator("floor in reach").positive("robot_radius_m", robot_radius_m);
  const RasterMap all = padded(truth);
  const auto is_no_floor = [](CellState state) { return state != CellState::kFree; };
  RasterMap clear = all;
  keep_off(all, is_no_floor, robot_radius_m, clear);
  RasterMap stands(all.columns(), all.rows(), all.resolution_m(), all.origin_m());
  for (const Eigen::Vector2d& center_m : take_region_m(nearest_free_cell(clear, start_m), clear)) {
    stands.set(stands.cell_at(center_m), CellState::kOccupied);
  }
  RasterMap floor = all;
  keep_off(all, is_no_floor, kAlongWallsM, floor);
  const mapping::DistanceField to_stands(stands, robot_radius_m + all.resolution_m());
  std::vector<Eigen::Vector2d> reached_m;
  for (int y = 0; y < all.rows(); ++y) {
    for (int x = 0; x < all.columns(); ++x) {
      const double to_stand_m =
          all.resolution_m() * static_cast<double>(to_stands.distance_cells({x, y}));
      if (floor.state({x, y}) == CellState::kFree && to_stand_m <= robot_radius_m) {
        reached_m.push_back(all.center_m({x, y}));
      }
    }
  }
  return reached_m;
}

double floor_seen(const RasterMap& map,
                  const geometry::Pose2& T_world_map,
                  const RasterMap& truth,
                  const Eigen::Vector2d& start_m,
                  double robot_radius_m) {
  const auto floor_m = floor_in_reach_m(truth, start_m, robot_radius_m);
  const geometry::Pose2 T_map_world = T_world_map.inverse();
  const auto seen = std::count_if(floor_m.begin(), floor_m.end(), [&](const auto& center_m) {
    return map.state(map.cell_at(T_map_world * center_m)) == CellState::kFree;
  });
  return floor_m.empty() ? 1.0 : static_cast<double>(seen) / static_cast<double>(floor_m.size());
}

}  // namespace echomap::evaluation
