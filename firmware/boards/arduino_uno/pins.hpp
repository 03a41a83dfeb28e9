// SPDX-License-Identifier: MIT
#pragma once

#include <avr/io.h>

/// Every pin of the Uno and the Nano that the firmware uses; docs/hardware/uno.md shows the wires.
namespace echomap {
namespace boards {

/// Port C: quadrature inputs with pull-up, left A, left B, right A, right B.
constexpr uint8_t kEncoderPins = _BV(PC0) | _BV(PC1) | _BV(PC2) | _BV(PC3);

/// Port B: sonar and servo.
constexpr uint8_t kEchoPin = _BV(PB0);  // ICP1
constexpr uint8_t kTriggerPin = _BV(PB1);
constexpr uint8_t kServoPin = _BV(PB2);  // OC1B

/// Port B: IN2 of bridges with IN1, IN2 and PWM; spare pins with any other.
constexpr uint8_t kLeftReversePin = _BV(PB3);
constexpr uint8_t kRightReversePin = _BV(PB4);

/// Port D: contacts (to ground, with pull-up) and motors. The forward pins are PH, high is forward;
/// or IN1; or IN2 of bridges with two inputs, whose IN1 has the PWM.
constexpr uint8_t kContactLeftPin = _BV(PD2);
constexpr uint8_t kContactRightPin = _BV(PD3);
constexpr uint8_t kLeftForwardPin = _BV(PD4);
constexpr uint8_t kRightPwmPin = _BV(PD5);  // OC0B
constexpr uint8_t kLeftPwmPin = _BV(PD6);   // OC0A
constexpr uint8_t kRightForwardPin = _BV(PD7);

/// Port C: the two-wire bus, A4 and A5.
constexpr uint8_t kSdaPin = _BV(PC4);
constexpr uint8_t kSclPin = _BV(PC5);

}  // namespace boards
}  // namespace echomap
