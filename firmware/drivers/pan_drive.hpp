// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/pan_servo.hpp"
#include "firmware/drivers/pan_stepper.hpp"

namespace echomap {
namespace drivers {

/// What turns the sonar, a servo or a stepper by ConfigurePan::kind.
class PanDrive {
 public:
  /// `settings` is where the active ones stand.
  constexpr PanDrive(protocol::ConfigurePan& settings, const SparePins& pins)
      : settings_(settings), pins_(pins) {}

  /// True for a kind of drive that goes from its minimum to its maximum.
  static bool accepts(const protocol::ConfigurePan& settings);
  /// Takes settings that `accepts` has granted; only while it rests.
  void configure(const protocol::ConfigurePan& settings);

  /// True for a pan within the settings' limits, in centidegrees to the left; false for any while
  /// a stepper has not all of its phases.
  bool reaches(int32_t pan_cdeg) const;
  /// Turns to a pan that `reaches` has granted.
  void turn_to(int32_t pan_cdeg);
  /// Once a millisecond; true when it looks where it shall.
  bool tick();
  /// Nobody waits for it any more, there or not.
  void rest();

 private:
  protocol::ConfigurePan& settings_;
  const SparePins& pins_;
  PanServo servo_;
  PanStepper stepper_;
  uint16_t turning_ms_ = 0;
};

}  // namespace drivers
}  // namespace echomap
