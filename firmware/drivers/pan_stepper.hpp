// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/spare_pins.hpp"
#include "protocol/command_messages.hpp"

namespace echomap {
namespace drivers {

/// A geared stepper under the sonar (28BYJ-48) on four spare pins, in half steps, one a millisecond
/// at most. It counts from where it stands at the start, which is straight ahead, and forgets no
/// turn: what one sweep has wound up the next unwinds.
class PanStepper {
 public:
  /// True for a number of steps in range and a speed of 1 .. 1000 steps/s.
  static bool accepts(const protocol::ConfigurePan& settings);

  /// Turns to a pan within the limits that `accepts` has granted, in centidegrees to the left.
  void turn_to(const protocol::ConfigurePan& settings, int32_t pan_cdeg);
  /// Goes on by a step when it is time for one; once a millisecond. True when it is there.
  bool tick(const SparePins& pins);
  /// Stays where it is and switches the coils off: they would get hot, and the gear holds a sonar.
  void rest(const SparePins& pins);

 private:
  int16_t position_steps_ = 0;
  int16_t target_steps_ = 0;
  uint16_t steps_per_s_ = 0;
  uint16_t progress_ = 0;  ///< Part of the next step, in steps/1000.
};

}  // namespace drivers
}  // namespace echomap
