// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "host/models/linear_odometry_motion.hpp"
#include "host/models/odometry_motion.hpp"
#include "host/models/turn_forward_motion.hpp"

namespace echomap::models {

/// Any of the motion models.
using MotionModel = std::variant<OdometryMotion, TurnForwardMotion, LinearOdometryMotion>;

/// How far the motion that odometry tells may be off, by the model that is held.
inline MotionSpread spread_of(const MotionModel& model, const OdometryStep& step) {
  return std::visit([&](const auto& held) { return held.spread(step); }, model);
}

}  // namespace echomap::models
