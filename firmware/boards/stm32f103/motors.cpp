// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"

/// Timer 3 has both PWM pins, whatever the bridge.
namespace echomap {
namespace boards {
namespace {

using hal::BridgeKind;

/// 2 MHz / 255 = 7.8 kHz; a compare of 255 is above every count, so the pin is high all the time.
constexpr uint32_t kPeriodCounts = 255;
constexpr uint32_t kSlowerBy = 8;
constexpr uint32_t kServoFrameHalfUs = 40000;
constexpr uint32_t kPwmMode = kTimCcmr1Pwm1 | kTimCcmr1Pwm2;
constexpr uint32_t kPreload = kTimCcmr1Preload1 | kTimCcmr1Preload2;
constexpr uint32_t kEnabled = kTimCcerEnable1 | kTimCcerEnable2;
constexpr Pin kForwardPins[] = {kLeftForwardPin, kRightForwardPin};
constexpr Pin kReversePins[] = {kLeftReversePin, kRightReversePin};

BridgeKind active = BridgeKind::kPhaseEnable;

/// A motor's pins and its half of the timer.
struct MotorPins {
  Pin forward;
  Pin reverse;
  Register& compare;
  uint32_t inverted;
};

MotorPins pins_of(hal::Motor motor) {
  return motor == hal::Motor::kLeft
             ? MotorPins{kLeftForwardPin, kLeftReversePin, tim3().ccr1, kTimCcerInverted1}
             : MotorPins{kRightForwardPin, kRightReversePin, tim3().ccr2, kTimCcerInverted2};
}

bool has_reverse_pins(BridgeKind kind) {
  return kind == BridgeKind::kIn1In2Pwm || kind == BridgeKind::kTwoPwm;
}

/// Both outputs low from here on. A duty counts at once, for 0 switches off; a servo's pulse is
/// preloaded, for a shorter one is full reverse.
void start_timer(uint32_t prescaler, uint32_t period, uint32_t preload) {
  TimerRegisters& timer = tim3();
  timer.ccmr1 = kPwmMode;
  timer.ccr1 = 0;
  timer.ccr2 = 0;
  timer.ccer = kEnabled;
  timer.psc = prescaler;
  timer.arr = period - 1;
  timer.egr = kTimUpdate;
  timer.ccmr1 = kPwmMode | preload;
  timer.cr1 = kTimCr1Enable;
}

void start_timer_for(BridgeKind kind, bool slow_pwm) {
  const uint32_t prescaler = half_us_prescaler();
  if (kind == BridgeKind::kServo) {
    start_timer(prescaler, kServoFrameHalfUs, kPreload);
  } else {
    start_timer(slow_pwm ? (prescaler + 1) * kSlowerBy - 1 : prescaler, kPeriodCounts, 0);
  }
}

}  // namespace

void start_motors() {
  active = BridgeKind::kPhaseEnable;
  start_timer_for(active, false);
  set_mode(kLeftPwmPin, PinMode::kAlternate);
  set_mode(kRightPwmPin, PinMode::kAlternate);
  for (const Pin pin : kForwardPins) {
    set_level(pin, false);
    set_mode(pin, PinMode::kOutput);
  }
}

/// The pins of every kind: which one is active is in RAM, and that may be damaged. Preloaded zeros
/// let a servo's pulse under way end.
void cut_motors() {
  for (const Pin pin : kReversePins) {
    set_level(pin, false);
  }
  for (const Pin pin : kForwardPins) {
    set_level(pin, false);
  }
  tim3().ccer = kEnabled;
  tim3().ccr1 = 0;
  tim3().ccr2 = 0;
}

}  // namespace boards

namespace hal {

bool can_bridge(BridgeKind kind) { return kind <= BridgeKind::kServo; }

uint16_t bridge_aux_pins(BridgeKind kind) {
  constexpr uint16_t kB12AndB13 = 1U << 11 | 1U << 12;
  return boards::has_reverse_pins(kind) ? kB12AndB13 : 0;
}

void use_bridge(BridgeKind kind, bool slow_pwm) {
  using namespace boards;
  stop_motor(Motor::kLeft, false);
  stop_motor(Motor::kRight, false);
  for (const Pin pin : kReversePins) {
    if (has_reverse_pins(kind)) {
      set_level(pin, false);
      set_mode(pin, PinMode::kOutput);
    } else if (has_reverse_pins(active)) {
      pull_down(pin);
    }
  }
  active = kind;
  start_timer_for(kind, slow_pwm);
}

void set_motor(Motor motor, bool forward, uint8_t duty) {
  using namespace boards;
  const MotorPins pins = pins_of(motor);
  const bool two_pwm = active == BridgeKind::kTwoPwm;
  if (active == BridgeKind::kServo) {
    pins.compare = wheel_pulse_half_us(forward, duty);
    return;
  }
  if (has_reverse_pins(active)) {
    set_level(pins.reverse, !forward);
  }
  set_level(pins.forward, forward && !two_pwm);
  // Backwards the second input is high while the first one chops: low for the duty.
  const uint32_t others = tim3().ccer & ~pins.inverted;
  tim3().ccer = two_pwm && !forward ? others | pins.inverted : others;
  pins.compare = duty;
}

void stop_motor(Motor motor, bool brake) {
  using namespace boards;
  const MotorPins pins = pins_of(motor);
  if (active == BridgeKind::kServo) {
    pins.compare = brake ? wheel_pulse_half_us(true, 0) : 0;
    return;
  }
  pins.compare = brake ? kPeriodCounts : 0;
  tim3().ccer = tim3().ccer & ~pins.inverted;
  set_level(pins.forward, brake && active == BridgeKind::kIn1In2Pwm);
  if (has_reverse_pins(active)) {
    set_level(pins.reverse, brake);
  }
}

}  // namespace hal
}  // namespace echomap
