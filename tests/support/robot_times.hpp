// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host/time/robot_time.hpp"

namespace echomap::tests {

/// An instant of the robot's clock.
inline time::RobotTime at_us(std::int64_t stamp_us) {
  return time::RobotTime(time::RobotClock::duration(stamp_us));
}

}  // namespace echomap::tests
