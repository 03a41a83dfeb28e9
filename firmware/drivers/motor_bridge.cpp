// SPDX-License-Identifier: MIT
#include "firmware/drivers/motor_bridge.hpp"

namespace echomap {
namespace drivers {

void MotorBridge::invert(bool inverted) {
  set(0);
  inverted_ = inverted;
}

void MotorBridge::set(int16_t duty) {
  const bool forward = (duty > 0) != inverted_;
  const bool reversing = running_ && forward != pin_forward_;
  running_ = duty != 0 && !reversing;
  if (running_) {
    pin_forward_ = forward;
  }
  const uint8_t magnitude = static_cast<uint8_t>(duty < 0 ? -duty : duty);
  hal::set_motor(motor_, pin_forward_, running_ ? magnitude : uint8_t{0});
}

}  // namespace drivers
}  // namespace echomap
