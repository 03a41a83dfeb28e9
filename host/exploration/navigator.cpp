// SPDX-License-Identifier: MIT
#include "host/exploration/navigator.hpp"

#include "host/exploration/planning_map.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::exploration {

using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

bool is_stopped(const pipeline::Snapshot& snapshot, MotionResult last) {
  return snapshot.hazards.bump_left || snapshot.hazards.bump_right ||
         last == MotionResult::kBumped || last == MotionResult::kHazard ||
         last == MotionResult::kStalled;
}

Navigator::Navigator(const NavigatorParams& params) : params_(params), follower_(params.follower) {
  geometry::ParameterValidator("navigator")
      .at_least("back_off_m", params.back_off_m, 0.0)
      .positive("obstacle_m", params.obstacle_m)
      .positive("max_failures", params.max_failures)
      .within("standing_cost", params.standing_cost, 1.0, 30.0);
}

RasterMap Navigator::map_of(const pipeline::Snapshot& snapshot, double margin_m) const {
  RasterMap map = planning_map(snapshot, margin_m, params_.costs.robot_radius_m);
  for (const Eigen::Vector2d& obstacle_m : obstacles_m_) {
    draw_disc(map,
              obstacle_m,
              0.5 * params_.obstacle_m,
              {CellState::kFree, CellState::kUnknown},
              CellState::kOccupied);
  }
  return map;
}

void Navigator::set_map(const RasterMap& map, const pipeline::Snapshot& snapshot) {
  set_hypothetical_map(map, snapshot);
  travel_.search(costs(), costs().cell_at(snapshot.latest.T_map_robot.position_m()));
}

void Navigator::set_hypothetical_map(const RasterMap& map, const pipeline::Snapshot& snapshot) {
  costs_ = costs_on(map, snapshot, params_.costs);
  for (const OccupiedFloor& other : standing_) {
    const double radius_m = other.radius_m + params_.costs.robot_radius_m;
    if (other.is_closed) {
      // The robot may stand nearer already: then it may leave.
      const double apart_m = (other.at_m - snapshot.latest.T_map_robot.position_m()).norm();
      costs_->close_around(other.at_m, std::min(radius_m, apart_m - costs_->resolution_m()));
    } else {
      costs_->raise_around(other.at_m, radius_m, params_.standing_cost);
    }
  }
}

void Navigator::follow_path_to(const Pose2& T_map_robot,
                               const Eigen::Vector2d& goal_m,
                               double cost_m) {
  const auto path =
      planner_.find(costs(), costs().cell_at(T_map_robot.position_m()), costs().cell_at(goal_m));
  follower_.follow(path && cost_m > 0.0 ? path->points_m : std::vector<Eigen::Vector2d>{});
  motions_left_ = max_motions(cost_m, params_.follower);
}

std::optional<Motion> Navigator::next(const Pose2& T_map_robot) {
  const auto motion = follower_.next(T_map_robot, costs());
  if (!motion || motions_left_ == 0) {
    return std::nullopt;
  }
  --motions_left_;
  return motion;
}

Drive Navigator::back_off(const pipeline::Snapshot& snapshot) {
  constexpr double kSideRad = 0.6;
  const auto& hazards = snapshot.hazards;
  const double aside_rad =
      kSideRad * ((hazards.bump_left ? 1.0 : 0.0) - (hazards.bump_right ? 1.0 : 0.0));
  const double ahead_m = params_.costs.robot_radius_m + 0.5 * params_.obstacle_m;
  const Eigen::Vector2d from_robot_m = ahead_m * geometry::unit_vector(aside_rad);
  obstacles_m_.emplace_back(snapshot.latest.T_map_robot * from_robot_m);
  return Drive{-params_.back_off_m};
}

std::optional<Motion> Navigator::recover(const pipeline::Snapshot& snapshot,
                                         MotionResult last,
                                         bool is_driving) {
  const bool is_in_the_way = is_driving && is_stopped(snapshot, last);
  if (last == MotionResult::kReached && !is_in_the_way) {
    return std::nullopt;
  }
  if (++failures_ > params_.max_failures) {
    return Finished{FinishReason::kNowhereToGo};
  }
  return is_in_the_way ? std::optional<Motion>(back_off(snapshot)) : std::nullopt;
}

}  // namespace echomap::exploration
