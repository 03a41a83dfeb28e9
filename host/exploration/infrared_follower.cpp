// SPDX-License-Identifier: MIT
#include "host/exploration/infrared_follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

namespace {

using geometry::radians;

/// A sensor looks ahead, aslant to the right or to the right side within these bearings.
constexpr double kAheadRad = radians(30.0);
constexpr double kObliqueRad = radians(75.0);
constexpr double kBesideRad = radians(120.0);

void validate(const InfraredFollowerParams& params) {
  geometry::ParameterValidator("infra-red follower")
      .positive("speed_m_per_s", params.speed_m_per_s)
      .positive("spin_rad_per_s", params.spin_rad_per_s)
      .positive("tick_s", params.tick_s)
      .positive("max_turn_rad_per_s", params.max_turn_rad_per_s)
      .positive("turn_per_m", params.turn_per_m)
      .at_least("turn_per_m_per_s", params.turn_per_m_per_s, 0.0)
      .positive("distance_m", params.distance_m)
      .positive("ahead_m", params.ahead_m)
      .positive("oblique_m", params.oblique_m)
      .positive("graze_m", params.graze_m)
      .positive("robot_radius_m", params.robot_radius_m);
}

}  // namespace

InfraredFollower::InfraredFollower(const InfraredFollowerParams& params) : params_(params) {
  validate(params);
  std::optional<std::size_t> beside;
  for (std::size_t i = 0; i < params.T_robot_sensor.size(); ++i) {
    const double right_rad = -params.T_robot_sensor[i].heading_rad();
    if (std::abs(right_rad) <= kAheadRad) {
      ahead_.push_back(i);
    } else if (right_rad > 0.0 && right_rad <= kObliqueRad) {
      oblique_.push_back(i);
    } else if (right_rad > 0.0 && right_rad <= kBesideRad) {
      beside = i;
    } else if (right_rad < 0.0 && right_rad >= -kBesideRad) {
      left_.push_back(i);
    }
  }
  if (ahead_.empty() || !beside) {
    throw std::invalid_argument("infra-red follower: no sensor looks ahead, or none to the right");
  }
  beside_ = *beside;
}

bool InfraredFollower::is_blocked(InfraredRanges ranges_m) const {
  return nearest_m(ranges_m, ahead_) < params_.ahead_m ||
         nearest_m(ranges_m, oblique_) < params_.oblique_m;
}

bool InfraredFollower::grazes_right(InfraredRanges ranges_m) const {
  return nearest_m(ranges_m, {beside_}) < params_.graze_m;
}

bool InfraredFollower::grazes_left(InfraredRanges ranges_m) const {
  return nearest_m(ranges_m, left_) < params_.graze_m;
}

std::optional<double> InfraredFollower::beside_m(InfraredRanges ranges_m) const {
  return beside_ < ranges_m.size() ? ranges_m[beside_] : std::nullopt;
}

Roll InfraredFollower::follow(InfraredRanges ranges_m) {
  if (is_blocked(ranges_m)) {
    last_m_.reset();
    return spin();
  }
  const auto wall_m = beside_m(ranges_m);
  const auto before_m = std::exchange(last_m_, wall_m);
  if (!wall_m) {
    const double radius_m = params_.robot_radius_m + params_.distance_m;
    return {params_.speed_m_per_s, -params_.speed_m_per_s / radius_m, params_.tick_s};
  }
  const double away_m_per_s = (*wall_m - before_m.value_or(*wall_m)) / params_.tick_s;
  const double turn_rad_per_s = -params_.turn_per_m * (*wall_m - params_.distance_m) -
                                params_.turn_per_m_per_s * away_m_per_s;
  return {params_.speed_m_per_s,
          std::clamp(turn_rad_per_s, -params_.max_turn_rad_per_s, params_.max_turn_rad_per_s),
          params_.tick_s};
}

double InfraredFollower::nearest_m(InfraredRanges ranges_m,
                                   const std::vector<std::size_t>& sensors) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const std::size_t i : sensors) {
    if (i < ranges_m.size()) {
      nearest_m = std::min(nearest_m, ranges_m[i].value_or(nearest_m));
    }
  }
  return nearest_m;
}

}  // namespace echomap::exploration
