// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/rp2040/registers.hpp"

/// Every pin of the Pico that the firmware uses; docs/hardware/pico.md shows the wires.
namespace echomap {
namespace boards {

/// A pin by its name on the board: 12 is GP12.
using Pin = uint8_t;

/// Who has the pin: RP2040 data sheet, 2.19.2.
enum class PinFunction : uint8_t {
  kUart = 2,
  kI2c = 3,
  kPwm = 4,
  kLevel = 5,  ///< SIO: the program.
  kPio0 = 6,
  kNone = 31,
};

/// Gives the pin to a part of the chip.
inline void set_function(Pin pin, PinFunction function) {
  pins().pin[pin].ctrl = static_cast<uint32_t>(function);
}

/// Level of an output of the program.
inline void set_level(Pin pin, bool high) { (high ? sio().out_set : sio().out_clr) = bit(pin); }

/// Level on the pin now.
inline bool level_of(Pin pin) { return (sio().in & bit(pin)) != 0; }

/// An output of the program, at the level set before.
void make_output(Pin pin);
/// Inputs of the program, and of whatever reads the pins besides.
void pull_up(Pin pin);
void pull_down(Pin pin);
/// No digital input and no pull, for the converter.
void make_analog(Pin pin);

/// Serial port: UART0.
constexpr Pin kSendPin = 0;
constexpr Pin kReceivePin = 1;

/// Encoders, two pins each in the order A, B: PIO0.
constexpr Pin kLeftEncoderPin = 2;
constexpr Pin kRightEncoderPin = 4;

/// Sonar and servo.
constexpr Pin kTriggerPin = 6;
constexpr Pin kEchoPin = 7;   // PWM slice 3, channel B.
constexpr Pin kServoPin = 8;  // PWM slice 4, channel A.

/// Motors. The forward pins are PH, high is forward, or IN1. The reverse pins are IN2, of bridges
/// with two inputs too, whose IN1 is the PWM pin. Servos are on the PWM pins.
constexpr Pin kLeftPwmPin = 10;      // PWM slice 5, channel A.
constexpr Pin kLeftReversePin = 11;  // Spare pins where the bridge does not need them.
constexpr Pin kRightPwmPin = 12;     // PWM slice 6, channel A.
constexpr Pin kRightReversePin = 13;
constexpr Pin kLeftForwardPin = 14;
constexpr Pin kRightForwardPin = 15;

/// Contacts, to ground.
constexpr Pin kContactLeftPin = 16;
constexpr Pin kContactRightPin = 17;

/// I2C0; spare pins while no transfer was started.
constexpr Pin kTwiDataPin = 20;
constexpr Pin kTwiClockPin = 21;

/// The first pin of the converter, its channel 0.
constexpr Pin kFirstAnalogPin = 26;

/// Slices of the PWM unit.
constexpr uint8_t kEchoSlice = 3;
constexpr uint8_t kServoSlice = 4;
constexpr uint8_t kLeftSlice = 5;
constexpr uint8_t kRightSlice = 6;

/// Divider of a slice, with four bits of fraction: 125 MHz / 62.5 are half microseconds.
constexpr uint32_t kHalfUsDivider = 62U << 4 | 8;

}  // namespace boards
}  // namespace echomap
