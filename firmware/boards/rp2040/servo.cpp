// SPDX-License-Identifier: MIT
#include "firmware/hal/servo.hpp"

#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kFrameHalfUs = hal::kServoFrameMs * 2000UL;

}  // namespace

void start_servo() {
  SliceRegisters& slice = pwm().slice[kServoSlice];
  slice.div = kHalfUsDivider;
  slice.top = kFrameHalfUs - 1;
  slice.csr = kPwmEnable;
  set_level(kServoPin, false);
  make_output(kServoPin);
}

}  // namespace boards

namespace hal {

void set_servo_pulse_us(uint16_t pulse_us) {
  boards::pwm().slice[boards::kServoSlice].cc = uint32_t{pulse_us} * 2;
  boards::set_function(boards::kServoPin, boards::PinFunction::kPwm);
}

}  // namespace hal
}  // namespace echomap
