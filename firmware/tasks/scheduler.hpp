// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/fixed_point.hpp"

namespace echomap {
namespace tasks {

/// Hands the interrupt's ticks on to the main loop, which may be late but misses none (up to 255).
class Scheduler {
 public:
  /// From the tick's interrupt.
  void on_tick() { ticked_ = static_cast<uint8_t>(ticked_ + 1); }

  bool has_tick() const { return ticked_ != served_; }
  /// Takes the oldest tick that has not been served; false when there is none.
  bool take_tick();
  /// True in every tick taken in which the wheels are to be controlled.
  bool control_is_due() const { return served_ % control::kControlPeriodMs == 0; }

 private:
  volatile uint8_t ticked_ = 0;
  uint8_t served_ = 0;
};

}  // namespace tasks
}  // namespace echomap
