// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/robot_params.hpp"

namespace echomap::world {

/// A pan servo that turns toward what its pulses say at a bounded speed.
class PanServo {
 public:
  /// Looks straight ahead. Throws std::invalid_argument for a scale or speed of zero.
  explicit PanServo(const PanParams& params);

  /// Follows a pulse for `dt_s`; without pulses, `pulse_us` 0, it stays where it is.
  void step(double dt_s, double pulse_us);

  /// Counter-clockwise from straight ahead, in the robot frame.
  double pan_rad() const { return pan_rad_; }

 private:
  PanParams params_;
  double pan_rad_ = 0.0;
};

}  // namespace echomap::world
