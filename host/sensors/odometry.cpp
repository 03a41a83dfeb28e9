// SPDX-License-Identifier: MIT
#include "host/sensors/odometry.hpp"

#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::sensors {
namespace {

/// sin(x) / x, by its series near zero.
double sinc(double x) { return std::abs(x) < 1e-6 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

}  // namespace

geometry::Pose2 arc_step(double arc_m, double turn_rad) {
  // Equation 5.9 with v/w (sin(a + w dt) - sin a) = chord cos(a + w dt / 2), free of the division
  // by a turn of zero.
  const double half_turn_rad = turn_rad / 2.0;
  const double chord_m = arc_m * sinc(half_turn_rad);
  return {chord_m * std::cos(half_turn_rad), chord_m * std::sin(half_turn_rad), turn_rad};
}

WheelOdometry::WheelOdometry(double track_m) : track_m_(track_m) {
  geometry::ParameterValidator("odometry").positive_finite("track_m", track_m);
}

const geometry::Pose2& WheelOdometry::update(const WheelTravel& travel) {
  const double left_m = travel.left_m - last_.left_m;
  const double right_m = travel.right_m - last_.right_m;
  T_odom_robot_ = T_odom_robot_ * arc_step((left_m + right_m) / 2.0, (right_m - left_m) / track_m_);
  last_ = travel;
  return T_odom_robot_;
}

void WheelOdometry::move_to(const geometry::Pose2& T_odom_robot, const WheelTravel& travel) {
  T_odom_robot_ = T_odom_robot;
  last_ = travel;
}

}  // namespace echomap::sensors
