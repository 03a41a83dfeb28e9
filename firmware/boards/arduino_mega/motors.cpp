// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include <avr/io.h>

#include "firmware/boards/arduino_mega/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint8_t kFastPwm8Mode = _BV(WGM30);                 // Mode 5, in both control registers:
constexpr uint8_t kFastPwm8Control = _BV(WGM32) | _BV(CS31);  // 16 MHz / 8 / 256 = 7.8 kHz.
constexpr uint8_t kConnected = _BV(COM3A1);
static_assert(WGM30 == WGM40 && WGM32 == WGM42 && CS31 == CS41 && COM3A1 == COM4A1,
              "timers 3 and 4 have the same layout");

void set_pin(volatile uint8_t& port, uint8_t pin, bool high) {
  if (high) {
    port |= pin;
  } else {
    port &= static_cast<uint8_t>(~pin);
  }
}

}  // namespace

void start_motors() {
  PORTE &= static_cast<uint8_t>(~kRightPwmPin);
  PORTH &= static_cast<uint8_t>(~kLeftPwmPin);
  DDRE |= kRightPwmPin;
  DDRG |= kLeftForwardPin;
  DDRH |= kLeftPwmPin | kRightForwardPin;
  TCCR3A = kFastPwm8Mode;
  TCCR3B = kFastPwm8Control;
  TCCR4A = kFastPwm8Mode;
  TCCR4B = kFastPwm8Control;
}

/// Off the timers the ports, which are low, have the pins.
void cut_motors() {
  TCCR3A = kFastPwm8Mode;
  TCCR4A = kFastPwm8Mode;
}

}  // namespace boards

namespace hal {

/// Fast PWM has no duty 0, only a spike per period: off means that the port, low, has the pin.
void set_motor(Motor motor, bool forward, uint8_t duty) {
  const uint8_t mode =
      duty == 0 ? boards::kFastPwm8Mode : (boards::kFastPwm8Mode | boards::kConnected);
  if (motor == Motor::kLeft) {
    boards::set_pin(PORTG, boards::kLeftForwardPin, forward);
    OCR4A = duty;
    TCCR4A = mode;
  } else {
    boards::set_pin(PORTH, boards::kRightForwardPin, forward);
    OCR3A = duty;
    TCCR3A = mode;
  }
}

}  // namespace hal
}  // namespace echomap
