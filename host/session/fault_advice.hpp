// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/diagnosis/fault.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::session {

/// What is wrong with a robot, and what to change.
struct FaultAdvice {
  std::string what;    ///< Of the robot: "the left wheel rolls 8 % farther than ..".
  std::string change;  ///< In its profile or on it: "set left_wheel_scale = 1.08 in [drive]".
};

/// In words, for a robot of this profile.
FaultAdvice advice_of(const diagnosis::Fault& fault, const RobotProfile& profile);

}  // namespace echomap::session
