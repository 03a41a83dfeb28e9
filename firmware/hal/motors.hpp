// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// The two motors, as seen from behind the robot.
enum class Motor : uint8_t { kLeft, kRight };

/// What stands between the board and the motors: which pins it has and what they mean. Numbered as
/// protocol::MotorBridgeKind; docs/hardware has the pins of each board.
enum class BridgeKind : uint8_t {
  kPhaseEnable,  ///< A direction and a PWM. Some brake at duty 0, some coast.
  kIn1In2Pwm,    ///< Two directions and a PWM.
  kTwoPwm,       ///< Two inputs, and the PWM on one of them; one alone that is high is full speed.
  kServo,        ///< Pulses of 1000 .. 2000 us every 20 ms for servos that turn on and on.
};

/// False for a kind for which the board has no pins or no timer.
bool can_bridge(BridgeKind kind);
/// The spare pins (aux_pins.hpp), a bit each, that a kind takes.
uint16_t bridge_aux_pins(BridgeKind kind);
/// Switches the motors off, lets go of the pins that only the kind before had, and makes those of
/// this one outputs that are low. `slow_pwm` is about 1 kHz instead of 7.8, for bridges of bipolar
/// transistors. A board starts with kPhaseEnable.
void use_bridge(BridgeKind kind, bool slow_pwm);

/// Turns a motor with a duty of 1 .. 255. The direction of one that turns must not change: the
/// caller stops it and lets one PWM period pass, 128 us, or 1.03 ms of the slow PWM.
void set_motor(Motor motor, bool forward, uint8_t duty);
/// No current without `brake`: all pins of the motor are low. With it the motor is shorted, or its
/// servo told to stand; that needs a kind other than kPhaseEnable.
void stop_motor(Motor motor, bool brake);

/// The servo's pulse for a duty, in half microseconds: 1500 us at 0, 500 more or less at 255.
inline uint16_t wheel_pulse_half_us(bool forward, uint8_t duty) {
  constexpr uint16_t kCentre = 3000;
  const uint16_t change = static_cast<uint16_t>(uint32_t{duty} * 1004 >> 8);  // 1000 / 255.
  return static_cast<uint16_t>(forward ? kCentre + change : kCentre - change);
}

}  // namespace hal
}  // namespace echomap
