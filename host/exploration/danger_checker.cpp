// SPDX-License-Identifier: MIT
#include "host/exploration/danger_checker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {
namespace {

/// A motor that starts pulls the voltage down for a moment: half a minute of reports counts.
constexpr double kBatteryShare = 0.03;
/// A strategy whose every drive is in danger is asked so many times at most.
constexpr int kMaxRefusals = 8;

bool has_failed(MotionResult result) {
  return result == MotionResult::kBumped || result == MotionResult::kHazard ||
         result == MotionResult::kStalled || result == MotionResult::kTimedOut ||
         result == MotionResult::kRefused;
}

}  // namespace

DangerChecker::DangerChecker(std::unique_ptr<Explorer> strategy, const DangerCheckerParams& params)
    : strategy_(std::move(strategy)), params_(params) {
  geometry::ParameterValidator("danger checker")
      .require(strategy_ != nullptr, "a strategy must be given")
      .positive("robot_radius_m", params.robot_radius_m)
      .at_least("min_clearance_m", params.min_clearance_m, 0.0)
      .at_least("min_drive_m", params.min_drive_m, 0.0)
      .positive("max_failures", params.max_failures)
      .positive("max_same_views", params.max_same_views)
      .positive("moved_m", params.moved_m);
}

Motion DangerChecker::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  note(snapshot, last);
  if (const auto reason = danger(snapshot)) {
    return Finished{*reason};
  }
  const bool is_low = battery_v_ && params_.return_below_v && *battery_v_ < *params_.return_below_v;
  if (is_low && !way_home_) {
    way_home_.emplace(params_.costs, params_.follower);
  }
  if (way_home_) {
    return way_home_->next(snapshot).value_or(Finished{FinishReason::kBatteryLow});
  }
  return ask_strategy(snapshot, last);
}

void DangerChecker::note(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (snapshot.battery && snapshot.battery->stamp != battery_stamp_) {
    battery_stamp_ = snapshot.battery->stamp;
    const double now_v = snapshot.battery->voltage_v;
    battery_v_ = battery_v_.value_or(now_v) + kBatteryShare * (now_v - battery_v_.value_or(now_v));
  }
  const Eigen::Vector2d here_m = snapshot.latest.T_map_robot.position_m();
  failures_ = has_failed(last) ? failures_ + 1 : failures_;
  if ((here_m - got_to_m_).norm() >= params_.moved_m) {
    got_to_m_ = here_m;
    failures_ = 0;
  }
  if (snapshot.stops != stops_) {
    compare_views(snapshot);
    stops_ = snapshot.stops;
    last_stop_m_ = here_m;
    last_scan_ = snapshot.last_scan;
  }
}

void DangerChecker::compare_views(const pipeline::Snapshot& snapshot) {
  const double moved_m = (snapshot.latest.T_map_robot.position_m() - last_stop_m_).norm();
  if (!last_scan_ || moved_m < params_.moved_m) {
    return;
  }
  const bool same = is_same_view(*last_scan_, *snapshot.last_scan, params_.same_view);
  same_views_ = same ? same_views_ + 1 : 0;
}

std::optional<FinishReason> DangerChecker::danger(const pipeline::Snapshot& snapshot) const {
  if (snapshot.hazards.is_in_the_air()) {
    return FinishReason::kLifted;
  }
  if (battery_v_ && params_.stop_below_v && *battery_v_ < *params_.stop_below_v) {
    return FinishReason::kBatteryLow;
  }
  if (failures_ >= params_.max_failures || same_views_ >= params_.max_same_views) {
    return FinishReason::kStuck;
  }
  return std::nullopt;
}

Motion DangerChecker::ask_strategy(const pipeline::Snapshot& snapshot, MotionResult last) {
  for (int i = 0; i < kMaxRefusals; ++i) {
    Motion motion = strategy_->next(snapshot, last);
    auto* drive = std::get_if<Drive>(&motion);
    if (drive == nullptr || drive->distance_m <= 0.0 || !params_.shortens_drives) {
      return motion;
    }
    const double clear_m = clear_distance_m(snapshot);
    if (clear_m >= std::min(drive->distance_m, params_.min_drive_m)) {
      drive->distance_m = std::min(drive->distance_m, clear_m);
      return motion;
    }
    last = MotionResult::kRefused;
  }
  return Finished{FinishReason::kStuck};
}

/// How far the hull can go straight ahead before it comes near to a cell that is occupied. What it
/// stands on already, by the map, is no reason to stay.
double DangerChecker::clear_distance_m(const pipeline::Snapshot& snapshot) const {
  const mapping::OccupancyGrid& grid = *snapshot.grid;
  const geometry::Pose2 T_robot_map = snapshot.latest.T_map_robot.inverse();
  const double radius_m = params_.robot_radius_m + params_.min_clearance_m;
  double clear_m = std::numeric_limits<double>::infinity();
  const auto& bounds = grid.bounds();
  for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      const Eigen::Vector2d cell_m = T_robot_map * grid.center_m({x, y});
      const bool is_ahead = cell_m.x() > 0.0 && std::abs(cell_m.y()) < params_.robot_radius_m;
      if (is_ahead && cell_m.norm() > params_.robot_radius_m &&
          grid.state({x, y}) == mapping::CellState::kOccupied) {
        const double half_m = std::sqrt(radius_m * radius_m - cell_m.y() * cell_m.y());
        clear_m = std::min(clear_m, std::max(0.0, cell_m.x() - half_m));
      }
    }
  }
  return clear_m;
}

}  // namespace echomap::exploration
