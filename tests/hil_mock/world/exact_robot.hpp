// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/robot_params.hpp"

namespace echomap::world {

/// The usual robot, exactly as its file says and without noise.
inline RobotParams exact_robot() {
  RobotParams robot;
  robot.drive.wheel_diameter_stddev = 0.0;
  robot.drive.wheel_mismatch_stddev = 0.0;
  robot.drive.track_stddev = 0.0;
  robot.drive.motor_gain_stddev = 0.0;
  robot.drive.slip_m_per_sqrt_m = 0.0;
  robot.sonar.range_noise_m = 0.0;
  return robot;
}

}  // namespace echomap::world
