// SPDX-License-Identifier: MIT
#include "host/sensors/robot_geometry.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace echomap::sensors {
namespace {

void require(bool holds, const char* what) {
  if (!holds) {
    throw std::invalid_argument(std::string("robot geometry: ") + what);
  }
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

}  // namespace

double RobotGeometry::metres_per_tick() const {
  return std::numbers::pi * wheel_diameter_m / counts_per_turn;
}

std::int32_t RobotGeometry::ticks_from_metres(double distance_m) const {
  return static_cast<std::int32_t>(std::lround(distance_m / metres_per_tick()));
}

WheelTicks RobotGeometry::ticks(double left_m, double right_m) const {
  return {ticks_from_metres(left_m / left_wheel_scale),
          ticks_from_metres(right_m / right_wheel_scale)};
}

WheelTicks RobotGeometry::straight(double distance_m) const {
  return ticks(distance_m, distance_m);
}

WheelTicks RobotGeometry::turn_on_spot(double turn_rad) const {
  const double arc_m = turn_rad * track_m / 2.0;
  return ticks(-arc_m, arc_m);
}

WheelTicks RobotGeometry::arc_speeds(double forward_m_per_s, double turn_rad_per_s) const {
  const double apart_m_per_s = turn_rad_per_s * track_m / 2.0;
  return ticks(forward_m_per_s - apart_m_per_s, forward_m_per_s + apart_m_per_s);
}

geometry::Pose2 RobotGeometry::T_robot_sonar(double pan_rad) const {
  return {sonar_x_m + sonar_forward_m * std::cos(pan_rad),
          sonar_y_m + sonar_forward_m * std::sin(pan_rad),
          pan_rad};
}

void RobotGeometry::validate() const {
  require(positive(wheel_diameter_m), "wheel_diameter_m must be positive");
  require(positive(track_m), "track_m must be positive");
  require(positive(counts_per_turn), "counts_per_turn must be positive");
  require(positive(left_wheel_scale), "left_wheel_scale must be positive");
  require(positive(right_wheel_scale), "right_wheel_scale must be positive");
  require(std::isfinite(sonar_x_m) && std::isfinite(sonar_y_m), "sonar_x_m, sonar_y_m: not finite");
  require(std::isfinite(sonar_forward_m), "sonar_forward_m is not finite");
}

}  // namespace echomap::sensors
