// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/wheel_guard.hpp"
#include "firmware/control/wheel_speed_controller.hpp"
#include "firmware/drivers/motor_bridge.hpp"

namespace echomap {
namespace control {

/// One wheel with its motor and controller.
class DrivenWheel {
 public:
  constexpr explicit DrivenWheel(hal::Motor side) : motor_(side) {}

  void invert_motor(bool inverted) { motor_.invert(inverted); }
  void brake_at_zero(bool brakes) { motor_.brake_at_zero(brakes); }
  void arrive_within(uint8_t ticks) { controller_.arrive_within(ticks); }
  /// Is now where it should be, at `count`.
  void begin(int16_t count);
  /// First half of a control period: the reference goes on by `step` (1/4000 tick).
  void prepare(const protocol::ConfigureDrive& settings, int32_t step) {
    step_ = step;
    controller_.prepare(settings, step);
  }
  /// Second half: follows the reference from `count`.
  void follow(int16_t count);
  /// Leaves the motor at duty 0, braked where that is configured.
  void rest() { motor_.set(0); }
  /// Switches the motor off: no current, no brake.
  void release() { motor_.release(); }

  bool arrived() const { return controller_.arrived(); }
  /// What is wrong after a control period: kNone, kStalled, kRunaway or kOverSpeed.
  protocol::MotionOutcome classify(const protocol::ConfigureDrive& settings,
                                   const protocol::ConfigureSafety& limits);

 private:
  drivers::MotorBridge motor_;
  WheelSpeedController controller_;
  WheelGuard guard_;
  int32_t step_ = 0;
  int16_t duty_ = 0;
  int16_t last_count_ = 0;
};

}  // namespace control
}  // namespace echomap
