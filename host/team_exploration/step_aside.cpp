// SPDX-License-Identifier: MIT
#include "host/team_exploration/step_aside.hpp"

#include <algorithm>

#include "host/exploration/path_planner.hpp"
#include "host/exploration/planning_map.hpp"
#include "host/exploration/travel_field.hpp"
#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::team_exploration {
namespace {

using exploration::CostGrid;
using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

bool is_clear(const ClearPath& path, const Eigen::Vector2d& place_m) {
  for (std::size_t i = 1; i < path.points_m.size(); ++i) {
    if (geometry::distance_m({path.points_m[i - 1], path.points_m[i]}, place_m) < path.keep_off_m) {
      return false;
    }
  }
  return true;
}

/// What each peer covers is occupied, but for what this robot stands on.
RasterMap with_peers(RasterMap map, const Eigen::Vector2d& here_m, const std::vector<Peer>& peers) {
  for (const Peer& peer : peers) {
    const Eigen::Vector2d at_m = peer.T_map_robot.position_m();
    const double radius_m = std::min(peer.radius_m, (at_m - here_m).norm() - map.resolution_m());
    exploration::draw_disc(
        map, at_m, radius_m, {CellState::kFree, CellState::kUnknown}, CellState::kOccupied);
  }
  return map;
}

}  // namespace

std::vector<Eigen::Vector2d> expected_path(const RasterMap& map,
                                           const Peer& peer,
                                           const Claim* claim,
                                           const StepAsideParams& params) {
  const Eigen::Vector2d from_m = peer.T_map_robot.position_m();
  if (claim != nullptr) {
    const CostGrid costs(map, from_m, params.costs);
    exploration::PathPlanner planner;
    if (auto path = planner.find(costs, costs.cell_at(from_m), costs.cell_at(claim->at_m))) {
      path->points_m.insert(path->points_m.begin(), from_m);
      return path->points_m;
    }
  }
  const double heading_rad = peer.T_map_robot.heading_rad();
  return {from_m, from_m + params.straight_m * geometry::unit_vector(heading_rad)};
}

std::optional<PassingPlace> passing_place(const RasterMap& map,
                                          const Eigen::Vector2d& here_m,
                                          const std::vector<Peer>& peers,
                                          const ClearPath& path,
                                          const StepAsideParams& params) {
  const CostGrid costs(with_peers(map, here_m, peers), here_m, params.costs);
  exploration::TravelField travel;
  travel.search(costs, costs.cell_at(here_m));
  std::optional<PassingPlace> nearest;
  for (std::int32_t y = 0; y < costs.rows(); ++y) {
    for (std::int32_t x = 0; x < costs.columns(); ++x) {
      const auto cost_m = travel.cost_m({x, y});
      const bool is_nearer = cost_m && *cost_m <= (nearest ? nearest->cost_m : params.max_cost_m);
      if (is_nearer && is_clear(path, costs.center_m({x, y}))) {
        nearest = PassingPlace{costs.center_m({x, y}), *cost_m};
      }
    }
  }
  return nearest;
}

}  // namespace echomap::team_exploration
