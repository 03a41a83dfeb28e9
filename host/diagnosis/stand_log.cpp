// SPDX-License-Identifier: MIT
#include "host/diagnosis/stand_log.hpp"

#include <cmath>
#include <utility>

#include "host/geometry/angle.hpp"

namespace echomap::diagnosis {
namespace {

/// Less than this is a robot that stands: some counts of a wheel that settles.
constexpr double kAtRestM = 0.002;
/// Steps whose wheels roll in the same proportion are one arc; the proportion as an angle.
constexpr double kSameArcRad = 0.03;

bool is_one_arc(const WheelStep& one, const WheelStep& other) {
  const double a = std::atan2(one.right_m, one.left_m);
  const double b = std::atan2(other.right_m, other.left_m);
  return std::abs(geometry::angle_between(a, b)) < kSameArcRad;
}

}  // namespace

StandLog::StandLog(const sensors::RobotGeometry& robot, const mapping::SonarSurfaceParams& surfaces)
    : robot_(robot), surface_params_(surfaces) {}

void StandLog::follow(const sensors::WheelTravel& travel) {
  if (!last_) {
    last_ = travel;
  }
  const WheelStep step{travel.left_m - last_->left_m, travel.right_m - last_->right_m};
  if (std::abs(step.left_m) + std::abs(step.right_m) < kAtRestM) {
    return;
  }
  end_stand();
  last_ = travel;
  travelled_m_ += 0.5 * std::abs(step.left_m + step.right_m);
  if (has_rolled_since_stand() && is_one_arc(steps_.back(), step)) {
    steps_.back().left_m += step.left_m;
    steps_.back().right_m += step.right_m;
  } else {
    steps_.push_back(step);
  }
}

void StandLog::begin_stop() {
  end_stand();
  is_in_stop_ = true;
}

void StandLog::add(const sensors::SonarObservation& observation) {
  follow(observation.travel);
  if (observation.has_answered) {
    const geometry::Pose2 T_axis_sonar = geometry::Pose2(0.0, 0.0, observation.pan_rad) *
                                         geometry::Pose2(robot_.sonar_forward_m, 0.0, 0.0);
    heard_.push_back({geometry::Pose2(), T_axis_sonar, observation.range_m});
  }
}

void StandLog::end_stop() {
  end_stand();
  stops_ += std::exchange(is_in_stop_, false) ? 1 : 0;
}

void StandLog::break_way() {
  end_stand();
  ++piece_;
}

/// A stand has readings enough for a surface; others were made in passing.
void StandLog::end_stand() {
  const auto heard = std::exchange(heard_, {});
  if (is_in_stop_ && heard.size() >= surface_params_.min_readings) {
    stands_.push_back(
        {steps_.size(), piece_, mapping::find_surfaces(heard, surface_params_).surfaces});
  } else {
    add_rolling_pings(heard);
  }
}

void StandLog::add_rolling_pings(const mapping::Scan& heard) {
  RollingPing ping{steps_.size(), {}, piece_};
  if (has_rolled_since_stand()) {
    --ping.steps;
    ping.rolled = steps_.back();
  }
  for (const mapping::PlacedReading& reading : heard) {
    if (reading.range_m) {
      ping.bearing_rad = reading.T_map_sonar.heading_rad();
      ping.range_m = *reading.range_m + robot_.sonar_forward_m;
      rolling_pings_.push_back(ping);
    }
  }
}

}  // namespace echomap::diagnosis
