// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"

namespace echomap {
namespace boards {
namespace {

/// 2 MHz / 255 = 7.8 kHz; a compare of 255 is above every count, so the pin is high all the time.
constexpr uint32_t kPeriodCounts = 255;

}  // namespace

void start_motors() {
  TimerRegisters& timer = tim3();
  timer.psc = half_us_prescaler();
  timer.arr = kPeriodCounts - 1;
  timer.ccmr1 = kTimCcmr1Pwm1 | kTimCcmr1Pwm2;  // No preload: 0 switches off at once.
  timer.ccer = kTimCcerEnable1 | kTimCcerEnable2;
  timer.egr = kTimUpdate;
  timer.cr1 = kTimCr1Enable;
  set_mode(kLeftPwmPin, PinMode::kAlternate);
  set_mode(kRightPwmPin, PinMode::kAlternate);
  set_mode(kLeftForwardPin, PinMode::kOutput);
  set_mode(kRightForwardPin, PinMode::kOutput);
}

void cut_motors() {
  tim3().ccr1 = 0;
  tim3().ccr2 = 0;
}

}  // namespace boards

namespace hal {

void set_motor(Motor motor, bool forward, uint8_t duty) {
  if (motor == Motor::kLeft) {
    boards::set_level(boards::kLeftForwardPin, forward);
    boards::tim3().ccr1 = duty;
  } else {
    boards::set_level(boards::kRightForwardPin, forward);
    boards::tim3().ccr2 = duty;
  }
}

}  // namespace hal
}  // namespace echomap
