// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "host/time/robot_time.hpp"

namespace echomap::time {

/// Seconds of the robot's clock at an instant; the inverse of robot_time().
inline double robot_seconds(RobotTime stamp) {
  return std::chrono::duration<double>(stamp.time_since_epoch()).count();
}

}  // namespace echomap::time
