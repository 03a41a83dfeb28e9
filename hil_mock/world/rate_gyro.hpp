// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/part_params.hpp"

namespace echomap::world {

/// A rate gyro: scale error and bias of this run, a bias that wanders, white noise, and a low-pass
/// filter of first order before its output.
class RateGyro {
 public:
  /// Draws this run's errors.
  RateGyro(const GyroParams& params, const NoiseStream& noise);

  /// Turns at `yaw_rad_per_s`, counter-clockwise positive, for `dt_s`.
  void step(double dt_s, double yaw_rad_per_s, double bandwidth_hz);

  double rate_deg_per_s() const { return rate_deg_per_s_; }
  /// The present one.
  double bias_deg_per_s() const { return bias_deg_per_s_; }

 private:
  GyroParams params_;
  NoiseStream noise_;
  double bias_deg_per_s_;
  double scale_;
  double rate_deg_per_s_ = 0.0;
};

}  // namespace echomap::world
