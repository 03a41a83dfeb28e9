// SPDX-License-Identifier: MIT
#include "firmware/control/driven_wheel.hpp"

namespace echomap {
namespace control {

void DrivenWheel::begin(int16_t count) {
  controller_.reset();
  guard_.reset();
  last_count_ = count;
}

void DrivenWheel::follow(int16_t count) {
  const int16_t turned = static_cast<int16_t>(count - last_count_);
  last_count_ = count;
  duty_ = controller_.update(turned);
  motor_.set(duty_);
}

protocol::MotionOutcome DrivenWheel::classify(const protocol::ConfigureDrive& settings,
                                              const protocol::ConfigureSafety& limits) {
  if (controller_.stalled(settings)) {
    return protocol::MotionOutcome::kStalled;
  }
  const WheelPeriod now{step_, duty_, controller_.turned(), controller_.turned_sum()};
  return guard_.classify(limits, now);
}

}  // namespace control
}  // namespace echomap
