// SPDX-License-Identifier: MIT
#include "hil_mock/world/pan_servo.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace echomap::world {

PanServo::PanServo(const PanParams& params) : params_(params) {
  if (params.us_per_90deg == 0.0 || !(params.slew_rad_per_s > 0.0)) {
    throw std::invalid_argument("pan: scale or speed is zero");
  }
}

void PanServo::step(double dt_s, double pulse_us) {
  if (pulse_us <= 0.0) {
    return;
  }
  const double quarter_turns = (pulse_us - params_.centre_us) / params_.us_per_90deg;
  const double goal_rad =
      std::clamp(0.5 * std::numbers::pi * quarter_turns, -params_.limit_rad, params_.limit_rad);
  const double reach_rad = params_.slew_rad_per_s * dt_s;
  pan_rad_ += std::clamp(goal_rad - pan_rad_, -reach_rad, reach_rad);
}

}  // namespace echomap::world
