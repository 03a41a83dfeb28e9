// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/time/robot_time.hpp"

namespace echomap::sensors {

/// Distance that each wheel has rolled since the session began, forward positive.
struct WheelTravel {
  double left_m = 0.0;
  double right_m = 0.0;
};

/// One odometry report in SI units.
struct OdometryObservation {
  time::RobotTime stamp;
  WheelTravel travel;
};

/// One sonar reading. `range_m` is empty where nothing answered. `pan_rad` is counter-clockwise
/// from straight ahead, in the robot frame.
struct SonarObservation {
  time::RobotTime stamp;
  WheelTravel travel;
  double pan_rad = 0.0;
  std::optional<double> range_m;
};

}  // namespace echomap::sensors
