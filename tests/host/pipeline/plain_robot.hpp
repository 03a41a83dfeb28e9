// SPDX-License-Identifier: MIT
#pragma once

#include "host/sensors/robot_geometry.hpp"

namespace echomap::pipeline {

/// With wheels 20 cm apart, else as RobotGeometry has it.
inline sensors::RobotGeometry wide_robot() {
  sensors::RobotGeometry robot;
  robot.track_m = 0.2;
  return robot;
}

/// Its sonar turns above the middle between them.
inline sensors::RobotGeometry plain_robot() {
  sensors::RobotGeometry robot = wide_robot();
  robot.sonar_x_m = 0.0;
  return robot;
}

}  // namespace echomap::pipeline
