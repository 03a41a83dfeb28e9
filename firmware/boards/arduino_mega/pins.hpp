// SPDX-License-Identifier: MIT
#pragma once

#include <avr/io.h>

/// Every pin of the Mega that the firmware uses; docs/hardware/mega.md shows the wires.
namespace echomap {
namespace boards {

/// Port B: quadrature inputs with pull-up, left A, left B, right A, right B.
constexpr uint8_t kEncoderPins = _BV(PB0) | _BV(PB1) | _BV(PB2) | _BV(PB3);

/// Port L: sonar and servo.
constexpr uint8_t kEchoPin = _BV(PL1);  // ICP5
constexpr uint8_t kTriggerPin = _BV(PL3);
constexpr uint8_t kServoPin = _BV(PL4);  // OC5B

/// Port E: contacts (to ground, with pull-up).
constexpr uint8_t kContactLeftPin = _BV(PE4);
constexpr uint8_t kContactRightPin = _BV(PE5);

/// Ports E, G and H: motors. The forward pins are PH, high is forward; or IN1; or IN2 of bridges
/// with two inputs, whose IN1 is the PWM pin. The reverse pins are IN2 of bridges with three.
constexpr uint8_t kRightPwmPin = _BV(PE3);      // OC3A
constexpr uint8_t kLeftForwardPin = _BV(PG5);   // OC0B
constexpr uint8_t kLeftPwmPin = _BV(PH3);       // OC4A
constexpr uint8_t kRightForwardPin = _BV(PH4);  // OC4B
constexpr uint8_t kLeftReversePin = _BV(PH5);
constexpr uint8_t kRightReversePin = _BV(PH6);

/// Port B: servos in place of motors.
constexpr uint8_t kLeftServoPin = _BV(PB5);   // OC1A
constexpr uint8_t kRightServoPin = _BV(PB6);  // OC1B

/// Port D: the two-wire bus, D20 and D21.
constexpr uint8_t kSdaPin = _BV(PD1);
constexpr uint8_t kSclPin = _BV(PD0);

}  // namespace boards
}  // namespace echomap
