// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "host/diagnosis/robot_errors.hpp"
#include "host/diagnosis/stand_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/odometry.hpp"

namespace echomap::diagnosis {

/// A robot in a box of 3.1 x 2.3 m, without noise, whose sonar hears each wall within 25 degrees of
/// the perpendicular. It stands, drives and stands; what it tells of that is by its profile.
class BoxLog {
 public:
  explicit BoxLog(const RobotErrors& errors) : errors_(errors), log_(robot(), {}) {}

  static sensors::RobotGeometry robot() {
    sensors::RobotGeometry robot;
    robot.sonar_x_m = 0.0;
    return robot;
  }

  BoxLog& stand() {
    log_.begin_stop();
    for (int i = -30; i < 30; ++i) {
      ping(0.05 * i);
    }
    log_.end_stop();
    return *this;
  }

  BoxLog& ping(double pan_rad) {
    log_.add({{}, travel_, pan_rad, range_m(errors_.pan_scale * pan_rad + errors_.pan_offset_rad)});
    return *this;
  }

  /// What the wheels roll by the profile.
  BoxLog& roll(double left_m, double right_m) {
    travel_.left_m += left_m;
    travel_.right_m += right_m;
    const double left_true_m = errors_.left_scale * left_m;
    const double right_true_m = errors_.right_scale * right_m;
    T_box_robot_ = T_box_robot_ * sensors::arc_step(0.5 * (left_true_m + right_true_m),
                                                    (right_true_m - left_true_m) /
                                                        (errors_.track_scale * robot().track_m));
    log_.follow(travel_);
    return *this;
  }
  BoxLog& turn(double angle_rad) {
    const double arc_m = 0.5 * robot().track_m * angle_rad;
    return roll(-arc_m, arc_m);
  }
  BoxLog& drive(double distance_m) { return roll(distance_m, distance_m); }

  /// Round about at three places.
  const StandLog& tour() {
    stand().turn(std::numbers::pi).stand().turn(0.4).drive(0.6).stand();
    turn(2.0).stand().drive(0.5).stand().turn(1.1).stand();
    return log_;
  }
  StandLog& log() { return log_; }

 private:
  std::optional<double> range_m(double true_pan_rad) const {
    constexpr double kHeardRad = 0.44;
    const double bearing_rad = T_box_robot_.heading_rad() + true_pan_rad;
    const std::array<double, 4> depths_m{1.9 - T_box_robot_.x_m(),
                                         1.3 - T_box_robot_.y_m(),
                                         1.2 + T_box_robot_.x_m(),
                                         1.0 + T_box_robot_.y_m()};
    for (std::size_t wall = 0; wall < depths_m.size(); ++wall) {
      const double off_rad =
          geometry::angle_between(0.5 * std::numbers::pi * static_cast<double>(wall), bearing_rad);
      if (std::abs(off_rad) < kHeardRad) {
        return depths_m[wall] / errors_.range_scale;
      }
    }
    return std::nullopt;
  }

  RobotErrors errors_;
  StandLog log_;
  geometry::Pose2 T_box_robot_;
  sensors::WheelTravel travel_;
};

}  // namespace echomap::diagnosis
