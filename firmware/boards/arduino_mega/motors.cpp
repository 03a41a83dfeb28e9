// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/arduino_mega/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/hal/interrupts.hpp"

/// Timers 3 and 4 have the PWM of each motor's first pin. Of bridges with two inputs the second one
/// is on timer 0 (left) or on timer 4 too (right). Timer 1 makes the pulses of servos.
namespace echomap {
namespace boards {
namespace {

using hal::BridgeKind;
using hal::Motor;

constexpr uint8_t kFastPwm8Mode = _BV(WGM30);  // Mode 5, in both control registers.
constexpr uint8_t kFastPwm8Control = _BV(WGM32);
constexpr uint8_t kPwmOn = _BV(COM3A1);
constexpr uint8_t kRightSecondOn = _BV(COM4B1);  // Timer 4.
constexpr uint8_t kLeftSecondOn = _BV(COM0B1);   // Timer 0.
constexpr uint8_t kTimer0Mode = _BV(WGM01) | _BV(WGM00);
constexpr uint8_t kBy8 = _BV(CS31);               // 16 MHz / 8 / 256 = 7.8 kHz.
constexpr uint8_t kBy64 = _BV(CS31) | _BV(CS30);  // 16 MHz / 64 / 256 = 976 Hz.
static_assert(WGM30 == WGM40 && WGM32 == WGM42 && COM3A1 == COM4A1 && CS31 == CS41 &&
                  CS30 == CS40 && CS31 == CS01 && CS30 == CS00,
              "the timers have the same layout");

constexpr uint8_t kServoMode = _BV(WGM11);  // Mode 14: from 0 to ICR1, 20 ms of half microseconds.
constexpr uint8_t kServoControl = _BV(WGM13) | _BV(WGM12) | _BV(CS11);
constexpr uint16_t kFrameCounts = 40000;

BridgeKind active = BridgeKind::kPhaseEnable;

void set_pin(volatile uint8_t& port, uint8_t pin, bool high) {
  if (high) {
    port |= pin;
  } else {
    port &= static_cast<uint8_t>(~pin);
  }
}

/// What a servo's motor is on timer 1.
struct ServoBits {
  uint8_t pin;        // Of port B.
  uint8_t connected;  // Of TCCR1A.
  uint8_t end;        // Of TIMSK1 and TIFR1: the end of its pulse.
};

ServoBits servo_bits(Motor motor) {
  static_assert(OCIE1A == OCF1A && OCIE1B == OCF1B, "enables and flags have the same places");
  return motor == Motor::kLeft ? ServoBits{kLeftServoPin, _BV(COM1A1), _BV(OCIE1A)}
                               : ServoBits{kRightServoPin, _BV(COM1B1), _BV(OCIE1B)};
}

void set_pulse(Motor motor, uint16_t half_us) {
  const ServoBits bits = servo_bits(motor);
  const hal::InterruptLock lock;  // 16-bit registers share one TEMP byte with the interrupts.
  TIMSK1 &= static_cast<uint8_t>(~bits.end);
  if (motor == Motor::kLeft) {
    OCR1A = static_cast<uint16_t>(half_us - 1);
  } else {
    OCR1B = static_cast<uint16_t>(half_us - 1);
  }
  TCCR1A |= bits.connected;
}

/// A pulse under way is left to its end: a servo would take a shorter one for full reverse.
void end_pulses(Motor motor) {
  const ServoBits bits = servo_bits(motor);
  const hal::InterruptLock lock;
  if ((PINB & bits.pin) == 0) {
    TCCR1A &= static_cast<uint8_t>(~bits.connected);
  } else {
    TIFR1 = bits.end;
    TIMSK1 |= bits.end;
  }
}

/// 2 ms at most, unless the timer stands still.
void let_pulses_end() {
  for (uint16_t polls = 8000; polls != 0 && (PINB & (kLeftServoPin | kRightServoPin)) != 0;
       --polls) {
  }
}

/// Off the timers the ports have the pins: fast PWM has no duty 0, only a spike per period.
void disconnect(Motor motor) {
  if (motor == Motor::kLeft) {
    OCR4A = 0;
    TCCR4A &= static_cast<uint8_t>(~kPwmOn);
    OCR0B = 0;
    TCCR0A = kTimer0Mode;
  } else {
    OCR3A = 0;
    TCCR3A = kFastPwm8Mode;
    OCR4B = 0;
    TCCR4A &= static_cast<uint8_t>(~kRightSecondOn);
  }
}

/// Levels of a motor's pins while they are off the timers; those of `reverse` only with IN2 there.
void set_levels(Motor motor, bool pwm, bool forward, bool reverse) {
  const bool has_reverse = active == BridgeKind::kIn1In2Pwm;
  if (motor == Motor::kLeft) {
    set_pin(PORTH, kLeftPwmPin, pwm);
    set_pin(PORTG, kLeftForwardPin, forward);
    set_pin(PORTH, kLeftReversePin, reverse && has_reverse);
  } else {
    set_pin(PORTE, kRightPwmPin, pwm);
    set_pin(PORTH, kRightForwardPin, forward);
    set_pin(PORTH, kRightReversePin, reverse && has_reverse);
  }
}

/// On the motor's first pin.
void connect(Motor motor, uint8_t duty) {
  if (motor == Motor::kLeft) {
    OCR4A = duty;
    TCCR4A |= kPwmOn;
  } else {
    OCR3A = duty;
    TCCR3A = kFastPwm8Mode | kPwmOn;
  }
}

/// On the second one of a bridge with two inputs.
void connect_second(Motor motor, uint8_t duty) {
  if (motor == Motor::kLeft) {
    OCR0B = duty;
    TCCR0A = kTimer0Mode | kLeftSecondOn;
  } else {
    OCR4B = duty;
    TCCR4A |= kRightSecondOn;
  }
}

void start_timers(bool slow_pwm) {
  const uint8_t clock = slow_pwm ? kBy64 : kBy8;
  TCCR0B = clock;
  TCCR3B = kFastPwm8Control | clock;
  TCCR4B = kFastPwm8Control | clock;
}

}  // namespace

void start_motors() {
  cut_motors();
  TIMSK1 = 0;
  TCCR1B = 0;
  DDRE |= kRightPwmPin;
  DDRG |= kLeftForwardPin;
  DDRH &= static_cast<uint8_t>(~(kLeftReversePin | kRightReversePin));
  DDRH |= kLeftPwmPin | kRightForwardPin;
  DDRB &= static_cast<uint8_t>(~(kLeftServoPin | kRightServoPin));
  active = BridgeKind::kPhaseEnable;
  start_timers(false);
}

/// The pins of every kind: which one is active is in RAM, and that may be damaged.
void cut_motors() {
  PORTG &= static_cast<uint8_t>(~kLeftForwardPin);
  PORTH &=
      static_cast<uint8_t>(~(kLeftPwmPin | kRightForwardPin | kLeftReversePin | kRightReversePin));
  PORTE &= static_cast<uint8_t>(~kRightPwmPin);
  TCCR0A = kTimer0Mode;
  TCCR3A = kFastPwm8Mode;
  TCCR4A = kFastPwm8Mode;
  let_pulses_end();
  TCCR1A = kServoMode;
  PORTB &= static_cast<uint8_t>(~(kLeftServoPin | kRightServoPin));
}

}  // namespace boards

namespace hal {

bool can_bridge(BridgeKind kind) { return kind <= BridgeKind::kServo; }

uint16_t bridge_aux_pins(BridgeKind /*kind*/) { return 0; }

void use_bridge(BridgeKind kind, bool slow_pwm) {
  using namespace boards;
  constexpr uint8_t kServoPins = kLeftServoPin | kRightServoPin;
  constexpr uint8_t kReversePins = kLeftReversePin | kRightReversePin;
  stop_motor(Motor::kLeft, false);
  stop_motor(Motor::kRight, false);
  active = kind;
  if (kind == BridgeKind::kIn1In2Pwm) {
    DDRH |= kReversePins;
  } else {
    DDRH &= static_cast<uint8_t>(~kReversePins);
  }
  if (kind == BridgeKind::kServo) {
    ICR1 = kFrameCounts - 1;
    TCCR1B = kServoControl;
    DDRB |= kServoPins;
  } else {
    DDRB &= static_cast<uint8_t>(~kServoPins);
  }
  start_timers(slow_pwm);
}

void set_motor(Motor motor, bool forward, uint8_t duty) {
  using namespace boards;
  // One that turns does so in the same direction.
  if (motor == Motor::kLeft && (TCCR4A & kPwmOn) != 0) {
    OCR4A = duty;
    return;
  }
  if (motor == Motor::kRight && (TCCR3A & kPwmOn) != 0) {
    OCR3A = duty;
    return;
  }
  if (active == BridgeKind::kServo) {
    set_pulse(motor, wheel_pulse_half_us(forward, duty));
    return;
  }
  const bool two_pwm = active == BridgeKind::kTwoPwm;
  set_levels(motor, false, forward && !two_pwm, !forward);
  if (two_pwm && !forward) {
    connect_second(motor, duty);
  } else {
    connect(motor, duty);
  }
}

void stop_motor(Motor motor, bool brake) {
  using namespace boards;
  if (active == BridgeKind::kServo) {
    if (brake) {
      set_pulse(motor, wheel_pulse_half_us(true, 0));
    } else {
      end_pulses(motor);
    }
    return;
  }
  disconnect(motor);
  set_levels(motor, brake, brake, brake);
}

ISR(TIMER1_COMPA_vect) {
  TCCR1A &= static_cast<uint8_t>(~_BV(COM1A1));
  TIMSK1 &= static_cast<uint8_t>(~_BV(OCIE1A));
}

ISR(TIMER1_COMPB_vect) {
  TCCR1A &= static_cast<uint8_t>(~_BV(COM1B1));
  TIMSK1 &= static_cast<uint8_t>(~_BV(OCIE1B));
}

}  // namespace hal
}  // namespace echomap
