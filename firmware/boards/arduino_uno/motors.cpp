// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include <avr/io.h>

#include "firmware/boards/arduino_uno/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {
namespace {

void set_pin(uint8_t pin, bool high) {
  if (high) {
    PORTD |= pin;
  } else {
    PORTD &= static_cast<uint8_t>(~pin);
  }
}

/// Fast PWM has no duty 0, only a spike per period: off means that the port, low, has the pin.
void set_duty(volatile uint8_t& compare, uint8_t connect, uint8_t duty) {
  compare = duty;
  if (duty == 0) {
    TCCR0A &= static_cast<uint8_t>(~connect);
  } else {
    TCCR0A |= connect;
  }
}

}  // namespace

void start_motors() {
  PORTD &= static_cast<uint8_t>(~(kLeftPwmPin | kRightPwmPin));
  DDRD |= kLeftPwmPin | kRightPwmPin | kLeftForwardPin | kRightForwardPin;
  TCCR0A = _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(CS01);  // Fast PWM, 16 MHz / 8 / 256 = 7.8 kHz.
}

/// Off the timer the port, which is low, has the pins.
void cut_motors() { TCCR0A = _BV(WGM01) | _BV(WGM00); }

}  // namespace boards

namespace hal {

void set_motor(Motor motor, bool forward, uint8_t duty) {
  if (motor == Motor::kLeft) {
    boards::set_pin(boards::kLeftForwardPin, forward);
    boards::set_duty(OCR0A, _BV(COM0A1), duty);
  } else {
    boards::set_pin(boards::kRightForwardPin, forward);
    boards::set_duty(OCR0B, _BV(COM0B1), duty);
  }
}

}  // namespace hal
}  // namespace echomap
