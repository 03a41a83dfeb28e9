// SPDX-License-Identifier: MIT
#include "firmware/hal/servo.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"

namespace echomap {
namespace boards {

static_assert(kFrameHalfUs == hal::kServoFrameMs * 2000UL, "a servo frame is a round of timer 1");

void start_servo() {
  TimerRegisters& timer = tim1();
  timer.ccmr2 = kTimCcmr2Pwm4 | kTimCcmr2Preload4;
  timer.ccer = timer.ccer | kTimCcerEnable4;
  timer.bdtr = kTimBdtrOutputsOn;
  set_level(kServoPin, false);
  set_mode(kServoPin, PinMode::kOutput);
}

}  // namespace boards

namespace hal {

void set_servo_pulse_us(uint16_t pulse_us) {
  boards::tim1().ccr4 = uint32_t{pulse_us} * 2;
  boards::set_mode(boards::kServoPin, boards::PinMode::kAlternate);
}

}  // namespace hal
}  // namespace echomap
