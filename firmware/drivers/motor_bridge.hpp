// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/hal/motors.hpp"

namespace echomap {
namespace drivers {

/// Largest duty either way.
constexpr int16_t kFullDuty = 255;

/// One half of a phase/enable motor bridge. A reversal spends one call at duty 0, so that the old
/// duty never drives the new direction.
class MotorBridge {
 public:
  constexpr explicit MotorBridge(hal::Motor motor) : motor_(motor) {}

  /// Swaps the motor's directions; switches it off.
  void invert(bool inverted);
  /// Duty -255 .. 255, forward positive.
  void set(int16_t duty);

 private:
  hal::Motor motor_;
  bool inverted_ = false;
  bool pin_forward_ = true;
  bool running_ = false;
};

}  // namespace drivers
}  // namespace echomap
