// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"

/// Each motor has a slice of the PWM unit, whatever the bridge. A slice takes a new duty at its
/// next period only, so a motor is switched off by taking the pin away from it.
namespace echomap {
namespace boards {
namespace {

using hal::BridgeKind;

/// How fast a slice counts, to where, and what a duty of 1 is.
struct Timing {
  uint32_t divider;
  uint32_t period;
  uint32_t counts_of_duty;
};

/// A compare value beyond the last count is high all the time, as a duty of 255 is.
constexpr Timing kFast{kHalfUsDivider, 255, 1};  // 7.8 kHz.
constexpr Timing kSlow{250U << 4, 510, 2};       // 980 Hz.
constexpr Timing kServoFrame{kHalfUsDivider, 40000, 0};
constexpr Pin kPinsOfEveryKind[] = {kLeftPwmPin, kRightPwmPin, kLeftForwardPin, kRightForwardPin};
constexpr Pin kReversePins[] = {kLeftReversePin, kRightReversePin};
constexpr uint32_t kAllPins = bit(kLeftPwmPin) | bit(kRightPwmPin) | bit(kLeftForwardPin) |
                              bit(kRightForwardPin) | bit(kLeftReversePin) | bit(kRightReversePin);

BridgeKind active = BridgeKind::kPhaseEnable;
uint32_t counts_of_duty = kFast.counts_of_duty;

/// A motor's pins and its slice.
struct MotorPins {
  Pin pwm;
  Pin forward;
  Pin reverse;
  SliceRegisters& slice;
};

MotorPins pins_of(hal::Motor motor) {
  return motor == hal::Motor::kLeft ? MotorPins{kLeftPwmPin,
                                                kLeftForwardPin,
                                                kLeftReversePin,
                                                boards::pwm().slice[kLeftSlice]}
                                    : MotorPins{kRightPwmPin,
                                                kRightForwardPin,
                                                kRightReversePin,
                                                boards::pwm().slice[kRightSlice]};
}

bool has_reverse_pins(BridgeKind kind) {
  return kind == BridgeKind::kIn1In2Pwm || kind == BridgeKind::kTwoPwm;
}

void start_slice(SliceRegisters& slice, const Timing& timing) {
  slice.csr = 0;
  slice.cc = 0;
  slice.div = timing.divider;
  slice.top = timing.period - 1;
  slice.ctr = 0;
  slice.csr = kPwmEnable;
}

void start_slices(BridgeKind kind, bool slow_pwm) {
  const Timing& fast_or_slow = slow_pwm ? kSlow : kFast;
  const Timing& timing = kind == BridgeKind::kServo ? kServoFrame : fast_or_slow;
  counts_of_duty = timing.counts_of_duty;
  start_slice(pwm().slice[kLeftSlice], timing);
  start_slice(pwm().slice[kRightSlice], timing);
}

/// The PWM pin steady, from now on and without a spike.
void hold(const MotorPins& pins, bool high) {
  set_level(pins.pwm, high);
  set_function(pins.pwm, PinFunction::kLevel);
  pins.slice.cc = 0;
}

}  // namespace

void start_motors() {
  sio().out_clr = kAllPins;
  for (const Pin pin : kPinsOfEveryKind) {
    make_output(pin);
  }
  active = BridgeKind::kPhaseEnable;
  start_slices(active, false);
}

/// The pins of every kind: which one is active is in RAM, and that may be damaged. A spare pin in
/// place of a reverse pin is no output of the PWM unit, and low does not harm it.
void cut_motors() {
  sio().out_clr = kAllPins;
  set_function(kLeftPwmPin, PinFunction::kLevel);
  set_function(kRightPwmPin, PinFunction::kLevel);
}

}  // namespace boards

namespace hal {

bool can_bridge(BridgeKind kind) { return kind <= BridgeKind::kServo; }

uint16_t bridge_aux_pins(BridgeKind kind) {
  constexpr uint16_t kGp11AndGp13 = 1U << 9 | 1U << 10;
  return boards::has_reverse_pins(kind) ? kGp11AndGp13 : 0;
}

void use_bridge(BridgeKind kind, bool slow_pwm) {
  using namespace boards;
  stop_motor(Motor::kLeft, false);
  stop_motor(Motor::kRight, false);
  for (const Pin pin : kReversePins) {
    if (has_reverse_pins(kind)) {
      set_level(pin, false);
      make_output(pin);
    } else if (has_reverse_pins(active)) {
      pull_down(pin);
    }
  }
  active = kind;
  start_slices(kind, slow_pwm);
}

void set_motor(Motor motor, bool forward, uint8_t duty) {
  using namespace boards;
  const MotorPins pins = pins_of(motor);
  const bool two_pwm = active == BridgeKind::kTwoPwm;
  if (active == BridgeKind::kServo) {
    pins.slice.cc = wheel_pulse_half_us(forward, duty);
  } else {
    if (has_reverse_pins(active)) {
      set_level(pins.reverse, !forward);
    }
    set_level(pins.forward, forward && !two_pwm);
    // Backwards the second input is high while the first one chops: low for the duty.
    pins.slice.csr = two_pwm && !forward ? kPwmEnable | kPwmInvertA : kPwmEnable;
    pins.slice.cc = duty * counts_of_duty;
  }
  set_function(pins.pwm, PinFunction::kPwm);
}

/// A servo's pulse under way ends: half of one is another command.
void stop_motor(Motor motor, bool brake) {
  using namespace boards;
  const MotorPins pins = pins_of(motor);
  if (active == BridgeKind::kServo) {
    pins.slice.cc = brake ? wheel_pulse_half_us(true, 0) : 0;
    return;
  }
  hold(pins, brake);
  set_level(pins.forward, brake && active == BridgeKind::kIn1In2Pwm);
  if (has_reverse_pins(active)) {
    set_level(pins.reverse, brake);
  }
}

}  // namespace hal
}  // namespace echomap
