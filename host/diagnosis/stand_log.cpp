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
  const bool is_behind_stand = !stands_.empty() && stands_.back().steps == steps_.size();
  if (!steps_.empty() && !is_behind_stand && is_one_arc(steps_.back(), step)) {
    steps_.back().left_m += step.left_m;
    steps_.back().right_m += step.right_m;
  } else {
    steps_.push_back(step);
  }
}

void StandLog::begin_stop() { is_in_stop_ = true; }

void StandLog::add(const sensors::SonarObservation& observation) {
  follow(observation.travel);
  if (is_in_stop_ && observation.has_answered) {
    const geometry::Pose2 T_axis_sonar = geometry::Pose2(0.0, 0.0, observation.pan_rad) *
                                         geometry::Pose2(robot_.sonar_forward_m, 0.0, 0.0);
    heard_.push_back({geometry::Pose2(), T_axis_sonar, observation.range_m});
  }
}

void StandLog::end_stop() {
  if (std::exchange(is_in_stop_, false)) {
    end_stand();
    ++stops_;
  }
}

void StandLog::break_way() {
  end_stand();
  ++piece_;
}

void StandLog::end_stand() {
  const auto heard = std::exchange(heard_, {});
  if (!heard.empty()) {
    stands_.push_back(
        {steps_.size(), piece_, mapping::find_surfaces(heard, surface_params_).surfaces});
  }
}

}  // namespace echomap::diagnosis
