// SPDX-License-Identifier: MIT
#include "hil_mock/world/battery.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::world {

void Battery::step(double dt_s, const MotorLoad& left, const MotorLoad& right) {
  const double amperes = params_.idle_a + motor_amperes(left) + motor_amperes(right);
  used_ah_ = std::min(params_.capacity_ah, used_ah_ + amperes * dt_s / 3600.0);
  const double used = used_ah_ / params_.capacity_ah;
  const double rest_v = params_.full_v + used * (params_.empty_v - params_.full_v);
  volts_ = std::max(0.0, rest_v - amperes * params_.resistance_ohm);
}

void Battery::drain_to(double share) {
  used_ah_ = std::max(used_ah_, (1.0 - share) * params_.capacity_ah);
}

double Battery::pin_millivolts() {
  const double mean_mv = 1000.0 * params_.divider * volts_;
  return std::max(0.0, mean_mv + params_.noise_mv * noise_.normal());
}

/// Winding resistance drops what the turning motor's own voltage leaves of the duty; the bridge
/// passes that current on for the duty's share of the time.
double Battery::motor_amperes(const MotorLoad& load) const {
  const double winding_a = params_.stall_a * std::abs(load.duty - load.speed_share) +
                           params_.no_load_a * std::abs(load.speed_share);
  return std::min(1.0, std::abs(load.duty)) * winding_a;
}

}  // namespace echomap::world
