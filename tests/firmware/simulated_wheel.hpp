// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace echomap::tests {

/// A wheel with its motor, as simple as the controller's worst case: first-order speed, dry
/// friction as a dead zone of duty. Its encoder has x4 counts.
class SimulatedWheel {
 public:
  double no_load_ticks_per_s = 3300.0;
  double time_constant_s = 0.08;
  double dead_zone_duty = 30.0;
  bool blocked = false;

  /// Turns for `dt_s` with this duty (-255 .. 255).
  void step(double dt_s, int duty) {
    const double size = std::abs(duty) - dead_zone_duty;
    const double target =
        size > 0.0 && !blocked
            ? std::copysign(size / (255.0 - dead_zone_duty) * no_load_ticks_per_s, duty)
            : 0.0;
    ticks_per_s_ += (1.0 - std::exp(-dt_s / time_constant_s)) * (target - ticks_per_s_);
    position_ticks_ += ticks_per_s_ * dt_s;
  }

  std::int32_t ticks() const { return static_cast<std::int32_t>(std::floor(position_ticks_)); }
  double ticks_per_s() const { return ticks_per_s_; }

 private:
  double ticks_per_s_ = 0.0;
  double position_ticks_ = 0.5;
};

/// Levels of A (bit 0) and B (bit 1) at a count: 00 10 11 01 forwards.
inline std::uint8_t quadrature_levels(std::int32_t ticks) {
  constexpr std::uint8_t kCycle[] = {0b00, 0b01, 0b11, 0b10};
  return kCycle[ticks & 3];
}

}  // namespace echomap::tests
