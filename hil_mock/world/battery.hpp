// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/part_params.hpp"

namespace echomap::world {

/// What one motor does: the duty that it gets and its speed, both -1 .. 1 of full.
struct MotorLoad {
  double duty = 0.0;
  double speed_share = 0.0;
};

/// A battery that electronics and motors drain, with an inner resistance.
class Battery {
 public:
  Battery(const BatteryParams& params, const NoiseStream& noise)
      : params_(params), noise_(noise), volts_(params.full_v) {}

  /// Feeds two motors for `dt_s`.
  void step(double dt_s, const MotorLoad& left, const MotorLoad& right);

  /// Leaves no more than this share of its charge, 0 .. 1.
  void drain_to(double share);

  double volts() const { return volts_; }
  /// Behind the divider, with noise; draws it anew at each call.
  double pin_millivolts();

 private:
  double motor_amperes(const MotorLoad& load) const;

  BatteryParams params_;
  NoiseStream noise_;
  double used_ah_ = 0.0;
  double volts_;
};

}  // namespace echomap::world
