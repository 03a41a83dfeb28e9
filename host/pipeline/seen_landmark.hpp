// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "host/time/robot_time.hpp"

namespace echomap::pipeline {

/// Something known by its number, and where it was seen.
struct SeenLandmark {
  time::RobotTime stamp;  ///< Of the last pose in the trajectory by then.
  std::int64_t id = 0;
  double range_m = 0.0;
  double bearing_rad = 0.0;                              ///< In the robot's frame.
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< In the map frame.
};

}  // namespace echomap::pipeline
