// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include <avr/io.h>

#include "firmware/boards/arduino_uno/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {
namespace {

using hal::BridgeKind;

constexpr uint8_t kFastPwm = _BV(WGM01) | _BV(WGM00);
constexpr uint8_t kPwmPins = kLeftPwmPin | kRightPwmPin;
constexpr uint8_t kForwardPins = kLeftForwardPin | kRightForwardPin;
constexpr uint8_t kReversePins = kLeftReversePin | kRightReversePin;

BridgeKind active = BridgeKind::kPhaseEnable;

/// The pins of a motor, as bits of port D or B, and the bits of TCCR0A that give its PWM pin to the
/// timer: `pwm_on`, and `inverted` with it for a pin that is low for the duty.
struct MotorPins {
  uint8_t pwm;      // Port D.
  uint8_t forward;  // Port D.
  uint8_t reverse;  // Port B.
  uint8_t pwm_on;
  uint8_t inverted;
};

MotorPins pins_of(hal::Motor motor) {
  return motor == hal::Motor::kLeft
             ? MotorPins{kLeftPwmPin, kLeftForwardPin, kLeftReversePin, _BV(COM0A1), _BV(COM0A0)}
             : MotorPins{
                   kRightPwmPin, kRightForwardPin, kRightReversePin, _BV(COM0B1), _BV(COM0B0)};
}

void set_pins(volatile uint8_t& port, uint8_t pins, bool high) {
  if (high) {
    port |= pins;
  } else {
    port &= static_cast<uint8_t>(~pins);
  }
}

/// Off the timer the port has the pin: fast PWM has no duty 0, only a spike per period.
void disconnect(const MotorPins& pins) {
  TCCR0A &= static_cast<uint8_t>(~(pins.pwm_on | pins.inverted));
}

void set_duty(hal::Motor motor, uint8_t duty) {
  if (motor == hal::Motor::kLeft) {
    OCR0A = duty;
  } else {
    OCR0B = duty;
  }
}

bool turns(hal::Motor motor) {
  return (TCCR0A & (motor == hal::Motor::kLeft ? _BV(COM0A1) : _BV(COM0B1))) != 0;
}

/// Gives the duty to the motor's pins. Not inline: what it saves on the stack would make each new
/// duty of a motor that turns 10 us later.
__attribute__((noinline)) void start_motor(hal::Motor motor, bool forward) {
  const MotorPins pins = pins_of(motor);
  const bool two_pwm = active == BridgeKind::kTwoPwm;
  if (active == BridgeKind::kIn1In2Pwm) {
    set_pins(PORTB, pins.reverse, !forward);
  }
  // Of two inputs the one on port D is low forwards, and high while the other chops backwards.
  set_pins(PORTD, pins.forward, forward != two_pwm);
  const uint8_t others = TCCR0A & static_cast<uint8_t>(~(pins.pwm_on | pins.inverted));
  const uint8_t connected = two_pwm && !forward ? pins.pwm_on | pins.inverted : pins.pwm_on;
  TCCR0A = others | connected;
}

/// Inputs without a pull-up, which a bridge would take for a level.
void let_go_of_reverse_pins() {
  DDRB &= static_cast<uint8_t>(~kReversePins);
  PORTB &= static_cast<uint8_t>(~kReversePins);
}

}  // namespace

void start_motors() {
  cut_motors();
  let_go_of_reverse_pins();
  DDRD |= kPwmPins | kForwardPins;
  active = BridgeKind::kPhaseEnable;
  TCCR0B = _BV(CS01);  // 16 MHz / 8 / 256 = 7.8 kHz.
}

/// The pins of every kind: which one is active is in RAM, and that may be damaged.
void cut_motors() {
  PORTD &= static_cast<uint8_t>(~(kPwmPins | kForwardPins));
  TCCR0A = kFastPwm;
  PORTB &= static_cast<uint8_t>(~kReversePins);
}

}  // namespace boards

namespace hal {

/// Both halves of timer 1 and timer 2 have their work, so none makes pulses for wheels.
bool can_bridge(BridgeKind kind) { return kind < BridgeKind::kServo; }

uint16_t bridge_aux_pins(BridgeKind kind) { return kind == BridgeKind::kIn1In2Pwm ? 0x3 : 0; }

void use_bridge(BridgeKind kind, bool slow_pwm) {
  stop_motor(Motor::kLeft, false);
  stop_motor(Motor::kRight, false);
  if (boards::active == BridgeKind::kIn1In2Pwm) {
    boards::let_go_of_reverse_pins();
  }
  boards::active = kind;
  if (kind == BridgeKind::kIn1In2Pwm) {
    PORTB &= static_cast<uint8_t>(~boards::kReversePins);
    DDRB |= boards::kReversePins;
  }
  TCCR0B = slow_pwm ? _BV(CS01) | _BV(CS00) : _BV(CS01);  // 16 MHz / 64 / 256 = 976 Hz.
}

void set_motor(Motor motor, bool forward, uint8_t duty) {
  boards::set_duty(motor, duty);
  if (!boards::turns(motor)) {
    boards::start_motor(motor, forward);
  }
}

void stop_motor(Motor motor, bool brake) {
  using namespace boards;
  const MotorPins pins = pins_of(motor);
  const uint8_t of_port_d = pins.pwm | pins.forward;
  set_duty(motor, 0);
  if (brake) {
    set_pins(PORTD, of_port_d, true);
    disconnect(pins);
  } else {
    disconnect(pins);
    set_pins(PORTD, of_port_d, false);
  }
  if (active == BridgeKind::kIn1In2Pwm) {
    set_pins(PORTB, pins.reverse, brake);
  }
}

}  // namespace hal
}  // namespace echomap
