// SPDX-License-Identifier: MIT
#include "host/exploration/active_loop_closing.hpp"

#include <algorithm>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

ActiveLoopClosing::ActiveLoopClosing(const ActiveLoopClosingParams& params)
    : params_(params), limit_m_(params.max_position_stddev_m) {
  geometry::ParameterValidator("active loop closing")
      .positive("max_position_stddev_m", params.max_position_stddev_m)
      .within("max_known_share", params.max_known_share, 0.0, 1.0)
      .at_least("same_walls_m", params.same_walls_m, 0.0)
      .at_least("limit_growth", params.limit_growth, 1.0);
}

void ActiveLoopClosing::add_stop(const pipeline::Snapshot& snapshot) {
  const double stddev_m = snapshot.position_stddev_m.value_or(0.0);
  const std::size_t scans = snapshot.scans->size();
  const bool is_known = stddev_m <= params_.max_known_share * params_.max_position_stddev_m;
  if (scans > scans_ && is_known) {
    known_scans_.push_back(scans - 1);
  }
  scans_ = scans;
  if (is_returning_ || is_known) {
    limit_m_ = std::max(params_.max_position_stddev_m, params_.limit_growth * stddev_m);
    is_returning_ = false;
  }
}

std::vector<Eigen::Vector2d> ActiveLoopClosing::known_stops_m(
    const pipeline::Snapshot& snapshot) const {
  std::vector<Eigen::Vector2d> stops_m;
  for (const std::size_t index : known_scans_) {
    if (index < snapshot.scans->size() && !(*snapshot.scans)[index].empty()) {
      stops_m.push_back((*snapshot.scans)[index].front().T_map_robot.position_m());
    }
  }
  return stops_m;
}

std::optional<EarlierStop> ActiveLoopClosing::choose(const pipeline::Snapshot& snapshot,
                                                     const Eigen::Vector2d& goal_m,
                                                     const TravelField& travel,
                                                     const mapping::RasterMap& map) {
  is_returning_ = false;
  if (snapshot.position_stddev_m.value_or(0.0) <= limit_m_) {
    return std::nullopt;
  }
  std::optional<EarlierStop> cheapest;
  for (const Eigen::Vector2d& stop_m : known_stops_m(snapshot)) {
    if ((stop_m - goal_m).norm() <= params_.same_walls_m) {
      return std::nullopt;
    }
    const auto cost_m = travel.cost_m(map.cell_at(stop_m));
    if (cost_m && (!cheapest || *cost_m < cheapest->cost_m)) {
      cheapest = EarlierStop{stop_m, *cost_m};
    }
  }
  is_returning_ = cheapest.has_value();
  return cheapest;
}

}  // namespace echomap::exploration
