// SPDX-License-Identifier: MIT
#include "host/models/turn_forward_motion.hpp"

#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::models {

namespace {

/// Rounding of an odometry that stands still.
constexpr double kStill = 1e-6;

}  // namespace

TurnForwardMotion::TurnForwardMotion(const TurnForwardMotionParams& params) : params_(params) {
  geometry::ParameterValidator("turn and forward motion")
      .nonnegative_finite("turn_stddev_rad", params.turn_stddev_rad)
      .nonnegative_finite("forward_stddev_m", params.forward_stddev_m);
}

MotionSpread TurnForwardMotion::spread(const OdometryStep& step) const {
  const auto of_turn = [&](double turn_rad) {
    return std::abs(turn_rad) > kStill ? params_.turn_stddev_rad : 0.0;
  };
  return {of_turn(step.turn_before_rad),
          std::abs(step.drive_m) > kStill ? params_.forward_stddev_m : 0.0,
          of_turn(step.turn_after_rad),
          0.0};
}

}  // namespace echomap::models
