// SPDX-License-Identifier: MIT
#include "firmware/hal/servo.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kFrameHalfUs = hal::kServoFrameMs * 2000UL;

}  // namespace

void start_servo() {
  TimerRegisters& timer = tim2();
  timer.psc = half_us_prescaler();
  timer.arr = kFrameHalfUs - 1;
  timer.ccmr1 = kTimCcmr1Pwm1 | kTimCcmr1Preload1;
  timer.ccer = kTimCcerEnable1;
  timer.egr = kTimUpdate;
  timer.cr1 = kTimCr1Enable;
  set_level(kServoPin, false);
  set_mode(kServoPin, PinMode::kOutput);
}

}  // namespace boards

namespace hal {

void set_servo_pulse_us(uint16_t pulse_us) {
  boards::tim2().ccr1 = uint32_t{pulse_us} * 2;
  boards::set_mode(boards::kServoPin, boards::PinMode::kAlternate);
}

}  // namespace hal
}  // namespace echomap
