// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host/geometry/pose2.hpp"

namespace echomap::sensors {

/// Encoder counts for both wheels, forward positive.
struct WheelTicks {
  std::int32_t left = 0;
  std::int32_t right = 0;
  bool operator==(const WheelTicks&) const = default;
};

/// What the host must know of a robot's body to read its sensors in metres and to command it in
/// counts. The robot frame lies midway between the wheels, x forward, y left. The defaults describe
/// a common two-wheel chassis (65 mm wheels, 1:48 gear motors with x4 encoders); a profile replaces
/// them.
struct RobotGeometry {
  double wheel_diameter_m = 0.065;  ///< Rolling diameter, tape measure or calibration.
  double track_m = 0.140;           ///< Distance between the wheels' contact points.
  double counts_per_turn = 1440.0;  ///< Encoder counts for one turn of a wheel.
  double left_wheel_scale = 1.0;    ///< What the wheel rolls, as a multiple of the above.
  double right_wheel_scale = 1.0;   ///< The same.
  double sonar_x_m = 0.060;         ///< Pan axis of the sonar, in the robot frame.
  double sonar_y_m = 0.0;           ///< Pan axis of the sonar, in the robot frame.
  double sonar_forward_m = 0.0;     ///< From the pan axis to the sonar's face.

  /// Of a wheel of scale 1.
  double metres_per_tick() const;
  /// Counts nearest to rolling `distance_m` with a wheel of scale 1, forward positive.
  std::int32_t ticks_from_metres(double distance_m) const;
  /// Both wheels the same way.
  WheelTicks straight(double distance_m) const;
  /// Wheels against each other: a turn on the spot, counter-clockwise positive, any size.
  WheelTicks turn_on_spot(double turn_rad) const;
  /// Counts a second of both wheels on an arc, counter-clockwise positive.
  WheelTicks arc_speeds(double forward_m_per_s, double turn_rad_per_s) const;
  /// The sonar's face with the pan at `pan_rad`; its x axis is the axis of the cone.
  geometry::Pose2 T_robot_sonar(double pan_rad) const;

  /// Throws std::invalid_argument where a length or count is not positive or not finite.
  void validate() const;

 private:
  WheelTicks ticks(double left_m, double right_m) const;
};

}  // namespace echomap::sensors
